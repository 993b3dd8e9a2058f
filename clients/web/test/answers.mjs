// Typical wrong answers as students write them, and the words that each must get. They were written before the page's
// texts. Other right forms must pass.

const f = (head) => (...lines) => `function ${head} {\n${lines.map((line) => `  ${line}\n`).join("")}}\n`;
const ambient = f("ambient(k_a, i_a)");
const lambert = f("lambert(n, l)");
const attenuation = f("attenuation(a, b, c, q)");
const reflection = f("reflection(n, l)");
const phong = f("phong(r, v, m)");
const half = f("halfVector(l, v)");
const blinn = f("blinn(n, h, m)");
const spot = f("spot(l, axis, angle)");
const plane = f("plane(a, b, c, d)");
const sphere = f("sphere(center, p)");
const triangle = f("triangle(v1, v2, v3)");
const ellipsoid = f("ellipsoid(p, axes)");
const torus = f("torus(u, v, R, r)");

const sum = ({
  n = "unit(scene.n)", v = "unit(scene.v)", first = "mul(scene.k_a, scene.i_a)", lights = "scene.lights",
  gate = "if (cosine <= 0) continue;", h = "unit(add(light.l, v))", diffuse = "Math.max(0, cosine)",
  shiny = "Math.max(0, dot(n, h)) ** scene.m", k_d = "scene.k_d", k_s = "scene.k_s",
  color = "add(color, mul(light.intensity, reflected))", last = "color", end = "",
}) => f("shade(scene)")(`const n = ${n}, v = ${v};`, `let color = ${first};`, `for (const light of ${lights}) {`,
  "  const cosine = dot(n, light.l);", `  ${gate}`, `  const h = ${h};`,
  `  const shiny = ${shiny};`,
  `  const reflected = add(scale(${k_d}, ${diffuse}), scale(${k_s}, shiny));`, `  color = ${color};`, `  ${end}`,
  "}", `return ${last};`);

const TANGENTS = ["const d = R + r * Math.cos(v);", "const su = [-d * Math.sin(u), d * Math.cos(u), 0];"];
const SV = "const sv = [-r * Math.sin(v) * Math.cos(u), -r * Math.sin(v) * Math.sin(u), r * Math.cos(v)];";

