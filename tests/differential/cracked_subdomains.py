"""Random sheets with holes and cracks that are once whole and once cut into subdomains around the cracks. Both must
answer alike: stored energy, stress intensity factors, openings, displacements and stresses inside, reactions, and the
loads and places of growth.

    cracked_subdomains.py [--first SEED] [--count N] [--steps N] [--verbose]

Prints one line for every sheet that differs and a summary; exits with 1 if any does."""

from __future__ import annotations

import argparse
import math
import os
import random
import sys
import warnings
from typing import Any

import bempd
import numpy as np

os.environ["BEMPD_TEST_HOOKS"] = "1"  # option test.subdomain_elements
WHOLE = 10**9
# Largest differences over the largest value; of reactions, over the load; of growth, over the load and over the side of
# a cell. The elements' own error is some 1e-3 of the stress intensity factors, and more of stresses.
ENERGY, FACTOR, FIELD, STRESS, REACTION, LOAD, PLACE = 1e-4, 2e-4, 3e-4, 1e-2, 1e-8, 2e-4, 1e-5
LOADS = ("pull", "shear", "weight", "pressure", "squeeze", "heat")


def build(seed: int, most: int) -> tuple[bempd.Model, int, list[int]]:
    """Sheet with a round hole in each cell. Cracks begin at holes or lie between them; some lead from hole to hole."""
    choose = random.Random(seed)
    cells, load = choose.choice((2, 3, 3)), LOADS[seed % len(LOADS)]
    model = bempd.Model(options={"test.subdomain_elements": most, "threads": 1})
    solid = model.add_material(young_modulus=1000, poisson_ratio=0.3, fracture_energy=1e-3, thermal_expansion=1e-3)
    sheet = model.add_bem_region(solid, bempd.rectangle(0, 0, cells, cells), 1 / 5)
    holes = []
    for i in range(cells):
        for j in range(cells):
            radius = choose.uniform(0.14, 0.26)
            centre = (i + 0.5 + choose.uniform(-0.1, 0.1), j + 0.5 + choose.uniform(-0.1, 0.1))
            holes.append((centre, radius))
            first = model.add_circular_hole(sheet, centre, radius)
            for edge in range(first, first + 4):
                model.set_edge_mesh(sheet, edge, 2 * math.pi * radius / 16)
    cracks = []
    for hole in choose.sample(range(cells * cells), choose.choice((1, 2, 3))):
        (x, y), radius = holes[hole]
        angle, length = choose.uniform(0, 2 * math.pi), choose.uniform(0.06, 0.14)
        if choose.random() < 0.25 and hole % cells + 1 < cells:  # to the next hole
            (x2, y2), radius2 = holes[hole + 1]
            way = math.hypot(x2 - x, y2 - y)
            ends = [radius / way, 1 - radius2 / way]
            points = [(x + (x2 - x) * end, y + (y2 - y) * end) for end in ends]
        else:
            from_hole = radius if choose.random() < 0.7 else radius + 0.06
            points = [(x + way * math.cos(angle), y + way * math.sin(angle)) for way in (from_hole, from_hole + length)]
        cracks.append(model.add_crack(points))
    model.fix_edge(sheet, 4)
    if load == "pull":
        model.add_traction(sheet, 2, "x", proportional=1)
    elif load == "shear":
        model.add_traction(sheet, 2, "y", proportional=1)
    elif load == "weight":
        model.add_body_force(sheet, "x", 0.5, constant=0.3)
        model.add_body_force(sheet, "y", -0.2)
    elif load == "pressure":
        for crack in cracks:
            model.add_crack_pressure(crack, proportional=1)
    elif load == "squeeze":
        model.add_traction(sheet, 2, "x", proportional=-1)
        model.add_traction(sheet, 2, "y", proportional=-0.5)
    else:
        model.add_temperature_function(sheet, lambda x, y: (1 + 0.2 * x - 0.1 * y, 0.0))
    return model, sheet, cracks


