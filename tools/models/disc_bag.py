#!/usr/bin/env python3
# corpuscle: airbag deployment by the corpuscular method
# SPDX-License-Identifier: MIT
"""Writes the mesh of models/driver_bag_flat: two discs seamed at their rim, and the inflator's orifices.

Each disc is a square block, rings of quads round it, and three rings of triangles where the number of
elements around doubles, so that elements stay near one size from the middle to the rim.
"""

from math import atan2, cos, hypot, pi, sin
from typing import NamedTuple

from deck import MODELS, Mesh

FRONT, REAR, INFLATOR = 1, 2, 3   # parts
FIXED = 1                         # node set
RADIUS = 360.0                    # of the bag                                         [mm]
INFLATOR_RADIUS = 45.0            # of the fixed disc                                  [mm]
HALF_GAP = 0.5                    # the discs start 1 mm apart ...                     [mm]
CLOSING = 28.0                    # ... and close over this last stretch to the rim    [mm]
HALF_BLOCK = 28.0                 # half the side of the square block in the middle    [mm]
DISH = 15.0                       # the fixed disc is dished, to take in the orifices  [mm]
ORIFICES = 12
ORIFICE_RADIUS = 15.0             # of the circle they stand on                        [mm]
ORIFICE_DEPTH = 8.0               # below the rear panel, out of the fabric's reach    [mm]
JET_RISE = 0.4                    # of a jet's axis, over its run


class Grid(NamedTuple):
    block: int     # elements along a side of the square block
    rings: tuple   # how many around, out to which radius [mm]
    width: float   # of a ring, about                     [mm]


GRID = Grid(5, ((20, 60.0), (40, 116.0), (80, 230.0), (160, RADIUS)), 13.6)


def flat_disc(grid):
    """Points of a disc as (x, y), cells as point rows counter-clockwise, the rows on the rim."""
    n, points, cells = grid.block, [], []
    block = [[None] * (n + 1) for _ in range(n + 1)]
    for i in range(n + 1):
        for j in range(n + 1):
            block[i][j] = len(points)
            points.append(rounded_square(2.0 * i / n - 1.0, 2.0 * j / n - 1.0))
    for i in range(n):
        for j in range(n):
            cells.append((block[i][j], block[i + 1][j], block[i + 1][j + 1], block[i][j + 1]))
    ring = border(block)

    start = atan2(*reversed(points[ring[0]]))
    ring = add_ring(points, cells, ring, INFLATOR_RADIUS, len(ring), start)
    inner = INFLATOR_RADIUS
    for around, outer in grid.rings:
        count = max(1, round((outer - inner) / grid.width))
        for k in range(1, count + 1):
            radius = inner + (outer - inner) * k / count
            ring = add_ring(points, cells, ring, radius, around, start)
        inner = outer
    return points, cells, ring


def rounded_square(u, v):
    """The block's point for u, v in [-1, 1]: half-way between a square and a circle."""
    along = max(abs(u), abs(v))
    scale = HALF_BLOCK * (0.5 + 0.5 * along / hypot(u, v)) if along else 0.0
    return scale * u, scale * v


def border(block):
    """The block's border rows, counter-clockwise from its corner (-1, -1)."""
    n = len(block) - 1
    return ([block[i][0] for i in range(n)] + [block[n][j] for j in range(n)]
            + [block[i][n] for i in range(n, 0, -1)] + [block[0][j] for j in range(n, 0, -1)])


def add_ring(points, cells, inside, radius, around, start):
    """Adds `around` points at `radius` and the cells between them and the ring `inside`."""
    outside = []
    for k in range(around):
        angle = start + 2.0 * pi * k / around
        outside.append(len(points))
        points.append((radius * cos(angle), radius * sin(angle)))
    for k in range(len(inside)):
        a, b = inside[k], inside[(k + 1) % len(inside)]
        if around == len(inside):
            cells.append((a, outside[k], outside[(k + 1) % around], b))
        else:  # twice as many outside
            c, d, e = (outside[(2 * k + i) % around] for i in range(3))
            cells += [(a, c, d), (a, d, b), (b, d, e)]
    return outside


def height(x, y):
    """Half the gap between the discs: level, and smoothly zero at the rim."""
    share = min(1.0, max(0.0, (RADIUS - hypot(x, y)) / CLOSING))
    return HALF_GAP * share * share * (3.0 - 2.0 * share)


def dish(x, y):
    """Depth of the fixed disc below the rear panel: level in the block, rising in the ring round it."""
    return DISH if hypot(x, y) < 0.999 * INFLATOR_RADIUS else 0.0


def bag(grid):
    points, cells, rim = flat_disc(grid)
    rim = set(rim)
    mesh = Mesh()
    front = [mesh.node(x, y, 0.0 if i in rim else height(x, y)) for i, (x, y) in enumerate(points)]
    rear = [front[i] if i in rim else mesh.node(x, y, -height(x, y) - dish(x, y))
            for i, (x, y) in enumerate(points)]
    fixed = set()
    for cell in cells:
        on_inflator = all(hypot(*points[i]) < 1.001 * INFLATOR_RADIUS for i in cell)
        mesh.shell(FRONT, *(front[i] for i in reversed(cell)))
        mesh.shell(INFLATOR if on_inflator else REAR, *(rear[i] for i in cell))
        if on_inflator:
            fixed.update(rear[i] for i in cell)
    mesh.check_closed()
    add_orifices(mesh, fixed)
    mesh.node_sets[FIXED] = ("the inflator: fixed disc and orifices", sorted(fixed))
    return mesh


def add_orifices(mesh, fixed):
    """A circle of nodes in the dish, each with a vector that points outward and to the front."""
    for k in range(ORIFICES):
        angle = 2.0 * pi * k / ORIFICES
        c, s = cos(angle), sin(angle)
        fixed.add(mesh.node(ORIFICE_RADIUS * c, ORIFICE_RADIUS * s, -HALF_GAP - ORIFICE_DEPTH,
                            number=100001 + k))
        mesh.vectors[1 + k] = ((0.0, 0.0, 0.0), (c, s, JET_RISE))


if __name__ == "__main__":
    comment = ["Two discs of 720 mm diameter seamed at the rim, 1 mm apart, with a fixed dish and",
               "twelve orifices of the inflator in the middle of the rear one; lengths in mm.",
               "Written by tools/models/disc_bag.py: change it there."]
    bag(GRID).write(MODELS / "driver_bag_flat" / "mesh.k", comment)
