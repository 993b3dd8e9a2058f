// Typical wrong answers, as functions. An answer that agrees with one of them wherever it was asked gets its words:
// what is wrong, and a question that leads on. The test writes each of them down as a student would.
import { add, cross, dot, mul, RIGHT, same, scale, sub, unit } from "./formulas.js";

const zero = Math.max.bind(null, 0);
const gray = (x) => [x, x, x];
const typical = (id, of, says, asks) => ({ id, of, says, asks });

const in_front = ({ n, lights }) => lights.filter(({ l }) => dot(n, l) > 0);

/** The lights before the first one that is behind the surface. */
function before_behind({ n, lights }) {
  const behind = lights.findIndex(({ l }) => dot(unit(n), l) <= 0);
  return behind < 0 ? lights : lights.slice(0, behind);
}

/** The sum over directional lights with something changed. */
function sum(change) {
  return (scene) => {
    const parts = {
      n: unit(scene.n),
      v: unit(scene.v),
      ambient: mul(scene.k_a, scene.i_a),
      each: gray(0),
      gate: (cosine) => cosine > 0,
      intensity: (light) => light.intensity,
      lights: scene.lights,
      k_d: scene.k_d,
      k_s: scene.k_s,
      m: scene.m,
      half: unit,
      diffuse: (cosine) => cosine,
      specular: (highlight) => highlight,
      specular_light: null,
      multiplied: false,
      ...change(scene),
    };
    let color = parts.ambient;
    for (const light of parts.lights) {
      const cosine = dot(parts.n, light.l);
      color = add(color, parts.each);
      if (!parts.gate(cosine)) continue;
      const highlight = zero(dot(parts.n, parts.half(add(light.l, parts.v)))) ** parts.m;
      const diffuse = scale(parts.k_d, parts.diffuse(zero(cosine)));
      const specular = scale(parts.k_s, parts.specular(highlight, cosine));
      const intensity = parts.intensity(light);
      color = add(color, parts.multiplied ? mul(intensity, mul(diffuse, specular))
        : add(mul(intensity, diffuse), mul(parts.specular_light ?? intensity, specular)));
    }
    return color;
  };
}

/** The partial derivatives of the torus. */
function partials(u, v, R, r) {
  const distance = R + r * Math.cos(v);
  return [
    [-distance * Math.sin(u), distance * Math.cos(u), 0],
    [-r * Math.sin(v) * Math.cos(u), -r * Math.sin(v) * Math.sin(u), r * Math.cos(v)],
  ];
}

/** The normal of the torus with another S_u. */
function torusBy(change) {
  return (u, v, R, r) => {
    const [s_u, s_v] = partials(u, v, R, r);
    return unit(cross(change(s_u, u, v, r), s_v));
  };
}

