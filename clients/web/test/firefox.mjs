// Tries in Firefox what a student's code must not be able to, and that it judges, and shows lines of errors.
import assert from "node:assert/strict";
import puppeteer from "puppeteer-core";
import { home, requests, server } from "./server.mjs";
import { delayed, lambert, later, refusal, refused } from "./ways_out.mjs";

const browser = await puppeteer.launch({
  browser: "firefox", executablePath: process.env.FIREFOX ?? "/usr/bin/firefox-esr", headless: true, timeout: 120_000,
});
const page = await browser.newPage();
await page.goto(`${home}exercises/#lambert`);
await page.waitForSelector("html[data-drawn]");

/** The headline for this code. */
async function headline(code) {
  await page.evaluate((code) => {
    delete document.documentElement.dataset.checked;
    document.getElementById("code").value = code;
    document.getElementById("check").click();
  }, code);
  await page.waitForSelector("html[data-checked]");
  return page.evaluate(() => document.getElementById("headline").textContent);
}

assert.match(await headline(lambert("return Math.max(0, dot(n, l));")), /^All laws hold/);
assert.match(await headline(lambert("return dot(n, l);")), /negative light/);
assert.match(await headline(lambert("while (true);")), /did not finish in time/);
assert.match(await headline(lambert("return Math.max(0, dot(n, light));")), /in line 2: ReferenceError: light/);
assert.match(await headline(lambert("return lambert(n, l);")), /in line 2: A function calls itself without end/);
for (const [code, words] of Object.entries(refused)) assert.match(await headline(refusal(code)), words, code);
for (const code of later) assert.match(await headline(delayed(code)), /Error: end/, code);
await new Promise((passed) => setTimeout(passed, 500));
assert.deepEqual(requests.filter((url) => url.includes("leak")), [], "something got out");
console.log(`${await browser.version()}: ${Object.keys(refused).length + later.length} ways out are closed`);
await browser.close();
server.close();
