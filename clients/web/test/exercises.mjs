// Solves the exercises as students do, and tries what a student's code must not be able to:
// node exercises.mjs NORMALS [PICTURES]
// NORMALS is the program that gives the crate's normals.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readdir, readFile } from "node:fs/promises";
import { join } from "node:path";
import { gzipSync } from "node:zlib";
import { ALSO_RIGHT, WRONG } from "./answers.mjs";
import { delayed, forged, lambert, later, refusal, refused } from "./ways_out.mjs";
import { browser, close, folder, home, is_accessible, open, PHONE, requests } from "./site.mjs";
import { FORMULAS, NORMALS } from "../site/exercises/exercises.js";
import { RIGHT } from "../site/exercises/formulas.js";
import { PLANTED, planted, RENDERER } from "../site/exercises/renderer.js";
import { TYPICAL } from "../site/exercises/typical.js";

const [normals, pictures] = process.argv.slice(2);
const EXERCISES = [...FORMULAS, ...NORMALS];
/** The laws tell a form of the colors in other words than the table. */
const OTHER_WORDS = { SrgbOnceMore: /encoded as sRGB/ };

async function exercises(hash = "", options = {}) {
  const page = await open(`exercises/${hash}`, options);
  await page.waitForSelector("html[data-ready]");
  await page.waitForSelector("html[data-drawn]");
  return page;
}

/** Goes to an exercise by its link in the list. */
async function choose(page, id) {
  await page.evaluate((id) => {
    delete document.documentElement.dataset.drawn;
    if (location.hash === `#${id}`) document.documentElement.dataset.drawn = "";
    else location.hash = id;
  }, id);
  await page.waitForSelector("html[data-drawn]");
}

async function write(page, code) {
  await page.evaluate((code) => {
    delete document.documentElement.dataset.drawn;
    document.getElementById("code").value = code;
    document.getElementById("code").dispatchEvent(new Event("input"));
  }, code);
  await page.waitForSelector("html[data-drawn]");
}

/** Checks the code, and gives what is said and how long it took. */
async function check(page) {
  await page.evaluate(() => { delete document.documentElement.dataset.checked; });
  await page.waitForSelector("html[data-warm]"); // a hand takes longer than the next worker's start
  await page.click("#check");
  await page.waitForSelector("html[data-checked]", { timeout: 20_000 });
  return page.evaluate(() => {
    const { checked, first, off } = document.documentElement.dataset;
    const text = (id) => document.getElementById(id).innerText.replace(/\s*\n\s*/g, " | ");
    return { ms: Number(checked), first: Number(first), off, headline: text("headline"), verdict: text("verdict"),
      problem: text("problem"), isGood: document.getElementById("headline").className === "good" };
  });
}

/** Checks this code, with its picture or at once. */
async function attempt(page, id, code, isDrawn = false) {
  await choose(page, id);
  if (isDrawn) await write(page, code);
  else await page.evaluate((code) => { document.getElementById("code").value = code; }, code);
  return check(page);
}

const slowest = { first: 0, verdict: 0 };

/**
 * The first broken scene within 100 ms, and the verdict within 1 s. A processor that others use, too, is slow now and then, but
 * hardly for half a minute.
 */
async function is_quick(page, answer, what) {
  let { first, ms } = answer;
  slowest.first = Math.max(slowest.first, first);
  slowest.verdict = Math.max(slowest.verdict, ms);
  for (let tries = 0; tries < 30 && (first > 100 || ms > 1000); tries++) {
    await page.waitForTimeout(500);
    const again = await check(page);
    [first, ms] = [Math.min(first, again.first), Math.min(ms, again.ms)];
  }
  assert.ok(first <= 100 && ms <= 1000, `${what}: the first broken scene after ${first} ms, the verdict after ${ms} ms`);
}

