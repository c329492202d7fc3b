#!/usr/bin/env python3
# corpuscle: airbag deployment by the corpuscular method
# SPDX-License-Identifier: MIT
"""Writes the meshes of models/verification: discs, squares, a tube and a sphere of cloth, strips.

A mesh of n cells is mesh_n.k of its case; case_n.k, the deck, includes it and the case's scene.k."""

from math import atan, cos, pi, sin, sqrt
from random import Random

from deck import MODELS, Mesh

CASES = MODELS / "verification"
RIM, ACROSS_X, ACROSS_Y = 1, 2, 3  # node sets: held edge, mirrors x = 0 and y = 0
EPSILON = 1e-9


class Sheet(Mesh):
    """A mesh whose nodes of one place are one."""

    def __init__(self):
        super().__init__()
        self.known = {}

    def at(self, x, y, z=0.0):
        key = tuple(round(c * 1e7) for c in (x, y, z))
        if key not in self.known:
            self.known[key] = self.node(x, y, z)
        return self.known[key]

    def cell(self, is_cut, is_odd, a, b, c, d):
        """A quad, or two triangles whose diagonal alternates."""
        if not is_cut:
            self.shell(1, a, b, c, d)
        elif is_odd:
            self.shell(1, a, b, c)
            self.shell(1, a, c, d)
        else:
            self.shell(1, a, b, d)
            self.shell(1, b, c, d)

    def block(self, n, is_cut, point):
        for j in range(n):
            for i in range(n):
                corners = [self.at(*point((i + k) / n, (j + l) / n))
                           for k, l in ((0, 0), (1, 0), (1, 1), (0, 1))]
                self.cell(is_cut, (i + j) % 2 == 0, *corners)

    def mirrors(self, is_rim):
        """Sets of the nodes of the held edge and of both mirrors."""
        for number, title, holds in ((RIM, "edge", is_rim),
                                     (ACROSS_X, "mirror x = 0", lambda x, y: abs(x) < EPSILON),
                                     (ACROSS_Y, "mirror y = 0", lambda x, y: abs(y) < EPSILON)):
            self.node_sets[number] = (title, [n for n, (x, y, _) in self.nodes.items() if holds(x, y)])


def quarter_disc(n, radius, is_cut):
    """x >= 0, y >= 0 of a disc: a bulged square at the middle and two blocks that reach to the rim."""
    mesh = Sheet()
    middle, corner, eighth = 0.5 * radius, 0.43 * radius, atan(1.0)

    def square(u, v):
        return u * (middle + v * (corner - middle)), v * (middle + u * (corner - middle))

    def outward(inner, angle, s):
        return tuple((1 - s) * c + s * radius * e for c, e in zip(inner, (cos(angle), sin(angle))))

    mesh.block(n, is_cut, square)
    mesh.block(n, is_cut, lambda s, v: outward(square(1, v), v * eighth, s))
    mesh.block(n, is_cut, lambda u, s: outward(square(u, 1), 2 * eighth - u * eighth, s))
    mesh.mirrors(lambda x, y: x * x + y * y > (radius * (1 - 1e-6)) ** 2)
    return mesh


def quarter_square(n, half):
    mesh = Sheet()
    mesh.block(n, False, lambda u, v: (half * u, half * v))
    mesh.mirrors(lambda x, y: max(x, y) > half * (1 - 1e-6))
    return mesh


def ring(n, radius):
    """Two cells of a long tube along z, n around; sets: lower rim, upper rim."""
    mesh = Sheet()
    width = 2 * pi * radius / n
    rows = [[mesh.at(radius * cos(2 * pi * i / n), radius * sin(2 * pi * i / n), width * j)
             for i in range(n)] for j in range(3)]
    for low, high in zip(rows, rows[1:]):
        for i in range(n):
            k = (i + 1) % n
            mesh.shell(1, low[i], low[k], high[k], high[i])
    mesh.node_sets[1] = ("lower rim", rows[0])
    mesh.node_sets[2] = ("upper rim", rows[2])
    return mesh


