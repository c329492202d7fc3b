// Curves with the page's time. One chart shows one history, of every run that has it.

const FIRST_CHARTS = [/^airbag\/\d+\/pressure(_gauge)?$/, /^airbag\/\d+\/volume$/, /^airbag\/\d+\/temperature$/, /^energy\/gas$/, /^energy\/residual$/];
const CHART_HEIGHT = 230;  // without the legend [pixel]
const FONT = "13px system-ui, sans-serif";
const ALONG = {size: 26, gap: 4, labelGap: 0}, UP = {size: 72};  // room for the numbers of an axis [pixel]

/** An axis of uPlot. */
function axis(label, room) {
    return {label, labelFont: FONT, labelSize: label ? 20 : 0, font: FONT, stroke: "#5c6675", grid: {stroke: "#d5dae1", width: 1}, ticks: {show: false}, values: (plot, all) => all.map(show), ...room};
}

const most = (values) => values.reduce((high, v) => Math.abs(v) > high ? Math.abs(v) : high, 0);

/** The history of the force that pushes a body hardest, of those that move if any does; none: there is no body. */
function hardestPush(run) {
    const all = run.histories.map((history) => [history, /^rigid_body\/(\d+)\/force\.[xyz]$/.exec(history.name)]).filter(([, found]) => found);
    const speed = (id) => Math.max(...["x", "y", "z"].map((axis) => most(run.histories.find((h) => h.name === `rigid_body/${id}/velocity.${axis}`)?.values ?? [])));
    const moving = all.filter(([, found]) => speed(found[1]) > 0);
    return (moving.length ? moving : all).map(([history]) => history).sort((a, b) => most(b.values) - most(a.values))[0];
}

/** When a run is worth seeing: its body is pushed hardest, or its first bag has got 95 % of its greatest volume. */
function worthSeeing(run) {
    const force = hardestPush(run), volume = run.histories.find((history) => /^airbag\/\d+\/volume$/.test(history.name));
    const [values, share] = force && most(force.values) > 0 ? [force.values, 1] : volume ? [volume.values, 0.95] : [[], 1];
    const bound = share * most(values), row = values.findIndex((v) => Math.abs(v) >= bound);
    return row < 0 ? run.time[run.rows - 1] : run.time[row];
}

/** Numbers for uPlot; what is none is a gap. */
const numbers = (values) => Array.from(values, (v) => Number.isFinite(v) ? v : null);

class Chart {
    constructor(runs, first, pick) {
        this.runs = runs;
        this.pick = pick;
        this.t = 0;
        this.labels = new Map(runs.flatMap((run) => run.histories.slice(1).map((history) => [history.name, history.label])));
        const names = [...this.labels.keys()];
        this.select = make("select", {"aria-label": "history"}, ...names.map((name) => make("option", {value: name}, this.labels.get(name))));
        this.select.value = names.find((name) => first.test(name)) || names[0];
        this.place = make("div", {class: "plot", role: "img"});
        this.figure = make("figure", {}, this.select, this.place);
        this.select.addEventListener("change", () => this.renew());
    }

    /** The chart's numbers: [{run, history}] of those that have it. */
    curves() {
        return this.runs.map((run) => ({run, history: run.histories.find((h) => h.name === this.select.value)})).filter((c) => c.history);
    }

    /** Takes the chosen history. A drag zooms, in all charts; two clicks show all again; one click picks a time. */
    renew() {
        if (this.plot) this.plot.destroy();
        const curves = this.shown = this.curves(), unit = curves[0].history.unit, time = curves[0].run.units.time;
        const tables = curves.map(({run, history}) => [run.time, numbers(history.values)]);
        const value = (row) => row === null ? "-" : show(row);
        const options = {
            width: this.place.clientWidth,
            height: CHART_HEIGHT,
            scales: {x: {time: false}},
            axes: [axis(time, ALONG), axis(unit, UP)],
            series: [{label: `t [${time}]`, value: (plot, t) => value(t)}, ...curves.map((curve) => ({
                label: curve.run.name,
                stroke: LINE_COLOURS[this.runs.indexOf(curve.run) % LINE_COLOURS.length],
                width: 1.8,
                spanGaps: true,  // a row of the other run is none of this one
                points: {show: false},
                value: (plot, v, s, row) => value(row === null ? null : this.reading(curve, plot.data[0][row])),
            }))],
            cursor: {y: false, sync: {key: "time"}, drag: {dist: 5}},
            hooks: {draw: [() => this.mark()], setCursor: [(plot) => { if (plot.cursor.left < 0) this.mark(); }]},
        };
        this.plot = new lib.uPlot(options, tables.length > 1 ? lib.uPlot.join(tables) : tables[0], this.place);
        this.now = make("div", {class: "now"});
        this.plot.over.append(this.now);
        this.plot.over.addEventListener("click", (event) => this.pick(this.plot.posToVal(event.offsetX, "x")));
    }

    reading({run, history}, t) {
        return history.values[rowAt(run.time, t)];
    }

    fit() {
        this.plot.setSize({width: this.place.clientWidth, height: CHART_HEIGHT});
    }

    go(t) {
        this.t = t;
        this.mark();
    }

    /** The line at the page's time, and what the curves read there unless the mouse reads elsewhere. */
    mark() {
        if (!this.now) return;
        const {plot, now, t} = this, x = plot.valToPos(t, "x");
        now.hidden = x < 0 || x > plot.over.clientWidth;
        now.style.transform = `translateX(${x}px)`;
        if (plot.cursor.left < 0) plot.setLegend({idx: rowAt(plot.data[0], t)}, false);
        const readings = this.shown.map((curve) => show(this.reading(curve, t)));
        this.place.setAttribute("aria-label", `${this.labels.get(this.select.value)}: ${readings.join(", ")} ${this.shown[0].history.unit}`);
    }
}
