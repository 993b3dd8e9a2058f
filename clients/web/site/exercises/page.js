// The page: which exercise is open, what its code draws, and what the laws say of it.
import { $, capital, element } from "./dom.js";
import { Editor } from "./editor.js";
import { Engine } from "./engine.js";
import { FORMULAS, mistakeExercise, NORMALS } from "./exercises.js";
import { link_to, link_to_own, read_link } from "./link.js";
import { Runner } from "./run.js";
import { reason, verdict } from "./words.js";

const SIZE = 200; // of the pictures
const CASES = 400; // random scenes, beside the fixed ones
const canvases = [...document.querySelectorAll("canvas")];
const root = document.documentElement.dataset; // for tests: what was done, and how long it took

// ---- what the page needs, and then no network any more
async function file(name) {
  const response = await fetch(name);
  if (!response.ok) throw new Error(`${name}: ${response.status}`);
  return response;
}
let module;
let worker;
try {
  [module, worker] = await Promise.all([
    file("exercises.wasm").then((it) => it.arrayBuffer()).then((it) => WebAssembly.compile(it)),
    file("worker.js").then((it) => it.text()),
  ]);
} catch (error) {
  $("start").textContent = `The exercises cannot start: ${error.message}`;
  throw error;
}
// the workers inherit this
document.head.append(element("meta", {
  "http-equiv": "Content-Security-Policy",
  content: "connect-src 'none'; script-src 'wasm-unsafe-eval' blob:; worker-src blob:",
}));
const runner = new Runner(module, worker, (isWarm) => {
  if (isWarm) root.warm = "";
  else delete root.warm;
});
const engine = new Engine(module);

// ---- the exercises
const table = engine.mistakes();
const mistakes = table.filter((it) => engine.is_exercise(it));
const LISTS = { formulas: FORMULAS, normals: NORMALS, mistakes: mistakes.map(({ id }, i) => ({
  id: `find-${id}`, title: `Find the mistake ${i + 1}`, number: i + 1 })) };
const ALL = Object.values(LISTS).flat();

function exercise_of(id) {
  const known = ALL.find((it) => it.id === id) ?? ALL[0];
  if (!known.number) return known;
  const mistake = mistakes[known.number - 1];
  const { scene } = engine.best_scene(mistake);
  return mistakeExercise(known.number, mistake, scene);
}

// ---- what is kept in this browser
const KEY = "shading-exercises";
let kept = {};
try {
  kept = JSON.parse(localStorage.getItem(KEY)) ?? {};
} catch { /* a browser without storage forgets */ }
function keep(id, what) {
  if (current.isOwn) return;
  kept[id] = { ...kept[id], ...what };
  try {
    localStorage.setItem(KEY, JSON.stringify(kept));
  } catch { /* the same */ }
}

// ---- the open exercise
let current = FORMULAS[0];
let later;
let drawn = null; // the code whose picture is shown
let hints = 0;
const editor = new Editor({ changed, submit: check });

function task(what) {
  const { name, triple, surface, profile, scene, ungated, lamps, mistake } = current;
  const isPictureOnly = current.stub === undefined; // the mistake's line of code is still to be written
  const exercise = { name, triple, surface, profile, scene, ungated, lamps, isPictureOnly };
  return { what, size: SIZE, cases: CASES, seed: 0, mistake: mistake?.number ?? 1e6, exercise };
}

function tell(problem) {
  const line = problem?.line ? `Line ${problem.line}: ` : "";
  $("problem").textContent = problem ? `${line}${reason(problem, current, editor.text)}` : "";
  editor.mark(problem?.line ?? null);
}

function draw() {
  clearTimeout(later);
  const { text } = editor;
  const heard = ({ pictures, off, unlike, problem, ms }) => {
    tell(problem);
    if (pictures) {
      pictures.forEach((data, i) => canvases[i].getContext("2d").putImageData(new ImageData(data, SIZE, SIZE), 0, 0));
      $("off").textContent = off ? `${off} pixels differ.` : "The pictures are the same. The laws try more scenes.";
    } else {
      $("off").textContent = "There is no picture.";
    }
    drawn = text;
    Object.assign(root, { drawn: Math.round(ms ?? -1), off: off ?? "", unlike: unlike ?? "" });
  };
  runner.run(text, task("draw"), { heard });
}

function changed() {
  keep(current.id, { code: editor.text });
  clearTimeout(later);
  later = setTimeout(draw, 250);
}

function say(headline, isGood, below = []) {
  $("headline").textContent = headline;
  $("headline").className = isGood === null ? "" : isGood ? "good" : "bad";
  $("verdict").replaceChildren(...below);
  $("next").hidden = !isGood;
}

function check() {
  clearTimeout(later);
  delete root.checked;
  say("Trying …", null);
  const start = performance.now();
  let first = "";
  const progress = ({ asked, of, broken }) => {
    if (broken && first === "") {
      first = Math.round(performance.now() - start);
      say("Something is wrong. Looking for the smallest scene …", null);
    }
  };
  const heard = (answer) => {
    const { headline, isGood, below } = verdict(answer, current, editor.text);
    tell(answer.problem);
    if (isGood) {
      keep(current.id, { done: true });
      list();
    }
    say(headline, isGood, below);
    $("headline").scrollIntoView({ block: "nearest" });
    Object.assign(root, { checked: Math.round(performance.now() - start), first });
    dispatchEvent(new CustomEvent("checked", { detail: answer }));
    if (drawn !== editor.text) later = setTimeout(draw); // the click came before the picture
  };
  runner.run(editor.text, task("check"), { heard, progress });
}

