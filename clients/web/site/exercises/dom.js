// Elements of the page. What a student or a link brings is text in them, and never markup.

export const $ = (id) => document.getElementById(id);

/** An element with attributes and children. */
export function element(name, attributes = {}, ...children) {
  const it = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (key.startsWith("on")) it.addEventListener(key.slice(2), value);
    else if (value !== null && value !== false) it.setAttribute(key, value === true ? "" : value);
  }
  it.append(...children.filter((child) => child !== null && child !== undefined));
  return it;
}

export const number = (x) => {
  if (typeof x !== "number") return String(x);
  if (!Number.isFinite(x)) return Number.isNaN(x) ? "NaN" : x < 0 ? "−∞" : "∞";
  const rounded = Number(x.toPrecision(4));
  return String(Object.is(rounded, -0) ? 0 : rounded).replace(/-/g, "−");
};

export function value(x) {
  if (!Array.isArray(x)) return typeof x === "object" && x ? JSON.stringify(x) : number(x);
  // beside 1, the rounding error of a sine is 0 to the eye
  const least = 1e-12 * Math.max(...x.map(Math.abs).filter(Number.isFinite));
  return `(${x.map((c) => number(Math.abs(c) < least ? 0 : c)).join(", ")})`;
}

export const capital = (text) => (text.startsWith("sRGB") ? text : text.charAt(0).toUpperCase() + text.slice(1));
