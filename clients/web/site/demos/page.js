// The controls go into the module's memory, and the picture comes out of it.
import { directions, draw as drawArrows } from "./arrows.js";
import { plotFalloff, plotLobe } from "./plot.js";
import { program } from "./rust.js";

// as `Scene::new` in src/scene.rs takes them; the eye, the turn, the sun and three bytes of each color follow
const SETTINGS = ["surface", "model", "ka", "kd", "ks", "m", "x", "y", "z", "a", "b", "c", "angle", "edge", "second", "x2", "y2", "z2"];
const COLORS = ["color", "light", "light2", "sunlight"];
const OF_LAMP2 = ["x2", "y2", "z2", "light2"];
const OF_SUN = ["heading", "altitude", "sunlight"];
// as `numbers` in src/page.rs gives them: numbers, and triples in capitals; those of the lamps that are on follow, one by one
const PROBE = ["seen", "P", "N", "V", "AMBIENT", "DIFFUSE", "SPECULAR", "TOTAL", "SRGB"];
const PROBE_OF_LAMP = ["L", "R", "H", "q", "nl", "rv", "nh", "highlight", "attenuation", "cone"];
const LAMPS = [{ marker: "lamp", names: ["x", "y", "z"], color: "light" },
  { marker: "lamp2", names: ["x2", "y2", "z2"], color: "light2" }];

const $ = (id) => document.getElementById(id);
const [canvas, fine, form, frame] = [$("canvas"), $("fine"), $("controls"), $("frame")];
const context = canvas.getContext("2d");
const thumbnails = [...document.querySelectorAll("#parts canvas")];
const models = [...document.querySelectorAll("#models canvas")];
const meshes = [...document.querySelectorAll("#meshes canvas")];
const SMALL = [...thumbnails, ...models, ...meshes].map((canvas) => [canvas, canvas.width]);
// in fractions of the picture; a click pins it
const cross = { x: 0.45, y: 0.42, isPinned: false };

let shader;
try {
  const file = await fetch("demos.wasm");
  if (!file.ok) throw new Error(`${file.url}: ${file.status}`);
  shader = (await WebAssembly.instantiate(await file.arrayBuffer())).instance.exports;
} catch (error) {
  $("message").textContent = `The picture cannot be drawn: ${error.message}`;
  throw error;
}

const isOn = (name) => form.elements[name].checked;
const field = (name) => Number(form.elements[name].value);

/** The direction to the sun. */
function sun() {
  const [heading, altitude] = ["heading", "altitude"].map((name) => field(name) * Math.PI / 180);
  return [Math.sin(heading) * Math.cos(altitude), Math.sin(altitude), Math.cos(heading) * Math.cos(altitude)].map(Math.fround);
}

/** The eye, which walks around the object from (0, 1, 5) and climbs over it. */
function eye() {
  const [walk, climb] = ["walk", "climb"].map((name) => field(name) * Math.PI / 180);
  const y = Math.cos(climb) + 5 * Math.sin(climb);
  const away = 5 * Math.cos(climb) - Math.sin(climb);
  return [away * Math.sin(walk), y, away * Math.cos(walk)];
}

/** What the controls say, as numbers in the module's order. */
function settings() {
  const turn = field("turn") * Math.PI / 180;
  const values = SETTINGS.map((name) => (name === "second" ? Number(isOn(name)) : field(name)));
  return [...values, ...eye(), Math.cos(turn), Math.sin(turn), Number(isOn("sun")), ...sun(),
    ...COLORS.flatMap((name) => bytes(form.elements[name].value))].map(Math.fround);
}

const bytes = (color) => color.match(/\w\w/g).map((byte) => parseInt(byte, 16));

/** Draws a part into a canvas, in the canvas's size. */
function draw(part, { width, height }, context) {
  show(shader.draw(part, width, height), width, height, context);
  const message = new Uint8Array(shader.memory.buffer, shader.message(), shader.message_length());
  return new TextDecoder().decode(message);
}

/** Shows the picture of the module at an address. */
function show(at, width, height, context) {
  if (!width || !height) return;
  const pixels = new Uint8ClampedArray(shader.memory.buffer, at, 4 * width * height);
  context.putImageData(new ImageData(pixels, width, height), 0, 0);
}

