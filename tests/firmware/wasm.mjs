// Prints the digest that a WebAssembly module computes: node wasm.mjs FILE
import { readFile } from "node:fs/promises";

const module = await WebAssembly.instantiate(await readFile(process.argv[2]));
const digest = BigInt.asUintN(64, module.instance.exports.digest());
console.log(digest.toString(16).padStart(16, "0"));
