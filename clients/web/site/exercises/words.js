// What a report says to a learner: what is wrong, where, a question, and the smallest scene.
import { diagram, toward } from "./diagram.js";
import { capital, element, number, value } from "./dom.js";
import { dot, RIGHT, same, unit } from "./formulas.js";

/** What wrong answers have in common that no typical one explains: what is wrong, and a question. */
const GENERAL = {
  "never a number": () => ["Your function always returns NaN, which is not a number.",
    "Do you use * or − with whole arrays? In JavaScript, vectors and colors need mul, scale, sub or dot. Or does your "
      + "code read a number that is not there, such as n[3]?"],
  "not finite": () => ["In some scenes, your function returns NaN or infinity instead of a number.",
    "Where does your code divide, or take a root or a power? Which values must not get there?"],
  nearly: () => ["Your answer is nearly right: it is off by less than one percent.",
    "Do you take a small difference for a derivative, or a rounded number such as 3.14? The formula itself is exact."],
  opposite: () => ["Your answer always has the wrong sign.",
    "In which order do you subtract, or take the cross product?"],
  length: () => ["Your direction is right, but its length is not 1.", "What is left to do to give a vector length 1?"],
  factor: ({ factor }) => [`Your answer is always ${number(factor)} times what the formula gives.`,
    "Is there a factor in your code that is not in the formula, or one in the formula that you forgot?"],
  constant: () => ["Your answer is always the same.", "Which of the values that your function is given should it depend on?"],
  other: ({ right, of }) => [
    right ? `Your answer is wrong in ${number(of - right)} of ${number(of)} calls.` : "Your answer differs from the formula.",
    "Compute the scene below by hand, step by step. At which step does your code do something else?"],
};

const POWER = ["In JavaScript, ^ is not a power. It combines the bits of two whole numbers.",
  "How do you write the square of x?"];

/** What learners may ask themselves, by the name of the mistake in the laws' table. */
const ASKS = {
  NormalNotNormalized: "A cosine needs vectors of length 1. How long is the N that the code uses?",
  NormalReversed: "Which side of the surface does N point to?",
  NormalTowardEye: "Which way should N point where the eye sees the back of the surface?",
  ViewNotNormalized: "A cosine needs vectors of length 1. How long is V?",
  ViewReversed: "V points from the surface to the eye. Where does yours point?",
  LightNotNormalized: "A cosine needs vectors of length 1. How long is L?",
  LightReversed: "L points from the surface to the light. Where does yours point?",
  PointForgotten: "L begins at the point p. Where does yours begin?",
  FastInverseRoot: "How close to 1 is the length of a vector that the code normalizes?",
  NotAttenuated: "Where does the distance q come in?",
  HighlightNotAttenuated: "Which term does not get weaker with the distance?",
  DegreesForRadians: "In what unit does Math.cos take its angle, and in what unit is it given?",
  HalfAngleHalved: "Is the angle measured from edge to edge, or from the axis to the edge?",
  ConeReversed: "L points to the lamp, and the axis away from it. What is L·axis in the middle of the cone?",
  ConeForgotten: "Which points are outside the cone, and how much light should they get?",
  ConeExponent: "How bright should the light be halfway between the axis and the edge?",
  ConeSmooth: "How bright should the light be halfway between the axis and the edge?",
  DiffuseNotClamped: "What is N·L where the light is behind the surface, and how much light should there be?",
  HighlightNotGated: "Can a light behind the surface give a highlight?",
  ReflectionReversed: "R and L are on the same side of the surface. What should R be for L = N?",
  HalfVectorNotNormalized: "How long is L + V?",
  HalfVectorUnguarded: "What does the code divide by where the light is exactly opposite the eye?",
  ShininessTimes: "What is the exponent of the highlight?",
  NormalizedByEight: "How bright should the middle of the highlight be?",
  HighlightTimesCosine: "Does the highlight of the formula have a factor N·L?",
  AmbientPerLight: "How many times should the ambient light be added if there are three lamps?",
  AmbientTimesDiffuse: "Which reflectance belongs to the ambient light?",
  UnlitWithoutLights: "What should be seen in a scene without lamps?",
  AmbientTimes: "What color should a surface have that no lamp reaches?",
  DiffuseTimes: "Which term makes a surface darker as it turns away from the light?",
  HighlightTimes: "Which term has k_s? What does the code do with it?",
  LightTimes: "Where does the color of the light come in?",
  LightsAtMost: "Does the loop reach every lamp?",
  ChannelsSwapped: "Which of the three numbers of a color is the red one?",
  Scaled: "Is there a factor that the formula does not have?",
  SrgbOnceMore: "The page encodes the colors for the screen. Should the renderer do so, too?",
};

