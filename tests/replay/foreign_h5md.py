#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes H5MD files as other programs do, and beside slab.h5 what must be found in it; called when the tests are
built.

foreign_h5md.py FOLDER [PARTICLES]
"""
import sys

import h5py
import numpy as np

folder = sys.argv[1]
count = int(sys.argv[2]) if len(sys.argv) > 2 else 2000
rng = np.random.default_rng(7)
frames = 5
size = np.array([0.1, 0.012, 0.3])  # m: a slab that is thin in y
columns, rows, fewest = 4, 15, 21


def h5md(name):
    file = h5py.File(f"{folder}/{name}.h5", "w")
    about = file.create_group("h5md")
    about.attrs["version"] = np.array([1, 1])
    about.create_group("author").attrs["name"] = "N. N."
    about.create_group("creator").attrs["name"] = "h5py"
    return file


def element(group, name, values, step=None, time=None, **how):
    made = group.create_group(name)
    made.create_dataset("value", data=values, **how)
    if step is not None:
        made["step"] = step
    if time is not None:
        made["time"] = time
    return made


def indices(position, tracer):
    """Counts in the cells, and Tian et al. (2007), Eqs (13) to (15), from places as single precision holds them."""
    scaled = position.astype(np.float64) / size[[0, 2]] * [columns, rows]
    inside = ((scaled >= 0) & (scaled <= [columns, rows])).all(axis=1)
    cell = np.minimum(scaled[inside].astype(int), [columns - 1, rows - 1]) @ [1, columns]
    n = np.bincount(cell, minlength=columns * rows)
    black = np.bincount(cell, weights=tracer[inside], minlength=columns * rows)
    used = n >= fewest
    share, per_cell = black[used] / n[used], n[used].mean()
    mean, variance = share.mean(), share.var(ddof=1)
    separate, random = mean * (1 - mean), mean * (1 - mean) / per_cell
    lacey = (separate - variance) / (separate - random)
    ashton = np.log(separate / variance) / np.log(separate / random)
    return used.sum(), n, black.astype(int), lacey, ashton


def slab():
    """Two groups in space: rows shuffled from frame to frame, a few more particles gone in each."""
    file, expected, found = h5md("slab"), open(f"{folder}/slab.frames", "wb"), open(f"{folder}/slab.indices", "w")
    names, seen = ["fine", "coarse"], [[] for _ in range(frames)]
    for name in names:
        group = file.create_group(f"particles/{name}")
        n, number = count // 2, sorted(names).index(name)
        home, velocity = rng.random((n, 3)) * size * [1, 1, 0.6], rng.normal(size=(frames, n, 3))
        position = np.clip(home + np.cumsum(0.002 * velocity, axis=0), 0, size)
        ids = np.tile(np.arange(n), (frames, 1))
        for t in range(frames):
            order = rng.permutation(n)
            position[t], velocity[t], ids[t] = position[t][order], velocity[t][order], ids[t][order]
            gone = ids[t] % 50 < t
            position[t][gone], ids[t][gone] = np.nan, -1
            there = ids[t] >= 0
            seen[t].append((2 * ids[t][there] + number, position[t][there], velocity[t][there], number))
        how = {"compression": "gzip", "shuffle": True} if name == "fine" else {}
        for what, values in [("position", position), ("velocity", velocity), ("id", ids)]:
            made = element(group, what, values, step=np.int64(250), time=0.005, chunks=True, **how)
            made["step"].attrs["offset"] = 1000
            made["time"].attrs["offset"] = 0.02
        group["radius"] = np.full(n, 0.001 if name == "fine" else 0.0012)
        box = group.create_group("box")
        box.attrs["dimension"] = 3
        box.attrs["boundary"] = np.array([b"none"] * 3)
        box["edges"] = size
    for parts in seen:
        ids = np.concatenate([p[0] for p in parts])
        order = np.argsort(ids)
        plane = [np.concatenate([p[k] for p in parts])[order][:, [0, 2]].astype(np.float32) for k in (1, 2)]
        tracer = (ids[order] % 2).astype(np.uint8)
        for values in [np.int64(len(ids)), ids[order].astype(np.int32), *plane, tracer]:
            expected.write(values.tobytes())
        cells, n, black, lacey, ashton = indices(plane[0], tracer)
        found.write(" ".join(map(repr, [int(cells), float(lacey), float(ashton), *n.tolist(), *black.tolist()])) + "\n")


def flat():
    """In the plane and in single precision; species are an enum, the box is a matrix that changes."""
    file = h5md("flat")
    group = file.create_group("particles/grains")
    n = min(count, 60)
    steps, times = np.arange(frames) ** 2, 0.1 * np.arange(frames) ** 2
    places = rng.random((frames, n, 2)).astype(np.float32) * np.float32(0.2) - np.float32(0.1)
    made = element(group, "position", places, steps, times, compression="gzip")
    element(group, "angular_velocity", np.arange(frames * n, dtype=float).reshape(frames, n), made["step"], made["time"])
    kinds = h5py.enum_dtype({"glass": 4, "steel": 9}, basetype="i4")
    group.create_dataset("species", data=np.where(np.arange(n) % 3 == 0, 9, 4), dtype=kinds)
    group["id"] = np.arange(n)[::-1] + 1
    group["diameter"] = np.full(n, 0.004)
    box = group.create_group("box")
    box["offset"] = [-0.1, -0.1]
    element(box, "edges", np.tile(0.2 * np.eye(2), (frames, 1, 1)), made["step"], made["time"])


def bare():
    """Steps and places, nothing else."""
    group = h5md("bare").create_group("particles/all")
    places = rng.random((frames, 30, 3)) * size
    element(group, "position", places, step=10 * np.arange(frames))


def snapshot():
    """One instant."""
    group = h5md("snapshot").create_group("particles/all")
    group["position"] = rng.random((40, 2)) * [0.1, 0.3]
    group["species"] = np.arange(40) % 3
    group["radius"] = np.full(40, 0.002)


slab(), flat(), bare(), snapshot()