/** For each exercise: an answer, and what the headline must say. */
export const WRONG = {
  ambient: [
    [ambient("return add(k_a, i_a);"), /add the reflectance and the light/],
    [ambient("return k_a;"), /not depend on the ambient light/],
    [ambient("return i_a.slice();"), /not depend on the surface/],
    [ambient("const x = k_a[0] * i_a[0];", "return [x, x, x];"), /value of the red one/],
    [ambient("const s = dot(i_a, k_a);", "return [s, s, s];"), /add up the three channels/],
    [ambient("return scale(mul(k_a, i_a), 0.5);"), /always 0.5 times/],
    [ambient("return [k_a[0] * i_a[0], k_a[1] * i_a[1], 0];"), /wrong in .* calls/],
    [ambient("return scale(i_a, k_a);"), /scale takes an array and a number, but it was given an array of 3/],
    [ambient("return k_a * i_a;"), /does not compute with whole arrays/],
  ],
  lambert: [
    [lambert("return dot(n, l);"), /negative light/],
    [lambert("return Math.max(0, dot(n, scale(l, -1)));"), /lit from behind/],
    [lambert("return Math.abs(dot(n, l));"), /back of your surface is lit/],
    [lambert("const c = dot(n, l);", "return c > 0 ? c * c : 0;"), /square of the cosine/],
    [lambert("return Math.max(0, 1 - 2 * Math.acos(Math.max(-1, Math.min(1, dot(n, l)))) / Math.PI);"), /angle itself/],
    [lambert("return (dot(n, l) + 1) / 2;"), /reaches around/],
    [lambert("return Math.min(0, dot(n, l));"), /negative half/],
    [lambert("return Math.max(0, dot(n, l)) / Math.PI;"), /always 0.3183 times/],
    [lambert("return 0;"), /always the same/],
    [lambert("return Math.max(0, n[2] * l[2]);"), /wrong in .* calls/],
    [lambert("return Math.max(0, n * l);"), /always returns NaN/],
    [lambert("return Math.acos(dot(n, l));"), /angle itself/],
    [lambert("return Math.cos(dot(n, l));"), /cosine of a cosine/],
    [lambert("return dot(n, l) > 0 ? 1 : 0;"), /at any angle/],
    [lambert("return cross(n, l);"), /should return a number, but it returned an array of 3/],
    [lambert("return n.l;"), /returned nothing/],
  ],
  attenuation: [
    [attenuation("return 1 / (a + (b + c) * q);"), /not with its square/],
    [attenuation("return 1 / (a + b * q * q + c * q);"), /changed places/],
    [attenuation("return a + b * q + c * q ** 2;"), /gets stronger/],
    [attenuation("return 1 / q ** 2;"), /pure inverse square/],
    [attenuation("return 1 / (q * (b + c * q));"), /coefficient a is missing/],
    [attenuation("const x = 1 / (a + b * q + c * q * q);", "return x * x;"), /whole denominator/],
    [attenuation("return Math.min(1, 1 / (a + b * q + c * q * q));"), /limit the answer to 1/],
    [attenuation("return 1;"), /not get weaker/],
    [attenuation("return 1 / a + b * q + c * q * q;"), /Only a is in the denominator/],
    [attenuation("return 1 / (a * q * q + b * q + c);"), /a and c have changed places/],
    [attenuation("return 1 / (a + c * q * q);"), /coefficient b is missing/],
    [attenuation("return 1 / (a + b * q);"), /coefficient c is missing/],
    [attenuation("return 1 / (a + b * q + c * q^2);"), /\^ is not a power/],
  ],
  reflection: [
    [reflection("return sub(l, scale(n, 2 * dot(l, n)));"), /opposite of the right one/],
    [reflection("return sub(scale(n, dot(n, l)), l);"), /only half of the way/],
    [reflection("return sub(scale(n, 2), l);"), /N itself/],
    [reflection("return l.map((x) => -x);"), /mirror it in a point/],
    [reflection("return add(scale(n, 2 * dot(n, l)), l);"), /not have length 1/],
    [reflection("return sub(scale(l, 2 * dot(n, l)), n);"), /mirror N about L/],
    [reflection("return l;"), /still L itself/],
    [reflection("return sub(scale(n, 2 * Math.max(0, dot(n, l))), l);"), /You clamp N·L/],
    [reflection("return scale(n, 2 * dot(n, l));"), /always points along N/],
    [reflection("return 2 * dot(n, l) * n - l;"), /does not compute with whole arrays/],
  ],
  phong: [
    [phong("return dot(r, v) ** m;"), /negative cosine/],
    [phong("return Math.max(0, dot(r, v));"), /no effect/],
    [phong("return m * Math.max(0, dot(r, v));"), /multiply by m/],
    [phong("return Math.pow(Math.abs(dot(r, v)), m);"), /second highlight/],
    [phong("return Math.max(0, dot(r, v) ** m);"), /removes? the negative numbers afterward/],
    [phong("return m ** Math.max(0, dot(r, v));"), /changed places/],
    [phong("return Math.max(0, dot(r, v)) ** (m / 2);"), /half the exponent/],
    [phong("return m * Math.max(0, dot(r, v)) ** m;"), /multiply by m/],
    [phong("return Math.max(0, -dot(r, v)) ** m;"), /on the far side/],
    [phong("return Math.max(0, dot(r, v)) ^ m; // to the power of m"), /\^ is not a power/],
  ],
  half: [
    [half("return add(l, v);"), /not have length 1/],
    [half("return scale(add(l, v), 1 / 2);"), /average/],
    [half("return unit(sub(l, v));"), /difference of L and V/],
    [half("return unit(sub(v, l));"), /difference of V and L/],
    [half("const s = add(l, v);", "return scale(s, 1 / Math.sqrt(dot(s, s)));"), /divides by 0|NaN or infinity|before the division/],
    [half("return unit(cross(l, v));"), /cross product/],
    [half("return l;"), /not depend on the eye/],
    [half("return scale(add(l, v), 1 / Math.sqrt(2));"), /√2/],
    [half("return unit(v);"), /not depend on the light/],
    [half("return unit(scale(add(l, v), -1));"), /always has the wrong sign/],
    [half("return unit(l + v);"), /unit takes one array of numbers/],
  ],
  blinn: [
    [blinn("return dot(n, h) ** m;"), /negative cosine/],
    [blinn("return Math.max(0, dot(n, h));"), /no effect/],
    [blinn("return m * Math.max(0, dot(n, h));"), /multiply by m/],
    [blinn("return Math.abs(dot(n, h)) ** m;"), /second highlight/],
    [blinn("return Math.max(0, dot(n, h)) ** (m * 4);"), /4m/],
    [blinn("return m ** Math.max(0, dot(n, h));"), /changed places/],
    [blinn("return Math.max(0, dot(n, h) ** m);"), /removes? the negative numbers afterward/],
    [blinn("return m * Math.max(0, dot(n, h)) ** m;"), /multiply by m/],
    [blinn("return Math.max(0, -dot(n, h)) ** m;"), /on the far side/],
  ],
  spot: [
    [spot("return dot(l, axis) >= Math.cos(angle) ? 1 : 0;"), /back of the lamp/],
    [spot("return -dot(l, axis) >= Math.cos(angle / 2) ? 1 : 0;"), /half as wide/],
    [spot("return -dot(l, axis) >= Math.cos(angle / 180 * Math.PI) ? 1 : 0;"), /degrees/],
    [spot("return -dot(l, axis) <= Math.cos(angle) ? 1 : 0;"), /outside of its cone/],
    [spot("return -dot(l, axis) >= angle ? 1 : 0;"), /cosine with an angle/],
    [spot("const c = -dot(l, axis);", "return c >= Math.cos(angle) ? c : 0;"), /fades toward the edge/],
    [spot("return 1;"), /had no cone/],
    [spot("return -dot(l, axis) >= Math.sin(angle) ? 1 : 0;"), /with a sine/],
    [spot("return 0;"), /always the same/],
    [spot("return Math.abs(dot(l, axis)) >= Math.cos(angle) ? 1 : 0;"), /second cone/],
    [spot("return Math.max(0, -dot(l, axis));"), /not depend on the angle/],
    [spot("return -dot(l, axis) >= Math.cos(angle * 180 / Math.PI) ? 1 : 0;"), /into degrees/],
    [spot("return -dot(l, axis) >= Math.cos(angle);"), /returned the boolean true/],
  ],
  sum: [
    [sum({ first: "[0, 0, 0]", gate: "color = add(color, mul(scene.k_a, scene.i_a)); if (cosine <= 0) continue;" }),
      /once for every lamp/],
    [sum({ first: "[0, 0, 0]" }), /ambient light is missing/],
    [sum({ gate: "" }), /behind the surface still makes a highlight/],
    [sum({ color: "add(color, reflected)" }), /color of the light has no effect/],
    [sum({ end: "return color;" }), /Only the first light counts/],
    [sum({ n: "scene.n" }), /length is not 1/],
    [sum({ last: "[color[0], color[0], color[0]]" }), /value of the red one/],
    [sum({ color: "add(mul(scene.k_a, scene.i_a), mul(light.intensity, reflected))" }), /Only the last light counts/],
    [sum({ h: "add(light.l, v)" }), /L \+ V as the half vector/],
    [sum({ v: "scene.v" }), /v as it comes/],
    [sum({ v: "unit(scale(scene.v, -1))" }), /from the eye to the surface/],
    [sum({ diffuse: "1" }), /cosine is missing/],
    [sum({ gate: "if (cosine <= 0) break;" }), /ends at the first light behind/],
    [sum({ gate: "if (cosine <= 0) return color;" }), /ends at the first light behind/],
    [sum({ shiny: "cosine * Math.max(0, dot(n, h)) ** scene.m" }), /highlight by N·L/],
    [sum({ first: "scene.i_a" }), /not depend on the surface/],
    [sum({ last: "color.map((x) => Math.min(1, x))" }), /cut the light off/],
    [sum({ shiny: "Math.max(0, dot(n, h))" }), /no effect/],
    [sum({ k_d: "scene.k_s", k_s: "scene.k_d" }), /changed places/],
  ],
  plane: [
    [plane("return [a, b, c];"), /length is not 1/],
    [plane("return unit([-a, -b, -c]);"), /other side of the plane/],
    [plane("return scale([a, b, c], 1 / d);"), /divide by d/],
    [plane("const s = a + b + c;", "return [a / s, b / s, c / s];"), /sum of the coefficients|NaN or infinity/],
    [plane("return scale([a, b, c], 1 / dot([a, b, c], [a, b, c]));"), /root is missing/],
    [plane("return [0, 0, 1];"), /always the same/],
    [plane("return unit([a * d, b * d, c * d]);"), /wrong in .* calls/],
    [plane("return unit(a, b, c);"), /in line 2: TypeError: unit takes one array of numbers/],
    [plane("return unit([a, b, c, d]);"), /an array of 4/],
  ],
  sphere: [
    [sphere("return sub(p, center);"), /as long as the radius/],
    [sphere("return unit(sub(center, p));"), /into the sphere/],
    [sphere("return unit(p);"), /center may be anywhere/],
    [sphere("return unit(add(p, center));"), /add the center/],
    [sphere("const d = sub(p, center);", "return scale(d, 1 / dot(d, d));"), /root is missing/],
    [sphere("return [0, 0, 1];"), /same everywhere/],
    [sphere("return scale(sub(p, center), 0.5);"), /length is not 1/],
    [sphere("return unit(p - center);"), /does not compute with whole arrays/],
  ],
  triangle: [
    [triangle("return unit(cross(sub(v3, v1), sub(v2, v1)));"), /back of the triangle/],
    [triangle("return cross(sub(v2, v1), sub(v3, v1));"), /length is not 1/],
    [triangle("return unit(cross(v1, v2));"), /corners/],
    [triangle("return unit(scale(add(v1, add(v2, v3)), 1 / 3));"), /middle of the triangle/],
    [triangle("return cross(unit(sub(v2, v1)), unit(sub(v3, v1)));"), /normalize the edges/],
    [triangle("return unit(mul(sub(v2, v1), sub(v3, v1)));"), /number by number/],
    [triangle("return unit(cross(v2 - v1, v3 - v1));"), /cross takes two arrays of numbers/],
    [triangle("return unit(cross(sub(v1, v2), sub(v3, v1)));"), /back of the triangle/],
  ],
  implicit: [
    [ellipsoid("return unit(p);"), /normal of a sphere/],
    [ellipsoid("return unit(p.map((x, i) => x / axes[i]));"), /not by their squares/],
    [ellipsoid("return unit(p.map((x, i) => x * axes[i] ** 2));"), /should divide/],
    [ellipsoid("const [a, b, c] = axes;", "return [2 * p[0] / a ** 2, 2 * p[1] / b ** 2, 2 * p[2] / c ** 2];"),
      /length is not 1/],
    [ellipsoid("return unit(p.map((x, i) => -x / axes[i] ** 2));"), /into the ellipsoid/],
    [ellipsoid("return unit(p.map((x, i) => (x / axes[i]) ** 2));"), /not their derivatives/],
    // forward differences
    [ellipsoid("const g = ([x, y, z]) => (x / axes[0]) ** 2 + (y / axes[1]) ** 2 + (z / axes[2]) ** 2 - 1;",
      "return unit([0, 1, 2].map((i) => (g(p.map((x, k) => (k === i ? x + 1e-3 : x))) - g(p)) / 1e-3));"), /nearly right/],
    [ellipsoid("const [a, b, c] = axes;", "return unit([p[0], p[1] / b ** 2, p[2] / c ** 2]);"), /wrong in .* calls/],
    [ellipsoid("return unit(p.map((x, i) => 2 * x / (2 * axes[i])));"), /not by their squares/],
  ],
  parametric: [
    [torus(...TANGENTS, SV, "return unit(cross(sv, su));"), /into the torus/],
    [torus(...TANGENTS, SV, "return cross(su, sv);"), /length is not 1/],
    [torus("const d = R + r * Math.cos(v);", "return unit([d * Math.cos(u), d * Math.sin(u), r * Math.sin(v)]);"),
      /as if the torus were a sphere/],
    [torus(...TANGENTS, "return unit(su);"), /tangent/],
    [torus(...TANGENTS, SV.replaceAll("-r", "r"), "return unit(cross(su, sv));"), /wrong sign/],
    [torus("return [Math.cos(u) * Math.cos(v), Math.sin(v) * Math.cos(u), Math.sin(u)];"), /changed places/],
  ],
};

