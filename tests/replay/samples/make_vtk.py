#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
# Makes the files in vtk/ anew, by VTK's own writers (Debian: python3-vtk9). vtk_series_test.cpp knows the numbers.
import pathlib
import vtk

N = 40


def points(grid, dtype):
    data = vtk.vtkUnstructuredGrid() if grid else vtk.vtkPolyData()
    positions = vtk.vtkPoints()
    positions.SetDataType(dtype)
    make = vtk.vtkFloatArray if dtype == vtk.VTK_FLOAT else vtk.vtkDoubleArray
    velocity, radius, ident, kind = make(), make(), vtk.vtkIdTypeArray(), vtk.vtkIntArray()
    for array, name, components in (velocity, "v", 3), (radius, "radius", 1), (ident, "id", 1), (kind, "type", 1):
        array.SetName(name)
        array.SetNumberOfComponents(components)
        data.GetPointData().AddArray(array)
    cells = vtk.vtkCellArray()
    for i in range(N):
        positions.InsertNextPoint(i / 8, -i / 4, i * i)
        velocity.InsertNextTuple3(i / 2, 1 - i, 0.125)
        radius.InsertNextValue(1 / (1 << i % 5))
        ident.InsertNextValue(2 * N - i)
        kind.InsertNextValue(i % 3)
        cells.InsertNextCell(1, [i])
    data.SetPoints(positions)
    data.SetCells(vtk.VTK_VERTEX, cells) if grid else data.SetVerts(cells)
    return data


def write(writer, name, data):
    writer.SetInputData(data)
    writer.SetFileName(str(pathlib.Path(__file__).parent / "vtk" / name))
    assert writer.Write()


for grid, ending, xml, legacy in (
        (False, "vtp", vtk.vtkXMLPolyDataWriter, vtk.vtkPolyDataWriter),
        (True, "vtu", vtk.vtkXMLUnstructuredGridWriter, vtk.vtkUnstructuredGridWriter)):
    for mode in "Ascii", "Binary", "Appended":
        for zlib in False, True:
            for big in False, True:
                w = xml()
                getattr(w, f"SetDataModeTo{mode}")()
                w.SetCompressorTypeToZLib() if zlib else w.SetCompressorTypeToNone()
                w.SetByteOrderToBigEndian() if big else w.SetByteOrderToLittleEndian()
                w.SetHeaderTypeToUInt64() if zlib else w.SetHeaderTypeToUInt32()
                if mode == "Appended" and big != zlib:
                    w.EncodeAppendedDataOff()  # raw
                w.SetBlockSize(320)  # several blocks in an array
                if mode == "Ascii" and (zlib or big):
                    continue
                name = f"{mode.lower()}{'-zlib' if zlib else ''}{'-big' if big else ''}.{ending}"
                write(w, name, points(grid, vtk.VTK_DOUBLE if big else vtk.VTK_FLOAT))
    for binary in False, True:
        w = legacy()
        w.SetFileTypeToBinary() if binary else w.SetFileTypeToASCII()
        w.SetFileVersion(42 if grid else 51)
        write(w, f"{'binary' if binary else 'ascii'}-{'grid' if grid else 'poly'}.vtk", points(grid, vtk.VTK_FLOAT))
