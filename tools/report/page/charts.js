// Curves with a time cursor. One chart shows one history, of every run that has it.

const FIRST_CHARTS = [/^airbag\/\d+\/pressure$/, /^airbag\/\d+\/volume$/, /^airbag\/\d+\/temperature$/, /^energy\/gas$/, /^energy\/residual$/, /^rigid_body\/\d+\/force\.z$/];

/** Round numbers between low and high, about `count` of them. */
function ticks(low, high, count) {
    const rough = (high - low) / count || 1, unit = 10 ** Math.floor(Math.log10(rough));
    const step = [1, 2, 5, 10].map((k) => k * unit).find((s) => s >= rough);
    const all = [];
    for (let k = Math.ceil(low / step); k * step <= high + 1e-9 * step; ++k) all.push(k * step);
    return all;
}

/** Axes of a canvas; returns how numbers map to it. */
function axes(canvas, xRange, yRange, xLabel, yLabel) {
    const scale = window.devicePixelRatio || 1;
    canvas.width = canvas.clientWidth * scale;
    canvas.height = canvas.clientHeight * scale;
    const pen = canvas.getContext("2d");
    pen.scale(scale, scale);
    const box = {left: 64, top: 20, right: canvas.clientWidth - 10, bottom: canvas.clientHeight - 34};
    const [x0, x1] = xRange, [y0, y1] = yRange[0] < yRange[1] ? yRange : [yRange[0] - 1, yRange[1] + 1];
    const x = (v) => box.left + (v - x0) / ((x1 - x0) || 1) * (box.right - box.left);
    const y = (v) => box.bottom - (v - y0) / (y1 - y0) * (box.bottom - box.top);
    pen.font = "12px system-ui, sans-serif";
    pen.strokeStyle = "#d5dae1";
    pen.fillStyle = "#5c6675";
    pen.textAlign = "center";
    for (const v of ticks(x0, x1, 6)) {
        pen.strokeRect(x(v), box.top, 0, box.bottom - box.top);
        pen.fillText(show(v), x(v), box.bottom + 15);
    }
    pen.fillText(xLabel, 0.5 * (box.left + box.right), box.bottom + 30);
    pen.textAlign = "right";
    for (const v of ticks(y0, y1, 5)) {
        pen.strokeRect(box.left, y(v), box.right - box.left, 0);
        pen.fillText(show(v), box.left - 5, y(v) + 4);
    }
    pen.textAlign = "left";
    pen.fillText(yLabel, 4, 12);
    return {pen, x, y, box};
}

function bounds(lists) {
    let low = Infinity, high = -Infinity;
    for (const list of lists)
        for (const v of list) {
            if (v < low) low = v;
            if (v > high) high = v;
        }
    return low <= high ? [low, high] : [0, 1];
}

/** Room around points. */
function widened(list) {
    const [low, high] = bounds([list]), room = 0.06 * (high - low) || 0.5;
    return [low - room, high + room];
}

class Chart {
    constructor(runs, first, pick) {
        this.runs = runs;
        const names = [...new Set(runs.flatMap((run) => run.histories.slice(1).map((history) => history.name)))];
        this.select = make("select", {"aria-label": "history"}, ...names.map((name) => make("option", {}, name)));
        this.select.value = names.find((name) => first.test(name)) || names[0];
        this.canvas = make("canvas", {tabindex: 0, role: "img"});
        this.figure = make("figure", {}, this.select, this.canvas);
        this.select.addEventListener("change", () => this.draw(this.t));
        this.canvas.addEventListener("click", (event) => pick(this.timeAt(event.offsetX)));
    }

    timeAt(pixel) {
        const {left, right} = this.frame.box, [a, b] = this.range;
        return Math.min(Math.max(a + (pixel - left) / (right - left) * (b - a), a), b);
    }

    /** The chart's numbers: [{run, history}] of those that have it. */
    curves() {
        return this.runs.map((run) => ({run, history: run.histories.find((h) => h.name === this.select.value)})).filter((c) => c.history);
    }

    draw(t) {
        this.t = t;
        const curves = this.curves();
        this.range = bounds(curves.map((c) => c.run.time));
        const unit = curves[0].history.unit;
        const {pen, x, y, box} = this.frame = axes(this.canvas, this.range, bounds(curves.map((c) => c.history.values)), curves[0].run.units.time, unit);
        const readings = [];
        curves.forEach(({run, history}) => {
            const colour = LINE_COLOURS[this.runs.indexOf(run) % LINE_COLOURS.length];
            pen.strokeStyle = colour;
            pen.lineWidth = 1.8;
            pen.beginPath();
            for (let row = 0; row < run.rows; ++row) pen.lineTo(x(run.time[row]), y(history.values[row]));
            pen.stroke();
            readings.push([colour, history.values[rowAt(run, t)]]);
        });
        pen.strokeStyle = "#1c2430";
        pen.lineWidth = 1;
        pen.strokeRect(x(t), box.top, 0, box.bottom - box.top);
        pen.textAlign = "right";
        readings.reverse().forEach(([colour, value], k) => {
            pen.fillStyle = colour;
            pen.fillText(show(value), box.right - 80 * k, 12);
        });
        this.canvas.setAttribute("aria-label", `${this.select.value}: ${readings.map((r) => show(r[1])).join(", ")} ${unit}`);
    }
}
