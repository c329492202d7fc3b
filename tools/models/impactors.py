#!/usr/bin/env python3
# corpuscle: airbag deployment by the corpuscular method
# SPDX-License-Identifier: MIT
"""Writes the meshes of models/impactors: a ball and half a capsule, closed, normals outward.

Each is the surface of a box's grid, drawn onto the form, so that facets stay near one size. The foremost
point is the origin and the form flies towards -z.
"""

from math import hypot, pi, tan

from deck import MODELS, Mesh, box_faces

HEADFORM, TORSO = 100, 101                 # parts
FIRST = 400001                             # node and shell
HEAD_RADIUS, HEAD_CELLS = 82.5, 10         # [mm], along an edge of the box
TORSO_RADIUS, TORSO_CELLS = 150.0, 16
TORSO_STRAIGHT, TORSO_STRIPS = 200.0, 10   # between the rounded ends [mm], facets along it


def on_ball(u, v, w):
    """A place on the cube's surface to one on the unit ball: equal angles along the cube's edges."""
    p = [tan(0.25 * pi * c) for c in (u, v, w)]
    size = hypot(*p)
    return [c / size for c in p]


def form(name, part, cells, place, comment):
    mesh = Mesh(FIRST)
    known = {}

    def node(grid):
        if grid not in known:
            known[grid] = mesh.node(*place(*grid))
        return known[grid]

    for _, end, _, _, corners in box_faces(cells):
        nodes = [node(grid) for grid in corners]
        mesh.shell(part, *(nodes if end else nodes[::-1]))
    mesh.check_closed(outward=True)
    mesh.node_sets[part] = ("all of the form", list(mesh.nodes))
    mesh.write(MODELS / "impactors" / f"{name}_mesh.k",
               [comment, "The foremost point is the origin, the form flies towards -z; lengths in mm.",
                "Written by tools/models/impactors.py: change it there."])


def headform():
    n = HEAD_CELLS

    def place(i, j, k):
        x, y, z = on_ball(*(2.0 * c / n - 1.0 for c in (i, j, k)))
        return HEAD_RADIUS * x, HEAD_RADIUS * y, HEAD_RADIUS * (1.0 + z)

    form("headform", HEADFORM, (n, n, n), place, "A ball of 165 mm.")


def torso():
    n, strips, half = TORSO_CELLS, TORSO_STRIPS, TORSO_CELLS // 2

    def place(i, j, k):
        u, w = 2.0 * i / n - 1.0, k / half - 1.0
        strip = min(max(j - half, 0), strips)  # of the straight part
        v = 2.0 * (j - strip) / n - 1.0
        if w < 0.0:
            x, y, z = on_ball(u, v, w)
        else:  # the flat back: squares within the rim's, to circles
            inside = max(abs(u), abs(v))
            x, y, z = (inside * c for c in on_ball(u, v, w)) if inside else (0.0, 0.0, 0.0)
        y += TORSO_STRAIGHT / TORSO_RADIUS * (strip / strips - 0.5)
        return TORSO_RADIUS * x, TORSO_RADIUS * y, TORSO_RADIUS * (1.0 + z)

    form("torso", TORSO, (n, n + strips, half), place,
         "Half a cylinder of 300 mm along y, its ends rounded: 500 mm high, 150 mm deep.")
    tell_inertia(TORSO_RADIUS, TORSO_STRAIGHT)


def tell_inertia(R, L):
    """Centre and radii of gyration of a uniform half capsule: half a cylinder and two quarter balls."""
    cylinder, ball = 0.5 * pi * R ** 2 * L, 2.0 / 3.0 * pi * R ** 3
    volume = cylinder + ball
    depth = (cylinder * 4.0 * R / (3.0 * pi) + ball * 3.0 * R / 8.0) / volume  # from the flat back
    across = (cylinder * R ** 2 / 4.0 + ball * R ** 2 / 5.0) / volume          # mean of x², and of z² from the back
    along = (cylinder * L ** 2 / 12.0
             + ball * (R ** 2 / 5.0 + 3.0 * R * L / 8.0 + L ** 2 / 4.0)) / volume
    through = across - depth ** 2
    print(f"torso: centre {R - depth:.6g} mm behind the foremost point, gyration radii squared about "
          f"x, y, z: {along + through:.6g}, {across + through:.6g}, {across + along:.6g} mm2")


if __name__ == "__main__":
    headform()
    torso()
