"""A height map with a texture, the sun and its shadows: relief.py [PICTURE]."""

import sys

import numpy as np
import shading
from PIL import Image

# Heights above a grid, in its unit: x grows from column to column, and y from row to row of the image upward.
h, w = 300, 400
rows, columns = np.indices((h, w), dtype=np.float32)
x, y = columns, h - 1 - rows
z = 22 * np.exp(-((x - 150) ** 2 + (y - 150) ** 2) / 3000) + 14 * np.exp(-((x - 260) ** 2 + (y - 120) ** 2) / 1500)
z += 1.2 * np.sin(x / 6) * np.sin(y / 9)

# Bytes of an image are sRGB, and light is linear.
texture = np.where((z > 14)[..., None], (226, 222, 214), (118, 146, 84)).astype(np.uint8)
k_d = shading.from_srgb8(texture)


def height(row, column):
    """The height between the cells, by bilinear interpolation: the nearest cell would give stripes."""
    r, c = np.clip(row, 0, h - 1), np.clip(column, 0, w - 1)
    i, j = np.minimum(r.astype(int), h - 2), np.minimum(c.astype(int), w - 2)
    v, u = r - i, c - j
    return (1 - v) * ((1 - u) * z[i, j] + u * z[i, j + 1]) + v * ((1 - u) * z[i + 1, j] + u * z[i + 1, j + 1])


def lit(toward):
    """Whether the way toward the sun is free. The ray leaves its cell first, and ends above the highest one."""
    along = np.asarray(toward) / np.hypot(*toward[:2])
    free = np.ones((h, w), bool)
    for step in np.arange(1, (z.max() - z.min()) / along[2], 0.5):
        free &= height(rows - step * along[1], columns + step * along[0]) <= z + step * along[2]
    return free


sun = (-3, 2, 1.2)
colors = shading.shade(
    points=np.stack([x, y, z], axis=-1),
    normals=shading.height_field(z, dx=1, dy=-1),
    eye=(w / 2, h / 2, 1000),
    lights=shading.directional(toward=sun, intensity=(1.0, 0.9, 0.75)),
    visible=lit(sun)[None],
    k_a=k_d,
    k_d=k_d,
    ambient=(0.12, 0.15, 0.2),
)
Image.fromarray(shading.to_srgb8(colors)).save(sys.argv[1] if len(sys.argv) > 1 else "relief.png")
