// Opens a page that comes in two parts, as from a slow disk or network: the first ends within a frame's bytes.
//
// usage: node visit_slow.mjs CHROMIUM PAGE.html FRAME...   FRAME: ids of the elements in which the page is cut, one after the other

import { createServer } from "node:http";
import { readFileSync } from "node:fs";
import { say, visit } from "./browser.mjs";

const [file, ...frames] = process.argv.slice(3);
const text = readFileSync(file, "latin1");

/** The page's first part: five characters of the frame's base64, which are no whole group. */
const firstPart = (frame) => {
    const tag = `id="${frame}">`;
    return text.indexOf(tag) + tag.length + 5;
};

await visit(async (page) => {
    let answer, asked;
    const server = createServer((request, response) => {
        response.writeHead(200, {"content-type": "text/html; charset=utf-8"});
        response.write(Buffer.from(text.slice(0, firstPart(asked)), "latin1"));
        answer = response;
    });
    await new Promise((go) => server.listen(0, "127.0.0.1", go));
    const seen = {};
    for (const frame of frames) {
        asked = frame;
        await page.goto(`http://127.0.0.1:${server.address().port}/`, {waitUntil: "commit"});
        await page.waitForSelector("body[data-ready]", {state: "attached"});
        await page.waitForFunction((frame) => document.getElementById(frame), frame);
        await page.waitForTimeout(500);  // all other frames are read, and this one is wanted
        seen[frame] = [await page.evaluate(() => window.page.runs[0].frames.filter((frame) => frame.isRead).length)];
        answer.end(Buffer.from(text.slice(firstPart(frame)), "latin1"));
        await page.waitForFunction(() => document.readyState === "complete");
        await page.waitForTimeout(200);
        seen[frame].push(await page.evaluate(() => window.page.runs[0].frames.filter((frame) => frame.isRead).length));
        say(`state of ${frame}`, await page.locator("#state").textContent());
    }
    say("read", seen);
    server.closeAllConnections();
    server.close();
});
