"""Draws the pictures of this example's runs; of a run event by event also the paths of both cracks.

usage: /usr/bin/python3 examples/two_edge_cracks/plot.py [FOLDER] [RUN...]
"""

import csv
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import crack_plots
import numpy as np
import plotting

plt = plotting.plt
SIDE, SPACING, TIP, HALF_OFFSET = 50.0, 0.5, 2.0, 1.0  # mm
COLOURS = {1: plotting.CURVE, 2: plotting.MARK}


def read_path(file):
    """Middles of the broken bonds [mm] by the tip from which they grew, in the order of breaking."""
    with open(file, newline="") as rows:
        table = [(int(row["tip"]), 1e3 * float(row["x"]), 1e3 * float(row["y"]) - SIDE / 2) for row in csv.DictReader(rows)]
    return {tip: np.array([(x, y) for number, x, y in table if number == tip]) for tip in (1, 2)}


def mean_path(broken):
    """Mean height of the broken bonds in each column of points, where there are some."""
    columns = np.arange(SPACING / 2, SIDE, SPACING)
    heights = [broken[np.abs(broken[:, 0] - x) < SPACING / 2, 1] for x in columns]
    return np.array([(x, found.mean()) for x, found in zip(columns, heights) if len(found)])


def draw_paths(folder, run):
    """The torn plate, and the paths of both cracks with their heights stretched."""
    last = plotting.read_series(folder / f"{run}.pvd")[-1]
    paths = read_path(folder / f"path_{run}.csv")
    with plt.rc_context(plotting.STYLE):
        figure, (plate, near) = plt.subplots(1, 2, figsize=(8.4, 3.4), width_ratios=[1, 1.5], layout="constrained")
        cells = plotting.draw_stage(plate, last, 0, 1e-3, None, 0.5)
        figure.colorbar(cells, ax=plate, shrink=0.8, label="damage [-]")
        plate.set(xlabel="x [mm]", ylabel="y [mm]", title="the cracks have met")
        for tip, broken in paths.items():
            left = tip == 1
            side, sign = (0.0, 1) if left else (SIDE, -1)
            start = -HALF_OFFSET if left else HALF_OFFSET
            near.plot(*broken.T, ".", color=COLOURS[tip], markersize=1.5, alpha=0.25)
            near.plot([side, side + sign * TIP], [start, start], color="black", linewidth=2)
            near.plot(*mean_path(broken).T, color=COLOURS[tip], linewidth=1.6, label="left crack" if left else "right crack")
        near.axhline(0, color=plotting.BODY_EDGE, linewidth=0.6, linestyle="--")
        near.set(xlim=(0, SIDE), ylim=(-4, 4), xlabel="x [mm]", ylabel="height over the middle [mm]",
                 title="paths: mean of the broken bonds (dots) in each column")
        near.legend(loc="lower right")
        target = folder / f"paths_{run}.png"
        figure.savefig(target, dpi=150)
        plt.close(figure)
    print(f"wrote {target}")


crack_plots.draw(
    "two_edge_cracks",
    load=0.1e6,
    load_label="traction",
    load_unit="Pa",
    # The shape is not deformed: nothing resists the load in the end, so displacements would hide the paths.
    magnification=0,
)
chosen = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "out/two_edge_cracks")
for events in sorted(chosen.glob("path_events_*.csv")):
    draw_paths(chosen, events.stem.removeprefix("path_"))
