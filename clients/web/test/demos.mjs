// Drives the page for demos as a user does: node demos.mjs DRAW [PICTURES]
// DRAW is the program that draws the same picture on this machine. The pictures must be equal to the bit.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdir, mkdtemp, rm, stat, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { browser, close, folder, home, is_accessible, open as open_page, PHONE } from "./site.mjs";

const [draw, pictures] = process.argv.slice(2);

async function open(options = {}, hash = "") {
  const page = await open_page(`demos/${hash}`, options);
  await page.waitForSelector("html[data-ready]");
  await page.evaluate(() => import("./page.js").then((module) => Object.assign(window, { module })));
  await drawn(page);
  return page;
}

const drawn = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => setTimeout(done))));

/** Sets controls as a user's hand does, with an event for each. */
async function set(page, values) {
  await page.evaluate((values) => {
    for (const [name, value] of Object.entries(values)) {
      const inputs = [...document.querySelectorAll(`[name=${name}]`)];
      const input = inputs.find(({ type }) => type !== "radio") ?? inputs.find((radio) => radio.value === String(value));
      if (input.type === "radio") input.checked = true;
      else if (input.type === "checkbox") input.checked = value;
      else input.value = value;
      input.dispatchEvent(new Event("input", { bubbles: true }));
    }
  }, values);
  await drawn(page);
}

const seen = (page, id = "canvas") => page.evaluate((id) => {
  const canvas = document.getElementById(id);
  const { data, width, height } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
  const part = document.querySelector("[name=part]:checked").value;
  const text = Array.from(data, (byte) => String.fromCharCode(byte)).join("");
  return { text, part, width, height, settings: window.module.settings() };
}, id).then(({ text, ...rest }) => ({ data: Buffer.from(text, "latin1"), ...rest }));

/** The canvas beside the same picture of this machine. */
async function same_as_host(page, what, id = "canvas") {
  const { data, part, width, height, settings } = await seen(page, id);
  const options = { maxBuffer: 1e8, stdio: ["ignore", "pipe", "ignore"] };
  const host = execFileSync(draw, [part, width, height, ...settings].map(String), options);
  assert.equal(host.length, data.length, what);
  assert.ok(host.equals(data), `${what}: another picture than the host's`);
  return data;
}

/** The eye: (0, 1, 5), raised about the x axis and then turned about the y axis. */
function eye_of({ walk, climb }) {
  const [w, c] = [walk, climb].map((degrees) => degrees * Math.PI / 180);
  const [y, z] = [Math.cos(c) + 5 * Math.sin(c), 5 * Math.cos(c) - Math.sin(c)];
  return [z * Math.sin(w), y, z * Math.cos(w)];
}

const CASES = {
  "as it opens": {},
  "another diffuse reflectance": { kd: 0.3 },
  "a second lamp": { second: true, x2: 2, y2: 0.5, light2: "#40ff80" },
  "a first one of another color": { light: "#ff8000" },
  "the second lamp off again": { second: false },
  "Phong": { model: 1, m: 7 },
  "Lambert": { model: 0 },
  "a sphere in a soft cone": { model: 2, surface: 0, angle: 20, edge: 12, x: -3.1, y: 0.4 },
  "its diffuse part": { part: 2 },
  "its specular part": { part: 3, m: 200 },
  "the object turned": { part: 0, surface: 1, turn: 70 },
  "from another side, and above": { walk: -120, climb: 50 },
  "in the sun alone": { sun: true, light: "#000000", heading: -100, sunlight: "#ffd080" },
  "a sun below": { altitude: -30, light: "#ffffff", angle: 170 },
  "everything at its least": Object.fromEntries(
    ["ka", "kd", "ks", "m", "x", "y", "z", "b", "c", "angle", "edge"].map((name) => [name, -9]).concat([["sun", false]])),
  "no falloff that has a value": { a: 0, part: 0, ka: 0.2 },
  "the lamp at the center": { walk: 0, climb: 0, surface: 0, x: 0, y: 0, z: 0, a: 1, ka: 0.1, kd: 1, angle: 180 },
  "the lamp at the eye": { x: 0, y: 1, z: 5, ks: 1, m: 0 },
  "everything at its most": Object.fromEntries(
    ["ka", "kd", "ks", "m", "x", "y", "z", "a", "b", "c", "angle", "edge"].map((name) => [name, 999])),
};

