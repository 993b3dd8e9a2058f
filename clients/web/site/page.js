// The controls go into the module's memory, and the picture comes out of it.

// as `Scene::new` in src/scene.rs takes them; three bytes of color follow
const SETTINGS = ["surface", "model", "ka", "kd", "ks", "m", "x", "y", "z", "a", "b", "c", "angle", "edge"];
// as `numbers` in src/page.rs gives them: numbers, and triples in capitals
const PROBE = ["seen", "P", "N", "V", "AMBIENT", "DIFFUSE", "SPECULAR", "TOTAL", "SRGB", "L", "R", "H",
  "q", "nl", "rv", "nh", "highlight", "attenuation", "cone"];

const $ = (id) => document.getElementById(id);
const [canvas, form, frame] = [$("canvas"), $("controls"), $("frame")];
const context = canvas.getContext("2d");
const thumbnails = [...document.querySelectorAll("#parts canvas")];
const cross = { x: 0.45, y: 0.42 }; // in shares of the picture

let shader;
try {
  const file = await fetch("web.wasm");
  if (!file.ok) throw new Error(`${file.url}: ${file.status}`);
  shader = (await WebAssembly.instantiate(await file.arrayBuffer())).instance.exports;
} catch (error) {
  $("message").textContent = `The picture cannot be drawn: ${error.message}`;
  throw error;
}

/** What the controls say, as numbers in the module's order. */
function settings() {
  const values = new FormData(form);
  const color = values.get("color").match(/\w\w/g).map((byte) => parseInt(byte, 16));
  return [...SETTINGS.map((name) => Number(values.get(name))), ...color];
}

/** Draws a part into a canvas, in the canvas's size. */
function draw(part, { width, height }, context) {
  const at = shader.draw(part, width, height);
  const message = new Uint8Array(shader.memory.buffer, shader.message(), shader.message_length());
  if (width && height) {
    const pixels = new Uint8ClampedArray(shader.memory.buffer, at, 4 * width * height);
    context.putImageData(new ImageData(pixels, width, height), 0, 0);
  }
  return new TextDecoder().decode(message);
}

function redraw() {
  new Float32Array(shader.memory.buffer, shader.settings(), SETTINGS.length + 3).set(settings());
  thumbnails.forEach((canvas, part) => draw(part, canvas, canvas.getContext("2d")));
  const part = Number(document.querySelector("[name=part]:checked").value);
  $("message").textContent = draw(part, canvas, context);
  const { width, height } = canvas;
  place($("lamp"), shader.lamp_x(width, height) / width, shader.lamp_y(width, height) / height);
  explain();
}

function place(marker, x, y) {
  marker.hidden = !(x >= 0 && x <= 1 && y >= 0 && y <= 1);
  Object.assign(marker.style, { left: `${100 * x}%`, top: `${100 * y}%` });
}

/** The numbers of the pixel under the cross. */
function probe() {
  const { width, height } = canvas;
  const at = (share, size) => Math.min(Math.floor(share * size), size - 1);
  const address = shader.probe(width, height, at(cross.x, width), at(cross.y, height));
  const numbers = [...new Float32Array(shader.memory.buffer, address, 41)];
  const take = (name) => (name > "Z" ? numbers.shift() : numbers.splice(0, 3));
  return Object.fromEntries(PROBE.map((name) => [name, take(name)]));
}

const number = (x) => (Math.abs(x) >= 1000 ? x.toExponential(2) : x.toFixed(3)).replace("-", "−");
const triple = (t) => `(${t.map(number).join(", ")})`;

function explain() {
  place($("cross"), cross.x, cross.y);
  const { ka, kd, ks, m, a, b, c, model } = Object.fromEntries(new FormData(form));
  const dot = { 1: "<b>R</b>·<b>V</b>", 2: "<b>N</b>·<b>H</b>" }[model];
  const highlight = dot ? ` + <span class="specular">k<sub>s</sub> max(0, ${dot})<sup>m</sup></span>` : "";
  $("formula").innerHTML = `I = <span class="ambient">k<sub>a</sub> O</span> + f(q) s
    (<span class="diffuse">k<sub>d</sub> O max(0, <b>N</b>·<b>L</b>)</span>${highlight})`;

  const at = probe();
  if (!at.seen) {
    $("numbers").textContent = "Nothing is seen here.";
    return;
  }
  const behind = at.nl <= 0 ? " ≤ 0: turned from the lamp, no light from it" : "";
  const [cosine, vector] = model === "1" ? [at.rv, ["R", at.R]] : [at.nh, ["H", at.H]];
  const lit = at.nl > 0 ? at.highlight : 0;
  const share = `${number(at.attenuation)} · ${number(at.cone)}`;
  const row = (name, value, kind = "") => `<dt class="${kind}">${name}</dt><dd class="${kind}">${value}</dd>`;
  const rows = [
    row("P", triple(at.P)),
    row("N", triple(at.N)),
    row("L", triple(at.L)),
    row("V", triple(at.V)),
    dot ? row(vector[0], triple(vector[1])) : "",
    row("q", number(at.q)),
    row("f(q)", `1/(${a} + ${b} · ${number(at.q)} + ${c} · ${number(at.q)}²) = ${number(at.attenuation)}`),
    row("s", `${number(at.cone)}, the cone's share`),
    row("N·L", number(at.nl) + behind),
    dot ? row(dot.replace(/<\/?b>/g, ""), `${number(cosine)}; to the power of ${m}: ${number(at.highlight)}`) : "",
    row("ambient", `${ka} · O = ${triple(at.AMBIENT)}`, "ambient"),
    row("diffuse", `${share} · ${kd} · O · ${number(Math.max(0, at.nl))} = ${triple(at.DIFFUSE)}`, "diffuse"),
    dot ? row("specular", `${share} · ${ks} · ${number(lit)} = ${triple(at.SPECULAR)}`, "specular") : "",
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
  if (output) output.textContent = input.value;
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

function point({ offsetX, offsetY }) {
  // the center of a pixel, which rounding does not move to the next
  cross.x = Math.max(0, (Math.floor(offsetX) + 0.5) / canvas.clientWidth);
  cross.y = Math.max(0, (Math.floor(offsetY) + 0.5) / canvas.clientHeight);
  explain();
}
canvas.addEventListener("pointerdown", point);
canvas.addEventListener("pointermove", point);
canvas.addEventListener("keydown", (event) => {
  const [x, y] = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key] ?? [0, 0];
  if (!x && !y) return;
  event.preventDefault();
  const step = event.shiftKey ? 10 : 1;
  const moved = (share, by, size) => Math.min(Math.max(share + (step * by) / size, 0), 1);
  cross.x = moved(cross.x, x, canvas.width);
  cross.y = moved(cross.y, y, canvas.height);
  explain();
});

// as many pixels as the picture has room for; a smaller window draws a smaller picture
new ResizeObserver(() => {
  [canvas.width, canvas.height] = [frame.clientWidth, frame.clientHeight];
  redraw();
}).observe(frame);

[...form.elements].forEach(label);
document.documentElement.dataset.ready = "";
export { probe, redraw, settings, shader };
