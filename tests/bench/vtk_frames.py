#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Draws frames with VTK, off-screen, and prints the milliseconds of wall and of CPU time a picture takes; called by vtk.sh.

vtk_frames.py FOLDER PARTICLES WIDTH HEIGHT gaussian|sphere SECONDS [PICTURE.png]
FOLDER holds what `bench_draw --write` wrote. Every picture is read back; five lines of text change with each.
"""
import glob
import sys
import time

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk

folder, particles, width, height, mode, seconds = sys.argv[1:7]
width, height, seconds = int(width), int(height), float(seconds)
radius = 0.002
frames = [np.loadtxt(f) for f in sorted(glob.glob(f"{folder}/{particles}_*.txt"))]
count = len(frames[0])

cloud, points, cells = vtk.vtkPolyData(), vtk.vtkPoints(), vtk.vtkCellArray()
for i in range(count):
    cells.InsertNextCell(1, [i])
cloud.SetPoints(points)
cloud.SetVerts(cells)

if mode == "gaussian":  # squares with a disc in each: the fastest way found
    mapper = vtk.vtkPointGaussianMapper()
    mapper.SetInputData(cloud)
    mapper.SetScaleFactor(radius)
    mapper.EmissiveOff()
    mapper.SetTriangleScale(1.5)
    mapper.SetSplatShaderCode(
        "//VTK::Color::Impl\nif (dot(offsetVCVSOutput.xy, offsetVCVSOutput.xy) > 1.0) discard;\n"
    )
else:
    sphere = vtk.vtkSphereSource()
    sphere.SetRadius(radius)
    sphere.SetThetaResolution(16)
    sphere.SetPhiResolution(16)
    mapper = vtk.vtkGlyph3DMapper()
    mapper.SetInputData(cloud)
    mapper.SetSourceConnection(sphere.GetOutputPort())
    mapper.ScalingOff()
    mapper.OrientOff()
actor = vtk.vtkActor()
actor.SetMapper(mapper)
actor.GetProperty().LightingOff()

text = vtk.vtkTextActor()
text.GetTextProperty().SetFontSize(20)
text.GetTextProperty().SetColor(0, 0, 0)
text.SetPosition(20, height - 160)

renderer, window = vtk.vtkRenderer(), vtk.vtkRenderWindow()
renderer.SetBackground(1, 1, 1)
renderer.AddActor(actor)
renderer.AddActor2D(text)
window.SetOffScreenRendering(1)
window.SetMultiSamples(0 if mode == "gaussian" else 4)
window.SetSize(width, height)
window.AddRenderer(renderer)
low, high = frames[0][:, :2].min(axis=0), frames[0][:, :2].max(axis=0)
middle = 0.5 * (low + high)
camera = renderer.GetActiveCamera()
camera.ParallelProjectionOn()
camera.SetFocalPoint(middle[0], middle[1], 0)
camera.SetPosition(middle[0], middle[1], 1)
# As large as bedmix draws the bed: 0.42 m of height with a tenth above it, or 1.2 m.
camera.SetParallelScale(0.5 * 1.2 * (0.42 if count == 1000 else 1.2))
reader = vtk.vtkWindowToImageFilter()
reader.SetInput(window)
reader.ReadFrontBufferOff()


def draw(k):
    frame = frames[k % len(frames)]
    points.SetData(numpy_to_vtk(np.c_[frame[:, :2], np.zeros(count)], deep=1))
    colors = numpy_to_vtk(
        np.where(frame[:, 4:5] == 1, [[0, 0, 0]], [[0, 158, 115]]).astype(np.uint8), deep=1
    )
    cloud.GetPointData().SetScalars(colors)
    cloud.Modified()
    text.SetInput(f"t = {0.02 * k:.2f} s\n{count} particles\nu = 2.0 u_mf\nLacey 0.{k % 100:02}\nAshton 0.{k % 90:02}")
    window.Render()
    reader.Modified()
    reader.Update()


draw(0)
start, start_cpu, k = time.perf_counter(), time.process_time(), 0
while k == 0 or time.perf_counter() - start < seconds:
    k += 1
    draw(k)
wall, cpu = time.perf_counter() - start, time.process_time() - start_cpu
print(f"{1e3 * wall / k:.3f} {1e3 * cpu / k:.3f}")
if len(sys.argv) > 7:
    writer = vtk.vtkPNGWriter()
    writer.SetInputConnection(reader.GetOutputPort())
    writer.SetFileName(sys.argv[7])
    writer.Write()
