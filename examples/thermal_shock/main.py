"""Cools one edge of a hot plate suddenly; the cold goes in, and an array of cracks grows with it.

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
YOUNG, RATIO, ENERGY, EXPANSION, DIFFUSIVITY = 370e9, 1 / 3, 24.3, 7.5e-6, 1e-5  # alumina
COOLING = 110.0  # of the edge [K]
LAYERS = 10  # of two spacings each, which have temperatures of their own


def temperature(y: float, time: float) -> float:
    """In a half plane whose edge is suddenly cold: H. S. Carslaw and J. C. Jaeger, Conduction of Heat in Solids, art. 2.4."""
    return -COOLING * math.erfc(y / math.sqrt(4 * DIFFUSIVITY * time))


def build(spacing: float) -> tuple[bempd.Model, list[int], dict[int, float]]:
    """The model, its regions, and the middle height of each temperature."""
    model = bempd.Model(options={"crack.rule": "bond"})
    alumina = model.add_material(young_modulus=YOUNG, poisson_ratio=RATIO, fracture_energy=ENERGY, thickness=1e-3,
                                 thermal_expansion=EXPANSION)
    heights = [2 * spacing * k for k in range(LAYERS + 1)] + [HEIGHT]
    regions = [model.add_pd_region(alumina, bempd.rectangle(0, low, WIDTH, high), spacing, 3)
               for low, high in zip(heights, heights[1:])]
    # Lattices of one material act as one where they touch.
    cold = {model.add_temperature(region, 1.0): (low + high) / 2
            for region, low, high in zip(regions[:LAYERS], heights, heights[1:])}
    # A material is never quite the same everywhere: nicks of one and two spacings break the symmetry along the edge.
    random = np.random.default_rng(5)
    for column in range(1, round(WIDTH / spacing) - 1):
        if random.random() < 0.3:
            place = (column + 0.5) * spacing
            model.add_crack([(place, 0), (place, 0.5 * spacing * random.choice((1, 3)))])
    for region in regions:
        model.fix_edge(region, 4, "x")
        model.fix_edge(region, 2, "x")
    model.fix_point((0, HEIGHT), "y")
    return model, regions, cold


def depths(model: bempd.Model, regions: list[int], spacing: float) -> np.ndarray:
    """How deep each column of points is parted from the next one by broken bonds one spacing long."""
    found = np.zeros(round(WIDTH / spacing))
    for region in regions:
        points, bonds = model.field(region, "position"), model.bonds(region)
        ends = points[bonds.points[bonds.states != bempd.BondState.INTACT]]
        apart = np.abs(ends[:, 0] - ends[:, 1])
        level = ends[(apart[:, 1] < 0.1 * spacing) & (apart[:, 0] < 1.1 * spacing)]
        columns = np.round(level[:, :, 0].mean(axis=1) / spacing - 0.5).astype(int)
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
    spacing = 0.5e-3 if arguments.short else 0.4e-3
    model, regions, cold = build(spacing)
    times = [0.01, 0.02, 0.03, 0.04, 0.06, 0.08, 0.12, 0.16, 0.24, 0.32]
    loads = {load: [temperature(y, time) for time in times] for load, y in cold.items()}
    table = [["time [s]", "cold to [mm]", "bonds broken", "cracks over 1 mm", "over 3 mm", "deepest [mm]", "balance error"]]
    movie = None
    if not arguments.short:
        from bempd import plot

        movie = plot.Movie(arguments.folder / "thermal_shock.gif", model, "damage", magnification=40, frames_per_second=2)
    for row, time in enumerate(times):
        report = model.run_program(times[: row + 1], loads={load: factors[: row + 1] for load, factors in loads.items()})
        found = depths(model, regions, spacing)
        table.append([f"{time:g}", f"{1e3 * math.sqrt(4 * DIFFUSIVITY * time):.1f}", str(report.total_broken_bonds),
                      str(cracks(found, 1e-3)), str(cracks(found, 3e-3)), f"{1e3 * found.max():.1f}",
                      f"{report.energy_balance_error:.0e}"])
        if movie:
            movie.add_frame()
    for line in table:
        print("  ".join(f"{word:>16s}" for word in line))
    with (arguments.folder / "summary.csv").open("w", newline="") as file:
        csv.writer(file).writerows(table)
    if movie:
        movie.close()
        import matplotlib

        matplotlib.use("Agg")
        import matplotlib.pyplot as plt

        figure, axes = plt.subplots(figsize=(9, 3.2), layout="constrained")
        model.plot("damage", axes=axes, magnification=40)
        axes.set_title(f"damage {times[-1]:g} s after the lower edge was cooled, displacements x 40; lines: layers of one temperature", fontsize=10)
        figure.savefig(arguments.folder / "thermal_shock.png", dpi=110)
        print(f"written: {arguments.folder / 'thermal_shock.png'}")


main()
