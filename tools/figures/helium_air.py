#!/usr/bin/env python3
# corpuscle: airbag deployment by the corpuscular method
# SPDX-License-Identifier: MIT
"""Figure of models/helium_air: pressure over time, and the speeds of both gases at 10 ms."""

import numpy as np
from results import frame_at, open_results, plt, save

R = 8.314462618       # [J/(mol K)]
EXACT = 92.06         # as the notes give it [kPa]
TEMPERATURE = 300.0   # [K]
GASES = ((1, "air", 0.028, "tab:blue"), (2, "helium", 0.003, "tab:orange"))


def maxwell_boltzmann(speed, molar_mass):
    """Equation 26 of the notes."""
    a = molar_mass / (2.0 * R * TEMPERATURE)
    return 4.0 * np.pi * (a / np.pi) ** 1.5 * speed ** 2 * np.exp(-a * speed ** 2)


def main():
    run = open_results("helium_air.py RESULTS.h5")[0]
    figure, (left, right) = plt.subplots(1, 2, figsize=(10, 3.6))

    time = run["history/time"][:] * 1e3
    wall = run["history/airbag/1/part/1/pressure"][:] * 1e-3
    left.plot(time, wall, color="tab:gray", linewidth=0.6, label="impulse on the walls, each 20 µs")
    left.plot(time, run["history/airbag/1/pressure"][:] * 1e-3, label="2/3 translational energy / V")
    left.axhline(EXACT, color="k", linestyle="--", linewidth=0.8, label=f"nRT/V = {EXACT} kPa")
    late = wall[time >= 5.0]
    left.set(xlabel="time [ms]", ylabel="pressure [kPa]",
             title=f"mean on the walls, 5 to 20 ms: {late.mean():.2f} kPa")
    left.legend()

    frame, at = frame_at(run, 10e-3)
    species = frame["particles/species"][:]
    speeds = np.linalg.norm(frame["particles/velocity"][:], axis=1)
    for number, name, molar_mass, colour in GASES:
        own = speeds[species == number]
        line = np.linspace(0.0, 4.0 * np.sqrt(R * TEMPERATURE / molar_mass), 400)
        right.hist(own, bins=40, density=True, color=colour, alpha=0.4,
                   label=f"{name}, {len(own)} particles")
        right.plot(line, maxwell_boltzmann(line, molar_mass), color=colour)
    right.set(xlabel="speed [m/s]", ylabel="density [s/m]",
              title=f"speeds at {at * 1e3:.0f} ms and Maxwell-Boltzmann at 300 K")
    right.legend()
    save(figure, "helium_air", "helium_air.png")


if __name__ == "__main__":
    main()
