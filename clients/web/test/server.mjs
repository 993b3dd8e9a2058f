// Serves the built site.
import { readFile } from "node:fs/promises";
import { createServer } from "node:http";
import { extname, join } from "node:path";

export const folder = new URL("../../target/web/", import.meta.url).pathname;
const TYPES = { ".html": "text/html", ".css": "text/css", ".js": "text/javascript", ".png": "image/png" };

/** What was asked of the server. */
export const requests = [];
export const server = createServer(async ({ url }, response) => {
  requests.push(url);
  const { pathname } = new URL(url, "http://localhost");
  try {
    const name = pathname.endsWith("/") ? `${pathname}index.html` : pathname;
    const body = await readFile(join(folder, name));
    response.writeHead(200, { "content-type": TYPES[extname(name)] ?? "application/octet-stream" });
    response.end(body);
  } catch {
    response.writeHead(404).end();
  }
}).listen(0, "localhost");
await new Promise((listening) => server.once("listening", listening));
export const home = `http://localhost:${server.address().port}/`;
