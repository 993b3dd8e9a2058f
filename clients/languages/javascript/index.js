// Lambert, Phong and Blinn-Phong shading of many points, in WebAssembly. index.d.ts explains the functions.

const MODELS = ["lambert", "phong", "blinn-phong"];
const KINDS = ["directional", "point", "spot"];
const [MATERIAL, LIGHT] = [6, 7]; // of the status in ../shading.h
const MATERIAL_RULE = "ka, kd, ks and ambient must be finite and 0 or more, and m must be 0 or more";
const LIGHT_RULE = "its intensity and attenuation must be finite and 0 or more, and not all of the attenuation 0; its direction " +
  "must not be 0, its range above 0, and 0 <= inner <= outer <= pi";

export const directional = ({ toward, intensity = 1 }) => ({ kind: "directional", direction: toward, intensity });

export const point = ({ position, intensity = 1, attenuation = [1, 0, 0], range = Infinity, gltf = false }) =>
  ({ kind: "point", position, intensity, attenuation, range, gltf });

export const spot = ({ axis, inner = 0, outer = Math.PI / 4, ...lamp }) =>
  ({ ...point(lamp), kind: "spot", direction: axis, inner, outer });

function triple(name, value) {
  if (value?.length !== 3) throw new TypeError(`${name}: expected three numbers, got ${JSON.stringify(value)}`);
  return [...value];
}

/** One number is gray. */
const color = (name, value) => triple(name, typeof value === "number" ? [value, value, value] : value);

/** The 17 words of `shading_light`. */
function packed(light, index) {
  const kind = KINDS.indexOf(light?.kind);
  if (kind < 0) throw new TypeError(`lights[${index}]: expected a light, made by directional, point or spot`);
  const { position = [0, 0, 0], direction = [0, 0, 0], intensity, attenuation = [1, 0, 0], range = Infinity, inner = 0,
    outer = 0, gltf = false } = light;
  const name = `lights[${index}]`;
  const words = new Float32Array([0, ...triple(`${name}.position`, position), ...triple(`${name}.direction`, direction),
    ...color(`${name}.intensity`, intensity), ...triple(`${name}.attenuation`, attenuation), range, inner, outer, 0]);
  new Uint32Array(words.buffer)[0] = kind;
  new Uint32Array(words.buffer)[16] = gltf ? 1 : 0;
  return words;
}

async function bytes(source) {
  if (!(source instanceof URL || typeof source === "string")) return source;
  const url = new URL(source, import.meta.url);
  if (url.protocol === "file:") return (await import("node:fs/promises")).readFile(url);
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url}: ${response.status}`);
  return response.arrayBuffer();
}

export async function load(source = new URL("shading.wasm", import.meta.url)) {
  const module = source instanceof WebAssembly.Module ? source : await WebAssembly.compile(await bytes(source));
  const { memory, shading_room, shading_free, shading_shade, shading_to_srgb8 } =
    (await WebAssembly.instantiate(module)).exports;

  /** Calls `use` with the addresses of the arrays and of room for the output, and frees all of it. */
  function call(inputs, floats, use) {
    const sizes = [...inputs.map((input) => input.length), floats];
    const rooms = sizes.map((size) => shading_room(size)); // first all, since each may move the memory
    try {
      inputs.forEach((input, i) => new Float32Array(memory.buffer, rooms[i], input.length).set(input));
      return use(...rooms);
    } finally {
      rooms.forEach((room, i) => shading_free(room, sizes[i]));
    }
  }

  function status(model, points, normals, eye, material, ambient, lights, take) {
    const inputs = [points, normals, eye, material, ambient];
    return call(inputs, 17 * lights.length + points.length, (p, n, e, m, a, rest) => {
      // as integers: the words that are none might not survive as floats
      const words = new Uint32Array(memory.buffer, rest, 17 * lights.length);
      lights.forEach((light, i) => words.set(new Uint32Array(light.buffer), 17 * i));
      const out = rest + 4 * words.length;
      const code = shading_shade(model, points.length / 3, p, n, e, m, a, rest, lights.length, out);
      return code || take(new Float32Array(memory.buffer, out, points.length));
    });
  }

  function shade({ points, normals, eye, lights, material = {}, ambient = 1, model = "blinn-phong" }) {
    const number = MODELS.indexOf(model);
    if (number < 0) throw new RangeError(`model: expected one of ${MODELS.join(", ")}, got ${model}`);
    if (points.length % 3) throw new RangeError(`points: expected three numbers for each point, got ${points.length}`);
    if (normals.length !== points.length) {
      throw new RangeError(`normals: expected as many numbers as points, ${points.length}, got ${normals.length}`);
    }
    const { ka = 0, kd = 0, ks = 0, m = 1 } = material;
    const words = [...color("material.ka", ka), ...color("material.kd", kd), ...color("material.ks", ks), m];
    const packedLights = lights.map(packed);
    const args = [triple("eye", eye), words, color("ambient", ambient)];
    let colors;
    const code = status(number, points, normals, ...args, packedLights, (out) => { colors = out.slice(); return 0; });
    if (code === LIGHT) {
      // no points, and one light at a time
      const bad = packedLights.findIndex((light) => status(number, [], [], ...args, [light], () => 0) === LIGHT);
      throw new RangeError(`lights[${bad}]: ${LIGHT_RULE}`);
    }
    if (code === MATERIAL) throw new RangeError(`material: ${MATERIAL_RULE}`);
    if (code) throw new Error(`shading_shade: status ${code}`);
    return colors;
  }

  function toSrgb8(colors) {
    if (colors.length % 3) throw new RangeError(`colors: expected three numbers for each color, got ${colors.length}`);
    return call([colors], Math.ceil(colors.length / 4), (from, out) => {
      const code = shading_to_srgb8(colors.length / 3, from, out);
      if (code) throw new Error(`shading_to_srgb8: status ${code}`);
      return new Uint8Array(memory.buffer, out, colors.length).slice();
    });
  }

  return { shade, toSrgb8, memory };
}
