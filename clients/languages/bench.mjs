// A million points under two lamps, beside the same loop in JavaScript: the least of 15 rounds, in turn.
import { load, point } from "shading";

const COUNT = 1_000_000;
const LAMPS = [[[2, 1, 3], [1, 0.75, 0.5]], [[-2, 1, 2], [0.25, 0.5, 1]]];
const random = Float32Array.from({ length: 6 * COUNT }, () => 2 * Math.random() - 1);
const points = random.subarray(0, 3 * COUNT);
const normals = random.subarray(3 * COUNT).map((x, i) => i % 3 === 2 ? x + 1.5 : x);
const lights = LAMPS.map(([position, intensity]) => point({ position, intensity, attenuation: [1, 0, 0.25] }));

function byHand() {
  const out = new Float32Array(3 * COUNT);
  for (let i = 0; i < 3 * COUNT; i += 3) {
    const [x, y, z] = [points[i], points[i + 1], points[i + 2]];
    const s = 1 / Math.hypot(normals[i], normals[i + 1], normals[i + 2]);
    const [nx, ny, nz] = [normals[i] * s, normals[i + 1] * s, normals[i + 2] * s];
    const t = 1 / Math.sqrt(x * x + y * y + (5 - z) * (5 - z));
    const [vx, vy, vz] = [-x * t, -y * t, (5 - z) * t];
    let [r, g, b] = [0.1, 0.1, 0.1];
    for (const [[px, py, pz], intensity] of LAMPS) {
      const [tx, ty, tz] = [px - x, py - y, pz - z];
      const q = Math.sqrt(tx * tx + ty * ty + tz * tz);
      const [lx, ly, lz] = [tx / q, ty / q, tz / q];
      const nDotL = nx * lx + ny * ly + nz * lz;
      if (nDotL <= 0) continue;
      const [hx, hy, hz] = [lx + vx, ly + vy, lz + vz];
      const cosine = Math.max(0, (nx * hx + ny * hy + nz * hz) / Math.sqrt(hx * hx + hy * hy + hz * hz));
      const factor = (0.6 * nDotL + 0.4 * cosine ** 32) / (1 + 0.25 * q * q);
      r += factor * intensity[0];
      g += factor * intensity[1];
      b += factor * intensity[2];
    }
    out.set([r, g, b], i);
  }
  return out;
}

const { shade } = await load();
const runs = {
  shade: () => shade({ points, normals, eye: [0, 0, 5], lights, k_a: 0.1, k_d: 0.6, k_s: 0.4, m: 32 }),
  "by hand": byHand,
};
const [own, other] = [runs.shade(), runs["by hand"]()];
if (!own.every((x, i) => Math.abs(x - other[i]) < 1e-4)) throw new Error("they differ");
const least = {};
for (let round = 0; round < 15; round++) {
  for (const [name, run] of Object.entries(runs)) {
    const start = performance.now();
    run();
    least[name] = Math.min(least[name] ?? Infinity, performance.now() - start);
  }
}
for (const [name, time] of Object.entries(least)) {
  console.log(`Node.js    ${name.padEnd(14)} ${time.toFixed(1).padStart(7)} ms  ${(time / least.shade).toFixed(2).padStart(5)}`);
}
