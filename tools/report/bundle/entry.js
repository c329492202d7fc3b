// What the page uses of its libraries: esbuild leaves out the rest. The page's scripts call it `lib`.

export {
    BufferAttribute,
    BufferGeometry,
    ColorManagement,
    DirectionalLight,
    DoubleSide,
    HemisphereLight,
    LinearSRGBColorSpace,
    Mesh,
    MeshLambertMaterial,
    PerspectiveCamera,
    Plane,
    Points,
    PointsMaterial,
    Scene,
    Vector3,
    WebGLRenderer,
} from "three";
export { OrbitControls } from "three/addons/controls/OrbitControls.js";
export { default as uPlot } from "uplot";
import "uplot/dist/uPlot.min.css";
