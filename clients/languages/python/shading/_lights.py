"""Lights."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Union

import numpy as np
import numpy.typing as npt

from . import _native
from ._arrays import BYTES, number, numbers, refusal, short

_KINDS = ("directional", "point", "spot")
Vector = Union[Sequence[float], npt.NDArray[Any]]


@dataclass(frozen=True)
class Light:
    """A light, made by `directional`, `point` or `spot`. Two lights with equal numbers are equal."""

    kind: str
    position: tuple[float, float, float] = (0.0, 0.0, 0.0)
    toward: tuple[float, float, float] = (0.0, 0.0, 0.0)
    axis: tuple[float, float, float] = (0.0, 0.0, 0.0)
    intensity: tuple[float, float, float] = (1.0, 1.0, 1.0)
    attenuation: tuple[float, float, float] = (1.0, 0.0, 0.0)
    range: float = math.inf
    inner: float = 0.0
    outer: float = math.pi / 4
    gltf: bool = False

    def __post_init__(self) -> None:
        if self.kind not in _KINDS:
            raise ValueError(f"kind: expected a light made by directional, point or spot, got {short(self.kind)}")
        intensity = self.intensity
        is_gray = np.ndim(intensity) == 0 and not isinstance(intensity, str) and intensity is not None
        object.__setattr__(self, "intensity", [intensity] * 3 if is_gray else intensity)
        if getattr(intensity, "dtype", None) in BYTES:
            raise TypeError(f"intensity: expected linear light, got {short(intensity)}; from_srgb8 decodes an image's bytes")
        for name in ("position", "toward", "axis", "intensity", "attenuation"):
            object.__setattr__(self, name, numbers(name, getattr(self, name), 3))
        for name in ("range", "inner", "outer"):
            object.__setattr__(self, name, number(name, getattr(self, name)))
        if not isinstance(self.gltf, (bool, np.bool_)):
            raise TypeError(f"gltf: expected True or False, got {short(self.gltf)}")
        object.__setattr__(self, "gltf", bool(self.gltf))
        try:
            _native.check_light(self._words())
        except ValueError as error:
            raise ValueError(refusal(error)[0]) from None

    def __repr__(self) -> str:
        if self.kind == "directional":
            return f"directional(toward={self.toward}, intensity={self.intensity})"
        cone = f", axis={self.axis}, inner={self.inner}, outer={self.outer}" if self.kind == "spot" else ""
        end = "" if math.isinf(self.range) else f", range={self.range}"
        gltf = ", gltf=True" if self.gltf else ""
        return (
            f"{self.kind}(position={self.position}, intensity={self.intensity}{cone}, "
            f"attenuation={self.attenuation}{end}{gltf})"
        )

    def _words(self) -> list[float]:
        """In the order of the kernel's structure."""
        vectors = (self.position, self.toward, self.axis, self.intensity, self.attenuation)
        numbers = [number for vector in vectors for number in vector]
        return [float(_KINDS.index(self.kind)), *numbers, self.range, self.inner, self.outer, float(self.gltf)]


def directional(toward: Vector, intensity: float | Vector = 1.0) -> Light:
    """A light so far away that its rays are parallel, such as the sun.

    toward: the direction **to** the light; three numbers of any length.
    intensity: linear red, green and blue, or one number for gray light.

    >>> directional(toward=(0, 0, 2), intensity=0.5)
    directional(toward=(0.0, 0.0, 2.0), intensity=(0.5, 0.5, 0.5))
    """
    return Light("directional", toward=toward, intensity=intensity)  # type: ignore[arg-type]


def point(
    position: Vector,
    intensity: float | Vector = 1.0,
    attenuation: Vector = (1.0, 0.0, 0.0),
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
    return Light(
        "point", position, intensity=intensity, attenuation=attenuation, range=range, gltf=gltf,  # type: ignore[arg-type]
    )


def spot(
    position: Vector,
    axis: Vector,
    intensity: float | Vector = 1.0,
    inner: float = 0.0,
    outer: float = math.pi / 4,
    attenuation: Vector = (1.0, 0.0, 0.0),
    range: float = math.inf,
    gltf: bool = False,
) -> Light:
    """A point light that shines into a cone.

    axis: the direction in which it shines, away from the light; three numbers of any length.
    inner, outer: the half-angles in radians, measured from the axis, between which the edge softens as t²; equal for a hard edge.
    The other arguments are those of `point`.
    """
    return Light(
        "spot", position, axis=axis, intensity=intensity, attenuation=attenuation, range=range,  # type: ignore[arg-type]
        inner=inner, outer=outer, gltf=gltf,
    )
