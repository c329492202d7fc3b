// Puts the page together: one time for all pictures and curves.

const element = (id) => document.getElementById(id);

class Page {
    constructor(runs) {
        this.runs = runs;
        this.end = Math.max(...runs.map((run) => run.time[run.rows - 1]));
        this.t = 0;
        this.is_due = false;
        this.is_new = true;
        const is_comparable = runs.every((run) => run.units.length === runs[0].units.length), box = commonBox(runs);
        this.viewers = runs.map((run) => {
            const canvas = make("canvas", {class: "picture", tabindex: 0, "aria-label": `${run.name} in 3-D`});
            run.legend = make("canvas", {width: 260, height: 34});
            element("scene").append(make("figure", {}, canvas, make("figcaption", {}, `${run.name} (${run.termination})`, run.legend)));
            return new Viewer(canvas, run, is_comparable ? box : run.box);
        });
        this.camera = new Camera(element("scene"), () => this.ask());
        const push = runs.map(hardestPush).find((history) => history);
        const wanted = push ? [...FIRST_CHARTS, {test: (name) => name === push.name}] : FIRST_CHARTS;
        this.charts = wanted.filter((first) => runs.some((run) => run.histories.some((h) => first.test(h.name)))).map((first) => new Chart(runs, first, (t) => this.go(t)));
        element("charts").append(...this.charts.map((chart) => chart.figure));
        for (const chart of this.charts) chart.renew();
        this.hidden = new Set();
        this.listParts();
        element("up").value = runs[0].up;
        this.turnUp();
        this.listen();
        this.asked = /^#t=([\d.e+-]+)$/.exec(location.hash);
        this.go(this.asked ? Number(this.asked[1]) : 0);
    }

    /** Goes to a frame worth seeing when that is read, unless the address says another time or somebody has gone elsewhere. */
    open() {
        if (this.asked || this.moves > 1) return;
        const {runs} = this, t = runs[0].frames[frameAt(runs[0], worthSeeing(runs[0]))].t, moves = this.moves;
        Promise.all(runs.map((run) => readFrame(run, frameAt(run, t)))).then(() => { if (this.moves === moves) this.go(t); }, failed);
    }

    /** A box to tick for each part, with its colour. */
    listParts() {
        for (const run of this.runs)
            for (const [k, part] of run.parts.entries()) {
                if (element(`part${part}`)) continue;
                const title = run.part_titles[part], box = make("input", {type: "checkbox", id: `part${part}`, checked: ""});
                box.addEventListener("change", () => {
                    if (box.checked) this.hidden.delete(part); else this.hidden.add(part);
                    this.renew();
                });
                const colour = make("span", {class: "swatch"});
                colour.style.background = `rgb(${PART_COLOURS[k % PART_COLOURS.length]})`;
                element("parts").append(make("label", {}, box, colour, title ? `${part} ${title}` : `part ${part}`));
            }
    }

    turnUp() {
        for (const viewer of this.viewers) viewer.turnUp(element("up").value);
        this.ask();
    }

    go(t) {
        this.moves = (this.moves ?? 0) + 1;
        this.t = Math.min(Math.max(t, 0), this.end);
        element("slider").value = 1000 * this.t / this.end;
        element("clock").textContent = `t = ${show(this.t)} ${this.runs[0].units.time}`;
        for (const chart of this.charts) chart.go(this.t);
        this.renew();
    }

    /** To the next or last frame of the first run. */
    step(by) {
        const frames = this.runs[0].frames, k = frameAt(this.runs[0], this.t) + by;
        this.go(frames[Math.min(Math.max(k, 0), frames.length - 1)].t);
    }

    ask() {
        if (this.is_due) return;
        this.is_due = true;
        requestAnimationFrame(() => this.draw());
    }

    renew() {
        this.is_new = true;
        this.ask();
    }

