"""The module against the formulas, written in NumPy by hand, in doubles."""

from __future__ import annotations

import copy
import doctest
import importlib.resources
import inspect
import multiprocessing
import pickle
import threading
import time
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays, mutually_broadcastable_shapes

import shading
from shading import _images, _lights, _normals, _shade

Array = npt.NDArray[Any]
MODELS = ("lambert", "phong", "blinn-phong")


def unit(v: Array) -> Array:
    result: Array = v / np.linalg.norm(v, axis=-1, keepdims=True)
    return result


def dot(a: Array, b: Array) -> Array:
    return np.asarray((a * b).sum(-1, keepdims=True))


def arriving(light: shading.Light, points: Array) -> tuple[Array, Array]:
    """L, and I as it arrives."""
    intensity = np.asarray(light.intensity)
    if light.kind == "directional":
        return unit(np.asarray(light.toward)) + 0 * points, intensity + 0 * points
    to_light = np.asarray(light.position) - points
    q = np.linalg.norm(to_light, axis=-1, keepdims=True)
    a, b, c = light.attenuation
    window = np.maximum(0, 1 - (q / light.range) ** 4)
    factor = window ** (1 if light.gltf else 2) / (a + b * q + c * q**2)
    if light.kind == "spot":
        inner, outer = np.cos(light.inner), np.cos(light.outer)
        cosine = dot(-to_light / q, unit(np.asarray(light.axis)))
        factor = factor * np.clip((cosine - outer) / (inner - outer), 0, 1) ** 2
    return to_light / q, intensity * factor


def by_hand(
    points: Array, normals: Array, eye: Array, lights: list[shading.Light], *, k_a: Array, k_d: Array, k_s: Array, m: Array,
    ambient: Array, model: str, visible: Array | None = None,
) -> tuple[Array, Array, Array, Array]:
    """The three parts, and the N·L nearest to 0, where the highlight has a jump."""
    points, normals, eye, k_a, k_d, k_s, ambient, power = (
        x.astype(np.float64) for x in np.broadcast_arrays(points, normals, eye, k_a, k_d, k_s, ambient, m[..., None])
    )
    n, v = unit(normals), unit(eye - points)
    diffuse, specular, nearest = 0 * points, 0 * points, np.asarray(1.0)
    for k, light in enumerate(lights):
        l, intensity = arriving(light, points)
        n_dot_l = dot(n, l)
        nearest = np.minimum(nearest, np.abs(n_dot_l).min(initial=1.0))
        if visible is not None:
            intensity = intensity * np.broadcast_to(visible, (len(lights), *points.shape[:-1]))[k][..., None]
        intensity = np.where(n_dot_l > 0, intensity, 0)
        diffuse = diffuse + intensity * n_dot_l
        if model != "lambert":
            r_or_h = dot(2 * n_dot_l * n - l, v) if model == "phong" else dot(n, unit(l + v))
            specular = specular + intensity * np.where(r_or_h > 0, np.abs(r_or_h) ** power, 0)
    return k_a * ambient, k_d * diffuse, k_s * specular, nearest


def floats(low: float, high: float) -> st.SearchStrategy[float]:
    return st.floats(low, high, width=32, allow_subnormal=False)


def vectors(low: float, high: float) -> st.SearchStrategy[tuple[float, float, float]]:
    return st.tuples(*[floats(low, high)] * 3)


@st.composite
def scene_lights(draw: st.DrawFn) -> list[shading.Light]:
    """Up to three lights, above and away from the points, which are within [−1, 1]³."""
    lights: list[shading.Light] = []
    for kind in draw(st.lists(st.sampled_from(["directional", "point", "spot"]), max_size=3)):
        x, y, z = draw(vectors(-1, 1))
        intensity = draw(vectors(0, 4))
        place = (3 * x, 3 * y, 3 + z)
        falloff: dict[str, Any] = dict(
            intensity=intensity,
            attenuation=draw(st.tuples(floats(0.5, 2), floats(0, 1), floats(0, 1))),
            range=draw(st.one_of(st.just(np.inf), floats(4, 9))),
            gltf=draw(st.booleans()),
        )
        if kind == "directional":
            lights.append(shading.directional((x, y, 1.5 + z), intensity))
        elif kind == "point":
            lights.append(shading.point(place, **falloff))
        else:
            inner = draw(floats(0.125, 1))
            lights.append(shading.spot(place, (-x, -y, -2), inner=inner, outer=inner + 0.25, **falloff))
    return lights


