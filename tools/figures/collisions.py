#!/usr/bin/env python3
# corpuscle: airbag deployment by the corpuscular method
# SPDX-License-Identifier: MIT
"""Figure gas/collision_models.png, from the table of `benchmark_collisions FILE.csv`."""

import csv
import sys

from results import MODELS, plt


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: collisions.py FILE.csv")
    with open(sys.argv[1], newline="") as file:
        rows = list(csv.DictReader(file))
    figure, axes = plt.subplots(1, 2, figsize=(9, 3.6), sharex=True)
    for axis, error in zip(axes, ("density", "pressure")):
        for model in dict.fromkeys(row["model"] for row in rows):
            of_model = [row for row in rows if row["model"] == model]
            axis.loglog([float(row["cpu_seconds"]) for row in of_model],
                        [float(row[error]) for row in of_model], "o-", label=model)
        axis.set(xlabel="CPU time of a run [s]", ylabel=f"L1 error of {error} [-]",
                 title=f"Sod's tube, {error}: 10^4, 10^5, 10^6 particles")
    axes[1].legend()
    path = MODELS.parent / "gas" / "collision_models.png"
    figure.savefig(path, bbox_inches="tight", metadata={"Software": None})
    print(path.relative_to(MODELS.parent))


main()
