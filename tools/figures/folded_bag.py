#!/usr/bin/env python3
# corpuscle: airbag deployment by the corpuscular method
# SPDX-License-Identifier: MIT
"""Figure of models/driver_bag_folded: the bag as it leaves its housing. usage: folded_bag.py RESULTS.h5"""

import numpy as np
from mpl_toolkits.mplot3d.art3d import Poly3DCollection
from results import open_results, plt, save

INSTANTS = (0.0, 3.0, 6.0, 10.0, 15.0, 20.0, 30.0)  # [ms], as far as the run goes
HOUSING = 7
LIGHT = np.array([-0.4, -0.5, 0.77])
CLOTH = np.array([0.93, 0.91, 0.86])


def draw(axes, x, shells):
    corners = x[shells]
    normal = np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
    normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-12)
    shade = 0.45 + 0.55 * np.abs(normal @ LIGHT)
    axes.add_collection3d(Poly3DCollection(
        corners, facecolors=np.clip(shade[:, None] * CLOTH, 0.0, 1.0), edgecolors=(0, 0, 0, 0.15),
        linewidths=0.1))


def main():
    run = open_results(__doc__.split('usage: ')[1])[0]
    times = run["frames/time"][:]
    shells = run["mesh/shell_nodes"][:][run["mesh/shell_part"][:] != HOUSING]
    instants = [t for t in INSTANTS if t <= times[-1] * (1 + 1e-6)]
    last = run[f"frames/{int(np.abs(times - instants[-1]).argmin()):05d}/coordinates"][:]
    half = max(100.0, np.abs(last[:, :2]).max(), 0.5 * last[:, 2].max() + 15.0)
    figure = plt.figure(figsize=(2.6 * len(instants), 3.2))
    for i, t in enumerate(instants):
        axes = figure.add_subplot(1, len(instants), i + 1, projection="3d")
        frame = int(np.abs(times - t).argmin())
        draw(axes, run[f"frames/{frame:05d}/coordinates"][:].astype(float), shells)
        axes.set(xlim=(-half, half), ylim=(-half, half), zlim=(-30, 2 * half - 30),
                 title=f"{times[frame]:.1f} ms")
        axes.set_box_aspect((1, 1, 1), zoom=1.45)
        axes.view_init(15, -60)
        axes.set_axis_off()
    save(figure, "driver_bag_folded", "driver_bag_folded.png")


main()
