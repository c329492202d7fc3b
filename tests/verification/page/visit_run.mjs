// Does with a page of one or two runs what a person would.
//
// usage: node visit_run.mjs CHROMIUM PAGE.html TIMES VALUES...   TIMES of the frames, VALUES of the first chart's curve of each run

import { say, settle, visit } from "./browser.mjs";
import { allDiffer, allSame, pictures, pointsInked } from "./pixels.mjs";

const [times, ...curves] = process.argv.slice(4).map((list) => list.split(",").map(Number));
const LINES = ["#1769c2", "#d1600a"];
const end = times.at(-1);

const reading = (page) => page.locator("#charts .plot").first().getAttribute("aria-label");
const legend = (page) => page.evaluate(() => [...document.querySelector("#charts .u-legend").querySelectorAll(".u-value")].map((cell) => cell.textContent).join(", "));
const now = (page) => page.evaluate(() => window.page.t);

/** Where the first chart's time cursor stands, as a share of the chart's width. */
const cursor = (page) => page.evaluate(() => {
    const chart = document.querySelector("#charts .u-over").getBoundingClientRect(), line = document.querySelector("#charts .now").getBoundingClientRect();
    return (0.5 * (line.left + line.right) - chart.left) / chart.width;
});

async function press(page, key) {
    await page.keyboard.press(key);
    await settle(page);
}

async function slide(page, name, value) {
    await page.locator(name).fill(String(value));
    await settle(page);
    return pictures(page);
}

/** The slider moves the bag, which grows, the cursor and the clock. */
async function slider(page) {
    const reach = [], off = [];
    let all;
    for (const t of times) {
        all = await slide(page, "#slider", Math.round(1000 * t / end));
        reach.push(Math.min(...all.map((one) => one.reach)));
        off.push(Math.abs(await cursor(page) - t / end));
    }
    say("bag grows", reach.every((one, k) => k === 0 || one > 1.02 * reach[k - 1]));
    say("last over first bag", all.at(-1).reach / all[0].reach);
    say("cursor off", Math.max(...off));
    say("end", await reading(page));
    say("legend", await legend(page));
    say("clock", await page.locator("#clock").textContent());
}

/** Another history in the first chart, at the same time. */
async function choose(page, name) {
    const select = page.locator("#charts select").first(), first = await select.inputValue();
    await select.selectOption(name);
    await settle(page);
    say("chosen", await reading(page));
    say("cursor of chosen off", Math.abs(await cursor(page) - 1));
    await select.selectOption(first);
}

async function keyboard(page, start) {
    await page.locator("h1").click();  // out of the slider
    await press(page, "Home");
    say("home", await reading(page));
    say("back", allSame(await pictures(page), start));
    await press(page, "ArrowRight");
    say("right", await now(page));
    await press(page, "ArrowLeft");
    say("left", await now(page));
    await press(page, "End");
    say("end key", await now(page));
    for (const [key, name] of [["c", "colour"], ["p", "dots"], ["v", "view"]]) {
        const before = await pictures(page);
        await press(page, key);
        say(name, allDiffer(await pictures(page), before));
    }
    // what the button says meanwhile, however slow the machine is: a run plays for a third of a second
    const said = await page.evaluateHandle(() => {
        const texts = [], button = document.getElementById("play");
        new MutationObserver(() => texts.push(button.textContent)).observe(button, {childList: true});
        return texts;
    });
    await press(page, "Space");
    await page.waitForFunction((end) => window.page.t === end && !window.page.timer, end);
    const texts = await said.jsonValue();
    say("plays", texts[0] ?? "");
    say("played", texts.at(-1) ?? "");
}

/** Particles by species, speed and temperature are three pictures. */
async function gas(page) {
    const select = page.locator("#dots"), first = await select.inputValue(), seen = [];
    for (const name of ["species", "speed", "temperature"]) {
        await select.selectOption(name);
        await settle(page);
        seen.push(await pictures(page));
    }
    say("gas", allDiffer(seen[0], seen[1]) && allDiffer(seen[1], seen[2]) && allDiffer(seen[0], seen[2]));
    await select.selectOption(first);
    await settle(page);
}

/** Every direction hides the half of every picture that it points to, and back at the end all is there. */
async function cut(page) {
    const hides = {};
    const select = async (name, value) => {
        await page.locator(name).selectOption(value);
        await settle(page);
    };
    // what is left lies further left, right, down or up: [view, axis of the screen, sign]
    const left = {x: ["top", 0, -1], "-x": ["top", 0, 1], y: ["front", 0, -1], "-y": ["front", 0, 1], z: ["front", 1, 1], "-z": ["front", 1, -1]};
    for (const [toward, [view, axis, sign]] of Object.entries(left)) {
        await select("#view", {label: view});
        const whole = await pictures(page);
        await select("#toward", toward);
        const half = await slide(page, "#cut", 500);
        hides[toward] = half.every((one, k) => one.ink < 0.9 * whole[k].ink && one.ink > 0.1 * whole[k].ink && sign * (one.centre[axis] - whole[k].centre[axis]) > 5);
        hides[toward] &&= allSame(await slide(page, "#cut", 1000), whole);
    }
    say("cuts", hides);
    await select("#view", {label: "oblique"});
}

