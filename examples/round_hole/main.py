"""A crack runs into a round hole and out of its other side, in a plate whose edges are not parallel to the axes.

usage: main.py [--short] [FOLDER]      --short: a coarse lattice and no picture, as a test
"""

from __future__ import annotations

import argparse
import math
import pathlib

import bempd
import numpy as np

WIDTH, HEIGHT, RADIUS = 60e-3, 36e-3, 6e-3
CENTRE = (26e-3, 19e-3)
NOTCH = 17.5e-3, 9e-3  # height and length
TURNED = math.radians(20)


def placed(x: float, y: float) -> tuple[float, float]:
    """A place of the upright plate in the turned one."""
    c, s = math.cos(TURNED), math.sin(TURNED)
    return c * x - s * y, s * x + c * y


def build(spacing: float, horizon_ratio: int, lattice_angle: float, rule: str) -> tuple[bempd.Model, int]:
    model = bempd.Model()
    model.options["crack.rule"] = rule
    glass = model.add_material(young_modulus=70e9, poisson_ratio=1 / 3, thickness=1e-3, fracture_energy=10)
    corners = [placed(x, y) for x, y in bempd.rectangle(0, 0, WIDTH, HEIGHT)]
    plate = model.add_pd_region(glass, corners, spacing, horizon_ratio, lattice_angle=lattice_angle)
    model.add_circular_hole(plate, placed(*CENTRE), RADIUS)
    model.add_crack([placed(0, NOTCH[0]), placed(NOTCH[1], NOTCH[0])])
    model.fix_edge(plate, 1)
    pull = placed(0, 1e-5)
    model.prescribe_edge(plate, 3, "x", [pull[0]])
    model.prescribe_edge(plate, 3, "y", [pull[1]])
    return model, plate


def places_of_broken(model: bempd.Model, plate: int) -> np.ndarray:
    """Middles of broken bonds in the upright plate."""
    bonds, points = model.bonds(plate), model.field(plate, "position")
    middles = points[bonds.points[bonds.states == bempd.BondState.BROKEN]].mean(axis=1)
    c, s = math.cos(TURNED), math.sin(TURNED)
    return middles @ np.array([[c, -s], [s, c]])


def run(spacing: float, horizon_ratio: int, lattice_angle: float, rule: str) -> tuple[bempd.Model, list[str]]:
    model, plate = build(spacing, horizon_ratio, lattice_angle, rule)
    start, entered, left = None, None, None
    while left is None and model.step_to_next_event(10).stop_reason != bempd.StopReason.LOAD_FACTOR:
        start = start or model.load_factor
        broken = places_of_broken(model, plate)
        if entered is None and (np.hypot(*(broken - CENTRE).T) < RADIUS + spacing).any():
            entered = model.load_factor
        if (broken[:, 0] > CENTRE[0] + RADIUS).any():
            left = model.load_factor
    report = model.run_to_separation(10)
    broken = places_of_broken(model, plate)
    if start is None or entered is None or left is None:
        raise SystemExit("not so: the crack runs into the hole and out again")
    names = {"first bond breaks": start, "crack enters the hole": entered, "leaves it": left}
    way = broken[broken[:, 0] > CENTRE[0] + RADIUS + 2 * spacing]
    tilt = math.degrees(math.atan(np.polyfit(*way.T, 1)[0])) if len(way) else math.nan
    lines = [f"{'bond by bond' if rule == 'bond' else 'as a line'}, lattice turned by {math.degrees(lattice_angle):.0f} degrees:"]
    lines += [f"    {name:24s} load factor {value:.3f}" for name, value in names.items()]
    lines.append(f"    its way behind the hole, from the middle line of the plate: {tilt:.1f} degrees")
    lines.append(f"    bonds broken {report.total_broken_bonds}, energy balance error {report.energy_balance_error:.0e}")
    return model, lines


def draw(models: list[tuple[str, bempd.Model]], path: pathlib.Path) -> None:
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(2, 2, figsize=(9, 7.6), layout="constrained", sharex=True, sharey=True)
    for (title, model), one in zip(models, axes.flat):
        model.plot("damage", axes=one, limits=(0, 0.6), colour_bar=one in axes[:, 1])
        one.set_title(f"{title}\nin two at load factor {model.load_factor:.3f}", fontsize=10)
        one.label_outer()
    figure.savefig(path, dpi=110)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--short", action="store_true")
    parser.add_argument("folder", nargs="?", default=".", type=pathlib.Path)
    arguments = parser.parse_args()
    spacing, horizon_ratio = (1.5e-3, 3) if arguments.short else (0.75e-3, 4)
    models = []
    for rule in ("bond", "line"):
        for angle in (0.0, TURNED):
            model, lines = run(spacing, horizon_ratio, angle, rule)
            print("\n".join(lines))
            rows = "along the plate" if angle else "along the axes"
            models.append((f"{'bond by bond' if rule == 'bond' else 'as a line'}, rows {rows}", model))
    if not arguments.short:
        arguments.folder.mkdir(parents=True, exist_ok=True)
        draw(models, arguments.folder / "round_hole.png")
        print(f"written: {arguments.folder / 'round_hole.png'}")


if __name__ == "__main__":
    main()
