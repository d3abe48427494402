"""Bends a notched beam until its crack has run through, with the deflection held and along the path of equilibrium.

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


def build(spacing: float, control: str) -> tuple[bempd.Model, int, int]:
    model = bempd.Model(options={"pd.crack_rule": "bond", "stepping.control": control})
    resin = model.add_material(young_modulus=YOUNG, poisson_ratio=RATIO, thickness=THICKNESS, fracture_energy=ENERGY)
    half, end = (round(8e-3 / spacing) + 0.5) * spacing, SPAN / 2 + 4e-3
    left = model.add_bem_region(resin, bempd.rectangle(-end, 0, -half, HEIGHT), 2e-3)
    core = model.add_pd_region(resin, bempd.rectangle(-half, 0, half, HEIGHT), spacing)
    right = model.add_bem_region(resin, bempd.rectangle(half, 0, end, HEIGHT), 2e-3)
    model.add_crack([(0, 0), (0, NOTCH)])
    length = end - half

    def part(middle: float) -> tuple[float, float]:
        return (middle - SEAT) / length, (middle + SEAT) / length

    model.prescribe_edge(left, 1, "y", 0, part=part(end - SPAN / 2))
    model.prescribe_edge(right, 1, "y", 0, part=part(SPAN / 2 - half))
    stamp = model.prescribe_edge(core, 3, "y", PER_LOAD_FACTOR, part=((half - SEAT) / (2 * half), (half + SEAT) / (2 * half)))
    model.fix_point((-SPAN / 2, 0), "x")
    return model, core, stamp


def curve(model: bempd.Model, stamp: int, folder: pathlib.Path, name: str) -> np.ndarray:
    """Deflection [m] and force [N] at every line of the history."""
    path = folder / f"{name}.csv"
    model.write_history(path)
    with path.open() as lines:
        rows = list(csv.DictReader(lines))
    return np.array([(float(row["load_factor"]) * -PER_LOAD_FACTOR, -float(row[f"reaction_y_{stamp}"])) for row in rows])


def griffith() -> float:
    """Force at which the notch grows: K_I of a bent bar whose span is four heights (ASTM E399) is sqrt(E G0)."""
    a = NOTCH / HEIGHT
    shape = 3 * math.sqrt(a) * (1.99 - a * (1 - a) * (2.15 - 3.93 * a + 2.7 * a * a)) / (2 * (1 + 2 * a) * (1 - a) ** 1.5)
    return math.sqrt(YOUNG * ENERGY) * THICKNESS * HEIGHT**1.5 / (SPAN * shape)


def run(spacing: float, control: str, folder: pathlib.Path, film: bool) -> tuple[bempd.Model, np.ndarray]:
    model, _, stamp = build(spacing, control)
    if film:
        from bempd import plot

        with plot.Movie(folder / "three_point_bend.gif", model, "damage", magnification=8, frames_per_second=12) as movie:
            movie.add_frame()
            reason = bempd.StopReason.EVENT
            while reason == bempd.StopReason.EVENT:
                for _ in range(30):
                    reason = model.step_to_next_event(END).stop_reason
                movie.add_frame()
    model.step(END)
    return model, curve(model, stamp, folder, control)


def draw(curves: dict[str, np.ndarray], peak: float, folder: pathlib.Path) -> None:
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(figsize=(5.6, 3.8), layout="constrained")
    for control, label, look in (("path", "path of equilibrium", dict(color="#c05a00", linewidth=0.7)),
                                 ("load", "deflection held", dict(color="#1f4e79", linewidth=1.6))):
        values = curves[control]
        axes.plot(1e3 * np.append(0, values[:, 0]), np.append(0, values[:, 1]), label=label, **look)
    axes.axhline(peak, color="#7d838c", linewidth=0.8, label="notch grows by Griffith")
    axes.set(xlabel="deflection [mm]", ylabel="force [N]", ylim=(0, None), xlim=(0, None))
    axes.legend(frameon=False)
    figure.savefig(folder / "three_point_bend.png", dpi=110)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--short", action="store_true")
    parser.add_argument("folder", nargs="?", default="out/three_point_bend", type=pathlib.Path)
    arguments = parser.parse_args()
    arguments.folder.mkdir(parents=True, exist_ok=True)
    spacing = 1e-3 if arguments.short else 0.5e-3
    curves, lines = {}, [("control", "largest force [N]", "over Griffith's", "first break [mm]", "energy released [J]", "balance error")]
    for control in ("load", "path"):
        model, curves[control] = run(spacing, control, arguments.folder, film=control == "path" and not arguments.short)
        history = model.history()
        broken = history["total_broken_bonds"]
        first = curves[control][np.argmax(broken > 0), 0]
        peak = curves[control][:, 1].max()
        lines.append((control, f"{peak:.1f}", f"{peak / griffith():.3f}", f"{1e3 * first:.4f}",
                      f"{history['released_energy'][-1]:.5f}", f"{history['energy_balance_error'].max():.0e}"))
    with (arguments.folder / "summary.csv").open("w", newline="") as file:
        csv.writer(file).writerows(lines)
    for line in lines:
        print("  ".join(f"{word:>18s}" for word in line))
    print(f"energy of the surface G0 B (W - a): {ENERGY * THICKNESS * (HEIGHT - NOTCH):.5f} J")
    if not arguments.short:
        draw(curves, griffith(), arguments.folder)
        print(f"written: {arguments.folder / 'three_point_bend.png'}")


main()
