"""Shades scenes with the fixed-function lighting of Mesa's OpenGL, in the format of ../../docs/format.md: a vertex for each
scene, whose position is relative to the eye. The projection sends it to the next pixel instead, so none is clipped.
"""
import math
import os

# llvmpipe compiles a program for each combination of kinds of lights: minutes for 1000 scenes of up to 8 lights
os.environ.setdefault("GALLIUM_DRIVER", "softpipe")
os.environ["PYOPENGL_PLATFORM"] = "osmesa"

import numpy
from OpenGL import GL, osmesa

from batches import serve

SIDE = 256
MOST_LIGHTS = 8
PROFILE = {"name": "Mesa's fixed-function OpenGL", "models": ["lambert", "blinn_phong"], "most_lights": MOST_LIGHTS}
frame = numpy.zeros((SIDE * SIDE, 4), numpy.float32)


def vector(triple):
    return numpy.array(triple, numpy.float32)


def set_material(scene):
    specular = [0, 0, 0] if scene["model"] == "lambert" else scene["k_s"]
    for term, color in [(GL.GL_AMBIENT, scene["k_a"]), (GL.GL_DIFFUSE, scene["k_d"]), (GL.GL_SPECULAR, specular)]:
        GL.glMaterialfv(GL.GL_FRONT_AND_BACK, term, [*color, 1])
    GL.glMaterialf(GL.GL_FRONT_AND_BACK, GL.GL_SHININESS, scene["m"])
    GL.glLightModelfv(GL.GL_LIGHT_MODEL_AMBIENT, [*scene["i_a"], 1])


def set_light(name, light, eye):
    for term in [GL.GL_DIFFUSE, GL.GL_SPECULAR]:
        GL.glLightfv(name, term, [*light["intensity"], 1])
    if light["kind"] == "directional":
        GL.glLightfv(name, GL.GL_POSITION, [*light["l"], 0])
    else:
        GL.glLightfv(name, GL.GL_POSITION, [*(vector(light["position"]) - eye), 1])
    of_distance = [GL.GL_CONSTANT_ATTENUATION, GL.GL_LINEAR_ATTENUATION, GL.GL_QUADRATIC_ATTENUATION]
    for term, coefficient in zip(of_distance, light.get("attenuation", [1, 0, 0])):
        GL.glLightf(name, term, coefficient)
    GL.glLightfv(name, GL.GL_SPOT_DIRECTION, light.get("axis", [0, 0, -1]))
    GL.glLightf(name, GL.GL_SPOT_CUTOFF, min(90, math.degrees(light["angle"])) if "angle" in light else 180)
    GL.glEnable(name)


def draw(scene, x, y):
    """Draws the pixel at x and y, from -1 to 1."""
    v = vector(scene["v"])
    eye = vector(scene["p"]) + v
    set_material(scene)
    for i in range(MOST_LIGHTS):
        GL.glDisable(GL.GL_LIGHT0 + i)
    for i, light in enumerate(scene["lights"]):
        set_light(GL.GL_LIGHT0 + i, light, eye)
    GL.glMatrixMode(GL.GL_PROJECTION)
    GL.glLoadMatrixf([0] * 12 + [x, y, 0, 1])
    GL.glBegin(GL.GL_POINTS)
    GL.glNormal3fv(scene["n"])
    GL.glVertex3fv(-v)
    GL.glEnd()


def shade(scenes):
    for i, scene in enumerate(scenes):
        draw(scene, (2 * (i % SIDE) + 1) / SIDE - 1, (2 * (i // SIDE) + 1) / SIDE - 1)
    GL.glFinish()
    return frame[:len(scenes), :3].tolist()


context = osmesa.OSMesaCreateContextExt(GL.GL_RGBA, 0, 0, 0, None)
assert osmesa.OSMesaMakeCurrent(context, frame, GL.GL_FLOAT, SIDE, SIDE), "no frame of floats"
for ability in [GL.GL_LIGHTING, GL.GL_NORMALIZE]:
    GL.glEnable(ability)
GL.glDisable(GL.GL_DITHER)
GL.glLightModeli(GL.GL_LIGHT_MODEL_LOCAL_VIEWER, GL.GL_TRUE)
for clamp in [GL.GL_CLAMP_VERTEX_COLOR, GL.GL_CLAMP_FRAGMENT_COLOR]:
    GL.glClampColor(clamp, GL.GL_FALSE)
serve(PROFILE, shade, SIDE * SIDE)
