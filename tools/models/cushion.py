#!/usr/bin/env python3
# corpuscle: airbag deployment by the corpuscular method
# SPDX-License-Identifier: MIT
"""Writes models/placed_modules/module_mesh.k: a small cushion, flat, and the orifice inside it.

Two panels of 240 x 160 mm in quads, seamed at the rim and 10 mm apart elsewhere; the orifice lies on
the x axis in the rear quarter, whose nodes are held.
"""

from deck import MODELS, Mesh

COLUMNS, ROWS = 12, 8
LENGTH, WIDTH, GAP = 240.0, 160.0, 10.0
FRONT, REAR, HELD = 1, 2, 1


def main():
    mesh = Mesh()
    rim, held = {}, []

    def node(i, j, side):
        is_rim = i in (0, COLUMNS) or j in (0, ROWS)
        if is_rim and (i, j) in rim:
            return rim[i, j]
        x, y = LENGTH * i / COLUMNS, WIDTH * (j / ROWS - 0.5)
        number = mesh.node(x, y, 0.0 if is_rim else 0.5 * side * GAP)
        if is_rim:
            rim[i, j] = number
        if 4 * i <= COLUMNS:
            held.append(number)
        return number

    for part, side in ((FRONT, 1), (REAR, -1)):
        grid = {(i, j): node(i, j, side) for j in range(ROWS + 1) for i in range(COLUMNS + 1)}
        for j in range(ROWS):
            for i in range(COLUMNS):
                corners = [grid[i, j], grid[i + 1, j], grid[i + 1, j + 1], grid[i, j + 1]]
                mesh.shell(part, *(corners if side > 0 else corners[::-1]))
    mesh.check_closed(outward=True)
    held.append(mesh.node(30.0, 0.0, 0.0, number=1000))
    mesh.node_sets[HELD] = ("the rear quarter, and the orifice", held)
    mesh.write(MODELS / "placed_modules" / "module_mesh.k",
               ["A cushion of two panels of 240 x 160 mm, an orifice in it; lengths in mm.",
                "Written by tools/models/cushion.py: change it there."])


if __name__ == "__main__":
    main()
