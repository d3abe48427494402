"""Pulls a sheet with 1,000 holes in which ten cracks grow.

usage: main.py [--short | --small] [--full] [FOLDER]
    --short: 64 holes, three cracks and no picture, as a test;  --small: 256 holes
    --full: on until the cracks end or the sheet is torn
    FOLDER: out/perforated_sheet
"""

from __future__ import annotations

import argparse
import csv
import dataclasses
import itertools
import math
import pathlib
import random
import resource
import time

import bempd

CELL, POROSITY, SEED = 5e-3, 0.2, 1  # side of the square around each hole [m]; share of holes; of radii and places
YOUNG, RATIO, THICKNESS, FRACTURE_ENERGY = 3e9, 1 / 3, 2e-3, 300.0  # of PMMA
STRAIN = 1e-3  # of the sheet at load factor one
CRACK = 0.15  # length of a crack over the cell's side
GROWTH = 0.1  # of all cracks together, per crack and over the cell's side, at which the run ends
FAR = 1e6  # a load factor that is never reached

Hole = tuple[float, float, float]  # centre, radius


@dataclasses.dataclass
class Sheet:
    model: bempd.Model
    size: tuple[float, float]
    holes: list[Hole]
    cracks: list[int]


def describe(columns: int, rows: int, cracks: int) -> Sheet:
    """A hole of pseudo-random radius and place in each cell. Cracks begin at the right of holes that are far apart."""
    choose = random.Random(SEED)
    size = columns * CELL, rows * CELL
    model = bempd.Model(options={"stepping.control": "path", "error.wanted": 0.01})
    pmma = model.add_material(young_modulus=YOUNG, poisson_ratio=RATIO, thickness=THICKNESS, fracture_energy=FRACTURE_ENERGY)
    sheet = model.add_body(pmma, bempd.rectangle(0, 0, *size))
    holes = []
    for column, row in itertools.product(range(columns), range(rows)):
        radius = math.sqrt(POROSITY / math.pi) * choose.uniform(0.7, 1.3)
        room = 0.8 * (0.5 - radius)
        centre = column + 0.5 + room * choose.uniform(-1, 1), row + 0.5 + room * choose.uniform(-1, 1)
        holes.append((CELL * centre[0], CELL * centre[1], CELL * radius))
        model.add_circular_hole(sheet, holes[-1][:2], holes[-1][2])
    made = []
    for crack in range(cracks):
        row = (2 * crack + 1) * rows // (2 * cracks)
        x, y, radius = holes[(7 * crack + 1) % (columns - 1) * rows + row]
        made.append(model.add_crack([(x + radius, y), (x + radius + CRACK * CELL, y)]))
    model.fix_edge(sheet, 1, "both")
    model.prescribe_edge(sheet, 3, "y", proportional=[STRAIN * size[1]])
    return Sheet(model, size, holes, made)


@dataclasses.dataclass
class Run:
    grown: list[float]  # over the cell's side, per crack, of all cracks together
    load: list[float]  # load factor
    resistance: list[float]  # [N]
    seconds: list[float]  # of each step
    preparing: float  # seconds until the first solution
    ended: str


def grow(sheet: Sheet, until: float) -> Run:
    """One crack at a time grows, the one that does so at the least load; every state is one of equilibrium."""
    model, cracks = sheet.model, len(sheet.cracks)
    begin = time.perf_counter()
    model.step(1e-3)
    run = Run([], [], [], [], time.perf_counter() - begin, "the growth asked for")
    length = 0.0
    while length < until * cracks:
        before = len(model.extensions())
        begin = time.perf_counter()
        try:
            report = model.step_to_next_event(FAR)
        except bempd.Error as error:
            run.ended = str(error)
            break
        run.seconds.append(time.perf_counter() - begin)
        if report.events == 0 or report.separated:
            run.ended = "the sheet is torn" if report.separated else "no crack grows on"
            break
        length += sum(one.length for one in model.extensions()[before:]) / CELL
        run.grown.append(length / cracks)
        run.load.append(report.load_factor)
        run.resistance.append(report.resistance)
    return run