const LAST_WORDS = {
  "no falloff that has a value": /has no value/,
  "the lamp at the center": /lights nothing/,
  "everything at its least": /lights nothing/,
};

{
  const page = await open();
  let before;
  for (const [what, values] of Object.entries(CASES)) {
    await set(page, values);
    const data = await same_as_host(page, what);
    assert.ok(!before?.equals(data), `${what}: nothing changed`);
    before = data;
    const message = await page.textContent("#message");
    assert.match(message, LAST_WORDS[what] ?? /^$/, what);
  }
  await page.close();
  console.log(`${Object.keys(CASES).length} pictures, each with the host's bits`);
}

// the numbers beside the picture, by the formula in doubles, and the pixel by the numbers
{
  const page = await open();
  for (const values of [{}, { model: 1, m: 12 }, { surface: 0, x: 2.5, angle: 40, edge: 15, b: 0.3 },
    { second: true, light2: "#ff2080", x2: -1, y2: 1.5, z2: 3, light: "#80ffc0" },
    { sun: true, heading: 20, altitude: 35, walk: 25, climb: -10, turn: 40, surface: 1 }, { second: false, sunlight: "#ff8000" }]) {
    await set(page, values);
    const at = await page.evaluate(() => window.module.probe());
    const form = await page.evaluate(() => Object.fromEntries([...new FormData(document.getElementById("controls"))]));
    const { ka, kd, ks, m, a, b, c, model } = form;
    const dot = (u, v) => u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
    const unit = (v) => v.map((c) => c / Math.hypot(...v));
    const decoded = (color) => color.match(/\w\w/g).map((byte) => parseInt(byte, 16) / 255)
      .map((e) => (e <= 0.04045 ? e / 12.92 : ((e + 0.055) / 1.055) ** 2.4));
    const v = unit(eye_of(form).map((c, i) => c - at.P[i]));
    const lamps = [["x", "y", "z", "light"], ["x2", "y2", "z2", "light2"]].slice(0, form.second ? 2 : 1);
    if (form.sun) lamps.push(["sunlight"]);
    assert.equal(at.lamps.length, lamps.length);
    const [heading, altitude] = ["heading", "altitude"].map((name) => form[name] * Math.PI / 180);
    const sun = [Math.sin(heading) * Math.cos(altitude), Math.sin(altitude), Math.cos(heading) * Math.cos(altitude)];
    const arriving = lamps.map((names, k) => {
      const color = names.at(-1);
      const is_sun = color === "sunlight";
      const to_lamp = is_sun ? sun : names.slice(0, 3).map((name, i) => Number(form[name]) - at.P[i]);
      const [q, l] = [Math.hypot(...to_lamp), unit(to_lamp)];
      const nl = dot(at.N, l);
      const r = at.N.map((n, i) => 2 * nl * n - l[i]);
      const cosine = model === "1" ? dot(r, v) : dot(at.N, unit(l.map((c, i) => c + v[i])));
      const f = is_sun ? 1 : (1 / (Number(a) + b * q + c * q * q)) * at.lamps[k].cone;
      const highlight = nl > 0 && cosine > 0 ? cosine ** m : 0;
      return { light: decoded(form[color]).map((channel) => f * channel), nl, highlight };
    });
    decoded(form.color).forEach((o, i) => {
      const expected = ka * o + arriving.reduce((sum, { light, nl, highlight }) =>
        sum + light[i] * (kd * o * Math.max(0, nl) + ks * highlight), 0);
      // rounding of some twenty operations in f32, the power's m times, for each lamp
      assert.ok(Math.abs(expected - at.TOTAL[i]) < 2e-5 * (1 + Number(m)), `${expected}, ${at.TOTAL[i]}`);
      const e = Math.min(1, at.TOTAL[i]);
      const byte = 255 * (e <= 0.0031308 ? 12.92 * e : 1.055 * e ** (1 / 2.4) - 0.055);
      assert.ok(Math.abs(byte - at.SRGB[i]) <= 0.51, `byte ${at.SRGB[i]}, by the formula ${byte}`);
    });
    const { data, width, height } = await seen(page);
    const pixel = 4 * (Math.floor(0.42 * height) * width + Math.floor(0.45 * width));
    assert.deepEqual([...data.subarray(pixel, pixel + 3)], at.SRGB);
  }
  await page.close();
  console.log("the numbers of the pixel are the formula's");
}

