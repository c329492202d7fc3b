// Opens a page in Chromium, driven by playwright-core, and says what it saw: lines of name=value on the standard output.
//
// usage of each visit: node visit_*.mjs CHROMIUM PAGE.html, with CORPUSCLE_BROWSER_DRIVER a folder that holds node_modules

import { createRequire } from "node:module";
import { pathToFileURL } from "node:url";

const { chromium } = createRequire(`${process.env.CORPUSCLE_BROWSER_DRIVER}/`)("playwright-core");

export function say(name, value) {
    console.log(`${name}=${typeof value === "string" ? value : JSON.stringify(value)}`);
}

/** What is asked for besides the page itself, and what goes wrong in it. */
class Watch {
    constructor(page, address) {
        this.requests = [];
        this.faults = [];
        page.on("request", (request) => { if (request.url() !== address) this.requests.push(request.url()); });
        page.on("pageerror", (error) => this.faults.push(error.message));
        page.on("console", (message) => { if (["error", "warning"].includes(message.type())) this.faults.push(message.text()); });
    }
}

/** Opens the page, lets `look` see it, and says which requests left the file. */
export async function visit(look, hash = "", [program, file] = process.argv.slice(2)) {
    // the software renderer of WebGL draws the same everywhere
    const browser = await chromium.launch({executablePath: program, args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]});
    try {
        const page = await browser.newPage({viewport: {width: 1280, height: 960}});
        const address = pathToFileURL(file).href, watch = new Watch(page, address);
        await page.goto(`${address}${hash}`, {waitUntil: "commit"});
        await page.waitForSelector("body[data-ready]", {state: "attached"});
        await look(page, address);
        say("requests", watch.requests);
        say("faults", watch.faults);
    } finally {
        await browser.close();
    }
}

/** Waits until the page has drawn what it was asked for last. */
export async function settle(page) {
    await page.evaluate(async () => {
        await Promise.all(window.page.runs.map((run) => readFrame(run, frameAt(run, window.page.t))));
        do await new Promise((go) => requestAnimationFrame(() => setTimeout(go)));
        while (window.page.is_due || window.page.is_new);
    });
}
