"""Normals of reliefs and meshes."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from . import _native
from ._arrays import Floats, array, called, is_single, short, vectors


def _step(name: str, value: Any) -> float:
    if not isinstance(value, (int, float, np.number)):
        raise TypeError(f"{name}: expected a number, got {short(value)}")
    return float(value)


def height_field(z: npt.ArrayLike, dx: float = 1.0, dy: float = 1.0) -> Floats:
    """The unit normals (-∂z/∂x, -∂z/∂y, 1) of a grid of heights. The slopes are exact for parabolas.

    z: heights of shape (rows, columns).
    dx: what x grows by from a column to the next.
    dy: what y grows by from a row to the next. It is negative if the first row is the top of an image and y points up.

    Returns an array of shape (rows, columns, 3), of float32 if the heights are.

    >>> height_field([[0, 1], [0, 1]])[0, 0].round(3)
    array([-0.707, -0.   ,  0.707])
    """
    heights = array("z", z)
    if heights.ndim != 2:
        raise ValueError(f"z: expected the shape (rows, columns), got {heights.shape}")
    single = is_single(heights)
    kernel: Any = _native.field_f32 if single else _native.field_f64
    rows = np.ascontiguousarray(heights, np.float32 if single else np.float64)
    flat = called(kernel, rows, _step("dx", dx), _step("dy", dy), grid=heights.shape)
    result: Floats = flat.reshape(*heights.shape, 3)
    return result


def mesh_normals(vertices: npt.ArrayLike, faces: npt.ArrayLike, crease: float | None = None) -> Floats:
    """The unit normals of a mesh of triangles. The triangles around a vertex are weighted by their angles there.

    vertices: positions of shape (vertices, 3).
    faces: whole numbers of shape (faces, 3), which are indices of vertices, counter-clockwise as seen from outside.
    crease: the greatest angle in radians between triangles that are one smooth surface; without it, all are.

    Returns a normal for each vertex, of shape (vertices, 3); with a crease, one for each corner of each triangle, of shape
    (faces, 3, 3). A vertex without triangles has the normal 0.

    >>> mesh_normals([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)])[0]
    array([0., 0., 1.])
    """
    points, indices = vectors("vertices", vertices), vectors("faces", faces)
    for name, value in (("vertices", points), ("faces", indices)):
        if value.ndim != 2:
            raise ValueError(f"{name}: expected the shape (n, 3), got {value.shape}")
    if indices.dtype.kind not in "iu":
        raise TypeError(f"faces: expected whole numbers, got an array of {indices.dtype}")
    if indices.size and (indices.min() < 0 or indices.max() >= len(points)):
        bad = int(np.argwhere(((indices < 0) | (indices >= len(points))).any(-1))[0, 0])
        raise ValueError(
            f"faces: expected indices below {len(points)}, the number of vertices, got {tuple(indices[bad].tolist())} at [{bad}]"
        )
    single = is_single(points)
    kernel: Any = _native.mesh_f32 if single else _native.mesh_f64
    rows = np.ascontiguousarray(points, np.float32 if single else np.float64)
    angle = None if crease is None else _step("crease", crease)
    flat = called(kernel, rows, np.ascontiguousarray(indices, np.uint32), angle, grid=(len(points),))
    result: Floats = flat.reshape((-1, 3) if crease is None else (-1, 3, 3))
    return result
