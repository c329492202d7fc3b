// What a page shows when it opens: the axis that is up, what its charts are of, and its tables' texts.
//
// usage: node visit_opening.mjs CHROMIUM PAGE.html

import { say, settle, visit } from "./browser.mjs";

await visit(async (page) => {
    await page.waitForFunction(() => window.page.moves > 1);  // it has gone to the frame worth seeing
    await settle(page);
    say("t", await page.evaluate(() => window.page.t));
    say("up", await page.locator("#up").inputValue());
    say("charts", await page.locator("#charts select").evaluateAll((all) => all.map((select) => select.selectedOptions[0].textContent)));
    const rows = (title) => page.locator("#tables div", {has: page.locator(`> h2:text-is("${title}")`)}).last();
    say("responses", await rows("Responses of rigid bodies").locator("tbody tr td:nth-child(2)").allTextContents());
    say("mended", await rows("Mended").locator("li").allTextContents());
});
