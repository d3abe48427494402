"""Pulls a drilled plate with two cracks, whose treatments change on the way.

usage: main.py [--short] [FOLDER]      --short: the treatments without pictures, as a test; FOLDER: out/drilled_plate
"""

from __future__ import annotations

import argparse
import csv
import pathlib

import bempd

WIDTH, HEIGHT, THICKNESS = 240e-3, 160e-3, 5e-3
YOUNG, RATIO, FRACTURE_ENERGY = 3e9, 1 / 3, 300.0  # of PMMA
HOLES = ((60e-3, 35e-3, 12e-3), (60e-3, 125e-3, 12e-3), (180e-3, 40e-3, 14e-3), (185e-3, 118e-3, 12e-3), (120e-3, 128e-3, 8e-3))
EDGE_CRACK = ((0, 80e-3), (20e-3, 80e-3))
INNER_CRACK = ((108e-3, 76e-3), (132e-3, 84e-3))


def build(treatment: str) -> tuple[bempd.Model, int, int]:
    """The plate, its crack from the left edge, and its inner crack, which is treated so."""
    model = bempd.Model(options={"stepping.control": "path"})
    pmma = model.add_material(young_modulus=YOUNG, poisson_ratio=RATIO, thickness=THICKNESS, fracture_energy=FRACTURE_ENERGY)
    plate = model.add_body(pmma, bempd.rectangle(0, 0, WIDTH, HEIGHT))
    for x, y, radius in HOLES:
        model.add_circular_hole(plate, (x, y), radius)
    edge, inner = model.add_crack(EDGE_CRACK), model.add_crack(INNER_CRACK)
    model.set_crack_treatment(inner, treatment)
    model.set_body_lattice(plate, spacing=0.9e-3, horizon_ratio=3)
    model.fix_edge(plate, 1)
    model.prescribe_edge(plate, 3, "x", proportional=0)
    model.prescribe_edge(plate, 3, "y", proportional=1e-6)
    return model, edge, inner


class Run:
    """A run with a film and a table of its phases."""

    def __init__(self, treatment: str, film: pathlib.Path | None) -> None:
        self.model, self.edge, self.inner = build(treatment)
        self.table: list[list[str]] = []
        self.movie = None
        if film:
            from bempd import plot

            self.movie = plot.Movie(film, self.model, "stress von Mises", magnification=15, frames_per_second=4, resolution=16,
                                    limits=(0, 12e6))

    def until(self, crack: int, length: float, what: str) -> None:
        """Let the plate be pulled until a crack is so long, or nothing grows any more."""
        model, events = self.model, 0
        while model.crack_length(crack) < length:
            report = model.step_to_next_event(1e9)
            if self.movie and events % 5 == 0:
                self.movie.add_frame()
            events += 1
            if report.separated or report.events == 0:
                break
        carriers = {tip.method.name.lower() for tip in model.tips() if tip.crack == self.inner}
        self.table.append([what, f"{model.load_factor:.2f}", f"{1e3 * model.crack_length(self.edge):.1f}",
                           f"{1e3 * model.crack_length(self.inner):.1f}", str(events), " and ".join(sorted(carriers))])


def run(treatment: str, film: pathlib.Path | None, lengths: tuple[float, ...]) -> Run:
    """Four phases, each until a crack has its length [m]."""
    found = Run(treatment, film)
    model = found.model
    model.prepare()
    model.set_crack_treatment(found.inner, "frozen")
    found.until(found.edge, lengths[0], "the inner crack is frozen")
    model.set_crack_treatment(found.edge, "frozen")
    model.set_crack_treatment(found.inner, treatment)
    found.until(found.inner, lengths[1], "the edge crack is frozen, in the patch")
    found.until(found.inner, lengths[2], "the patch follows the inner crack")
    model.set_crack_treatment(found.edge, "automatic")
    found.until(found.inner, lengths[3], "both may grow")
    if found.movie:
        found.movie.close()
    return found


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--short", action="store_true")
    parser.add_argument("folder", nargs="?", default="out/drilled_plate", type=pathlib.Path)
    arguments = parser.parse_args()
    arguments.folder.mkdir(parents=True, exist_ok=True)
    film = None if arguments.short else arguments.folder / "drilled_plate.gif"
    lengths = (24e-3, 26e-3, 27e-3, 27e-3) if arguments.short else (36e-3, 36e-3, 50e-3, 70e-3)
    runs = {"lattice": run("lattice", film, lengths)}
    if not arguments.short:
        runs["elements"] = run("elements", None, lengths)
    table = [["inner crack", "phase", "stretch [um]", "edge crack [mm]", "inner crack [mm]", "events", "inner tips"]]
    table += [[treatment, *row] for treatment, found in runs.items() for row in found.table]
    with (arguments.folder / "summary.csv").open("w", newline="") as file:
        csv.writer(file).writerows(table)
    for row in table:
        print(f"{row[0]:12s}{row[1]:42s}" + "".join(f"{word:>20s}" for word in row[2:]))
    for part in runs["lattice"].model.parts():
        print(part)
    if arguments.short:
        return
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(1, 2, figsize=(9, 4.2), layout="constrained")
    build("lattice")[0].plan().plot(axes[0])
    runs["lattice"].model.plot("outline", axes=axes[1])
    axes[1].set_title("cracks in the end", fontsize=9)
    figure.savefig(arguments.folder / "drilled_plate.png", dpi=110)
    print(f"written: {arguments.folder / 'drilled_plate.png'}")


main()