/** The settings stand in the address, so that a link shows the same picture. */
function remember() {
  const all = new URLSearchParams();
  for (const { name, type, value, checked, defaultValue, defaultChecked } of form.elements) {
    if (!name) continue;
    if (type === "radio" ? checked && !defaultChecked : type === "checkbox" ? checked : value !== defaultValue) {
      all.set(name, type === "checkbox" ? "on" : type === "range" ? String(Number(Number(value).toFixed(3))) : value);
    }
  }
  if (cross.isPinned) all.set("at", `${cross.x.toFixed(4)},${cross.y.toFixed(4)}`);
  const hash = String(all) ? `#${all}` : "";
  if (hash !== location.hash) history.replaceState(null, "", location.pathname + location.search + hash);
}

/** Takes the settings of a link. */
function recall() {
  const all = new URLSearchParams(location.hash.slice(1));
  for (const [name, value] of all) {
    const control = form.elements[name];
    if (!control) continue;
    if (control.type === "checkbox") control.checked = value === "on";
    else control.value = value;
  }
  const [x, y] = (all.get("at") ?? "").split(",").map(Number);
  if (x >= 0 && x <= 1 && y >= 0 && y <= 1) Object.assign(cross, { x, y, isPinned: true });
}

const write = (values) => new Float32Array(shader.memory.buffer, shader.settings(), values.length).set(values);

/** The same scene by each model, side by side. */
function compare() {
  const values = settings();
  models.forEach((canvas, model) => {
    write(values.map((value, i) => (SETTINGS[i] === "model" ? model : value)));
    draw(0, canvas, canvas.getContext("2d"));
  });
  write(values);
}

/** The same scene on a coarse mesh, flat and by Gouraud, beside that of each pixel. */
function compareMeshes() {
  meshes.forEach((canvas, i) => {
    const { width, height } = canvas;
    const context = canvas.getContext("2d");
    if (i === 2) draw(0, canvas, context);
    else show(shader.draw_mesh(i, width, height), width, height, context);
  });
}

/** Draws the small pictures, with so many pixels along each side for one of the page. */
function drawSmall(times) {
  for (const [canvas, side] of SMALL) {
    if (canvas.width !== times * side) canvas.width = canvas.height = times * side;
  }
  thumbnails.forEach((canvas, part) => draw(part, canvas, canvas.getContext("2d")));
  if ($("models").open) compare();
  if ($("meshes").open) compareMeshes();
}

const part = () => Number(document.querySelector("[name=part]:checked").value);

const REST = 150; // ms without a change, after which there is time for a smooth picture
let rest;

/**
 * At rest, every picture is drawn with two pixels along each side for one of the page, and the browser scales it down: an
 * edge gets the mean of four samples, though of their encoded colors and not of their light. The large one lies over the
 * one that is drawn while something moves, whose pixels have the numbers.
 */
function refine() {
  drawSmall(2);
  if (canvas.width >= 2 * frame.clientWidth) return; // also if there is no room
  [fine.width, fine.height] = [frame.clientWidth, frame.clientHeight].map((size) => Math.min(2 * size, 2048));
  draw(part(), fine, fine.getContext("2d"));
  fine.hidden = false;
}

function redraw() {
  clearTimeout(rest);
  fine.hidden = true;
  rest = setTimeout(refine, REST);
  remember();
  write(settings());
  drawSmall(1);
  $("message").textContent = draw(part(), canvas, context);
  for (const name of OF_LAMP2) form.elements[name].disabled = !isOn("second");
  for (const name of OF_SUN) form.elements[name].disabled = !isOn("sun");
  const hasFalloff = ["a", "b", "c"].some(field);
  LAMPS.forEach(({ marker, color, names }, lamp) => {
    showLamp($(marker), hasFalloff && (lamp === 0 || isOn("second")), lampPlace(lamp), names.map(field));
    if (!hasFalloff) $(`${marker}-place`).textContent = "off";
    $(marker).style.setProperty("--light", form.elements[color].value);
  });
  explain();
}