/** The mouse turns all pictures alike and zooms; a chart picks a time, and zooms all charts. */
async function mouse(page) {
    const picture = await page.locator("canvas.picture").first().boundingBox();
    const [x, y] = [picture.x + 0.5 * picture.width, picture.y + 0.5 * picture.height];
    let before = await pictures(page);
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 60, y + 20, {steps: 3});
    await page.mouse.up();
    await settle(page);
    say("turned", allDiffer(await pictures(page), before));
    before = await pictures(page);
    await page.mouse.wheel(0, 400);
    await settle(page);
    say("smaller", (await pictures(page)).every((one, k) => one.ink < before[k].ink));

    const over = await page.locator("#charts .u-over").first().boundingBox();
    await page.mouse.click(over.x + 0.25 * over.width, over.y + 0.5 * over.height);
    await settle(page);
    say("picked", Math.abs(await now(page) - 0.25 * end) < 0.01 * end);
    await page.mouse.move(over.x + 0.2 * over.width, over.y + 0.5 * over.height);
    await page.mouse.down();
    await page.mouse.move(over.x + 0.6 * over.width, over.y + 0.5 * over.height, {steps: 4});
    await page.mouse.up();
    say("zoomed", await page.evaluate((end) => window.page.charts.every(({plot}) => Math.abs(plot.scales.x.min - 0.2 * end) + Math.abs(plot.scales.x.max - 0.6 * end) < 0.02 * end), end));
    say("time kept", Math.abs(await now(page) - 0.25 * end) < 0.01 * end);
}

/** Pictures and charts fill a window that is narrower. */
async function resize(page) {
    await page.setViewportSize({width: 900, height: 700});
    await page.waitForTimeout(100);
    await settle(page);
    say("fits", await page.evaluate(() => window.page.charts.every(({plot, place}) => plot.width === place.clientWidth && plot.root.clientWidth === place.clientWidth)
        && window.page.viewers.every(({canvas}) => canvas.width === canvas.clientWidth && canvas.height === canvas.clientHeight)
        && document.documentElement.scrollWidth <= innerWidth));
}

/** A part's box hides it; another axis up is another picture; without #t= the page opens on a frame worth seeing. */
async function parts(page) {
    const before = await pictures(page), box = page.locator("#parts input").first();
    await box.uncheck();
    await settle(page);
    say("hidden", (await pictures(page)).every((one, k) => one.ink < before[k].ink));
    await box.check();
    await settle(page);
    say("shown", allSame(await pictures(page), before));
    await page.locator("#up").selectOption("-y");
    await settle(page);
    say("up", allDiffer(await pictures(page), before));
    await page.locator("#up").selectOption("z");
    await settle(page);
    say("up again", allSame(await pictures(page), before));
}

/** A projector's window: nothing sideways, and the pictures and their player in sight. */
async function projector(page) {
    await page.setViewportSize({width: 1280, height: 900});
    await page.waitForTimeout(100);
    await settle(page);
    say("projector", await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth && document.getElementById("player").getBoundingClientRect().bottom < innerHeight
        && document.querySelector("#charts figure").getBoundingClientRect().top < innerHeight));
}

async function reopen(page, address) {
    await page.goto("about:blank");
    await page.goto(address, {waitUntil: "commit"});
    await page.waitForSelector("body[data-ready]", {state: "attached"});
    await page.waitForFunction(() => window.page.t > 0);
    say("opens at", await now(page));
}

/** Nothing is drawn while nothing changes. */
async function idle(page) {
    const drawn = () => page.evaluate(() => window.page.viewers.map((viewer) => viewer.renderer.info.render.frame));
    const before = await drawn();
    await page.waitForTimeout(400);
    const after = await drawn();
    await press(page, "Home");
    say("idle", after.every((count, k) => count === before[k]) && (await drawn()).every((count, k) => count > after[k]));
}

await visit(async (page, address) => {
    await settle(page);
    const start = await pictures(page);
    say("pictures", start.length);
    say("ink", Math.min(...start.map((one) => one.ink)));
    say("colours", Math.min(...start.map((one) => one.colours)));
    say("start", await reading(page));
    const inked = [], plot = await page.evaluateHandle(() => window.page.charts[0].plot);
    for (const [k, values] of curves.entries()) inked.push(await pointsInked(page, plot, times.map((t, row) => [t, values[row]]), LINES[k]));
    say("curve", inked);
    await slider(page);
    await choose(page, "airbag/7/volume");
    await keyboard(page, start);
    await gas(page);
    await cut(page);
    await mouse(page);
    await resize(page);
    await idle(page);
    await parts(page);
    await projector(page);
    await reopen(page, address);
}, "#t=0");
