// Opens a page several times in one browser: how long until its first picture is there, at best.
//
// usage: node visit_large.mjs CHROMIUM PAGE.html

import { say, visit } from "./browser.mjs";
import { pictures } from "./pixels.mjs";

const TIMES = 4;  // the browser is warm from the second on

await visit(async (page, address) => {
    const seconds = [];
    for (let k = 0; k < TIMES; ++k) {
        await page.goto(address, {waitUntil: "commit"});
        seconds.push(await page.evaluate(() => new Promise((go) => {
            const look = () => {
                if (!document.body?.dataset.ready) return setTimeout(look, 5);
                window.page.draw();
                document.querySelector("canvas.picture").getContext("webgl2").readPixels(0, 0, 1, 1, 6408, 5121, new Uint8Array(4));  // waits for the picture
                go(0.001 * performance.now());
            };
            look();
        })));
    }
    say("opened", Math.min(...seconds));
    say("ink", (await pictures(page))[0].ink);
    say("first", seconds[0]);
});
