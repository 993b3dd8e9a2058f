// The calls of ../../interface.json, which Python and C make too, and those that only JavaScript can write.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { test } from "node:test";

import { directional, load, point, spot } from "shading";

const LIGHTS = { directional, point, spot };
const shading = await load();
const { shade, toSrgb8, toSrgba8, fromSrgb8, heightField, implicit, meshNormals } = shading;
const path = process.env.INTERFACE ?? new URL("../../interface.json", import.meta.url);
// JSON has neither NaN nor infinity
const INTERFACE = JSON.parse(readFileSync(path, "utf8"), (_, value) => ({ nan: NaN, inf: Infinity })[value] ?? value);

const made = (light) => {
  const [[kind, given]] = Object.entries(light);
  return LIGHTS[kind](given);
};
const flat = (value) => Array.isArray(value) ? value.flat(2) : value;

function called({ change, leave_out: without, light, height_field: field, implicit: surface, mesh_normals: mesh }) {
  if (field) return heightField({ ...field, z: flat(field.z), columns: field.z[0].length });
  if (surface) {
    const { values, points } = surface;
    const [rows, columns] = [values[0].length, values[0][0].length];
    return implicit({ ...surface, values: flat(values), rows, columns, points: flat(points) });
  }
  if (mesh) return meshNormals({ ...mesh, vertices: flat(mesh.vertices), faces: flat(mesh.faces) });
  const { lights, ...rest } = { ...INTERFACE.base, ...change };
  const scene = Object.fromEntries(Object.entries(rest).map(([name, value]) => [name, flat(value)]));
  delete scene[without];
  return shade({ ...scene, lights: light ? [made(light)] : lights.map(made) });
}

for (const call of [...INTERFACE.calls, ...INTERFACE.normals]) {
  test(`as in the other languages: ${call.what}`, () => {
    if (call.value) {
      const expected = flat(call.value);
      called(call).forEach((x, i) => assert.ok(Math.abs(x - expected[i % expected.length]) <= 1e-7, `${x} at ${i}`));
      return;
    }
    const sentence = call.javascript ?? call.error;
    assert.throws(() => called(call), (error) => {
      assert.ok(error.message.includes(sentence), error.message);
      return error instanceof TypeError || error instanceof RangeError;
    });
  });
}

test("arguments are those of the other languages", () => {
  const camel = (name) => name.replace(/_(\w)/g, (_, letter) => letter.toUpperCase());
  const functions = { ...shading, ...LIGHTS };
  delete functions.memory;
  assert.deepEqual(Object.keys(functions).sort(), INTERFACE.functions.map(camel).sort());
  const types = readFileSync(new URL(import.meta.resolve("shading").replace("node.js", "index.d.ts")), "utf8");
  for (const [name, defaults] of Object.entries({ ...INTERFACE.lights, shade: INTERFACE.shade })) {
    const call = name === "shade" ? shade : LIGHTS[name];
    const names = Object.keys(defaults);
    // the error lists them all
    assert.throws(() => call({ k: 1 }), (error) => {
      const listed = error.message.split("only ")[1].split(", ");
      assert.deepEqual(listed.sort(), names.sort());
      return true;
    });
    for (const argument of names) assert.match(types, new RegExp(`\\b${argument}\\??:`), argument);
  }
});

const POINTS = { points: [0, 0, 0, 2, 0, 0], normals: [0, 0, 1, 0, 0, 1], eye: [0, 0, 5] };
const SUN = directional({ toward: [0, 0, 1] });
const shaded = (changes) => shade({ ...POINTS, lights: [SUN], k_d: 0.5, ...changes });

test("defaults are those of the other languages", () => {
  const written = (defaults, given) => ({ ...Object.fromEntries(Object.entries(defaults)
    .filter(([, value]) => value !== null && value !== "none")), ...given });
  const places = { toward: [1, 2, 3], position: [1, 2, 3], axis: [-1, -2, -3] };
  const needed = (defaults) => Object.fromEntries(Object.entries(places).filter(([name]) => name in defaults));
  for (const [kind, defaults] of Object.entries(INTERFACE.lights)) {
    assert.deepEqual(LIGHTS[kind](needed(defaults)), LIGHTS[kind](written(defaults, needed(defaults))));
  }
  const scene = { ...POINTS, lights: [point({ position: [1, 2, 3] })], k_a: 0.25, k_d: 0.5, k_s: 0.5 };
  assert.deepEqual(shade(scene), shade(written(INTERFACE.shade, scene)));
});

const transferred = () => {
  const array = new Float32Array(6);
  structuredClone(array.buffer, { transfer: [array.buffer] });
  return array;
};

