// Sorts a study's table by its first response, and looks into its scatter plots.
//
// usage: node visit_study.mjs CHROMIUM PAGE.html HEADING POINTS...   HEADING of the column; of each plot its points, "x,y x,y"

import { say, visit } from "./browser.mjs";
import { pointsInked } from "./pixels.mjs";

const [heading, ...plots] = process.argv.slice(4);
const [POINT, MEAN] = ["#1769c2", "#d1600a"];

await visit(async (page) => {
    const runs = async () => (await page.locator("#tables .scroll tbody tr td:first-child").allTextContents()).join(" ");
    const title = page.locator("th", {hasText: heading});
    say("start", await runs());
    await title.click();
    say("up", await runs());
    await title.focus();
    await page.keyboard.press("Enter");
    say("down", await runs());
    say("plots", (await page.locator("#effects .plot").evaluateAll((all) => all.map((plot) => plot.getAttribute("aria-label")))).join(", "));
    const inked = [], means = [];
    for (const [k, list] of plots.entries()) {
        const points = list.split(" ").map((point) => point.split(",").map(Number));
        const plot = await page.evaluateHandle((k) => window.study.scatters[k], k);
        inked.push(await pointsInked(page, plot, points, POINT));
        const at = (x) => points.filter((p) => p[0] === x), xs = [...new Set(points.map((p) => p[0]))];
        const mean = (x) => at(x).reduce((sum, p) => sum + p[1], 0) / at(x).length;
        means.push(await pointsInked(page, plot, xs.filter((x) => at(x).length > 1).map((x) => [x, mean(x)]), MEAN));
    }
    say("points", inked);
    say("means", means);
});
