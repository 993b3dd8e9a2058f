"""A height map with a texture, the sun and its shadows: relief.py [PICTURE]."""

import sys

import numpy as np
import shading
from PIL import Image

# Heights above a grid, in cells: x grows from column to column, and y from row to row of the image upward.
h, w = 300, 400
row, column = np.indices((h, w))
x, y = column, -row
z = 22 * np.exp(-((x - 150) ** 2 + (y + 149) ** 2) / 3000) + 14 * np.exp(-((x - 260) ** 2 + (y + 179) ** 2) / 1500)
z += 1.2 * np.sin(x / 6) * np.sin(y / 9)

# Bytes of an image are sRGB, and light is linear.
picture = np.where((z > 14)[..., None], (226, 222, 214), (118, 146, 84)).astype(np.uint8)
texture = shading.from_srgb8(picture)


def height(right, up):
    """How high it is so far to the right of each cell and above it. It is interpolated: the nearest cell would give stripes."""
    i, j = int(np.floor(-up)), int(np.floor(right))
    v, u = -up - i, right - j

    def at(i, j):
        return z[np.clip(row + i, 0, h - 1), np.clip(column + j, 0, w - 1)]

    return (1 - v) * ((1 - u) * at(i, j) + u * at(i, j + 1)) + v * ((1 - u) * at(i + 1, j) + u * at(i + 1, j + 1))


# Where nothing is in the way to the sun. The way leaves its cell first, and ends above the highest one.
sun = np.array((-3, 2, 1.2))
along = sun / np.hypot(sun[0], sun[1])
visible = np.ones((h, w), bool)
for right, up, rise in np.outer(np.arange(1, np.ptp(z) / along[2], 0.5), along):
    visible &= height(right, up) <= z + rise

colors = shading.shade(
    points=np.stack([x, y, z], axis=-1),
    normals=shading.height_field(z, dx=1, dy=-1),
    eye=(w / 2, -h / 2, 1000),
    lights=shading.directional(toward=sun, intensity=(1, 0.9, 0.75)),
    visible=visible,
    k_a=texture,
    k_d=texture,
    ambient=(0.12, 0.15, 0.2),
)
Image.fromarray(shading.to_srgb8(colors)).save(sys.argv[1] if len(sys.argv) > 1 else "relief.png")