const WRONG = {
  "k_d: expected linear numbers, usually from 0 to 1, got Uint8Array; fromSrgb8 decodes": () => shaded({ k_d: new Uint8Array(6) }),
  "k_d: expected linear numbers, usually from 0 to 1, got Uint8ClampedArray": () => shaded({ k_d: new Uint8ClampedArray(6) }),
  "points: expected an array of numbers, got [0,null,0]": () => shaded({ points: [0, , 0] }), // eslint-disable-line no-sparse-arrays
  "points: expected an array of numbers, got undefined": () => shaded({ points: undefined }),
  "points: expected an array of numbers, got \"0,0,0\"": () => shaded({ points: "0,0,0" }),
  "points: expected an array of numbers, got [[0,0,0]]": () => shaded({ points: [[0, 0, 0]] }),
  "normals: expected three numbers for each of 2 points, got 2": () => shaded({ normals: [0, 0] }),
  "points: expected three numbers for each point, got 2": () => shaded({ points: [0, 0] }),
  "shade: there is no kd, only points, normals": () => shaded({ kd: 1 }),
  "shade: there is no material, only": () => shaded({ material: { kd: 1 } }),
  "shade: expected an object with points, normals": () => shade(),
  "point: there is no colour, only position, intensity": () => point({ position: [0, 0, 1], colour: 1 }),
  "position: expected three finite numbers, got undefined": () => point({}),
  "point: expected an object with position, intensity": () => point(),
  "position: expected three finite numbers, got \"a,b\"": () => point({ position: "a,b" }),
  "position: expected three finite numbers, got \"abc\"": () => point({ position: "abc" }),
  "position: expected three finite numbers, got [\"0\",0,0]": () => point({ position: ["0", 0, 0] }),
  "lights: expected a light, made by directional, point or spot, or an array of lights, got null":
    () => shaded({ lights: null }),
  "lights: expected a light, made by directional, point or spot, or an array of lights, got undefined":
    () => shaded({ lights: undefined }),
  "lights[0]: expected a light, made by directional, point or spot, got {\"kind\":\"foo\"}":
    () => shaded({ lights: [{ kind: "foo" }] }),
  "lights[1]: expected a light, made by directional, point or spot, got 3": () => shaded({ lights: [SUN, 3] }),
  "lights[1].intensity: expected finite numbers of 0 or more, got (-1, 0, 0)": () => shaded({
    lights: [SUN, directional({ toward: [0, 0, 1], intensity: [-1, 0, 0] })],
  }),
  "range: expected a number, got \"far\"": () => point({ position: [0, 0, 1], range: "far" }),
  "eye: expected an array of numbers, got 0.5": () => shaded({ eye: 0.5 }),
  "eye: expected 3 or 6 numbers, got 2": () => shaded({ eye: [0, 5] }),
  "k_d: expected 1, 2, 3 or 6 numbers, got 4": () => shaded({ k_d: [1, 1, 1, 1] }),
  "m: expected 1 or 2 numbers, got 3": () => shaded({ m: [1, 1, 1] }),
  "visible: expected 2 numbers, for each light those of all points, got 3": () => shaded({ visible: [1, 1, 1] }),
  "parts: expected true or false, got 1": () => shaded({ parts: 1 }),
  "colors: expected linear light, where 1 is white": () => toSrgb8(new Uint8Array(3)),
  "texture: expected a Uint8Array or an ImageData, got [1,2,3]": () => fromSrgb8([1, 2, 3]),
  "columns: expected a whole number that divides 4, the number of heights, got 3": () => heightField({ z: [0, 0, 0, 0], columns: 3 }),
  "columns: expected a whole number that divides 4, the number of heights, got -4": () => heightField({
    z: [0, 0, 0, 0], columns: -4,
  }),
  "columns: expected a whole number that divides 4, the number of heights, got undefined": () => heightField({ z: [0, 0, 0, 0] }),
  "rows, columns: expected whole numbers whose product divides 8, the number of values, got 3 and 2": () => implicit({
    values: Array(8).fill(0), rows: 3, columns: 2, points: [],
  }),
  "rows, columns: expected whole numbers whose product divides 2, the number of values, got undefined": () => implicit({
    values: [0, 1], points: [],
  }),
  "faces: expected indices below 3, the number of vertices, got -1 at [0]": () => meshNormals({
    vertices: [0, 0, 0, 1, 0, 0, 0, 1, 0], faces: [0, 1, -1],
  }),
  "points: expected an array of numbers, got [\"0n\",\"0n\",\"0n\"]": () => shaded({ points: [0n, 0n, 0n] }),
  "points: expected an array of numbers, got [\"0n\",\"0n\"": () => shaded({ points: new BigInt64Array(6) }),
  "points: expected an array of numbers, got an array whose buffer was transferred": () => shaded({ points: transferred() }),
  "z: expected an array of numbers, got an array whose buffer was transferred": () => heightField({ z: transferred(), columns: 2 }),
  "points: expected an array of numbers, got ArrayBuffer": () => shaded({ points: new ArrayBuffer(24) }),
  "points: expected an array of numbers, got DataView": () => shaded({ points: new DataView(new ArrayBuffer(24)) }),
  "points: expected an array of numbers, got Map": () => shaded({ points: new Map() }),
  "normals: expected an array of numbers, got [null,null,null,null,null,1]": () => {
    const sparse = [];
    sparse[5] = 1;
    return shaded({ normals: sparse });
  },
  "m: expected a number or an array of numbers, got 32n": () => shaded({ m: 32n }),
  "k_d: expected a number or an array of numbers, got Symbol(red)": () => shaded({ k_d: Symbol("red") }),
  "k_d: expected a number or an array of numbers, got null": () => shaded({ k_d: null }),
  "k_d: expected a number or an array of numbers, got an object": () => {
    const cycle = {};
    cycle.self = cycle;
    return shaded({ k_d: cycle });
  },
  "k_d: expected a number or an array of numbers, got Number": () => shaded({ k_d: new Number(0.5) }),
  "k_d: expected linear numbers, usually from 0 to 1, got whole numbers up to 176; fromSrgb8": () => shaded({ k_d: [176, 112, 62] }),
  "k_s: expected linear numbers, usually from 0 to 1, got whole numbers up to 255; fromSrgb8": () => shaded({
    k_s: Int32Array.of(176, 112, 62, 0, 255, 1),
  }),
  "intensity: expected linear light, usually of an image's bytes by fromSrgb8, got [255,240,200]": () => directional({
    toward: [0, 0, 1], intensity: Uint8Array.of(255, 240, 200),
  }),
  "point: there is no intesity, only": () => shaded({ lights: [SUN, { kind: "point", position: [0, 0, 1], intesity: 1 }] }),
  "position: expected three finite numbers, got [\"0n\",0,1]": () => point({ position: [0n, 0, 1] }),
  "toward: expected three finite numbers, got [0,\"NaN\",1]": () => directional({ toward: [0, NaN, 1] }),
  "lights[1]: expected a light, made by directional, point or spot, got undefined": () => shaded({
    lights: [SUN, , SUN], // eslint-disable-line no-sparse-arrays
  }),
  "lights[0]: expected a light, made by directional, point or spot, got [{\"kind\"": () => shaded({ lights: [[SUN]] }),
  "lights: expected a light, made by directional, point or spot, or an array of lights, got Generator": () => shaded({
    lights: (function* () { yield SUN; })(),
  }),
  "visible: expected an array of fractions from 0 to 1, got [\"yes\",\"no\"]": () => shaded({ visible: ["yes", "no"] }),
  "visible: expected an array of fractions from 0 to 1, got [\"1n\",\"0n\"]": () => shaded({ visible: [1n, 0n] }),
  "visible: expected fractions from 0 to 1, got 255 at [0]": () => shaded({ visible: Uint8Array.of(255, 0) }),
  "columns: expected a whole number that divides 4, the number of heights, got 2n": () => heightField({ z: [0, 0, 0, 0], columns: 2n }),
  "dx: expected a finite number that is not 0, got 0": () => heightField({ z: [0, 0, 0, 0], columns: 2, dx: 1e-300 }),
  "rows, columns: expected whole numbers whose product divides 8, the number of values, got 2n and 2": () => implicit({
    values: Array(8).fill(0), rows: 2n, columns: 2, points: [],
  }),
  "faces: expected three numbers for each triangle, got 4": () => meshNormals({ vertices: Array(9).fill(0), faces: [0, 1, 2, 0] }),
  "faces: expected indices below 3, the number of vertices, got 4294967296": () => meshNormals({
    vertices: Array(9).fill(0), faces: [0, 1, 4294967296],
  }),
  "colors: expected linear light, where 1 is white, got [0,128,255]": () => toSrgb8(Int32Array.of(0, 128, 255)),
  "colors: expected an array of numbers, got {\"ambient\"": () => toSrgb8(shaded({ parts: true })),
  "texture: expected three numbers for each texel, got 8": () => fromSrgb8(new Uint8ClampedArray(8)),
  "the module's memory has no room for 536870912 more numbers": () => heightField({ z: new Float32Array(1 << 29), columns: 1 << 29 }),
};

