// For Node.js, which reads the module from a file.
import { readFile } from "node:fs/promises";

import { load as loadFrom } from "./index.js";

export { directional, point, spot } from "./core.js";

export async function load(source = new URL("shading.wasm", import.meta.url)) {
  const isUrl = source instanceof URL || typeof source === "string";
  const url = isUrl && new URL(source, import.meta.url);
  return loadFrom(url && url.protocol === "file:" ? await readFile(url) : source);
}
