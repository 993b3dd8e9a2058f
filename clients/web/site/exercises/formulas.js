// The formulas of the lectures, one function each. The worker puts the student's function in the place of one of
// them. A test compares the normals with those of the crate, and the laws judge the others.

export const add = (a, b) => a.map((x, i) => x + b[i]);
export const sub = (a, b) => a.map((x, i) => x - b[i]);
export const mul = (a, b) => a.map((x, i) => x * b[i]);
export const scale = (a, s) => a.map((x) => x * s);
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

/** a at length 1, or 0 if it has no direction. */
export function unit(a) {
  const length = Math.hypot(...a);
  return length > 0 ? a.map((x) => x / length) : a;
}

const near = (a, b, allowed) => Object.is(a, b) || Math.abs(a - b) <= allowed * Math.max(1, Math.abs(b));

/** Whether two answers, numbers or triples, are the same to this precision. */
export function same(answer, wanted, allowed = 1e-6) {
  const [a, b] = [[answer].flat(), [wanted].flat()];
  return a.length === b.length && a.every((x, i) => near(x, b[i], allowed));
}

export const RIGHT = {
  ambient: (k_a, i_a) => mul(k_a, i_a),
  lambert: (n, l) => Math.max(0, dot(n, l)),
  attenuation: (a, b, c, q) => 1 / (a + b * q + c * q * q),
  reflection: (n, l) => sub(scale(n, 2 * dot(n, l)), l),
  phong: (r, v, m) => Math.max(0, dot(r, v)) ** m,
  halfVector: (l, v) => unit(add(l, v)),
  blinn: (n, h, m) => Math.max(0, dot(n, h)) ** m,
  spot: (l, axis, angle) => (-dot(l, axis) < Math.cos(angle) ? 0 : 1),
  plane: (a, b, c) => unit([a, b, c]),
  sphere: (center, p) => unit(sub(p, center)),
  triangle: (v1, v2, v3) => unit(cross(sub(v2, v1), sub(v3, v1))),
  ellipsoid: (p, axes) => unit(p.map((x, i) => x / axes[i] ** 2)),
  torus(u, v, R, r) {
    const distance = R + r * Math.cos(v); // from the axis
    const s_u = [-distance * Math.sin(u), distance * Math.cos(u), 0];
    const s_v = [-r * Math.sin(v) * Math.cos(u), -r * Math.sin(v) * Math.sin(u), r * Math.cos(v)];
    return unit(cross(s_u, s_v));
  },
};

// Surfaces that have a scene's normal somewhere. The student's function is asked for the normal there.
const CENTER = [0.5, -1, 0.25];
const AXES = [0.75, 1.5, 2.5]; // with 1, a square would look like a root, and with 2 like a product

export const SURFACES = {
  plane: ({ plane }, n) => plane(...n, n[0] + 0.25), // on either side of the origin
  sphere: ({ sphere }, n) => sphere(CENTER, add(CENTER, n)),
  triangle({ triangle }, n) {
    const least = n.map(Math.abs).indexOf(Math.min(...n.map(Math.abs)));
    const side = Math.sqrt(Math.hypot(...n)); // the cross product is then as long as n
    const t = scale(unit(cross(n, [0, 1, 2].map((i) => Number(i === least)))), side);
    const b = scale(unit(cross(n, t)), side);
    return triangle(CENTER, add(CENTER, t), add(CENTER, add(b, scale(t, 0.25))));
  },
  ellipsoid({ ellipsoid }, n) {
    const p = mul(AXES.map((a) => a * a), unit(n));
    return ellipsoid(scale(p, 1 / Math.sqrt(dot(p, unit(n)))), AXES);
  },
  torus({ torus }, n) {
    const [x, y, z] = unit(n);
    const v = Math.asin(Math.max(-1, Math.min(1, z)));
    // each normal is found twice: on the outside of the torus, and across its axis on the inside
    const [a, b] = y < 0 ? [Math.atan2(-y, -x), Math.PI - v] : [Math.atan2(y, x), v];
    return torus(a, b, 2, 0.75);
  },
};

/** The direction to a light, and the light that arrives at p. */
function arriving(parts, light, p) {
  if (light.kind === "directional") return [light.l, light.intensity];
  const toLight = sub(light.position, p);
  const q = Math.hypot(...toLight);
  const l = scale(toLight, 1 / q);
  const cone = light.kind === "spot" ? parts.spot(l, light.axis, light.angle) : 1;
  return [l, scale(light.intensity, cone * parts.attenuation(...light.attenuation, q))];
}

/** The color of a scene by these parts. An ungated highlight is not cut off behind the surface. */
export function shadeBy(parts, scene, { surface, ungated }) {
  const n = surface ? SURFACES[surface](parts, scene.n) : unit(scene.n);
  const v = unit(scene.v);
  let color = parts.ambient(scene.k_a, scene.i_a);
  for (const light of scene.lights) {
    const [l, intensity] = arriving(parts, light, scene.p);
    let factor = scale(scene.k_d, parts.lambert(n, l));
    if (scene.model !== "lambert" && (ungated || dot(n, l) > 0)) {
      const highlight = scene.model === "phong" ? parts.phong(parts.reflection(n, l), v, scene.m)
        : parts.blinn(n, parts.halfVector(l, v), scene.m);
      factor = add(factor, scale(scene.k_s, highlight));
    }
    color = add(color, mul(intensity, factor));
  }
  return color;
}

/** The whole formula for directional lights, as the student writes it: the sum over the lights. */
RIGHT.shade = (scene) => shadeBy(RIGHT, scene, {});
