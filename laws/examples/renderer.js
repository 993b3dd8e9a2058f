// A renderer to copy from: Lambert, Phong and Blinn-Phong, checked by
//
//     shading-laws node renderer.js

const add = (a, b) => a.map((x, i) => x + b[i]);
const sub = (a, b) => a.map((x, i) => x - b[i]);
const mul = (a, b) => a.map((x, i) => x * b[i]);
const scale = (a, s) => a.map((x) => x * s);
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

// a at length 1, or 0 if it has no direction, as L + V where L = -V
function unit(a) {
  const length = Math.sqrt(dot(a, a));
  return length > 0 ? scale(a, 1 / length) : a;
}

// the direction L to a light, and the intensity that arrives at p
function arriving(light, p) {
  if (light.kind === "directional") return [light.l, light.intensity];
  const toLight = sub(light.position, p);
  const q = Math.sqrt(dot(toLight, toLight));
  const l = scale(toLight, 1 / q);
  // the cone includes its edge
  if (light.kind === "spot" && -dot(l, light.axis) < Math.cos(light.angle)) return [l, [0, 0, 0]];
  const [a, b, c] = light.attenuation;
  return [l, scale(light.intensity, 1 / (a + b * q + c * q * q))];
}

function highlight(model, n, l, v, m) {
  if (model === "phong") {
    const r = sub(scale(n, 2 * dot(n, l)), l);
    return Math.max(0, dot(r, v)) ** m;
  }
  if (model === "blinn_phong") return Math.max(0, dot(n, unit(add(l, v)))) ** m;
  return 0; // Lambert
}

function shade(scene) {
  const n = unit(scene.n);
  const v = unit(scene.v);
  let color = mul(scene.k_a, scene.i_a);
  for (const light of scene.lights) {
    const [l, intensity] = arriving(light, scene.p);
    const nDotL = dot(n, l);
    if (nDotL <= 0) continue; // the light is behind the surface
    const specular = scale(scene.k_s, highlight(scene.model, n, l, v, scene.m));
    color = add(color, mul(intensity, add(scale(scene.k_d, nDotL), specular)));
  }
  return color;
}

let isFirst = true;
require("node:readline")
  .createInterface({ input: process.stdin })
  .on("line", (line) => {
    if (isFirst) console.log(JSON.stringify({ name: "renderer.js", roundoff: 2 ** -53 }));
    else if (line) console.log(JSON.stringify(shade(JSON.parse(line))));
    isFirst = false; // the first line is the version of the format
  });
