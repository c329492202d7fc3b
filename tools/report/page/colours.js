// Colours that stay apart on a projector and for the colour-blind.

const PART_COLOURS = [[86, 140, 190], [222, 143, 60], [110, 170, 110], [190, 100, 120], [150, 130, 190], [150, 120, 90], [120, 120, 120], [225, 200, 90], [70, 160, 160]];
const LINE_COLOURS = ["#1769c2", "#d1600a", "#2e8540", "#a02060", "#6a4ea0"];
const SPECIES_COLOURS = [[60, 120, 220], [230, 90, 30], [40, 160, 90], [170, 60, 170], [200, 170, 0]];

/** From dark blue over green to yellow, share 0 to 1. */
function ramp(share) {
    const stops = [[40, 50, 120], [30, 120, 145], [70, 175, 110], [190, 215, 70], [253, 231, 37]];
    const at = Math.min(Math.max(share, 0), 1) * (stops.length - 1);
    const k = Math.min(Math.floor(at), stops.length - 2), rest = at - k;
    return stops[k].map((low, c) => Math.round(low + rest * (stops[k + 1][c] - low)));
}
const RAMP = Array.from({length: 256}, (_, k) => ramp(k / 255));

function drawLegend(canvas, range, unit) {
    const pen = canvas.getContext("2d");
    pen.clearRect(0, 0, canvas.width, canvas.height);
    if (!range) return;
    for (let k = 0; k < canvas.width; ++k) {
        pen.fillStyle = `rgb(${RAMP[Math.floor(255 * k / (canvas.width - 1))]})`;
        pen.fillRect(k, 0, 1, 14);
    }
    pen.fillStyle = "#1c2430";
    pen.font = "14px system-ui, sans-serif";
    pen.textAlign = "left";
    pen.fillText(show(range[0]), 0, 30);
    pen.textAlign = "right";
    pen.fillText(`${show(range[1])} ${unit}`, canvas.width, 30);
}