/** Kinds of scenes that every wrong color of an exercise has in common, because all of its scenes do. */
function trivial({ lights = [], models = [] }) {
  const all = ["lights"];
  if (lights.length === 1) all.push(lights[0], ...(lights[0] === "directional" ? [] : ["lamps"]));
  if (models.length === 1) all.push({ lambert: "diffuse", phong: "Phong", blinn_phong: "Blinn" }[models[0]]);
  if (models.length === 1 && models[0] !== "lambert") all.push("highlight");
  return all;
}

/** The cause that explains nearly all wrong colors of a finding. */
const cause_of = ({ cause }) => (cause && (cause.of === 0 || cause.explained * 100 >= cause.of * 90) ? cause : null);
const id_of = (mistake) => /^\w*/.exec(mistake ?? "")[0];

const comments = /\/\/.*|\/\*[^]*?\*\//g;

/** What is wrong, and the question that leads on. */
function told({ report, diagnosis }, exercise, code) {
  if (diagnosis?.says) return [diagnosis.says, diagnosis.asks];
  if (code.replace(comments, "").includes("^")) return POWER;
  const causes = (report.findings ?? []).map(cause_of).filter(Boolean);
  const [cause] = causes;
  if (exercise.lamps && cause) {
    const ids = [cause.mistake, ...cause.alternatives].map(id_of);
    const planted = ids.includes(exercise.mistake?.id) ? exercise.mistake.id : ids[0];
    const says = ids[0] === planted ? cause.says : exercise.mistake.says;
    return [`${capital(says)}.`, ASKS[planted] ?? "Which line of the code has to do with this?"];
  }
  if (diagnosis) return GENERAL[diagnosis.general](diagnosis);
  if (cause) return [`${capital(cause.says)}.`, ASKS[id_of(cause.mistake)] ?? ""];
  return ["The colors are wrong, but not by a mistake that has a name.",
    "Follow your code line by line with the scene below. Where do its numbers depart from the formula?"];
}

/** What is what the exercise is about, and so says nothing. */
const ABOUT = { ambient: "ambient", attenuation: "attenuation", spot: "cone" };

/** The words of the report for the kinds of scenes. */
function places(report, exercise) {
  const known = [...trivial(exercise.profile), ABOUT[exercise.name], exercise.surface && "length of N"];
  const list = (report.findings ?? []).flatMap((finding) => finding.places);
  return list.map(({ only_with }) => only_with.filter((what) => !known.includes(what)))
    .filter((only) => only.length)
    .map((only) => element("p", {}, "The colors are wrong only with: ", element("b", {}, only.join(", ")), "."));
}

/** The names of what the student's function is given. */
function names(exercise) {
  const head = new RegExp(`function ${exercise.name}\\(([^)]*)\\)`).exec(exercise.solution);
  return head ? head[1].split(", ") : [];
}

function given(exercise, values) {
  const row = (name, what) => [element("dt", {}, name), element("dd", {}, what)];
  if (exercise.name !== "shade") return names(exercise).flatMap((name, i) => row(name, value(values[i])));
  const [scene] = values;
  const length = Math.hypot(...scene.n);
  return [
    row("model", { lambert: "Lambert", phong: "Phong", blinn_phong: "Blinn–Phong" }[scene.model]),
    row("n", value(scene.n) + (Math.abs(length - 1) > 1e-9 ? `, of length ${number(length)}` : "")),
    ...["v", "p", "k_a", "k_d", "k_s", "m", "i_a"].filter((name) => [scene[name]].flat().some((x) => x))
      .map((name) => row(name, value(scene[name]))),
    ...scene.lights.flatMap((light, i) => Object.entries(light).map(([name, x]) =>
      (name === "kind" ? row(`light ${i + 1}`, x) : row(name, value(x))))),
  ].flat();
}

/** What of the scene a drawing helps to understand: nothing, where the function is given no direction. */
const isDrawn = ({ name, surface }) => !surface && name !== "ambient" && name !== "attenuation";

const facing = (cosine) => (cosine < 0 ? ": the light is behind the surface" : cosine === 0 ? ": the light grazes the surface" : "");