for (const [sentence, call] of Object.entries(WRONG)) {
  test(`what only JavaScript can write: ${sentence}`, () => {
    assert.throws(call, (error) => {
      assert.ok(error.message.includes(sentence), error.message);
      return error instanceof TypeError || error instanceof RangeError;
    });
  });
}

test("an error has the index of the light or the point", () => {
  const dark = directional({ toward: [0, 0, 1], intensity: -1 });
  assert.throws(() => shaded({ lights: [SUN, SUN, dark] }), { name: "RangeError", light: 2 });
  assert.throws(() => shaded({ points: [0, 0, 0, 0, 0, NaN] }), { name: "RangeError", index: 1 });
});

test("one light needs no list", () => assert.deepEqual(shaded({ lights: SUN }), shaded({ lights: [SUN] })));

test("arrays of any kind have the right value", () => {
  const expected = shaded({ points: [1, 0, 0, 2, 0, 0], k_s: 0.5, m: 8 });
  for (const Kind of [Float64Array, Int16Array, Uint32Array, Uint8Array, Int8Array]) {
    assert.deepEqual(shaded({ points: Kind.of(1, 0, 0, 2, 0, 0), normals: Kind.of(0, 0, 1, 0, 0, 1), k_s: 0.5, m: 8 }), expected);
  }
  const shared = new Float32Array(new SharedArrayBuffer(24));
  shared.set([1, 0, 0, 2, 0, 0]);
  const proxy = new Proxy([1, -0, 0, 2, -0, 0], {});
  for (const points of [shared, proxy]) assert.deepEqual(shaded({ points, k_s: 0.5, m: 8 }), expected);
  assert.deepEqual([...shaded({ k_d: Uint32Array.of(0, 1, 2, 3, 4, 5) })], [0, 1, 2, 3, 4, 5]);
  assert.deepEqual(shaded({ m: Uint16Array.of(8, 8), points: [1, 0, 0, 2, 0, 0], k_s: 0.5 }), expected);
  assert.deepEqual([...shaded({ visible: [true, false] })], [0.5, 0.5, 0.5, 0, 0, 0]);
});

