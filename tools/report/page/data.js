// What the page was given: runs as JSON and bytes, or a study's table.

/** The bytes behind <script id>: base64 of deflate. */
async function bytesOf(id) {
    const text = atob(document.getElementById(id).textContent.trim());
    const packed = new Uint8Array(text.length);
    for (let k = 0; k < text.length; ++k) packed[k] = text.charCodeAt(k);  // Uint8Array.from is many times slower
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
    return new Response(stream).arrayBuffer();
}

/** A run with its arrays in place; positions are summed up from their changes. */
async function readRun(index) {
    const run = JSON.parse(document.getElementById(`run${index}`).textContent);
    const bytes = await bytesOf(`bytes${index}`);
    run.corners = new Uint32Array(bytes, run.corners_at, 3 * run.triangles);
    run.shellOf = new Uint32Array(bytes, run.shell_of_at, run.triangles);
    let before = null;
    for (const frame of run.frames) {
        const x = new Uint16Array(bytes, frame.x, 3 * run.nodes);
        if (before) for (let k = 0; k < x.length; ++k) x[k] += before[k];
        before = frame.x = x;
        frame.pressure = new Uint8Array(bytes, frame.pressure, run.shells);
        frame.stress = new Uint8Array(bytes, frame.stress, run.shells);
        frame.particles = new Uint16Array(bytes, frame.particles, 3 * frame.count);
        frame.species = new Uint8Array(bytes, frame.species, frame.count);
        frame.speed = new Uint8Array(bytes, frame.speed, frame.count);
    }
    for (const history of run.histories) history.values = new Float32Array(bytes, history.at, run.rows);
    run.time = run.histories[0].values;
    run.parts = [...new Set(run.shell_part)];
    return run;
}

/** The frame that is nearest to t. */
function frameAt(run, t) {
    let best = 0;
    run.frames.forEach((frame, k) => {
        if (Math.abs(frame.t - t) < Math.abs(run.frames[best].t - t)) best = k;
    });
    return best;
}

/** The row of the histories that is nearest to t. */
function rowAt(run, t) {
    let low = 0, high = run.rows - 1;
    while (high - low > 1) {
        const middle = (low + high) >> 1;
        if (run.time[middle] <= t) low = middle; else high = middle;
    }
    return t - run.time[low] < run.time[high] - t ? low : high;
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
