// A text area with colors and line numbers: the colored text lies under the one that is edited.
import { $, element } from "./dom.js";

const TOKEN = new RegExp([
  "(?<comment>//.*|/\\*[^]*?(?:\\*/|$))",
  "(?<string>\"(?:[^\"\\\\\\n]|\\\\.)*\"?|'(?:[^'\\\\\\n]|\\\\.)*'?)",
  "(?<number>\\b\\d[\\w.]*)",
  "(?<word>\\b(?:const|let|var|function|return|if|else|for|of|in|while|do|break|continue|new|true|false|null|undefined)\\b)",
  "(?<name>\\b[A-Za-z_$][\\w$]*(?=\\())",
].join("|"), "g");

function colored(text) {
  const parts = [];
  let last = 0;
  for (const match of text.matchAll(TOKEN)) {
    const kind = Object.keys(match.groups).find((key) => match.groups[key] !== undefined);
    parts.push(text.slice(last, match.index), element("span", { class: kind }, match[0]));
    last = match.index + match[0].length;
  }
  return [...parts, text.slice(last), "\n"];
}

export class Editor {
  constructor({ changed, submit }) {
    this.area = $("code");
    this.wrong = null;
    this.area.addEventListener("input", () => {
      this.mark(null);
      changed();
    });
    this.area.addEventListener("scroll", () => this.follow());
    this.area.addEventListener("keydown", (event) => this.key(event, submit));
  }

  get text() {
    return this.area.value;
  }

  set text(text) {
    this.area.value = text;
    this.mark(null);
  }

  /** Shows the text in colors, and marks a line that is wrong. */
  mark(wrong) {
    const { value } = this.area;
    const count = value.split("\n").length;
    $("colors").replaceChildren(...colored(value));
    const lines = Array.from({ length: count }, (_, i) =>
      element("span", { class: i + 1 === wrong ? "wrong" : null }, `${i + 1}\n`));
    $("lines").replaceChildren(...lines);
    this.area.rows = Math.min(32, count + 1);
    this.follow();
  }

  follow() {
    const { scrollTop, scrollLeft } = this.area;
    $("lines").scrollTop = scrollTop;
    Object.assign($("colors"), { scrollTop, scrollLeft });
  }

  key(event, submit) {
    const { selectionStart: at, value: text } = this.area;
    if (event.key === "}" && /\n {2,}$/.test(text.slice(0, at))) {
      this.area.setSelectionRange(at - 2, at); // a block ends two spaces before its lines
      return;
    }
    if (event.key !== "Enter") return;
    event.preventDefault();
    if (event.ctrlKey || event.metaKey) return void submit();
    const line = text.slice(text.lastIndexOf("\n", at - 1) + 1, at);
    // the only way of inserting that the browser can undo
    document.execCommand("insertText", false, `\n${/^ */.exec(line)[0]}${line.endsWith("{") ? "  " : ""}`);
  }
}
