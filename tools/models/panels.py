#!/usr/bin/env python3
# corpuscle: airbag deployment by the corpuscular method
# SPDX-License-Identifier: MIT
"""Writes models/recipes/panels.k: two flat panels, drawn as a preprocessor would, to be folded.

A bag 420 long whose sides are curves: front (part 1), back (part 2) with a vent (part 5), rims with
nodes of their own that lie on each other. Units: mm.
"""

from math import cos, pi

from deck import MODELS

COLUMNS, ROWS = 36, 26
VENT = {(i, j) for i in (9, 10, 11) for j in (12, 13)}  # cells of the back


def place(i, j):
    """Node of the grid, which the curved sides stretch."""
    u, v = 2.0 * i / COLUMNS - 1.0, 2.0 * j / ROWS - 1.0
    return 210.0 * u - 18.0 * v * v * u, 150.0 * v * (0.8 + 0.2 * cos(0.5 * pi * u))


def main():
    nodes, shells = [], []
    for panel in range(2):
        def number(i, j, panel=panel):
            return panel * (COLUMNS + 1) * (ROWS + 1) + j * (COLUMNS + 1) + i + 1
        for j in range(ROWS + 1):
            for i in range(COLUMNS + 1):
                nodes.append((number(i, j), *place(i, j), 0.0))
        for j in range(ROWS):
            for i in range(COLUMNS):
                corners = [number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)]
                part = 5 if panel and (i, j) in VENT else panel + 1
                shells.append((part, corners if panel == 0 else corners[::-1]))
    with open(MODELS / "recipes" / "panels.k", "w") as deck:
        deck.write("$ Two panels to be folded by deck.toml. Units: mm.\n"
                   "$ Written by tools/models/panels.py\n*KEYWORD\n*NODE\n")
        for number, x, y, z in nodes:
            deck.write(f"{number:8d}{x:16.9g}{y:16.9g}{z:16.9g}\n")
        deck.write("*ELEMENT_SHELL\n")
        for row, (part, corners) in enumerate(shells, 1):
            deck.write(f"{row:8d}{part:8d}" + "".join(f"{n:8d}" for n in corners) + "\n")
        deck.write("*END\n")


if __name__ == "__main__":
    main()