// with a mouse: the numbers are those of the pixel under it
{
  const page = await open();
  const box = await page.locator("#canvas").boundingBox();
  const at = (x, y) => page.mouse.move(Math.ceil(box.x + x * box.width), Math.ceil(box.y + y * box.height));
  for (const [x, y] of [[0.51, 0.5], [0.3, 0.57], [0.6, 0.55]]) {
    await at(x, y);
    const { SRGB, seen: is_seen } = await page.evaluate(() => window.module.probe());
    assert.equal(is_seen, 1);
    const { data, width } = await seen(page);
    const [column, row] = [Math.ceil(x * box.width), Math.ceil(y * box.height)];
    // the picture may begin between two rows or columns of the screen
    const shifts = [-1, 0, 1].flatMap((i) => [-1, 0, 1].map((j) => [i, j]));
    const colors = shifts.map(([i, j]) => 4 * ((row + j) * width + column + i))
      .map((pixel) => [...data.subarray(pixel, pixel + 3)].join());
    assert.ok(colors.includes(SRGB.join()), `${SRGB} is none of ${colors.join("; ")}`);
    const words = await page.textContent("#numbers");
    assert.ok(words.includes(SRGB.join(", ")), words);
  }

  // over the background the last pixel stays; a click pins a pixel, and a click on the background lets it go
  const numbers = () => page.textContent("#numbers");
  const last = await numbers();
  await at(0.5, 0.95);
  assert.equal(await numbers(), last, "the background keeps the pixel");
  const code = await page.textContent("#code");
  assert.match(code, /let p = Vec3::new/);
  await at(0.5, 0.55);
  await page.mouse.down();
  await page.mouse.up();
  const pinned = await numbers();
  assert.notEqual(pinned, last);
  await at(0.35, 0.6);
  assert.equal(await numbers(), pinned, "a pinned pixel stays");
  await set(page, { second: true });
  assert.notEqual(await numbers(), pinned, "its numbers follow the controls");
  assert.notEqual(await page.textContent("#code"), code, "and so does its program");
  const link = await page.evaluate(() => location.hash);
  assert.match(link, /second=on/);
  await at(0.5, 0.95);
  await page.mouse.down();
  await page.mouse.up();
  await at(0.35, 0.6);
  assert.notEqual(await numbers(), pinned, "a click on the background lets it follow again");
  await page.close();

  // the link shows the same: every control
  const every = { model: 1, surface: 0, part: 3, turn: 17, walk: -31, climb: 12, ka: 0.21, kd: 0.43, ks: 0.77, m: 19, color: "#102030",
    x: -1.5, y: 0.75, z: 2.25, light: "#fedcba", second: true, x2: 1.25, y2: -0.5, z2: 3, light2: "#abcdef", a: 0.5, b: 0.25, c: 0.12,
    angle: 44, edge: 11, sun: true, heading: -70, altitude: 25, sunlight: "#f0e0d0" };
  {
    const page = await open();
    const names = await page.evaluate(() => [...document.querySelectorAll("input[name]")].map(({ name }) => name));
    assert.deepEqual([...new Set(names)].sort(), Object.keys(every).sort(), "a control that the link may forget");
    await set(page, every);
    const other = await open({}, await page.evaluate(() => location.hash));
    for (const [name, value] of Object.entries(every)) {
      const restored = await other.evaluate((name) => {
        const control = document.getElementById("controls").elements[name];
        return control.type === "checkbox" ? control.checked : control.value;
      }, name);
      assert.equal(String(restored), String(value), `${name} is not in the link`);
    }
    const pictures = await Promise.all([page, other].map((page) => seen(page)));
    assert.ok(pictures[0].data.equals(pictures[1].data), "the link draws another picture");
    await page.close();
    await other.close();
  }
  const other = await open({}, link);
  assert.ok(await other.isChecked("[name=second]"));
  assert.ok(Math.abs(await other.evaluate(() => window.module.cross.x) - 0.5) < 0.01);
  assert.equal(await other.evaluate(() => location.hash), link);
  await other.close();
  console.log("a click pins the pixel, and the link keeps it");
}

