"""Presses a disc at two opposite places until it splits between them: the Brazilian test of tensile strength.

usage: main.py [--short] [FOLDER]      --short: a coarse lattice and no pictures, as a test; FOLDER: out/brazilian_disc
"""

from __future__ import annotations

import argparse
import csv
import math
import pathlib

import bempd
import numpy as np

RADIUS, THICKNESS = 25e-3, 20e-3
YOUNG, RATIO, CRITICAL_STRETCH = 30e9, 1 / 3, 2e-4
HALF_ANGLE = math.radians(7.5)  # of each of the two loaded arcs
CORE = 7.5e-3, 19e-3  # half width and half height of the lattice
STRENGTH = YOUNG * CRITICAL_STRETCH


def build(spacing: float, criterion: str) -> tuple[bempd.Model, int]:
    """At load factor one the force is that at which the stress in the middle is the strength of the material: 2 P / (pi D t)
    for loads at points, by a factor less for pressed arcs (Hondros 1959)."""
    model = bempd.Model(options={"crack.rule": "bond", "pd.criterion": criterion, "stepping.control": "load"})
    rock = model.add_material(young_modulus=YOUNG, poisson_ratio=RATIO, thickness=THICKNESS, critical_stretch=CRITICAL_STRETCH)
    half_width = (round(CORE[0] / spacing) + 0.5) * spacing
    half_height = round(CORE[1] / spacing) * spacing
    disc = model.add_bem_disc(rock, (0, 0), RADIUS, 2.5e-3)
    corners = bempd.rectangle(-half_width, -half_height, half_width, half_height)
    model.add_hole(disc, corners[::-1])
    core = model.add_pd_region(rock, corners, spacing)
    part = HALF_ANGLE / (math.pi / 2)
    pressure = STRENGTH / middle_over_pressure()
    for edge, span in ((1, (1 - part, 1)), (2, (0, part)), (3, (1 - part, 1)), (4, (0, part))):
        model.add_pressure(disc, edge, pressure, part=span)
    model.fix_point((-RADIUS, 0), "y")
    model.fix_point((RADIUS, 0), "y")
    model.fix_point((0, -RADIUS), "x")
    return model, core


def middle_over_pressure() -> float:
    """Stress across the loaded diameter in the middle of a disc, over the pressure on the two arcs: G. Hondros, Aust. J. Appl.
    Sci. 10 (1959), 243."""
    return 2 / math.pi * (math.sin(2 * HALF_ANGLE) - HALF_ANGLE)


def force(load_factor: float) -> float:
    """The resultant of one arc [N]."""
    return load_factor * STRENGTH / middle_over_pressure() * 2 * RADIUS * math.sin(HALF_ANGLE) * THICKNESS


def length_of_split(model: bempd.Model, core: int, spacing: float) -> float:
    """Share of the lattice's rows in which a bond one spacing long is broken."""
    points, bonds = model.field(core, "position"), model.bonds(core)
    ends = points[bonds.points[bonds.states == bempd.BondState.BROKEN]]
    near = np.abs(ends[:, 0] - ends[:, 1])
    level = ends[(near[:, 1] < 0.1 * spacing) & (near[:, 0] < 1.1 * spacing)]
    return len(np.unique(np.round(level[:, 0, 1] / spacing))) / len(np.unique(np.round(points[:, 1] / spacing)))


def run(spacing: float, criterion: str, film: pathlib.Path | None) -> tuple[bempd.Model, list[str]]:
    """To the split: from there on the halves would come off under the same force."""
    model, core = build(spacing, criterion)
    report = model.step_to_next_event(10)
    first, events = report.load_factor, 0
    movie = None
    if film:
        from bempd import plot

        movie = plot.Movie(film, model, "damage", magnification=60, frames_per_second=6)
        movie.add_frame()
    while length_of_split(model, core, spacing) < 0.9 and events < 750:
        for _ in range(25):
            report = model.step_to_next_event(1.1 * first)
            events += 1
        if movie:
            movie.add_frame()
    if movie:
        movie.close()
    disc = math.pi * RADIUS * THICKNESS
    return model, [criterion, f"{force(first):.0f}", f"{force(first) / disc / STRENGTH:.3f}", f"{first:.3f}",
                   f"{length_of_split(model, core, spacing):.2f}", f"{report.load_factor / first:.3f}",
                   f"{report.total_broken_bonds}", f"{report.energy_balance_error:.0e}"]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--short", action="store_true")
    parser.add_argument("folder", nargs="?", default="out/brazilian_disc", type=pathlib.Path)
    arguments = parser.parse_args()
    arguments.folder.mkdir(parents=True, exist_ok=True)
    spacing = 1e-3 if arguments.short else 0.75e-3
    table = [["criterion", "force at the first break [N]", "2 P / (pi D t) / strength", "middle / strength",
              "rows split", "at, over the first", "bonds broken", "balance error"]]
    models = []
    for criterion in ("stretch", "opening"):
        film = arguments.folder / "brazilian_disc.gif" if criterion == "opening" and not arguments.short else None
        model, line = run(spacing, criterion, film)
        models.append(model)
        table.append(line)
    with (arguments.folder / "summary.csv").open("w", newline="") as file:
        csv.writer(file).writerows(table)
    for line in zip(*table):
        print(f"{line[0]:32s}" + "".join(f"{word:>12s}" for word in line[1:]))
    if not arguments.short:
        import matplotlib

        matplotlib.use("Agg")
        import matplotlib.pyplot as plt

        figure, axes = plt.subplots(1, 2, figsize=(9, 4.2), layout="constrained")
        for model, one, (criterion, first, *_) in zip(models, axes, table[1:]):
            model.plot("damage", axes=one, magnification=60, limits=(0, 0.6))
            one.set_title(f"pd.criterion = {criterion}: first break at {first} N", fontsize=10)
            one.set(xlim=(-28, 28), ylim=(-34, 34))
            for y, way in ((33, -7), (-33, 7)):
                one.annotate("", (0, y + way), (0, y), arrowprops={"arrowstyle": "-|>", "color": "#c05a00"})
        figure.savefig(arguments.folder / "brazilian_disc.png", dpi=110)
        print(f"written: {arguments.folder / 'brazilian_disc.png'}")


main()
