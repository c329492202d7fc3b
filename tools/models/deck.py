# corpuscle: airbag deployment by the corpuscular method
# SPDX-License-Identifier: MIT
"""Writes meshes as LS-DYNA keyword cards: fixed columns, the same bytes on every machine."""

from math import dist, hypot
from pathlib import Path

MODELS = Path(__file__).resolve().parents[2] / "models"


def box_faces(cells):
    """The faces of a box's grid of `cells` along each axis: (axis, end, i, j, four grid points).

    Their normals look along the axis: inward where end is 0."""
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        for end in (0, cells[axis]):
            for i in range(cells[u]):
                for j in range(cells[v]):
                    corners = []
                    for di, dj in ((0, 0), (1, 0), (1, 1), (0, 1)):
                        grid = [0, 0, 0]
                        grid[axis], grid[u], grid[v] = end, i + di, j + dj
                        corners.append(tuple(grid))
                    yield axis, end, i, j, corners


class Mesh:
    """Nodes, shells and node sets under the ids that the deck will use, nodes and shells from `first` on."""

    def __init__(self, first=1):
        self.first = first
        self.nodes = {}      # id -> (x, y, z)
        self.shells = {}     # id -> (part, (n1, n2, n3) or (n1, n2, n3, n4))
        self.vectors = {}    # id -> (tail, head)
        self.node_sets = {}  # id -> (title, [node ids])

    def node(self, x, y, z, number=None):
        """Adds a node under `number`, by default the next free one."""
        number = number or self.first + len(self.nodes)
        assert number not in self.nodes, f"node {number} is defined twice"
        self.nodes[number] = tuple(round(c, 9) + 0.0 for c in (x, y, z))  # no 1e-17, no -0
        return number

    def shell(self, part, *corners):
        """Adds a triangle or quad of `part`; its normal follows the corners' right-hand rule."""
        assert len(corners) in (3, 4) and len(set(corners)) == len(corners)
        self.shells[self.first + len(self.shells)] = (part, corners)

    def volume(self):
        """Volume enclosed by the shells, positive when their normals point inward."""
        total = 0.0
        for _, corners in self.shells.values():
            for a, b in zip(corners[1:], corners[2:]):
                total -= _determinant(*(self.nodes[n] for n in (corners[0], a, b))) / 6.0
        return total

    def smallest_height(self):
        """Least of twice a shell's area over its longest edge (a quad: area over it)."""
        least = float("inf")
        for _, corners in self.shells.values():
            x = [self.nodes[n] for n in corners]
            edges = [dist(a, b) for a, b in zip(x, x[1:] + x[:1])]
            p, q = (x[1], x[2]) if len(x) == 3 else (x[2], x[3])
            o, r = (x[0], x[0]) if len(x) == 3 else (x[0], x[1])
            spread = _cross([a - b for a, b in zip(p, o)], [a - b for a, b in zip(q, r)])
            area = 0.5 * hypot(*spread)
            least = min(least, (2.0 if len(x) == 3 else 1.0) * area / max(edges))
        return least

    def check_closed(self, outward=False):
        """Every edge is run through once in each direction: closed, and oriented one way, inward or outward."""
        edges = set()
        for _, corners in self.shells.values():
            for edge in zip(corners, corners[1:] + corners[:1]):
                assert edge not in edges, f"edge {edge} is run through twice in one direction"
                edges.add(edge)
        assert all((b, a) in edges for a, b in edges), "the surface has a free edge"
        assert (self.volume() < 0.0) == outward, "the normals point the other way"

    def write(self, path, comment):
        lines = [f"$ {line}" for line in comment] + ["*KEYWORD", "*NODE"]
        lines += [f"{n:8d}{x:16.8g}{y:16.8g}{z:16.8g}" for n, (x, y, z) in self.nodes.items()]
        lines.append("*ELEMENT_SHELL")
        for number, (part, corners) in self.shells.items():
            quad = corners + corners[-1:] * (4 - len(corners))  # a triangle repeats its third node
            lines.append("".join(f"{n:8d}" for n in (number, part, *quad)))
        for number, (title, nodes) in self.node_sets.items():
            lines += ["*SET_NODE_LIST_TITLE", title, f"{number:10d}"]
            lines += ["".join(f"{n:10d}" for n in nodes[i:i + 8]) for i in range(0, len(nodes), 8)]
        for number, (tail, head) in self.vectors.items():
            ends = "".join(f"{c:10.6f}" for c in (*tail, *head))
            lines += ["*DEFINE_VECTOR", f"{number:10d}{ends}"]
        lines.append("*END")
        path.write_text("\n".join(lines) + "\n", newline="\n")
        triangles = sum(len(corners) == 3 for _, corners in self.shells.values())
        print(f"{path.relative_to(MODELS.parent)}: {len(self.nodes)} nodes, {len(self.shells)} "
              f"shells ({triangles} triangles), volume {self.volume():.6g}, "
              f"smallest height {self.smallest_height():.4g}")


def _cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def _determinant(a, b, c):
    return sum(p * q for p, q in zip(a, _cross(b, c)))
