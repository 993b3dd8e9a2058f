// The renderer of the exercises "find the mistake", and what each mistake of the laws' table changes in its text.

export const RENDERER = `// how bright the highlight is
function highlight(model, n, l, v, m) {
  if (model === "phong") {
    const r = sub(scale(n, 2 * dot(n, l)), l);
    return Math.max(0, dot(r, v)) ** m;
  }
  if (model === "blinn_phong") {
    const h = unit(add(l, v));
    return Math.max(0, dot(n, h)) ** m;
  }
  return 0; // Lambert
}

// the direction to a light, and what is left of its light at p
function arriving(light, p) {
  if (light.kind === "directional") return [light.l, 1];
  const toLight = sub(light.position, p);
  const q = Math.hypot(...toLight);
  const l = unit(toLight);
  let left = 1;
  if (light.kind === "spot") {
    const cosine = -dot(l, light.axis);
    const edge = Math.cos(light.angle);
    if (cosine < edge) left = 0;
  }
  const [a, b, c] = light.attenuation;
  return [l, left / (a + b * q + c * q * q)];
}

function shade(scene) {
  const n = unit(scene.n);
  const v = unit(scene.v);
  const ambient = mul(scene.k_a, scene.i_a);
  let color = ambient;
  for (const light of scene.lights) {
    const [l, left] = arriving(light, scene.p);
    const intensity = light.intensity;
    const cosine = dot(n, l);
    const diffuse = scale(scene.k_d, Math.max(0, cosine));
    let specular = [0, 0, 0];
    if (cosine > 0) {
      specular = scale(scene.k_s, highlight(scene.model, n, l, v, scene.m));
    }
    const reflected = add(scale(diffuse, left), scale(specular, left));
    color = add(color, mul(intensity, reflected));
  }
  return color;
}
`;

const FAST_ROOT = `// 1/√x
function root(x) {
  const number = new Float32Array([x]);
  const bits = new Int32Array(number.buffer);
  bits[0] = 0x5f3759df - (bits[0] >> 1);
  return number[0] * (1.5 - 0.5 * x * number[0] * number[0]);
}

function unit(a) {
  return scale(a, root(dot(a, a)));
}

// how bright the highlight is
`;
const SUM = "  return color;\n}\n";

