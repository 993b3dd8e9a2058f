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
];

/** Code that keeps the worker alive for a while, so that it might be sent. */
export const delayed = (code) => {
  const body = "const end = Date.now() + 400;\n  while (Date.now() < end);\n  throw new Error(\"end\");";
  return `try { ${code}; } catch {}\n${lambert(body)}`;
};
