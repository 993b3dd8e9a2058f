"""An image as a wall, lit by two spots: picture.py [PICTURE [IMAGE]]."""

import sys

import numpy as np
import shading
from PIL import Image

if len(sys.argv) > 2:
    image = np.asarray(Image.open(sys.argv[2]).convert("RGB"))
else:  # tiles
    row, column = np.indices((300, 450))
    is_joint = (row % 50 < 3) | ((column + 25 * (row // 50 % 2)) % 50 < 3)
    image = np.where(is_joint[..., None], (120, 116, 110), (186, 92, 70)).astype(np.uint8)

# The wall is the plane z = 0, two units high. Bytes of an image are sRGB, and light is linear: so `from_srgb8`.
h, w = image.shape[:2]
row, column = np.indices((h, w), dtype=np.float32)
x, y = 2 * (column - w / 2) / h, 2 * (h / 2 - row) / h
wall = np.stack([x, y, np.zeros_like(x)], axis=-1)
k_d = shading.from_srgb8(image)


def spot(side):
    """A lamp above the wall, which shines down along it."""
    return shading.spot(
        position=(side, 1.4, 0.9),
        axis=(-0.2 * side, -1.2, -0.9),
        intensity=(3.0, 2.6, 2.0),
        inner=np.radians(15),
        outer=np.radians(35),
        attenuation=(0, 0, 1),
    )


colors = shading.shade(
    wall, (0, 0, 1), eye=(0, 0, 3), lights=[spot(-0.8), spot(0.8)], k_a=k_d, k_d=k_d, k_s=0.15, m=20, ambient=0.06
)
Image.fromarray(shading.to_srgb8(colors)).save(sys.argv[1] if len(sys.argv) > 1 else "picture.png")
