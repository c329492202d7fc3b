// A run in 3-D: its shells as triangles, its particles as points. Draws when it is asked to.

const SHADERS = {
    vertex: `#version 300 es
        in vec3 place; in vec3 colour;
        uniform mat4 camera; uniform vec3 low, size; uniform float dot;
        out vec3 tint; out vec3 world; out float height;
        void main() {
            world = low + size * place; tint = colour; height = place.z;
            gl_Position = camera * vec4(world, 1.0); gl_PointSize = dot;
        }`,
    fragment: `#version 300 es
        precision highp float;
        in vec3 tint; in vec3 world; in float height;
        uniform float cut; uniform bool lit;
        out vec4 ink;
        void main() {
            if (height > cut) discard;
            float light = 1.0;
            if (lit) light = 0.35 + 0.65 * abs(normalize(cross(dFdx(world), dFdy(world))).z * 0.6 + 0.4);
            ink = vec4(tint * light, 1.0);
        }`,
};

class Viewer {
    constructor(canvas, run, moved) {
        this.canvas = canvas;
        this.run = run;
        this.moved = moved;
        const gl = this.gl = canvas.getContext("webgl2", {antialias: true, preserveDrawingBuffer: true});
        if (!gl) throw new Error("this browser has no WebGL 2");
        this.program = this.link();
        this.shells = this.array(3 * run.triangles);
        this.dots = this.array(Math.max(1, ...run.frames.map((frame) => frame.count)));
        this.low = run.box.map((range) => range[0]);
        this.size = run.box.map((range) => range[1] - range[0]);
        this.radius = 0.5 * Math.hypot(...this.size) || 1;
        this.camera = {turn: -0.9, tilt: 1.15, far: 1.6, x: 0, y: 0};
        this.follow();
    }

    link() {
        const gl = this.gl, program = gl.createProgram();
        for (const [kind, text] of [[gl.VERTEX_SHADER, SHADERS.vertex], [gl.FRAGMENT_SHADER, SHADERS.fragment]]) {
            const shader = gl.createShader(kind);
            gl.shaderSource(shader, text);
            gl.compileShader(shader);
            gl.attachShader(program, shader);
        }
        gl.linkProgram(program);
        if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
        gl.useProgram(program);
        return program;
    }

    /** Room for places and colours of so many corners. */
    array(count) {
        const gl = this.gl, all = {vertices: gl.createVertexArray(), place: new Uint16Array(3 * count), colour: new Uint8Array(3 * count)};
        gl.bindVertexArray(all.vertices);
        for (const [name, type] of [["place", gl.UNSIGNED_SHORT], ["colour", gl.UNSIGNED_BYTE]]) {
            const buffer = all[`${name}Buffer`] = gl.createBuffer();
            gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
            gl.bufferData(gl.ARRAY_BUFFER, all[name].byteLength, gl.DYNAMIC_DRAW);
            const at = gl.getAttribLocation(this.program, name);
            gl.enableVertexAttribArray(at);
            gl.vertexAttribPointer(at, 3, type, true, 0, 0);
        }
        return all;
    }

    send(all, count) {
        const gl = this.gl;
        for (const name of ["place", "colour"]) {
            gl.bindBuffer(gl.ARRAY_BUFFER, all[`${name}Buffer`]);
            gl.bufferSubData(gl.ARRAY_BUFFER, 0, all[name], 0, 3 * count);
        }
    }

    /** Takes what a frame shows: field is part, pressure, stress or contact; dots species, speed or off. */
    take(index, field, dots) {
        const {run, shells} = this, frame = run.frames[index];
        const partColour = new Map(run.parts.map((part, k) => [part, PART_COLOURS[k % PART_COLOURS.length]]));
        for (let t = 0, at = 0; t < run.triangles; ++t) {
            const shell = run.shellOf[t];
            const colour = field === "part" ? partColour.get(run.shell_part[shell]) : RAMP[frame[field][shell]];
            for (let c = 0; c < 3; ++c, at += 3)
                for (let k = 0; k < 3; ++k) {
                    shells.place[at + k] = frame.x[3 * run.corners[3 * t + c] + k];
                    shells.colour[at + k] = colour[k];
                }
        }
        this.send(shells, 3 * run.triangles);
        this.dotCount = dots === "off" ? 0 : frame.count;
        if (this.dotCount === 0) return;
        this.dots.place.set(frame.particles);
        for (let p = 0; p < frame.count; ++p) {
            const colour = dots === "speed" ? RAMP[frame.speed[p]] : SPECIES_COLOURS[frame.species[p] % SPECIES_COLOURS.length];
            for (let k = 0; k < 3; ++k) this.dots.colour[3 * p + k] = colour[k];
        }
        this.send(this.dots, frame.count);
    }

