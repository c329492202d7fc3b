// The picture of a page in the READMEs: a window of a page at a time, drawn by Debian's Chromium.
//
// usage, from the project's root, after tools/setup:
//     build/run/bin/corpuscle run models/oop_linear/oop_linear.k -D NP=20000 -D TSW=1E10
//     build/run/bin/corpuscle report oop_linear.out
//     node tools/figures/page.mjs oop_linear.out/report.html 47 tools/report/page.png

import { createRequire } from "node:module";
import { pathToFileURL } from "node:url";

const { chromium } = createRequire(new URL("../../build/browser_driver/", import.meta.url))("playwright-core");
const [file, time, picture] = process.argv.slice(2);

const browser = await chromium.launch({executablePath: "/usr/bin/chromium", args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]});
const page = await browser.newPage({viewport: {width: 1280, height: 930}});
await page.goto(pathToFileURL(file).href);
await page.waitForSelector("body[data-ready]", {state: "attached"});
await page.selectOption("#toward", "-y");
await page.fill("#cut", "500");
await page.selectOption("#dots", "speed");
await page.locator("h1").click();  // nothing stands in focus
await page.evaluate((t) => {  // nearer
    window.page.camera.position.multiplyScalar(0.7);
    return window.page.visit(t);
}, Number(time));
await page.screenshot({path: picture});
await browser.close();
