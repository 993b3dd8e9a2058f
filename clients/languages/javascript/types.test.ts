// Compiled only: what the types allow, and what they refuse.
import { directional, load, point, spot, type Light, type Scene } from "shading";

const lights: Light[] = [
  directional({ toward: [0, 0, 1], intensity: 0.5 }),
  point({ position: [0, 0, 2], intensity: [1, 0.5, 0], attenuation: [0, 0, 1], range: 8 }),
  spot({ position: [0, 0, 2], axis: [0, 0, -1], outer: 0.5 }),
];
const scene: Scene = { points: new Float32Array(3), normals: [0, 0, 1], eye: [0, 0, 5], lights, material: { kd: 1, m: 32 } };
const { shade, toSrgb8 } = await load("shading.wasm");
const bytes: Uint8Array = toSrgb8(shade(scene));

// @ts-expect-error there is no such model
shade({ ...scene, model: "gouraud" });
// @ts-expect-error a spot has an axis
spot({ position: [0, 0, 2] });
// @ts-expect-error a position has three coordinates
point({ position: [0, 2] });
export { bytes };