/** The smallest scene: numbers beside a drawing. */
function smallest_case(smallest, { calls, worst }, exercise) {
  const [scene] = smallest.scenes;
  const rows = [];
  const row = (name, what) => rows.push(element("dt", {}, name), element("dd", {}, what));
  const is_wrong = ({ answer, wanted }) => !same(answer, wanted);
  const call = calls.find(is_wrong) ?? worst ?? calls[0];
  const isScene = exercise.name === "shade";
  if (call && !isScene) {
    rows.push(...given(exercise, call.given));
    row("yours", value(call.answer));
    row("formula", value(call.wanted));
  } else {
    rows.push(...(isScene ? given(exercise, [scene]) : []));
  }
  if (isDrawn(exercise)) {
    scene.lights.forEach((light, i) => {
      const cosine = dot(unit(scene.n), toward(light, scene.p));
      const index = scene.lights.length > 1 ? ` (${i + 1})` : "";
      row(`N·L${index}`, number(cosine) + facing(cosine));
    });
  }
  if (isScene) {
    row("yours", value(smallest.colors[0]));
    row("formula", value(smallest.right[0]));
  }
  const own = call && ["reflection", "halfVector"].includes(exercise.name) ? call.answer : null;
  const hasEye = isScene || scene.model !== "lambert";
  const drawing = isDrawn(exercise) ? diagram(scene, own, hasEye) : null;
  return element("div", { class: "case" }, element("dl", {}, ...rows), drawing);
}

const SIGNS = { "−": "-", "–": "-", "·": "*", "×": "*", "²": "** 2", "³": "** 3", "≥": ">=", "≤": "<=", "’": "\"", "“": "\"", "”": "\"" };
const OF_SCENE = ["n", "v", "p", "k_a", "k_d", "k_s", "m", "i_a", "lights"];

/** What stopped the code, and what to write in place of a name or a sign that JavaScript does not know. */
export function reason({ text }, exercise, code) {
  const [, name] = /(?:ReferenceError: |^)(\S+) is not defined/.exec(text) ?? [];
  const sign = /SyntaxError/.test(text)
    && /[^\s\x21-\x7e]/u.exec(code.replace(comments, ""))?.[0];
  const of = (list, name) => list.find((it) => it.toLowerCase() === name.toLowerCase());
  if (sign) {
    const instead = SIGNS[sign] ? ` In its place, write ${SIGNS[sign]}.` : "";
    return `${text.replace(/\.$/, "")}. JavaScript does not know the sign ${sign}.${instead}`;
  }
  if (!name) return text;
  const says = (what) => `${text}. ${what}`;
  const math = of(Object.getOwnPropertyNames(Math), name);
  if (exercise.name === "shade" && of(OF_SCENE, name)) return says(`Here it is scene.${of(OF_SCENE, name)}.`);
  if (exercise.name === "shade" && of(["l", "intensity"], name)) return says(`Each light has its own, such as light.${of(["l", "intensity"], name)}.`);
  if (math) return says(`In JavaScript, it is Math.${math}.`);
  if (name === exercise.name) return says(`The function must keep its name.`);
  if (name in RIGHT) return says("Your earlier functions are not here, so write the formula again.");
  return says(`Your function is given ${names(exercise).join(", ")}.`);
}

/** The headline of an answer to this code, for the eye and the ear, and the elements below it. */
export function verdict(answer, exercise, code) {
  const { report, problem } = answer;
  if (problem) {
    const line = problem.line ? ` in line ${problem.line}` : "";
    const below = problem.given?.length ? [element("p", {}, "Your function was given:"),
      element("dl", {}, ...given(exercise, problem.given))] : [];
    return { isGood: false, headline: `Your code stopped${line}: ${reason(problem, exercise, code)}`, below };
  }
  if (!report.laws) return { isGood: false, headline: `The laws could not be checked: ${report.error}`, below: [] };
  if (report.passes) {
    const { cases } = report.laws.find(({ law }) => law === "formula");
    return { isGood: true, headline: `All laws hold in each of ${number(cases)} scenes. Well done.`, below: [] };
  }
  const [says, asks] = told(answer, exercise, code);
  const smallest = report.laws.find((law) => law.smallest)?.smallest;
  const broken = report.laws.filter((law) => law.verdict === "broken");
  const counts = broken.map(({ says, failures, cases }) =>
    element("li", {}, `Broken in ${number(failures)} of ${number(cases)} scenes: ${says}.`));
  return {
    isGood: false,
    headline: says,
    asks,
    below: [
      element("p", { class: "asks" }, asks),
      ...places(report, exercise),
      ...(smallest ? [element("h3", {}, "The smallest scene in which it is wrong"), smallest_case(smallest, answer, exercise)] : []),
      element("details", {}, element("summary", {}, "The laws that are broken"), element("ul", {}, ...counts)),
    ],
  };
}
