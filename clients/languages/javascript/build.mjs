// Builds the package into this folder: the WebAssembly with lanes, the copies for `require`, and the README.
import { execFileSync } from "node:child_process";
import { copyFileSync, readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";

const here = (name) => fileURLToPath(new URL(name, import.meta.url));

// a folder of its own: with other flags, cargo builds everything anew
const target = `${process.env.CARGO_TARGET_DIR ?? here("../../target")}/lanes`;
const triple = "wasm32-unknown-unknown";
execFileSync("cargo", ["build", "--quiet", "--release", "--package", "languages", "--lib", "--target", triple], {
  cwd: here("."),
  stdio: "inherit",
  env: { ...process.env, CARGO_TARGET_DIR: target, RUSTFLAGS: "-C target-feature=+simd128" },
});
copyFileSync(`${target}/${triple}/release/shading_c.wasm`, here("shading.wasm"));

const module = readFileSync(here("core.js"), "utf8");
const common = module
  .replace(/^export const (\w+) =/gm, "const $1 = exports.$1 =")
  .replace(/^export async function (\w+)/gm, "exports.$1 = $1;\nasync function $1");
if (/^(export|import) /m.test(common)) throw new Error("core.js: an import or export that build.mjs does not know");
writeFileSync(here("core.cjs"), common);
copyFileSync(here("index.d.ts"), here("index.d.cts"));
