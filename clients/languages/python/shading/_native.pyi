from typing import Optional

import numpy as np
import numpy.typing as npt

_F32 = npt.NDArray[np.float32]
_F64 = npt.NDArray[np.float64]
_U32 = npt.NDArray[np.uint32]
_Bytes = npt.NDArray[np.uint8]

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
    visible: Optional[_F32],
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
    visible: Optional[_F64],
    parts: bool,
) -> _F64: ...
def field_f32(z: _F32, dx: float, dy: float) -> _F32: ...
def field_f64(z: _F64, dx: float, dy: float) -> _F64: ...
def implicit_f32(values: _F32, points: _F32, steps: tuple[float, float, float]) -> _F32: ...
def implicit_f64(values: _F64, points: _F64, steps: tuple[float, float, float]) -> _F64: ...
def mesh_f32(vertices: _F32, faces: _U32, crease: Optional[float]) -> _F32: ...
def mesh_f64(vertices: _F64, faces: _U32, crease: Optional[float]) -> _F64: ...
def check_light(numbers: list[float]) -> None: ...
def to_srgb8(colors: _F32) -> _Bytes: ...
def to_srgba8(colors: _F32) -> _Bytes: ...
def from_srgb8(bytes: _Bytes) -> _F32: ...
