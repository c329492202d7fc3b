#!/usr/bin/env python3
# corpuscle: airbag deployment by the corpuscular method
# SPDX-License-Identifier: MIT
"""Writes the box meshes of models/helium_air, fast_piston, two_inflators, vented_tank, porous_tank,
two_chambers and tank_test."""

from deck import MODELS, Mesh, box_faces

WALLS, PISTON, VENT, MEMBRANE = 1, 2, 2, 2
HELD, MOVED = 1, 2  # node sets


def box(side, cells, part_of_face, membrane_at=None, along=None):
    """A box from the origin to `side` (a cube's edge, or three), `cells` along each axis, normals inward.

    part_of_face(axis, end, i, j) names the part of quad i, j of the face where coordinate `axis` is
    0 or its end. membrane_at: cells along x to a MEMBRANE from wall to wall. along: places of the
    nodes along x where cells are not alike.
    """
    sides = side if isinstance(side, tuple) else (side,) * 3
    mesh = Mesh()
    known = {}

    def node(grid):
        if grid not in known:
            x, y, z = (s * i / n for s, i, n in zip(sides, grid, cells))
            known[grid] = mesh.node(along[grid[0]] if along else x, y, z)
        return known[grid]

    for axis, end, i, j, corners in box_faces(cells):
        nodes = [node(grid) for grid in corners]
        mesh.shell(part_of_face(axis, end, i, j), *(nodes[::-1] if end else nodes))
    mesh.check_closed()
    if membrane_at:
        for j in range(cells[1]):
            for k in range(cells[2]):
                mesh.shell(MEMBRANE, *(node((membrane_at, j + dj, k + dk))
                                       for dj, dk in ((0, 0), (1, 0), (1, 1), (0, 1))))
    return mesh


def helium_air():
    mesh = box(0.1, (6, 6, 6), lambda axis, end, i, j: 1)
    walls = list(mesh.nodes)
    orifice = mesh.node(0.05, 0.05, 0.05, number=100000)
    mesh.node_sets[HELD] = ("every node is held", walls + [orifice])
    mesh.write(MODELS / "helium_air" / "mesh.k",
               ["A box of 1 litre and the orifice in its middle; lengths in m.",
                "Written by tools/models/box.py: change it there."])


def fast_piston():
    mesh = box(0.2, (1, 6, 6), lambda axis, end, i, j: PISTON if axis == 0 and end else WALLS)
    moved = [n for n, x in mesh.nodes.items() if x[0] > 0.0]
    held = [n for n in mesh.nodes if n not in moved]
    orifice = mesh.node(0.1, 0.1, 0.1, number=12345)
    mesh.node_sets[HELD] = ("the closed end and the orifice", held + [orifice])
    mesh.node_sets[MOVED] = ("the piston, with the rim that the side walls share", moved)
    mesh.write(MODELS / "fast_piston" / "mesh.k",
               ["A box of 8 litres whose face at x = 0.2 is a piston; lengths in m.",
                "The side walls run from the closed end to the piston's rim in one quad: they stretch.",
                "Written by tools/models/box.py: change it there."])


def tank(name, is_vent, comment):
    mesh = box(0.1, (6, 6, 6), lambda *face: VENT if is_vent(*face) else WALLS)
    walls = list(mesh.nodes)
    orifice = mesh.node(0.05, 0.05, 0.05, number=100000)
    mesh.node_sets[HELD] = ("every node is held", walls + [orifice])
    mesh.write(MODELS / name / "mesh.k",
               [comment, "Written by tools/models/box.py: change it there."])


def tank_test():
    side = 60.0e6 ** (1.0 / 3.0)  # 60 l                                                  [mm]
    mesh = box(side, (8, 8, 8), lambda *face: WALLS)
    walls = list(mesh.nodes)
    orifice = mesh.node(0.5 * side, 0.5 * side, 0.5 * side, number=100000)
    mesh.node_sets[HELD] = ("every node is held", walls + [orifice])
    mesh.write(MODELS / "tank_test" / "mesh.k",
               ["A box of 60 litres and the inflator's place in its middle; lengths in mm.",
                "Written by tools/models/box.py: change it there."])


