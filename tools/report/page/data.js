// What the page was given: runs as JSON and bytes, or a study's table.

/** Fields that particles have; all others are the shells'. */
const OF_PARTICLES = ["speed", "temperature"];

/** Frames but the first stand behind the scripts, so that those need not wait for them. */
const wholePage = new Promise((go) => document.addEventListener("DOMContentLoaded", go));

/**
 * Whether <script id> has all of its text. The parser adds an element at its start tag and its text piece by piece, and
 * goes on behind it only after its end tag.
 */
const isWhole = (id) => Boolean(document.getElementById(id)?.nextSibling);

/** The bytes behind <script id>: base64 of deflate. */
async function bytesOf(id) {
    if (!isWhole(id)) await wholePage;
    const text = atob(document.getElementById(id).textContent.trim());
    const packed = new Uint8Array(text.length);
    for (let k = 0; k < text.length; ++k) packed[k] = text.charCodeAt(k);  // Uint8Array.from is many times slower
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
    return new Response(stream).arrayBuffer();
}

/** A run with its mesh, its histories and its first frame in place. */
async function readRun(index) {
    const run = JSON.parse(document.getElementById(`run${index}`).textContent);
    run.index = index;
    const first = run.frames.length ? readFrame(run, 0) : null;
    const bytes = await bytesOf(`bytes${index}`);
    run.corners = new Uint32Array(bytes, run.corners_at, 3 * run.triangles);
    run.shellOf = new Uint32Array(bytes, run.shell_of_at, run.triangles);
    for (const history of run.histories) history.values = new Float32Array(bytes, history.at, run.rows);
    run.time = run.histories[0].values;
    run.parts = [...new Set(run.shell_part)];
    await first;
    return run;
}

/** A frame with its arrays in place, and those before it: positions are summed up from their changes. */
function readFrame(run, k) {
    const frame = run.frames[k];
    const read = async () => {
        const last = k > 0 ? readFrame(run, k - 1) : null;
        const bytes = await bytesOf(`frame${run.index}_${k}`), before = await last;
        frame.x = new Uint16Array(bytes, frame.x, 3 * run.nodes);
        if (before) for (let i = 0; i < frame.x.length; ++i) frame.x[i] += before.x[i];
        for (const name of Object.keys(run.ranges)) frame[name] = new Uint8Array(bytes, frame[name], OF_PARTICLES.includes(name) ? frame.count : run.shells);
        frame.particles = new Uint16Array(bytes, frame.particles, 3 * frame.count);
        frame.species = new Uint8Array(bytes, frame.species, frame.count);
        frame.isRead = true;
        return frame;
    };
    return frame.reading ??= read();
}

/** The frame that is nearest to t. */
function frameAt(run, t) {
    let best = 0;
    run.frames.forEach((frame, k) => {
        if (Math.abs(frame.t - t) < Math.abs(run.frames[best].t - t)) best = k;
    });
    return best;
}

/** The row of `times`, which go up, that is nearest to t. */
function rowAt(times, t) {
    let low = 0, high = times.length - 1;
    while (high - low > 1) {
        const middle = (low + high) >> 1;
        if (times[middle] <= t) low = middle; else high = middle;
    }
    return t - times[low] < times[high] - t ? low : high;
}

function show(number) {
    if (number === null || Number.isNaN(number)) return "-";
    return String(Number(number.toPrecision(5)));
}

function make(name, attributes = {}, ...children) {
    const element = document.createElement(name);
    for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
    element.append(...children);
    return element;
}