/** A lamp behind the object is drawn dashed, and one outside of the picture as an arrow at its edge. */
function showLamp(marker, isShown, [x, y], position) {
  const isOutside = !(x >= 0 && x <= 1 && y >= 0 && y <= 1);
  const isKnown = x !== -1 / canvas.width || y !== -1 / canvas.height; // else it is behind the eye
  marker.hidden = !isShown || (isOutside && !isKnown);
  const [cx, cy] = [x, y].map((c) => Math.min(0.98, Math.max(0.02, c)));
  Object.assign(marker.style, { left: `${100 * cx}%`, top: `${100 * cy}%` });
  // what is farther than the origin is behind the object, if it is hidden
  const isFar = projected(position)[2] > projected([0, 0, 0])[2];
  const isBehind = !isOutside && isFar && covers(x, y);
  marker.classList.toggle("far", isBehind);
  marker.classList.toggle("outside", isOutside);
  const place = isBehind ? "behind the object" : !isOutside ? "" : isKnown ? "outside of the picture" : "behind the eye";
  $(`${marker.id}-place`).textContent = isShown ? place : "";
}

/** Where a point of space is in the picture, in fractions of it, and its depth. */
function projected(point) {
  const { width, height } = canvas;
  const [x, y, depth] = [0, 1, 2].map((number) => shader.projected(...point, width, height, number));
  return [x / width, y / height, depth];
}

/** Whether the object is seen at a place of the picture. */
function covers(x, y) {
  const at = (fraction, size) => Math.min(Math.floor(fraction * size), size - 1);
  const { width, height } = canvas;
  const address = shader.probe(width, height, at(x, width), at(y, height));
  return new Float32Array(shader.memory.buffer, address, 1)[0] > 0;
}

/** Where a lamp is in the picture, in fractions of it. */
function lampPlace(lamp) {
  const { width, height } = canvas;
  return [shader.lamp_x(lamp, width, height) / width, shader.lamp_y(lamp, width, height) / height];
}

function place(marker, x, y) {
  marker.hidden = !(x >= 0 && x <= 1 && y >= 0 && y <= 1);
  Object.assign(marker.style, { left: `${100 * x}%`, top: `${100 * y}%` });
}

/** What shines, by the sign that stands beside its letters: nothing is added to those of a single lamp. */
function lit() {
  const hasFalloff = ["a", "b", "c"].some(field);
  const lamps = hasFalloff ? (isOn("second") ? ["1", "2"] : [isOn("sun") ? "1" : ""]) : [];
  return [...lamps, ...(isOn("sun") ? ["sun"] : [])];
}

/** The numbers of the pixel under the cross. */
function probe() {
  const { width, height } = canvas;
  const at = (fraction, size) => Math.min(Math.floor(fraction * size), size - 1);
  const address = shader.probe(width, height, at(cross.x, width), at(cross.y, height));
  const numbers = [...new Float32Array(shader.memory.buffer, address, 73)];
  const take = (name) => (name > "Z" ? numbers.shift() : numbers.splice(0, 3));
  const all = (names) => Object.fromEntries(names.map((name) => [name, take(name)]));
  return { ...all(PROBE), lamps: lit().map((name) => ({ name, ...all(PROBE_OF_LAMP) })) };
}

const number = (x) => (Math.abs(x) >= 1000 ? x.toExponential(2) : x.toFixed(3)).replace("-", "−");
const triple = (t) => `(${t.map(number).join(", ")})`;