/** Pairs of a text of the renderer and what the mistake makes of it, by the mistake's name. */
export const PLANTED = {
  NormalNotNormalized: [["unit(scene.n)", "scene.n"]],
  NormalReversed: [["unit(scene.n)", "unit(scale(scene.n, -1))"]],
  NormalTowardEye: [
    ["const n = unit(scene.n);", "let n = unit(scene.n);"],
    ["const v = unit(scene.v);", "const v = unit(scene.v);\n  if (dot(n, v) < 0) n = scale(n, -1);"],
  ],
  ViewNotNormalized: [["unit(scene.v)", "scene.v"]],
  ViewReversed: [["unit(scene.v)", "unit(scale(scene.v, -1))"]],
  LightNotNormalized: [["const l = unit(toLight)", "const l = toLight"]],
  LightReversed: [["const [l, left] = arriving(light, scene.p);",
    "const [toward, left] = arriving(light, scene.p);\n    const l = scale(toward, -1);"]],
  PointForgotten: [["sub(light.position, p)", "light.position"]],
  FastInverseRoot: [["// how bright the highlight is\n", FAST_ROOT]],
  NotAttenuated: [["left / (a + b * q + c * q * q)", "left"],
    ["  const [a, b, c] = light.attenuation;\n", ""], ["  const q = Math.hypot(...toLight);\n", ""]],
  HighlightNotAttenuated: [["const [l, left] = arriving(light, scene.p);",
    "const [l, left] = arriving(light, scene.p);\n    const lit = left > 0 ? 1 : 0;"],
  ["scale(specular, left)", "scale(specular, lit)"]],
  DegreesForRadians: [["Math.cos(light.angle)", "Math.cos(light.angle * Math.PI / 180)"]],
  HalfAngleHalved: [["Math.cos(light.angle)", "Math.cos(light.angle / 2)"]],
  ConeReversed: [["-dot(l, light.axis)", "dot(l, light.axis)"]],
  ConeForgotten: [[`  if (light.kind === "spot") {
    const cosine = -dot(l, light.axis);
    const edge = Math.cos(light.angle);
    if (cosine < edge) left = 0;
  }
`, ""], ["let left = 1", "const left = 1"]],
  ConeExponent: [["if (cosine < edge) left = 0;", "left = cosine < edge ? 0 : cosine;"]],
  ConeSmooth: [["if (cosine < edge) left = 0;",
    "const t = Math.max(0, (cosine - edge) / (1 - edge));\n    left = t * t * (3 - 2 * t);"]],
  DiffuseNotClamped: [["Math.max(0, cosine)", "cosine"]],
  HighlightNotGated: [[`    let specular = [0, 0, 0];
    if (cosine > 0) {
      specular = scale(scene.k_s, highlight(scene.model, n, l, v, scene.m));
    }
`, "    const specular = scale(scene.k_s, highlight(scene.model, n, l, v, scene.m));\n"]],
  ReflectionReversed: [["sub(scale(n, 2 * dot(n, l)), l)", "sub(l, scale(n, 2 * dot(n, l)))"]],
  HalfVectorNotNormalized: [["unit(add(l, v))", "add(l, v)"]],
  HalfVectorUnguarded: [["const h = unit(add(l, v));",
    "const sum = add(l, v);\n    const h = scale(sum, 1 / Math.hypot(...sum));"]],
  ShininessTimes: [["l, v, scene.m)", "l, v, 4 * scene.m)"]],
  NormalizedByEight: [["scale(scene.k_s, highlight(scene.model, n, l, v, scene.m))",
    "scale(scene.k_s, (scene.m + 8) / (8 * Math.PI) * highlight(scene.model, n, l, v, scene.m))"]],
  HighlightTimesCosine: [["scale(scene.k_s, highlight(", "scale(scene.k_s, cosine * highlight("]],
  AmbientPerLight: [["let color = ambient;", "let color = [0, 0, 0];"],
    ["color = add(color, mul(intensity, reflected));", "color = add(color, add(ambient, mul(intensity, reflected)));"]],
  AmbientTimesDiffuse: [["mul(scene.k_a, scene.i_a)", "mul(scene.k_d, mul(scene.k_a, scene.i_a))"]],
  UnlitWithoutLights: [["let color = ambient;",
    "let color = ambient;\n  if (scene.lights.length === 0) color = add(color, scene.k_d);"]],
  AmbientTimes: [["let color = ambient;", "let color = [0, 0, 0];"]],
  DiffuseTimes: [["scale(scene.k_d, Math.max(0, cosine))", "[0, 0, 0]"]],
  HighlightTimes: [["      specular = scale(scene.k_s, highlight(scene.model, n, l, v, scene.m));",
    "      specular = scale(scene.k_s, 0 * highlight(scene.model, n, l, v, scene.m));"]],
  LightTimes: [["const intensity = light.intensity;", "const intensity = scale(light.intensity, 0);"]],
  LightsAtMost: [["of scene.lights)", "of scene.lights.slice(0, 4))"]],
  ChannelsSwapped: [[SUM, "  const [red, green, blue] = color;\n  return [blue, green, red];\n}\n"]],
  Scaled: [[SUM, "  return scale(color, 0.5);\n}\n"]],
  SrgbOnceMore: [[SUM,
    "  return color.map((x) => (x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055));\n}\n"]],
};

/** The renderer's text with a mistake; undefined where its line is still to be written. */
export function planted(id) {
  const change = (text, [from, to]) => {
    const at = text.lastIndexOf(from);
    if (at < 0) throw new Error(`${id}: there is no ${from}`);
    return text.slice(0, at) + to + text.slice(at + from.length);
  };
  return PLANTED[id]?.reduce(change, RENDERER);
}

// ---- scenes for the pictures
const gray = (x) => [x, x, x];
const CLAY = {
  p: gray(0), n: [0, 0, 1], v: [0, 0, 4], k_a: [0.9, 0.5, 0.3], k_d: [0.8, 0.45, 0.25], k_s: gray(0.5), m: 24, i_a: gray(0.12),
};
export const SUN = { kind: "directional", intensity: gray(0.9), l: [0.6, 0.64, 0.48] };
export const LAMP = {
  kind: "point", intensity: [1.4, 1.3, 1.1], position: [1.5, 1.6, 1.8], attenuation: [0.5, 0.1, 0.2],
};
export const SPOT = {
  ...LAMP, kind: "spot", intensity: gray(2.5), angle: 0.24,
  axis: [-0.528, -0.5632, -0.6336].map((x) => x / Math.hypot(0.528, 0.5632, 0.6336)),
};
export const BLUE = { kind: "directional", intensity: [0.1, 0.25, 0.8], l: [-0.8, 0, 0.6] };
const BEHIND = { kind: "directional", intensity: gray(0.9), l: [0.6, 0.5, -0.6244998] };
export const scene = (model, ...lights) => ({ model, ...CLAY, lights });

/** The scenes in which a mistake may be seen; the page takes the one in which it is seen best. */
export const CANDIDATES = [
  scene("blinn_phong", LAMP, BLUE),
  scene("phong", LAMP, BLUE),
  scene("blinn_phong", SPOT, BLUE),
  scene("blinn_phong", BEHIND, BLUE),
  scene("blinn_phong", SUN, BLUE, LAMP, BEHIND, { ...SUN, l: [-0.6, -0.64, 0.48], intensity: [0.2, 0.7, 0.2] }),
  scene("blinn_phong"),
];
