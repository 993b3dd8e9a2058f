// Lambert, Phong and Blinn-Phong shading of many points, in WebAssembly. index.d.ts explains the functions.
// What is wrong with a number, the module says; here is only what is wrong with the types of JavaScript.

const MODELS = ["lambert", "phong", "blinn-phong"];
const KINDS = ["directional", "point", "spot"];
const WORDS = 20; // of `shading_light` in ../shading.h
const NONE = 0xFFFFFFFF; // no light, no index

const LAMP = { position: undefined, intensity: 1, attenuation: [1, 0, 0], range: Infinity, gltf: false };
const LIGHTS = {
  directional: { toward: undefined, intensity: 1 },
  point: LAMP,
  spot: { ...LAMP, axis: undefined, inner: 0, outer: Math.PI / 4 },
};
const SCENE = { points: undefined, normals: undefined, eye: undefined, lights: undefined, k_a: undefined, k_d: undefined,
  k_s: undefined, m: 1, ambient: 1, model: "blinn-phong", visible: undefined, parts: false };

const isDetached = (view) => {
  try {
    return !new Uint8Array(view.buffer, 0, 0);
  } catch {
    return true;
  }
};

/** The value as it is written in a message. */
function shown(value) {
  if (["undefined", "number", "function", "symbol"].includes(typeof value)) return String(value);
  if (typeof value === "bigint") return `${value}n`;
  try {
    const isView = ArrayBuffer.isView(value) && !(value instanceof DataView);
    if (isView && isDetached(value)) return "an array whose buffer was transferred";
    const type = Object.prototype.toString.call(value).slice(8, -1);
    if (typeof value === "object" && !isView && !["Array", "Object", "Null"].includes(type)) return type;
    const text = JSON.stringify(isView || Array.isArray(value) ? Array.from(value.slice(0, 80)) : value, (_, inner) =>
      typeof inner === "bigint" || (typeof inner === "number" && !Number.isFinite(inner)) ? shown(inner) : inner);
    return text.length > 80 ? `${text.slice(0, 77)}...` : text;
  } catch { // it refers to itself, or throws when it is read
    return "an object";
  }
}

const wrong = (name, expected, got) => new TypeError(`${name}: expected ${expected}, got ${shown(got)}`);

/** The options with the defaults of those that are left out. */
function options(name, defaults, given) {
  if (typeof given !== "object" || given === null) throw wrong(name, `an object with ${Object.keys(defaults).join(", ")}`, given);
  for (const key of Object.keys(given)) {
    if (!(key in defaults)) {
      throw new TypeError(`${name}: there is no ${key}, only ${Object.keys(defaults).join(", ")}`);
    }
  }
  const set = Object.entries(given).filter(([, value]) => value !== undefined);
  return { ...defaults, ...Object.fromEntries(set) };
}

/** Words that are written as they are. Other arrays become floats. */
class Raw extends Uint32Array {}

const isArray = (value) => Array.isArray(value) || (ArrayBuffer.isView(value) && !(value instanceof DataView));
const isNumber = (value) => typeof value === "number";
const isCount = (value) => Number.isInteger(value) && value >= 0;

/** Every element is a number, also where an array has holes. */
function areNumbers(value) {
  if (ArrayBuffer.isView(value)) return !(value instanceof BigInt64Array || value instanceof BigUint64Array || isDetached(value));
  for (let i = 0; i < value.length; i++) if (!isNumber(value[i])) return false;
  return true;
}

function triple(name, value) {
  if (!isArray(value) || value.length !== 3 || !areNumbers(value)) throw wrong(name, "three finite numbers", value);
  return [...value];
}

/** One number is gray. */
function color(name, value) {
  if (isBytes(value)) throw wrong(name, "linear light, usually of an image's bytes by fromSrgb8", value);
  return triple(name, isNumber(value) ? [value, value, value] : value);
}

function number(name, value) {
  if (!isNumber(value)) throw wrong(name, "a number", value);
  return value;
}

function boolean(name, value) {
  if (typeof value !== "boolean") throw wrong(name, "true or false", value);
  return value;
}

/** A light, whose numbers `shade` judges. */
function light(kind, given) {
  const set = options(kind, LIGHTS[kind], given);
  const made = { kind };
  for (const [name, value] of Object.entries(set)) {
    if (name === "gltf") made[name] = boolean(name, value);
    else if (name === "intensity") made[name] = color(name, value);
    else if (isNumber(LIGHTS[kind][name])) made[name] = number(name, value);
    else made[name] = triple(name, value);
    const isFinite = !Array.isArray(made[name]) || made[name].every(Number.isFinite);
    if (!isFinite) throw wrong(name, name === "intensity" ? "finite numbers of 0 or more" : "three finite numbers", value);
  }
  return Object.freeze(made);
}

