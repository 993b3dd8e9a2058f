"""The calls of ../../interface.json, which JavaScript and C make too, and those that only Python can write."""

from __future__ import annotations

import dataclasses
import inspect
import json
import math
import textwrap
from pathlib import Path
from typing import Any, Callable

import numpy as np
import pytest

import shading

FILE = next(path for path in (folder / "interface.json" for folder in Path(__file__).parents) if path.is_file())


def numbers(value: Any) -> Any:
    """JSON has neither NaN nor infinity."""
    if isinstance(value, list):
        return [numbers(inner) for inner in value]
    if isinstance(value, dict):
        return {name: numbers(inner) for name, inner in value.items()}
    return float(value) if value in ("nan", "inf") else value


INTERFACE: dict[str, Any] = numbers(json.loads(FILE.read_text(encoding="utf-8")))


def made(light: dict[str, dict[str, Any]]) -> shading.Light:
    ((kind, arguments),) = light.items()
    function: Callable[..., shading.Light] = getattr(shading, kind)
    return function(**arguments)


def called(call: dict[str, Any]) -> Any:
    for name in ("height_field", "implicit", "mesh_normals"):
        if name in call:
            return getattr(shading, name)(**call[name])
    scene = {**INTERFACE["base"], **call.get("change", {})}
    scene.pop(call.get("leave_out"), None)
    lights = [made(light) for light in scene.pop("lights")]
    if "light" in call:
        lights = [made(call["light"])]
    return shading.shade(**scene, lights=lights)


@pytest.mark.parametrize("call", INTERFACE["calls"] + INTERFACE["normals"], ids=lambda call: str(call["what"]))
def test_each_call_ends_as_in_the_other_languages(call: dict[str, Any]) -> None:
    if "value" in call:
        value = called(call)
        np.testing.assert_allclose(value, np.broadcast_to(call["value"], value.shape), rtol=1e-15, atol=1e-16)
        return
    with pytest.raises((TypeError, ValueError)) as error:
        called(call)
    assert call.get("python", call["error"]) in str(error.value)


def test_arguments_and_defaults_are_those_of_the_other_languages() -> None:
    assert shading.__all__ == INTERFACE["functions"]
    functions = {name: INTERFACE[name] for name in ("shade", "height_field", "implicit", "mesh_normals")}
    for name, arguments in {**functions, **INTERFACE["lights"]}.items():
        parameters = inspect.signature(getattr(shading, name)).parameters
        defaults: dict[str, Any] = {
            key: None if parameter.default is inspect.Parameter.empty else parameter.default for key, parameter in parameters.items()
        }
        expected = {
            key: None if value == "none" else tuple(value) if isinstance(value, list) else value for key, value in arguments.items()
        }
        assert defaults == expected, name
        required = {key for key, parameter in parameters.items() if parameter.default is inspect.Parameter.empty}
        assert required == {key for key, value in arguments.items() if value is None}, name


POINTS = np.zeros((4, 5, 3))
BYTES = np.full((4, 5, 3), 128, np.uint8)
SUN = shading.directional((0, 0, 1))


def shaded(**changes: Any) -> Any:
    scene: dict[str, Any] = dict(points=POINTS, normals=POINTS + (0, 0, 1), eye=(0, 0, 5), lights=SUN, k_d=0.5)
    return shading.shade(**{**scene, **changes})


def one_nan() -> Any:
    points = POINTS.copy()
    points[1, 2, 0] = np.nan
    return points