// the arrows begin at the pixel and end where the directions of the crate do, by a camera of our own
for (const view of [{ walk: 0, climb: 0 }, { walk: 40, climb: 20 }]) {
  const page = await open();
  await set(page, { second: true, model: 1, sun: true, ...view });
  const { at, lines, size } = await page.evaluate(() => ({
    at: window.module.probe(),
    size: document.getElementById("canvas").width,
    lines: [...document.querySelectorAll("#vectors g")].map((group) => {
      const line = group.querySelector("line");
      return [group.textContent, ...["x1", "y1", "x2", "y2"].map((name) => Number(line.getAttribute(name)))];
    }),
  }));
  // the eye looks at the origin; 1.75 is the picture's side at the distance 1
  const eye = eye_of(view);
  const [away, root] = [Math.hypot(eye[0], eye[2]), Math.hypot(...eye)];
  const seen_at = ([x, y, z]) => {
    const depth = root - (x * eye[0] + y * eye[1] + z * eye[2]) / root;
    const right = (x * eye[2] - z * eye[0]) / away;
    const up = (y * away - (eye[1] * (x * eye[0] + z * eye[2])) / away) / root;
    return [50 + (175 * right) / depth, 50 - (175 * up) / depth];
  };
  const [l1, l2, sun] = at.lamps;
  const expected = { N: at.N, V: at.V, "L₁": l1.L, "R₁": l1.R, "L₂": l2.L, "R₂": l2.R, "Lₛ": sun.L, "Rₛ": sun.R };
  assert.deepEqual(lines.map(([name]) => name).sort(), Object.keys(expected).sort());
  for (const [name, x1, y1, x2, y2] of lines) {
    const ends = [...seen_at(at.P), ...seen_at(at.P.map((p, i) => p + 0.6 * expected[name][i]))];
    [x1, y1, x2, y2].forEach((x, i) => assert.ok(Math.abs(x - ends[i]) < 1e-2, `${name}: ${x}, not ${ends[i]}`));
  }
  // the cross is at the pixel's center, and the arrows at the point that is seen there
  const [, x1, y1] = lines[0];
  assert.ok(Math.hypot(x1 - 45, y1 - 42) < 100 / size + 0.1, `${x1}, ${y1}`);
  await page.close();
}
console.log("the arrows are where the directions are, seen from two sides");

// beside the picture by pixels, the same on a mesh: flat has the fewest colors, and Gouraud fewer than each pixel
{
  const page = await open();
  await page.click("#meshes summary");
  await set(page, { surface: 0 });
  const colors = await page.evaluate(() => [...document.querySelectorAll("#meshes canvas")].map((canvas) => {
    const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
    return new Set(new Uint32Array(data.buffer)).size;
  }));
  // an octahedron in 4² triangles per face, and the background
  assert.ok(colors[0] > 20 && colors[0] <= 8 * 16 + 1 && colors[0] * 2 < colors[1] && colors[0] * 2 < colors[2], `${colors}`);
  await page.close();
}

