#!/usr/bin/env python3
# corpuscle: airbag deployment by the corpuscular method
# SPDX-License-Identifier: MIT
"""Figure of models/two_inflators: temperatures of both gases, and speeds before and after mixing."""

import numpy as np
from results import frame_at, open_results, plt, save

R = 8.314462618      # [J/(mol K)]
MOLAR_MASS = 0.028   # of both gases [kg/mol]
GASES = ((1, "hot air", 300.0, "tab:red"), (2, "cold air", 30.0, "tab:blue"))
MIXED = 165.0        # [K]
OPENS = 2.0          # [ms]


def maxwell_boltzmann(speed, temperature):
    """Equation 26 of the notes."""
    a = MOLAR_MASS / (2.0 * R * temperature)
    return 4.0 * np.pi * (a / np.pi) ** 1.5 * speed ** 2 * np.exp(-a * speed ** 2)


def draw_speeds(axes, run, time, lines):
    frame, at = frame_at(run, time)
    species = frame["particles/species"][:]
    speeds = np.linalg.norm(frame["particles/velocity"][:], axis=1)
    bins = np.linspace(0.0, 1200.0, 61)
    for number, name, _, colour in GASES:
        axes.hist(speeds[species == number], bins=bins, density=True, color=colour, alpha=0.4, label=name)
    v = np.linspace(0.0, 1200.0, 400)
    for temperature, colour in lines:
        axes.plot(v, maxwell_boltzmann(v, temperature), color=colour, label=f"{temperature:.0f} K")
    axes.set(xlabel="speed [m/s]", ylabel="density [s/m]", title=f"speeds at {at * 1e3:.3g} ms")
    axes.legend()


def main():
    run = open_results("two_inflators.py RESULTS.h5")[0]
    figure, (left, middle, right) = plt.subplots(1, 3, figsize=(12, 3.4))
    time = run["history/time"][:] * 1e3
    for number, name, _, colour in GASES:
        temperature = run[f"history/airbag/1/species/{number}/temperature"][:]
        left.plot(time[1:], temperature[1:], color=colour, label=name)
    left.axvline(OPENS, color="k", linestyle=":", linewidth=0.8)
    left.axhline(MIXED, color="k", linestyle="--", linewidth=0.8)
    left.set(xscale="log", xlabel="time [ms]", ylabel="temperature [K]",
             title="the valve opens at 2 ms")
    left.legend()
    draw_speeds(middle, run, 1.8e-3, [(t, c) for _, _, t, c in GASES])
    draw_speeds(right, run, 100e-3, [(MIXED, "k")])
    save(figure, "two_inflators", "two_inflators.png")


if __name__ == "__main__":
    main()
