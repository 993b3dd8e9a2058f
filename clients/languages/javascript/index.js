// For browsers, with or without a bundler.
import { instance } from "./core.js";

export { directional, point, spot } from "./core.js";

async function compiled(source) {
  if (source instanceof WebAssembly.Module) return source;
  if (source instanceof ArrayBuffer || ArrayBuffer.isView(source)) return WebAssembly.compile(source);
  if (!(source instanceof URL || typeof source === "string")) {
    throw new TypeError("source: expected a URL, the bytes of shading.wasm or a WebAssembly.Module");
  }
  const response = await fetch(source);
  if (!response.ok) throw new Error(`${source}: ${response.status}`);
  return WebAssembly.compile(await response.arrayBuffer());
}

export async function load(source = new URL("shading.wasm", import.meta.url)) {
  return instance(await compiled(source));
}
