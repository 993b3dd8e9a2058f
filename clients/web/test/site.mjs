// Opens pages of the built site in Chromium. Errors and foreign requests fail the test.
import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { chromium } from "playwright-core";
import { home, server } from "./server.mjs";

export { folder, home, requests } from "./server.mjs";
export const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true };
const axe = createRequire(import.meta.url).resolve("axe-core/axe.min.js");

export const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox", "--disable-background-networking", "--disable-sync", "--disable-component-update"],
});

/** A page whose errors and foreign requests fail the test. */
export async function open(path, options = {}) {
  const page = await browser.newPage({ viewport: { width: 1280, height: 890 }, ...options });
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
