// Everything of a run that is not a picture: settings, warnings, timings, ledger, responses.

function table(head, rows) {
    const cells = (row, kind) => row.map((cell) => make(kind, typeof cell === "number" ? {class: "number"} : {}, typeof cell === "number" ? show(cell) : cell ?? "-"));
    return make("div", {class: "scroll"}, make("table", {}, make("thead", {}, make("tr", {}, ...cells(head, "th"))), make("tbody", {}, ...rows.map((row) => make("tr", {}, ...cells(row, "td"))))));
}

function block(title, content) {
    return make("div", {}, make("h2", {}, title), content);
}

function responseTable(run) {
    const rows = Object.entries(run.responses.bodies).flatMap(([body, all]) =>
        Object.entries(all).map(([name, r]) => [body, name, r.value, r.unit, r.filter, r.note]));
    return rows.length ? block("Responses of rigid bodies", table(["body", "response", "value", "unit", "filter", "note"], rows)) : "";
}

function ledgerTable(run) {
    const last = run.histories.filter((history) => history.name.startsWith("energy/")).map((history) => [history.name.slice(7), history.values[run.rows - 1], history.unit]);
    return block("Energy books at the end", table(["book", "value", "unit"], last));
}

function settingsTable(run) {
    const rows = ["deck", "program", "version", "unit_system", "seed", "threads", "termination", "nodes", "shells"].map((key) => [key, String(run[key])]);
    rows.push(["frames shown", `${run.frames.length} of ${run.frames_in_file}`]);
    rows.push(["particles shown at the end", String(run.frames.length ? run.frames[run.frames.length - 1].count : 0)]);
    return block(`Settings of ${run.name}`, table(["setting", "value"], rows));
}

function summaryTables(run) {
    if (!run.summary) return [block("Warnings and timings", "the run left no run.json")];
    const {warnings, mended = [], phases, steps, wall} = run.summary;
    const items = (texts) => make("ul", {class: "warning"}, ...texts.map((text) => make("li", {}, text)));
    const rows = Object.entries(phases).filter(([, seconds]) => seconds > 0.0005 * wall).map(([name, seconds]) => [name, seconds, 100 * seconds / wall]);
    return [block("Warnings", warnings.length ? items(warnings) : "none"), mended.length ? block("Mended", items(mended)) : "", block(`Wall time: ${show(wall)} s, ${steps} steps`, table(["phase", "s", "%"], rows))];
}

function fillTables(place, runs) {
    for (const run of runs)
        place.append(make("div", {class: "columns"}, responseTable(run), ledgerTable(run), settingsTable(run), ...summaryTables(run)));
}
