// Shades a dome from JavaScript, by WebAssembly, and writes the colors as floats: node main.mjs FILE.
import { writeFileSync } from "node:fs";
import { argv } from "node:process";

import { directional, load, point, spot } from "shading";

const SIDE = 64;

const lights = [
  directional({ toward: [-1, 2, 2], intensity: [0.25, 0.25, 0.375] }),
  point({ position: [2, 1, 2], intensity: [1, 0.75, 0.5], attenuation: [1, 0, 0.25] }),
  spot({ position: [0, 3, 3], axis: [0, -1, -1], intensity: [3, 1, 1], attenuation: [1, 0.5, 0], range: 8,
    inner: 0.25, outer: 0.375 }),
];
const places = Array.from({ length: SIDE * SIDE }, (_, i) => [(i % SIDE - 32) / 32, (32 - Math.floor(i / SIDE)) / 32]);
const points = places.flatMap(([x, y]) => [x, y, 1 - x * x - y * y]);
const normals = places.flatMap(([x, y]) => [2 * x, 2 * y, 1]);

const { shade } = await load();
writeFileSync(argv[2], shade({
  points, normals, eye: [0, 0, 5], lights, k_a: 0.125, k_d: [0.5, 0.375, 0.25], k_s: 0.5, m: 32, ambient: 0.5,
}));