@st.composite
def scenes(draw: st.DrawFn, dtype: Any) -> dict[str, Any]:
    """A scene whose arguments have different shapes that broadcast to each other."""
    shapes = draw(mutually_broadcastable_shapes(num_shapes=8, max_dims=3, max_side=4)).input_shapes
    shape = iter(shapes)

    def array(low: float, high: float, width: tuple[int, ...] = (3,)) -> Array:
        elements = st.floats(low, high, width=32, allow_subnormal=False)
        return draw(arrays(dtype, next(shape) + width, elements=elements))

    normals = array(-1, 1)
    assume((np.linalg.norm(normals, axis=-1) > 0.25).all())
    return dict(
        points=array(-1, 1), normals=normals, eye=array(-1, 1) + np.asarray((0, 0, 5), dtype), lights=draw(scene_lights()),
        k_a=array(0, 1), k_d=array(0, 1, (draw(st.sampled_from([1, 3])),)), k_s=array(0, 1), ambient=array(0, 1),
        m=np.asarray(draw(st.sampled_from([0, 1, 2.5, 32, 50.5])), dtype), model=draw(st.sampled_from(MODELS)),
    )


def is_right(scene: dict[str, Any], roundoff: float) -> None:
    *expected, nearest = by_hand(**scene)
    assume(nearest > 64 * roundoff)  # the jump of the highlight
    computed = shading.shade(**scene, parts=True)
    # What the light can be at most, times the roundings: about twenty for L, V and H, as many for the falloff, and up to
    # 25 times as many for a cone, whose edge is narrow, 1/0.04; the power multiplies those of its cosine by m.
    at_most = 1 + sum(max(light.intensity) / light.attenuation[0] for light in scene["lights"])
    tolerance = (500 + 20 * float(scene["m"])) * roundoff * at_most
    for name, part, right in zip(computed._fields, computed, expected):
        assert part.shape == right.shape, name
        np.testing.assert_allclose(part, right, rtol=0, atol=tolerance, err_msg=name)
    total = shading.shade(**scene)
    np.testing.assert_array_equal(total, sum(computed[1:], computed[0]))
    assert total.dtype == scene["points"].dtype


@given(scenes(np.float64))
@settings(deadline=None, max_examples=200)
def test_doubles_are_the_formula(scene: dict[str, Any]) -> None:
    is_right(scene, 2.0**-53)


@given(scenes(np.float32))
@settings(deadline=None, max_examples=200)
def test_singles_are_the_formula(scene: dict[str, Any]) -> None:
    is_right(scene, 2.0**-24)


@given(scenes(np.float32), st.data())
@settings(deadline=None, max_examples=50)
def test_broadcasting_changes_no_bit(scene: dict[str, Any], data: st.DataObject) -> None:
    expected = shading.shade(**scene)
    written_out = dict(scene)
    for name in ("points", "normals", "eye", "k_a", "k_d", "k_s", "ambient"):
        written_out[name] = np.broadcast_to(scene[name], expected.shape).copy()
    written_out["m"] = np.broadcast_to(scene["m"], expected.shape[:-1]).copy()
    np.testing.assert_array_equal(shading.shade(**written_out), expected)
    order = np.asfortranarray if data.draw(st.booleans()) else np.ascontiguousarray
    written_out = {name: order(x) if isinstance(x, np.ndarray) else x for name, x in written_out.items()}
    np.testing.assert_array_equal(shading.shade(**written_out), expected)


GRID = (5, 7)
LAMPS = [shading.point((2, 1, 3), (1, 0.5, 0.25)), shading.directional((0, 0, 1), 0.5), shading.point((-2, 1, 3), 0.75)]


def plane(dtype: Any = np.float32) -> tuple[Array, Array]:
    y, x = np.indices(GRID, dtype=dtype)
    points = np.stack([x / 7, y / 5, 0 * x], axis=-1).astype(dtype)
    return points, np.broadcast_to(np.asarray((0, 0, 1), dtype), points.shape)


def test_a_texture_is_a_reflectance_for_each_point() -> None:
    points, normals = plane()
    texture = np.random.default_rng(1).random((*GRID, 3), dtype=np.float32)
    white = shading.shade(points, normals, (0, 0, 5), LAMPS, k_d=1)
    np.testing.assert_allclose(shading.shade(points, normals, (0, 0, 5), LAMPS, k_d=texture), white * texture, rtol=1e-6)
    gray = texture[..., :1]
    np.testing.assert_allclose(shading.shade(points, normals, (0, 0, 5), LAMPS, k_d=gray), white * gray, rtol=1e-6)


