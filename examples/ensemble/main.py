"""Strength of glass plates with random cracks: Weibull plot and size effect of three sizes.

usage: main.py [--full | --short] [--executor NAME] [FOLDER]     --full: 1,000 plates; --short: 12 and no picture, as a test
"""

from __future__ import annotations

import argparse
import math
import pathlib
import sys

import bempd
import numpy as np

SIDES = 0.1, 0.173, 0.3  # of the plates [m]: areas 1 : 3 : 9
DENSITY, SHORTEST, LONGEST, EXPONENT = 400.0, 8e-3, 45e-3, 5.0  # cracks [1/m^2], their lengths [m], the law of lengths
YOUNG, RATIO, THICKNESS, ENERGY = 70e9, 0.22, 0.004, 8.0
PULL = 1e6  # traction at load factor one [Pa]


def strength(seed: int, side: float) -> dict[str, float]:
    """Nominal stress at which the first crack of a plate grows: under a dead load that breaks the plate."""
    box = (0.0, 0.0, side, side)
    cracks = bempd.random_cracks(seed, box, count=round(DENSITY * side**2), length=(SHORTEST, LONGEST), exponent=EXPONENT)
    model = bempd.Model()
    glass = model.add_material(young_modulus=YOUNG, poisson_ratio=RATIO, thickness=THICKNESS, fracture_energy=ENERGY)
    plate = model.add_bem_region(glass, bempd.rectangle(*box), element_length=side / 10)
    for crack in cracks:
        model.add_crack(crack)
    for edge, sign in ((1, -1), (3, 1)):
        model.add_traction(plate, edge, "y", sign * PULL)
    model.fix_point((0, 0))
    model.fix_point((side, 0), "y")
    first = min(tip.critical_load_factor for tip in model.tips())
    return {"strength [Pa]": PULL * first, "longest [m]": max(math.dist(*crack) for crack in cracks)}


def cases(count: int) -> list[dict[str, float]]:
    """As many plates of each size, with seeds of their own."""
    return [{"seed": seed, "side": SIDES[seed % len(SIDES)]} for seed in range(count)]


def modulus(strengths: np.ndarray) -> tuple[float, float]:
    """Weibull modulus and characteristic strength by maximum likelihood."""
    logs = np.log(strengths)
    low, high = 0.5, 100.0
    for _ in range(60):
        m = 0.5 * (low + high)
        weights = strengths**m / np.sum(strengths**m)
        low, high = (m, high) if np.sum(weights * logs) - 1 / m - logs.mean() < 0 else (low, m)
    return m, float(np.mean((strengths / strengths.max()) ** m) ** (1 / m) * strengths.max())


def main() -> int:
    parser = argparse.ArgumentParser()
    size = parser.add_mutually_exclusive_group()
    size.add_argument("--full", action="store_true")
    size.add_argument("--short", action="store_true")
    parser.add_argument("--executor", default="processes")
    parser.add_argument("folder", nargs="?", default="out/ensemble", type=pathlib.Path)
    given = parser.parse_args()
    given.folder.mkdir(parents=True, exist_ok=True)
    found = bempd.ensemble(strength, cases(1000 if given.full else 12 if given.short else 100), executor=given.executor,
                           results=given.folder / "results.jsonl", table=given.folder / "plates.csv")
    strengths = found.values("strength [Pa]") / 1e6
    sides = np.array([row["case"]["side"] for row in found])
    known = np.isfinite(strengths)
    with open(given.folder / "summary.csv", "w", encoding="utf-8") as file:
        file.write("side [m],plates,mean strength [MPa],Weibull modulus,characteristic strength [MPa]\n")
        for side in SIDES:
            of_size = strengths[known & (sides == side)]
            m, scale = modulus(of_size)
            file.write(f"{side:g},{len(of_size)},{of_size.mean():.3f},{m:.2f},{scale:.3f}\n")
    print(open(given.folder / "summary.csv", encoding="utf-8").read(), end="")
    if not given.short:
        from picture import draw

        draw(sides[known], strengths[known], given.folder)
    return len(found.errors)


if __name__ == "__main__":
    sys.exit(main())
