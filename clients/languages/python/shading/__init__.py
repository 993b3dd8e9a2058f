"""Lambert, Phong and Blinn-Phong shading of NumPy's arrays.

    import numpy as np
    import shading

    normals = shading.height_field(z, dx=1, dy=-1)            # of a relief
    sun = shading.directional(toward=(-1, 1, 1), intensity=0.9)
    colors = shading.shade(points, normals, eye=(0, 0, 100), lights=[sun], k_a=0.1, k_d=texture)
    image = shading.to_srgb8(colors)                          # bytes, for an image file

What you call:

    shade         the light that points send to the eye
    directional, point, spot                    make lights
    height_field, implicit, mesh_normals        make normals of reliefs, implicit surfaces and meshes
    from_srgb8, to_srgb8, to_srgba8             decode and encode the colors of images

All directions point away from the surface, colors are linear light, and angles are in radians. Points, positions and distances
share a unit of length, which may be any. The last axis of an array of points, directions or colors has the length 3. A large
call uses all processors; the environment variable RAYON_NUM_THREADS limits them.
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
