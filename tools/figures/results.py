# corpuscle: airbag deployment by the corpuscular method
# SPDX-License-Identifier: MIT
"""What the figures share: reading results.h5 and a quiet look."""

import sys
from pathlib import Path

import h5py
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

MODELS = Path(__file__).resolve().parents[2] / "models"

plt.rcParams.update({
    "figure.dpi": 110, "font.size": 9, "axes.spines.top": False, "axes.spines.right": False,
    "axes.grid": True, "grid.alpha": 0.3, "lines.linewidth": 1.2, "legend.frameon": False,
})


def open_results(usage):
    """The results.h5 files named on the command line, at least one."""
    if len(sys.argv) < 2:
        sys.exit(f"usage: {usage}")
    return [h5py.File(Path(name), "r") for name in sys.argv[1:]]


def frame_at(results, time):
    """The frame nearest to `time`, and its time."""
    times = results["frames/time"][:]
    nearest = int(abs(times - time).argmin())
    return results[f"frames/{nearest:05d}"], float(times[nearest])


def particle_count(results):
    return int(results["history/airbag/1/particles"][:].max())


def save(figure, model, name):
    path = MODELS / model / name
    figure.savefig(path, bbox_inches="tight", metadata={"Software": None})
    print(path.relative_to(MODELS.parent))
