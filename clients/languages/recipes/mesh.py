"""A smooth mesh with sharp edges: mesh.py [PICTURE]."""

import sys

import numpy as np
import shading
from PIL import Image

# A turned piece of wood: a profile of radii and heights, around the axis z.
profile = np.array([(0, 0), (0.8, 0), (0.8, 0.15), (0.35, 0.35), (0.28, 0.8), (0.45, 0.95), (0.45, 1.05), (0.2, 1.1), (0, 1.1)])
n = 32
angle = np.arange(n) * 2 * np.pi / n
ring = np.stack([np.cos(angle), np.sin(angle)], axis=-1)
vertices = np.concatenate([np.column_stack([radius * ring, np.full(n, height)]) for radius, height in profile])
i, j = np.meshgrid(np.arange(len(profile) - 1), np.arange(n), indexing="ij")
a, b, c, d = i * n + j, i * n + (j + 1) % n, (i + 1) * n + (j + 1) % n, (i + 1) * n + j
faces = np.concatenate([np.stack([a, b, c], -1).reshape(-1, 3), np.stack([a, c, d], -1).reshape(-1, 3)])

# One normal for each corner of each triangle: smooth around the axis, where triangles differ by 360°/32, and sharp at the rims.
normals = shading.mesh_normals(vertices, faces, crease=np.radians(30))

# What each pixel sees of the mesh: a triangle, and the weights of its corners. The eye is far away.
eye = np.array([0, -6, 4.0])
forward = np.array([0, 0, 0.55]) - eye
forward /= np.linalg.norm(forward)
right = np.array([1.0, 0, 0])
up = np.cross(right, forward)
size = 360
screen = np.stack([size / 2 + 190 * (vertices @ right), size / 2 - 190 * ((vertices - (0, 0, 0.55)) @ up)], axis=-1)
depth = vertices @ forward
nearest = np.full((size, size), np.inf)
points, bent = np.zeros((size, size, 3)), np.zeros((size, size, 3))
for face, corners in zip(faces, normals):
    (x0, y0), (x1, y1), (x2, y2) = screen[face]
    area = (x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0)
    if abs(area) < 1e-9:
        continue
    low, high = np.floor(screen[face].min(0)).astype(int), np.ceil(screen[face].max(0)).astype(int) + 1
    y, x = np.mgrid[low[1] : high[1], low[0] : high[0]]
    u = ((x - x0) * (y2 - y0) - (x2 - x0) * (y - y0)) / area
    v = ((x1 - x0) * (y - y0) - (x - x0) * (y1 - y0)) / area
    weights = np.stack([1 - u - v, u, v], axis=-1)
    here = weights @ depth[face]
    seen = (weights >= 0).all(-1) & (here < nearest[y, x])
    nearest[y[seen], x[seen]] = here[seen]
    points[y[seen], x[seen]] = weights[seen] @ vertices[face]
    bent[y[seen], x[seen]] = weights[seen] @ corners

lamps = [
    shading.point((-3, -4, 5), (30, 26, 20), attenuation=(0, 0, 1)),
    shading.directional((4, 1, 2), (0.1, 0.16, 0.3)),
]
wood = shading.from_srgb8(np.array([176, 112, 62], np.uint8))
colors = shading.shade(points, bent, eye, lamps, k_a=wood, k_d=wood, k_s=0.25, m=48, ambient=0.12)
colors[np.isinf(nearest)] = 0.03
Image.fromarray(shading.to_srgb8(colors)).save(sys.argv[1] if len(sys.argv) > 1 else "mesh.png")