def two_rooms(name, size, cells, comment):
    mesh = box(size, cells, lambda *face: WALLS, membrane_at=cells[0] // 2)
    nodes = list(mesh.nodes)
    middle = [0.5 * s for s in size]
    orifices = [mesh.node(share * size[0], *middle[1:], number=100000 + i)
                for i, share in enumerate((0.25, 0.75))]
    mesh.node_sets[HELD] = ("every node is held", nodes + orifices)
    mesh.write(MODELS / name / "mesh.k",
               [comment,
                "Written by tools/models/box.py: change it there."])


def sod():
    mesh = box((1.0, 0.1, 0.1), (60, 6, 6), lambda *face: WALLS, membrane_at=30)
    mesh.node_sets[HELD] = ("every node is held", list(mesh.nodes))
    for number in range(15 * 9):
        i, j, k = number // 9, number // 3 % 3, number % 3
        mesh.node((i + 0.5) / 30, (j + 0.5) / 30, (k + 0.5) / 30, number=100001 + number)
    mesh.write(MODELS / "verification" / "sod" / "mesh.k",
               ["A tube of 1 x 0.1 x 0.1, a membrane (part 2) at 0.5, 135 orifices left of it; lengths in m.",
                "Written by tools/models/box.py: change it there."])


def vent_by_chamber():
    def part(axis, end, i, j):
        if axis == 0 and not end and i in (2, 3) and j in (2, 3):
            return 4
        # along y and z, x is the second and the first of the face's two axes
        if axis == 0:
            return 2 if end else 1
        return 1 if (j if axis == 1 else i) < 3 else 2

    mesh = box((0.1, 0.1, 0.1), (6, 6, 6), part, membrane_at=3)
    mesh.shells = {n: (3 if n > 6 * 36 else part_id, corners)
                   for n, (part_id, corners) in mesh.shells.items()}
    mesh.node_sets[HELD] = ("every node is held", list(mesh.nodes))
    mesh.write(MODELS / "verification" / "vent_by_chamber" / "mesh.k",
               ["A box of 1 litre; chambers' walls are parts 1 and 2, the membrane at x = 0.05 part 3,",
                "a vent in the wall at x = 0 part 4; lengths in m.",
                "Written by tools/models/box.py: change it there."])


def far_vent():
    mesh = box((1.0, 0.1, 0.1), (60, 6, 6), lambda axis, end, i, j: 1 if axis else 3 if end else 2)
    mesh.node_sets[HELD] = ("every node is held", list(mesh.nodes))
    mesh.write(MODELS / "verification" / "far_vent" / "mesh.k",
               ["A duct of 1 x 0.1 x 0.1; the end at x = 0 is part 2, that at x = 1 part 3; lengths in m.",
                "Written by tools/models/box.py: change it there."])


def free_jet():
    mesh = box((0.6, 0.4, 0.4), (6, 4, 4), lambda axis, end, i, j: 1 if axis else 3 if end else 2)
    orifice = mesh.node(0.02, 0.2, 0.2, number=100000)
    mesh.node_sets[HELD] = ("every node is held", list(mesh.nodes))
    mesh.vectors[1] = ((0.0, 0.0, 0.0), (1.0, 0.0, 0.0))
    mesh.write(MODELS / "verification" / "free_jet" / "mesh.k",
               ["A box of 0.6 x 0.4 x 0.4, the end at x = 0 part 2, that at x = 0.6 part 3, an orifice; lengths in m.",
                "Written by tools/models/box.py: change it there."])


def piston_wave():
    mesh = box((1.0, 0.1, 0.1), (1, 6, 6), lambda axis, end, i, j: 1 if axis else PISTON if end else 3)
    moved = [n for n, x in mesh.nodes.items() if x[0] > 0.0]
    mesh.node_sets[HELD] = ("the closed end", [n for n in mesh.nodes if n not in moved])
    mesh.node_sets[MOVED] = ("the piston, with the rim that the side walls share", moved)
    mesh.write(MODELS / "verification" / "piston_wave" / "mesh.k",
               ["A tube of 1 x 0.1 x 0.1; the end at x = 0 is part 3, the piston at x = 1 part 2; lengths in m.",
                "The side walls run from end to end in one quad: they stretch.",
                "Written by tools/models/box.py: change it there."])


def porous_tube():
    rings, columns = 8, 3  # of porous wall, each 0.1 m along the tube
    along = [0.1 * i / columns for i in range(rings * columns + 1)] + [1.0]

    def part(axis, end, i, j):
        if axis == 0:
            return PISTON if end else 3
        column = j if axis == 1 else i
        return 11 + column // columns if column < rings * columns else WALLS

    mesh = box((1.0, 0.1, 0.1), (len(along) - 1, 6, 6), part, along=along)
    moved = [n for n, x in mesh.nodes.items() if x[0] > 0.9]
    mesh.node_sets[HELD] = ("all but the piston", [n for n in mesh.nodes if n not in moved])
    mesh.node_sets[MOVED] = ("the piston, with the rim that the side walls share", moved)
    mesh.write(MODELS / "verification" / "porous_tube" / "mesh.k",
               ["A tube of 1 x 0.1 x 0.1; the end at x = 0 is part 3, the piston at x = 1 part 2; lengths in m.",
                "Side walls: rings of 0.1 m, parts 11 to 18, then part 1 in one quad that the piston shortens.",
                "Written by tools/models/box.py: change it there."])


if __name__ == "__main__":
    sod()
    porous_tube()
    vent_by_chamber()
    far_vent()
    free_jet()
    piston_wave()
    helium_air()
    fast_piston()
    tank("vented_tank", lambda axis, end, i, j: axis == 0 and end and i in (2, 3) and j in (2, 3),
         "A box of 1 litre, a vent in the middle of the face at x = 0.1, an orifice; lengths in m.")
    tank("porous_tank", lambda *face: False,
         "A box of 1 litre and the orifice in its middle; lengths in m.")
    tank_test()
    two_rooms("two_inflators", (0.2, 0.1, 0.1), (12, 6, 6),
              "Two rooms of 1 litre, a membrane (part 2) between them, an orifice in each; lengths in m.")
    two_rooms("two_chambers", (0.1, 0.1, 0.1), (6, 6, 6),
              "Two rooms of half a litre, a membrane (part 2) between, an orifice in each; lengths in m.")
