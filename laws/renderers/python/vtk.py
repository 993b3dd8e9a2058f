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
        self.renderer = vtkRenderer()
        self.renderer.SetViewport(x / SIDE, y / SIDE, (x + 1) / SIDE, (y + 1) / SIDE)
        self.renderer.AutomaticLightCreationOff()
        self.points = vtkPoints()
        self.points.SetNumberOfPoints(1)
        self.normals = vtkFloatArray()
        self.normals.SetNumberOfComponents(3)
        self.normals.SetNumberOfTuples(1)
        vertices = vtkCellArray()
        vertices.InsertNextCell(1, [0])
        data = vtkPolyData()
        data.SetPoints(self.points)
        data.SetVerts(vertices)
        data.GetPointData().SetNormals(self.normals)
        mapper = vtkPolyDataMapper()
        mapper.SetInputData(data)
        actor = vtkActor()
        actor.SetMapper(mapper)
        self.surface = actor.GetProperty()
        self.surface.SetInterpolationToPhong()
        self.surface.SetPointSize(1)
        self.surface.SetAmbient(1)
        self.surface.SetSpecular(1)
        self.renderer.AddActor(actor)
        window.AddRenderer(self.renderer)

    def show(self, scene):
        p, v = scene["p"], scene["v"]
        self.points.SetPoint(0, p)
        self.points.Modified()
        self.normals.SetTuple(0, scene["n"])
        self.normals.Modified()
        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(numpy.add(p, v))
        camera.SetFocalPoint(p)
        least = min(range(3), key=lambda i: abs(v[i]))
        camera.SetViewUp([float(i == least) for i in range(3)])
        camera.SetClippingRange(0.5 * math.hypot(*v), 2 * math.hypot(*v))
        self.surface.SetAmbientColor(numpy.multiply(scene["k_a"], scene["i_a"]))
        self.surface.SetDiffuseColor(scene["k_d"])
        self.surface.SetSpecularColor([0, 0, 0] if scene["model"] == "lambert" else scene["k_s"])
        self.surface.SetSpecularPower(scene["m"])
        self.renderer.RemoveAllLights()
        for light in scene["lights"]:
            self.renderer.AddLight(of(light))


def of(scene):
    """A light of VTK."""
    light = vtkLight()
    light.SetLightTypeToSceneLight()
    light.SetColor(scene["intensity"])
    if scene["kind"] == "directional":
        light.SetPosition(scene["l"])
        light.SetFocalPoint(0, 0, 0)
        return light
    light.PositionalOn()
    light.SetPosition(scene["position"])
    light.SetAttenuationValues(scene["attenuation"])
    light.SetExponent(0)
    light.SetConeAngle(90)  # no cone
    if scene["kind"] == "spot":
        light.SetFocalPoint(numpy.add(scene["position"], scene["axis"]))
        light.SetConeAngle(math.degrees(scene["angle"]))
    return light


class Screen:
    def __init__(self):
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(True)
        self.window.SetMultiSamples(0)
        self.window.SetSize(SIDE, SIDE)
        self.pixels = [Pixel(self.window, i % SIDE, i // SIDE) for i in range(SIDE * SIDE)]
        self.window.Render()
        # floats, not bytes
        self.window.GetRenderFramebuffer().PopulateFramebuffer(SIDE, SIDE, True, 1, VTK_FLOAT, True, 32, 0, False)

    def shade(self, scenes):
        for pixel, scene in zip(self.pixels, scenes):
            pixel.show(scene)
        self.window.Render()
        colors = vtkFloatArray()
        self.window.GetRGBAPixelData(0, 0, SIDE - 1, SIDE - 1, 0, colors)
        return [list(colors.GetTuple(i)[:3]) for i in range(len(scenes))]


serve(PROFILE, Screen().shade, SIDE * SIDE)