    /** Perspective times look-at, column by column. */
    matrix() {
        const {turn, tilt, far, x, y} = this.camera, r = this.radius;
        const [ct, st, cp, sp] = [Math.cos(turn), Math.sin(turn), Math.cos(tilt), Math.sin(tilt)];
        const right = [-st, ct, 0], back = [ct * sp, st * sp, cp], up = [-ct * cp, -st * cp, sp];
        const centre = this.low.map((low, k) => low + 0.5 * this.size[k]);
        const along = (axis) => axis[0] * centre[0] + axis[1] * centre[1] + axis[2] * centre[2];
        const [ex, ey, ez] = [x * r - along(right), y * r - along(up), -far * r - along(back)];
        const focus = 1.8, aspect = this.canvas.width / this.canvas.height, near = 0.05 * r, end = 20 * r;
        const a = (end + near) / (near - end), b = 2 * end * near / (near - end), fx = focus / aspect;
        const m = [];
        for (let k = 0; k < 3; ++k) m.push(fx * right[k], focus * up[k], a * back[k], -back[k]);
        return new Float32Array([...m, fx * ex, focus * ey, a * ez + b, -ez]);
    }

    draw(cut) {
        const {gl, canvas} = this, at = (name) => gl.getUniformLocation(this.program, name);
        const scale = window.devicePixelRatio || 1;
        canvas.width = Math.max(1, Math.round(canvas.clientWidth * scale));
        canvas.height = Math.max(1, Math.round(canvas.clientHeight * scale));
        gl.viewport(0, 0, canvas.width, canvas.height);
        gl.clearColor(0.96, 0.97, 0.98, 1);
        gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
        gl.enable(gl.DEPTH_TEST);
        gl.uniformMatrix4fv(at("camera"), false, this.matrix());
        gl.uniform3fv(at("low"), this.low);
        gl.uniform3fv(at("size"), this.size);
        gl.uniform1f(at("cut"), cut);
        gl.uniform1f(at("dot"), 2.5 * scale);
        gl.uniform1i(at("lit"), 1);
        gl.bindVertexArray(this.shells.vertices);
        gl.drawArrays(gl.TRIANGLES, 0, 3 * this.run.triangles);
        if (!this.dotCount) return;
        gl.uniform1i(at("lit"), 0);
        gl.bindVertexArray(this.dots.vertices);
        gl.drawArrays(gl.POINTS, 0, this.dotCount);
    }

    /** Turns, shifts and zooms with the mouse or a finger. */
    follow() {
        const {canvas} = this;
        let last = null;
        canvas.addEventListener("pointerdown", (event) => {
            last = event;
            canvas.setPointerCapture(event.pointerId);
        });
        canvas.addEventListener("pointermove", (event) => {
            if (!last) return;
            const [dx, dy] = [event.clientX - last.clientX, event.clientY - last.clientY].map((d) => d / canvas.clientHeight);
            if (event.shiftKey || event.buttons === 2) {
                this.camera.x += dx * this.camera.far;
                this.camera.y -= dy * this.camera.far;
            } else {
                this.camera.turn -= 4 * dx;
                this.camera.tilt = Math.min(Math.max(this.camera.tilt - 4 * dy, 0.01), Math.PI - 0.01);
            }
            last = event;
            this.moved(this.camera);
        });
        canvas.addEventListener("pointerup", () => { last = null; });
        canvas.addEventListener("contextmenu", (event) => event.preventDefault());
        canvas.addEventListener("wheel", (event) => {
            event.preventDefault();
            this.camera.far = Math.min(Math.max(this.camera.far * Math.exp(0.001 * event.deltaY), 0.3), 15);
            this.moved(this.camera);
        }, {passive: false});
    }
}
