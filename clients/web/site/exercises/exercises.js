// The exercises in the order of the lectures. `name` is the function to write. The laws try it within the whole
// formula, in scenes that have what `profile` says.
import { BLUE, LAMP, planted, RENDERER, scene, SPOT, SUN } from "./renderer.js";

const only = (models, lights, more) => ({ models, lights, ...more });
// the functions of the highlight are tried behind the surface, too
const UNGATED = { departs: ["HighlightNotGated"] };
const PHONG = { profile: only(["phong"], ["directional"], UNGATED), scene: scene("phong", SUN), ungated: true };
const BLINN = { profile: only(["blinn_phong"], ["directional"], UNGATED), scene: scene("blinn_phong", SUN), ungated: true };
const LAMBERT = { profile: only(["lambert"], ["directional"]), scene: scene("lambert", SUN) };
const body = (head, ...lines) => `function ${head} {\n${lines.map((line) => `  ${line}\n`).join("")}}\n`;

/** The exercises whose function is a formula. */
export const FORMULAS = [
  {
    id: "ambient", title: "Ambient light", name: "ambient", triple: true, ...LAMBERT,
    text: `Some light has bounced so often that it comes from everywhere. How much of it a surface sends to the eye
      depends on its color alone. A color is an array of three numbers: red, green and blue.`,
    formula: "k<sub>a</sub> I<sub>a</sub>, channel by channel",
    hints: ["Red light is reflected by the red number of the surface, and the other channels have no part in it.",
      "mul(a, b) multiplies two colors channel by channel."],
    stub: body("ambient(k_a, i_a)", "return [0, 0, 0];"),
    solution: body("ambient(k_a, i_a)", "return mul(k_a, i_a);"),
  },
  {
    id: "lambert", title: "Lambert’s law", name: "lambert", ...LAMBERT,
    text: `A matte surface is brightest where it faces the light. When it turns away, the same beam spreads over more
      surface. Return the fraction of the light that arrives. N is the normal and L points to the light. Both have length 1.`,
    formula: "max(0, <b>N</b>·<b>L</b>)",
    hints: ["The fraction is the cosine of the angle between N and L, and dot(n, l) is that cosine.",
      "A cosine can be negative. Light cannot."],
    stub: body("lambert(n, l)", "return 1;"),
    solution: body("lambert(n, l)", "return Math.max(0, dot(n, l));"),
  },
  {
    id: "attenuation", title: "Attenuation", name: "attenuation",
    profile: only(["lambert"], ["point"]), scene: scene("lambert", LAMP),
    text: `The light of a lamp gets weaker with the distance q. In nature it falls with the square of the distance.
      Pictures often look better with a mixture, which the coefficients a, b and c set: a is for the constant part,
      b for the linear and c for the quadratic one. Return the fraction that is left.`,
    formula: "1/(a + bq + cq²)",
    hints: ["First write the polynomial in q with the coefficients a, b and c.", "More distance means less light: divide."],
    stub: body("attenuation(a, b, c, q)", "return 1;"),
    solution: body("attenuation(a, b, c, q)", "return 1 / (a + b * q + c * q * q);"),
  },
  {
    id: "reflection", title: "The reflected direction", name: "reflection", triple: true, ...PHONG,
    text: `A mirror sends the light from L into the direction R, on the other side of N and at the same angle. All
      directions point away from the surface. N and L have length 1, and then R has length 1, too.`,
    formula: "<b>R</b> = 2(<b>N</b>·<b>L</b>)<b>N</b> − <b>L</b>",
    hints: ["Split L into a part along N and a part across. Which of the two changes its sign?",
      "The part of L along N is (N·L)N, which is scale(n, dot(n, l))."],
    stub: body("reflection(n, l)", "return l;"),
    solution: body("reflection(n, l)", "return sub(scale(n, 2 * dot(n, l)), l);"),
  },
  {
    id: "phong", title: "Phong’s highlight", name: "phong", ...PHONG,
    text: `A shiny surface sends most light into the direction R. The nearer the eye is to R, the brighter is the
      highlight. The shininess m makes it small and sharp. R points away from the surface, and V points to the eye.`,
    formula: "max(0, <b>R</b>·<b>V</b>)<sup>m</sup>",
    hints: ["R·V is the cosine of the angle between R and V. What should a negative one give?",
      "In JavaScript, x ** m is the power. Take care of negative numbers before it."],
    stub: body("phong(r, v, m)", "return 0;"),
    solution: body("phong(r, v, m)", "return Math.max(0, dot(r, v)) ** m;"),
  },
  {
    id: "half", title: "The half vector", name: "halfVector", triple: true, ...BLINN,
    text: `Blinn’s highlight needs no R. It asks how well the surface would have to be turned to mirror the light into
      the eye. For this, find the direction H in the middle between L and V, at length 1. Where L and V are
      opposite, no direction is in the middle, and any finite answer will do.`,
    formula: "<b>H</b> = (<b>L</b> + <b>V</b>)/|<b>L</b> + <b>V</b>|",
    hints: ["Put the arrows L and V one after the other. Where does their sum point?",
      "unit(a) gives a vector length 1, and leaves the zero vector as it is."],
    stub: body("halfVector(l, v)", "return l;"),
    solution: body("halfVector(l, v)", "return unit(add(l, v));"),
  },
  {
    id: "blinn", title: "Blinn’s highlight", name: "blinn", ...BLINN,
    text: `The highlight is brightest where the normal N is the half vector H. The shininess m makes it small and
      sharp, as in Phong’s formula.`,
    formula: "max(0, <b>N</b>·<b>H</b>)<sup>m</sup>",
    hints: ["It is Phong’s formula with another pair of vectors.",
      "In JavaScript, x ** m is the power. Take care of negative numbers before it."],
    stub: body("blinn(n, h, m)", "return 0;"),
    solution: body("blinn(n, h, m)", "return Math.max(0, dot(n, h)) ** m;"),
  },
  {
    id: "spot", title: "The cone of a spot", name: "spot",
    profile: only(["lambert"], ["spot"]), scene: scene("lambert", SPOT),
    text: `A spot lights a cone and nothing else. Its axis points from the lamp into the scene, and L points from the
      surface to the lamp. The angle goes from the axis to the edge of the cone, in radians. Return 1 inside and on
      the edge, and 0 outside.`,
    formula: "1 if −<b>L</b>·axis ≥ cos(angle), else 0",
    hints: ["In the middle of the cone, L and the axis are opposite. What is −L·axis there?",
      "Compare cosines, not angles: the cosine shrinks toward the edge."],
    stub: body("spot(l, axis, angle)", "return 1;"),
    solution: body("spot(l, axis, angle)", "return -dot(l, axis) >= Math.cos(angle) ? 1 : 0;"),
  },
  {
    id: "sum", title: "The sum over the lights", name: "shade", triple: true,
    profile: only(["blinn_phong"], ["directional"]), scene: scene("blinn_phong", SUN, BLUE),
    text: `Now put everything together. The scene has n, v, k_a, k_d, k_s, m, i_a and lights, and each light has l and
      intensity. Add the ambient light once. Then add for each light what the surface reflects, with Blinn’s
      highlight. The vectors n and v may have any length. A light behind the surface adds nothing, not even a highlight.`,
    formula: `k<sub>a</sub> I<sub>a</sub> + Σ I (k<sub>d</sub> <b>N</b>·<b>L</b> + k<sub>s</sub>
      (<b>N</b>·<b>H</b>)<sup>m</sup>), over the lights with <b>N</b>·<b>L</b> &gt; 0`,
    hints: ["Begin with N and V at length 1, and with the ambient light as the color.",
      "In the loop: leave out a light with N·L ≤ 0, compute H, then add to the color with mul(light.intensity, …)."],
    stub: body("shade(scene)", "let color = mul(scene.k_a, scene.i_a);", "for (const light of scene.lights) {",
      "  // color = add(color, …);", "}", "return color;"),
    solution: body("shade(scene)", "const n = unit(scene.n);", "const v = unit(scene.v);",
      "let color = mul(scene.k_a, scene.i_a);", "for (const light of scene.lights) {",
      "  const cosine = dot(n, light.l);", "  if (cosine <= 0) continue;", "  const h = unit(add(light.l, v));",
      "  const highlight = Math.max(0, dot(n, h)) ** scene.m;",
      "  const reflected = add(scale(scene.k_d, cosine), scale(scene.k_s, highlight));",
      "  color = add(color, mul(light.intensity, reflected));", "}", "return color;"),
  },
];

