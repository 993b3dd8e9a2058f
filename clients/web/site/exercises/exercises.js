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
    text: `Some light has bounced so often that it comes from everywhere. This ambient light has the color i_a.
      The color k_a says which part of it the surface reflects. Return the ambient light that goes to the eye. A color
      is an array of three numbers: red, green and blue.`,
    formula: "k<sub>a</sub> I<sub>a</sub>, channel by channel",
    hints: ["Red light is reflected by the red number of the surface, and the other channels have no part in it.",
      "mul(a, b) multiplies two colors channel by channel."],
    stub: body("ambient(k_a, i_a)", "return [0, 0, 0];"),
    solution: body("ambient(k_a, i_a)", "return mul(k_a, i_a);"),
  },
  {
    id: "lambert", title: "Lambert’s law", name: "lambert", ...LAMBERT,
    text: `A matte surface is brightest where it faces the light. When it turns away, the same beam spreads over more
      surface. Return the fraction of the light that arrives at a point. N is the normal, and L points to the light.
      Both have length 1.`,
    formula: "max(0, <b>N</b>·<b>L</b>)",
    hints: ["The fraction is the cosine of the angle between N and L, and dot(n, l) is that cosine.",
      "A cosine can be negative. Light cannot."],
    stub: body("lambert(n, l)", "return 1;"),
    solution: body("lambert(n, l)", "return Math.max(0, dot(n, l));"),
  },
  {
    id: "attenuation", title: "Attenuation", name: "attenuation",
    profile: only(["lambert"], ["point"]), scene: scene("lambert", LAMP),
    text: `The light of a lamp gets weaker with the distance q. In nature it is divided by the square of the distance.
      Pictures often look better if it is divided by a polynomial in q instead. The coefficient a is that of the
      constant term, b that of the linear term and c that of the quadratic one. Return the factor by which the light
      is multiplied.`,
    formula: "1/(a + bq + cq²)",
    hints: ["First write the polynomial in q with the coefficients a, b and c.", "More distance means less light: divide."],
    stub: body("attenuation(a, b, c, q)", "return 1;"),
    solution: body("attenuation(a, b, c, q)", "return 1 / (a + b * q + c * q * q);"),
  },
  {
    id: "reflection", title: "The reflected direction", name: "reflection", triple: true, ...PHONG,
    text: `A mirror sends light from the direction L into the direction R, on the other side of N and at the same angle.
      All directions point away from the mirror. N and L have length 1, and then R has length 1, too. Let the formula
      hold for every L, even for one behind the mirror.`,
    formula: "<b>R</b> = 2(<b>N</b>·<b>L</b>)<b>N</b> − <b>L</b>",
    hints: ["Split L into a part along N and a part across N. Which of the two changes its sign?",
      "The part of L along N is (N·L)N, which is scale(n, dot(n, l))."],
    stub: body("reflection(n, l)", "return l;"),
    solution: body("reflection(n, l)", "return sub(scale(n, 2 * dot(n, l)), l);"),
  },
  {
    id: "phong", title: "Phong’s highlight", name: "phong", ...PHONG,
    text: `A shiny surface sends most of the light into the direction R. The closer the direction V to the eye is to R,
      the brighter the highlight. A large shininess m makes the highlight small and sharp. R and V have length 1.
      Return the brightness, which is 1 in the middle of the highlight.`,
    formula: "max(0, <b>R</b>·<b>V</b>)<sup>m</sup>",
    hints: ["R·V is the cosine of the angle between R and V. What should a negative one give?",
      "In JavaScript, x ** m is x to the power of m. Take care of negative numbers first."],
    stub: body("phong(r, v, m)", "return 0;"),
    solution: body("phong(r, v, m)", "return Math.max(0, dot(r, v)) ** m;"),
  },
  {
    id: "half", title: "The half vector", name: "halfVector", triple: true, ...BLINN,
    text: `Blinn’s highlight does without R. A mirror whose normal is H would send the light straight into the eye: H is
      the direction in the middle between L and V. Return H at length 1. L and V have length 1. Where they are
      opposite, no direction is in the middle, and any three finite numbers will do.`,
    formula: "<b>H</b> = (<b>L</b> + <b>V</b>)/|<b>L</b> + <b>V</b>|",
    hints: ["Put the arrows L and V one after the other. Where does their sum point?",
      "unit(a) gives a vector length 1, and leaves the zero vector as it is."],
    stub: body("halfVector(l, v)", "return l;"),
    solution: body("halfVector(l, v)", "return unit(add(l, v));"),
  },
  {
    id: "blinn", title: "Blinn’s highlight", name: "blinn", ...BLINN,
    text: `The highlight is brightest where the normal N is the half vector H. A large shininess m makes it small and
      sharp, as in Phong’s formula. N and H have length 1. Return the brightness, which is 1 where N and H are equal.`,
    formula: "max(0, <b>N</b>·<b>H</b>)<sup>m</sup>",
    hints: ["It is Phong’s formula with another pair of vectors.",
      "In JavaScript, x ** m is x to the power of m. Take care of negative numbers first."],
    stub: body("blinn(n, h, m)", "return 0;"),
    solution: body("blinn(n, h, m)", "return Math.max(0, dot(n, h)) ** m;"),
  },
  {
    id: "spot", title: "The cone of a spot", name: "spot",
    profile: only(["lambert"], ["spot"]), scene: scene("lambert", SPOT),
    text: `A spot lights a cone and nothing else. Its axis points from the lamp into the scene, and L points from the
      surface to the lamp. Both have length 1. The angle is measured from the axis to the edge of the cone, in radians.
      Return 1 inside the cone and on its edge, and 0 outside.`,
    formula: "1 if −<b>L</b>·axis ≥ cos(angle), else 0",
    hints: ["In the middle of the cone, L and the axis are opposite. What is −L·axis there?",
      "Compare cosines, not angles: the cosine shrinks toward the edge."],
    stub: body("spot(l, axis, angle)", "return 1;"),
    solution: body("spot(l, axis, angle)", "return -dot(l, axis) >= Math.cos(angle) ? 1 : 0;"),
  },
  {
    id: "sum", title: "The sum over the lights", name: "shade", triple: true,
    profile: only(["blinn_phong"], ["directional"]), scene: scene("blinn_phong", SUN, BLUE),
    text: `Now put everything together. The scene has n, v, k_a, k_d, k_s, m, i_a and lights. Each light has its direction
      l, of length 1, and its color, intensity. Begin with the ambient light. Then add for each light what the surface
      reflects of it: Lambert’s part and Blinn’s highlight. The vectors n and v may have any length. A light behind the
      surface adds nothing, not even a highlight. Your earlier functions are not here, so write their formulas again.`,
    formula: `k<sub>a</sub> I<sub>a</sub> + Σ I (k<sub>d</sub> <b>N</b>·<b>L</b> + k<sub>s</sub>
      (<b>N</b>·<b>H</b>)<sup>m</sup>), over the lights with <b>N</b>·<b>L</b> &gt; 0`,
    hints: ["Give N and V length 1 before the loop.",
      "In the loop, skip a light with N·L ≤ 0. Then compute H, and add to the color with mul(light.intensity, …)."],
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

const BALL = "At each point of the ball in the picture, your function is asked about a surface with the normal of that point.";

/** The exercises whose function is a normal. */
export const NORMALS = [
  {
    id: "plane", title: "The normal of a plane", name: "plane", surface: "plane",
    text: `The points (x, y, z) of a plane satisfy ax + by + cz = d. Return the normal of length 1 that points to the side
      where ax + by + cz is larger. ${BALL}`,
    formula: "<b>N</b> = (a, b, c)/|(a, b, c)|",
    hints: ["Subtract the equations of two points of the plane. What does the result say about (a, b, c)?",
      "The difference of two points of the plane is perpendicular to (a, b, c)."],
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
    text: `Seen from the front, the corners v1, v2 and v3 of a triangle go around counterclockwise. Return the normal of
      length 1 that points to the front. ${BALL}`,
    formula: "<b>N</b> = (v₂ − v₁) × (v₃ − v₁), at length 1",
    hints: ["Two edges lie in the plane of the triangle. The cross product is perpendicular to both.",
      "Point the fingers of your right hand along the first edge and bend them toward the second. Your thumb points along "
        + "the cross product."],
    stub: body("triangle(v1, v2, v3)", "return [0, 0, 1];"),
    solution: body("triangle(v1, v2, v3)", "return unit(cross(sub(v2, v1), sub(v3, v1)));"),
  },
  {
    id: "implicit", title: "The normal of an implicit surface", name: "ellipsoid", surface: "ellipsoid",
    text: `An ellipsoid is where f(x, y, z) = x²/a² + y²/b² + z²/c² − 1 is 0. Its normal is the direction in which f
      grows fastest. Find the derivatives of f with respect to x, y and z. The array p is [x, y, z], a point of the
      ellipsoid, and the array axes is [a, b, c]. Return the normal at length 1. ${BALL}`,
    formula: "<b>N</b> = ∇f/|∇f|, with ∂f/∂x = 2x/a² and so on",
    hints: ["The derivative of x²/a² with respect to x is 2x/a².",
      "The factor 2 is the same in all three numbers, so unit removes it."],
    stub: body("ellipsoid(p, axes)", "return unit(p);"),
    solution: body("ellipsoid(p, axes)", "return unit(p.map((x, i) => x / axes[i] ** 2));"),
  },
  {
    id: "parametric", title: "The normal of a parametric surface", name: "torus", surface: "torus",
    text: `A torus is S(u, v) = ((R + r cos v) cos u, (R + r cos v) sin u, r sin v). Its two partial derivatives are
      tangents. Find the derivatives of S with respect to u and to v by hand, and return the normal S_u × S_v at
      length 1. ${BALL}`,
    formula: "<b>N</b> = <b>S</b><sub>u</sub> × <b>S</b><sub>v</sub>, at length 1",
    hints: ["S_u = (−(R + r cos v) sin u, (R + r cos v) cos u, 0), because v does not change.",
      "The derivative of R + r cos v is −r sin v. In S_v it is multiplied by cos u in the first number and by sin u in the "
        + "second. The third number is the derivative of r sin v."],
    stub: body("torus(u, v, R, r)", "const s_u = [1, 0, 0]; // the derivative of S with respect to u",
      "const s_v = [0, 1, 0]; // the derivative of S with respect to v", "return unit(cross(s_u, s_v));"),
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
    text: `This renderer has a common mistake. Look at the pictures: what is wrong?`,
    formula: `k<sub>a</sub> I<sub>a</sub> + Σ f s I (k<sub>d</sub> max(0, <b>N</b>·<b>L</b>) + k<sub>s</sub> highlight), where
      f is the falloff 1/(a + bq + cq²), s is 1 within the cone of a spot and 0 outside, and the highlight needs
      <b>N</b>·<b>L</b> &gt; 0`,
    hints: ["Imagine the picture without the ambient, the diffuse or the specular light. Which of the three is wrong?",
      "Check tries hundreds of scenes, and says in which kind of scene the color is wrong."],
  };
}
