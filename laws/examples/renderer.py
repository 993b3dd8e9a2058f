"""A renderer to copy from: Lambert, Phong and Blinn-Phong, checked by

    shading-laws python3 renderer.py
"""

import json
import math
import sys


def add(a, b):
    return [x + y for x, y in zip(a, b)]


def sub(a, b):
    return [x - y for x, y in zip(a, b)]


def mul(a, b):
    return [x * y for x, y in zip(a, b)]


def scale(a, s):
    return [x * s for x in a]


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def unit(a):
    """a at length 1, or 0 if it has no direction, as L + V where L = -V."""
    length = math.sqrt(dot(a, a))
    return scale(a, 1 / length) if length > 0 else a


def arriving(light, p):
    """The direction L to a light, and the intensity that arrives at p."""
    if light["kind"] == "directional":
        return light["l"], light["intensity"]
    to_light = sub(light["position"], p)
    q = math.sqrt(dot(to_light, to_light))
    l = scale(to_light, 1 / q)
    # the cone includes its edge
    if light["kind"] == "spot" and -dot(l, light["axis"]) < math.cos(light["angle"]):
        return l, [0, 0, 0]
    a, b, c = light["attenuation"]
    return l, scale(light["intensity"], 1 / (a + b * q + c * q * q))


def highlight(model, n, l, v, m):
    if model == "phong":
        r = sub(scale(n, 2 * dot(n, l)), l)
        return max(0, dot(r, v)) ** m
    if model == "blinn_phong":
        h = unit(add(l, v))
        return max(0, dot(n, h)) ** m
    return 0  # Lambert


def shade(scene):
    n, v = unit(scene["n"]), unit(scene["v"])
    color = mul(scene["k_a"], scene["i_a"])
    for light in scene["lights"]:
        l, intensity = arriving(light, scene["p"])
        n_dot_l = dot(n, l)
        if n_dot_l > 0:  # otherwise the light is behind the surface
            diffuse = scale(scene["k_d"], n_dot_l)
            specular = scale(scene["k_s"], highlight(scene["model"], n, l, v, scene["m"]))
            color = add(color, mul(intensity, add(diffuse, specular)))
    return color


def main():
    sys.stdin.readline()  # the version of the format
    print(json.dumps({"name": "renderer.py", "roundoff": 2**-53}), flush=True)
    for line in sys.stdin:
        if line.strip():
            print(json.dumps(shade(json.loads(line))))
        else:  # the end of a batch
            sys.stdout.flush()


if __name__ == "__main__":
    main()
