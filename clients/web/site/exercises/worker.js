// Runs the student's code beside the laws. The page makes a function of this text and what it imports, and gives it
// `student`, which finds the student's function. The page listens to a port that the student's code cannot reach.
import { add, cross, dot, mul, RIGHT, same, scale, shadeBy, sub, unit } from "./formulas.js";
import { numbersOf, profileOf, write } from "./module.js";
import { diagnose } from "./typical.js";

const WARM = 60; // random scenes of the first run of the laws
const MOST_CALLS = 600; // that are looked at to find what a wrong answer has in common with others

const { structuredClone: copy } = self; // JSON has no NaN

function shown(x) {
  if (x === undefined) return "nothing";
  if (typeof x === "function") return "a function";
  if (typeof x === "string") return "a string";
  if (typeof x !== "object") return `the ${typeof x} ${typeof x === "number" ? Number(x.toPrecision(4)) : String(x)}`;
  if (!Array.isArray(x)) return "an object";
  return x.every((c) => typeof c === "number") ? `an array of ${x.length}` : "an array in which not everything is a number";
}

// what * and + make of arrays
const NUMBER = " To multiply an array by a number, use scale(array, number).";
const isOfArrays = (x) => typeof x === "string" || Number.isNaN(x);
const USE = " JavaScript does not compute with whole arrays: use add, sub, mul, scale or dot.";

const isList = (x) => Array.isArray(x) && x.every((c) => typeof c === "number");

/** A function for the student, which says what is wrong with what it is given. */
function helper(name, of) {
  const isWanted = (x, i) => (name === "scale" && i === 1 ? typeof x === "number" : isList(x));
  const want = { scale: "an array and a number", unit: "one array of numbers" }[name] ?? "two arrays of numbers";
  return (...given) => {
    for (let i = 0; i < of.length; i++) {
      if (isWanted(given[i], i)) continue;
      const more = isOfArrays(given[i]) ? USE : (name === "mul" || name === "scale") && typeof given[i] === "number" ? NUMBER : "";
      throw new TypeError(`${name} takes ${want}, but it was given ${shown(given[i])}.${more}`);
    }
    return of(...given);
  };
}

// the student may give these names a meaning of their own
for (const [name, of] of Object.entries({ add, sub, mul, scale, dot, cross, unit })) self[name] = helper(name, of);

/** Three numbers as an array of our own, since a getter of the student's might answer each time something else. */
function triple_of(x) {
  if (!Array.isArray(x) || x.length !== 3) return null;
  const [a, b, c] = [x[0], x[1], x[2]];
  return typeof a === "number" && typeof b === "number" && typeof c === "number" ? [a, b, c] : null;
}

/** What the page says of an answer; nothing that the student's code throws is one. */
class Refusal extends Error {}

/** What the student's code made, which may be anything: what `of` makes of it, or else this. */
function anything(of, instead) {
  try {
    return of();
  } catch {
    return instead;
  }
}

/** The student's function, whose answer is a number or three of them. */
function checked(name, of, isOfTriples, calls) {
  const want = isOfTriples ? "an array of three numbers" : "a number";
  return (...given) => {
    const kept = calls.length < MOST_CALLS ? copy(given) : null; // the student's code may change what it is given
    calls.last = kept ?? given;
    const returned = of(...given);
    const answer = isOfTriples ? triple_of(returned) : typeof returned === "number" ? returned : null;
    if (answer === null) {
      const text = returned === undefined ? `${name} returned nothing. Is there a return in every branch?`
        : `${name} should return ${want}, but it returned ${shown(returned)}.${isOfArrays(returned) ? USE : ""}`;
      throw new Refusal(text);
    }
    if (kept) calls.push({ given: kept, answer });
    return answer;
  };
}

const encoded = (x) => 255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055);

// what the student's code may replace
const now = performance.now.bind(performance);
const { parse } = JSON;
const decode = TextDecoder.prototype.decode.bind(new TextDecoder());
const Bytes = Uint8Array;
const Numbers = Float64Array;

let shadeAll = () => 1;
let heard = () => {};
const page = {
  shade_all: (at, length, out) => shadeAll(at, length, out),
  goes_on: (asked, of, broken) => heard(asked, of, broken),
};
let exports;
const bytes = (at, length) => new Bytes(exports.memory.buffer, at, length);
const scenes_at = (at, length) => parse(`[${decode(bytes(at, length))}]`);
function answer_at(out, colors) {
  new Numbers(exports.memory.buffer, out, colors.length).set(colors);
  return 0;
}

/** Runs the laws on the right formula, so that the browser has compiled them when the student's code comes. */
function warmUp() {
  shadeAll = (at, length, out) => answer_at(out, scenes_at(at, length).flatMap((scene) => shadeBy(RIGHT, scene, {})));
  exports.check(...profileOf({ models: ["blinn_phong"], lights: ["directional"] }), 0, WARM, 0);
}

self.onmessage = ({ data: { module, isWarm } }) => {
  exports = new WebAssembly.Instance(module, { page }).exports;
  if (isWarm) warmUp();
  self.onmessage = run;
  self.postMessage("warm");
};

