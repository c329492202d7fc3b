#!/usr/bin/env python3
# corpuscle: airbag deployment by the corpuscular method
# SPDX-License-Identifier: MIT
"""Figure of models/fast_piston: pressure on the piston against the 1-D Euler equations.

Takes one or more results.h5, and Euler's pressure from standard input:
    euler_1d_csv | fast_piston.py RESULTS.h5 [RESULTS.h5 ...]
"""

import sys

import numpy as np
from results import open_results, particle_count, plt, save

START, STOP, BIN = 5.0, 9.0, 0.05   # [ms]


def binned(time, pressure):
    """Means over bins: a sample is the mean since the sample before it."""
    edges = np.arange(START - 1.0, STOP + BIN / 2, BIN)
    impulse = np.concatenate(([0.0], np.cumsum(pressure[1:] * np.diff(time))))
    return edges[:-1] + BIN / 2, np.diff(np.interp(edges, time, impulse)) / BIN


def main():
    runs = open_results("euler_1d_csv | fast_piston.py RESULTS.h5 ...")
    time, pressure = np.loadtxt(sys.stdin, delimiter=",", skiprows=1, unpack=True)
    figure, axes = plt.subplots(figsize=(7, 4))
    for run in runs:
        when = run["history/time"][:] * 1e3
        on_piston = run["history/airbag/1/part/2/pressure"][:] * 1e-3
        axes.plot(*binned(when, on_piston), label=f"corpuscle, {particle_count(run)} particles")
    axes.plot(time * 1e3, pressure * 1e-3, "k--", linewidth=1.0, label="1-D Euler equations")
    axes.axhline(17.95, color="tab:gray", linestyle=":", linewidth=0.8)
    axes.annotate("simple wave, 17.95 kPa", (6.4, 18.5), color="tab:gray")
    axes.set(xlim=(START - 1.0, STOP), ylim=(0.0, 130.0), xlabel="time [ms]",
             ylabel="pressure on the piston [kPa]", title="A piston that runs at 400 m/s")
    axes.legend()
    save(figure, "fast_piston", "fast_piston.png")


if __name__ == "__main__":
    main()
