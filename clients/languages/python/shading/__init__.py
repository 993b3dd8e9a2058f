"""Lambert, Phong and Blinn-Phong shading of NumPy's arrays.

    lamp = shading.point(position=(2, 0, 2), intensity=(1, 0.8, 0.6), attenuation=(1, 0, 0.25))
    colors = shading.shade(points, normals, eye=(0, -4, 3), lights=lamp, k_a=0.1, k_d=0.6, k_s=0.3, m=32, ambient=0.2)
    image = shading.to_srgb8(colors)  # bytes, for an image file

What you call:

    shade                                   the light that points send to the eye
    directional, point, spot                make lights
    height_field, implicit, mesh_normals    make normals of reliefs, implicit surfaces and meshes
    from_srgb8, to_srgb8, to_srgba8         decode and encode the colors of images

All directions but a spot's axis point away from the surface, colors are linear light, and angles are in radians. Points,
positions and distances share a unit of length, which may be any. The last axis of an array of points, directions or colors has
the length 3. A large call uses all processors; the environment variable RAYON_NUM_THREADS limits them.

The program below shades a relief with a picture on it, in the sun, with the shadows that it casts. The heights `z` and the bytes
`picture` have the shapes (h, w) and (h, w, 3), and their first row is the top of the image. x, y and z are counted in cells, and y
points up in the image.

    import numpy as np
    import shading

    h, w = z.shape
    row, column = np.indices((h, w))
    sun = np.array((-3, 2, 1.2))            # the direction to it, from the upper left
    along = sun / np.hypot(sun[0], sun[1])  # as far as a cell is wide

    def height(right, up):
        # how high it is so far to the right of each cell and above it, interpolated between four cells
        i, j = int(np.floor(-up)), int(np.floor(right))
        v, u = -up - i, right - j
        at = lambda i, j: z[np.clip(row + i, 0, h - 1), np.clip(column + j, 0, w - 1)]
        return (1 - v) * ((1 - u) * at(i, j) + u * at(i, j + 1)) + v * ((1 - u) * at(i + 1, j) + u * at(i + 1, j + 1))

    visible = np.ones((h, w), bool)         # where nothing is in the way to the sun
    for right, up, rise in np.outer(np.arange(1, np.ptp(z) / along[2], 0.5), along):
        visible &= height(right, up) <= z + rise

    texture = shading.from_srgb8(picture)
    colors = shading.shade(
        points=np.stack([column, -row, z], axis=-1),
        normals=shading.height_field(z, dx=1, dy=-1),
        eye=(w / 2, -h / 2, 1000),
        lights=shading.directional(toward=sun, intensity=(1, 0.9, 0.75)),
        visible=visible,
        k_a=texture,
        k_d=texture,
        ambient=(0.12, 0.15, 0.2),
    )
    image = shading.to_srgb8(colors)
"""

from importlib.metadata import version as _version

from ._images import from_srgb8, to_srgb8, to_srgba8
from ._lights import Light as Light, directional, point, spot
from ._normals import height_field, implicit, mesh_normals
from ._shade import Parts as Parts, shade

__version__ = _version("shading")
__all__ = [
    "directional", "from_srgb8", "height_field", "implicit", "mesh_normals", "point", "shade", "spot", "to_srgb8", "to_srgba8",
]
