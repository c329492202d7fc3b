#!/usr/bin/env python3
"""Counts the particles outside the bag in every frame of a results.h5: a ray along z from each particle
crosses the bag's shells an odd number of times from inside. usage: outside.py RESULTS.h5 [PART ...]
(the parts that close the bag; all by default)"""
import sys

import h5py
import numpy as np

CELL = 10.0  # of the columns, in the deck's unit of length


def facets(mesh, parts):
    shells = mesh["shell_nodes"][:]
    if parts:
        shells = shells[np.isin(mesh["shell_part"][:], parts)]
    a, b, c, d = shells.T
    quads = c != d
    return np.vstack([np.stack([a, b, c], 1), np.stack([a, c, d], 1)[quads]])


def columns(low, high, origin, count):
    """Rows and columns that boxes overlap: pairs (column, row of the box)."""
    first = np.clip(((low - origin) // CELL).astype(int), 0, count - 1)
    last = np.clip(((high - origin) // CELL).astype(int), 0, count - 1)
    pairs = {}
    for row, ((i0, j0), (i1, j1)) in enumerate(zip(first, last)):
        for i in range(i0, i1 + 1):
            for j in range(j0, j1 + 1):
                pairs.setdefault((i, j), []).append(row)
    return pairs


def crossings(points, corners):
    """How often the ray upward from each point meets the triangles. P x 3, T x 3 x 3"""
    p = points[:, None, :2]
    a, b, c = (corners[None, :, k, :2] for k in range(3))
    cross = lambda u, v: u[..., 0] * v[..., 1] - u[..., 1] * v[..., 0]
    area = cross(b - a, c - a)
    with np.errstate(divide="ignore", invalid="ignore"):
        u, v = cross(p - a, c - a) / area, cross(b - a, p - a) / area
        z = corners[None, :, 0, 2]
        height = z + u * (corners[None, :, 1, 2] - z) + v * (corners[None, :, 2, 2] - z)
        return ((u >= 0) & (v >= 0) & (u + v < 1) & (height > points[:, None, 2])).sum(1)


def outside(frame, triangles):
    x = frame["coordinates"][:].astype(float)
    at = frame["particles/position"][:].astype(float)
    if len(at) == 0:
        return 0, 0
    # A turn about odd angles: no ray passes exactly through edges that lie along the axes.
    turn = np.linalg.qr(np.array([[1.0, 0.1313, 0.0717], [0.0911, 1.0, 0.1171], [0.0531, 0.0837, 1.0]]))[0]
    x, at = x @ turn, at @ turn
    corners = x[triangles]
    low, high = corners[:, :, :2].min(1), corners[:, :, :2].max(1)
    origin = low.min(0)
    count = ((high.max(0) - origin) // CELL).astype(int) + 1
    cells = np.clip(((at[:, :2] - origin) // CELL).astype(int), 0, count - 1)
    order = np.lexsort((cells[:, 1], cells[:, 0]))
    starts = np.flatnonzero(np.any(np.diff(cells[order], axis=0, prepend=-1), axis=1))
    pairs = columns(low, high, origin, count)
    bad = 0
    for begin, end in zip(starts, np.append(starts[1:], len(at))):
        rows = order[begin:end]
        near = pairs.get(tuple(cells[rows[0]]), [])
        bad += (crossings(at[rows], corners[near]) % 2 == 0).sum() if near else len(rows)
    return int(bad), len(at)


def main():
    with h5py.File(sys.argv[1]) as results:
        triangles = facets(results["mesh"], [int(p) for p in sys.argv[2:]])
        total = looked = frames = 0
        for name in sorted(k for k in results["frames"] if k.isdigit()):
            frame = results["frames"][name]
            if "particles" not in frame:
                continue
            bad, n = outside(frame, triangles)
            if bad:
                print(f"frame {name}: {bad} of {n} particles outside")
            total, looked, frames = total + bad, looked + n, frames + 1
        print(f"{total} of {looked} particles outside in {frames} frames")


if __name__ == "__main__":
    main()
