// Plots of the falloff over the distance and of the highlight over the angle, with the lamps of the pixel in them.

const [WIDTH, HEIGHT] = [220, 90];

function curve(canvas, most, of, marks, label) {
  const sharp = Math.min(devicePixelRatio, 3);
  [canvas.width, canvas.height] = [WIDTH * sharp, HEIGHT * sharp];
  const context = canvas.getContext("2d");
  const { color } = getComputedStyle(canvas);
  const [left, bottom, top] = [24, HEIGHT - 16, 6];
  context.scale(sharp, sharp);
  const values = Array.from({ length: 101 }, (_, i) => of((i / 100) * most));
  const finite = values.filter(Number.isFinite);
  const highest = finite.length === 0 ? 1 : Math.max(1e-9, ...finite.map((x) => Math.min(x, 4)));
  const at = (x, y) => [left + (x / most) * (WIDTH - left - 6), bottom - (Math.min(y, highest) / highest) * (bottom - top)];
  Object.assign(context, { strokeStyle: color, fillStyle: color, font: "10px system-ui, sans-serif", lineWidth: 1 });
  context.globalAlpha = 0.5;
  context.beginPath();
  context.moveTo(left, top);
  context.lineTo(left, bottom);
  context.lineTo(WIDTH - 4, bottom);
  context.stroke();
  context.globalAlpha = 1;
  context.fillText(String(Number(highest.toPrecision(2))), 0, top + 8);
  context.fillText("0", 12, bottom);
  context.fillText(label, left, HEIGHT - 3);
  context.fillText(String(most), WIDTH - 22, HEIGHT - 3);
  context.lineWidth = 2;
  context.beginPath();
  values.forEach((y, i) => {
    if (Number.isFinite(y)) context.lineTo(...at((i / 100) * most, y));
  });
  context.stroke();
  for (const [x, y] of marks) {
    if (!Number.isFinite(y) || x > most) continue;
    context.beginPath();
    context.arc(...at(x, y), 4, 0, 2 * Math.PI);
    context.fill();
  }
}

/** The falloff over q. */
export function plotFalloff(canvas, [a, b, c], lamps) {
  const marks = lamps.map(({ q, attenuation }) => [q, attenuation]);
  curve(canvas, 10, (q) => 1 / (a + b * q + c * q * q), marks, "distance q");
}

/** The highlight over the angle between R and V, or between N and H. */
export function plotLobe(canvas, m, cosines) {
  const lobe = (degrees) => Math.max(0, Math.cos((degrees * Math.PI) / 180)) ** m;
  const marks = cosines.map((cosine) => {
    const degrees = (Math.acos(Math.max(-1, Math.min(1, cosine))) * 180) / Math.PI;
    return [degrees, lobe(degrees)];
  });
  curve(canvas, 90, lobe, marks, "angle in degrees");
}
