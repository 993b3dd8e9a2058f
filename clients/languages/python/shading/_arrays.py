"""Arguments as arrays of the shapes that the kernels take."""

from __future__ import annotations

from typing import Any, Callable, Union

import numpy as np
import numpy.typing as npt

BYTES = (np.uint8, np.uint16)
Floats = npt.NDArray[np.floating[Any]]


def array(name: str, value: npt.ArrayLike) -> npt.NDArray[Any]:
    """The numbers."""
    if isinstance(value, np.ma.MaskedArray):
        raise TypeError(f"{name}: expected an array without a mask, got a masked one; fill it, or pass value[~mask]")
    try:
        result = np.asarray(value)
    except ValueError:
        raise ValueError(f"{name}: expected numbers in a regular shape, got {short(value)}") from None
    except TypeError:
        raise TypeError(f"{name}: expected numbers, got {short(value)}") from None
    if result.dtype.kind not in "fiub":
        raise TypeError(f"{name}: expected numbers, got {short(value)}")
    return result


def short(value: Any) -> str:
    """The value as it is written in a message, in one line."""
    text = " ".join(repr(value).split())
    if getattr(value, "ndim", 0) and (len(text) > 80 or not isinstance(value, np.ndarray)):  # or what pandas and xarray have
        return f"{type(value).__name__} of {np.asarray(value).dtype} in the shape {np.shape(value)}"
    return text if len(text) <= 80 else f"{text[:77]}..."


def numbers(name: str, value: Any, count: int) -> tuple[float, ...]:
    """So many numbers, finite or not."""
    what = "three finite numbers" if count == 3 else "a number"
    refused = f"{name}: expected {what}, got {short(value)}"
    if isinstance(value, np.ma.MaskedArray):
        raise TypeError(refused)
    try:
        array = np.asarray(value)
        result = array.astype(np.float64) if array.dtype.kind in "fiub" else np.empty(0)
    except (TypeError, ValueError):
        result = np.empty(0)
    if result.shape != ((3,) if count == 3 else ()):
        raise TypeError(refused)
    return tuple(float(number) for number in np.atleast_1d(result))


def number(name: str, value: Any) -> float:
    return numbers(name, value, 1)[0]


def vectors(name: str, value: npt.ArrayLike) -> npt.NDArray[Any]:
    result = array(name, value)
    if result.ndim == 0 or result.shape[-1] != 3:
        hint = f"; np.moveaxis({name}, 0, -1) puts the 3 last" if result.ndim > 1 and result.shape[0] == 3 else ""
        raise ValueError(f"{name}: expected the shape (..., 3), got {result.shape}{hint}")
    return result


def reflectance(name: str, value: npt.ArrayLike) -> npt.NDArray[Any]:
    result = array(name, value)
    if result.dtype in BYTES:
        raise TypeError(
            f"{name}: expected linear numbers, usually from 0 to 1, got {result.dtype}; from_srgb8 decodes an image's bytes"
        )
    return result


def joined(shape: tuple[int, ...], name: str, other: tuple[int, ...]) -> tuple[int, ...]:
    try:
        return np.broadcast_shapes(shape, other)
    except ValueError:
        hint = f"; a gray texture is {name}[..., None]" if other == shape[:-1] else ""
        raise ValueError(f"{name}: expected a shape that broadcasts to {shape}, got {other}{hint}") from None


def fitted(
    name: str, value: npt.NDArray[Any], shape: tuple[int, ...], dtype: npt.DTypeLike, points: range
) -> npt.NDArray[Any]:
    """The array, broadcast to the shape. If it is the same for all points, whose axes are `points`, they have the length 1."""
    with np.errstate(over="ignore"):  # what is too large for float32 is refused as infinite
        single = np.asarray(value, dtype)
    try:
        full = np.broadcast_to(single, shape)
    except ValueError:
        raise ValueError(f"{name}: expected a shape that broadcasts to {shape}, got {value.shape}") from None
    if all(full.strides[axis] == 0 or shape[axis] == 1 for axis in points):
        full = full[tuple(slice(0, 1) if axis in points else slice(None) for axis in range(len(shape)))]
    return np.ascontiguousarray(full)


def is_single(*arrays: npt.NDArray[Any]) -> bool:
    return all(array.dtype == np.float32 for array in arrays)


def called(kernel: Callable[..., Any], *arguments: Any, grid: tuple[int, ...], **grids: tuple[int, ...]) -> Any:
    """What the kernel returns. If it refuses a row, the message gives the index within the axes of the points, or within those
    of the argument that `grids` names."""
    try:
        return kernel(*arguments)
    except ValueError as error:
        message, index = refusal(error)
        if index is None:
            raise ValueError(message) from None
        known = tuple(max(side, 1) for side in grids.get(message.split(":")[0], grid)[1:])
        axes = [int(i) for i in np.unravel_index(index % max(int(np.prod(known)), 1), known)] if known else []
        raise ValueError(f"{message} at {[index // max(int(np.prod(known)), 1), *axes]}") from None


def refusal(error: ValueError) -> tuple[str, Union[int, None]]:
    """The message of a kernel, and the index of the row that it refuses."""
    if len(error.args) == 2:
        message, index = error.args
        return str(message), index
    return str(error), None