export const TYPICAL = {
  ambient: [
    typical("added", add,
      "You add the reflectance and the light.",
      "A black surface has k_a = 0. What does your function return for it, and what should be seen?"),
    typical("no light", (k_a) => k_a,
      "Your answer does not depend on the ambient light I_a.",
      "What should be seen in a room without any light?"),
    typical("no material", (k_a, i_a) => i_a,
      "Your answer does not depend on the surface.",
      "How does a red surface differ from a white one in the same light?"),
    typical("one channel", (k_a, i_a) => gray(k_a[0] * i_a[0]),
      "All three channels get the value of the red one.",
      "Where does your function look at the green and the blue numbers of k_a?"),
    typical("dot product", (k_a, i_a) => gray(dot(k_a, i_a)),
      "You add up the three channels, as a dot product does.",
      "Can green light make a surface look more red?"),
    typical("clamped", (k_a, i_a) => mul(k_a, i_a).map((x) => Math.min(1, x)),
      "You cut the light off at 1.",
      "More light may still be added, and a camera may still change the exposure. When is the right time to cut it off?"),
  ],
  lambert: [
    typical("no clamp", dot,
      "Your function returns negative light where the light is behind the surface.",
      "What is N·L where the light is behind the surface, and how much light should arrive there?"),
    typical("reversed", (n, l) => zero(-dot(n, l)),
      "Your surface is lit from behind, and it is dark where it faces the light.",
      "L points from the surface to the light. What is the sign of N·L on the side that faces the light?"),
    typical("absolute value", (n, l) => Math.abs(dot(n, l)),
      "The back of your surface is lit like its front.",
      "Math.abs turns −0.5 into 0.5. How much light reaches a surface whose back is toward the light?"),
    typical("squared", (n, l) => zero(dot(n, l)) ** 2,
      "Your light falls off too fast when the surface turns away: it is the square of the cosine.",
      "At 60° the cosine is 0.5. How much light should arrive there, and how much does your function give?"),
    typical("angle", (n, l) => zero(1 - Math.acos(Math.max(-1, Math.min(1, dot(n, l)))) / (Math.PI / 2)),
      "You use the angle itself, but Lambert's law uses its cosine.",
      "A beam that arrives at 60° covers twice the area. What fraction of the light does each point get?"),
    typical("angle in radians", (n, l) => Math.acos(dot(n, l)),
      "You use the angle itself, but Lambert's law uses its cosine.",
      "A beam that arrives at 60° covers twice the area. What fraction of the light does each point get?"),
    typical("wrapped", (n, l) => 0.5 + 0.5 * dot(n, l),
      "Your light reaches around to the back of the surface.",
      "At 90° the light only grazes the surface. How much should arrive there?"),
    typical("minimum", (n, l) => Math.min(0, dot(n, l)),
      "You keep the negative half of N·L and throw away the positive one.",
      "Which is larger, 0 or −0.5, and which of the two should be returned?"),
    typical("not clamped on one side", (n, l) => Math.min(1, dot(n, l)),
      "You limit the cosine from above, but it needs a limit from below.",
      "How large can a cosine get, and how small? Which of the two cannot be light?"),
    typical("step", (n, l) => Number(dot(n, l) > 0),
      "Every point that faces the light gets all of it, at any angle.",
      "A beam that arrives at 60° covers twice the area. What fraction of the light does each point get?"),
    typical("cosine of the cosine", (n, l) => Math.cos(dot(n, l)),
      "You take the cosine of a cosine.",
      "N and L have length 1. What is dot(n, l) then: an angle, or its cosine?"),
  ],
  attenuation: [
    typical("not squared", (a, b, c, q) => 1 / (a + b * q + c * q),
      "Your last term grows with the distance, not with its square.",
      "At twice the distance, the light of a small lamp spreads over four times the area. Which term says so?"),
    typical("square on b", (a, b, c, q) => 1 / (a + b * q * q + c * q),
      "The coefficients b and c have changed places.",
      "Which of the three coefficients belongs to the square of the distance?"),
    typical("no reciprocal", (a, b, c, q) => a + b * q + c * q * q,
      "Your light gets stronger with the distance.",
      "The polynomial grows with q. What must you do with it, so that the light gets weaker?"),
    typical("inverse square", (a, b, c, q) => 1 / (q * q),
      "Your function is the pure inverse square, whatever a, b and c are.",
      "What happens very near the lamp, where q is close to 0? What could the coefficient a do about it?"),
    typical("no constant", (a, b, c, q) => 1 / (b * q + c * q * q),
      "The coefficient a is missing.",
      "What does your function return if b and c are both 0?"),
    typical("squared as a whole", (a, b, c, q) => 1 / (a + b * q + c * q * q) ** 2,
      "You square the whole denominator, and not the distance alone.",
      "What should be left of the light if a = 2 and b = c = 0?"),
    typical("clamped", (a, b, c, q) => Math.min(1, 1 / (a + b * q + c * q * q)),
      "You limit the answer to 1. Some books do, but the formula of this exercise does not.",
      "What should be returned for a = 0.5, b = 0, c = 0?"),
    typical("none", () => 1,
      "Your light does not get weaker with the distance.",
      "Where is q in your formula?"),
    typical("no parentheses", (a, b, c, q) => 1 / a + b * q + c * q * q,
      "Only a is in the denominator.",
      "JavaScript divides before it adds. Where are parentheses missing?"),
    typical("a and c exchanged", (a, b, c, q) => 1 / (a * q * q + b * q + c),
      "The coefficients a and c have changed places.",
      "Which of the three coefficients belongs to the square of the distance?"),
    typical("no linear term", (a, b, c, q) => 1 / (a + c * q * q),
      "The coefficient b is missing.",
      "What does your function return if a and c are both 0?"),
    typical("no quadratic term", (a, b, c, q) => 1 / (a + b * q),
      "The coefficient c is missing.",
      "What does your function return if a and b are both 0?"),
  ],
  reflection: [
    typical("reversed", (n, l) => sub(l, scale(n, 2 * dot(n, l))),
      "Your R points into the surface: it is the opposite of the right one.",
      "Take a light straight above, L = N. Which way should R point then?"),
    typical("no two", (n, l) => sub(scale(n, dot(n, l)), l),
      "Your R lies in the mirror: you go only half of the way from −L to R.",
      "(N·L)N is the part of L along N. How many times do you need it to get from −L to R?"),
    typical("no projection", (n, l) => sub(scale(n, 2), l),
      "You use N itself in place of the part of L along N.",
      "What should R be for a light that grazes the surface, where N·L = 0?"),
    typical("opposite", (n, l) => scale(l, -1),
      "You turn L around, and so you mirror it in a point.",
      "Which part of L should keep its sign: the one along N, or the one across N?"),
    typical("sum", (n, l) => add(scale(n, 2 * dot(n, l)), l),
      "You add L, and so your R does not have length 1.",
      "For L = N the formula should return N. What does yours return?"),
    typical("exchanged", (n, l) => sub(scale(l, 2 * dot(n, l)), n),
      "You mirror N about L, but L should be mirrored about N.",
      "Which of the two is the axis of the mirror?"),
    typical("not mirrored", (n, l) => l,
      "Your R is still L itself.",
      "On which side of N is L, and on which side should R be?"),
    typical("clamped", (n, l) => sub(scale(n, 2 * zero(dot(n, l))), l),
      "You clamp N·L, and so your R is wrong where L is behind the mirror.",
      "R is a direction, not light. Which directions may not have a negative part along N?"),
    typical("not subtracted", (n, l) => scale(n, 2 * dot(n, l)),
      "Your R always points along N.",
      "2(N·L)N leads from −L to R. From where do you have to start?"),
  ],
  phong: [
    typical("no clamp", (r, v, m) => dot(r, v) ** m,
      "You raise a negative cosine to a power.",
      "What is the sign of R·V where V points away from R, and what is (−0.5)²?"),
    typical("no power", (r, v) => zero(dot(r, v)),
      "The shininess m has no effect.",
      "What should happen to the highlight when m grows from 1 to 100?"),
    typical("times m", (r, v, m) => zero(dot(r, v)) * m,
      "You multiply by m. Your highlight gets brighter with m, and no smaller.",
      "In the middle of the highlight R·V = 1. How bright should it be there, for any m?"),
    typical("absolute value", (r, v, m) => Math.abs(dot(r, v)) ** m,
      "You have a second highlight on the far side, where R points away from the eye.",
      "What should be seen where R·V is −1?"),
    typical("clamped afterward", (r, v, m) => zero(dot(r, v) ** m),
      "You take the power first and remove the negative numbers afterward.",
      "(−0.5)² is positive. Can your function still see that the cosine was negative?"),
    typical("exchanged", (r, v, m) => m ** zero(dot(r, v)),
      "Base and exponent have changed places.",
      "Which of the two should be the exponent, so that the highlight gets smaller as m grows?"),
    typical("exchanged, no clamp", (r, v, m) => m ** dot(r, v),
      "Base and exponent have changed places.",
      "Which of the two should be the exponent, so that the highlight gets smaller as m grows?"),
    typical("power times m", (r, v, m) => m * zero(dot(r, v)) ** m,
      "You multiply by m, and so your highlight gets brighter with m.",
      "In the middle of the highlight R·V = 1. How bright should it be there, for any m?"),
    typical("reversed", (r, v, m) => zero(-dot(r, v)) ** m,
      "Your highlight is on the far side.",
      "What is R·V in the middle of the highlight: 1 or −1?"),
    typical("half", (r, v, m) => zero(dot(r, v)) ** (m / 2),
      "Your highlight is too wide: it has half the exponent.",
      "What is the exponent in your code?"),
  ],
  halfVector: [
    typical("not normalized", add,
      "Your H does not have length 1.",
      "How long is L + V if both are equal, and how long if they are perpendicular?"),
    typical("average", (l, v) => scale(add(l, v), 0.5),
      "Your H is the average of L and V, which is shorter than 1.",
      "Half the sum has length 1 only if L = V. What should you divide by?"),
    typical("difference", (l, v) => unit(sub(l, v)),
      "You take the difference of L and V, which points from one to the other.",
      "Draw L and V as arrows from one point. Where does the arrow in the middle between them point?"),
    typical("other difference", (l, v) => unit(sub(v, l)),
      "You take the difference of V and L, which points from one to the other.",
      "Draw L and V as arrows from one point. Where does the arrow in the middle between them point?"),
    typical("unguarded", (l, v) => scale(add(l, v), 1 / Math.hypot(...add(l, v))),
      "Your code divides by 0 where the light is exactly opposite the eye.",
      "What is L + V for L = −V? Which finite numbers could your function return there?"),
    typical("cross product", (l, v) => unit(cross(l, v)),
      "The cross product is perpendicular to L and to V, so it is not between them.",
      "Which operation gives a vector that leans toward both?"),
    typical("only L", (l) => l,
      "Your H does not depend on the eye.",
      "Should the highlight move when the viewer walks around the object?"),
    typical("only V", (l, v) => v,
      "Your H does not depend on the light.",
      "Should the highlight move when the lamp does?"),
    typical("root of two", (l, v) => scale(add(l, v), Math.SQRT1_2),
      "You divide by √2, which is right only where L and V are perpendicular.",
      "How long is L + V if L and V are equal?"),
  ],
  blinn: [
    typical("no clamp", (n, h, m) => dot(n, h) ** m,
      "You raise a negative cosine to a power.",
      "What is the sign of N·H where H points into the surface, and what is (−0.5)²?"),
    typical("no power", (n, h) => zero(dot(n, h)),
      "The shininess m has no effect.",
      "What should happen to the highlight when m grows from 1 to 100?"),
    typical("times m", (n, h, m) => zero(dot(n, h)) * m,
      "You multiply by m. Your highlight gets brighter with m, and no smaller.",
      "In the middle of the highlight N·H = 1. How bright should it be there, for any m?"),
    typical("absolute value", (n, h, m) => Math.abs(dot(n, h)) ** m,
      "You have a second highlight, on the back of the surface.",
      "What should be seen where N·H is −1?"),
    typical("clamped afterward", (n, h, m) => zero(dot(n, h) ** m),
      "You take the power first and remove the negative numbers afterward.",
      "(−0.5)² is positive. Can your function still see that the cosine was negative?"),
    typical("four times", (n, h, m) => zero(dot(n, h)) ** (4 * m),
      "Your exponent is 4m. That makes the highlight about as small as Phong's, but this formula has no 4.",
      "What is the exponent of the formula?"),
    typical("exchanged", (n, h, m) => m ** zero(dot(n, h)),
      "Base and exponent have changed places.",
      "Which of the two should be the exponent, so that the highlight gets smaller as m grows?"),
    typical("exchanged, no clamp", (n, h, m) => m ** dot(n, h),
      "Base and exponent have changed places.",
      "Which of the two should be the exponent, so that the highlight gets smaller as m grows?"),
    typical("power times m", (n, h, m) => m * zero(dot(n, h)) ** m,
      "You multiply by m, and so your highlight gets brighter with m.",
      "In the middle of the highlight N·H = 1. How bright should it be there, for any m?"),
    typical("reversed", (n, h, m) => zero(-dot(n, h)) ** m,
      "Your highlight is on the far side.",
      "What is N·H in the middle of the highlight: 1 or −1?"),
  ],
  spot: [
    typical("reversed", (l, axis, angle) => (dot(l, axis) >= Math.cos(angle) ? 1 : 0),
      "Your cone opens to the back of the lamp.",
      "In the middle of the cone, L points to the lamp and the axis away from it. What is L·axis there?"),
    typical("halved", (l, axis, angle) => (-dot(l, axis) >= Math.cos(angle / 2) ? 1 : 0),
      "Your cone is half as wide as it should be.",
      "From where to where is the angle measured: from edge to edge, or from the axis to the edge?"),
    typical("degrees", (l, axis, angle) => (-dot(l, axis) >= Math.cos(angle * Math.PI / 180) ? 1 : 0),
      "You convert the angle from degrees, but it is in radians already.",
      "In what unit does Math.cos take its angle?"),
    typical("outside", (l, axis, angle) => (-dot(l, axis) <= Math.cos(angle) ? 1 : 0),
      "Your lamp lights everything outside of its cone.",
      "The cosine is 1 on the axis. Does it grow or shrink toward the edge?"),
    typical("no cosine", (l, axis, angle) => (-dot(l, axis) >= angle ? 1 : 0),
      "You compare a cosine with an angle.",
      "−L·axis is the cosine of the angle to the axis. What must it be compared with?"),
    typical("fading", (l, axis, angle) => (-dot(l, axis) >= Math.cos(angle) ? -dot(l, axis) : 0),
      "Your light fades toward the edge. Some lamps do this, but not the one here.",
      "What should the function return for every point within the cone?"),
    typical("no cone", () => 1,
      "Your lamp lights everything, as if it had no cone.",
      "Which points are outside of the cone, and what should be returned for them?"),
    typical("sine", (l, axis, angle) => (-dot(l, axis) >= Math.sin(angle) ? 1 : 0),
      "You compare the cosine with a sine.",
      "A very narrow cone has an angle near 0. How large is its cosine, and how large its sine?"),
    typical("doubled", (l, axis, angle) => (-dot(l, axis) >= Math.cos(2 * angle) ? 1 : 0),
      "Your cone is twice as wide as it should be.",
      "From where to where is the angle measured: from edge to edge, or from the axis to the edge?"),
    typical("both sides", (l, axis, angle) => Number(Math.abs(dot(l, axis)) >= Math.cos(angle)),
      "Your lamp lights a second cone behind it.",
      "What is −L·axis behind the lamp, and what does Math.abs make of it?"),
    typical("no edge", (l, axis) => zero(-dot(l, axis)),
      "Your light does not depend on the angle of the cone.",
      "Which points are outside of the cone, and what should be returned for them?"),
    typical("angle of more than 1", (l, axis, angle) => Number(Math.acos(-dot(l, axis)) <= angle),
      "Your formula is right, but a rounded cosine may be a little above 1, and then it has no angle.",
      "What does Math.acos(1.0000000000000002) return? Could you compare cosines and do without Math.acos?"),
    typical("into degrees", (l, axis, angle) => Number(-dot(l, axis) >= Math.cos(angle * 180 / Math.PI)),
      "You convert the angle into degrees, but Math.cos takes radians.",
      "In what unit is the angle given?"),
  ],
  shade: [
    typical("ambient per light", sum((s) => ({ ambient: gray(0), each: mul(s.k_a, s.i_a) })),
      "You add the ambient light once for every lamp.",
      "How much ambient light should there be with three lamps, and how much with none?"),
    typical("no ambient", sum(() => ({ ambient: gray(0) })),
      "The ambient light is missing.",
      "What color should a surface have that no lamp reaches?"),
    typical("highlight from behind", sum(() => ({ gate: () => true })),
      "A light behind the surface still makes a highlight.",
      "N·H can be positive although N·L is negative. Which of the two says that the light is behind?"),
    typical("no intensity", sum(() => ({ intensity: () => gray(1) })),
      "The color of the light has no effect.",
      "What does a white surface look like in blue light?"),
    typical("last light", sum((s) => ({ lights: s.lights.slice(-1) })),
      "Only the last light counts.",
      "Does each light add to what is there, or does it replace it?"),
    typical("last light in front", sum((s) => ({ lights: in_front(s).slice(-1) })),
      "Only the last light counts.",
      "Does each light add to what is there, or does it replace it?"),
    typical("first light", sum((s) => ({ lights: s.lights.slice(0, 1) })),
      "Only the first light counts.",
      "Is there a return inside the loop?"),
    typical("first light in front", sum((s) => ({ lights: in_front(s).slice(0, 1) })),
      "Only the first light counts.",
      "Is there a return inside the loop?"),
    typical("ambient alone", (s) => mul(s.k_a, s.i_a),
      "Only the ambient light counts.",
      "What does each of scene.lights add to it?"),
    typical("long half vector", sum(() => ({ half: (x) => x })),
      "You use L + V as the half vector, but its length is not 1.",
      "How long is L + V if both are equal? What does that do to the power?"),
    typical("long normal", sum((s) => ({ n: s.n })),
      "You use the normal as it comes, but its length is not 1.",
      "scene.n may have any length. What happens to N·L if N is twice as long?"),
    typical("long vectors", sum((s) => ({ n: s.n, v: s.v })),
      "You use n and v as they come, but their lengths are not 1.",
      "scene.n and scene.v may have any length. What happens to N·L if N is twice as long?"),
    typical("long vectors and a highlight from behind", sum((s) => ({ n: s.n, v: s.v, gate: () => true })),
      "You use n and v as they come, but their lengths are not 1.",
      "scene.n and scene.v may have any length. What happens to N·L if N is twice as long?"),
    typical("long normal and a highlight from behind", sum((s) => ({ n: s.n, gate: () => true })),
      "You use the normal as it comes, but its length is not 1.",
      "scene.n may have any length. What happens to N·L if N is twice as long?"),
    typical("long view and a highlight from behind", sum((s) => ({ v: s.v, gate: () => true })),
      "You use v as it comes, but its length is not 1.",
      "scene.v may have any length. What does L + V lean toward if V is very long?"),
    typical("last light alone", sum((s) => (s.lights.length ? { ambient: gray(0), lights: s.lights.slice(-1) } : {})),
      "Only the last light counts, and the ambient light is lost.",
      "Does each light add to what is there, or does it replace it?"),
    typical("highlight without color", sum(() => ({ specular_light: gray(1) })),
      "Your highlight does not depend on the color of the light.",
      "Which of the terms does the color of the light belong to: one of them, or the sum?"),
    typical("highlight by k_d", sum((s) => ({ k_s: s.k_d })),
      "Your highlight has the color of k_d.",
      "Which number says how much of the light the highlight reflects?"),
    typical("terms multiplied", sum(() => ({ multiplied: true })),
      "You multiply the diffuse light by the highlight.",
      "What should be left of a matte surface, whose k_s is 0?"),
    typical("no diffuse light", sum(() => ({ k_d: gray(0) })),
      "The diffuse light is missing.",
      "Which term of the formula has k_d?"),
    typical("no highlight", sum(() => ({ k_s: gray(0) })),
      "The highlight is missing.",
      "Which term of the formula has k_s?"),
    typical("long view", sum((s) => ({ v: s.v })),
      "You use v as it comes, but its length is not 1.",
      "scene.v may have any length. What does L + V lean toward if V is very long?"),
    typical("view reversed", sum((s) => ({ v: unit(scale(s.v, -1)) })),
      "Your V points from the eye to the surface.",
      "Which way does scene.v point already?"),
    typical("no power", sum(() => ({ m: 1 })),
      "The shininess m has no effect.",
      "What should happen to the highlight when m grows from 1 to 100?"),
    typical("no cosine", sum(() => ({ diffuse: () => 1 })),
      "Lambert's cosine is missing.",
      "Which term makes a surface darker as it turns away from the light?"),
    typical("k_d and k_s exchanged", sum((s) => ({ k_d: s.k_s, k_s: s.k_d })),
      "k_d and k_s have changed places.",
      "Which of the two belongs to the highlight?"),
    typical("highlight times the cosine", sum(() => ({ specular: (highlight, cosine) => cosine * highlight })),
      "You multiply the highlight by N·L, too.",
      "Which of the two terms of the formula has a factor N·L?"),
    typical("ends at a light behind", sum((s) => ({ lights: before_behind(s) })),
      "Your loop ends at the first light behind the surface.",
      "Which statement skips one light and goes on with the next: break, return or continue?"),
    typical("ambient without k_a", sum((s) => ({ ambient: s.i_a })),
      "Your ambient light does not depend on the surface.",
      "How does a red surface differ from a white one in the same ambient light?"),
    typical("clamped", (scene) => RIGHT.shade(scene).map((x) => Math.min(1, x)),
      "You cut the light off at 1.",
      "More light may still be added, and a camera may still change the exposure. When is the right time to cut it off?"),
    typical("one channel", (scene) => gray(RIGHT.shade(scene)[0]),
      "All three channels get the value of the red one.",
      "Where does your code use the green and the blue numbers?"),
  ],
  plane: [
    typical("not normalized", (a, b, c) => [a, b, c],
      "Your normal points the right way, but its length is not 1.",
      "2x + 2y = 4 and x + y = 2 are the same plane. Does your function give them the same normal?"),
    typical("reversed", (a, b, c) => unit([-a, -b, -c]),
      "Your normal points to the other side of the plane.",
      "In which direction does ax + by + cz grow?"),
    typical("with d", (a, b, c, d) => scale([a, b, c], 1 / d),
      "You divide by d, which says only where the plane is.",
      "Does the normal turn when the plane is shifted?"),
    typical("sum of the coefficients", (a, b, c) => scale([a, b, c], 1 / (a + b + c)),
      "You divide by the sum of the coefficients, which is not the length.",
      "How long is the vector (3, 4, 0)?"),
    typical("square of the length", (a, b, c) => scale([a, b, c], 1 / (a * a + b * b + c * c)),
      "You divide by the square of the length: a root is missing.",
      "How long is your normal for 2x = 4?"),
    typical("intercepts", (a, b, c, d) => unit([d / a, d / b, d / c]),
      "You take the points where the plane cuts the axes.",
      "Which vector is perpendicular to everything that lies in the plane?"),
  ],
  sphere: [
    typical("not normalized", (center, p) => sub(p, center),
      "Your normal points the right way, but it is as long as the radius.",
      "How long is p − center on a sphere of radius 5?"),
    typical("reversed", (center, p) => unit(sub(center, p)),
      "Your normal points into the sphere.",
      "The difference b − a points from a to b. From where to where should the normal point?"),
    typical("no center", (center, p) => unit(p),
      "You leave out the center, but the center may be anywhere.",
      "What should the normal be if the sphere is moved, and the point with it?"),
    typical("sum", (center, p) => unit(add(p, center)),
      "You add the center, which shifts the point the wrong way.",
      "Which vector leads from the center to p?"),
    typical("square of the radius", (center, p) => {
      const d = sub(p, center);
      return scale(d, 1 / dot(d, d));
    },
    "You divide by the square of the radius: a root is missing.",
    "How long is your normal on a sphere of radius 2?"),
    typical("constant", () => [0, 0, 1],
      "Your normal is the same everywhere.",
      "What is the normal at the leftmost point of the sphere?"),
  ],
  triangle: [
    typical("reversed", (v1, v2, v3) => unit(cross(sub(v3, v1), sub(v2, v1))),
      "Your normal points to the back of the triangle.",
      "a × b and b × a are opposite. Which of the two edges comes first?"),
    typical("not normalized", (v1, v2, v3) => cross(sub(v2, v1), sub(v3, v1)),
      "Your normal points the right way, but its length is not 1.",
      "How long is the cross product of two edges? Think of the area."),
    typical("corners", (v1, v2) => unit(cross(v1, v2)),
      "You take the cross product of corners, but a corner is a point, not a direction.",
      "Which vectors lie in the plane of the triangle?"),
    typical("middle", (v1, v2, v3) => unit(add(add(v1, v2), v3)),
      "You take the direction of the middle of the triangle, as if it were on a sphere.",
      "Which vectors lie in the plane of the triangle?"),
    typical("edges normalized", (v1, v2, v3) => cross(unit(sub(v2, v1)), unit(sub(v3, v1))),
      "You normalize the edges, but their cross product still does not have length 1.",
      "If a and b have length 1, the length of a × b is the sine of the angle between them. When is that 1?"),
    typical("product of the edges", (v1, v2, v3) => unit(mul(sub(v2, v1), sub(v3, v1))),
      "You multiply the edges number by number, which gives no useful direction.",
      "Which product of two vectors is perpendicular to both?"),
    typical("constant", () => [0, 0, 1],
      "Your normal is the same for every triangle.",
      "Which vectors lie in the plane of the triangle?"),
  ],
  ellipsoid: [
    typical("sphere", (p) => unit(p),
      "That is the normal of a sphere.",
      "On a flat disk nearly every normal points up or down. Does your formula know how flat the ellipsoid is?"),
    typical("not squared", (p, axes) => unit(p.map((x, i) => x / axes[i])),
      "You divide by the axes, and not by their squares.",
      "What is the derivative of x²/a² with respect to x?"),
    typical("multiplied", (p, axes) => unit(p.map((x, i) => x * axes[i] ** 2)),
      "You multiply by the squares of the axes, where you should divide.",
      "Where the ellipsoid is long in x, is it steep or flat there? What does that say about the x of the normal?"),
    typical("not normalized", (p, axes) => p.map((x, i) => 2 * x / axes[i] ** 2),
      "Your gradient is right, but its length is not 1.",
      "What is left to do to make a gradient a normal of length 1?"),
    typical("not normalized, halved", (p, axes) => p.map((x, i) => x / axes[i] ** 2),
      "Your gradient points the right way, but its length is not 1.",
      "What is left to do to make a gradient a normal of length 1?"),
    typical("reversed", (p, axes) => unit(p.map((x, i) => -x / axes[i] ** 2)),
      "Your normal points into the ellipsoid.",
      "f is below 0 inside and above 0 outside. In which direction does it grow?"),
    typical("not derived", (p, axes) => unit(p.map((x, i) => (x / axes[i]) ** 2)),
      "You use the terms of f themselves, and not their derivatives.",
      "What is the derivative of x²/a² with respect to x?"),
  ],
  torus: [
    typical("reversed", (u, v, R, r) => unit(cross(...partials(u, v, R, r).reverse())),
      "Your normal points into the torus.",
      "a × b and b × a are opposite. Which of the two tangents comes first?"),
    typical("not normalized", (u, v, R, r) => cross(...partials(u, v, R, r)),
      "Your normal points the right way, but its length is not 1.",
      "What is left to do to give the cross product length 1?"),
    typical("point", (u, v, R, r) => {
      const distance = R + r * Math.cos(v);
      return unit([distance * Math.cos(u), distance * Math.sin(u), r * Math.sin(v)]);
    },
    "You return the direction of the point, as if the torus were a sphere.",
    "Which two vectors lie along the surface at S(u, v)?"),
    typical("tangent along u", (u, v, R, r) => unit(partials(u, v, R, r)[0]),
      "You return a tangent: it lies along the surface.",
      "Which vector is perpendicular to both tangents?"),
    typical("tangent along v", (u, v, R, r) => unit(partials(u, v, R, r)[1]),
      "You return a tangent: it lies along the surface.",
      "Which vector is perpendicular to both tangents?"),
    typical("sign of a derivative", (u, v, R, r) => {
      const [s_u, s_v] = partials(u, v, R, r);
      return unit(cross(s_u, [-s_v[0], -s_v[1], s_v[2]]));
    },
    "One of your partial derivatives has the wrong sign.",
    "What is the derivative of cos v?"),
    typical("sign of the other derivative", torusBy(([x, ...yz]) => [-x, ...yz]),
      "Your S_u has a wrong sign.",
      "What is the derivative of cos u?"),
    typical("no R", torusBy((s_u, u, v, r) => [-r * Math.cos(v) * Math.sin(u), r * Math.cos(v) * Math.cos(u), 0]),
      "Your S_u is without R.",
      "While only u changes, S goes around a circle. How large is its radius?"),
    typical("not derived by u", torusBy(([x, y], u, v, r) => [x, y, r * Math.sin(v)]),
      "The third number of your S_u is not 0.",
      "Does r sin v change while only u does?"),
    typical("R derived to R", (u, v, R, r) => {
      const [s_u, [,, z]] = partials(u, v, R, r);
      const s = R - r * Math.sin(v);
      return unit(cross(s_u, [s * Math.cos(u), s * Math.sin(u), z]));
    },
    "Your S_v still has R in it.",
    "What is the derivative of a constant?"),
    typical("angles exchanged", (u, v, R, r) => RIGHT.torus(v, u, R, r),
      "u and v have changed places.",
      "Which of the two angles goes around the axis of the torus, and which around its tube?"),
  ],
};

