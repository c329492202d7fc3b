// A run in 3-D: its shells as triangles, its particles as points. Draws when it is asked to.

lib.ColorManagement.enabled = false;  // colours are shown as colours.js has them

const SKY = 0xffffff, GROUND = 0x606870, PAPER = 0xf5f7fa;
const DOT = 2.5;  // [pixel]

/** Low corner and size of a box of [low, high] ranges. */
const lowOf = (box) => box.map((range) => range[0]);
const sizeOf = (box) => box.map((range) => range[1] - range[0]);

/** The box of all runs, so that they are shown in one scale. */
function commonBox(runs) {
    return [0, 1, 2].map((k) => [Math.min(...runs.map((run) => run.box[k][0])), Math.max(...runs.map((run) => run.box[k][1]))]);
}

class Viewer {
    /** The scene's unit is half the diagonal of `box`, its origin the box's centre. */
    constructor(canvas, run, box) {
        this.canvas = canvas;
        this.run = run;
        this.box = box;
        this.radius = 0.5 * Math.hypot(...sizeOf(box)) || 1;
        const context = canvas.getContext("webgl2", {antialias: true, preserveDrawingBuffer: true});
        if (!context) throw new Error("this browser has no WebGL 2");
        this.renderer = new lib.WebGLRenderer({canvas, context});
        this.renderer.outputColorSpace = lib.LinearSRGBColorSpace;
        this.renderer.setClearColor(PAPER);
        this.shells = this.object(lib.Mesh, 3 * run.triangles, new lib.MeshLambertMaterial({vertexColors: true, flatShading: true, side: lib.DoubleSide}));
        this.dots = this.object(lib.Points, Math.max(1, ...run.frames.map((frame) => frame.count)), new lib.PointsMaterial({vertexColors: true, size: DOT, sizeAttenuation: false}));
        this.sky = new lib.HemisphereLight(SKY, GROUND, 0.55 * Math.PI);
        this.lamp = new lib.DirectionalLight(SKY, 0.5 * Math.PI);
        this.scene = new lib.Scene().add(this.shells, this.dots, this.sky, this.lamp);
        this.turnUp("z");
    }

    /** Turns the scene so that an axis of the deck, such as "z" or "-y", points up in the pictures. */
    turnUp(axis) {
        const up = new lib.Vector3().setComponent("xyz".indexOf(axis.at(-1)), axis.startsWith("-") ? -1 : 1);
        this.scene.quaternion.setFromUnitVectors(up, new lib.Vector3(0, 0, 1));
        this.sky.position.copy(up);
    }

    /** Coordinate k of the deck in the scene. */
    inScene(k, value) {
        const [low, high] = this.box[k];
        return (value - 0.5 * (low + high)) / this.radius;
    }

    /** Room for places, in 16 bits of the run's box, and colours of so many corners. */
    object(Kind, count, material) {
        const geometry = new lib.BufferGeometry();
        geometry.setAttribute("position", new lib.BufferAttribute(new Uint16Array(3 * count), 3, true));
        geometry.setAttribute("color", new lib.BufferAttribute(new Uint8Array(3 * count), 3, true));
        const object = new Kind(geometry, material), {box} = this.run;
        object.position.set(...lowOf(box).map((low, k) => this.inScene(k, low)));
        object.scale.set(...sizeOf(box).map((size) => (size || 1e-9) / this.radius));
        object.frustumCulled = false;
        return object;
    }

    /** Takes what a frame shows: field is part, pressure, stress or contact; dots species, speed, temperature or off. */
    take(index, field, dots, hidden) {
        const frame = this.run.frames[index];
        this.takeShells(frame, field, hidden);
        this.dots.visible = dots !== "off" && frame.count > 0;
        if (this.dots.visible) this.takeDots(frame, dots);
    }

    takeShells(frame, field, hidden) {
        const {run} = this, {position, color} = this.shells.geometry.attributes;
        const partColour = new Map(run.parts.map((part, k) => [part, PART_COLOURS[k % PART_COLOURS.length]]));
        for (let t = 0, at = 0; t < run.triangles; ++t) {
            const shell = run.shellOf[t], isHidden = hidden.has(run.shell_part[shell]);
            const colour = field === "part" ? partColour.get(run.shell_part[shell]) : RAMP[frame[field][shell]];
            for (let c = 0; c < 3; ++c, at += 3)
                for (let k = 0; k < 3; ++k) {
                    position.array[at + k] = frame.x[3 * run.corners[3 * t + (isHidden ? 0 : c)] + k];  // hidden: no area
                    color.array[at + k] = colour[k];
                }
        }
        position.needsUpdate = color.needsUpdate = true;
    }

    takeDots(frame, dots) {
        const {position, color} = this.dots.geometry.attributes;
        position.array.set(frame.particles);
        for (let p = 0; p < frame.count; ++p) color.array.set(frame[dots] && dots !== "species" ? RAMP[frame[dots][p]] : SPECIES_COLOURS[frame.species[p] % SPECIES_COLOURS.length], 3 * p);
        this.dots.geometry.setDrawRange(0, frame.count);
        position.needsUpdate = color.needsUpdate = true;
    }

    /** The plane behind which nothing is drawn. @param toward  axis it moves along, such as "z" or "-x"; share 1: all is drawn */
    cut(toward, share) {
        const k = "xyz".indexOf(toward.at(-1)), sign = toward.startsWith("-") ? -1 : 1, [low, high] = this.box[k];
        const at = this.inScene(k, sign > 0 ? low + share * (high - low) : high - share * (high - low));
        const normal = new lib.Vector3().setComponent(k, -sign).applyQuaternion(this.scene.quaternion);
        this.renderer.clippingPlanes = share < 1 ? [new lib.Plane(normal, sign * at)] : [];
    }

    draw(camera) {
        const {clientWidth: width, clientHeight: height} = this.canvas, scale = window.devicePixelRatio || 1;
        if (this.width !== width || this.height !== height || this.scale !== scale) {
            Object.assign(this, {width, height, scale});
            this.renderer.setPixelRatio(scale);
            this.renderer.setSize(width, height, false);
        }
        camera.aspect = width / height;
        camera.updateProjectionMatrix();
        this.lamp.position.copy(camera.position).applyQuaternion(this.scene.quaternion.clone().invert());
        this.renderer.render(this.scene, camera);
    }
}
