# SPDX-License-Identifier: MIT
"""Reads an export as another program does and compares every number with the trajectory's, bit by bit.

python3 export_check.py h5md|vtk|xdmf|extxyz|lammps FOLDER TRAJECTORY FRAME...
FRAMEs are the places in the trajectory of those that were exported.
"""
import os
import sys
import xml.etree.ElementTree as xml

import h5py
import numpy as np

kind, folder, trajectory = sys.argv[1:4]
frames = [int(f) for f in sys.argv[4:]]
h5 = h5py.File(trajectory)
particles, gas = h5["particles/all"], h5["bedmix/gas"]


def of(group, name, frame):
    return group[name]["value"][frame]


def in_space(plane):
    return np.c_[plane.reshape(-1, 2), np.zeros(plane.size // 2, plane.dtype)]


def same(found, expected, what):
    assert found.shape == expected.shape, (what, found.shape, expected.shape)
    assert found.dtype == expected.dtype, (what, found.dtype, expected.dtype)
    assert found.tobytes() == expected.tobytes(), what


def check_vtk_particles(grid, frame):
    from vtkmodules.util.numpy_support import vtk_to_numpy as numbers
    assert grid.GetNumberOfCells() == len(particles["id"])
    same(numbers(grid.GetPoints().GetData()), in_space(of(particles, "position", frame)), "position")
    data = grid.GetPointData()
    same(numbers(data.GetArray("velocity")), in_space(of(particles, "velocity", frame)), "velocity")
    same(numbers(data.GetArray("angular_velocity")), of(particles, "angular_velocity", frame), "spin")
    same(numbers(data.GetArray("species")), particles["species"][:], "species")
    same(numbers(data.GetArray("id")), particles["id"][:], "id")


def check_vtk_gas(grid, frame):
    from vtkmodules.util.numpy_support import vtk_to_numpy as numbers
    same(numbers(grid.GetXCoordinates()), gas["x"][:], "x")
    same(numbers(grid.GetYCoordinates()), gas["y"][:], "y")
    data = grid.GetCellData()
    same(numbers(data.GetArray("voidage")), of(gas, "voidage", frame).ravel(), "voidage")
    same(numbers(data.GetArray("pressure")), of(gas, "pressure", frame).ravel(), "pressure")
    same(numbers(data.GetArray("gas_velocity")), in_space(of(gas, "gas_velocity", frame)), "gas velocity")


def check_vtk():
    from vtkmodules.util.numpy_support import vtk_to_numpy as numbers
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLRectilinearGridReader

    def read(reader, name):
        reader = reader()
        reader.SetFileName(os.path.join(folder, name))
        reader.Update()
        return reader.GetOutput()

    for part, reader, check in (("particles", vtkXMLPolyDataReader, check_vtk_particles),
                                ("gas", vtkXMLRectilinearGridReader, check_vtk_gas)):
        listed = xml.parse(os.path.join(folder, part + ".pvd")).findall("Collection/DataSet")
        assert len(listed) == len(frames), part
        for frame, entry in zip(frames, listed):
            grid = read(reader, entry.get("file"))
            check(grid, frame)
            time = particles["position/time"][frame]
            assert float(entry.get("timestep")) == time
            assert grid.GetFieldData().GetArray("TimeValue").GetValue(0) == time
    last = read(vtkXMLPolyDataReader, "particles_%06d.vtp" % frames[-1])
    assert np.all(numbers(last.GetPointData().GetArray("diameter")) == np.float32(0.004))
    blocked = np.arange(grid.GetDimensions()[1] - 1)[:, None] < gas["lowest_row"][:]
    assert [bool(grid.IsCellVisible(c)) for c in range(blocked.size)] == list(~blocked.ravel())
    walls = read(vtkXMLPolyDataReader, "walls.vtp")
    width, height = h5["particles/all/box/edges"][:]
    assert walls.GetNumberOfLines() >= 3
    assert np.allclose(walls.GetBounds(), (0, width, 0, height, 0, 0))


def check_xdmf():
    from vtkmodules.vtkIOXdmf2 import vtkXdmfReader
    for part, check in (("particles", check_vtk_particles), ("gas", check_vtk_gas)):
        reader = vtkXdmfReader()
        reader.SetFileName(os.path.join(folder, part + ".xmf"))
        reader.UpdateInformation()
        times = reader.GetOutputInformation(0).Get(reader.GetExecutive().TIME_STEPS())
        assert list(times) == list(particles["position/time"][frames])
        for frame, time in zip(frames, times):
            reader.UpdateTimeStep(time)
            check(reader.GetOutputDataObject(0), frame)


def check_atoms(kind, name):
    import ase.io
    found = ase.io.read(os.path.join(folder, name), index=":", format=kind)
    assert len(found) == len(frames)
    for frame, atoms in zip(frames, found):
        same(atoms.get_positions().astype(np.float32), in_space(of(particles, "position", frame)), "position")
        if kind == "lammps-dump-text":
            continue  # ASE scales what else there is to its own units
        assert np.array_equal(atoms.arrays["velo"].astype(np.float32), in_space(of(particles, "velocity", frame)))
        assert np.array_equal(atoms.arrays["omega"].astype(np.float32), of(particles, "angular_velocity", frame))
        assert np.array_equal(atoms.arrays["id"], particles["id"][:])
        assert np.array_equal(np.array(atoms.get_chemical_symbols()) == "C", particles["species"][:] == 1)
        assert np.all(atoms.arrays["radius"] == 0.002)
        assert atoms.info["Time"] == particles["position/time"][frame]


def check_h5md():
    assert list(h5["h5md"].attrs["version"]) == [1, 1]
    for module in ("author", "creator"):
        assert h5["h5md"][module].attrs["name"]
    assert h5["h5md/creator"].attrs["version"]
    box = particles["box"]
    assert box.attrs["dimension"] == 2
    assert list(box.attrs["boundary"]) == [b"none", b"none"]
    assert box["edges"].shape == (2,)
    count = len(particles["id"])
    shape = {"position": (count, 2), "velocity": (count, 2), "angular_velocity": (count,)}
    elements = [*particles.items(), *h5["observables"].items()]
    changing = [(name, e) for name, e in elements if isinstance(e, h5py.Group) and name != "box"]
    assert len(changing) >= 6
    for name, element in changing:
        assert set(element) == {"step", "time", "value"}, name
        steps, times, values = element["step"], element["time"], element["value"]
        assert steps.dtype == np.int64 and times.dtype == np.float64
        assert len(steps) == len(times) == len(values)
        assert np.all(np.diff(steps) > 0) and np.all(np.diff(times) > 0)
        assert values.shape[1:] == shape.get(name, ()), name
    for name in ("species", "id"):
        assert particles[name].shape == (count,)


{"h5md": check_h5md, "vtk": check_vtk, "xdmf": check_xdmf,
 "extxyz": lambda: check_atoms("extxyz", "particles.extxyz"),
 "lammps": lambda: check_atoms("lammps-dump-text", "particles.lammpstrj")}[kind]()
