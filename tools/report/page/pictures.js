// Not of the page: appended to it for `corpuscle report --png`. Draws some frames of the first run and leaves them
// as the page's only text, a line a picture: its name and its data URL.

(async () => {
    const MOST = 8, COLUMNS = 4, WIDTH = 640, HEIGHT = 480;
    const lines = [], pause = () => new Promise((go) => setTimeout(go, 50));
    const leave = (text) => document.body.replaceChildren(make("pre", {id: "pictures"}, text));
    while (!document.body.dataset.ready) {
        if (element("state").textContent) return leave(element("state").textContent);
        await pause();
    }
    const viewer = window.page.viewers[0], frames = viewer.run.frames, unit = viewer.run.units.time;
    const count = Math.min(MOST, frames.length), columns = Math.min(COLUMNS, count);
    viewer.canvas.style.cssText = `width: ${WIDTH}px; height: ${HEIGHT}px; border: 0`;
    const strip = make("canvas", {width: columns * WIDTH, height: Math.ceil(count / columns) * HEIGHT});
    const pen = strip.getContext("2d");
    pen.font = "28px system-ui, sans-serif";
    for (let k = 0; k < count; ++k) {
        const frame = frames[count === 1 ? 0 : Math.round(k * (frames.length - 1) / (count - 1))];
        await window.page.visit(frame.t);
        lines.push(`picture_${String(k).padStart(2, "0")}.png ${viewer.canvas.toDataURL("image/png")}`);
        const [x, y] = [k % columns * WIDTH, Math.floor(k / columns) * HEIGHT];
        pen.drawImage(viewer.canvas, x, y, WIDTH, HEIGHT);
        pen.fillText(`${show(frame.t)} ${unit}`, x + 16, y + 36);
    }
    lines.push(`strip.png ${strip.toDataURL("image/png")}`);
    leave(`${lines.join("\n")}\n`);
})();