function explain() {
  place($("cross"), cross.x, cross.y);
  const { ka, kd, ks, m, a, b, c, model } = Object.fromEntries(new FormData(form));
  const dot = { 1: "<b>R</b>·<b>V</b>", 2: "<b>N</b>·<b>H</b>" }[model];
  const highlight = dot ? ` + <span class="specular">k<sub>s</sub> max(0, ${dot})<sup>m</sup></span>` : "";
  $("formula").innerHTML = `I = <span class="ambient">k<sub>a</sub> O</span> + Σ f(q) s C
    (<span class="diffuse">k<sub>d</sub> O max(0, <b>N</b>·<b>L</b>)</span>${highlight})`;

  const at = probe();
  const lamps = at.lamps.filter(({ name }) => name !== "sun");
  plotFalloff($("falloff"), [a, b, c].map(Number), at.seen ? lamps : []);
  if (!at.seen) {
    $("numbers").textContent = "Nothing is seen here.";
    $("code").textContent = "// Nothing is seen at this pixel. Choose another.";
    $("vectors").replaceChildren();
    return;
  }
  const values = Object.fromEntries(SETTINGS.map((name, i) => [name, settings()[i]]));
  const colors = Object.fromEntries(COLORS.map((name) => [name, bytes(form.elements[name].value)]));
  $("code").textContent = program(at, values, colors, LAMPS.slice(0, values.second ? 2 : 1), isOn("sun") ? sun() : null);
  drawArrows($("vectors"), at, Number(model), projected);
  const degrees = (cosine) => `${((Math.acos(Math.max(-1, Math.min(1, cosine))) * 180) / Math.PI).toFixed(1)}°`;
  $("lobe").hidden = !dot;
  if (dot) plotLobe($("lobe"), Number(m), at.lamps.map((lamp) => (model === "1" ? lamp.rv : lamp.nh)));
  const row = (name, value, kind = "") => `<dt class="${kind}">${name}</dt><dd class="${kind}">${value}</dd>`;
  const rows_of_lamp = (lamp) => {
    const sub = lamp.name && `<sub>${lamp.name}</sub>`;
    const isSun = lamp.name === "sun"; // which has neither a distance nor a cone
    const behind = lamp.nl <= 0 ? "; not above 0, so no light comes from there" : "";
    const [cosine, name, vector] = model === "1" ? [lamp.rv, "R", lamp.R] : [lamp.nh, "H", lamp.H];
    return [
      row(`L${sub}`, triple(lamp.L)),
      dot ? row(`${name}${sub}`, triple(vector)) : "",
      isSun ? "" : row(`q${sub}`, number(lamp.q)),
      isSun ? "" : row(`f(q${sub})`, `1/(${a} + ${b} · ${number(lamp.q)} + ${c} · ${number(lamp.q)}²) = ${number(lamp.attenuation)}`),
      isSun ? "" : row(`s${sub}`, `${number(lamp.cone)}, the fraction that passes the cone`),
      row(`N·L${sub}`, `${number(lamp.nl)}, at ${degrees(lamp.nl)}${behind}`),
      dot ? row(dot.replace(/<\/?b>/g, "") + sub, `${number(cosine)}, at ${degrees(cosine)}; to the power of ${m}: ${number(lamp.highlight)}`) : "",
    ];
  };
  const sum = (factor) => at.lamps.map((lamp) => {
    const left = lamp.name === "sun" ? "" : `${number(lamp.attenuation)} · ${number(lamp.cone)} · `;
    return `${left}${number(factor(lamp))} · C${lamp.name && `<sub>${lamp.name}</sub>`}`;
  }).join(" + ") || "0";
  const rows = [
    row("P", triple(at.P)),
    row("N", triple(at.N)),
    row("V", triple(at.V)),
    ...at.lamps.flatMap(rows_of_lamp),
    row("ambient", `${ka} · O = ${triple(at.AMBIENT)}`, "ambient"),
    row("diffuse", `${kd} · O · (${sum((lamp) => Math.max(0, lamp.nl))}) = ${triple(at.DIFFUSE)}`, "diffuse"),
    dot ? row("specular", `${ks} · (${sum((lamp) => (lamp.nl > 0 ? lamp.highlight : 0))}) = ${triple(at.SPECULAR)}`, "specular") : "",
    row("I", triple(at.TOTAL)),
    row("sRGB", `${at.SRGB.join(", ")} <span class="swatch"></span>`),
  ];
  $("numbers").innerHTML = `<dl>${rows.join("")}</dl>`;
  document.querySelector(".swatch").style.backgroundColor = `rgb(${at.SRGB})`;
}

let waiting = 0;
function soon() {
  waiting ||= requestAnimationFrame(() => {
    waiting = 0;
    redraw();
  });
}

function label(input) {
  const output = input.labels?.[0]?.querySelector("output");
  if (output) output.textContent = Math.round(100 * input.value) / 100;
}

form.addEventListener("input", ({ target }) => {
  label(target);
  soon();
});
form.addEventListener("reset", () => setTimeout(() => {
  [...form.elements].forEach(label);
  soon();
}));
$("parts").addEventListener("input", soon);

const MOST = 512; // pixels along a side that are drawn while something moves
const REACH = 16; // a lamp is taken by a pointer this near, in pixels of the screen
let dragged = null;

