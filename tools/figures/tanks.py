#!/usr/bin/env python3
# corpuscle: airbag deployment by the corpuscular method
# SPDX-License-Identifier: MIT
"""Figures of models/vented_tank, porous_tank and two_chambers, from a results.h5 of each."""

import numpy as np
from results import open_results, plt, save

R = 8.314462618       # [J/(mol K)]
P_ATM = 101325.0      # [Pa]
OPENS = 5e-3          # [s]
VOLUME = 1e-3         # [m^3]
VENT = 0.1 ** 2 / 9   # [m^2]
AIR, HELIUM = (0.028, 28.0), (0.004, 20.79)  # molar mass, molar Cp


def stirred_tank(time, mass, temperature, gases, share):
    """Masses and pressure at the times, by the midpoint rule; share(p, T, masses) leaves a second."""
    M, cp = np.array(gases).T
    state = np.append(mass, (mass / M * (cp - R)).sum() * temperature)

    def seen(state):
        moles = state[:-1] / M
        T = state[-1] / (moles * (cp - R)).sum()
        return moles.sum() * R * T / VOLUME, T

    def rate(state):
        p, T = seen(state)
        out = share(p, T, state[:-1]) * state[:-1]
        return -np.append(out, (out / M * cp).sum() * T)

    rows, now = [], OPENS
    for t in time:
        for _ in range(50):
            dt = (t - now) / 50
            state = state + dt * rate(state + 0.5 * dt * rate(state))
        now = t
        rows.append(np.append(state[:-1], seen(state)[0]))
    return np.array(rows).T


def nozzle(p, T, molar_mass, molar_cp):
    if p <= P_ATM:
        return 0.0
    g = molar_cp / (molar_cp - R)
    Q = max(P_ATM / p, (2 / (g + 1)) ** (g / (g - 1)))
    return p * Q ** (1 / g) * np.sqrt(2 * g / (g - 1) * molar_mass / (R * T) * (1 - Q ** ((g - 1) / g)))


def tank(run, name, gases, labels, share):
    bag, time = run["history/airbag/1"], run["history/time"][:]
    after = time > OPENS
    masses = np.array([bag[f"species/{k + 1}/mass"][:] for k in range(len(gases))])
    start = [np.interp(OPENS, time, m) for m in masses]
    exact = stirred_tank(time[after], np.array(start), np.interp(OPENS, time, bag["temperature"][:]),
                         gases, share)
    figure, (left, right) = plt.subplots(1, 2, figsize=(10, 3.6))
    left.plot(time * 1e3, bag["pressure"][:] / P_ATM, linewidth=0.8, label="particles")
    left.plot(time[after] * 1e3, exact[-1] / P_ATM, "k--", linewidth=0.9, label="stirred tank")
    left.set(xlabel="time [ms]", ylabel="pressure [p_atm]", title=name)
    left.legend()
    for k, label in enumerate(labels):
        error = (masses[k][after] / exact[k] - 1) * 100
        right.plot(time[after] * 1e3, error, label=f"{label}, at worst {abs(error).max():.2f} %")
    right.set(xlabel="time [ms]", ylabel="mass against the equations [%]", ylim=(-2, 2),
              title=f"{int(bag['particles'][:].max())} particles")
    right.legend()
    save(figure, name, f"{name}.png")


def chambers(run):
    bag, time = run["history/airbag/1"], run["history/time"][:]
    figure, axes = plt.subplots(figsize=(6, 3.4))
    late = time >= 2e-3
    for k, label in ((1, "air of 300 K"), (2, "air of 30 K")):
        energy = bag[f"species/{k}/energy"][:][late]
        change = np.abs(energy / energy[0] - 1)
        axes.plot(time[late] * 1e3, change, label=f"{label}, at worst {change.max():.1g}")
    axes.axhline(1e-12, color="k", linestyle="--", linewidth=0.8, label="allowed")
    axes.set(xlabel="time [ms]", ylabel="energy, relative change", yscale="log", ylim=(1e-17, 1e-11))
    axes.legend()
    save(figure, "two_chambers", "two_chambers.png")


def main():
    for run in open_results("tanks.py RESULTS.h5 ..."):
        deck = str(run.attrs["deck"])
        if "vented_tank" in deck:
            tank(run, "vented_tank", [AIR], ["air"],
                 lambda p, T, m: VENT * nozzle(p, T, *AIR) / m.sum())
        elif "porous_tank" in deck:
            tank(run, "porous_tank", [AIR, HELIUM], ["air", "helium"],
                 lambda p, T, m: 0.06 * 0.1 * 60 * np.clip((p / P_ATM - 1) / 4, 0, 1) / VOLUME)
        else:
            chambers(run)


if __name__ == "__main__":
    main()
