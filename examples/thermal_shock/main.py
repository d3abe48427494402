"""Cools one edge of a hot plate until an array of cracks grows from it.

usage: main.py [--short] [FOLDER]      --short: a coarse lattice and no pictures, as a test; FOLDER: out/thermal_shock
"""

from __future__ import annotations

import argparse
import csv
import math
import pathlib

import bempd
import numpy as np

WIDTH, HEIGHT = 48e-3, 12e-3
YOUNG, RATIO, ENERGY, EXPANSION = 370e9, 1 / 3, 24.3, 7.5e-6  # alumina
DEPTH = 2.5e-3  # of the cold: sqrt(4 kappa t)


def build(spacing: float) -> tuple[bempd.Model, int]:
    """The lower edge is one degree colder per load factor, and the plate inside as heat flows into a half plane whose edge is
    suddenly cold (H. S. Carslaw and J. C. Jaeger, Conduction of Heat in Solids, art. 2.4)."""
    model = bempd.Model()
    alumina = model.add_material(young_modulus=YOUNG, poisson_ratio=RATIO, fracture_energy=ENERGY, thickness=1e-3,
                                 thermal_expansion=EXPANSION)
    plate = model.add_pd_region(alumina, bempd.rectangle(0, 0, WIDTH, HEIGHT), spacing, 3)
    model.add_temperature_function(plate, lambda x, y: (-math.erfc(y / DEPTH), 0))
    # A material is never quite the same everywhere: nicks of one and two spacings break the symmetry along the edge.
    random = np.random.default_rng(5)
    for x in np.arange(1.5, WIDTH / spacing - 1):
        if random.random() < 0.3:
            place = (math.floor(x) + 0.5) * spacing
            model.add_crack([(place, 0), (place, 0.5 * spacing * random.choice((1, 3)))])
    model.fix_edge(plate, 4, "x")
    model.fix_edge(plate, 2, "x")
    model.fix_point((0, HEIGHT), "y")
    return model, plate


def depths(model: bempd.Model, plate: int, spacing: float) -> np.ndarray:
    """How deep each column of points is parted from the next one by broken bonds one spacing long."""
    points, bonds = model.field(plate, "position"), model.bonds(plate)
    ends = points[bonds.points[bonds.states != bempd.BondState.INTACT]]
    apart = np.abs(ends[:, 0] - ends[:, 1])
    level = ends[(apart[:, 1] < 0.1 * spacing) & (apart[:, 0] < 1.1 * spacing)]
    columns = np.round(level[:, :, 0].mean(axis=1) / spacing - 0.5).astype(int)
    found = np.zeros(round(WIDTH / spacing))
    np.maximum.at(found, columns, level[:, 0, 1] + 0.5 * spacing)
    return found


def cracks(found: np.ndarray, deeper_than: float) -> int:
    """Columns that are the deepest of those next to them and deeper than a limit."""
    padded = np.concatenate([[0, 0], found, [0, 0]])
    nearby = np.array([padded[k : k + 5].max() for k in range(len(found))])
    is_top = (found >= nearby) & (found > deeper_than)
    return int((is_top & ~np.roll(is_top, 1)).sum())


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--short", action="store_true")
    parser.add_argument("folder", nargs="?", default="out/thermal_shock", type=pathlib.Path)
    arguments = parser.parse_args()
    arguments.folder.mkdir(parents=True, exist_ok=True)
    spacing = 0.5e-3 if arguments.short else 0.3e-3
    model, plate = build(spacing)
    first = model.step_to_next_event(1e4).load_factor
    table = [["cooling [K]", "events", "bonds broken", "cracks deeper than 1 mm", "than 3 mm", "deepest [mm]", "balance error"]]
    movie = None
    if not arguments.short:
        from bempd import plot

        movie = plot.Movie(arguments.folder / "thermal_shock.gif", model, "damage", magnification=40, frames_per_second=4)
        movie.add_frame()
    for share in (1.0, 1.25, 1.5, 2.0, 2.5, 3.0, 3.5, 4.0):
        report = model.step(share * first)
        found = depths(model, plate, spacing)
        table.append([f"{report.load_factor:.0f}", str(report.total_events), str(report.total_broken_bonds),
                      str(cracks(found, 1e-3)), str(cracks(found, 3e-3)), f"{1e3 * found.max():.1f}",
                      f"{report.energy_balance_error:.0e}"])
        print("  ".join(f"{word:>24s}" for word in table[-1]) if len(table) > 2 else
              "\n".join("  ".join(f"{word:>24s}" for word in row) for row in table), flush=True)
        if movie:
            movie.add_frame()
    with (arguments.folder / "summary.csv").open("w", newline="") as file:
        csv.writer(file).writerows(table)
    if movie:
        movie.close()
        import matplotlib

        matplotlib.use("Agg")
        import matplotlib.pyplot as plt

        figure, axes = plt.subplots(figsize=(9, 3.2), layout="constrained")
        model.plot("damage", axes=axes, magnification=40)
        figure.savefig(arguments.folder / "thermal_shock.png", dpi=110)
        print(f"written: {arguments.folder / 'thermal_shock.png'}")


main()
