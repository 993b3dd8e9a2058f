"""Colors as the bytes of images."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from . import _native
from ._arrays import array, vectors


def _linear(colors: npt.ArrayLike) -> tuple[npt.NDArray[np.float32], tuple[int, ...]]:
    values = vectors("colors", colors)
    if values.dtype.kind in "iu" and values.size and values.max() > 1:
        raise TypeError(f"colors: expected linear light, where 1 is white, got whole numbers up to {values.max()}")
    with np.errstate(over="ignore"):
        return np.ascontiguousarray(values, np.float32).reshape(-1, 3), values.shape


def to_srgb8(colors: npt.ArrayLike) -> npt.NDArray[np.uint8]:
    """The bytes of linear colors in sRGB, each rounded to the nearest.

    colors: an array of shape (..., 3), where 1 is the brightest that a screen shows. What is brighter is cut off, and NaN is 0.

    Returns an array of uint8 of the same shape.
    """
    flat, shape = _linear(colors)
    return _native.to_srgb8(flat).reshape(shape)


def to_srgba8(colors: npt.ArrayLike) -> npt.NDArray[np.uint8]:
    """The bytes of `to_srgb8` with an opaque alpha: an array of shape (..., 4)."""
    flat, shape = _linear(colors)
    return _native.to_srgba8(flat).reshape(*shape[:-1], 4)


def from_srgb8(texture: npt.ArrayLike) -> npt.NDArray[np.float32]:
    """The linear colors of sRGB bytes, such as those of an image file, to be used as k_d.

    texture: an array of uint8 of shape (..., 3).

    Returns an array of float32 of the same shape, from 0 to 1.
    """
    if array("texture", texture).dtype != np.uint8:
        raise TypeError(f"texture: expected an array of uint8, got one of {np.asarray(texture).dtype}")
    values = np.asarray(texture)
    if values.ndim and values.shape[-1] == 4:
        raise ValueError(f"texture: expected the shape (..., 3), got {values.shape}; leave alpha out by texture[..., :3]")
    bytes = vectors("texture", values)
    return _native.from_srgb8(np.ascontiguousarray(bytes).reshape(-1, 3)).reshape(bytes.shape)