def patch(n, side):
    """n x n quads of a square, inner nodes off their grid; sets: edge; reference: the same places under ids + 1000."""
    mesh = Sheet()
    shifts = Random(7)

    def place(u, v):
        is_edge = min(u, v) < EPSILON or max(u, v) > 1 - EPSILON
        if (u, v) not in moved:
            moved[u, v] = (0.0, 0.0) if is_edge else tuple(0.25 * (2 * shifts.random() - 1) / n for _ in "xy")
        return tuple(side * (c + d) for c, d in zip((u, v), moved[u, v]))

    moved = {}
    mesh.block(n, False, place)
    edge = lambda c: min(c) < EPSILON or max(c) > side - EPSILON
    mesh.node_sets[RIM] = ("edge", [n for n, (x, y, _) in mesh.nodes.items() if edge((x, y))])
    return mesh


def strip(n, length, width):
    """n quads along x; sets: ends, the rest."""
    mesh = Sheet()
    for i in range(n):
        corners = [mesh.at(length * (i + k) / n, width * l) for k, l in ((0, 0), (1, 0), (1, 1), (0, 1))]
        mesh.shell(1, *corners)
    is_end = lambda x: x < EPSILON or x > length - EPSILON
    for number, title, holds in ((1, "ends", is_end), (2, "between", lambda x: not is_end(x))):
        mesh.node_sets[number] = (title, [n for n, (x, _, _) in mesh.nodes.items() if holds(x)])
    return mesh


def belt(n, radius, length, width):
    """A strip over the upper half of a rod along y, n quads around, and down `length` on both sides, at x = -radius
    and x = radius; sets: the end that is pulled, the end that hangs."""
    mesh = Sheet()
    edge = pi * radius / n
    down = round(length / edge)

    def place(i):
        if i < down:
            return -radius, -edge * (down - i)
        if i > down + n:
            return radius, -edge * (i - down - n)
        angle = pi * (i - down) / n
        return -radius * cos(angle), radius * sin(angle)

    rows = [[mesh.at(x, width * l, z) for l in (0, 1)] for x, z in map(place, range(2 * down + n + 1))]
    for (a, b), (d, c) in zip(rows, rows[1:]):
        mesh.shell(1, a, d, c, b)
    mesh.node_sets[1] = ("the end that is pulled", rows[-1])
    mesh.node_sets[2] = ("the end that hangs", rows[0])
    return mesh


def sphere(level, radius, squeeze=1.0, centre=(0.0, 0.0, 0.0)):
    """An icosahedron whose triangles are cut in four `level` times; normals outward; z times `squeeze`."""
    golden = (1 + sqrt(5)) / 2
    corners = [(-1, golden, 0), (1, golden, 0), (-1, -golden, 0), (1, -golden, 0),
               (0, -1, golden), (0, 1, golden), (0, -1, -golden), (0, 1, -golden),
               (golden, 0, -1), (golden, 0, 1), (-golden, 0, -1), (-golden, 0, 1)]
    faces = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4),
             (11, 10, 2), (10, 7, 6), (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8),
             (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1)]

    def lifted(p):
        return tuple(c / sqrt(sum(q * q for q in p)) for c in p)

    triangles = [tuple(lifted(corners[k]) for k in face) for face in faces]
    for _ in range(level):
        cut = []
        for a, b, c in triangles:
            ab, bc, ca = (lifted(tuple((p + q) / 2 for p, q in zip(u, v)))
                          for u, v in ((a, b), (b, c), (c, a)))
            cut += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
        triangles = cut
    mesh = Sheet()
    for face in triangles:
        mesh.shell(1, *(mesh.at(*(m + radius * s * c for m, s, c in zip(centre, (1, 1, squeeze), p)))
                        for p in face))
    return mesh


