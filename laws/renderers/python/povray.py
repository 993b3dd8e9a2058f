"""Shades scenes with POV-Ray, in the format of ../../docs/format.md. A batch is one picture, a pixel for each scene, which is
turned so that V is +z, and moved so that p is under the middle of its pixel. A smooth triangle with the normal N lies there.
"""
import math
import subprocess
import sys
import tempfile
from functools import partial
from pathlib import Path

import numpy

from batches import serve

WIDTH = 64
PROFILE = {
    "name": "POV-Ray",
    "clamps": [0, 1],
    "bits": 16,
    "departs": ["NormalTowardEye", "AmbientTimesDiffuse"],
    "unattenuated": True,
    "gray_highlight": True,
}


def unit(a):
    return numpy.divide(a, numpy.linalg.norm(a))


def vector(a):
    return "<%r,%r,%r>" % tuple(map(float, a))


def light(light, p, turned, place):
    """A light, where p is at `place`."""
    def at(position):
        return vector(place + turned(position))

    if light["kind"] == "directional":
        return f"light_source{{{at(light['l'])} rgb{vector(light['intensity'])} parallel point_at{vector(place)}}}"
    position = numpy.subtract(light["position"], p)
    cone = ""
    if light["kind"] == "spot":
        degrees = math.degrees(light["angle"])
        cone = f" spotlight point_at{at(position + light['axis'])} radius {degrees!r} falloff {degrees!r} tightness 0"
    return f"light_source{{{at(position)} rgb{vector(light['intensity'])}{cone}}}"


def description(scene, place):
    """A scene with the point at `place`."""
    z = unit(scene["v"])
    x = unit(numpy.cross(numpy.eye(3)[abs(z).argmin()], z))
    turned = numpy.array([x, numpy.cross(z, x), z]).dot
    n = turned(unit(scene["n"]))
    # the plane is tilted halfway to N: a smooth triangle vanishes where N is perpendicular to its plane's normal
    tilt = (n if n[2] >= 0 else -n) + [0, 0, 1]
    corners = [(a, b, -(a * tilt[0] + b * tilt[1]) / tilt[2]) for a, b in [(-0.4, -0.4), (0.4, -0.4), (0, 0.4)]]
    corners = ",".join(f"{vector(place + corner)},{vector(n)}" for corner in corners)
    ambient = numpy.multiply(scene["k_a"], scene["i_a"])
    highlight = {
        "lambert": "",
        "phong": f" phong {scene['k_s'][0]!r} phong_size {scene['m']!r}",
        "blinn_phong": f" specular {scene['k_s'][0]!r} roughness {1 / scene['m']!r}",
    }[scene["model"]]
    lights = "".join(light(each, scene["p"], turned, place) for each in scene["lights"])
    return (
        f"light_group{{{lights}smooth_triangle{{{corners} pigment{{rgb{vector(scene['k_d'])}}}"
        f"finish{{ambient rgb{vector(ambient)} diffuse 1{highlight}}}no_shadow}}global_lights off}}\n"
    )


def shade(folder, scenes):
    height = -(-len(scenes) // WIDTH)
    places = [numpy.array([i % WIDTH + 0.5, -(i // WIDTH) - 0.5, 0]) for i in range(len(scenes))]
    text = (
        "#version 3.7; global_settings{assumed_gamma 1 ambient_light 1}\n"
        f"camera{{orthographic location<{WIDTH / 2},{-height / 2},9> direction<0,0,-1> right<{WIDTH},0,0> up<0,{height},0>}}\n"
    ) + "".join(map(description, scenes, places))
    (folder / "scenes.pov").write_text(text)
    command = ["povray", "+Iscenes.pov", "+Ocolors.ppm", "+FP16", f"+W{WIDTH}", f"+H{height}", "File_Gamma=1", "-A", "-D", "-GA", "+WT1"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    if done.returncode:
        sys.exit(done.stderr)
    levels = numpy.frombuffer((folder / "colors.ppm").read_bytes()[-6 * WIDTH * height:], ">u2")
    return (levels.reshape(-1, 3)[:len(scenes)] / 65535).tolist()


with tempfile.TemporaryDirectory() as folder:
    serve(PROFILE, partial(shade, Path(folder)))