test("an error in a getter is the caller's", () => {
  const scene = { ...POINTS, k_d: 0.5, get lights() { throw new Error("from the getter"); } };
  assert.throws(() => shade(scene), /^Error: from the getter$/);
});

test("the source of the module is named", async () => {
  for (const source of [3, null, {}]) await assert.rejects(load(source), /source: expected a URL, the bytes/);
});

test("the alpha of an image is left out", () => {
  const image = { data: Uint8ClampedArray.of(1, 2, 3, 9, 4, 5, 6, 9, 7, 8, 10, 9), width: 3, height: 1 };
  assert.deepEqual(fromSrgb8(image), fromSrgb8(Uint8Array.of(1, 2, 3, 4, 5, 6, 7, 8, 10)));
});

test("a gray texture has a number for each point", () => {
  assert.deepEqual([...shaded({ k_d: new Float32Array([0.5, 1]) })], [0.5, 0.5, 0.5, 1, 1, 1]);
});

test("the parts add up", () => {
  const scene = { k_a: 0.25, k_s: 0.5, m: [4, 8.5], parts: true };
  const { ambient, diffuse, specular } = shaded(scene);
  const total = shaded({ ...scene, parts: false });
  assert.deepEqual(total, total.map((_, i) => Math.fround(Math.fround(ambient[i] + diffuse[i]) + specular[i])));
  assert.ok(ambient[0] === 0.25 && diffuse[0] === 0.5 && specular[0] === 0.5);
});

test("alpha is opaque, and bytes come back", () => {
  const every = Uint8Array.from({ length: 768 }, (_, i) => i / 3);
  const colors = fromSrgb8(every);
  assert.deepEqual([...toSrgb8(colors)], [...every]);
  assert.deepEqual([...toSrgba8(colors)].filter((_, i) => i % 4 === 3), Array(256).fill(255));
  assert.deepEqual([...toSrgba8(colors)].filter((_, i) => i % 4 !== 3), [...every]);
});

test("a crease keeps edges", () => {
  // two triangles that meet in a right angle, in the edge from (0, 0, 0) to (0, 1, 0)
  const mesh = { vertices: [0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1], faces: [0, 2, 1, 0, 1, 3] };
  const flat = meshNormals({ ...mesh, crease: 1.5 });
  assert.deepEqual([...flat], [...Array(3).fill([0, 0, 1]).flat(), ...Array(3).fill([1, 0, 0]).flat()]);
  const smooth = meshNormals({ ...mesh, crease: 1.6 }).slice(0, 3);
  smooth.forEach((x, i) => assert.ok(Math.abs(x - [Math.SQRT1_2, 0, Math.SQRT1_2][i]) < 1e-6));
});

test("require has the same functions", async () => {
  const common = createRequire(import.meta.url)("shading");
  assert.deepEqual(Object.keys(common).sort(), ["directional", "load", "point", "spot"]);
  const module = await common.load();
  assert.deepEqual(module.shade({ ...POINTS, lights: common.directional({ toward: [0, 0, 1] }), k_d: 0.5 }), shaded({}));
});
