"""The shading of many points."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, Literal, NamedTuple, Union, overload

import numpy as np
import numpy.typing as npt

from . import _native
from ._arrays import Floats, array, called, fitted, is_single, joined, reflectance, short, vectors
from ._lights import Light

_MODELS = ("lambert", "phong", "blinn-phong")


class Parts(NamedTuple):
    """The three parts of the light that a surface sends to the eye. Their sum is what `shade` returns without `parts`."""

    ambient: Floats
    diffuse: Floats
    specular: Floats


def _lights(lights: Light | Sequence[Light]) -> list[Light]:
    expected = "a light, made by directional, point or spot"
    if isinstance(lights, Light):
        return [lights]
    if lights is None or isinstance(lights, str) or not hasattr(lights, "__iter__"):
        raise TypeError(f"lights: expected {expected}, or a sequence of lights, got {short(lights)}")
    result = list(lights)
    for i, light in enumerate(result):
        if not isinstance(light, Light):
            raise TypeError(f"lights[{i}]: expected {expected}, got {short(light)}")
    return result


@overload
def shade(
    points: npt.ArrayLike,
    normals: npt.ArrayLike,
    eye: npt.ArrayLike,
    lights: Light | Sequence[Light],
    *,
    k_a: npt.ArrayLike | None = ...,
    k_d: npt.ArrayLike | None = ...,
    k_s: npt.ArrayLike | None = ...,
    m: npt.ArrayLike = ...,
    ambient: npt.ArrayLike = ...,
    model: str = ...,
    visible: npt.ArrayLike | None = ...,
    parts: Literal[False] = ...,
) -> Floats: ...


@overload
def shade(
    points: npt.ArrayLike,
    normals: npt.ArrayLike,
    eye: npt.ArrayLike,
    lights: Light | Sequence[Light],
    *,
    k_a: npt.ArrayLike | None = ...,
    k_d: npt.ArrayLike | None = ...,
    k_s: npt.ArrayLike | None = ...,
    m: npt.ArrayLike = ...,
    ambient: npt.ArrayLike = ...,
    model: str = ...,
    visible: npt.ArrayLike | None = ...,
    parts: Literal[True],
) -> Parts: ...


def shade(
    points: npt.ArrayLike,
    normals: npt.ArrayLike,
    eye: npt.ArrayLike,
    lights: Light | Sequence[Light],
    *,
    k_a: npt.ArrayLike | None = None,
    k_d: npt.ArrayLike | None = None,
    k_s: npt.ArrayLike | None = None,
    m: npt.ArrayLike = 1.0,
    ambient: npt.ArrayLike = 1.0,
    model: str = "blinn-phong",
    visible: npt.ArrayLike | None = None,
    parts: bool = False,
) -> Union[Floats, Parts]:
    """The linear light that points of a surface send to the eye.

    k_a ambient + sum over the lights with N.L > 0 of I (k_d N.L + k_s max(0, cosine)^m), where the cosine is R.V for "phong"
    and N.H for "blinn-phong"; "lambert" leaves the highlight out.

    points, normals, eye: arrays of shape (..., 3). The eye is a position. Normals have any length, as a gradient has. Where a normal is 0, or where the
        point is at the eye, the result is black.
    lights: a light or a sequence of lights.
    k_a, k_d, k_s: what the surface reflects of each channel, usually from 0 to 1: a number, three numbers, or a texture of
        shape (..., 3), or (..., 1) if it is gray. At least one must be given; the others are 0. An image's bytes are decoded by
        `from_srgb8` first.
    m: the shininess, 0 or more: a number, or an array of shape (...), without the 3. Whole numbers are faster.
    ambient: the ambient light; a number, three numbers, or an array like a texture.
    model: "lambert", "phong" or "blinn-phong".
    visible: which lights reach which points: an array that broadcasts to (number of lights, ...), of bool or of fractions from
        0 to 1. Without it, all do. `help(shading)` makes one of the shadows of a relief.
    parts: returns a tuple of the ambient, the diffuse and the specular part.

    All these arrays broadcast to each other as NumPy's do; the result has their common shape (..., 3). It is 0 or more, without
    an upper limit. It is float32 if points and normals are; otherwise it is computed in float64.

    >>> shade((0, 0, 0), (0, 0, 1), (0, 0, 5), directional(toward=(0, 0, 1)), k_d=(0.5, 0.25, 0))
    array([0.5 , 0.25, 0.  ])
    """
    if not isinstance(model, str) or model not in _MODELS:
        raise ValueError(f'model: expected "lambert", "phong" or "blinn-phong", got {short(model)}')
    if not isinstance(parts, (bool, np.bool_)):
        raise TypeError(f"parts: expected True or False, got {short(parts)}")
    if k_a is None and k_d is None and k_s is None:
        raise ValueError("k_d: expected a reflectance, such as 0.6, in k_d, k_a or k_s, got none")
    all_lights = _lights(lights)

    places = {name: vectors(name, value) for name, value in (("points", points), ("normals", normals), ("eye", eye))}
    reflectances = {"k_a": k_a, "k_d": k_d, "k_s": k_s, "ambient": ambient}
    colors = {name: reflectance(name, 0.0 if value is None else value) for name, value in reflectances.items()}
    powers = array("m", m)
    seen = None if visible is None else array("visible", visible)

    shape: tuple[int, ...] = (3,)
    for name, value in {**places, **colors}.items():
        shape = joined(shape, name, value.shape)
    if len(shape) > 1 and powers.shape in ((*shape[:-1], 1), shape):
        raise ValueError(f"m: expected the shape {shape[:-1]}, got {powers.shape}; m[..., 0] leaves the last axis out")
    try:
        grid = np.broadcast_shapes(shape[:-1], powers.shape)
    except ValueError:
        raise ValueError(f"m: expected a shape that broadcasts to {shape[:-1]}, got {powers.shape}") from None
    shape, mask, count = (*grid, 3), (len(all_lights), *grid), math.prod(grid)

    single = is_single(places["points"], places["normals"])
    dtype: type[np.floating[Any]] = np.float32 if single else np.float64
    axes = range(len(grid))
    rows = [fitted(name, value, shape, dtype, axes).reshape(-1, 3) for name, value in {**places, **colors}.items()]
    m_rows = fitted("m", powers, grid, dtype, axes).reshape(-1)
    seen_rows = None if seen is None else fitted("visible", seen, mask, dtype, range(1, len(mask))).reshape(-1)

    kernel: Any = _native.shade_f32 if single else _native.shade_f64
    words = [light._words() for light in all_lights]
    flat = called(kernel, _MODELS.index(model), count, words, *rows, m_rows, seen_rows, bool(parts), grid=grid, visible=mask)
    if parts:
        return Parts(*flat.reshape(3, *shape))
    result: Floats = flat.reshape(shape)
    return result
