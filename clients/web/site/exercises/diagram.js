// The directions of a scene as a drawing: N up, and each of the others at its angle to N.
import { add, dot, scale, sub, unit } from "./formulas.js";

const SVG = "http://www.w3.org/2000/svg";
function svg(name, attributes, ...children) {
  const it = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) it.setAttribute(key, value);
  it.append(...children);
  return it;
}

export const toward = (light, p) => light.l ?? unit(sub(light.position, p));

/** The directions to draw: a name, a unit vector and a class. */
function directions({ n, v, p, lights, model }, hasEye) {
  const up = unit(n);
  const list = hasEye ? [["V", unit(v), "eye"]] : [];
  lights.slice(0, 3).forEach((light, i) => {
    const index = lights.length > 1 ? "₁₂₃"[i] : "";
    const l = toward(light, p);
    list.push([`L${index}`, l, dot(up, l) <= 0 ? "behind" : "light"]);
    if (light.kind === "spot" && model === "lambert") list.push([`−axis${index}`, scale(unit(light.axis), -1), "between"]);
    if (model === "phong") list.push([`R${index}`, sub(scale(up, 2 * dot(up, l)), l), "between"]);
    if (model === "blinn_phong") list.push([`H${index}`, unit(add(l, unit(v))), "between"]);
  });
  return list.filter(([, d]) => Math.hypot(...d) > 0.5);
}

/**
 * A drawing of N, of V if the eye matters, and of L and R or H of each light; `own` is a vector of the student's, drawn
 * beside them.
 */
export function diagram(scene, own, hasEye) {
  const up = unit(scene.n);
  const all = directions(scene, hasEye);
  if (own?.every(Number.isFinite) && Math.hypot(...own) > 1e-6) all.push(["yours", own, "own"]);
  const across = (d) => sub(d, scale(up, dot(up, d)));
  // what has the eye's side is to the right; without an eye to the side, the first light is to the left
  const eye = hasEye ? across(unit(scene.v)) : [0, 0, 0];
  const first = all.map(([, d]) => across(d)).find((d) => Math.hypot(...d) > 0.05) ?? [1, 0, 0];
  const side = Math.hypot(...eye) > 0.05 ? eye : scale(first, -1);
  const arrows = [["N", 0, "normal", 1], ...all.map(([name, d, kind]) => {
    const angle = Math.acos(Math.max(-1, Math.min(1, dot(up, unit(d)))));
    return [name, dot(across(d), side) < 0 ? -angle : angle, kind, Math.min(1.25, Math.hypot(...d))];
  })];
  const labels = [];
  for (const [name, angle, kind, length] of arrows) { // one label where two directions are nearly the same
    const same = labels.find((label) => Math.abs(label.angle - angle) < 0.2);
    if (same) Object.assign(same, { name: `${same.name}, ${name}`, length: Math.max(length, same.length) });
    else labels.push({ name, angle, kind, length: Math.max(1, length) });
  }
  const [left, right] = [-95, 95];
  const lines = arrows.map(([, angle, kind, length]) => {
    const [x, y] = [60 * length * Math.sin(angle), -60 * length * Math.cos(angle)];
    const tip = [2.6, -2.6].map((turn) => {
      const at = angle + turn;
      return `M${x.toFixed(1)} ${y.toFixed(1)}l${(7 * Math.sin(at)).toFixed(1)} ${(-7 * Math.cos(at)).toFixed(1)}`;
    }).join("");
    return svg("path", { class: kind, d: `M0 0L${x.toFixed(1)} ${y.toFixed(1)}${tip}` });
  });
  let bottom = 15;
  const words = labels.map(({ name, angle, kind, length }) => {
    const [x, y] = [(60 * length + 22) * Math.sin(angle), -(60 * length + 20) * Math.cos(angle)];
    const above = Math.abs(y) < 12 ? -8 : 4; // not on the line of the surface
    bottom = Math.max(bottom, y + 15);
    return svg("text", { class: kind, x: x.toFixed(1), y: (y + above).toFixed(1), "text-anchor": "middle" }, name);
  });
  const degrees = arrows.slice(1).map(([name, angle]) => `${name} at ${Math.round(Math.abs(angle) * 180 / Math.PI)}°`);
  const label = `The directions about N: ${degrees.join(", ")}`;
  return svg("svg", { viewBox: `-110 -107 220 ${107 + bottom}`, role: "img", "aria-label": label },
    svg("path", { class: "surface", d: `M${left} 0H${right}` }), ...lines, ...words);
}
