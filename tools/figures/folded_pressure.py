#!/usr/bin/env python3
# corpuscle: airbag deployment by the corpuscular method
# SPDX-License-Identifier: MIT
"""Pressure and volume of the folded bag against time, for particle numbers with and without uniform
pressure, run times beside the curves; and how far each run's pressure is from that of the most
particles. usage: folded_pressure.py FOLDER ... (of runs, or of a study's, which holds run_0001 ...)"""

import csv
import json
import sys
from pathlib import Path

import h5py
import numpy as np
from results import plt, save

INSTANTS = (20.0, 30.0)  # [ms]


def runs_in(folder):
    """Folders with results of runs that have ended."""
    within = [folder] if (folder / "results.h5").exists() else sorted(folder.glob("run_*"))
    return [run for run in within if (run / "run.json").exists()]


def asked_for(folder):
    """Particles that a study's run was to have (NP); None of any other run."""
    table = folder.parent / "study.csv"
    if not table.exists():
        return None
    with open(table, newline="") as file:
        points = {f"run_{int(row['run']):04}": row.get("NP") for row in csv.DictReader(file)}
    return int(float(points[folder.name])) if points.get(folder.name) else None


def curves_of(folder):
    with h5py.File(folder / "results.h5") as run:
        bag = run["history/airbag/1"]
        kept = {name: bag[name][:].astype(float) for name in ("pressure", "volume", "particles", "particles_out")}
        time = run["history/time"][:].astype(float)
    # in a bag that has become uniform no particle comes or goes any more
    number = kept["particles"] + kept["particles_out"]
    last = time[np.flatnonzero(np.diff(number))[-1]]
    switch = last if last < time[-1] - 2.0 else np.inf
    wall = json.loads((folder / "run.json").read_text())["wall"]
    return {"time": time, "switch": switch, "wall": wall, "number": asked_for(folder) or int(number.max()), **kept}


def label(run):
    uniform = f"; uniform from {run['switch']:.0f} ms" if np.isfinite(run["switch"]) else ""
    return f"{run['number']:,} particles{uniform}: {run['wall']:.0f} s".replace(",", " ")


def main():
    folders = [run for name in sys.argv[1:] for run in runs_in(Path(name))]
    if not folders:
        sys.exit("usage: " + __doc__.split("usage: ")[1])
    runs = sorted((curves_of(folder) for folder in folders), key=lambda r: (np.round(r["switch"]), r["number"]))
    figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4))
    for run in runs:
        style = "--" if np.isfinite(run["switch"]) else "-"
        left.plot(run["time"], 1e6 * run["pressure"], style, linewidth=0.9, label=label(run))
        right.plot(run["time"], 1e-6 * run["volume"], style)
    left.set(xlabel="time [ms]", ylabel="pressure [kPa]")
    right.set(xlabel="time [ms]", ylabel="volume [l]")
    left.legend(fontsize=7)
    save(figure, "driver_bag_folded", "pressure.png")

    best = max(runs, key=lambda r: (not np.isfinite(r["switch"]), r["number"]))
    print("run" + " " * 47 + "".join(f"p at {t:.0f} ms [kPa]  off by  " for t in INSTANTS))
    for run in runs:
        row = f"{label(run):50s}"
        for t in INSTANTS:
            p, p_best = (np.mean(r["pressure"][np.abs(r["time"] - t) < 0.5]) for r in (run, best))
            row += f"{1e6 * p:14.2f} {100 * (p / p_best - 1):+8.2f} % "
        print(row)


if __name__ == "__main__":
    main()
