// Prints the digests that a WebAssembly module computes: node wasm.mjs FILE
import { readFile } from "node:fs/promises";

const { instance } = await WebAssembly.instantiate(await readFile(process.argv[2]));
const { single, double, fixed } = instance.exports;
const hex = (digest) => BigInt.asUintN(64, digest()).toString(16).padStart(16, "0");
console.log([single, double, fixed].map(hex).join("-"));
