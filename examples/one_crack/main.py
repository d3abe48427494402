"""Tears a plate with two holes in two by one crack: in boundary elements, in a lattice, and in a body of both.

usage: main.py [--short] [FOLDER]      --short: a coarse lattice and no picture, as a test; FOLDER: out/one_crack
"""

from __future__ import annotations

import argparse
import csv
import dataclasses
import math
import pathlib
import time

import bempd
import numpy as np

WIDTH, HEIGHT, THICKNESS = 60e-3, 90e-3, 5e-3
YOUNG, RATIO, FRACTURE_ENERGY = 3e9, 1 / 3, 300.0  # of PMMA
HOLES = ((36e-3, 72e-3), 7e-3), ((44e-3, 30e-3), 7e-3)  # centre, radius
MOUTH, LENGTH, ANGLE = np.array([0.0, 38e-3]), 16e-3, math.radians(63)  # of the edge crack; the angle to the horizontal
WINDOW = (0.0, 26e-3, 26e-3, 66e-3)  # of lattice in the body of both: left, bottom, right, top
PULL = 1e-6  # of the upper edge at load factor one [m]
FAR = 1e6  # a load factor that is never reached


@dataclasses.dataclass
class Result:
    name: str
    path: np.ndarray  # vertices that the crack has grown to, with the described tip first
    load: np.ndarray  # load factor at which it grew from each but the last one
    taken: float  # energy that the new area of crack took [J]
    released: float  # with what became motion [J]
    seconds: float
    report: bempd.StepReport

    @property
    def length(self) -> np.ndarray:
        """Of the growth, at each vertex."""
        return np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(self.path, axis=0), axis=1))])

    def over_g0(self, energy: float) -> float:
        """An energy for each new area of crack, over the fracture energy."""
        return energy / (FRACTURE_ENERGY * THICKNESS * self.length[-1])


def body(kind: str, spacing: float, turned: float = 0.0, shift: float = 0.0) -> bempd.Model:
    """The plate of one kind: elements, lattice, both.

    `turned` is the angle of the lattice's rows in degrees; `shift` moves crack and holes over the lattice, to the right and up.
    """
    model = bempd.Model()
    pmma = model.add_material(young_modulus=YOUNG, poisson_ratio=RATIO, thickness=THICKNESS, fracture_energy=FRACTURE_ENERGY)
    left, bottom, right, top = WINDOW
    notch = [(0, top), (right, top), (right, bottom), (0, bottom)] if kind == "both" else []
    outline = [*bempd.rectangle(0, 0, WIDTH, HEIGHT), *notch]
    if kind == "lattice":
        plate = model.add_pd_region(pmma, outline, spacing, 4, lattice_angle=math.radians(turned))
    else:
        plate = model.add_bem_region(pmma, outline, 4e-3)
    for centre, radius in HOLES:
        model.add_circular_hole(plate, np.add(centre, shift), radius)
    if kind == "both":
        model.add_pd_region(pmma, bempd.rectangle(*WINDOW), spacing, 4)
    mouth = MOUTH + [0, shift]
    model.add_crack([mouth, mouth + LENGTH * np.array([math.cos(ANGLE), math.sin(ANGLE)])])
    model.fix_edge(plate, 1, "both")
    model.prescribe_edge(plate, 3, "y", proportional=[PULL])
    return model


def tear(name: str, model: bempd.Model) -> Result:
    """The same lines for every kind of body."""
    start = time.perf_counter()
    model.options["stepping.control"] = "path"  # every event is a state of equilibrium, also where growth is unstable
    report = model.run_to_separation(FAR)
    path = model.crack_path(1)
    seconds = time.perf_counter() - start
    tip = [vertex for vertex in path if vertex.event == 0][-1]
    grown = [vertex for vertex in path if vertex.event > 0]
    return Result(name, np.array([(vertex.x, vertex.y) for vertex in (tip, *grown)]),
                  np.array([vertex.load_factor for vertex in grown]), report.bond_energy, report.released_energy,
                  seconds, report)


def farthest(path: np.ndarray, other: np.ndarray) -> float:
    """Largest distance of a path's vertices from another path."""
    start, way = other[:-1], np.diff(other, axis=0)
    share = np.einsum("pij,ij->pi", path[:, None] - start, way) / np.einsum("ij,ij->i", way, way)
    nearest = start + np.clip(share, 0, 1)[:, :, None] * way
    return float(np.linalg.norm(path[:, None] - nearest, axis=2).min(axis=1).max())