// every exercise: the stub fails, the solution and other right forms pass, and typical mistakes get their words
{
  const page = await exercises();
  let count = 0;
  const only = process.env.ONLY?.split(","); // exercises, while one writes texts
  for (const { id, name, stub, solution } of EXERCISES.filter(({ id }) => !only || only.includes(id))) {
    assert.ok(WRONG[id].length >= 5 && TYPICAL[name].length >= 5, `${id}: five typical mistakes`);
    assert.ok(!(await attempt(page, id, stub)).isGood, `${id}: the stub passes`);
    for (const code of [solution, ...(ALSO_RIGHT[id] ?? [])]) {
      const answer = await attempt(page, id, code, true);
      assert.ok(answer.isGood, `${id} refuses a right answer: ${code}${answer.headline}\n${answer.verdict}`);
      assert.equal(answer.off, "0", `${id}: the picture of a right answer differs from the crate's: ${code}`);
      await is_quick(page, { ...answer, first: 0 }, code);
    }
    for (const [code, words] of WRONG[id]) {
      const answer = await attempt(page, id, code);
      assert.ok(!answer.isGood, `${id} takes a wrong answer: ${code}`);
      assert.match(answer.headline, words, `${id}: ${code}${answer.verdict}`);
      const isStopped = answer.headline.startsWith("Your code stopped");
      const isRun = !answer.headline.includes("SyntaxError");
      assert.match(answer.verdict, isStopped ? isRun ? /was given/ : /^$/ : /\?|by hand|step/, `${id}: no question leads on`);
      assert.match(answer.verdict, isStopped ? isRun ? /was given/ : /^$/ : /smallest scene/, `${id}: no scene is shown`);
      await is_quick(page, answer, code);
      count++;
      if (process.env.ALOUD) console.log(`${id}\n${code}${answer.headline}\n${answer.verdict}\n`);
    }
  }
  // what was done is remembered
  await page.reload();
  await page.waitForSelector("html[data-ready]");
  const score = await page.textContent("#score");
  assert.match(score, only ? /\d/ : new RegExp(`^${EXERCISES.length} of`));
  await page.close();
  console.log(`${EXERCISES.length} exercises take their solutions, and ${count} typical wrong answers get their words`);
}

// the first check of a page that was just opened is as quick: each try has a page of its own, in a process that knows nothing
{
  const firsts = [];
  for (const [id, code] of [["lambert", lambert("return dot(n, l);")], ["half", WRONG.half[0][0]], ["sum", WRONG.sum[0][0]]]) {
    const times = [];
    do {
      const page = await exercises(`#${id}`);
      times.push((await attempt(page, id, code)).first);
      await page.close();
    } while (times.at(-1) > 100 && times.length < 20);
    assert.ok(times.at(-1) <= 100, `${id}: the first broken scene of a fresh page after ${times} ms`);
    firsts.push(`${id} ${times.join(", ")}`);
  }
  console.log(`the first broken scene of a fresh page, in ms: ${firsts.join("; ")}`);
}

// the normals by hand are the crate's, which differentiates by itself
{
  let seed = 1;
  const random = () => {
    seed = (seed * 48271) % 2147483647;
    return 4 * (seed / 2147483647) - 2;
  };
  const triple = () => [random(), random(), random()];
  const away = () => random() + 3; // from 0
  const surfaces = {
    plane: () => triple(),
    sphere: () => [triple(), triple()],
    triangle: () => [triple(), triple(), triple()],
    ellipsoid: () => [triple(), [away(), away(), away()]],
    torus: () => [2 * random(), 2 * random(), 6 + random(), away() / 2],
  };
  const given = Object.values(surfaces).map((values) => Array.from({ length: 2000 }, values));
  const input = given.map((list, index) => list.map((values) => [index, ...values.flat()].join(" ")).join("\n")).join("\n");
  const printed = execFileSync(normals, { input, encoding: "utf8" });
  const crate = printed.trim().split("\n").map((line) => line.split(" ").map(Number));
  const worst = Object.keys(surfaces).map((name, index) => {
    const off = given[index].map((values, i) => RIGHT[name](...values).map((x, k) => Math.abs(x - crate[2000 * index + i][k])));
    return [name, Math.max(...off.flat())];
  });
  // some thirty roundings of doubles; a thin triangle loses the digits of its edges' angle, 2000 draws are seldom below 1/1000
  for (const [name, most] of worst) assert.ok(most < (name === "triangle" ? 1e-11 : 1e-13), `${name}: ${most}`);
  console.log(`the normals by hand are the crate's: ${worst.map(([name, most]) => `${name} ${most.toExponential(0)}`).join(", ")}`);
}