export const directional = (given) => light("directional", given);
export const point = (given) => light("point", given);
export const spot = (given) => light("spot", given);

/** The words of `shading_light`. */
function packed(given, index) {
  const kind = KINDS.indexOf(given?.kind);
  if (kind < 0) throw wrong(`lights[${index}]`, "a light, made by directional, point or spot", given);
  const { kind: _, ...numbers } = given;
  const nowhere = [0, 0, 0];
  const { position = nowhere, toward = nowhere, axis = nowhere, intensity, attenuation = nowhere, range = 1, inner = 0,
    outer = 0, gltf = false } = light(given.kind, numbers);
  const words = new Float32Array([0, ...position, ...toward, ...axis, ...intensity, ...attenuation, range, inner, outer, 0]);
  const whole = new Uint32Array(words.buffer);
  whole[0] = kind;
  whole[WORDS - 1] = gltf ? 1 : 0;
  return whole;
}

function listed(lights) {
  if (typeof lights?.kind === "string") return [lights];
  if (!Array.isArray(lights)) {
    throw wrong("lights", "a light, made by directional, point or spot, or an array of lights", lights);
  }
  return lights;
}

/** Three numbers for each point, or whatever else the array describes. */
function triples(name, value, count, what = "point") {
  if (!isArray(value) || !areNumbers(value)) throw wrong(name, "an array of numbers", value);
  if (value.length % 3 || (count !== undefined && value.length !== 3 * count)) {
    const expected = count === undefined ? `three numbers for each ${what}` : `three numbers for each of ${count} points`;
    throw new RangeError(`${name}: expected ${expected}, got ${value.length}`);
  }
  return value;
}

const isBytes = (value) => [Uint8Array, Uint8ClampedArray, Uint16Array].some((type) => value instanceof type);
const isInteger = (value) => isBytes(value) || [Int8Array, Int16Array, Int32Array, Uint32Array].some((type) => value instanceof type);

/** Numbers, true or false; a hole becomes NaN, which the module refuses. */
const areFractions = (value) => Array.isArray(value)
  ? value.every((x) => isNumber(x) || typeof x === "boolean")
  : isArray(value) && areNumbers(value);

/** One value for all points, or an array with one for each. A color may be one number, and a texture may be gray. */
function each(name, value, count, width, isColor = width === 3) {
  if (isColor && isBytes(value)) {
    throw new TypeError(`${name}: expected linear numbers, usually from 0 to 1, got ${value.constructor.name}; `
      + "fromSrgb8 decodes an image's bytes");
  }
  if (isNumber(value) && (isColor || width === 1)) return { one: Array(width).fill(value) };
  if (!isArray(value) || !areNumbers(value)) throw wrong(name, isColor || width === 1 ? "a number or an array of numbers" : "an array of numbers", value);
  if (value.length === width) return { one: [...value] };
  if (value.length === width * count) return { all: value };
  if (isColor && value.length === count) {
    const all = new Float32Array(3 * count);
    for (let i = 0; i < all.length; i++) all[i] = value[Math.floor(i / 3)];
    return { all };
  }
  const lengths = new Set([width, width * count, ...(isColor ? [1, count] : [])]);
  const [most, ...others] = [...lengths].sort((a, b) => b - a);
  throw new RangeError(`${name}: expected ${others.reverse().join(", ")} or ${most} numbers, got ${value.length}`);
}

/** The colors of an ImageData, or what else was given. */
function withoutAlpha(given) {
  const { data, width, height } = given ?? {};
  const isImage = data instanceof Uint8ClampedArray && data.length === 4 * width * height;
  return isImage ? data.filter((_, i) => i % 4 !== 3) : given;
}

