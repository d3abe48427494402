"""Bends a notched beam until its crack has run through, with the deflection held and along the path of equilibrium, the crack
a line, as by default, and bond by bond.

usage: main.py [--short] [FOLDER]      --short: a coarse lattice and no pictures, as a test; FOLDER: out/three_point_bend
"""

from __future__ import annotations

import argparse
import csv
import math
import pathlib

import bempd
import numpy as np

SPAN, HEIGHT, NOTCH, THICKNESS = 80e-3, 20e-3, 4e-3, 10e-3
YOUNG, RATIO, ENERGY = 3.0e9, 1 / 3, 300.0
SEAT = 1e-3  # half width of the supports and of the stamp
PER_LOAD_FACTOR = -1e-6  # of the stamp [m]
END = 650  # load factor: then the crack is under the stamp, which holds on to both halves
RULES, CONTROLS = ("line", "bond"), ("load", "path")


def seat(middle: float, length: float) -> tuple[float, float]:
    return (middle - SEAT) / length, (middle + SEAT) / length


def build(spacing: float, rule: str, control: str) -> tuple[bempd.Model, int, int]:
    model = bempd.Model(options={"crack.rule": rule, "stepping.control": control})
    resin = model.add_material(young_modulus=YOUNG, poisson_ratio=RATIO, thickness=THICKNESS, fracture_energy=ENERGY)
    half, end = (round(8e-3 / spacing) + 0.5) * spacing, SPAN / 2 + 4e-3
    left = model.add_bem_region(resin, bempd.rectangle(-end, 0, -half, HEIGHT), 2e-3)
    core = model.add_pd_region(resin, bempd.rectangle(-half, 0, half, HEIGHT), spacing)
    right = model.add_bem_region(resin, bempd.rectangle(half, 0, end, HEIGHT), 2e-3)
    model.add_crack([(0, 0), (0, NOTCH)])
    length = end - half

    model.prescribe_edge(left, 1, "y", 0, part=seat(end - SPAN / 2, length))
    model.prescribe_edge(right, 1, "y", 0, part=seat(SPAN / 2 - half, length))
    stamp = model.prescribe_edge(core, 3, "y", PER_LOAD_FACTOR, part=seat(half, 2 * half))
    model.fix_point((-SPAN / 2, 0), "x")
    return model, core, stamp


def curve(model: bempd.Model, stamp: int, folder: pathlib.Path, name: str) -> np.ndarray:
    """Deflection [m] and force [N] before and after every event. The history has those after it; before it the body, elastic
    since the last one, held what it stores now and what the event has released, half of force times deflection."""
    path = folder / f"{name}.csv"
    model.write_history(path)
    values, released = [(0.0, 0.0)], 0.0
    with path.open() as lines:
        for row in csv.DictReader(lines):
            deflection = float(row["load_factor"]) * -PER_LOAD_FACTOR
            held = float(row["stored_energy"]) + float(row["released_energy"]) - released
            values += [(deflection, 2 * held / deflection), (deflection, -float(row[f"reaction_y_{stamp}"]))]
            released = float(row["released_energy"])
    return np.array(values)


def griffith() -> float:
    """Force at which the notch grows: K_I of a bent bar whose span is four heights (ASTM E399) is sqrt(E G0)."""
    a = NOTCH / HEIGHT
    shape = 3 * math.sqrt(a) * (1.99 - a * (1 - a) * (2.15 - 3.93 * a + 2.7 * a * a)) / (2 * (1 + 2 * a) * (1 - a) ** 1.5)
    return math.sqrt(YOUNG * ENERGY) * THICKNESS * HEIGHT**1.5 / (SPAN * shape)


def fracture_mechanics(lengths: np.ndarray) -> np.ndarray:
    """Deflection [m] and force [N] at which a crack of each length grows, by boundary elements alone."""
    places = []
    for crack in lengths:
        model = bempd.Model()
        resin = model.add_material(young_modulus=YOUNG, poisson_ratio=RATIO, thickness=THICKNESS, fracture_energy=ENERGY)
        end = SPAN / 2 + 4e-3
        bar = model.add_bem_region(resin, bempd.rectangle(-end, 0, end, HEIGHT), 2e-3)
        model.add_crack([(0, 0), (0, crack)])
        for middle in (-SPAN / 2, SPAN / 2):
            model.prescribe_edge(bar, 1, "y", 0, part=seat(end + middle, 2 * end))
        stamp = model.prescribe_edge(bar, 3, "y", PER_LOAD_FACTOR, part=seat(end, 2 * end))
        model.fix_point((-end, HEIGHT / 2), "x")
        model.step(1)
        critical = model.tips()[0].critical_load_factor
        places.append((critical * -PER_LOAD_FACTOR, -critical * model.reaction(stamp)[1]))
    return np.array(places)


