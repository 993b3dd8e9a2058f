"""Shades a dome from Python, and writes the colors as floats: python main.py FILE."""

import sys

import numpy as np
import shading

lights = [
    shading.directional(toward=(-1, 2, 2), intensity=(0.25, 0.25, 0.375)),
    shading.point(position=(2, 1, 2), intensity=(1, 0.75, 0.5), attenuation=(1, 0, 0.25)),
    shading.spot(
        position=(0, 3, 3), axis=(0, -1, -1), intensity=(3, 1, 1), inner=0.25, outer=0.375, attenuation=(1, 0.5, 0), range=8
    ),
]
j, i = np.indices((64, 64), dtype=np.float32)
x, y = (i - 32) / 32, (32 - j) / 32
points = np.stack([x, y, 1 - x * x - y * y], axis=-1)
normals = np.stack([2 * x, 2 * y, np.ones_like(x)], axis=-1)
colors = shading.shade(
    points, normals, (0, 0, 5), lights, k_a=0.125, k_d=(0.5, 0.375, 0.25), k_s=0.5, m=32, ambient=0.5
)
colors.tofile(sys.argv[1])