def load_deviation(one: Result, reference: Result, horizon: float) -> tuple[float, float]:
    """Largest deviation of loads after the first one from the reference's at the same length of growth: up to a horizon before
    the edge, and in it. A reference that grows by longer steps is straight between its own loads."""
    at = one.length[1:-1]
    deviation = np.abs(one.load[1:] / np.interp(at, reference.length[:-1], reference.load) - 1)
    last = at > reference.length[-1] - horizon
    return deviation[~last].max(), deviation[last].max(initial=0)


def picture(results: list[Result], file: pathlib.Path) -> None:
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, (plate, curve) = plt.subplots(1, 2, figsize=(9.5, 5), layout="constrained", width_ratios=(1, 1.5))
    plate.add_patch(plt.Rectangle((0, 0), WIDTH * 1e3, HEIGHT * 1e3, facecolor="#e3e5e8", edgecolor="#7d838c"))
    for (x, y), radius in HOLES:
        plate.add_patch(plt.Circle((x * 1e3, y * 1e3), radius * 1e3, facecolor="white", edgecolor="#7d838c"))
    left, bottom, right, top = (1e3 * side for side in WINDOW)
    plate.add_patch(plt.Rectangle((left, bottom), right - left, top - bottom, fill=False, edgecolor="#7d838c", linestyle=":"))
    plate.plot(*zip(1e3 * MOUTH, 1e3 * results[0].path[0]), color="black", linewidth=2)
    for result, style in zip(results, ("-", "--", ":", "-.", (0, (1, 3)))):
        plate.plot(*(1e3 * result.path.T), linestyle=style, label=result.name)
        curve.plot(1e3 * result.length[:-1], result.load, linestyle=style, label=result.name)
    plate.set(aspect="equal", xlabel="x [mm]", ylabel="y [mm]", xlim=(-2, 62), ylim=(-2, 92))
    curve.set(xlabel="growth of the crack [mm]", ylabel="displacement of the upper edge [micrometres]", ylim=(0, None))
    curve.legend()
    figure.savefig(file, dpi=110)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--short", action="store_true")
    parser.add_argument("folder", nargs="?", default="out/one_crack", type=pathlib.Path)
    arguments = parser.parse_args()
    arguments.folder.mkdir(parents=True, exist_ok=True)
    spacing = 1e-3 if arguments.short else 0.5e-3
    elements = tear("elements", body("elements", spacing))
    runs = [(tear("lattice", body("lattice", spacing)), elements), (tear("both", body("both", spacing)), elements)]
    if not arguments.short:
        runs.append((tear("lattice turned by 20 degrees", body("lattice", spacing, turned=20)), elements))
        moved = tear("elements", body("elements", spacing, shift=spacing / 2))
        runs.append((tear("lattice shifted by half a spacing", body("lattice", spacing, shift=spacing / 2)), moved))
    table = [["body", "first load", "peak load", "first over elements", "peak over elements", "other loads off", "in the last horizon",
              "path off [spacings]", "energy of new area / G0", "released / G0", "seconds", "end"]]
    for one, reference in [(elements, elements), *runs]:
        off, last = load_deviation(one, reference, 4 * spacing)
        table.append([one.name, f"{one.load[0]:.1f}", f"{one.load.max():.1f}", f"{one.load[0] / reference.load[0]:.3f}",
                      f"{one.load.max() / reference.load.max():.3f}", f"{off:.3f}", f"{last:.3f}",
                      f"{farthest(one.path, reference.path) / spacing:.2f}", f"{one.over_g0(one.taken):.3f}",
                      f"{one.over_g0(one.released):.3f}", f"{one.seconds:.1f}", one.report.stop_reason.name.lower()])
    with (arguments.folder / "summary.csv").open("w", newline="") as file:
        csv.writer(file).writerows(table)
    for line in zip(*table):
        print(f"{line[0]:22s}" + "".join(f"{word:>36s}" if len(word) > 18 else f"{word:>18s}" for word in line[1:]))
    if not arguments.short:
        picture([elements, *(one for one, _ in runs)], arguments.folder / "one_crack.png")


if __name__ == "__main__":
    main()