// every mistake of the laws' table: its text draws the table's colors, the laws name it, and the mended text passes
{
  const page = await exercises("#find-NormalReversed");
  const ids = await page.evaluate(() => import("./page.js").then(({ LISTS }) => LISTS.mistakes.map(({ id }) => id.slice(5))));
  const table = await page.evaluate(() => import("./page.js").then(({ engine }) => engine.mistakes()));
  // what draws the right picture in a page, whose colors are linear and not rounded
  const invisible = table.map(({ id }) => id).filter((id) => !ids.includes(id));
  assert.deepEqual(invisible, ["Gamma", "LevelsTruncated"], "a new mistake that no scene of the page shows");
  for (const id of Object.keys(PLANTED)) assert.ok(ids.includes(id), `${id} is not in the table any more`);
  for (const id of ids) {
    assert.ok(PLANTED[id], `write the line of code in which the renderer has the mistake ${id}`);
    await choose(page, `find-${id}`);
    const { off, unlike } = await page.evaluate(() => ({ ...document.documentElement.dataset }));
    // an unguarded half vector differs in one direction alone
    if (id !== "HalfVectorUnguarded") assert.ok(Number(off) > 0, `${id}: the picture is right`);
    // the table's root is that of f32
    if (id !== "FastInverseRoot") assert.equal(unlike, "0", `${id}: the picture is not the table's`);
    assert.equal(await page.locator("#choices button").count(), 4, id);
    assert.ok(await page.isHidden("#code"), `${id}: the code gives the mistake away`);
    const { says } = table.find((it) => it.id === id);
    const wanted = `${says.startsWith("sRGB") ? says : says.charAt(0).toUpperCase() + says.slice(1)}.`;
    const names = await page.locator("#choices button").allTextContents();
    assert.equal(names.filter((name) => name === wanted).length, 1, `${id}: ${names}`);
    const wrong = names.find((name) => name !== wanted);
    await page.locator("#choices button").nth(names.indexOf(wrong)).click();
    assert.match(await page.textContent("#named"), /^No/);
    assert.ok(await page.isHidden("#code"));
    await page.locator("#choices button").nth(names.indexOf(wanted)).click();
    assert.equal(await page.inputValue("#code"), planted(id));
    const answer = await check(page);
    assert.ok(!answer.isGood, `${id}: its laws hold`);
    const isNamed = OTHER_WORDS[id]?.test(answer.headline) ?? answer.headline.startsWith(wanted.slice(0, -1));
    assert.ok(isNamed, `${id}: ${answer.headline}\n${answer.verdict}`);
    await is_quick(page, answer, id);
  }
  await write(page, RENDERER);
  const mended = await check(page);
  assert.ok(mended.isGood && mended.off === "0", JSON.stringify(mended));
  await page.close();
  console.log(`${ids.length} mistakes of the laws' table are found, named and mended`);
}

// ---- what a student's code must not be able to

