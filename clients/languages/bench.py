"""A million points under two lamps, beside the same loop in NumPy, numba and jax: bench.py.

Each is measured on one core and on all, in turn. The table gives the least times, and their ratios to those of `shade`.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import time

ONE_CORE = "--one-core"
if ONE_CORE in sys.argv:  # before threads are started
    os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})

import jax
import jax.numpy as jnp
import numba
import numpy as np
import shading

COUNT, ROUNDS = 1_000_000, 15
LAMPS = [((2.0, 1.0, 3.0), (1.0, 0.75, 0.5)), ((-2.0, 1.0, 2.0), (0.25, 0.5, 1.0))]
A, B, C = 1.0, 0.0, 0.25
K_A, K_D, K_S, M, EYE = 0.1, 0.6, 0.4, 32, (0.0, 0.0, 5.0)


def formula(xp, points, normals):
    """As one writes it for arrays, with the whole power by squaring."""
    unit = lambda v: v / xp.sqrt((v * v).sum(-1, keepdims=True))
    dot = lambda a, b: (a * b).sum(-1, keepdims=True)
    n, v = unit(normals), unit(xp.asarray(EYE, xp.float32) - points)
    total = xp.full_like(points, K_A)
    for position, intensity in LAMPS:
        to_light = xp.asarray(position, xp.float32) - points
        q = xp.sqrt(dot(to_light, to_light))
        l = to_light / q
        n_dot_l = dot(n, l)
        power = xp.maximum(dot(n, unit(l + v)), 0)
        for _ in range(5):
            power = power * power
        factor = xp.where(n_dot_l > 0, K_D * n_dot_l + K_S * power, 0) / (A + q * (B + q * C))
        total = total + factor * xp.asarray(intensity, xp.float32)
    return total


POSITIONS = np.array([position for position, _ in LAMPS], np.float32)
INTENSITIES = np.array([intensity for _, intensity in LAMPS], np.float32)


def loop(points, normals, out):
    """As one writes it for numba."""
    one, zero = np.float32(1), np.float32(0)
    for i in numba.prange(len(points)):
        px, py, pz = points[i, 0], points[i, 1], points[i, 2]
        nx, ny, nz = normals[i, 0], normals[i, 1], normals[i, 2]
        s = one / np.sqrt(nx * nx + ny * ny + nz * nz)
        nx, ny, nz = nx * s, ny * s, nz * s
        vx, vy, vz = -px, -py, np.float32(5) - pz
        s = one / np.sqrt(vx * vx + vy * vy + vz * vz)
        vx, vy, vz = vx * s, vy * s, vz * s
        r = g = b = np.float32(K_A)
        for k in range(len(POSITIONS)):
            lx, ly, lz = POSITIONS[k, 0] - px, POSITIONS[k, 1] - py, POSITIONS[k, 2] - pz
            q = np.sqrt(lx * lx + ly * ly + lz * lz)
            lx, ly, lz = lx / q, ly / q, lz / q
            n_dot_l = nx * lx + ny * ly + nz * lz
            if n_dot_l > zero:
                hx, hy, hz = lx + vx, ly + vy, lz + vz
                power = (nx * hx + ny * hy + nz * hz) / np.sqrt(hx * hx + hy * hy + hz * hz)
                power = max(power, zero)
                for _ in range(5):
                    power = power * power
                factor = (np.float32(K_D) * n_dot_l + np.float32(K_S) * power) / (np.float32(A) + np.float32(C) * q * q)
                r += factor * INTENSITIES[k, 0]
                g += factor * INTENSITIES[k, 1]
                b += factor * INTENSITIES[k, 2]
        out[i, 0], out[i, 1], out[i, 2] = r, g, b


def measured() -> dict[str, float]:
    rng = np.random.default_rng(1)
    points = rng.uniform(-1, 1, (COUNT, 3)).astype(np.float32)
    normals = (rng.uniform(-1, 1, (COUNT, 3)) + (0, 0, 1.5)).astype(np.float32)
    lights = [shading.point(position, intensity, attenuation=(A, B, C)) for position, intensity in LAMPS]
    compiled = numba.njit(loop, parallel=ONE_CORE not in sys.argv)
    by_jax = jax.jit(lambda points, normals: formula(jnp, points, normals))
    on_device = jax.device_put(points), jax.device_put(normals)

    def by_numba() -> np.ndarray:
        out = np.empty_like(points)
        compiled(points, normals, out)
        return out

    runs = {
        "shading.shade": lambda: shading.shade(points, normals, EYE, lights, k_a=K_A, k_d=K_D, k_s=K_S, m=M),
        "NumPy": lambda: formula(np, points, normals),
        "numba": by_numba,
        "jax": lambda: by_jax(*on_device).block_until_ready(),
    }
    expected = runs["shading.shade"]()
    for name, run in runs.items():
        worst = np.abs(np.asarray(run()) - expected).max()
        assert worst < 1e-4, f"{name} differs by {worst}"  # m roundings of the cosine, 32 · 2⁻²³, times the light
    least = dict.fromkeys(runs, np.inf)
    for _ in range(ROUNDS):
        for name, run in runs.items():
            start = time.perf_counter()
            run()
            least[name] = min(least[name], time.perf_counter() - start)
    return least


if len(sys.argv) > 1:
    print(json.dumps(measured()))
else:
    print(f"{COUNT:,} points under {len(LAMPS)} lamps, float32, Blinn-Phong with m = {M}; the least of {ROUNDS} rounds")
    cores = {"one core": ONE_CORE, f"{os.cpu_count()} cores": "--all-cores"}
    for label, option in cores.items():
        least = json.loads(subprocess.run([sys.executable, __file__, option], check=True, capture_output=True, text=True).stdout)
        own = least["shading.shade"]
        for name, seconds in least.items():
            print(f"{label:10} {name:14} {1000 * seconds:7.1f} ms  {seconds / own:5.2f}")