def sphere_with_vents(level, radius):
    """A sphere; part 2: what is round the corners of its icosahedron, 3 of 16 triangles; sets: mirrors, all with the
    orifice."""
    mesh = sphere(level, radius)
    coarse = sphere(2, radius)
    degree = {}
    for _, corners in coarse.shells.values():
        for n in corners:
            degree[n] = degree.get(n, 0) + 1
    tips = [n for n in degree if degree[n] == 5]
    middle = lambda of, corners: tuple(sum(of.nodes[n][k] for n in corners) for k in range(3))
    ends = [middle(coarse, corners) for _, corners in coarse.shells.values()]
    is_vent = [any(n in tips for n in corners) for _, corners in coarse.shells.values()]
    for number, (_, corners) in mesh.shells.items():
        here = middle(mesh, corners)
        nearest = min(range(len(ends)), key=lambda k: sum((a - b) ** 2 for a, b in zip(ends[k], here)))
        mesh.shells[number] = (2 if is_vent[nearest] else 1, corners)
    mesh.node(0.0, 0.0, 0.0, 100000)
    for k, title in enumerate(("mirror x = 0", "mirror y = 0", "mirror z = 0")):
        mesh.node_sets[k + 1] = (title, [n for n, at in mesh.nodes.items() if abs(at[k]) < EPSILON])
    return mesh


def write(case, n, mesh, what):
    mesh.write(CASES / case / f"mesh_{n}.k",
               [what, "Written by tools/models/verification.py: change it there."])


def main():
    for n in (5, 10, 20):
        what = f"A quarter of a disc of 0.1 m, 3 x {n} x {n} "
        write("hencky", n, quarter_disc(n, 0.1, False), what + "quads; lengths in m.")
        write("hencky_triangles", n, quarter_disc(n, 0.1, True), what + "cells of two triangles; lengths in m.")
    for n in (8, 16, 32):
        write("square_bag", n, quarter_square(n, 0.42425),
              f"A quarter of a square of 0.8485 m, {n} x {n} quads; lengths in m.")
    for n in (24, 48, 96):
        write("tube_vessel", n, ring(n, 0.1), f"Two cells of a tube of radius 0.1 m, {n} around; lengths in m.")
    for level in (2, 3, 4):
        write("sphere_vessel", level, sphere(level, 0.1),
              f"A sphere of radius 0.1 m, 20 x 4^{level} triangles; lengths in m.")
    for level in (2, 3):
        write("spinning_bag", level, sphere(level, 0.1, squeeze=0.7),
              f"A ball of radius 0.1 m, flattened to 0.7 of it, 20 x 4^{level} triangles; lengths in m.")
    for level in (2, 3):
        write("vented_bag", level, sphere_with_vents(level, 0.25),
              f"A sphere of radius 0.25 m, 20 x 4^{level} triangles, vents (part 2), an orifice in the middle; lengths in m.")
    for n in (16, 32, 64):
        write("capstan", n, belt(n, 0.05, 0.1, 0.02),
              f"A strip of 0.02 m over a rod of radius 0.05 m, {n} quads around its half; lengths in m.")
    mesh = patch(4, 0.1)
    write("patch_warp", 4, mesh, "A square of 0.1 m, 4 x 4 irregular quads; lengths in m.")
    lines = ["$ The places of mesh_4.k, where the cloth is without stress.",
             "$ Written by tools/models/verification.py: change it there.", "*AIRBAG_REFERENCE_GEOMETRY"]
    lines += [f"{n:8d}{x:16.8g}{y:16.8g}{z:16.8g}" for n, (x, y, z) in mesh.nodes.items()]
    (CASES / "patch_warp" / "reference_4.k").write_text("\n".join(lines + ["*END"]) + "\n", newline="\n")
    for n in (8, 16, 32):
        mesh = strip(n, 1.0, 0.1)
        write("shear_wave", n, mesh, f"A strip of 1 x 0.1 m, {n} quads along; lengths in m.")
        lines = ["$ v = 1 mm/s sin(pi x / 1 m) across the strip.",
                 "$ Written by tools/models/verification.py: change it there.", "*INITIAL_VELOCITY_NODE"]
        lines += [f"{k}, 0.0, {1e-3 * sin(pi * x):.10g}, 0.0" for k, (x, _, _) in mesh.nodes.items()]
        (CASES / "shear_wave" / f"start_{n}.k").write_text("\n".join(lines + ["*END"]) + "\n", newline="\n")


if __name__ == "__main__":
    main()