WRONG: dict[str, Callable[[], Any]] = {
    "k_d: expected linear numbers, usually from 0 to 1, got uint8; from_srgb8 decodes": lambda: shaded(k_d=BYTES),
    "k_d: expected linear numbers, usually from 0 to 1, got uint16": lambda: shaded(k_d=BYTES.astype(np.uint16)),
    "points: expected an array without a mask, got a masked one": lambda: shaded(points=np.ma.array(POINTS, mask=POINTS == 0)),
    "k_d: expected an array without a mask": lambda: shaded(k_d=np.ma.array([0.5, 0.5, 0.5], mask=[False, True, False])),
    "points: expected finite numbers, got (NaN, 0, 0) at [1, 2]": lambda: shaded(points=one_nan()),
    "visible: expected fractions from 0 to 1, got -1 at [0, 1, 2]": lambda: shaded(
        visible=np.where(np.isnan(one_nan()[..., 0]), -1, 1)
    ),
    "z: expected finite heights (fill in what is missing first), got NaN at [1, 2]": lambda: shading.height_field(one_nan()[..., 0]),
    "got an unexpected keyword argument 'kd'": lambda: shaded(kd=1),
    "position: expected three finite numbers, got 'a,b'": lambda: shading.point("a,b"),  # type: ignore[arg-type]
    "position: expected three finite numbers, got None": lambda: shading.point(None),  # type: ignore[arg-type]
    "kind: expected a light made by directional, point or spot, got 'foo'": lambda: shading.Light("foo"),
    "intensity: expected finite numbers of 0 or more, got (-1, 0, 0)": lambda: dataclasses.replace(SUN, intensity=(-1, 0, 0)),
    "lights: expected a light, made by directional, point or spot, or a sequence of lights, got None": lambda: shaded(lights=None),
    "lights[0]: expected a light, made by directional, point or spot, got (0, 0, 1)": lambda: shaded(lights=[(0, 0, 1)]),
    "k_d: expected a shape that broadcasts to (4, 5, 3), got (4, 5); a gray texture is k_d[..., None]": lambda: shaded(
        k_d=np.ones((4, 5))
    ),
    "normals: expected a shape that broadcasts to (4, 5, 3), got (3, 5, 3)": lambda: shaded(normals=np.ones((3, 5, 3))),
    "points: expected numbers in a regular shape, got [[0, 0, 0], [0, 0]]": lambda: shaded(points=[[0, 0, 0], [0, 0]]),
    "points: expected numbers, got": lambda: shaded(points=POINTS.astype(complex)),
    "lights[0].intensity: expected finite numbers of 0 or more, got (inf, inf, inf)": lambda: shaded(
        points=POINTS.astype(np.float32), normals=POINTS.astype(np.float32) + np.float32(1), lights=shading.point((0, 0, 1), 1e39)
    ),
    "colors: expected linear light, where 1 is white, got whole numbers up to 128": lambda: shading.to_srgb8(BYTES),
    "texture: expected the shape (..., 3), got (2, 2, 4); leave alpha out": lambda: shading.from_srgb8(np.zeros((2, 2, 4), np.uint8)),
    "faces: expected whole numbers, got an array of float64": lambda: shading.mesh_normals(np.zeros((3, 3)), [(0.0, 1, 2)]),
    "faces: expected indices below 3, the number of vertices, got (0, 1, -1) at [0]": lambda: shading.mesh_normals(
        np.zeros((3, 3)), [(0, 1, -1)]
    ),
    "z: expected the shape (rows, columns), got (3,)": lambda: shading.height_field([1, 2, 3]),
    "values: expected the shape (layers, rows, columns), got (2, 2)": lambda: shading.implicit(np.eye(2), (0, 0, 0)),
    "values: expected finite numbers (fill in what is missing first), got NaN at [1, 2, 0]": lambda: shading.implicit(
        one_nan(), (0, 0, 0)
    ),
    "points: expected positions in the grid, from (0, 0, 0) to (2, 4, 3), got (0, 0, 3.5) at [1, 0]": lambda: shading.implicit(
        POINTS, np.array([[(0, 0, 0)], [(0, 0, 3.5)]])
    ),
    "range: expected a number, got 'far'": lambda: shading.point((0, 0, 1), range="far"),  # type: ignore[arg-type]
    "range: expected a number, got [3]": lambda: shading.point((0, 0, 1), range=[3]),  # type: ignore[arg-type]
    "k_d: expected linear numbers, usually from 0 to 1, got whole numbers up to 128; from_srgb8": lambda: shaded(
        k_d=BYTES.astype(np.int64)
    ),
    "k_s: expected linear numbers, usually from 0 to 1, got whole numbers up to 128; from_srgb8": lambda: shaded(
        k_s=BYTES.astype(np.float32)
    ),
    "intensity: expected linear light, got array([255, 240, 200], dtype=uint8); from_srgb8 decodes": lambda: shading.directional(
        (0, 0, 1), np.array((255, 240, 200), np.uint8)
    ),
    "normals: expected numbers, got ndarray of object in the shape (4, 5, 3)": lambda: shaded(normals=POINTS.astype(object)),
    "k_a: expected numbers, got array([['a', 'b', 'c']], dtype='<U1')": lambda: shaded(k_a=np.array([["a", "b", "c"]])),
    "eye: expected numbers, got [None, 0, 5]": lambda: shaded(eye=[None, 0, 5]),
    "eye: expected numbers, got array(['NaT', 'NaT', 'NaT'], dtype='datetime64": lambda: shaded(eye=np.full(3, "NaT", "M8[s]")),
    "points: expected numbers, got <generator object": lambda: shaded(points=(point for point in POINTS)),
    "points: expected numbers, got {'x': 1}": lambda: shaded(points={"x": 1}),
    "points: expected numbers, got b'abc'": lambda: shaded(points=b"abc"),
    "points: expected the shape (..., 3), got ()": lambda: shaded(points=np.float32(1)),
    "points: expected the shape (..., 3), got (3, 4, 5); np.moveaxis(points, 0, -1) puts the 3 last": lambda: shaded(
        points=np.moveaxis(POINTS, -1, 0)
    ),
    "points: expected the shape (..., 3), got (0,)": lambda: shaded(points=[]),
    "normals: expected a shape that broadcasts to (4, 5, 3), got (0, 3)": lambda: shaded(normals=np.zeros((0, 3))),
    "k_d: expected a shape that broadcasts to (4, 5, 3), got (4, 5, 4)": lambda: shaded(k_d=np.ones((4, 5, 4))),
    "m: expected the shape (4, 5), got (4, 5, 1); m[..., 0] leaves the last axis out": lambda: shaded(m=np.ones((4, 5, 1))),
    "m: expected the shape (4, 5), got (4, 5, 3); m[..., 0] leaves the last axis out": lambda: shaded(m=np.ones((4, 5, 3))),
    'model: expected "lambert", "phong" or "blinn-phong", got array([': lambda: shaded(model=np.array(["phong", "lambert"])),
    "parts: expected True or False, got 'yes'": lambda: shaded(parts="yes"),
    "parts: expected True or False, got None": lambda: shaded(parts=None),
    "lights[0]: expected a light, made by directional, point or spot, got [directional(": lambda: shaded(lights=[[SUN]]),
    "lights[0]: expected a light, made by directional, point or spot, got 'sun'": lambda: shaded(lights={"sun": SUN}),
    "sequence of lights, got <function directional": lambda: shaded(lights=shading.directional),
    "toward: expected three finite numbers, got (0, 0, 1j)": lambda: shading.directional((0, 0, 1j)),  # type: ignore[arg-type]
    "toward: expected three finite numbers, got (1000000": lambda: shading.directional((10**400, 0, 0)),
    "dx: expected a number, got 1000000": lambda: shading.height_field(POINTS[..., 0], dx=10**400),
    "dx: expected a number, got array([1, 2])": lambda: shading.height_field(
        POINTS[..., 0], dx=np.array([1, 2])  # type: ignore[arg-type]
    ),
    "dy: expected a number, got ": lambda: shading.height_field(POINTS[..., 0], dy=np.complex128(1)),  # type: ignore[arg-type]
    "dx: expected a finite number that is not 0, got inf": lambda: shading.height_field(np.zeros((3, 3), np.float32), dx=1e300),
    "crease: expected a number, got '30'": lambda: shading.mesh_normals(POINTS[0], [(0, 1, 2)], "30"),  # type: ignore[arg-type]
    "values: expected at least one layer, row and column, got none": lambda: shading.implicit(np.zeros((0, 2, 2)), (0, 0, 0)),
    "texture: expected numbers, got 'brick.png'": lambda: shading.from_srgb8("brick.png"),
}


