// Runs the student's code beside the laws. The page makes a function of this text and what it imports, and gives it
// `student`, which finds the student's function. The page listens to a port that the student's code cannot reach.
import { add, cross, dot, mul, RIGHT, same, scale, shadeBy, sub, unit } from "./formulas.js";
import { numbersOf, profileOf, write } from "./module.js";
import { diagnose } from "./typical.js";

const MOST_CALLS = 600; // that are looked at to find what a wrong answer has in common with others

const copy = (value) => structuredClone(value); // JSON has no NaN
const isTriple = (x) => Array.isArray(x) && x.length === 3 && x.every((c) => typeof c === "number");

function shown(x) {
  if (x === undefined) return "nothing";
  if (typeof x === "function") return "a function";
  if (typeof x !== "object") return `the ${typeof x} ${x}`;
  if (!Array.isArray(x)) return "an object";
  return x.every((c) => typeof c === "number") ? `an array of ${x.length}` : "an array in which not everything is a number";
}

// what * and + make of arrays
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
      throw new TypeError(`${name} takes ${want}, but it was given ${shown(given[i])}.${isOfArrays(given[i]) ? USE : ""}`);
    }
    return of(...given);
  };
}

// the student may give these names a meaning of their own
for (const [name, of] of Object.entries({ add, sub, mul, scale, dot, cross, unit })) self[name] = helper(name, of);

/** The student's function, whose answer is a number or three of them. */
function checked(name, of, isOfTriples, calls) {
  const want = isOfTriples ? "an array of three numbers" : "a number";
  return (...given) => {
    calls.last = given;
    const kept = calls.length < MOST_CALLS ? given.map((x) => (Array.isArray(x) ? [...x] : x)) : null;
    const answer = of(...given);
    if (isOfTriples ? !isTriple(answer) : typeof answer !== "number") {
      const text = answer === undefined ? `${name} returned nothing. Is there a return in every branch?`
        : `${name} should return ${want}, but it returned ${shown(answer)}.${isOfArrays(answer) ? USE : ""}`;
      throw Object.assign(new Error(text), { isOurs: true });
    }
    if (kept) calls.push({ given: kept, answer });
    return answer;
  };
}

const encoded = (x) => 255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055);

self.onmessage = ({ data, ports: [port] }) => {
  self.onmessage = null;
  const { module, exercise, what, size, cases, seed, code, mistake } = data;
  const { name, triple, profile, surface, ungated } = exercise;
  const say = port.postMessage.bind(port);
  const now = performance.now.bind(performance);
  const parse = JSON.parse;
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
      const frames = String(error?.stack).split(`${code}:`); // begin with their lines, the innermost first
      // a stack may overflow at a call or at the head of what is called; below it is a call in either case
      const isDeep = /call stack|recursion/.test(error?.message) && frames.length > 2;
      const text = isDeep ? "A function calls itself without end." : error?.isOurs ? error.message : String(error);
      const line = error?.isOurs ? 0 : parseInt(frames[isDeep ? 2 : 1], 10);
      problem = { text, line: line || null, given: copy(calls.last ?? []) };
      return null;
    }
  }

  const bytes = (at, length) => new Uint8Array(exports.memory.buffer, at, length);
  const page = {
    shade_all(at, length, out) {
      const scenes = parse(`[${new TextDecoder().decode(bytes(at, length))}]`);
      say({ busy: true });
      const colors = [];
      while (colors.length < scenes.length && !problem) colors.push(attempt(scenes[colors.length]));
      say({ busy: false });
      if (problem) return 1;
      new Float64Array(exports.memory.buffer, out, 3 * scenes.length).set(colors.flat());
      return 0;
    },
    goes_on: (asked, of, broken) => say({ asked, of, broken, ms: now() - start }),
  };
  const { exports } = new WebAssembly.Instance(module, { page });

  function draw() {
    write(exports, numbersOf(exercise.scene));
    const at = exports.draw(size, mistake);
    const scene = JSON.stringify(exercise.scene); // each pixel gets its own, which the student's code may change
    const numbers = new Float64Array(exports.memory.buffer, at, 15 * size * size).slice();
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
    const report = parse(new TextDecoder().decode(bytes(exports.text(), exports.text_length())));
    const isWhole = exercise.lamps; // RIGHT.shade knows directional lights only: what the laws say is enough there
    const asked = isWhole ? [] : calls.map((call) => ({ ...call, wanted: RIGHT[name](...call.given) }));
    const diagnosis = report.passes ? null : diagnose(name, asked);
    const smallest = report.laws?.map((law) => law.smallest).find((it) => it);
    const shownCalls = smallest && !isWhole ? calls_in(smallest.scenes[0]) : [];
    const worst = asked.find(({ answer, wanted }) => !same(answer, wanted));
    say({ report, diagnosis, calls: shownCalls, worst: worst && copy(worst), problem, ms: now() - start });
  }

  if (what === "draw") draw();
  else check();
};