// ---- naming a mistake
function naming() {
  const { mistake } = current;
  const isNamed = !mistake || kept[current.id]?.named || kept[current.id]?.done;
  $("naming").hidden = !mistake;
  $("writing").hidden = Boolean(mistake) && (!isNamed || current.stub === undefined);
  $("named").textContent = "";
  if (!mistake) return;
  const options = [mistake, ...engine.others(mistake, table, current.scene)];
  options.sort((a, b) => a.id.length - b.id.length || a.number - b.number); // an order that gives nothing away
  $("choices").replaceChildren(...options.map((option) => element("button", {
    type: "button", class: "choice", disabled: Boolean(isNamed),
    onclick: ({ target }) => choose(option, target),
  }, `${capital(option.says)}.`)));
  if (isNamed) $("named").textContent = `It was: ${mistake.says}.`;
}

function choose(option, button) {
  const { mistake } = current;
  if (option.id !== mistake.id) {
    button.disabled = true;
    $("named").textContent = "No, that would look different. Look again where the difference is bright.";
    return;
  }
  keep(current.id, { named: true });
  [...$("choices").children].forEach((it) => { it.disabled = true; });
  if (current.stub === undefined) {
    $("named").textContent = "Yes.";
    keep(current.id, { done: true });
    return list();
  }
  $("named").textContent = "Yes. Now fix the code until all laws hold.";
  $("writing").hidden = false;
  editor.mark(null);
  $("code").focus();
}

// ---- the list, hints and links
function list() {
  for (const [id, exercises] of Object.entries(LISTS)) {
    $(id).replaceChildren(...exercises.map(({ id, title, number }) => {
      const isDone = kept[id]?.done;
      return element("li", {}, element("a", {
        href: `#${id}`, class: isDone ? "done" : "", "aria-current": id === current.id ? "page" : null,
        "aria-label": number ? `${title}${isDone ? ", done" : ""}` : null,
      }, number ? String(number) : element("span", {}, title, isDone ? element("small", {}, " done") : null)));
    }));
  }
  $("score").textContent = `${ALL.filter(({ id }) => kept[id]?.done).length} of ${ALL.length} done`;
}

function open() {
  const { id, code, own, isBroken } = read_link(location.hash);
  const base = exercise_of(id);
  current = own ? { ...base, ...own, stub: code, isOwn: true, mistake: undefined } : base;
  document.title = `${current.title} – exercises in local illumination`;
  $("title").textContent = current.title;
  $("text").textContent = current.text;
  editor.text = code ?? kept[current.id]?.code ?? current.stub ?? "";
  hints = 0;
  $("hint").disabled = $("show").disabled = false;
  $("help").replaceChildren();
  $("yours").textContent = current.mistake ? "with the mistake" : "yours";
  $("copied").textContent = isBroken ? "The link is damaged, so this is the exercise as it begins." : "";
  say(kept[current.id]?.done ? "You have solved this exercise before." : "Not checked yet.", null);
  const next = ALL[ALL.findIndex((it) => it.id === current.id) + 1];
  $("next").href = `#${next?.id ?? ALL[0].id}`;
  list();
  naming();
  draw();
}

async function copy(hash, status) {
  const link = location.href.split("#")[0] + hash;
  try {
    await navigator.clipboard.writeText(link);
    $(status).textContent = "The link is copied.";
  } catch {
    history.replaceState(null, "", hash);
    $(status).textContent = "The link is in the address bar.";
  }
}

$("check").addEventListener("click", check);
$("hint").addEventListener("click", () => {
  const hint = current.hints[hints++];
  $("help").append(element("p", {}, hint ?? "There are no more hints. You can still show the formula."));
  if (!hint) $("hint").disabled = true;
});
$("show").addEventListener("click", () => {
  const formula = element("p", { class: "formula" });
  formula.innerHTML = current.formula; // of this page, never of a link
  $("help").append(formula);
  $("show").disabled = true;
});
$("again").addEventListener("click", () => {
  editor.text = current.stub;
  $("code").dispatchEvent(new Event("input"));
});
const own = (title, text) => link_to_own({ base: current.id, title, text, code: editor.text });
$("link").addEventListener("click", () => {
  const { id, title, text, isOwn } = current;
  copy(isOwn ? own(title, text) : link_to(id, editor.text), "copied");
});
$("own-link").addEventListener("click", () => {
  copy(own($("own-title").value || current.title, $("own-text").value || current.text), "own-copied");
});
addEventListener("hashchange", () => {
  open();
  $("title").focus();
});
// on a phone, the list is folded
if (matchMedia("(max-width: 52rem)").matches) $("menu").open = false;

open();
root.ready = "";
export { engine, LISTS };
