#!/usr/bin/env python3
# corpuscle: airbag deployment by the corpuscular method
# SPDX-License-Identifier: MIT
"""Figures of models/driver_bag_flat: the bag and its gas at five instants, and its volume and pressure."""

import numpy as np
from mpl_toolkits.mplot3d.art3d import Poly3DCollection
from results import frame_at, open_results, plt, save

INSTANTS = (0.0, 5.0, 10.0, 20.0, 40.0)   # [ms]
SHOWN = 6000                              # particles in a picture
P_ATM = 101.325                           # [kPa]
LIGHT = np.array([-0.4, -0.5, 0.77])
CLOTH = np.array([0.93, 0.91, 0.86])


def cut_open(axes, x, quads):
    """The half of the bag behind the plane y = 0, shaded by its normals."""
    corners = x[quads]
    corners = corners[corners[:, :, 1].mean(axis=1) > 0.0]
    normal = np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
    normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-12)
    shade = 0.45 + 0.55 * np.abs(normal @ LIGHT)
    axes.add_collection3d(Poly3DCollection(
        corners, facecolors=np.clip(shade[:, None] * CLOTH, 0.0, 1.0), edgecolors=(0, 0, 0, 0.12),
        linewidths=0.15))


def gas(axes, frame, colours):
    if "particles" not in frame or len(frame["particles/id"]) == 0:
        return
    x = frame["particles/position"][:]
    v = np.linalg.norm(frame["particles/velocity"][:], axis=1)
    chosen = np.flatnonzero(x[:, 1] > 0.0)
    chosen = chosen[:: max(1, len(chosen) // SHOWN)]
    axes.scatter(*x[chosen].T, c=v[chosen], s=0.8, cmap="plasma", norm=colours, linewidths=0,
                 depthshade=False)


def strip(run):
    quads = run["mesh/shell_nodes"][:]
    figure = plt.figure(figsize=(18, 4.2))
    colours = plt.Normalize(0.0, 1500.0)
    for i, instant in enumerate(INSTANTS):
        frame, at = frame_at(run, instant)
        axes = figure.add_subplot(1, len(INSTANTS), i + 1, projection="3d", computed_zorder=False)
        cut_open(axes, frame["coordinates"][:].astype(float), quads)
        gas(axes, frame, colours)
        axes.set(xlim=(-370, 370), ylim=(-370, 370), zlim=(-60, 500), title=f"{at:.0f} ms")
        axes.set_box_aspect((740, 740, 560), zoom=1.75)
        axes.view_init(elev=16, azim=-80)
        axes.set_axis_off()
    figure.subplots_adjust(0, 0, 1, 0.95, 0, 0)
    scale = plt.cm.ScalarMappable(colours, "plasma")
    figure.colorbar(scale, ax=figure.axes, shrink=0.6, pad=0.01, label="particle speed [m/s]")
    save(figure, "driver_bag_flat", "driver_bag_flat.png")


def curves(run):
    figure, axes = plt.subplots(1, 2, figsize=(9, 3))
    time = run["history/time"][:]
    axes[0].plot(time, run["history/airbag/1/volume"][:] * 1e-6)
    axes[0].set(xlabel="time [ms]", ylabel="volume [l]")
    axes[1].plot(time, run["history/airbag/1/pressure"][:] * 1e6 - P_ATM)
    axes[1].set(xlabel="time [ms]", ylabel="gauge pressure [kPa]")
    save(figure, "driver_bag_flat", "curves.png")


def main():
    run = open_results("driver_bag.py RESULTS.h5")[0]
    strip(run)
    curves(run)


if __name__ == "__main__":
    main()
