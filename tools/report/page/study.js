// A study's table, sorted by a click, and its responses over its factors.

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
        window.addEventListener("resize", () => this.fit());
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

    /** Every response over every factor. */
    draw() {
        this.plots.replaceChildren();
        this.scatters = [];
        for (const response of this.responses)
            for (const factor of this.factors) {
                const place = make("div", {class: "plot", role: "img", "aria-label": `${response} over ${factor}`});
                this.plots.append(place);
                const [f, r] = [factor, response].map((name) => this.head.indexOf(name));
                const points = this.rows.filter((row) => row[r] !== null).map((row) => [row[f], row[r], row[0]]);
                if (points.length > 0) this.scatters.push(scatter(place, points, factor, response));
            }
    }

    fit() {
        for (const plot of this.scatters) plot.setSize({width: plot.root.parentElement.clientWidth, height: CHART_HEIGHT});
    }
}
