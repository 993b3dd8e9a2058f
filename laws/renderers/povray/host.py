"""Shades scenes with POV-Ray, in the format of ../../docs/format.md. A batch is one picture of 16 bits, a pixel for each scene.

The camera is orthographic and looks along -z: each scene is turned so that V is +z, and moved so that p is under the middle
of its pixel. A smooth triangle lies there, all of its normals N, in a light group with the lights of the scene. Light sources
cannot be shadowless, because POV-Ray gives those no highlight; the triangle has no shadow instead.
"""
import json
import math
import subprocess
import sys
import tempfile
from array import array
from pathlib import Path

WIDTH = 64
PROFILE = {
    "name": "POV-Ray",
    "clamps": [0, 1],
    "bits": 16,
    "departs": ["NormalTowardEye", "AmbientTimesDiffuse"],
    "unattenuated": True,
    "gray_highlight": True,
}


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[i - 2] * b[i - 1] - a[i - 1] * b[i - 2] for i in range(3)]


def unit(a):
    length = math.sqrt(dot(a, a))
    return [x / length for x in a]


def vector(a):
    return "<%r,%r,%r>" % tuple(a)


def light(light, p, turned, place):
    """A light, where p is at `place`."""
    def at(position):
        return vector(a + b for a, b in zip(place, turned(position)))

    if light["kind"] == "directional":
        return f"light_source{{{at(light['l'])} rgb{vector(light['intensity'])} parallel point_at{vector(place)}}}"
    position = [a - b for a, b in zip(light["position"], p)]
    cone = ""
    if light["kind"] == "spot":
        aim = [a + b for a, b in zip(position, light["axis"])]
        degrees = math.degrees(light["angle"])
        cone = f" spotlight point_at{at(aim)} radius {degrees!r} falloff {degrees!r} tightness 0"
    return f"light_source{{{at(position)} rgb{vector(light['intensity'])}{cone}}}"


def description(scene, place):
    """A scene with the point at `place`."""
    z = unit(scene["v"])
    least = min(range(3), key=lambda i: abs(z[i]))
    x = unit(cross([float(i == least) for i in range(3)], z))
    y = cross(z, x)

    def turned(a):
        return [dot(x, a), dot(y, a), dot(z, a)]

    n = turned(unit(scene["n"]))
    # the plane is tilted halfway to N: a smooth triangle vanishes where N is perpendicular to its plane's normal
    tilt = [a if n[2] >= 0 else -a for a in n]
    tilt[2] += 1
    corners = [(a, b, -(a * tilt[0] + b * tilt[1]) / tilt[2]) for a, b in [(-0.4, -0.4), (0.4, -0.4), (0, 0.4)]]
    corners = ",".join(f"{vector(a + b for a, b in zip(place, corner))},{vector(n)}" for corner in corners)
    ambient = [a * b for a, b in zip(scene["k_a"], scene["i_a"])]
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


def shade(scenes, folder):
    height = -(-len(scenes) // WIDTH)
    places = [[i % WIDTH + 0.5, -(i // WIDTH) - 0.5, 0.0] for i in range(len(scenes))]
    text = (
        "#version 3.7; global_settings{assumed_gamma 1 ambient_light 1}\n"
        f"camera{{orthographic location<{WIDTH / 2},{-height / 2},9> direction<0,0,-1> right<{WIDTH},0,0> up<0,{height},0>}}\n"
    ) + "".join(map(description, scenes, places))
    (folder / "scenes.pov").write_text(text)
    command = ["povray", "+Iscenes.pov", "+Ocolors.ppm", "+FP16", f"+W{WIDTH}", f"+H{height}", "File_Gamma=1", "-A", "-D", "-GA", "+WT1"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    if done.returncode:
        sys.exit(done.stderr)
    levels = array("H", (folder / "colors.ppm").read_bytes()[-6 * WIDTH * height:])
    levels.byteswap()
    return [[level / 65535 for level in levels[3 * i:3 * i + 3]] for i in range(len(scenes))]


def main():
    assert sys.stdin.readline() == '{"shading-laws":1}\n', "this is not version 1 of the format"
    print(json.dumps(PROFILE), flush=True)
    scenes = []
    with tempfile.TemporaryDirectory() as folder:
        for line in sys.stdin:
            if line != "\n":
                scenes.append(json.loads(line))
                continue
            for color in shade(scenes, Path(folder)):
                print(color)
            sys.stdout.flush()
            scenes = []


main()