def felt_tip(model: bempd.Model) -> float:
    """Where the loads feel the tip of the crack to be [m]: ahead of its place by less than a spacing, if that is known. A crack
    that has reached the upper edge has no tip: then its end."""
    if not model.tips():
        return max(vertex.y for vertex in model.crack_path(1))
    tip = model.tips()[0]
    return tip.y if math.isnan(tip.felt_ahead) else tip.y + tip.felt_ahead


def run(spacing: float, rule: str, control: str, folder: pathlib.Path, film: bool) -> tuple[np.ndarray, list[str]]:
    model, _, stamp = build(spacing, rule, control)
    notch = felt_tip(model)
    if film:
        from bempd import plot

        with plot.Movie(folder / "three_point_bend.gif", model, "damage", magnification=8, frames_per_second=6) as movie:
            movie.add_frame()
            reason = bempd.StopReason.EVENT
            while reason == bempd.StopReason.EVENT:
                reason = model.step_to_next_event(END).stop_reason
                movie.add_frame()
    model.step(END)
    values, history = curve(model, stamp, folder, f"{rule}_{control}"), model.history()
    peak, first = values[:, 1].max(), values[1, 0]
    return values, [rule, control, f"{peak:.1f}", f"{peak / griffith():.3f}", f"{1e3 * first:.4f}",
                    f"{history['released_energy'][-1]:.5f}", f"{ENERGY * THICKNESS * (felt_tip(model) - notch):.5f}",
                    f"{history['energy_balance_error'].max():.0e}"]


def write_steps(spacing: float, places: np.ndarray, folder: pathlib.Path) -> None:
    """Every step of the line on the path: its deflection over that of fracture mechanics, its energy over G0 B times the way."""
    with (folder / "line_path.csv").open() as lines:
        rows = list(csv.DictReader(lines))[: len(places)]
    released = np.diff([0.0] + [float(row["released_energy"]) for row in rows])
    with (folder / "steps.csv").open("w", newline="") as file:
        steps = csv.writer(file)
        steps.writerow(["tip [mm]", "deflection over fracture mechanics", "released over G0"])
        for k, row in enumerate(rows):
            over = float(row["load_factor"]) * -PER_LOAD_FACTOR / places[k, 0]
            steps.writerow([f"{1e3 * (NOTCH + k * spacing):.1f}", f"{over:.3f}",
                            f"{released[k] / (ENERGY * THICKNESS * spacing):.3f}"])


def draw(curves: dict[tuple[str, str], np.ndarray], places: np.ndarray, folder: pathlib.Path) -> None:
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(figsize=(6.2, 4.2), layout="constrained")
    for run_of, label, look in ((("bond", "path"), "bond by bond, path of equilibrium", dict(color="#b4b9c0", linewidth=0.5)),
                                (("bond", "load"), "bond by bond, deflection held", dict(color="#7d838c", linewidth=1)),
                                (("line", "path"), "line, path of equilibrium", dict(color="#c05a00", linewidth=1)),
                                (("line", "load"), "line, deflection held", dict(color="#1f4e79", linewidth=1.6))):
        values = curves[run_of]
        axes.plot(1e3 * values[:, 0], values[:, 1], label=label, **look)
    axes.plot(1e3 * places[:, 0], places[:, 1], "k--", linewidth=0.9, label="fracture mechanics, boundary elements")
    axes.set(xlabel="deflection [mm]", ylabel="force [N]", ylim=(0, None), xlim=(0, None))
    axes.legend(frameon=False, fontsize=8)
    figure.savefig(folder / "three_point_bend.png", dpi=110)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--short", action="store_true")
    parser.add_argument("folder", nargs="?", default="out/three_point_bend", type=pathlib.Path)
    arguments = parser.parse_args()
    arguments.folder.mkdir(parents=True, exist_ok=True)
    spacing = 1e-3 if arguments.short else 0.5e-3
    curves, lines = {}, [["rule", "control", "largest force [N]", "over Griffith's", "first break [mm]", "energy released [J]",
                          "G0 B times parted", "balance error"]]
    for rule in RULES:
        for control in CONTROLS:
            film = (rule, control) == ("line", "path") and not arguments.short
            curves[rule, control], line = run(spacing, rule, control, arguments.folder, film)
            lines.append(line)
    with (arguments.folder / "summary.csv").open("w", newline="") as file:
        csv.writer(file).writerows(lines)
    for line in lines:
        print("  ".join(f"{word:>19s}" for word in line))
    if not arguments.short:
        places = fracture_mechanics(np.arange(NOTCH, 18.25e-3, spacing))
        write_steps(spacing, places, arguments.folder)
        draw(curves, places, arguments.folder)
        print(f"written: {arguments.folder / 'three_point_bend.png'}")


if __name__ == "__main__":
    main()