def rows_of(sheet: Sheet, run: Run) -> list[tuple[str, str]]:
    sizes = sheet.model.statistics()
    steps = sorted(run.seconds)
    return [
        ("holes, cracks", f"{len(sheet.holes):,}, {len(sheet.cracks)}"),
        ("boundary elements, subdomains", f"{sizes.boundary_elements:,}, {sizes.subdomains:,}"),
        ("nodes, with those on cuts", f"{sizes.boundary_nodes + sizes.cut_nodes:,}"),
        ("memory, largest [GB]", f"{resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e6:.2f}"),
        ("seconds to prepare", f"{run.preparing:.1f}"),
        ("steps, seconds of one (middle, largest)", f"{len(steps)}, {steps[len(steps) // 2]:.2f}, {steps[-1]:.2f}"),
        ("first and largest load factor", f"{run.load[0]:.4g}, {max(run.load):.4g}"),
        ("growth over a cell, load factor", "; ".join(f"{run.grown[k]:.2f}, {run.load[k]:.4g}" for k in picked(len(run.load)))),
        ("pieces at the end", f"{sheet.model.piece_count}"),
        ("ended by", run.ended),
    ]


def picked(count: int) -> list[int]:
    """Numbers of the first, the last and some steps between them."""
    return sorted({round(share * (count - 1) / 4) for share in range(5)})


def picture(sheet: Sheet, run: Run, file: pathlib.Path) -> None:
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, (plate, curve) = plt.subplots(1, 2, figsize=(11, 5), layout="constrained", width_ratios=(1.6, 1))
    plate.add_patch(plt.Rectangle((0, 0), *(1e3 * side for side in sheet.size), facecolor="#e3e5e8", edgecolor="#7d838c"))
    for x, y, radius in sheet.holes:
        plate.add_patch(plt.Circle((1e3 * x, 1e3 * y), 1e3 * radius, facecolor="white", edgecolor="#b6bac0", linewidth=0.4))
    for crack in sheet.cracks:
        path = sheet.model.crack_path(crack)
        plate.plot([1e3 * one.x for one in path], [1e3 * one.y for one in path], color="#b3261e", linewidth=1.6)
        plate.plot(1e3 * path[0].x, 1e3 * path[0].y, "o", color="#b3261e", markersize=2)
    plate.set(xlim=(-1, 1e3 * sheet.size[0] + 1), ylim=(-1, 1e3 * sheet.size[1] + 1), aspect="equal", xlabel="x [mm]",
              ylabel="y [mm]")
    curve.plot(run.grown, run.load, "o-", color="#24507a", markersize=3)
    curve.set(xlabel="growth of all cracks, over cell and cracks", ylabel="load factor", ylim=(0, None))
    figure.savefig(file, dpi=130)


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--short", action="store_true")
    parser.add_argument("--small", action="store_true")
    parser.add_argument("--full", action="store_true")
    parser.add_argument("folder", nargs="?", type=pathlib.Path, default=pathlib.Path("out/perforated_sheet"))
    arguments = parser.parse_args()
    arguments.folder.mkdir(parents=True, exist_ok=True)
    sheet = describe(8, 8, 3) if arguments.short else describe(16, 16, 10) if arguments.small else describe(40, 25, 10)
    run = grow(sheet, math.inf if arguments.full else 0.1 if arguments.short else GROWTH)
    assert run.load, f"no crack has grown: {run.ended}"
    rows = rows_of(sheet, run)
    with open(arguments.folder / "summary.csv", "w", newline="", encoding="utf-8") as file:
        csv.writer(file).writerows(rows)
    print("\n".join(f"{name:42}{value}" for name, value in rows))
    if not arguments.short:
        picture(sheet, run, arguments.folder / "perforated_sheet.png")


if __name__ == "__main__":
    main()
