// The page by keyboard.

/** @param acts  what to do at a key, by KeyboardEvent.key */
function listenToKeys(acts) {
    document.addEventListener("keydown", (event) => {
        if (["INPUT", "SELECT", "BUTTON"].includes(event.target.tagName)) return;
        const act = acts[event.key];
        if (!act) return;
        event.preventDefault();
        act();
    });
}

/** To a select's next option. */
function next(select) {
    select.selectedIndex = (select.selectedIndex + 1) % select.length;
    select.dispatchEvent(new Event("change"));
}
