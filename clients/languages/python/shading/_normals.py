"""Normals of reliefs, implicit surfaces and meshes."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from . import _native
from ._arrays import Floats, array, called, is_single, number, vectors


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
    flat = called(kernel, rows, number("dx", dx), number("dy", dy), grid=heights.shape)
    result: Floats = flat.reshape(*heights.shape, 3)
    return result


def implicit(values: npt.ArrayLike, points: npt.ArrayLike, dx: float = 1.0, dy: float = 1.0, dz: float = 1.0) -> Floats:
    """The unit normals of an implicit surface, on which a field of values is constant, at points of it.

    They point to where the values grow: outward for a distance, and inward for a density. They are approximate: the gradient at
    the nodes of the grid is that of central differences, and is interpolated in between. If you know the exact gradient, pass it
    to `shade` as `normals`, which have any length.

    values: numbers of shape (layers, rows, columns). The first is at the point (0, 0, 0).
    points: positions of shape (..., 3) in the grid, such as the vertices of a mesh that was made from the field.
    dx, dy, dz: what x grows by from a column to the next, y from a row to the next, and z from a layer to the next.

    Returns an array of the shape of points, of float32 if values and points are. Where the gradient is 0, the normal is 0.

    >>> z, y, x = np.mgrid[0:5, 0:5, 0:5]
    >>> implicit((x - 2) ** 2 + (y - 2) ** 2 + (z - 2) ** 2, points=(2, 3.5, 2))
    array([0., 1., 0.])
    """
    numbers, places = array("values", values), vectors("points", points)
    if numbers.ndim != 3:
        raise ValueError(f"values: expected the shape (layers, rows, columns), got {numbers.shape}")
    single = is_single(numbers, places)
    dtype: type[np.floating[Any]] = np.float32 if single else np.float64
    kernel: Any = _native.implicit_f32 if single else _native.implicit_f64
    rows = np.ascontiguousarray(places, dtype).reshape(-1, 3)
    steps = (number("dx", dx), number("dy", dy), number("dz", dz))
    field = np.ascontiguousarray(numbers, dtype)
    flat = called(kernel, field, rows, steps, grid=places.shape[:-1], values=field.shape)
    result: Floats = flat.reshape(places.shape)
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
    angle = None if crease is None else number("crease", crease)
    flat = called(kernel, rows, np.ascontiguousarray(indices, np.uint32), angle, grid=(len(points),))
    result: Floats = flat.reshape((-1, 3) if crease is None else (-1, 3, 3))
    return result
