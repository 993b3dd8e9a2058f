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

export const value = (x) => (Array.isArray(x) ? `(${x.map(number).join(", ")})`
  : typeof x === "object" && x ? JSON.stringify(x) : number(x));

export const capital = (text) => text.charAt(0).toUpperCase() + text.slice(1);
