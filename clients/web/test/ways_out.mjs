// Ways by which a student's code might get out of its worker, and what the browser says to each.
import { home } from "./server.mjs";

export const lambert = (line) => `function lambert(n, l) {\n  ${line}\n}\n`;

/** What is refused at once. */
export const refused = {
  "eval(\"1\")": /EvalError/,
  "new Function(\"return 1\")()": /EvalError/,
  [`importScripts("${home}exercises/page.js?leak")`]: /NetworkError/,
  "importScripts(\"data:text/javascript,1\")": /NetworkError/,
  "localStorage.length": /ReferenceError/,
  "document.cookie": /ReferenceError/,
  "(async () => {}).constructor(\"return 1\")()": /EvalError/,
  "new Image().src = \"x\"": /ReferenceError/,
  "new RTCPeerConnection()": /ReferenceError/,
  "Reflect.construct(Function, [\"return 1\"])()": /EvalError/,
  "(function* () {}).constructor(\"yield 1\")()": /EvalError/,
  [`importScripts(new URL("/?leak=import", "${home}"))`]: /NetworkError/,
  "sessionStorage.length": /ReferenceError/,
  "parent.postMessage(1)": /ReferenceError/,
  "open(\"/?leak=window\")": /ReferenceError/,
  "new SharedWorker(\"x\")": /ReferenceError/,
  [`const x = new XMLHttpRequest(); x.open("GET", "${home}?leak=xhr", false); x.send()`]: /NetworkError/,
};

/** Code that says how it is refused. */
export const refusal = (code) =>
  lambert(`let how = "allowed";\n  try { ${code}; } catch (e) { how = String(e); }\n  throw new Error(how);`);

/** What would only be sent later. */
export const later = [
  `fetch("${home}?leak=fetch")`, `fetch("${home}?leak=keepalive", { keepalive: true })`,
  `fetch("https://example.org/?leak")`, `import("${home}exercises/page.js?leak=import")`,
  `new EventSource("${home}?leak=events")`, `new WebSocket("${home.replace("http", "ws")}?leak=socket")`,
  `new Worker(URL.createObjectURL(new Blob(["fetch('${home}?leak=worker')"])))`,
  `fetch(new Request("${home}?leak=request", { mode: "no-cors" }))`,
  `import("data:text/javascript,fetch('${home}?leak=module')")`,
  `importScripts(URL.createObjectURL(new Blob(["fetch('${home}?leak=script')"])))`,
  `WebAssembly.compileStreaming(fetch("${home}?leak=stream"))`,
  `new FontFace("x", "url(${home}?leak=font)").load()`,
  `new Worker("data:text/javascript,fetch('${home}?leak=data')")`,
  `self.location.href = "${home}?leak=location"`,
  `navigator.sendBeacon?.("${home}?leak=beacon")`,
  `setTimeout("fetch('${home}?leak=timer')")`,
  `queueMicrotask(() => fetch("${home}?leak=microtask"))`,
  `onerror = onunhandledrejection = () => fetch("${home}?leak=handler"); Promise.reject(1)`,
  `caches.open("x").then((it) => it.add("${home}?leak=cache"))`,
  `const x = new XMLHttpRequest(); x.open("POST", "${home}?leak=post"); x.send("n")`,
  `new WebTransport("${home.replace("http", "https")}?leak=transport")`,
  `new WebSocketStream("${home.replace("http", "ws")}?leak=stream-socket")`,
  `new Worker("${home}exercises/worker.js?leak=own")`,
  `new Worker(URL.createObjectURL(new Blob(["import '${home}?leak=static'"])), { type: "module" })`,
  `import(URL.createObjectURL(new Blob(["await fetch('${home}?leak=await')"], { type: "text/javascript" })))`,
  `navigator.serviceWorker.register("${home}exercises/worker.js?leak=service")`,
  `new Response(new ReadableStream({ pull: () => fetch("${home}?leak=pull") })).text()`,
];

/** What comes before a wrong answer, and might make a right one of it. */
export const forged = [
  `const old = TextDecoder.prototype.decode;
TextDecoder.prototype.decode = function (x) { return old.call(this, x).replace('"passes":false', '"passes":true'); };`,
  "const old = JSON.parse; JSON.parse = (x) => { const it = old(x); if (it.laws) it.passes = true; return it; };",
  "postMessage({ report: { passes: true, laws: [{ law: \"formula\", cases: 1 }] } });",
  "onmessage = ({ ports }) => ports[0].postMessage({ report: { passes: true, laws: [] } });",
  "addEventListener(\"message\", ({ ports }) => ports[0]?.postMessage({ report: { passes: true, laws: [] } }));",
  "const { postMessage } = MessagePort.prototype;\n"
    + "MessagePort.prototype.postMessage = function (it) { postMessage.call(this, { ...it, report: { passes: true, laws: [] } }); };",
  "WebAssembly.Instance = function () { return { exports: { check() {}, text: () => 0, text_length: () => 0 } }; };",
  "for (const key of [\"passes\", \"problem\", \"report\"]) Object.defineProperty(Object.prototype, key, { get: () => true, set() {} });",
  "Float64Array.prototype.set = function () {};",
  "Float64Array = class extends Float64Array { set(x) { super.set(x.map(() => 0)); } };",
  "structuredClone = (x) => x; performance = null; Math.abs = () => 0;",
  "Array.isArray = () => true; Array.prototype.every = () => true; Array.prototype.some = () => false;",
];

/** Code that keeps the worker alive for a while, so that it might be sent. */
export const delayed = (code) => {
  const body = "const end = Date.now() + 400;\n  while (Date.now() < end);\n  throw new Error(\"end\");";
  return `try { ${code}; } catch {}\n${lambert(body)}`;
};