@pytest.mark.parametrize("message", WRONG)
def test_what_only_python_can_write_ends_in_a_sentence(message: str) -> None:
    with pytest.raises((TypeError, ValueError)) as error:
        WRONG[message]()
    assert message in str(error.value)


def test_a_result_that_is_too_large_is_an_error_of_memory() -> None:
    huge = np.broadcast_to(0.0, (1 << 50, 3))
    with pytest.raises(MemoryError, match="no memory for a result of 3377699720527872 numbers"):
        shaded(points=huge, normals=(0, 0, 1))
    with pytest.raises(MemoryError):
        shading.height_field(np.broadcast_to(np.float32(0), (1 << 30, 1 << 20)))


def test_arrays_of_any_kind_have_the_right_value() -> None:
    rng = np.random.default_rng(5)
    points, normals = rng.integers(-9, 9, (4, 6, 3)).astype(float), rng.integers(-9, 9, (4, 6, 3)).astype(float)
    expected = shaded(points=points, normals=normals, eye=(0, 0, 20))
    assert expected.any()
    for kind in (np.float16, np.longdouble, np.int8, np.int64, ">f8", "<i2"):
        np.testing.assert_array_equal(shaded(points=points.astype(kind), normals=normals.astype(kind), eye=(0, 0, 20)), expected)
    frozen, strided = points.copy(), np.zeros((8, 12, 6))
    frozen.flags.writeable = False
    strided[::-2, ::2, ::-2] = normals
    for order in (np.asfortranarray, np.ascontiguousarray):
        np.testing.assert_array_equal(shaded(points=order(frozen), normals=strided[::-2, ::2, ::-2], eye=(0, 0, 20)), expected)
    mirrored = shaded(points=points[::-1, ::-1], normals=normals[::-1, ::-1], eye=(0, 0, 20))
    np.testing.assert_array_equal(mirrored, expected[::-1, ::-1])
    assert (shaded(k_d=True) == 1).all() and (shaded(k_d=2) == 2).all() and shaded(m=np.inf).any()
    assert shaded(lights=np.array([SUN])).shape == shaded(lights={SUN}).shape == (4, 5, 3)
    two: Any = np.array(2.0)
    np.testing.assert_array_equal(shading.height_field(np.eye(3), dx=two), shading.height_field(np.eye(3), dx=2))


