// One camera for all pictures, so that runs side by side are seen from one place.

const VIEWS = [[-0.9, 1.15], [0, Math.PI / 2], [-Math.PI / 2, Math.PI / 2], [-Math.PI / 2, 0.01]];  // turn about z, tilt from it [rad]

class Camera extends lib.PerspectiveCamera {
    /** Drag turns, with shift or the right button shifts, the wheel zooms, as fingers do; `moved` is called after each. */
    constructor(place, moved) {
        super(58, 1, 0.05, 50);  // in the scene's unit
        this.up.set(0, 0, 1);
        this.controls = new lib.OrbitControls(this, place);
        Object.assign(this.controls, {minDistance: 0.3, maxDistance: 15});
        this.turn(0);
        this.controls.addEventListener("change", moved);
    }

    turn(view) {
        const [turn, tilt] = VIEWS[view], far = 1.6;
        this.position.set(Math.cos(turn) * Math.sin(tilt), Math.sin(turn) * Math.sin(tilt), Math.cos(tilt)).multiplyScalar(far);
        this.controls.target.set(0, 0, 0);
        this.controls.update();
    }
}