// a lamp outside of the picture, one behind the object, and a lamp that is off
{
  const page = await open();
  const kinds = () => page.evaluate(() => document.getElementById("lamp").className);
  await set(page, { x: 6, y: 0, z: 0 });
  assert.match(await kinds(), /outside/);
  assert.equal(await page.textContent("#lamp-place"), "outside of the picture");
  await set(page, { x: 0, y: 0, z: -3 });
  assert.match(await kinds(), /far/);
  assert.equal(await page.textContent("#lamp-place"), "behind the object");
  await set(page, { x: 0, y: 1.1, z: 6 });
  assert.equal(await page.textContent("#lamp-place"), "behind the eye");
  await set(page, { x: 0.8, y: 1.2, z: 1.8, a: 0, c: 0 });
  assert.equal(await page.textContent("#lamp-place"), "off", "the falloff has no value");
  assert.ok(await page.isHidden("#lamp"));
  await set(page, { a: 0.8, c: 0.02 });
  assert.doesNotMatch(await kinds(), /far|outside/);
  for (const name of ["x2", "heading"]) assert.ok(await page.isDisabled(`[name=${name}]`), "the controls of a light that is off are off");
  await set(page, { second: true });
  assert.ok(!(await page.isDisabled("[name=x2]")));
  await page.close();
}

// a screen with more pixels gets them
{
  const page = await open({ deviceScaleFactor: 2 });
  await page.waitForSelector("#fine", { state: "visible" });
  const { width, shown } = await page.evaluate(() => {
    const { width, clientWidth } = document.getElementById("fine");
    return { width, shown: clientWidth };
  });
  assert.equal(width, 2 * shown);
  await same_as_host(page, "twice the pixels", "fine");
  await page.close();
}

// at rest the picture is smooth: a white disk on black, of the radius 0.35 of the window, has grays at its edge alone
{
  const page = await open({ bypassCSP: true });
  await page.addStyleTag({ content: "#vectors, .marker { display: none; }" });
  await set(page, { surface: 0, color: "#ffffff", ka: 1, kd: 0, ks: 0 });
  const levels = async () => {
    const picture = await page.locator("#frame").screenshot();
    return page.evaluate(async (url) => {
      const image = Object.assign(new Image(), { src: url });
      await image.decode();
      const { width, height } = image;
      const context = new OffscreenCanvas(width, height).getContext("2d");
      context.drawImage(image, 0, 0);
      // without the round corners
      const { data } = context.getImageData(20, 20, width - 40, height - 40);
      const reds = data.filter((_, i) => i % 4 === 0);
      return { side: width, area: reds.reduce((sum, red) => sum + red / 255, 0), grays: reds.filter((red) => red > 8 && red < 247).length };
    }, `data:image/png;base64,${picture.toString("base64")}`);
  };
  await page.waitForSelector("#fine", { state: "visible" });
  await same_as_host(page, "at rest", "fine");
  const { side, area, grays } = await levels();
  const radius = 0.35 * side;
  assert.ok(Math.abs(area / (Math.PI * radius ** 2) - 1) < 0.005, `${area}`);
  // a circle crosses 8 r pixels, and 4 r squares of four samples, whose sides are half as long (by Cauchy and Crofton)
  assert.ok(grays > 3 * radius && grays < 9 * radius, `${grays} grays, where the radius is ${radius}`);
  // while something moves there is no time for it
  await page.evaluate(() => window.module.redraw());
  assert.ok(await page.isHidden("#fine"));
  await page.close();
  console.log(`at rest the edge of a disk has ${grays} grays on ${Math.round(2 * Math.PI * radius)} pixels`);
}

// opened as a file, the page says why it is dead
{
  const page = await browser.newPage();
  await page.goto(`file://${folder}demos/index.html`);
  await page.waitForFunction(() => document.getElementById("start").textContent.includes("opened as a file"));
  await page.goto(`file://${folder}exercises/index.html`);
  await page.waitForFunction(() => document.getElementById("start").textContent.includes("opened as a file"));
  await page.close();
  console.log("opened as files, the pages say why they are dead");
}