def test_one_light_needs_no_list() -> None:
    np.testing.assert_array_equal(shaded(lights=SUN), shaded(lights=[SUN]))
    np.testing.assert_array_equal(shaded(lights=iter([SUN])), shaded(lights=(SUN,)))


def test_alpha_is_opaque() -> None:
    colors = np.random.default_rng(1).random((4, 5, 3))
    image = shading.to_srgba8(colors)
    assert image.shape == (4, 5, 4) and (image[..., 3] == 255).all()
    np.testing.assert_array_equal(image[..., :3], shading.to_srgb8(colors))


def test_reliefs_have_the_normals_of_their_formula() -> None:
    y, x = np.mgrid[0:6, 0:7] * 0.5
    z = 0.25 * x**2 - 0.5 * x * y + y**2  # a parabola along each axis, of which the slopes are exact
    expected = np.stack([0.5 * y - 0.5 * x, 0.5 * x - 2 * y, np.ones_like(z)], -1)
    expected /= np.linalg.norm(expected, axis=-1, keepdims=True)
    np.testing.assert_allclose(shading.height_field(z, 0.5, 0.5), expected, atol=1e-14)
    turned = shading.height_field(z[::-1], 0.5, -0.5)[::-1]  # as the rows of an image
    np.testing.assert_allclose(turned, expected, atol=1e-14)
    assert shading.height_field(z.astype(np.float32)).dtype == np.float32
    np.testing.assert_array_equal(shading.height_field([[3.0]]), [[(0, 0, 1)]])


def torus(x: Any, y: Any, z: Any) -> Any:
    return (np.hypot(x, y) - 2) ** 2 + z**2


def test_implicit_surfaces_have_the_normals_of_their_formula() -> None:
    n = np.random.default_rng(3).normal(size=(20, 10, 3))
    n /= np.linalg.norm(n, axis=-1, keepdims=True)
    center = np.array((2, 2.25, 2.5))
    # the gradient of a sphere is linear, so that it is exact in a grid of any cells, whichever way they are counted
    z, y, x = np.meshgrid(np.arange(11) * 0.5, np.arange(19) * -0.25, np.arange(5), indexing="ij")
    sphere = (x - center[0]) ** 2 + (y + center[1]) ** 2 + (z - center[2]) ** 2
    points = (1, -1, 1) * center + 1.5 * n
    for values in (sphere, np.asfortranarray(sphere)):
        np.testing.assert_allclose(shading.implicit(values, points, 1, -0.25, 0.5), n, atol=1e-13)
    np.testing.assert_allclose(shading.implicit(-sphere, points, 1, -0.25, 0.5), -n, atol=1e-13)
    single = shading.implicit(sphere.astype(np.float32), points.astype(np.float32), 1, -0.25, 0.5)
    assert single.dtype == np.float32
    np.testing.assert_allclose(single, n, atol=1e-5)
    np.testing.assert_array_equal(shading.implicit(sphere, (1, -1, 1) * center, 1, -0.25, 0.5), 0)

    # a torus, whose rings have the radii 2 and 1: the error is within the square of the cells, and falls with it
    around, across = np.random.default_rng(4).uniform(0, 2 * np.pi, (2, 500))
    n = np.stack([np.cos(around) * np.cos(across), np.sin(around) * np.cos(across), np.sin(across)], -1)
    points = n + 2 * np.stack([np.cos(around), np.sin(around), 0 * around], -1)
    worst = []
    for cell in (0.25, 0.125):
        z, y, x = (cell * np.indices([round(8 / cell) + 1] * 3) - 4).astype(np.float64)
        worst.append(np.abs(shading.implicit(torus(x, y, z), points + 4, cell, cell, cell) - n).max())
    assert worst[0] < 0.25**2 and worst[1] < 0.3 * worst[0]

    # the exact gradient may be given as it is
    gradient = 2 * n
    lamp = shading.point((3, -2, 5))
    given, unit = (shading.shade(points, normals, (0, -6, 6), lamp, k_d=0.5, k_s=0.5, m=20) for normals in (gradient, n))
    np.testing.assert_allclose(given, unit, atol=1e-14)