/** The functions of the compiled module. */
export async function instance(module) {
  const wasm = (await WebAssembly.instantiate(module)).exports;
  const { memory } = wasm;

  /** Calls `use` with the addresses of the arrays and of room for the output, and frees all of it. */
  function call(inputs, words, use) {
    const sizes = [...inputs.map((input) => input.length), words];
    const rooms = [];
    try {
      for (const size of sizes) { // first all, since each may move the memory
        const room = size < 2 ** 30 && wasm.shading_room(size) >>> 0;
        if (!room) throw new RangeError(`the module's memory has no room for ${size} more numbers; pass the points in several calls`);
        rooms.push(room);
      }
      inputs.forEach((input, i) => {
        const Words = input instanceof Raw ? Uint32Array : Float32Array;
        new Words(memory.buffer, rooms[i], input.length).set(input);
      });
      return use(...rooms);
    } finally {
      rooms.forEach((room, i) => wasm.shading_free(room, sizes[i]));
    }
  }

  const ERROR = 3 + 256 / 4; // the words of `shading_error`

  /** Throws what the module says in the error that it has written. */
  function refuse(error) {
    const bytes = new Uint8Array(memory.buffer, error + 12, 256);
    const text = new TextDecoder().decode(bytes.slice(0, bytes.indexOf(0))).replace("from_srgb8", "fromSrgb8");
    const [light, index] = new Uint32Array(memory.buffer, error + 4, 2);
    throw Object.assign(new RangeError(text), light === NONE ? {} : { light }, index === NONE ? {} : { index });
  }

  function shade(given) {
    const scene = options("shade", SCENE, given);
    const model = MODELS.indexOf(scene.model);
    if (model < 0) throw new RangeError(`model: expected "lambert", "phong" or "blinn-phong", got ${shown(scene.model)}`);
    const parts = boolean("parts", scene.parts);
    const points = triples("points", scene.points);
    const count = points.length / 3;
    const normals = triples("normals", scene.normals, count);
    if ([scene.k_a, scene.k_d, scene.k_s].every((k) => k === undefined)) {
      throw new TypeError("k_d: expected a reflectance, such as 0.6, in k_d, k_a or k_s, got none");
    }
    const lights = Array.from(listed(scene.lights), packed); // holes, too
    const values = {
      eye: each("eye", scene.eye, count, 3, false),
      k_a: each("k_a", scene.k_a === undefined ? 0 : scene.k_a, count, 3),
      k_d: each("k_d", scene.k_d === undefined ? 0 : scene.k_d, count, 3),
      k_s: each("k_s", scene.k_s === undefined ? 0 : scene.k_s, count, 3),
      m: each("m", scene.m, count, 1),
      ambient: each("ambient", scene.ambient, count, 3),
    };
    let visible = [];
    if (scene.visible !== undefined) {
      if (!areFractions(scene.visible)) throw wrong("visible", "an array of fractions from 0 to 1", scene.visible);
      visible = Float32Array.from(scene.visible, Number);
      if (visible.length === lights.length) { // the same for all points
        const fractions = visible;
        visible = new Float32Array(lights.length * count).map((_, i) => fractions[Math.floor(i / count)]);
      }
      if (visible.length !== lights.length * count) {
        const expected = `${lights.length * count} numbers, for each light those of all points`;
        throw new RangeError(`visible: expected ${expected}, got ${visible.length}`);
      }
    }
    const one = (name) => values[name].one ?? (name === "m" ? [0] : [0, 0, 0]);
    const numbers = new Float32Array(["eye", "ambient", "k_a", "k_d", "k_s", "m"].flatMap(one));
    const arrays = ["eye", "k_a", "k_d", "k_s", "m", "ambient"].map((name) => values[name].all ?? []);
    const allLights = new Raw(WORDS * lights.length);
    lights.forEach((words, i) => allLights.set(words, WORDS * i));
    const size = points.length * (parts ? 3 : 1);
    const inputs = [points, normals, allLights, visible, ...arrays];
    return call(inputs, size + ERROR + SCENE_WORDS, (p, n, l, seen, ...rest) => {
      const out = rest.pop();
      const [error, at] = [out + 4 * size, out + 4 * (size + ERROR)];
      const whole = new Uint32Array(memory.buffer, at, SCENE_WORDS);
      whole.set([model, parts ? 1 : 0, count, p, n]);
      whole.set(new Uint32Array(numbers.buffer), 5);
      const pointers = rest.map((room, i) => arrays[i].length ? room : 0);
      whole.set([l, lights.length, ...pointers, visible.length ? seen : 0], 21);
      if (wasm.shading_shade(at, out, error)) refuse(error);
      const colors = new Float32Array(memory.buffer, out, size).slice();
      if (!parts) return colors;
      const [ambient, diffuse, specular] = [0, 1, 2].map((i) => colors.slice(i * points.length, (i + 1) * points.length));
      return { ambient, diffuse, specular };
    });
  }

  function encoded(colors, width, encode) {
    triples("colors", colors, undefined, "color");
    if (isInteger(colors)) throw wrong("colors", "linear light, where 1 is white", colors);
    const size = width * colors.length / 3;
    return call([colors], Math.ceil(size / 4), (from, out) => {
      encode(colors.length / 3, from, out);
      return new Uint8ClampedArray(memory.buffer, out, size).slice();
    });
  }

  function fromSrgb8(given) {
    const texture = withoutAlpha(given);
    if (!(texture instanceof Uint8Array || texture instanceof Uint8ClampedArray)) {
      throw wrong("texture", "a Uint8Array or an ImageData", given);
    }
    triples("texture", texture, undefined, "texel");
    const words = new Raw(Math.ceil(texture.length / 4));
    new Uint8Array(words.buffer).set(texture);
    return call([words], texture.length, (from, out) => {
      wasm.shading_from_srgb8(texture.length / 3, from, out);
      return new Float32Array(memory.buffer, out, texture.length).slice();
    });
  }

  function heightField(given) {
    const { z, columns, dx, dy } = options("heightField", { z: undefined, columns: undefined, dx: 1, dy: 1 }, given);
    if (!isArray(z) || !areNumbers(z)) throw wrong("z", "an array of numbers", z);
    const rows = isCount(columns) ? z.length / columns : NaN;
    if (!isCount(rows)) {
      const expected = `a whole number that divides ${z.length}, the number of heights`;
      throw new RangeError(`columns: expected ${expected}, got ${shown(columns)}`);
    }
    return call([z], 3 * z.length + ERROR, (heights, out) => {
      const error = out + 12 * z.length;
      if (wasm.shading_height_field(rows, columns, heights, number("dx", dx), number("dy", dy), out, error)) refuse(error);
      return new Float32Array(memory.buffer, out, 3 * z.length).slice();
    });
  }

  function implicit(given) {
    const defaults = { values: undefined, rows: undefined, columns: undefined, points: undefined, dx: 1, dy: 1, dz: 1 };
    const { values, rows, columns, points, dx, dy, dz } = options("implicit", defaults, given);
    if (!isArray(values) || !areNumbers(values)) throw wrong("values", "an array of numbers", values);
    triples("points", points);
    const layers = isCount(rows) && isCount(columns) ? values.length / (rows * columns) : NaN;
    if (!isCount(layers)) {
      const expected = `whole numbers whose product divides ${values.length}, the number of values`;
      throw new RangeError(`rows, columns: expected ${expected}, got ${shown(rows)} and ${shown(columns)}`);
    }
    const steps = Object.entries({ dx, dy, dz }).map(([name, step]) => number(name, step));
    const size = points.length;
    return call([values, points], size + ERROR, (v, p, out) => {
      const error = out + 4 * size;
      if (wasm.shading_implicit(layers, rows, columns, v, ...steps, size / 3, p, out, error)) refuse(error);
      return new Float32Array(memory.buffer, out, size).slice();
    });
  }

  function meshNormals(given) {
    const { vertices, faces, crease } = options("meshNormals", { vertices: undefined, faces: undefined, crease: undefined }, given);
    triples("vertices", vertices, undefined, "vertex");
    const indices = Raw.from(triples("faces", faces, undefined, "triangle"));
    const count = vertices.length / 3;
    for (let i = 0; i < faces.length; i++) {
      if (indices[i] !== faces[i] || indices[i] >= count) {
        const expected = `indices below ${count}, the number of vertices`;
        throw new RangeError(`faces: expected ${expected}, got ${faces[i]} at [${Math.floor(i / 3)}]`);
      }
    }
    if (crease !== undefined && !(number("crease", crease) >= 0)) {
      throw new RangeError(`crease: expected 0 <= crease <= pi, in radians (a degree is pi/180), got ${crease}`);
    }
    const size = crease === undefined ? vertices.length : 3 * faces.length;
    return call([vertices, indices], size + ERROR, (v, f, out) => {
      const error = out + 4 * size;
      const code = wasm.shading_mesh_normals(count, v, faces.length / 3, f, crease ?? -1, out, error);
      if (code) refuse(error);
      return new Float32Array(memory.buffer, out, size).slice();
    });
  }

  const toSrgb8 = (colors) => encoded(colors, 3, wasm.shading_to_srgb8);
  const toSrgba8 = (colors) => encoded(colors, 4, wasm.shading_to_srgba8);
  return { shade, toSrgb8, toSrgba8, fromSrgb8, heightField, implicit, meshNormals, memory };
}

/** The words of `shading_scene`, whose pointers have 4 bytes here. */
const SCENE_WORDS = 30;
