"""Life of a riveted lap: cracks from two rivet holes under a spectrum, a-N curve, inspections, scatter of the material.

usage: main.py [--full | --short] [FOLDER]     --full: 100 materials; --short: 2, no picture and no film, as a test
"""

from __future__ import annotations

import argparse
import math
import pathlib

import bempd
import numpy as np

PITCH, RADIUS, EDGE, LENGTH, THICKNESS = 0.02, 0.0024, 0.01, 0.08, 0.0016  # of the lap [m]
HOLES = (-PITCH, 0.0, PITCH)
PULL = 90e6  # stress far from the rivets at the load factor 1 [Pa]
SPECTRUM = {"high": [1.0, 0.8, 0.6], "low": [0.05, 0.2, 0.1], "cycles": [10.0, 100.0, 500.0]}
COEFFICIENT, EXPONENT = 2e-11, 3.0  # of Paris' law in MPa m^(1/2) and m
SCATTER_OF_LOG_C, SCATTER_OF_M = 0.08, 0.03  # standard deviations of log10 C and of m


def lap(coefficient: float = COEFFICIENT, exponent: float = EXPONENT) -> bempd.Model:
    """A strip with a row of three rivets, which carry all of its pull; cracks on both sides of the middle hole, and on one
    side of its neighbour."""
    width = 3 * PITCH
    model = bempd.Model(log=None)
    aluminium = model.add_material(young_modulus=72e9, poisson_ratio=0.33, thickness=THICKNESS)
    strip = model.add_bem_region(aluminium, bempd.rectangle(-width / 2, -EDGE, width / 2, LENGTH), element_length=0.01)
    force = PULL * width * THICKNESS / len(HOLES)
    for x in HOLES:
        first = model.add_circular_hole(strip, (x, 0), RADIUS)
        for edge in range(first, first + 4):
            model.add_traction_function(strip, edge, rivet(x, force))
    model.add_traction(strip, 3, "y", PULL)
    model.fix_point((-width / 2, LENGTH))
    model.fix_point((width / 2, LENGTH), "y")
    model.add_crack([(RADIUS, 0), (RADIUS + 0.001, 0)])
    model.add_crack([(-RADIUS - 0.0008, 0), (-RADIUS, 0)])
    model.add_crack([(PITCH - RADIUS - 0.0005, 0), (PITCH - RADIUS, 0)])
    model.set_growth_rate(aluminium, coefficient=coefficient, exponent=exponent, unit_intensity=1e6, walker=0.6,
                          critical_intensity=35)
    return model


def rivet(x0: float, force: float):
    """A rivet that pulls its hole down: a pressure with the cosine of the angle to the force."""
    peak = 2 * force / (math.pi * RADIUS * THICKNESS)

    def traction(x: float, y: float):
        normal = ((x - x0) / RADIUS, y / RADIUS)
        pressure = peak * max(0.0, -normal[1])
        return (0.0, 0.0), (pressure * normal[0], pressure * normal[1])

    return traction


def life_of(log_c: float, m: float) -> dict[str, float]:
    """Cycles until a tip breaks or meets another crack."""
    return {"cycles": lap(10**log_c, m).grow_fatigue(**SPECTRUM).cycles}


def materials(count: int) -> list[dict[str, float]]:
    draw = np.random.default_rng(1)
    middle = math.log10(COEFFICIENT)
    return [{"log_c": float(middle + SCATTER_OF_LOG_C * draw.standard_normal()), "m": float(EXPONENT + SCATTER_OF_M * draw.standard_normal())}
            for _ in range(count)]


def main() -> int:
    parser = argparse.ArgumentParser()
    size = parser.add_mutually_exclusive_group()
    size.add_argument("--full", action="store_true")
    size.add_argument("--short", action="store_true")
    parser.add_argument("folder", nargs="?", default="out/crack_life", type=pathlib.Path)
    given = parser.parse_args()
    given.folder.mkdir(parents=True, exist_ok=True)
    model = lap()
    life = model.grow_fatigue(**SPECTRUM, detectable=0.002)
    life.write_csv(given.folder / "life.csv")
    print(f"{life.cycles:.4g} cycles, {life.stop_reason.name} at crack {life.crack}, an inspection every {life.interval:.3g} cycles")
    print(str(model.explain()).rsplit("By cycles, ", 1)[-1])
    found = bempd.ensemble(life_of, materials(100 if given.full else 2 if given.short else 12), results=given.folder / "scatter.jsonl")
    logs = np.log10(found.values("cycles"))
    print(f"{len(found)} materials: mean life {10 ** logs.mean():.4g}, standard deviation of its logarithm {logs.std(ddof=1):.3f}")
    with open(given.folder / "summary.csv", "w", encoding="utf-8") as file:
        file.write("life [cycles],steps,error,interval [cycles],materials,mean life [cycles],deviation of log10\n")
        file.write(f"{life.cycles:.6g},{life.steps},{life.error:.2g},{life.interval:.6g},{len(found)},{10 ** logs.mean():.5g},{logs.std(ddof=1):.3f}\n")
    if not given.short:
        from picture import draw, film

        draw(model, life, 10**logs, given.folder)
        filmed = film(lap(), SPECTRUM, given.folder / "crack_life.gif")
        print(f"film: {filmed.cycles:.4g} cycles, {filmed.stop_reason.name} at crack {filmed.crack}")
    return len(found.errors)


if __name__ == "__main__":
    raise SystemExit(main())