{
  const page = await exercises("#lambert");
  const problems = {
    [lambert("while (true);")]: /did not finish in time/,
    [`while (true);\n${lambert("return 1;")}`]: /did not finish in time/,
    [lambert("return lambert(n, l);")]: /in line 2: A function calls itself without end/,
    [`const f = (x) =>\n  x > 0 ? g(x) : 0;\nconst g = (x) => f(x + 1);\n${lambert("return f(1);")}`]: /in line [23]: A function calls/,
    [lambert("return new Array(-1).length;")]: /in line 2: RangeError/,
    [lambert("return Math.max(0, dot(n, light));")]: /in line 2: ReferenceError: light/,
    [lambert("return Math.max(0, dot(n, l);")]: /in line 2: SyntaxError/,
    [lambert("dot(n, l);")]: /returned nothing/,
    [lambert("return n;")]: /should return a number, but it returned an array of 3\./,
    [lambert("return n + l;")]: /returned a string\..* use add, sub/,
    [lambert("throw 7;")]: /stopped.*: 7/,
    [lambert("throw Symbol(\"x\");")]: /stopped.*: Symbol\(x\)/,
    [lambert("throw Object.create(null);")]: /cannot be shown/,
    [lambert("throw { get stack() { while (true); } };")]: /did not finish in time/,
    [lambert("n[0] = () => 1; throw new Error(\"x\");")]: /in line 2: Error: x/,
    [`let asked = 0;\n${lambert("if (++asked > 2000) while (true);\n  return 1;")}`]: /did not finish in time|always the same/,
    [lambert("const cell = new Int32Array(new WebAssembly.Memory({ initial: 1, maximum: 1, shared: true }).buffer);\n"
      + "  return Atomics.wait(cell, 0, 0);")]: /did not finish in time/,
    [lambert("while (true) postMessage(0);")]: /did not finish in time/,
    [lambert("return /^(a+)+$/.test(\"a\".repeat(40) + \"b\");")]: /did not finish in time/,
    [lambert("return new ArrayBuffer(1e15).byteLength;")]: /in line 2: RangeError/,
    [lambert("let s = \"x\";\n  for (;;) s += s;")]: /in line 3: RangeError/,
    [lambert("return { valueOf: () => 1 };")]: /should return a number, but it returned an object/,
    "function* lambert(n, l) {\n  yield 1;\n}\n": /should return a number, but it returned an object/,
    "async function lambert(n, l) {\n  return 1;\n}\n": /should return a number, but it returned an object/,
    [lambert("return 1n;")]: /returned the bigint 1/,
    [lambert("debugger;\n  return 1;")]: /always the same/,
    "const x = 1;\n": /lambert is not defined/,
  };
  for (const [code, words] of Object.entries(problems)) {
    const { headline, isGood, ms } = await attempt(page, "lambert", code);
    assert.match(headline, words, code);
    assert.ok(!isGood);
    if (code === lambert("while (true);")) console.log(`an endless loop is told after ${ms} ms`);
  }
  // what it says of itself is not believed, and makes no element of the page
  for (const code of forged) {
    assert.ok(!(await attempt(page, "lambert", `${code}\n${lambert("return 1;")}`)).isGood, `a forged verdict: ${code}`);
  }
  const { headline } = await attempt(page, "lambert", lambert("throw new Error(\"<b id=forged>x</b><img src=x onerror=alert(1)>\");"));
  assert.match(headline, /<b id=forged>/);
  assert.equal(await page.locator("#forged, main img").count(), 0);
  // a vector of getters or a proxy is read once
  const proxy = "const { cos, sin } = Math;\n  const n = [cos(u) * cos(v), sin(u) * cos(v), sin(v)];\n  return new Proxy(n, {});";
  assert.ok((await attempt(page, "parametric", `function torus(u, v, R, r) {\n  ${proxy}\n}\n`)).isGood, "a proxy of the right answer");
  const turning = "let reads = 0;\n  const x = () => { if (++reads > 3) while (true); return 1; };\n"
    + "  return [0, 1, 2].reduce((it, i) => Object.defineProperty(it, i, { get: x }), [0, 0, 0]);";
  assert.match((await attempt(page, "sphere", `function sphere(center, p) {\n  ${turning}\n}\n`)).headline, /always the same/);
  const changed = await attempt(page, "lambert", lambert("n[0] = 7; l.reverse(); return 1;"));
  assert.ok(!changed.isGood);
  assert.ok((await attempt(page, "lambert", lambert("return Math.max(0, dot(n, l));"))).isGood, "afterward, all is well");
  await page.close();
}

{
  // the browser's console tells of what the policy prevents
  const page = await browser.newPage();
  await page.goto(`${home}exercises/#lambert`);
  await page.waitForSelector("html[data-drawn]");
  for (const [code, words] of Object.entries(refused)) {
    assert.match((await attempt(page, "lambert", refusal(code))).headline, words, code);
  }
  for (const code of later) {
    const { headline } = await attempt(page, "lambert", delayed(code));
    assert.match(headline, /Error: end/, code);
  }
  await new Promise((passed) => setTimeout(passed, 500));
  assert.deepEqual(requests.filter((url) => url.includes("leak")), [], "something got out");
  const fetching = await attempt(page, "lambert", lambert("return fetch(\"/\");"));
  assert.match(fetching.headline, /returned an object/);
  await page.close();
  console.log(`${Object.keys(refused).length + later.length} ways out are closed`);
}

