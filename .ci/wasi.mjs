// Runs a WebAssembly program built for wasm32-wasip1: node --no-warnings wasi.mjs PROGRAM ARGUMENT...
// A panic ends the program before its test can print the output that it captured, so no output is captured.
import { readFile } from "node:fs/promises";
import { WASI } from "node:wasi";

const args = process.argv.slice(2);
const wasi = new WASI({ version: "preview1", args, env: { RUST_TEST_NOCAPTURE: "1" } });
const module = await WebAssembly.compile(await readFile(args[0]));
process.exitCode = wasi.start(await WebAssembly.instantiate(module, wasi.getImportObject()));