/** Draws or checks the student's code. */
function run({ data, ports: [port] }) {
  self.onmessage = null;
  const { exercise, what, size, cases, seed, code, mistake } = data;
  const { name, triple, profile, surface, ungated } = exercise;
  const say = port.postMessage.bind(port);
  const start = now();
  say({ busy: true }); // from here on, the time is the student's
  importScripts(code); // an error of the syntax goes to the page, with its line
  say({ busy: false });

  const calls = [];
  const theirs = checked(name, (...given) => student()(...given), triple, calls);
  const parts = { ...RIGHT, [name]: theirs };
  const shade = name === "shade" ? theirs : (scene) => shadeBy(parts, scene, { surface, ungated });
  let problem;
  function attempt(scene) {
    try {
      return shade(scene);
    } catch (error) {
      const frames = anything(() => String(error?.stack), "").split(`${code}:`); // begin with their lines, the innermost first
      // a stack may overflow at a call or at the head of what is called; below it is a call in either case
      const isDeep = /call stack|recursion/.test(anything(() => String(error?.message), "")) && frames.length > 2;
      const isOurs = error instanceof Refusal;
      const text = isDeep ? "A function calls itself without end." : isOurs ? error.message
        : anything(() => String(error), "It threw something that cannot be shown.");
      const line = isOurs ? 0 : parseInt(frames[isDeep ? 2 : 1], 10);
      problem = { text, line: line || null, given: anything(() => copy(calls.last), []) };
      return null;
    }
  }

  shadeAll = (at, length, out) => {
    const scenes = scenes_at(at, length);
    say({ busy: true });
    const colors = [];
    for (let i = 0; i < scenes.length && !problem; i++) {
      const color = attempt(scenes[i]);
      if (color) colors.push(color[0], color[1], color[2]);
    }
    say({ busy: false });
    return problem ? 1 : answer_at(out, colors);
  };
  heard = (asked, of, broken) => say({ asked, of, broken, ms: now() - start });

  function draw() {
    write(exports, numbersOf(exercise.scene));
    const at = exports.draw(size, mistake);
    const scene = JSON.stringify(exercise.scene); // each pixel gets its own, which the student's code may change
    const numbers = new Numbers(exports.memory.buffer, at, 15 * size * size).slice();
    const pictures = [0, 1, 2].map(() => new Uint8ClampedArray(4 * size * size));
    let [off, unlike] = [0, 0];
    for (let i = 0; i < size * size; i++) {
      if (i % (10 * size) === 0) say({ busy: true });
      const [p, n, v, wanted, wrong] = [0, 3, 6, 9, 12].map((k) => [...numbers.subarray(15 * i + k, 15 * i + k + 3)]);
      if (!dot(n, n)) continue;
      const color = exercise.isPictureOnly ? wrong : problem ? [0, 0, 0] : attempt({ ...parse(scene), p, n, v }) ?? [0, 0, 0];
      const isNumber = color.every(Number.isFinite);
      const level = (x) => encoded(Math.max(0, x));
      const apart = color.map((c, k) => Math.abs(Math.min(255, level(c)) - Math.min(255, level(wanted[k]))) || 0);
      if (!isNumber || apart.some((c) => c > 1)) off++;
      if (color.some((c, k) => Math.abs(c - wrong[k]) > 1e-6 * Math.max(1, Math.abs(wrong[k])))) unlike++;
      pictures[0].set(isNumber ? [...color.map(level), 255] : [255, 0, 255, 255], 4 * i);
      pictures[1].set([...wanted.map(level), 255], 4 * i);
      pictures[2].set([...(isNumber ? apart.map((c) => 4 * c) : [255, 0, 255]), 255], 4 * i);
    }
    say({ busy: false });
    say({ pictures, off, unlike, problem, ms: now() - start });
  }

  /** What the student's function is given in this scene, its answers and the right ones. */
  function calls_in(scene) {
    const list = [];
    const noted = (...given) => {
      const wanted = RIGHT[name](...given);
      list.push({ given: copy(given), answer: theirs(...copy(given)), wanted });
      return wanted;
    };
    try {
      if (name === "shade") noted(scene);
      else shadeBy({ ...RIGHT, [name]: noted }, scene, { surface, ungated });
    } catch { /* it threw before, which is told */ }
    return list;
  }

  function check() {
    exports.check(...profileOf(profile), exercise.lamps ? 1 : 0, cases, seed); // what calls have in common is found below
    const report = parse(decode(bytes(exports.text(), exports.text_length())));
    const isWhole = exercise.lamps; // RIGHT.shade knows directional lights only: what the laws say is enough there
    const asked = isWhole ? [] : calls.map((call) => ({ ...call, wanted: RIGHT[name](...call.given) }));
    const diagnosis = report.passes ? null : diagnose(name, asked);
    const smallest = report.laws?.map((law) => law.smallest).find((it) => it);
    say({ busy: true }); // the student's code is asked once more
    const shownCalls = smallest && !isWhole ? calls_in(smallest.scenes[0]) : [];
    say({ busy: false });
    const worst = asked.find(({ answer, wanted }) => !same(answer, wanted));
    say({ report, diagnosis, calls: shownCalls, worst: worst && copy(worst), problem, ms: now() - start });
  }

  if (what === "draw") draw();
  else check();
}
