// What is on a page's canvases, by their pixels.

/** Of each 3-D picture: share that is not paper, colours, how far the ink reaches, its centre, and a sum that tells pictures apart. */
export function pictures(page) {
    return page.evaluate(() => [...document.querySelectorAll("#scene canvas.picture")].map((canvas) => {
        const {width, height} = canvas, copy = new OffscreenCanvas(width, height).getContext("2d", {willReadFrequently: true});
        copy.drawImage(canvas, 0, 0);
        const pixels = copy.getImageData(0, 0, width, height).data, colours = new Set();
        let inked = 0, sum = 0, x = 0, y = 0, left = width, right = 0, top = height, bottom = 0;
        for (let k = 0; k < width * height; ++k) {
            const [r, g, b] = [pixels[4 * k], pixels[4 * k + 1], pixels[4 * k + 2]];
            if (r >= 235 && g >= 235 && b >= 235) continue;
            ++inked;
            [x, y] = [x + k % width, y + Math.floor(k / width)];
            sum = (31 * sum + k + r + 256 * g + 65536 * b) % 1000000007;
            colours.add(r + 256 * g + 65536 * b);
            [left, right] = [Math.min(left, k % width), Math.max(right, k % width)];
            [top, bottom] = [Math.min(top, Math.floor(k / width)), Math.max(bottom, Math.floor(k / width))];
        }
        return {ink: inked / (width * height), colours: colours.size, reach: Math.hypot(right - left, bottom - top), centre: [x / inked, y / inked], sum};
    }));
}

/** Whether every picture differs from what it was. */
export const allDiffer = (now, before) => now.every((one, k) => one.sum !== before[k].sum);
export const allSame = (now, before) => now.every((one, k) => one.sum === before[k].sum);

/**
 * How many of the points [x, y] have a plot's colour at their place on it, within a pixel.
 * @param plot  handle of uPlot's object
 */
export function pointsInked(page, plot, points, colour) {
    return page.evaluate(([plot, points, colour]) => {
        const {canvas} = plot.ctx, copy = new OffscreenCanvas(canvas.width, canvas.height).getContext("2d", {willReadFrequently: true});
        copy.drawImage(canvas, 0, 0);
        const [r, g, b] = [1, 3, 5].map((k) => parseInt(colour.slice(k, k + 2), 16));
        return points.filter(([x, y]) => {
            const at = [plot.valToPos(x, "x", true), plot.valToPos(y, "y", true)].map(Math.round);
            const near = copy.getImageData(at[0] - 1, at[1] - 1, 3, 3).data;
            for (let k = 0; k < near.length; k += 4)
                if (Math.hypot(near[k] - r, near[k + 1] - g, near[k + 2] - b) < 60) return true;
            return false;
        }).length;
    }, [plot, points, colour]);
}
