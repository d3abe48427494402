"""Grows the same crack, in a lattice patch, in bodies 1 to 1,000 times as large.

usage: main.py [--short] [FOLDER]      --short: up to 10 times and no picture, as a test; FOLDER: out/big_body
"""

from __future__ import annotations

import argparse
import csv
import pathlib
import time

import bempd

LENGTH = 20e-3  # of the crack [m]
SPACING = 1e-3
SMALLEST = 100e-3  # side of the smallest body [m]
EVENTS = 12


def build(times: float) -> bempd.Model:
    half = times * SMALLEST / 2
    model = bempd.Model(options={"stepping.control": "path"})
    glass = model.add_material(young_modulus=70e9, poisson_ratio=0.22, fracture_energy=8)
    body = model.add_body(glass, bempd.rectangle(-half, -half, half, half))
    crack = model.add_crack([(-LENGTH / 2, 0), (LENGTH / 2, 0)])
    model.set_crack_treatment(crack, "lattice")
    model.set_body_lattice(body, SPACING, 4)
    model.fix_edge(body, 1, "y")
    model.fix_point((-half, -half), "x")
    model.add_traction(body, 3, "y", proportional=1e6)
    return model


def run(times: float) -> tuple[bempd.Model, list[str], list[float]]:
    begin = time.process_time()
    model = build(times)
    for _ in range(EVENTS):
        model.step_to_next_event(1e6)
    seconds = time.process_time() - begin
    elements, patch = model.parts()
    loads = [extension.load_factor for extension in model.extensions()]
    return model, [f"{times:g}", str(elements.boundary_elements), str(patch.material_points), f"{patch.growth_load_factor:.4f}",
                   f"{patch.element_growth_load_factor:.4f}", f"{loads[-1]:.4f}", f"{seconds:.2f}"], loads


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--short", action="store_true")
    parser.add_argument("folder", nargs="?", default="out/big_body", type=pathlib.Path)
    arguments = parser.parse_args()
    arguments.folder.mkdir(parents=True, exist_ok=True)
    table = [["times the smallest", "boundary elements", "material points", "first growth [MPa]", "by elements [MPa]",
              f"after {EVENTS} events [MPa]", "seconds"]]
    models, curves = [], []
    for times in (1, 10) if arguments.short else (1, 10, 100, 1000):
        model, row, loads = run(times)
        table.append(row)
        models.append(model)
        curves.append((times, loads))
    with (arguments.folder / "summary.csv").open("w", newline="") as file:
        csv.writer(file).writerows(table)
    for line in zip(*table):
        print(f"{line[0]:28s}" + "".join(f"{word:>12s}" for word in line[1:]))
    if arguments.short:
        return
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(1, 2, figsize=(9, 3.8), layout="constrained")
    models[0].plan().plot(axes[0])
    axes[0].set_title("the smallest body: elements, and the patch of lattice", fontsize=9)
    for times, loads in curves:
        axes[1].plot(range(1, len(loads) + 1), loads, label=f"{times:,} times")
    axes[1].set(xlabel="extension of a tip", ylabel="stress on the path of equilibrium [MPa]")
    axes[1].legend(title="size of the body", fontsize=8)
    figure.savefig(arguments.folder / "big_body.png", dpi=110)
    print(f"written: {arguments.folder / 'big_body.png'}")


main()