const BALL = "The ball asks your function for each of its normals, on a surface that has it.";

/** The exercises whose function is a normal. */
export const NORMALS = [
  {
    id: "plane", title: "The normal of a plane", name: "plane", surface: "plane",
    text: `The points of a plane satisfy ax + by + cz = d. Return the normal of length 1 that points to where
      ax + by + cz is larger. ${BALL}`,
    formula: "<b>N</b> = (a, b, c)/|(a, b, c)|",
    hints: ["The difference of two points of the plane is perpendicular to (a, b, c)."],
    stub: body("plane(a, b, c, d)", "return [0, 0, 1];"),
    solution: body("plane(a, b, c, d)", "return unit([a, b, c]);"),
  },
  {
    id: "sphere", title: "The normal of a sphere", name: "sphere", surface: "sphere",
    text: `The point p is on a sphere of any size, around any center. Return the normal of length 1 that points
      outward. ${BALL}`,
    formula: "<b>N</b> = (p − center)/|p − center|",
    hints: ["Which vector leads from the center to p?"],
    stub: body("sphere(center, p)", "return [0, 0, 1];"),
    solution: body("sphere(center, p)", "return unit(sub(p, center));"),
  },
  {
    id: "triangle", title: "The normal of a triangle", name: "triangle", surface: "triangle",
    text: `Seen from the front, the corners v1, v2 and v3 go around counterclockwise. Return the normal of length 1 that
      points to the front. ${BALL}`,
    formula: "<b>N</b> = (v₂ − v₁) × (v₃ − v₁), at length 1",
    hints: ["Two edges lie in the plane of the triangle. The cross product is perpendicular to both.",
      "Put your right hand along the first edge and bend the fingers to the second: the thumb is the cross product."],
    stub: body("triangle(v1, v2, v3)", "return [0, 0, 1];"),
    solution: body("triangle(v1, v2, v3)", "return unit(cross(sub(v2, v1), sub(v3, v1)));"),
  },
  {
    id: "implicit", title: "The normal of an implicit surface", name: "ellipsoid", surface: "ellipsoid",
    text: `An ellipsoid is where f(x, y, z) = x²/a² + y²/b² + z²/c² − 1 is 0. Its normal is the direction in which f
      grows fastest. Derive f by x, by y and by z. The array axes is [a, b, c]. Return the normal at length 1. ${BALL}`,
    formula: "<b>N</b> = ∇f/|∇f|, with ∂f/∂x = 2x/a² and so on",
    hints: ["The derivative of x²/a² by x is 2x/a².", "The factor 2 is the same in all three, so the length takes it out."],
    stub: body("ellipsoid(p, axes)", "return unit(p);"),
    solution: body("ellipsoid(p, axes)", "return unit(p.map((x, i) => x / axes[i] ** 2));"),
  },
  {
    id: "parametric", title: "The normal of a parametric surface", name: "torus", surface: "torus",
    text: `A torus is S(u, v) = ((R + r cos v) cos u, (R + r cos v) sin u, r sin v). Its two partial derivatives are
      tangents. Derive S by u and by v, by hand, and return the normal S_u × S_v at length 1. ${BALL}`,
    formula: "<b>N</b> = <b>S</b><sub>u</sub> × <b>S</b><sub>v</sub>, at length 1",
    hints: ["S_u = (−(R + r cos v) sin u, (R + r cos v) cos u, 0), because v stays as it is.",
      "S_v has the derivative of r cos v, which is −r sin v, times cos u and times sin u."],
    stub: body("torus(u, v, R, r)", "const s_u = [1, 0, 0]; // the derivative of S by u",
      "const s_v = [0, 1, 0]; // the derivative of S by v", "return unit(cross(s_u, s_v));"),
    solution: body("torus(u, v, R, r)", "const distance = R + r * Math.cos(v);",
      "const s_u = [-distance * Math.sin(u), distance * Math.cos(u), 0];",
      "const s_v = [-r * Math.sin(v) * Math.cos(u), -r * Math.sin(v) * Math.sin(u), r * Math.cos(v)];",
      "return unit(cross(s_u, s_v));"),
  },
].map((it) => ({ ...it, triple: true, ...LAMBERT }));

/** The exercise of a mistake of the laws' table. Without a text that has it, it ends with its name. */
export function mistakeExercise(number, mistake, scene) {
  const stub = planted(mistake.id);
  return {
    id: `find-${mistake.id}`, title: `Find the mistake ${number}`, name: "shade", triple: true, lamps: true, profile: {}, scene,
    mistake, stub, solution: RENDERER,
    text: `This renderer has a mistake that is often made. Look at the pictures: what is wrong?`,
    formula: `k<sub>a</sub> I<sub>a</sub> + Σ f s I (k<sub>d</sub> max(0, <b>N</b>·<b>L</b>) + k<sub>s</sub> highlight), where
      f is the falloff 1/(a + bq + cq²), s is 1 within the cone of a spot and 0 outside, and the highlight needs
      <b>N</b>·<b>L</b> &gt; 0`,
    hints: ["Take one term away in your mind, the ambient, the diffuse or the specular one. Which of them is wrong in the picture?",
      "Check lets the laws try hundreds of scenes, and tells in which kind of scene the color is wrong."],
  };
}
