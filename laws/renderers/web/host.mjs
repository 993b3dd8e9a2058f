// Babylon.js' StandardMaterial behind pipes, in the format of shading-laws: node host.mjs [PROFILE]
// PROFILE is JSON with what to say of it besides.
import { createRequire } from "node:module";
import { createInterface } from "node:readline";
import { chromium } from "playwright-core";
import { shade, start } from "./page.mjs";

const profile = {
  name: "Babylon.js' StandardMaterial",
  models: ["lambert", "blinn_phong"],
  lights: ["directional"],
  ...JSON.parse(process.argv[2] ?? "{}"),
};

const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox", "--disable-gpu", "--enable-unsafe-swiftshader", "--disable-quic", "--no-first-run",
    "--disable-background-networking", "--disable-component-update", "--disable-sync"],
});
const page = await browser.newPage();
page.on("pageerror", (error) => console.error(error));
page.on("console", (message) => message.type() === "error" && console.error(message.text()));
await page.addScriptTag({ path: createRequire(import.meta.url).resolve("babylonjs/babylon.js") });
await page.evaluate(start);

let lines = [];
for await (const line of createInterface({ input: process.stdin })) {
  if (line === '{"shading-laws":1}') {
    console.log(JSON.stringify(profile));
  } else if (line) {
    lines.push(line);
  } else {
    const colors = await page.evaluate(shade, { json: `[${lines}]`, clamps: profile.clamps });
    process.stdout.write(colors.map((color) => `[${color}]\n`).join(""));
    lines = [];
  }
}
await browser.close();
