import numpy as np
import numpy.typing as npt

_F32 = npt.NDArray[np.float32]
_F64 = npt.NDArray[np.float64]

def shade_f32(
    model: int,
    count: int,
    lights: list[list[float]],
    points: _F32,
    normals: _F32,
    eye: _F32,
    k_a: _F32,
    k_d: _F32,
    k_s: _F32,
    ambient: _F32,
    m: _F32,
    visible: _F32,
    parts: bool,
) -> _F32: ...
def shade_f64(
    model: int,
    count: int,
    lights: list[list[float]],
    points: _F64,
    normals: _F64,
    eye: _F64,
    k_a: _F64,
    k_d: _F64,
    k_s: _F64,
    ambient: _F64,
    m: _F64,
    visible: _F64,
    parts: bool,
) -> _F64: ...
def is_light(numbers: list[float]) -> bool: ...
def to_srgb8(colors: _F32) -> npt.NDArray[np.uint8]: ...
def from_srgb8(bytes: npt.NDArray[np.uint8]) -> _F32: ...