/** The lamp under the pointer, if there is one. */
function lampUnder({ offsetX, offsetY }) {
  const distances = LAMPS.map((_, lamp) => {
    const [x, y] = lampPlace(lamp);
    const is_shown = x >= 0 && x <= 1 && y >= 0 && y <= 1;
    return is_shown ? Math.hypot(x * canvas.clientWidth - offsetX, y * canvas.clientHeight - offsetY) : Infinity;
  });
  const nearest = Math.min(...distances);
  return nearest <= REACH ? distances.indexOf(nearest) : null;
}

/** Moves a lamp to a place in the picture; it keeps its depth and stays within the reach of its sliders. */
function drag(lamp, { offsetX, offsetY }) {
  const { width, height } = canvas;
  const to = [(offsetX / canvas.clientWidth) * width, (offsetY / canvas.clientHeight) * height];
  const position = [0, 1, 2].map((i) => shader.moved(lamp, width, height, ...to, i));
  LAMPS[lamp].names.forEach((name, i) => {
    const input = form.elements[name];
    input.value = position[i];
    label(input);
  });
  soon();
}

function point(event) {
  if (dragged !== null) return drag(dragged, event);
  canvas.classList.toggle("over", lampUnder(event) !== null);
  if (cross.isPinned) return;
  aim(event);
}

/** Moves the cross to the pointer. The background has no numbers, so there the last pixel stays. */
function aim({ offsetX, offsetY }) {
  const [x, y] = [[offsetX, canvas.clientWidth], [offsetY, canvas.clientHeight]].map(([offset, size]) =>
    Math.min(1, Math.max(0, (Math.floor(offset) + 0.5) / size))); // the center of a pixel
  if (!covers(x, y)) return false;
  Object.assign(cross, { x, y });
  explain();
  return true;
}

/** Pins the pixel, or lets it follow the pointer again. */
function pin(isPinned) {
  cross.isPinned = isPinned;
  $("cross").classList.toggle("pinned", isPinned);
  $("pinned").textContent = isPinned ? "The pixel is pinned. Click beside the object to let it follow the pointer."
    : "A click pins the pixel.";
  remember();
}

canvas.addEventListener("pointerdown", (event) => {
  dragged = lampUnder(event);
  if (dragged === null) {
    pin(aim(event) || !cross.isPinned);
    return;
  }
  canvas.setPointerCapture(event.pointerId);
  canvas.classList.add("dragging");
});
canvas.addEventListener("pointermove", point);
for (const end of ["pointerup", "pointercancel"]) {
  canvas.addEventListener(end, () => {
    dragged = null;
    canvas.classList.remove("dragging");
  });
}
// a finger on a lamp drags it; elsewhere it scrolls the page
canvas.addEventListener("touchstart", (event) => {
  const { left, top } = canvas.getBoundingClientRect();
  const { clientX, clientY } = event.changedTouches[0];
  if (lampUnder({ offsetX: clientX - left, offsetY: clientY - top }) !== null) event.preventDefault();
}, { passive: false });

$("copy").addEventListener("click", async () => {
  try {
    await navigator.clipboard.writeText($("code").textContent);
    $("copied").textContent = "Copied.";
  } catch {
    getSelection().selectAllChildren($("code"));
    $("copied").textContent = "The browser refused. The program is selected: copy it with the keyboard.";
  }
});
canvas.addEventListener("keydown", (event) => {
  const [x, y] = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key] ?? [0, 0];
  if (!x && !y) return;
  event.preventDefault();
  const step = event.shiftKey ? 10 : 1;
  const moved = (fraction, by, size) => Math.min(Math.max(fraction + (step * by) / size, 0), 1);
  cross.x = moved(cross.x, x, canvas.width);
  cross.y = moved(cross.y, y, canvas.height);
  pin(true);
  explain();
});

// as many pixels as the picture has room for; a smaller window draws a smaller picture
new ResizeObserver(() => {
  const { clientWidth, clientHeight } = frame;
  const sharp = Math.min(devicePixelRatio, 2, MOST / Math.max(clientWidth, clientHeight));
  [canvas.width, canvas.height] = [clientWidth, clientHeight].map((size) => Math.round(sharp * size));
  redraw();
}).observe(frame);

for (const id of ["models", "meshes"]) $(id).addEventListener("toggle", soon);
addEventListener("hashchange", () => {
  form.reset();
  recall();
  pin(cross.isPinned);
});
recall();
pin(cross.isPinned);
[...form.elements].forEach(label);
document.documentElement.dataset.ready = "";
export { cross, directions, probe, redraw, refine, settings, shader };