// a lamp is dragged on the picture: it follows the pointer, its sliders follow it, and the picture is the host's
{
  const page = await open();
  await set(page, { second: true });
  const box = await page.locator("#canvas").boundingBox();
  for (const [marker, names, to] of [["#lamp", ["x", "y", "z"], [90, 120]], ["#lamp2", ["x2", "y2", "z2"], [320, 90]]]) {
    const center = async () => {
      const { x, y, width, height } = await page.locator(marker).boundingBox();
      return [x + width / 2 - box.x, y + height / 2 - box.y];
    };
    const values = () => Promise.all(names.map((name) => page.inputValue(`[name=${name}]`)));
    const [before, cross, old] = [await values(), await page.locator("#cross").boundingBox(), await seen(page)];
    const [x, y] = await center();
    await page.mouse.move(box.x + x + 3, box.y + y - 2);
    await page.mouse.down();
    await page.mouse.move(box.x + to[0], box.y + to[1], { steps: 5 });
    await page.mouse.up();
    // the released lamp does not follow
    await page.mouse.move(box.x + (marker === "#lamp" ? 0.5 : 0.6) * box.width, box.y + 0.55 * box.height);
    await drawn(page);
    const at = await center();
    assert.ok(Math.hypot(at[0] - to[0], at[1] - to[1]) < 1.5, `${marker} is at ${at}, not at ${to}`);
    assert.notDeepEqual(await values(), before);
    assert.notDeepEqual(await page.locator("#cross").boundingBox(), cross, "the pointer moves the cross again");
    assert.ok(!old.data.equals(await same_as_host(page, `${marker} dragged`)));
  }
  await page.close();
  console.log("lamps are dragged on the picture");
}

// with a finger: on a lamp it drags
{
  const page = await open({ ...PHONE });
  const box = await page.locator("#canvas").boundingBox();
  const lamp = await page.locator("#lamp").boundingBox();
  const [x, y] = [lamp.x + lamp.width / 2, lamp.y + lamp.height / 2];
  const before = await page.inputValue("[name=x]");
  await page.evaluate(() => scrollTo(0, 0));
  const client = await page.context().newCDPSession(page);
  const touch = (type, points) => client.send("Input.dispatchTouchEvent", { type, touchPoints: points });
  await touch("touchStart", [{ x, y }]);
  await touch("touchMove", [{ x: x - 30, y: y + 20 }]);
  await touch("touchMove", [{ x: x - 60, y: y + 40 }]);
  await touch("touchEnd", []);
  await drawn(page);
  const after = await page.locator("#lamp").boundingBox();
  assert.ok(Math.hypot(after.x - lamp.x + 60, after.y - lamp.y - 40) < 3, JSON.stringify([lamp, after, box]));
  assert.notEqual(await page.inputValue("[name=x]"), before);
  await page.close();
}

// the Rust that the page copies prints the bytes of the pixel
{
  const page = await open();
  await page.context().grantPermissions(["clipboard-read", "clipboard-write"]);
  const folder = await mkdtemp(join(tmpdir(), "page-"));
  const shading = new URL("../../../", import.meta.url).pathname;
  await mkdir(join(folder, "src"));
  await writeFile(join(folder, "Cargo.toml"),
    `[package]\nname = "pixel"\nedition = "2024"\n[dependencies]\nshading = { path = ${JSON.stringify(shading)} }\n[workspace]\n`);
  await page.click("#rust summary");
  for (const values of [{}, { model: 0, second: true, angle: 50, edge: 20, m: 7 }, { model: 1, light2: "#ff4000", second: true },
    { sun: true, heading: -70, turn: 30 }, { a: 0, c: 0 }, { sun: false }]) {
    await set(page, values);
    await page.click("#copy");
    await page.waitForFunction(() => document.getElementById("copied").textContent === "Copied.");
    const program = await page.evaluate(() => navigator.clipboard.readText());
    await writeFile(join(folder, "src/main.rs"), program);
    const printed = execFileSync("cargo", ["run", "--quiet", "--offline"], { cwd: folder, stdio: ["ignore", "pipe", "inherit"],
      env: { ...process.env, CARGO_TARGET_DIR: join(folder, "target"), RUSTFLAGS: "-D warnings" } });
    const { SRGB } = await page.evaluate(() => window.module.probe());
    assert.equal(String(printed).trim(), `[${SRGB.join(", ")}]`, program);
  }
  await rm(folder, { recursive: true });
  await page.close();
  console.log("the copied Rust prints the pixel's bytes");
}