def test_a_mask_leaves_lights_out() -> None:
    points, normals = plane()
    mask = np.random.default_rng(2).random((3, *GRID)) > 0.5
    scene: dict[str, Any] = dict(k_d=0.5, k_s=0.5, m=8)
    masked = shading.shade(points, normals, (0, 0, 5), LAMPS, visible=mask, **scene)
    for i in np.ndindex(*GRID):
        seen = [lamp for lamp, is_seen in zip(LAMPS, mask[(slice(None), *i)]) if is_seen]
        np.testing.assert_array_equal(masked[i], shading.shade(points[i], normals[i], np.array((0, 0, 5), np.float32), seen, **scene))
    each = [shading.shade(points, normals, (0, 0, 5), LAMPS, visible=(np.arange(3) == k)[:, None, None], **scene) for k in range(3)]
    half = shading.shade(points, normals, (0, 0, 5), LAMPS, visible=np.array((1, 0.5, 0), np.float32)[:, None, None], **scene)
    np.testing.assert_allclose(half, each[0] + 0.5 * each[1], rtol=1e-6)
    dark = shading.shade(points, normals, (0, 0, 5), LAMPS, visible=False, k_a=0.25, **scene)
    np.testing.assert_array_equal(dark, np.full((*GRID, 3), 0.25, np.float32))


def test_the_dtype_is_that_of_points_and_normals() -> None:
    for points_type, normals_type, expected in [(np.float32, np.float32, np.float32), (np.float64, np.float32, np.float64)]:
        points, normals = plane(points_type)[0], plane(normals_type)[1]
        assert shading.shade(points, normals, (0, 0, 5), LAMPS, k_d=np.ones(3)).dtype == expected
    assert shading.shade([0, 0, 0], [0, 0, 1], [0, 0, 5], LAMPS, k_d=1).dtype == np.float64
    assert shading.shade([0, 0, 0], [0, 0, 1], [0, 0, 5], LAMPS, k_d=1).shape == (3,)


def test_what_has_no_answer_is_black() -> None:
    points, normals = plane()
    no_normals, at_eye = np.zeros_like(points), points[2, 3]
    assert not shading.shade(points, no_normals, (0, 0, 5), LAMPS, k_d=1, k_a=1).any()
    result = shading.shade(points, normals, at_eye, LAMPS, k_d=1, k_a=1)
    assert (result == 0).all(-1).sum() == 1 and not result[2, 3].any()
    assert shading.shade(points[:0], normals[:0], (0, 0, 5), LAMPS, k_d=1).shape == (0, 7, 3)
    no_lights = shading.shade(points, normals, (0, 0, 5), [], k_a=(0.5, 0.25, 0), ambient=0.5)
    np.testing.assert_array_equal(no_lights[0, 0], np.array((0.25, 0.125, 0), np.float32))


def test_inputs_stay_as_they_are() -> None:
    points, normals = plane()
    before = points.copy(), normals.copy()
    shading.shade(points, normals, (0, 0, 5), LAMPS, k_d=1)
    np.testing.assert_array_equal(points, before[0])
    np.testing.assert_array_equal(normals, before[1])
    normals.flags.writeable = False
    shading.shade(points, normals, (0, 0, 5), LAMPS, k_d=1)


CALLS: dict[str, dict[str, Any]] = {
    "k_d: expected a shape that broadcasts to (5, 7, 3), got (5, 7); a gray texture is k_d[..., None]": dict(k_d=np.ones(GRID)),
    "m: expected a shape that broadcasts to (5, 7), got (3,)": dict(m=np.ones(3)),
    "eye: expected the shape (..., 3), got (2,)": dict(eye=(0, 5)),
    "normals: expected a shape that broadcasts to (5, 7, 3), got (4, 7, 3)": dict(normals=np.ones((4, 7, 3))),
    "visible: expected a shape that broadcasts to (3, 5, 7), got (2, 5, 7)": dict(visible=np.ones((2, *GRID), bool)),
    "visible: expected fractions from 0 to 1, got 2": dict(visible=2.0),
    'model: expected "lambert", "phong" or "blinn-phong", got \'blin\'': dict(model="blin"),
    "k_s: expected finite numbers of 0 or more, got (0, -1, 0)": dict(k_s=(0, -1, 0)),
    "k_a: expected finite numbers of 0 or more, got (NaN, NaN, NaN)": dict(k_a=np.nan),
    "m: expected numbers of 0 or more, got -1": dict(m=-1),
    "lights[1]: expected a light, made by directional, point or spot, got 3": dict(lights=[LAMPS[0], 3]),
    "k_d: expected numbers, got 'red'": dict(k_d="red"),
}


@pytest.mark.parametrize("message", CALLS)
def test_errors_name_the_argument_and_what_was_expected(message: str) -> None:
    points, normals = plane()
    call: dict[str, Any] = {"points": points, "normals": normals, "eye": (0, 0, 5), "lights": LAMPS, "k_d": 1, **CALLS[message]}
    with pytest.raises((TypeError, ValueError)) as error:
        shading.shade(**call)
    assert str(error.value) == message


