// Everything that is not a picture: settings, warnings, timings, ledger, responses; a study's table.

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
    const {warnings, phases, steps, wall} = run.summary;
    const list = warnings.length ? make("ul", {class: "warning"}, ...warnings.map((text) => make("li", {}, text))) : "none";
    const rows = Object.entries(phases).filter(([, seconds]) => seconds > 0.0005 * wall).map(([name, seconds]) => [name, seconds, 100 * seconds / wall]);
    return [block("Warnings", list), block(`Wall time: ${show(wall)} s, ${steps} steps`, table(["phase", "s", "%"], rows))];
}

function fillTables(place, runs) {
    for (const run of runs)
        place.append(make("div", {class: "columns"}, responseTable(run), ledgerTable(run), settingsTable(run), ...summaryTables(run)));
}

/** Cells of a line of study.csv. */
function csvCells(line) {
    return [...line.matchAll(/("(?:[^"]|"")*"|[^,]*)(,|$)/g)].slice(0, -1).concat(line.endsWith(",") ? [[null, ""]] : []).map(([, cell]) => cell.startsWith('"') ? cell.slice(1, -1).replaceAll('""', '"') : cell);
}

class StudyTable {
    constructor(place, csv) {
        const lines = csv.trim().split("\n").map(csvCells);
        this.head = lines[0];
        const numeric = this.head.map((name) => !["status", "reason"].includes(name));
        this.rows = lines.slice(1).map((cells) => cells.map((cell, k) => numeric[k] ? (cell === "" ? null : Number(cell)) : cell));
        const first = this.head.indexOf("seed"), after = this.head.indexOf("seconds");
        this.factors = this.head.slice(2, first);
        this.responses = this.head.slice(after + 1, -1);
        this.body = make("div");
        this.plots = make("div", {id: "effects"});
        place.append(make("h2", {}, `Study: ${this.rows.length} runs`), this.body, make("h2", {}, "Runs over each factor, and the mean at each of its values"), this.plots);
        this.sort(0);
    }

    sort(column) {
        this.down = this.column === column && !this.down;
        this.column = column;
        const order = (a, b) => (a === b ? 0 : (a < b) !== this.down ? -1 : 1);
        const last = (a, b) => (a === null) - (b === null);  // what has no value is last, up and down
        this.rows.sort((a, b) => last(a[column], b[column]) || order(a[column], b[column]));
        const shown = table(this.head, this.rows);
        shown.querySelectorAll("th").forEach((th, k) => {
            th.setAttribute("data-sort", "");
            th.tabIndex = 0;
            th.addEventListener("click", () => this.sort(k));
            th.addEventListener("keydown", (event) => { if (event.key === "Enter") this.sort(k); });
        });
        this.body.replaceChildren(shown);
    }

    /** Scatter of every response over every factor, with the mean at each value. */
    draw() {
        this.plots.replaceChildren();
        for (const response of this.responses)
            for (const factor of this.factors) {
                const canvas = make("canvas", {class: "plot", role: "img", "aria-label": `${response} over ${factor}`});
                this.plots.append(canvas);
                const [f, r] = [factor, response].map((name) => this.head.indexOf(name));
                const points = this.rows.filter((row) => row[r] !== null).map((row) => [row[f], row[r]]);
                if (points.length === 0) continue;
                const {pen, x, y} = axes(canvas, widened(points.map((p) => p[0])), widened(points.map((p) => p[1])), factor, response);
                pen.fillStyle = LINE_COLOURS[0];
                for (const [a, b] of points) pen.fillRect(x(a) - 2.5, y(b) - 2.5, 5, 5);
                const at = new Map();
                for (const [a, b] of points) at.set(a, [...(at.get(a) || []), b]);
                if (at.size === points.length) continue;
                pen.strokeStyle = LINE_COLOURS[1];
                pen.beginPath();
                for (const a of [...at.keys()].sort((p, q) => p - q)) pen.lineTo(x(a), y(at.get(a).reduce((s, v) => s + v, 0) / at.get(a).length));
                pen.stroke();
            }
    }
}