    draw() {
        this.is_due = false;
        const field = element("colour").value;
        for (const viewer of this.viewers) {
            if (this.is_new) this.take(viewer, frameAt(viewer.run, this.t), field);
            viewer.cut(element("toward").value, element("cut").value / 1000);
            viewer.draw(this.camera);
        }
        this.is_new = false;
        const shown = this.runs.some((run) => run.ranges[field]) ? field : element("dots").value;
        for (const run of this.runs) drawLegend(run.legend, run.ranges[shown], run.units[shown] ?? run.units.pressure);
    }

    /** A frame that is not read yet is drawn when it is. */
    take(viewer, k, field) {
        if (viewer.run.frames[k].isRead) return viewer.take(k, viewer.run.ranges[field] ? field : "part", element("dots").value, this.hidden);
        readFrame(viewer.run, k).then(() => this.renew(), failed);
    }

    /** Goes to t, and is there when the picture is. */
    async visit(t) {
        this.go(t);
        await Promise.all(this.runs.map((run) => readFrame(run, frameAt(run, this.t))));
        this.is_new = true;
        this.draw();
    }

    /** Reads all frames, one after the other. */
    async readAhead() {
        for (const run of this.runs)
            for (let k = 0; k < run.frames.length; ++k) {
                await readFrame(run, k);
                await new Promise((go) => setTimeout(go));
            }
    }

    play() {
        const frames = this.runs[0].frames;
        if (this.timer) {
            clearInterval(this.timer);
            this.timer = null;
        } else {
            if (this.t >= frames[frames.length - 1].t) this.go(0);
            this.timer = setInterval(() => {
                this.step(1);
                if (this.t >= frames[frames.length - 1].t) this.play();
            }, 80);
        }
        element("play").textContent = this.timer ? "pause" : "play";
    }

    listen() {
        element("slider").addEventListener("input", (event) => this.go(event.target.value / 1000 * this.end));
        element("play").addEventListener("click", () => this.play());
        for (const id of ["colour", "dots"]) element(id).addEventListener("change", () => this.renew());
        element("view").addEventListener("change", (event) => this.camera.turn(event.target.value));
        element("cut").addEventListener("input", () => this.ask());
        element("toward").addEventListener("change", () => this.ask());
        element("up").addEventListener("change", () => this.turnUp());
        window.addEventListener("resize", () => {
            for (const chart of this.charts) chart.fit();
            this.ask();
        });
        listenToKeys({
            " ": () => this.play(),
            ArrowRight: () => this.step(1),
            ArrowLeft: () => this.step(-1),
            Home: () => this.go(0),
            End: () => this.go(this.end),
            c: () => next(element("colour")),
            p: () => next(element("dots")),
            v: () => next(element("view")),
            x: () => next(element("toward")),
        });
    }
}

async function begin() {
    const csv = element("study");
    const count = document.querySelectorAll("script[id^=bytes]").length;
    const runs = [];
    for (let k = 0; k < count; ++k) runs.push(await readRun(k));
    if (csv) {
        const study = new StudyTable(element("tables"), JSON.parse(csv.textContent));
        study.draw();
        window.study = study;
    }
    if (runs.length === 0) for (const id of ["scene", "player", "charts"]) element(id).remove();
    else window.page = new Page(runs);
    fillTables(element("tables"), runs);
    element("state").textContent = runs.map((run) => `${run.name}: ${run.termination}`).join("; ");
    if (runs.length && !runs.some((run) => run.ranges.contact)) element("colour").querySelector("[value=contact]").remove();
    document.body.dataset.ready = "yes";
    if (runs.length && !runs.some((run) => run.ranges.temperature)) element("dots").querySelector("[value=temperature]").remove();
    if (window.page) setTimeout(() => {
        window.page.open();
        window.page.readAhead().catch(failed);
    }, 100);
}

function failed(why) {
    element("state").textContent = `the page cannot be shown: ${why.message}`;
}

begin().catch(failed);
