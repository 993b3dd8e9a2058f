"""The same from Python, by ctypes, on NumPy's arrays, with a picture: main.py LIBRARY FOLDER."""

import ctypes
import sys
import time
from pathlib import Path

import numpy as np
from PIL import Image

BLINN_PHONG = 2
DIRECTIONAL, POINT, SPOT = range(3)
VECTOR = ("<f4", 3)
LIGHT = np.dtype([("kind", "<u4"), ("position", *VECTOR), ("direction", *VECTOR), ("intensity", *VECTOR),
                  ("attenuation", *VECTOR), ("range", "<f4"), ("inner", "<f4"), ("outer", "<f4"),
                  ("unsquared", "<u4")])
MATERIAL = np.dtype([("k_a", *VECTOR), ("k_d", *VECTOR), ("k_s", *VECTOR), ("m", "<f4")])

NONE = (0, 0, 0)
LIGHTS = np.array([
    (DIRECTIONAL, NONE, (-1, 2, 2), (0.25, 0.25, 0.375), NONE, 0, 0, 0, 0),
    (POINT, (2, 1, 2), NONE, (1, 0.75, 0.5), (1, 0, 0.25), np.inf, 0, 0, 0),
    (POINT, (-4, -2, 4), NONE, (2, 4, 8), (0, 0, 1), 8, 0, 0, 1),
    (SPOT, (0, 3, 3), (0, -1, -1), (3, 1, 1), (1, 0.5, 0), 8, 0.25, 0.375, 0),
], LIGHT)
CLAY = np.array(((0.125,) * 3, (0.5, 0.375, 0.25), (0.5,) * 3, 32), MATERIAL)
EYE = np.array([0, 0, 5], "<f4")
AMBIENT = np.array([0.5, 0.5, 0.5], "<f4")


class Shading:
    """The functions of shading.h, on arrays."""

    def __init__(self, path):
        size, buffer = ctypes.c_size_t, ctypes.c_void_p
        library = ctypes.CDLL(path)
        self._shade, self._encode = library.shading_shade, library.shading_to_srgb8
        self._shade.argtypes = [ctypes.c_uint32, size, *[buffer] * 6, size, buffer]
        self._encode.argtypes = [size, buffer, buffer]

    def shade(self, model, points, normals, eye, material, ambient, lights):
        """The light that each point sends to the eye, of the shape of `points`."""
        if normals.shape != points.shape or points.shape[-1] != 3:
            raise ValueError(f"points of shape {points.shape}, normals of {normals.shape}: they must be the same, (…, 3)")
        inputs = [np.ascontiguousarray(array, "<f4") for array in (points, normals, eye)]
        material, ambient = np.ascontiguousarray(material, MATERIAL), np.ascontiguousarray(ambient, "<f4")
        lights, out = np.ascontiguousarray(lights, LIGHT), np.empty(points.shape, "<f4")
        if inputs[2].shape != (3,) or ambient.shape != (3,) or material.size != 1:
            raise ValueError("eye and ambient have three numbers each, and there is one material")
        pointers = [array.ctypes.data for array in (*inputs, material, ambient, lights)]
        self._check(self._shade(model, points.size // 3, *pointers, lights.size, out.ctypes.data))
        return out

    def to_srgb8(self, colors):
        """The bytes of linear colors, of the same shape."""
        colors = np.ascontiguousarray(colors, "<f4")
        out = np.empty(colors.shape, np.uint8)
        self._check(self._encode(colors.size // 3, colors.ctypes.data, out.ctypes.data))
        return out

    @staticmethod
    def _check(status):
        if status:
            texts = ("null", "alignment", "size", "overlap", "no such model", "bad material", "bad light")
            raise ValueError(f"shading: {texts[status - 1]}")


def unit(v):
    return v / np.sqrt(np.sum(v * v, axis=-1, keepdims=True))


def dot(a, b):
    return np.sum(a * b, axis=-1, keepdims=True)


def by_hand(points, normals, eye, material, ambient, lights):
    """What one writes with NumPy alone."""
    n, v = unit(normals), unit(eye - points)
    color = np.broadcast_to(material["k_a"] * ambient, points.shape).copy()
    for light in lights:
        if light["kind"] == DIRECTIONAL:
            l, factor = np.broadcast_to(unit(light["direction"]), points.shape), np.float32(1)
        else:
            way = light["position"] - points
            q = np.sqrt(dot(way, way))
            l, (a, b, c) = way / q, light["attenuation"]
            window = np.maximum(0, 1 - (q / light["range"]) ** 4) ** (1 if light["unsquared"] else 2)
            factor = window / (a + b * q + c * q * q)
        if light["kind"] == SPOT:
            inner, outer = np.cos(light["inner"]), np.cos(light["outer"])
            factor = factor * np.clip((-dot(l, unit(light["direction"])) - outer) / (inner - outer), 0, 1) ** 2
        n_dot_l = np.maximum(0, dot(n, l))
        highlight = np.where(n_dot_l > 0, np.maximum(0, dot(n, unit(l + v))) ** material["m"], 0)
        color += light["intensity"] * factor * (material["k_d"] * n_dot_l + material["k_s"] * highlight)
    return color


def least(work, passes):
    times = []
    for _ in range(passes):
        start = time.perf_counter()
        work()
        times.append(time.perf_counter() - start)
    return min(times)


def main(library, folder):
    folder = Path(folder)
    points, normals, expected = (
        np.fromfile(folder / name, "<f4").reshape(256, 256, 3) for name in ("points", "normals", "colors"))
    shading = Shading(library)
    scene = (points, normals, EYE, CLAY, AMBIENT, LIGHTS)
    colors = shading.shade(BLINN_PHONG, *scene)
    if colors.tobytes() != expected.tobytes():
        raise SystemExit("Python: other bits than the crate's")
    picture = shading.to_srgb8(colors)
    if picture.tobytes() != (folder / "bytes").read_bytes():
        raise SystemExit("Python: other bytes than the crate's")
    for wrong in (dict(model=7), dict(lights=np.zeros(1, LIGHT)), dict(normals=normals[:1])):
        arguments = dict(zip(("model", "points", "normals", "eye", "material", "ambient", "lights"), (BLINN_PHONG, *scene)))
        try:
            shading.shade(**{**arguments, **wrong})
        except ValueError:
            continue
        raise SystemExit(f"Python: no error for {wrong}")
    np.testing.assert_allclose(by_hand(*scene), colors, rtol=1e-4, atol=1e-4)
    Image.fromarray(picture).save(folder / "sphere.png")
    ours, theirs = least(lambda: shading.shade(BLINN_PHONG, *scene), 20), least(lambda: by_hand(*scene), 5)
    print(f"Python: {1e3 * ours:.1f} ms, {ours / theirs:.2f} of the time with NumPy; all bits are the crate's")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        raise SystemExit("usage: main.py LIBRARY FOLDER")
    main(*sys.argv[1:])
