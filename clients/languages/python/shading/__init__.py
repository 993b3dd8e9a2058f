"""Lambert, Phong and Blinn-Phong shading of NumPy's arrays.

    import numpy as np
    import shading

    lamp = shading.point(position=(2, 1, 2), intensity=1, attenuation=(1, 0, 0.25))
    colors = shading.shade(points, normals, (0, 0, 5), [lamp], k_d=0.6, k_s=0.4, m=32, ambient=0.1)
    pixels = shading.to_srgb8(colors)

All directions point away from the surface, colors are linear light, and angles are in radians. Points, positions and distances
share a unit of length, which may be any. The last axis of an array of points, directions or colors has the length 3.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from importlib.metadata import version as _version
from typing import Any, Literal, NamedTuple, Union, overload

import numpy as np
import numpy.typing as npt

from . import _native

__version__ = _version("shading")
__all__ = ["Light", "Parts", "directional", "from_srgb8", "point", "shade", "spot", "to_srgb8"]

_MODELS = ("lambert", "phong", "blinn-phong")
_KINDS = ("directional", "point", "spot")
_Floats = npt.NDArray[np.floating[Any]]
_Vector = Union[Sequence[float], npt.NDArray[Any]]


@dataclass(frozen=True)
class Light:
    """A light, made by `directional`, `point` or `spot`. Two lights with equal numbers are equal."""

    kind: str
    position: tuple[float, float, float] = (0.0, 0.0, 0.0)
    direction: tuple[float, float, float] = (0.0, 0.0, 0.0)
    intensity: tuple[float, float, float] = (1.0, 1.0, 1.0)
    attenuation: tuple[float, float, float] = (1.0, 0.0, 0.0)
    range: float = math.inf
    inner: float = 0.0
    outer: float = 0.0
    gltf: bool = False

    def __repr__(self) -> str:
        if self.kind == "directional":
            return f"directional(toward={self.direction}, intensity={self.intensity})"
        cone = f", axis={self.direction}, inner={self.inner}, outer={self.outer}" if self.kind == "spot" else ""
        end = "" if math.isinf(self.range) else f", range={self.range}"
        gltf = ", gltf=True" if self.gltf else ""
        return (
            f"{self.kind}(position={self.position}, intensity={self.intensity}{cone}, "
            f"attenuation={self.attenuation}{end}{gltf})"
        )

    def _numbers(self) -> list[float]:
        return [
            float(_KINDS.index(self.kind)),
            *self.position,
            *self.direction,
            *self.intensity,
            *self.attenuation,
            self.range,
            self.inner,
            self.outer,
            float(self.gltf),
        ]


class Parts(NamedTuple):
    """The three parts of the light that a surface sends to the eye. Their sum is what `shade` returns without `parts`."""

    ambient: _Floats
    diffuse: _Floats
    specular: _Floats


def _three(name: str, value: npt.ArrayLike, what: str) -> tuple[float, float, float]:
    """Three finite numbers; `what` says which."""
    try:
        array = np.asarray(value, dtype=np.float64)
    except (TypeError, ValueError):
        array = np.empty(0)
    if array.shape != (3,) or not np.isfinite(array).all():
        raise ValueError(f"{name}: expected {what}, got {value!r}")
    x, y, z = (float(number) for number in array)
    return x, y, z


def _color(name: str, value: npt.ArrayLike) -> tuple[float, float, float]:
    what = "a finite number or three of them, 0 or more"
    is_gray = isinstance(value, (int, float, np.number))
    color = _three(name, np.full(3, value) if is_gray else value, what)
    if min(color) < 0:
        raise ValueError(f"{name}: expected {what}, got {value!r}")
    return color


def _direction(name: str, value: npt.ArrayLike) -> tuple[float, float, float]:
    what = "three finite numbers, not all 0"
    direction = _three(name, value, what)
    if direction == (0, 0, 0):
        raise ValueError(f"{name}: expected {what}, got {value!r}")
    return direction


def _attenuation(value: npt.ArrayLike, end: float) -> tuple[float, float, float]:
    what = "three finite numbers a, b, c, 0 or more and not all 0"
    attenuation = _three("attenuation", value, what)
    if min(attenuation) < 0 or max(attenuation) == 0:
        raise ValueError(f"attenuation: expected {what}, got {value!r}")
    if not end > 0:
        raise ValueError(f"range: expected a number above 0, or infinity, got {end!r}")
    return attenuation


def _checked(light: Light) -> Light:
    if not _native.is_light(light._numbers()):
        raise ValueError(f"expected a light, got {light!r}")
    return light


def directional(toward: _Vector, intensity: float | _Vector = 1.0) -> Light:
    """A light so far away that its rays are parallel, such as the sun.

    toward: the direction **to** the light; three numbers of any length.
    intensity: linear red, green and blue, or one number for gray light.

    >>> directional(toward=(0, 0, 2), intensity=0.5)
    directional(toward=(0.0, 0.0, 2.0), intensity=(0.5, 0.5, 0.5))
    """
    return _checked(
        Light("directional", direction=_direction("toward", toward), intensity=_color("intensity", intensity))
    )


def point(
    position: _Vector,
    intensity: float | _Vector = 1.0,
    attenuation: _Vector = (1.0, 0.0, 0.0),
    range: float = math.inf,
    gltf: bool = False,
) -> Light:
    """A light that shines from a point, with the intensity I/(a + b q + c q²) at the distance q.

    position: three numbers.
    intensity: linear red, green and blue, or one number for gray light.
    attenuation: a, b and c; (0, 0, 1) is an inverse square.
    range: the distance at which the light ends, by the factor max(0, 1 - (q/range)⁴)².
    gltf: ends the light as the specification of glTF does, without the square.
    """
    end = float(range)
    return _checked(
        Light(
            "point",
            position=_three("position", position, "three finite numbers"),
            intensity=_color("intensity", intensity),
            attenuation=_attenuation(attenuation, end),
            range=end,
            gltf=bool(gltf),
        )
    )


def spot(
    position: _Vector,
    axis: _Vector,
    intensity: float | _Vector = 1.0,
    inner: float = 0.0,
    outer: float = math.pi / 4,
    attenuation: _Vector = (1.0, 0.0, 0.0),
    range: float = math.inf,
    gltf: bool = False,
) -> Light:
    """A point light that shines into a cone.

    axis: the direction in which it shines, away from the light; three numbers of any length.
    inner, outer: the half-angles, measured from the axis, between which the edge softens as t²; equal for a hard edge.
    The other arguments are those of `point`.
    """
    end = float(range)
    if not 0 <= inner <= outer <= math.pi:
        raise ValueError(f"inner, outer: expected 0 <= inner <= outer <= pi, got {inner!r} and {outer!r}")
    return _checked(
        Light(
            "spot",
            position=_three("position", position, "three finite numbers"),
            direction=_direction("axis", axis),
            intensity=_color("intensity", intensity),
            attenuation=_attenuation(attenuation, end),
            range=end,
            inner=float(inner),
            outer=float(outer),
            gltf=bool(gltf),
        )
    )


def _array(name: str, value: npt.ArrayLike) -> npt.NDArray[Any]:
    array = np.asarray(value)
    if array.dtype.kind not in "fiub":
        raise TypeError(f"{name}: expected numbers, got an array of {array.dtype}")
    return array


def _fitted(
    name: str, array: npt.NDArray[Any], shape: tuple[int, ...], dtype: npt.DTypeLike, points: range
) -> npt.NDArray[Any]:
    """The array, broadcast to the shape. If it is the same for all points, whose axes are `points`, they have the length 1."""
    try:
        full = np.broadcast_to(np.asarray(array, dtype), shape)
    except ValueError:
        raise ValueError(f"{name}: expected a shape that broadcasts to {shape}, got {array.shape}") from None
    if all(full.strides[axis] == 0 or shape[axis] == 1 for axis in points):
        full = full[tuple(slice(0, 1) if axis in points else slice(None) for axis in range(len(shape)))]
    return np.ascontiguousarray(full)


def _joined(shape: tuple[int, ...], name: str, other: tuple[int, ...]) -> tuple[int, ...]:
    try:
        return np.broadcast_shapes(shape, other)
    except ValueError:
        raise ValueError(f"{name}: expected a shape that broadcasts to {shape}, got {other}") from None


def _vectors(name: str, value: npt.ArrayLike) -> npt.NDArray[Any]:
    array = _array(name, value)
    if array.ndim == 0 or array.shape[-1] != 3:
        raise ValueError(f"{name}: expected the shape (..., 3), got {array.shape}")
    return array


def _is_light(name: str, array: npt.NDArray[Any]) -> npt.NDArray[Any]:
    bad = ~((array >= 0) & (array < np.inf))
    if bad.any():
        index = tuple(int(i) for i in np.argwhere(bad)[0])
        where = f" at {list(index)}" if index else ""
        raise ValueError(f"{name}: expected finite numbers of 0 or more, got {array[index]}{where}")
    return array


@overload
def shade(
    points: npt.ArrayLike,
    normals: npt.ArrayLike,
    eye: npt.ArrayLike,
    lights: Light | Sequence[Light],
    *,
    k_a: npt.ArrayLike = ...,
    k_d: npt.ArrayLike = ...,
    k_s: npt.ArrayLike = ...,
    m: npt.ArrayLike = ...,
    ambient: npt.ArrayLike = ...,
    model: str = ...,
    visible: npt.ArrayLike | None = ...,
    parts: Literal[False] = ...,
) -> _Floats: ...


@overload
def shade(
    points: npt.ArrayLike,
    normals: npt.ArrayLike,
    eye: npt.ArrayLike,
    lights: Light | Sequence[Light],
    *,
    k_a: npt.ArrayLike = ...,
    k_d: npt.ArrayLike = ...,
    k_s: npt.ArrayLike = ...,
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
    k_a: npt.ArrayLike = 0.0,
    k_d: npt.ArrayLike = 0.0,
    k_s: npt.ArrayLike = 0.0,
    m: npt.ArrayLike = 1.0,
    ambient: npt.ArrayLike = 1.0,
    model: str = "blinn-phong",
    visible: npt.ArrayLike | None = None,
    parts: bool = False,
) -> _Floats | Parts:
    """The linear light that points of a surface send to the eye.

    k_a ambient + sum over the lights with N.L > 0 of I (k_d N.L + k_s max(0, cosine)^m), where the cosine is R.V for "phong"
    and N.H for "blinn-phong"; "lambert" leaves the highlight out.

    points, normals, eye: arrays of shape (..., 3). Normals have any length. Where a normal has no direction, or where the point
        is at the eye, the result is black.
    lights: a light or a sequence of lights.
    k_a, k_d, k_s: what the surface reflects of each channel, usually from 0 to 1: a number, three numbers, or a texture of
        shape (..., 3), or (..., 1) if it is gray.
    m: the shininess, 0 or more: a number, or an array of shape (...), without the 3. Whole numbers are faster.
    ambient: the ambient light; a number, three numbers, or an array like a texture.
    model: "lambert", "phong" or "blinn-phong".
    visible: which lights reach which points: an array that broadcasts to (number of lights, ...), of bool or of fractions from
        0 to 1. Without it, all do.
    parts: returns a tuple of the ambient, the diffuse and the specular part.

    All these arrays broadcast to each other as NumPy's do; the result has their common shape (..., 3). It is 0 or more, without
    an upper limit. It is float32 if points and normals are; otherwise it is computed in float64.

    >>> shade((0, 0, 0), (0, 0, 1), (0, 0, 5), directional(toward=(0, 0, 1)), k_d=(0.5, 0.25, 0))
    array([0.5 , 0.25, 0.  ])
    """
    if model not in _MODELS:
        raise ValueError(f'model: expected "lambert", "phong" or "blinn-phong", got {model!r}')
    lights = [lights] if isinstance(lights, Light) else list(lights)
    for i, light in enumerate(lights):
        if not isinstance(light, Light):
            raise TypeError(f"lights[{i}]: expected a Light, made by directional, point or spot, got {light!r}")
    if model == "lambert":
        k_s, m = np.zeros(np.shape(k_s)), np.ones(np.shape(m))  # unused, but their shapes still broadcast

    places = {name: _vectors(name, value) for name, value in (("points", points), ("normals", normals), ("eye", eye))}
    reflectances = {"k_a": k_a, "k_d": k_d, "k_s": k_s, "ambient": ambient}
    colors = {name: _is_light(name, _array(name, value)) for name, value in reflectances.items()}
    powers = _array("m", m)
    if not (powers >= 0).all():
        raise ValueError(f"m: expected numbers of 0 or more, got {powers[~(powers >= 0)][0]}")
    seen = _array("visible", 1.0 if visible is None else visible)
    if not ((seen >= 0) & (seen <= 1)).all():
        raise ValueError(f"visible: expected bool, or fractions from 0 to 1, got {seen[~((seen >= 0) & (seen <= 1))][0]}")

    shape: tuple[int, ...] = (3,)
    for name, array in {**places, **colors}.items():
        shape = _joined(shape, name, array.shape)
    grid = _joined(shape[:-1], "m", powers.shape)
    shape, mask, count = (*grid, 3), (len(lights), *grid), math.prod(grid)

    is_single = all(places[name].dtype == np.float32 for name in ("points", "normals"))
    dtype: type[np.floating[Any]] = np.float32 if is_single else np.float64
    axes = range(len(grid))
    rows = [_fitted(name, array, shape, dtype, axes).reshape(-1, 3) for name, array in {**places, **colors}.items()]
    m_rows = _fitted("m", powers, grid, dtype, axes).reshape(-1)
    seen_rows = _fitted("visible", seen, mask, dtype, range(1, len(mask)))
    seen_rows = seen_rows.reshape(len(lights), -1) if seen_rows.size else np.ones((len(lights), 1), dtype)

    kernel: Any = _native.shade_f32 if is_single else _native.shade_f64
    numbers = [light._numbers() for light in lights]
    flat = kernel(_MODELS.index(model), count, numbers, *rows, m_rows, seen_rows, parts)
    if parts:
        return Parts(*flat.reshape(3, *shape))
    result: _Floats = flat.reshape(shape)
    return result


def to_srgb8(colors: npt.ArrayLike) -> npt.NDArray[np.uint8]:
    """The bytes of linear colors in sRGB, each rounded to the nearest.

    colors: an array of shape (..., 3), where 1 is the brightest that a screen shows. What is brighter is cut off, and NaN is 0.

    Returns an array of uint8 of the same shape.
    """
    array = _vectors("colors", colors)
    flat = np.ascontiguousarray(array, np.float32).reshape(-1, 3)
    return _native.to_srgb8(flat).reshape(array.shape)


def from_srgb8(texture: npt.ArrayLike) -> npt.NDArray[np.float32]:
    """The linear colors of sRGB bytes, such as those of an image file, to be used as k_d.

    texture: an array of uint8 of shape (..., 3).

    Returns an array of float32 of the same shape, from 0 to 1.
    """
    array = _vectors("texture", texture)
    if array.dtype != np.uint8:
        raise TypeError(f"texture: expected an array of uint8, got one of {array.dtype}")
    return _native.from_srgb8(np.ascontiguousarray(array).reshape(-1, 3)).reshape(array.shape)
