// N, V, L and R or H, drawn on the surface at the pixel.

const SVG = "http://www.w3.org/2000/svg";
const LENGTH = 0.6; // of an arrow, where the sphere has the radius 1

/** The names and directions at a pixel; `model` is that of the settings. */
export function directions({ N, V, lamps }, model) {
  const of_lamps = lamps.flatMap(({ name, L, R, H }) => {
    const index = { 1: "₁", 2: "₂", sun: "ₛ" }[name] ?? "";
    const other = model === 1 ? [[`R${index}`, R]] : model === 2 ? [[`H${index}`, H]] : [];
    return [[`L${index}`, L], ...other];
  });
  return [["N", N], ["V", V], ...of_lamps].filter(([, d]) => Math.hypot(...d) > 0.5);
}

function part(name, attributes, text = "") {
  const it = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) it.setAttribute(key, value);
  it.textContent = text;
  return it;
}

/** Draws them into an SVG of 100 by 100 over the picture; `projected` gives fractions of it. */
export function draw(svg, at, model, projected) {
  const place = (p) => projected(p).slice(0, 2).map((x) => 100 * x);
  const [x0, y0] = place(at.P);
  const groups = directions(at, model).map(([name, d]) => {
    const [x, y] = place(at.P.map((p, i) => p + LENGTH * d[i]));
    const length = Math.hypot(x - x0, y - y0) || 1e-9;
    const group = part("g", { class: `arrow ${name[0]}` });
    group.append(
      part("line", { x1: x0, y1: y0, x2: x, y2: y }),
      part("circle", { cx: x, cy: y, r: 0.9 }),
      part("text", { x: x + (3 * (x - x0)) / length, y: y + (3 * (y - y0)) / length + 1.2 }, name),
    );
    return group;
  });
  svg.replaceChildren(...groups);
}
