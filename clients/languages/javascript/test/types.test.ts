// Compiled only: what the types allow, and what they refuse.
import { directional, load, point, spot, type Light, type Scene } from "shading";

const lights: Light[] = [
  directional({ toward: [0, 0, 1], intensity: 0.5 }),
  point({ position: [0, 0, 2], intensity: [1, 0.5, 0], attenuation: [0, 0, 1], range: 8 }),
  spot({ position: [0, 0, 2], axis: [0, 0, -1], outer: 0.5 }),
];
const scene: Scene = { points: new Float32Array(3), normals: [0, 0, 1], eye: [0, 0, 5], lights, k_d: 1, m: 32 };
const { shade, toSrgb8, toSrgba8, fromSrgb8, heightField, implicit, meshNormals } = await load("shading.wasm");
const colors: Float32Array = shade({ ...scene, parts: false });
const specular: Float32Array = shade({ ...scene, lights: lights[0], k_d: new Float32Array(3), parts: true }).specular;
const image = new ImageData(toSrgba8(colors), 1);
const bytes: Uint8ClampedArray = toSrgb8(specular);
const texture: Float32Array = fromSrgb8(bytes);
heightField({ z: texture, columns: 1 });
implicit({ values: texture, rows: 1, columns: 1, points: [0, 0, 0], dz: 2 });
meshNormals({ vertices: [0, 0, 0], faces: new Uint16Array(3), crease: 0.5 });

// @ts-expect-error there is no such model
shade({ ...scene, model: "gouraud", parts: false });
// @ts-expect-error a spot has an axis
spot({ position: [0, 0, 2] });
// @ts-expect-error a position has three coordinates
point({ position: [0, 2] });
// @ts-expect-error it is k_d
shade({ ...scene, kd: 1, parts: false });
export { image };