// the link to the documentation
{
  const page = await browser.newPage();
  await page.route("https://docs.rs/**", (route) => route.fulfill({ body: "documentation", contentType: "text/plain" }));
  await page.goto(`${home}demos/`);
  await page.click("#docs");
  await page.waitForURL("https://docs.rs/shading");
  await page.close();
}

// without a mouse
{
  const page = await open();
  const before = await page.textContent("#numbers");
  await page.focus("#canvas");
  await page.keyboard.press("Shift+ArrowRight");
  assert.notEqual(await page.textContent("#numbers"), before, "arrow keys move the cross");
  const reached = new Set();
  for (let i = 0; i < 60; i++) {
    await page.keyboard.press("Tab");
    reached.add(await page.evaluate(() => document.activeElement.name ?? document.activeElement.type));
  }
  const names = await page.evaluate(() => [...document.querySelectorAll("input:enabled")].map(({ name }) => name));
  for (const name of names) assert.ok(reached.has(name), `Tab does not reach ${name}`);
  const old = await seen(page);
  await page.focus("[name=kd]");
  await page.keyboard.press("ArrowLeft");
  await drawn(page);
  assert.equal(Number(await page.inputValue("[name=kd]")), 0.64);
  assert.ok(!old.data.equals(await same_as_host(page, "by keys")), "a key moves a slider and changes the picture");
  // no room for a picture
  await page.evaluate(() => { document.getElementById("frame").style.maxWidth = "0"; });
  await page.waitForFunction(() => document.getElementById("message").textContent.includes("no room"));
  await page.evaluate(() => { document.getElementById("frame").style.maxWidth = ""; });
  await page.waitForFunction(() => document.getElementById("message").textContent === "");
  await page.close();
  console.log("keys reach and move everything; a window without room gets a message");
}

for (const colorScheme of ["light", "dark"]) {
  const views = { wide: {}, large: { viewport: { width: 1920, height: 1080 } }, phone: PHONE };
  for (const [name, options] of Object.entries(views)) {
    const page = await open({ ...options, colorScheme, bypassCSP: true });
    await set(page, { second: true });
    await page.click("#rust summary");
    await page.click("#models summary");
    await is_accessible(page, `${colorScheme} ${name}`);
    await page.evaluate(() => scrollTo(0, 0));
    await page.evaluate(() => window.module.refine());
    if (pictures) await page.screenshot({ path: join(pictures, `demos_${name}_${colorScheme}.png`) });
    await page.close();
  }
}
console.log("axe-core finds nothing wrong, light or dark, wide or on a phone");

// quick enough to follow a slider, in a large window, too
for (const viewport of [{ width: 1200, height: 890 }, { width: 1920, height: 1080 }]) {
  const page = await open({ viewport });
  const { size, times, atRest } = await page.evaluate(async () => {
    const { redraw, refine } = window.module;
    const input = document.querySelector("[name=x]");
    const times = [];
    while (times.length < 60) {
      await new Promise(requestAnimationFrame);
      input.value = 3 * Math.sin(times.length / 10);
      const start = performance.now();
      redraw();
      times.push(performance.now() - start);
    }
    const canvas = document.getElementById("canvas");
    const start = performance.now();
    refine();
    const atRest = performance.now() - start;
    return { size: [canvas.width, canvas.height], times: times.sort((a, b) => a - b), atRest };
  });
  // the quickest tenth: a processor that others use, too, is slow now and then, but hardly in 54 pictures of 60
  const ms = times[times.length / 10];
  console.log(`a picture of ${size.join(" × ")} in ${ms.toFixed(1)} ms, and the smooth one in ${atRest.toFixed(0)} ms`);
  assert.ok(ms <= 1000 / 30, `${ms} ms are fewer than 30 pictures a second`);
  await page.close();
}

const { size } = await stat(join(folder, "demos/demos.wasm"));
assert.ok(size < 65_536, `${size} bytes`);

await close();