/**
 * What an answer has in common with others, from the calls in which it was asked; null if it was right in all.
 * A call is what the function was given, its answer, and the right one.
 */
export function diagnose(name, calls) {
  const wrong = calls.filter(({ answer, wanted }) => !same(answer, wanted));
  if (!wrong.length) return null;
  const often = (test, of) => of.filter(test).length >= 0.99 * of.length;
  const isConstant = calls.every(({ answer }) => same(answer, calls[0].answer));
  // calls in which both are right tell nothing of whether the two are the same
  const fits = ({ of }) => {
    const judged = calls.map(({ given, answer, wanted }) => ({ answer, wanted, typical: of(...given) }));
    const telling = judged.filter(({ answer, wanted, typical }) => !same(answer, wanted) || !same(typical, wanted));
    const test = ({ answer, typical }) => same(answer, typical);
    return isConstant ? telling.every(test) : often(test, telling);
  };
  const known = TYPICAL[name]?.find(fits);
  if (known) return { says: known.says, asks: known.asks };
  const flat = (x) => [x].flat();
  const isNaN = ({ answer }) => flat(answer).some(Number.isNaN);
  if (calls.every(isNaN)) return { general: "never a number" };
  if (wrong.every(({ answer }) => flat(answer).some((x) => !Number.isFinite(x)))) return { general: "not finite" };
  if (isConstant) return { general: "constant" };
  if (often(({ answer, wanted }) => same(answer, wanted, 1e-2), wrong)) return { general: "nearly" };
  if (often(({ answer, wanted }) => same(answer, flat(wanted).map((x) => -x)), calls)) return { general: "opposite" };
  const isTriple = Array.isArray(wrong[0].wanted);
  if (isTriple && name !== "ambient" && name !== "shade"
    && often(({ answer, wanted }) => same(unit(answer), unit(wanted)), calls)) return { general: "length" };
  const ratio = ({ answer, wanted }) => {
    const at = flat(wanted).findIndex((x) => Math.abs(x) > 1e-3);
    return at < 0 ? null : flat(answer)[at] / flat(wanted)[at];
  };
  const factor = wrong.map(ratio).find((x) => x !== null);
  const isTimes = ({ answer, wanted }) => same(answer, flat(wanted).map((x) => factor * x), 1e-5);
  if (Number.isFinite(factor) && factor !== 0 && often(isTimes, calls)) return { general: "factor", factor };
  return { general: "other", right: calls.length - wrong.length, of: calls.length };
}
