"""The lap with its cracks at the end, the a-N curve, and the lives of the materials; a film of the growth."""

from __future__ import annotations

import pathlib

import bempd
import numpy as np


def draw(model: bempd.Model, life: bempd.FatigueLife, lives: np.ndarray, folder: pathlib.Path) -> None:
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    from main import HOLES, PITCH, RADIUS

    figure, (body, growth, scatter) = plt.subplots(1, 3, figsize=(11, 3.4), layout="constrained", width_ratios=(1.3, 1, 1))
    for x in HOLES:
        body.add_patch(plt.Circle((1e3 * x, 0), 1e3 * RADIUS, fill=False))
    for crack in range(1, model.crack_count() + 1):
        path = np.array([(vertex.x, vertex.y) for vertex in model.crack_path(crack)])
        body.plot(1e3 * path[:, 0], 1e3 * path[:, 1], label=f"crack {crack}")
    body.set(aspect="equal", xlim=(-1.5e3 * PITCH, 1.5e3 * PITCH), ylim=(-10, 12), xlabel="x [mm]", ylabel="y [mm]", title="cracks at the end")
    for crack in np.unique(life.table["crack"]):
        rows = life.table[life.table["crack"] == crack]
        growth.plot(1e-3 * rows["cycles"], 1e3 * rows["length"], "o-", markersize=3, label=f"crack {crack}")
    growth.axvline(1e-3 * (life.cycles - 2 * life.interval), color="0.6", linestyle=":")
    growth.set(xlabel="1,000 cycles", ylabel="length [mm]", title="a-N curve")
    growth.legend(frameon=False)
    order = np.sort(lives)
    scatter.plot(1e-3 * order, (np.arange(len(order)) + 0.5) / len(order), "o", markersize=3)
    scatter.set(xlabel="life [1,000 cycles]", ylabel="share of the materials", title="scatter of C and m")
    figure.savefig(folder / "crack_life.png", dpi=110)


def film(model: bempd.Model, spectrum: dict[str, list[float]], path: pathlib.Path) -> bempd.FatigueLife:
    """The lap in each step of its life, with the stress along the pull."""
    import bempd.plot as plot

    with plot.Movie(path, model, "stress yy", limits=(0, 400e6), magnification=20, frames_per_second=4) as movie:
        life = model.grow_fatigue(**spectrum, most_steps=1)
        movie.add_frame()
        while life.stop_reason == bempd.FatigueStop.STEPS:
            life = model.grow_fatigue(**spectrum, most_steps=1, first_cycle=life.cycles)
            movie.add_frame()
    return life