// ---- links
{
  const page = await exercises("#lambert");
  await page.context().grantPermissions(["clipboard-read", "clipboard-write"]);
  const code = lambert("return Math.max(0, dot(n, l)); // ü → 1");
  await write(page, code);
  await page.click("#link");
  await page.waitForFunction(() => document.getElementById("copied").textContent.includes("copied"));
  const link = await page.evaluate(() => navigator.clipboard.readText());
  await page.click(".teacher summary");
  await page.fill("#own-title", "My <b>own</b>");
  await page.fill("#own-text", "Light from “above”");
  await page.click("#own-link");
  await page.waitForFunction(() => document.getElementById("own-copied").textContent.includes("copied"));
  const own = await page.evaluate(() => navigator.clipboard.readText());
  await page.close();
  const hash = (link) => link.slice(link.indexOf("#"));
  const other = await exercises(hash(link));
  assert.equal(await other.inputValue("#code"), code);
  await other.close();
  const task = await exercises(hash(own));
  assert.equal(await task.textContent("#title"), "My <b>own</b>");
  assert.equal(await task.textContent("#text"), "Light from “above”");
  assert.equal(await task.inputValue("#code"), code);
  assert.ok((await check(task)).isGood);
  await write(task, "");
  await task.click("#again");
  assert.equal(await task.inputValue("#code"), code, "an own exercise begins with the teacher's code");
  await task.close();
  const damaged = await exercises(`${hash(link).slice(0, -41)}%%`);
  assert.match(await damaged.textContent("#copied"), /damaged/);
  assert.equal(await damaged.inputValue("#code"), FORMULAS[1].stub);
  await damaged.close();
  console.log("an exercise with its code, and a teacher's own, are links");
}

// ---- without a mouse, and for the ear
{
  const page = await exercises("#lambert");
  await page.focus("#code");
  await page.keyboard.press("Control+KeyA");
  await page.keyboard.type("function lambert(n, l) {\nif (dot(n, l) > 0) {\nreturn dot(n, l);\n}\nreturn 0;\n}");
  const indented = "function lambert(n, l) {\n  if (dot(n, l) > 0) {\n    return dot(n, l);\n  }\n  return 0;\n}";
  assert.equal(await page.inputValue("#code"), indented);
  await page.keyboard.press("Control+Enter");
  await page.waitForSelector("html[data-checked]");
  assert.match(await page.locator("#headline[role=status]").textContent(), /^All laws hold/);
  await page.waitForFunction(() => document.documentElement.dataset.off === "0"); // the picture follows although the key was faster
  const reached = [];
  for (let i = 0; i < 12; i++) {
    await page.keyboard.press("Tab");
    reached.push(await page.evaluate(() => document.activeElement.id));
  }
  for (const id of ["check", "hint", "show", "again", "link", "next"]) assert.ok(reached.includes(id), `Tab does not reach ${id}`);
  await page.focus("#hint");
  await page.keyboard.press("Enter");
  await page.focus("#show");
  await page.keyboard.press("Enter");
  assert.match(await page.textContent("#help"), /cosine[^]*max\(0/);
  await page.focus("#next");
  await page.keyboard.press("Enter");
  await page.waitForFunction(() => document.activeElement.id === "title");
  assert.equal(await page.textContent("#title"), "Attenuation");
  await page.close();
  console.log("keys reach everything, and the verdict is announced");
}

// ---- how it looks
const views = { wide: {}, large: { viewport: { width: 1920, height: 1080 } }, phone: PHONE };
for (const colorScheme of ["light", "dark"]) {
  for (const [name, options] of Object.entries(views)) {
    for (const [id, code] of [["lambert", lambert("return dot(n, l);")], ["half", WRONG.half[0][0]], ["find-NormalReversed", null]]) {
      const page = await exercises(`#${id}`, { ...options, colorScheme, bypassCSP: true });
      if (code) {
        await write(page, code);
        await page.click("#hint");
        await check(page);
      }
      await is_accessible(page, `${id}, ${colorScheme}, ${name}`);
      if (pictures) await page.screenshot({ path: join(pictures, `exercises_${id}_${name}_${colorScheme}.png`), fullPage: true });
      await page.close();
    }
    const entrance = await open("", { ...options, colorScheme, bypassCSP: true });
    await is_accessible(entrance, `entrance, ${colorScheme}, ${name}`);
    if (pictures) await entrance.screenshot({ path: join(pictures, `entrance_${name}_${colorScheme}.png`) });
    await entrance.close();
  }
}
console.log("axe-core finds nothing wrong, light or dark, wide or on a phone");

// ---- how large and how fast
const files = (await readdir(join(folder, "exercises"))).map((name) => join(folder, "exercises", name));
files.push(join(folder, "style.css"), join(folder, "file.js"));
let bytes = 0;
for (const path of files) bytes += gzipSync(await readFile(path), { level: 9 }).length;
console.log(`the page for exercises: ${(bytes / 1000).toFixed(1)} KB gzipped`);
assert.ok(bytes <= 180_000, `${bytes} bytes`);
console.log(`the slowest of all answers at their first try: the first broken scene after ${slowest.first} ms, a verdict after ${slowest.verdict} ms`);
await close();
