"""Shades scenes with VTK, in the format of ../../docs/format.md. A window of floats holds SIDE * SIDE renderers, each a pixel
with a camera, lights and a vertex of its own.
"""
import math
import os

# a window in memory, and a driver that computes powers as C does
os.environ.setdefault("VTK_DEFAULT_OPENGL_WINDOW", "vtkOSOpenGLRenderWindow")
os.environ.setdefault("GALLIUM_DRIVER", "softpipe")

import numpy
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401, draws what the others describe
from vtkmodules.vtkCommonCore import VTK_FLOAT, vtkFloatArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow

from batches import serve

SIDE = 16
PROFILE = {"name": "VTK", "models": ["lambert", "phong"], "departs": ["UnlitWithoutLights"]}


class Pixel:
    """A renderer with one vertex."""

    def __init__(self, window, x, y):
        self.points = vtkPoints(number_of_points=1)
        self.normals = vtkFloatArray(number_of_components=3, number_of_tuples=1)
        vertices = vtkCellArray()
        vertices.InsertNextCell(1, [0])
        data = vtkPolyData(points=self.points, verts=vertices)
        data.GetPointData().SetNormals(self.normals)
        actor = vtkActor(mapper=vtkPolyDataMapper(input_data=data))
        self.surface = actor.property
        self.surface.SetInterpolationToPhong()
        self.surface.point_size = self.surface.ambient = self.surface.specular = 1
        corners = (x / SIDE, y / SIDE, (x + 1) / SIDE, (y + 1) / SIDE)
        self.renderer = vtkRenderer(viewport=corners, automatic_light_creation=False)
        self.renderer.AddActor(actor)
        window.AddRenderer(self.renderer)

    def show(self, scene):
        p, v = scene["p"], scene["v"]
        self.points.SetPoint(0, p)
        self.points.Modified()
        self.normals.SetTuple(0, scene["n"])
        self.normals.Modified()
        camera = self.renderer.active_camera
        camera.position = numpy.add(p, v)
        camera.focal_point = p
        least = min(range(3), key=lambda i: abs(v[i]))
        camera.view_up = [float(i == least) for i in range(3)]
        camera.clipping_range = (0.5 * math.hypot(*v), 2 * math.hypot(*v))
        self.surface.ambient_color = numpy.multiply(scene["k_a"], scene["i_a"])
        self.surface.diffuse_color = scene["k_d"]
        self.surface.specular_color = [0, 0, 0] if scene["model"] == "lambert" else scene["k_s"]
        self.surface.specular_power = scene["m"]
        self.renderer.RemoveAllLights()
        for light in scene["lights"]:
            self.renderer.AddLight(of(light))


def of(scene):
    """A light of VTK."""
    light = vtkLight(color=scene["intensity"], focal_point=(0, 0, 0))
    if scene["kind"] == "directional":
        light.position = scene["l"]
        return light
    light.PositionalOn()
    light.position = scene["position"]
    light.attenuation_values = scene["attenuation"]
    light.exponent = 0
    light.cone_angle = 90  # no cone
    if scene["kind"] == "spot":
        light.focal_point = numpy.add(scene["position"], scene["axis"])
        light.cone_angle = math.degrees(scene["angle"])
    return light


def shade(scenes):
    for pixel, scene in zip(pixels, scenes):
        pixel.show(scene)
    window.Render()
    colors = vtkFloatArray()
    window.GetRGBAPixelData(0, 0, SIDE - 1, SIDE - 1, 0, colors)
    return [list(colors.GetTuple(i)[:3]) for i in range(len(scenes))]


window = vtkRenderWindow(off_screen_rendering=True, multi_samples=0, size=(SIDE, SIDE))
pixels = [Pixel(window, i % SIDE, i // SIDE) for i in range(SIDE * SIDE)]
window.Render()
# floats, not bytes
window.render_framebuffer.PopulateFramebuffer(SIDE, SIDE, True, 1, VTK_FLOAT, True, 32, 0, False)
serve(PROFILE, shade, SIDE * SIDE)
