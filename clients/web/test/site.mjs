// Serves the built site, and opens its pages in Chromium. Errors and foreign requests fail the test.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { createServer } from "node:http";
import { createRequire } from "node:module";
import { extname, join } from "node:path";
import { chromium } from "playwright-core";

export const folder = new URL("../../target/web/", import.meta.url).pathname;
export const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true };
const axe = createRequire(import.meta.url).resolve("axe-core/axe.min.js");
const TYPES = { ".html": "text/html", ".css": "text/css", ".js": "text/javascript", ".png": "image/png" };

/** What was asked of the server. */
export const requests = [];
const server = createServer(async ({ url }, response) => {
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

export const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox", "--disable-background-networking", "--disable-sync", "--disable-component-update"],
});

/** A page whose errors and foreign requests fail the test. */
export async function open(path, options = {}) {
  const page = await browser.newPage({ viewport: { width: 1200, height: 890 }, ...options });
  const fail = (what) => assert.fail(String(what));
  page.on("console", (message) => message.type() === "error" && fail(message.text()));
  page.on("pageerror", fail);
  page.on("request", (request) => {
    const isOurs = request.url().startsWith(home) || request.url().startsWith(`blob:${home}`);
    return isOurs || fail(request.url());
  });
  await page.goto(home + path);
  return page;
}

/** Fails if axe-core finds something, or if the page is too wide. */
export async function is_accessible(page, what) {
  await page.addScriptTag({ path: axe });
  const { violations } = await page.evaluate(() => window.axe.run());
  assert.deepEqual(violations.map(({ id, nodes }) => [id, nodes.map(({ html }) => html)]), [], what);
  const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
  assert.ok(overflow <= 0, `${what}: ${overflow} pixels too wide`);
}

export async function close() {
  await browser.close();
  server.close();
}