LIGHTS = {
    "intensity: expected finite numbers of 0 or more, got (-1, 0, 0)": lambda: shading.point((0, 0, 0), (-1, 0, 0)),
    "toward: expected three finite numbers, not all 0, got (0, 0, 0)": lambda: shading.directional((0, 0, 0)),
    "position: expected three finite numbers, got (0, 0)": lambda: shading.point((0, 0)),
    "attenuation: expected three finite numbers a, b, c of 0 or more, and not all 0, got (0, 0, 0)": lambda: shading.point(
        (0, 0, 0), attenuation=(0, 0, 0)
    ),
    "range: expected a number above 0, or infinity, got 0": lambda: shading.point((0, 0, 0), range=0),
    "inner, outer: expected 0 <= inner <= outer <= pi, in radians (a degree is pi/180), got 1 and 0.5": lambda: shading.spot(
        (0, 0, 0), (0, 0, 1), inner=1, outer=0.5
    ),
}


@pytest.mark.parametrize("message", LIGHTS)
def test_bad_lights_are_refused(message: str) -> None:
    with pytest.raises((TypeError, ValueError)) as error:
        LIGHTS[message]()
    assert str(error.value) == message


@given(scene_lights())
def test_lights_print_as_what_makes_them(lights: list[shading.Light]) -> None:
    names = {name: getattr(shading, name) for name in ("directional", "point", "spot")}
    for light in lights:
        assert eval(repr(light), names, {"inf": np.inf}) == light  # noqa: S307
        assert pickle.loads(pickle.dumps(light)) == copy.copy(light) == light


@given(arrays(np.float32, st.tuples(st.integers(0, 9), st.just(3)), elements=st.floats(width=32)))
def test_bytes_are_the_nearest(colors: Array) -> None:
    computed = shading.to_srgb8(colors)
    assert computed.dtype == np.uint8 and computed.shape == colors.shape
    linear = np.clip(np.nan_to_num(colors.astype(np.float64), nan=0, posinf=1, neginf=0), 0, 1)
    exact = 255 * np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)
    # the standard's constants meet at 0.0031308 but for 3e-8 of the range
    assert (np.abs(computed - exact) <= 0.5 + 1e-5).all()


def test_bytes_come_back() -> None:
    every = np.arange(256, dtype=np.uint8).repeat(3).reshape(-1, 3)
    np.testing.assert_array_equal(shading.to_srgb8(shading.from_srgb8(every)), every)
    with pytest.raises(TypeError, match="texture: expected an array of uint8, got one of float64"):
        shading.from_srgb8(np.ones(3))


def test_other_threads_run_meanwhile() -> None:
    points = np.zeros((1_000_000, 3), np.float32)
    normals = points + np.array((0, 0, 1), np.float32)
    worker = threading.Thread(target=shading.shade, args=(points, normals, (0, 0, 5), LAMPS * 8), kwargs={"k_d": 1})
    ticks = [time.perf_counter()]
    worker.start()
    while worker.is_alive():
        time.sleep(0.0005)
        ticks.append(time.perf_counter())
    # if the kernel held the lock, no tick would fall into most of that time
    longest, took = np.diff(ticks).max(), ticks[-1] - ticks[0]
    assert longest < took / 2, f"no other thread ran for {longest} of {took} s"


def test_a_forked_process_does_not_wait_for_threads_that_it_lacks() -> None:
    points = np.zeros((50_000, 3), np.float32)
    normals = points + np.array((0, 0, 1), np.float32)

    def shade() -> None:
        assert (shading.shade(points, normals, (0, 0, 5), LAMPS, k_d=1) > 0).all()

    shade()  # starts the threads
    forked = multiprocessing.get_context("fork").Process(target=shade)
    forked.start()
    forked.join(60)
    assert forked.exitcode == 0
    forked.close()


def test_help_shows_defaults_and_types() -> None:
    parameters = inspect.signature(shading.shade).parameters
    assert parameters["model"].default == "blinn-phong" and parameters["ambient"].default == 1
    assert "Ellipsis" not in inspect.getdoc(shading.shade) + str(inspect.signature(shading.point))  # type: ignore[operator]
    assert importlib.resources.files("shading").joinpath("py.typed").is_file()
    assert shading.__version__.count(".") == 2
    for name in shading.__all__:
        assert getattr(shading, name).__doc__
    assert all(doctest.testmod(module, extraglobs=vars(shading)).failed == 0 for module in (_images, _lights, _normals, _shade))
