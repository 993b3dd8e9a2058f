import assert from "node:assert/strict";
import { test } from "node:test";

import { directional, load, point, spot } from "shading";

const { shade, toSrgb8, memory } = await load();
const up = { points: [0, 0, 0], normals: [0, 0, 2], eye: [0, 0, 5] };

test("a white surface below a sun of 0.5 is 0.5 bright", () => {
  const lights = [directional({ toward: [0, 0, 3], intensity: 0.5 })];
  assert.deepEqual([...shade({ ...up, lights, k_d: [1, 0.5, 0] })], [0.5, 0.25, 0]);
});

test("a lamp falls off by 1/(a + bq + cq²), and ends at its range", () => {
  const lamp = (more) => [point({ position: [0, 0, 2], attenuation: [1, 0.5, 0.5], ...more })];
  const light = (more) => shade({ ...up, lights: lamp(more), k_d: 1, model: "lambert" })[0];
  assert.equal(light({}), 0.25); // 1/(1 + 1 + 2)
  assert.equal(light({ range: 4 }), 0.25 * 0.9375 ** 2); // (1 − (2/4)⁴)²
  assert.equal(light({ range: 4, gltf: true }), 0.25 * 0.9375);
  assert.equal(light({ range: 2 }), 0);
});

test("a spot lights its cone", () => {
  const beam = (outer) => [spot({ position: [2, 0, 2], axis: [0, 0, -1], inner: outer, outer })];
  const light = (outer) => shade({ ...up, lights: beam(outer), k_d: 1 })[0];
  assert.equal(light(Math.PI / 4 - 0.01), 0); // the point is at 45° to the axis
  assert.ok(Math.abs(light(Math.PI / 4 + 0.01) - Math.SQRT1_2) < 1e-6);
});

test("bytes are sRGB", () => {
  // half of the light is 188: 255 (1.055 · 0.5^(1/2.4) − 0.055) = 187.5
  assert.deepEqual([...toSrgb8([0, 0.5, 1, 2, -1, NaN])], [0, 188, 255, 255, 0, 0]);
});

test("each call frees what it takes", () => {
  const many = new Float32Array(300_000).fill(1);
  const call = () => toSrgb8(shade({ points: many, normals: many, eye: [0, 0, 5], lights: [], k_d: 1 }));
  call();
  const before = memory.buffer.byteLength;
  for (let i = 0; i < 200; i++) call();
  assert.equal(memory.buffer.byteLength, before);
  for (let i = 0; i < 200; i++) {
    assert.throws(() => shade({ points: many, normals: many, eye: [0, 0, 5], lights: [], k_d: 1, ambient: -1 }));
  }
  assert.equal(memory.buffer.byteLength, before);
});
