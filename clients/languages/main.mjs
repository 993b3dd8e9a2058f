// Shades a dome from JavaScript, by WebAssembly, and writes the colors as floats: node main.mjs MODULE FILE.
import { readFileSync, writeFileSync } from "node:fs";
import { argv } from "node:process";

const BLINN_PHONG = 2;
const [DIRECTIONAL, POINT, SPOT] = [0, 1, 2];
const SIDE = 64;

const { instance } = await WebAssembly.instantiate(readFileSync(argv[2]));
const { memory, shading_room, shading_shade } = instance.exports;

/** Copies numbers into the module's memory, and returns their address there. */
function place(numbers) {
  const address = shading_room(numbers.length);
  new Float32Array(memory.buffer, address, numbers.length).set(numbers);
  return address;
}

/** The 17 words of a light. */
function light(kind, { position = [0, 0, 0], direction = [0, 0, 0], intensity, attenuation = [1, 0, 0],
  range = Infinity, inner = 0, outer = 0, unsquared = 0 }) {
  const words = new Float32Array([0, ...position, ...direction, ...intensity, ...attenuation, range, inner, outer, 0]);
  const integers = new Uint32Array(words.buffer);
  [integers[0], integers[16]] = [kind, unsquared];
  return words;
}

const lights = [
  light(DIRECTIONAL, { direction: [-1, 2, 2], intensity: [0.25, 0.25, 0.375] }),
  light(POINT, { position: [2, 1, 2], intensity: [1, 0.75, 0.5], attenuation: [1, 0, 0.25] }),
  light(SPOT, { position: [0, 3, 3], direction: [0, -1, -1], intensity: [3, 1, 1], attenuation: [1, 0.5, 0], range: 8,
    inner: 0.25, outer: 0.375 }),
];
const material = [0.125, 0.125, 0.125, 0.5, 0.375, 0.25, 0.5, 0.5, 0.5, 32]; // k_a, k_d, k_s, m
const places = Array.from({ length: SIDE * SIDE }, (_, i) => [(i % SIDE - 32) / 32, (32 - Math.floor(i / SIDE)) / 32]);
const points = places.flatMap(([x, y]) => [x, y, 1 - x * x - y * y]);
const normals = places.flatMap(([x, y]) => [2 * x, 2 * y, 1]);

const inputs = [points, normals, [0, 0, 5], material, [0.5, 0.5, 0.5]].map(place);
const packed = place(lights.flatMap((light) => [...light]));
const out = shading_room(points.length);
const status = shading_shade(BLINN_PHONG, places.length, ...inputs, packed, lights.length, out);
if (status) throw new Error(`shading_shade: status ${status}`);
writeFileSync(argv[3], new Float32Array(memory.buffer, out, points.length));