# the corners of a cube, and two triangles for each side
CUBE = np.array([(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], float)
SIDES = np.array([
    (0, 1, 3), (0, 3, 2), (4, 6, 7), (4, 7, 5), (0, 4, 5), (0, 5, 1), (2, 3, 7), (2, 7, 6), (0, 2, 6), (0, 6, 4), (1, 5, 7), (1, 7, 3),
])  # fmt: skip


def test_meshes_are_smooth_up_to_the_crease() -> None:
    smooth = shading.mesh_normals(CUBE, SIDES)
    np.testing.assert_allclose(smooth, CUBE / math.sqrt(3), atol=1e-15)  # by symmetry, whatever the diagonals
    e1, e2 = CUBE[SIDES[:, 1]] - CUBE[SIDES[:, 0]], CUBE[SIDES[:, 2]] - CUBE[SIDES[:, 0]]
    flat = np.cross(e1, e2) / 4  # a right angle of two edges of 2
    for crease in (0.0, math.radians(89)):
        corners = shading.mesh_normals(CUBE, SIDES, crease)
        np.testing.assert_allclose(corners, np.repeat(flat[:, None], 3, 1), atol=1e-15)
    for crease in (math.radians(90.001), math.pi):
        corners = shading.mesh_normals(CUBE, SIDES, crease)
        np.testing.assert_allclose(corners, smooth[SIDES], atol=1e-15)
    unused = shading.mesh_normals(np.vstack([CUBE, [(9, 9, 9)]]), SIDES)
    np.testing.assert_array_equal(unused[-1], 0)


def test_help_begins_with_what_one_calls() -> None:
    import pydoc

    text = pydoc.plain(pydoc.render_doc(shading))
    assert "MRO" not in text and "class Light" not in text
    assert text.index("shading.shade(points, normals") < 1500


def test_the_program_in_the_help_casts_the_shadows_of_a_wall() -> None:
    # a wall from row to row, 8 high, whose last column is 10. The sun rises by 1.2/3 of a cell from a column to the next.
    z = np.zeros((40, 60))
    z[:, 8:11] = 8
    picture = np.full((40, 60, 3), 128, np.uint8)
    names: dict[str, Any] = {"z": z, "picture": picture}
    text = inspect.getdoc(shading) or ""
    exec(textwrap.dedent(text[text.index("    import numpy") :]), names)  # noqa: S102
    end = 10 + 8 / 0.4
    columns = np.arange(60)
    dark = (columns > 11) & (columns < end - 1)
    assert not names["visible"][:, dark].any() and names["visible"][:, (columns < 8) | (columns > end + 1)].all()
    (albedo,) = set(shading.from_srgb8(picture).flat)
    np.testing.assert_allclose(names["colors"][:, dark], np.broadcast_to(albedo * np.array((0.12, 0.15, 0.2)), (40, dark.sum(), 3)))
    facing = 1.2 / math.sqrt(9 + 4 + 1.44)
    lit = albedo * (np.array((0.12, 0.15, 0.2)) + facing * np.array((1, 0.9, 0.75)))
    np.testing.assert_allclose(names["colors"][:, -20:], np.broadcast_to(lit, (40, 20, 3)), rtol=1e-6)