/** Other right forms, which must pass. */
export const ALSO_RIGHT = {
  ambient: [
    "const ambient = (k, i) => k.map((x, c) => x * i[c]);\n",
    ambient("for (let i = 0; i < 3; i++) k_a[i] *= i_a[i];", "return k_a;"),
  ],
  lambert: [
    "const lambert = (n, l) => Math.max(dot(n, l), 0);\n",
    lambert("const cosine = n[0] * l[0] + n[1] * l[1] + n[2] * l[2];", "if (cosine < 0) return 0;", "return cosine;"),
    lambert("return (dot(n, l) + Math.abs(dot(n, l))) / 2;"),
    "const dot = (a, b) => a.reduce((s, x, i) => s + x * b[i], 0);\nconst add = 1, RIGHT = 2, student = 3, calls = 4;\n"
      + lambert("return Math.max(0, dot(n, l));"),
    lambert("const d = sub(n, l);", "return Math.max(0, 1 - dot(d, d) / 2);"),
    lambert("const angle = Math.acos(Math.min(1, Math.max(-1, dot(n, l))));", "return angle < Math.PI / 2 ? Math.cos(angle) : 0;"),
    "lambert = (n, l) => Math.max(0, dot(n, l));\n",
  ],
  attenuation: [
    attenuation("return 1 / (a + q * (b + q * c));"), attenuation("return (a + b * q + c * q ** 2) ** -1;"),
    attenuation("return dot([a, b, c], [1, q, q * q]) ** -1;"),
  ],
  reflection: [
    reflection("const along = scale(n, dot(n, l));", "return add(along, sub(along, l));"),
    reflection("const i = scale(l, -1);", "return sub(i, scale(n, 2 * dot(n, i)));"),
    reflection("return unit(sub(scale(n, 2 * dot(n, l)), l));"),
  ],
  phong: [phong("const c = dot(r, v);", "return c > 0 ? Math.pow(c, m) : 0;")],
  half: [
    half("const s = add(l, v);", "const q = Math.hypot(...s);", "return q === 0 ? [0, 0, 1] : scale(s, 1 / q);"),
    half("const q = Math.sqrt(2 + 2 * dot(l, v));", "return q > 1e-12 ? scale(add(l, v), 1 / q) : v;"),
  ],
  blinn: [blinn("return dot(n, h) < 0 ? 0 : Math.exp(m * Math.log(dot(n, h)));")],
  spot: [
    spot("return Math.acos(Math.max(-1, Math.min(1, -dot(l, axis)))) <= angle ? 1 : 0;"),
    spot("return Number(dot(scale(l, -1), axis) >= Math.cos(angle));"),
  ],
  sum: [
    sum({ gate: "if (cosine < 0) continue;" }),
    f("shade(scene)")("const n = unit(scene.n), v = unit(scene.v);", "return scene.lights.reduce((sum, { l, intensity }) => {",
      "  const c = dot(n, l);", "  if (c <= 0) return sum;", "  const s = Math.max(0, dot(n, unit(add(l, v)))) ** scene.m;",
      "  return sum.map((x, i) => x + intensity[i] * (scene.k_d[i] * c + scene.k_s[i] * s));", "}, mul(scene.k_a, scene.i_a));"),
  ],
  plane: [plane("const q = Math.sqrt(a * a + b * b + c * c);", "return [a / q, b / q, c / q];")],
  sphere: [sphere("const d = p.map((x, i) => x - center[i]);", "return scale(d, 1 / Math.hypot(...d));")],
  triangle: [
    triangle("return unit(cross(sub(v3, v2), sub(v1, v2)));"),
    triangle("return unit(cross(sub(v2, v1), sub(v3, v2)));"),
    triangle("return unit(add(add(cross(v1, v2), cross(v2, v3)), cross(v3, v1)));"),
  ],
  implicit: [ellipsoid("const [a, b, c] = axes;", "return unit([2 * p[0] / (a * a), 2 * p[1] / (b * b), 2 * p[2] / (c * c)]);")],
  parametric: [torus("return [Math.cos(u) * Math.cos(v), Math.sin(u) * Math.cos(v), Math.sin(v)];")],
};