def inside(model: bempd.Model, sheet: int, seed: int) -> tuple[Any, Any]:
    """Displacements and stresses at places between the holes, near the borders of cells."""
    choose = random.Random(seed)
    side = model.copy_field(sheet, "position").max()
    places = []
    for _ in range(60):
        across, along = round(choose.uniform(0.6, side - 0.6)) + choose.uniform(-0.08, 0.08), choose.uniform(0, side)
        places.append((across, along) if choose.random() < 0.5 else (along, across))
    found = model.evaluate(places)
    return found.displacement, np.asarray(found.stress)


def answers(seed: int, most: int, steps: int) -> dict[str, Any]:
    model, sheet, cracks = build(seed, most)
    report = model.step(0.001)
    tips = model.tips()
    found: dict[str, Any] = {"subdomains": model.statistics().subdomains, "energy": np.array([report.stored_energy])}
    found["factor"] = np.array([[tip.stress_intensity_1, tip.stress_intensity_2] for tip in tips])
    openings = [model.crack_opening(crack, [0.2, 0.5, 0.8]) for crack in cracks]
    found["opening"] = np.array([[*one] for one in openings])
    found["inside"], found["stress"] = inside(model, sheet, seed)
    found["reaction"] = np.array(model.reaction(1))
    loads = []
    for _ in range(steps):
        try:
            step = model.step_to_next_event(1e9)
        except bempd.Error as error:
            loads.append(f"{type(error).__name__}")
            break
        if step.events == 0:
            break
        loads.append(step.load_factor)
    found["loads"] = loads
    found["places"] = np.array([(grown.x, grown.y) for grown in model.extensions()])
    return found


LIMITS = {"energy": ENERGY, "factor": FACTOR, "opening": FIELD, "inside": FIELD, "stress": STRESS, "reaction": REACTION}


def difference(seed: int, steps: int) -> tuple[int, str, dict[str, float]]:
    whole = answers(seed, WHOLE, steps)
    cut = answers(seed, 50, steps)
    off: dict[str, float] = {}
    for name in LIMITS:
        if whole[name].shape != cut[name].shape:
            return cut["subdomains"], f"{name} has another shape", off
        largest = np.abs(whole[name]).max(initial=1e-300) if name != "reaction" else 1.0
        off[name] = float(np.abs(cut[name] - whole[name]).max(initial=0) / largest)
    said = "; ".join(f"{name} {off[name]:.1e} off" for name in LIMITS if not off[name] <= LIMITS[name])
    if [isinstance(load, str) for load in whole["loads"]] != [isinstance(load, str) for load in cut["loads"]]:
        return cut["subdomains"], said + f" steps {whole['loads']} whole, {cut['loads']} cut", off
    pairs = [(a, b) for a, b in zip(whole["loads"], cut["loads"]) if not isinstance(a, str)]
    off["loads"] = max((abs(b / a - 1) for a, b in pairs), default=0.0)
    if len(whole["places"]) == len(cut["places"]) > 0:
        off["places"] = float(np.abs(whole["places"] - cut["places"]).max())
    if off["loads"] > LOAD or off.get("places", 0.0) > PLACE or len(whole["places"]) != len(cut["places"]):
        said += f" growth {off['loads']:.1e} and {off.get('places')} off"
    return cut["subdomains"], said, off


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("--first", type=int, default=1)
    parser.add_argument("--count", type=int, default=24)
    parser.add_argument("--steps", type=int, default=3)
    parser.add_argument("--verbose", action="store_true")
    arguments = parser.parse_args()
    warnings.simplefilter("ignore")
    found = cut = 0
    worst: dict[str, float] = {}
    for seed in range(arguments.first, arguments.first + arguments.count):
        subdomains, sentence, off = difference(seed, arguments.steps)
        cut += subdomains > 0
        for name, value in off.items():
            worst[name] = max(worst.get(name, 0.0), value)
        if arguments.verbose:
            print(seed, subdomains, " ".join(f"{name} {value:.1e}" for name, value in off.items()), flush=True)
        if sentence:
            found += 1
            print(f"sheet {seed}, {subdomains} subdomains: {sentence}", flush=True)
    print("largest differences: " + ", ".join(f"{name} {value:.1e}" for name, value in worst.items()))
    print(f"{arguments.count} sheets, {cut} cut around cracks: {found} differ")
    return 1 if found or cut < arguments.count // 2 else 0


if __name__ == "__main__":
    sys.exit(main())
