// Copies the module that cargo has built beside index.js, from where the package loads it.
import { copyFileSync } from "node:fs";
import { fileURLToPath } from "node:url";

const target = process.env.CARGO_TARGET_DIR ?? fileURLToPath(new URL("../../target", import.meta.url));
copyFileSync(`${target}/wasm32-unknown-unknown/release/shading_c.wasm`, new URL("shading.wasm", import.meta.url));
