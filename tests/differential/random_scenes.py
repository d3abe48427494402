"""Random bodies of boundary element and peridynamic boxes, torn with windows and without: both must break the same bonds at
the same loads, with equilibrium and energy balance held to stated bounds.

    random_scenes.py [--first SEED] [--count N] [--also SEED ...] [--ratio NU] [--outlined] [--lines] [--elements] [--verbose]

A scene follows from its number alone. Prints one line for every scene that fails and a summary; exits with 1 if any does."""

from __future__ import annotations

import argparse
import dataclasses
import math
import os
import random
import sys
from typing import Any, Optional

import numpy as np

import bempd

os.environ["BEMPD_TEST_HOOKS"] = "1"  # options whose names begin with test.

# An answer whose forces or energies are off by more is no answer.
MOST_RESIDUAL, MOST_IMBALANCE = 1e-8, 1e-8
# Differences allowed between windows and whole bodies, relative to the largest value.
LOADS, ENERGIES, REACTIONS = 1e-7, 1e-6, 1e-6
# Digits of stretches, relative to those at the first event, that both solvers have: an event at 10,000 times its load
# factor has lost four.
STRETCHES = 1e-11
# Largest load factor over that of the first event, or over 10 (loads are such that bonds break at about 1): so many
# digits of the stretches are lost.
MOST_GROWTH, FIRST = 1e5, 10
# Energies far below those that bonds take, about 1e-7 each: where all loads are lost at the first event, rounding is left.
SMALL_ENERGY = 1e-15
EVENTS = 40
POISSON_RATIO = 1 / 3
OUTLINED = False  # lattices in any direction, with points on their outline
ELEMENTS = False  # boxes of boundary elements have cracks, too
LINES = False  # all cracks grow as lines, else every second scene's; and no scene ends in an error that has none bond by bond


@dataclasses.dataclass
class Outcome:
    error: Optional[str]
    history: Any
    reactions: list[np.ndarray]
    reports: list[bempd.StepReport]


def add_cracks(model: bempd.Model, boxes: list[tuple[int, int]], columns: list[str], height: int,
               choose: random.Random) -> None:
    for _ in range(choose.choice((0, 1, 1, 1, 2, 4, 12))):
        inner = [box for box, kind in zip(boxes, columns) if kind == "lattice"]
        if not inner:
            return
        left, right = choose.choice(inner)
        x = choose.randrange(left, right) + 0.5
        low = choose.choice((0, choose.randrange(0, height - 1) + 0.5))
        high = choose.randrange(int(low), height) + 0.5
        if high > low:
            slant = choose.choice((0, 0, 0.31, -0.27))
            far = min(max(x + slant * (high - low), left + 0.03), right - 0.03)
            model.add_crack([(x, low), (far, high)])


def add_cracks_with_elements(model: bempd.Model, boxes: list[tuple[int, int]], columns: list[str], height: int,
                             choose: random.Random) -> None:
    """One in each box that has room for it, inside or from its upper edge."""
    for (left, right), kind in zip(boxes, columns):
        if kind == "lattice" or right - left < 5 or height < 6 or choose.random() < 0.2:
            continue
        x, slant = choose.uniform(left + 2, right - 2), choose.uniform(-0.4, 0.4)
        low, high = choose.uniform(1.5, 0.4 * height), choose.choice((height, choose.uniform(0.55 * height, height - 1.5)))
        model.add_crack([(x, high), (min(max(x + slant * (high - low), left + 1), right - 1), low)])


def add_hole(model: bempd.Model, regions: list[int], boxes: list[tuple[int, int]], columns: list[str], height: int,
             choose: random.Random) -> None:
    for region, (left, right), kind in zip(regions, boxes, columns):
        if kind == "lattice" and min(right - left, height) > 10 and choose.random() < 0.5:
            model.add_circular_hole(region, (0.5 * (left + right), 0.5 * height), choose.choice((1.5, 2.2)))


def build(seed: int, solver: str, rule: str = "line") -> tuple[bempd.Model, int, float]:
    choose = random.Random(seed)
    options = {"test.solver": solver, "crack.tie_share": choose.choice((1e-3, 1e-3, 0.0, 0.02))}
    angle = 0.0
    if OUTLINED:
        options |= {"test.outline_points": "always"}
        angle = choose.choice((0, 0.3, 0.7))
    options |= {"crack.rule": rule if LINES or seed % 2 == 0 else "bond"}
    model = bempd.Model(options=options)
    # A fracture energy belongs to cracks with elements; with it a bond of three spacings' horizon breaks at about 1e-3.
    breaks = {"fracture_energy": 1.6e-6} if ELEMENTS else {"critical_stretch": 1e-3}
    glass = model.add_material(young_modulus=1, poisson_ratio=POISSON_RATIO, **breaks)
    height, horizon = choose.randrange(4, 16), choose.choice((3, 4) if OUTLINED else (2, 3, 3, 4))
    columns = [choose.choice(("lattice", "lattice", "boundary")) for _ in range(choose.randrange(1, 5))]
    boxes, x = [], 0
    for _ in columns:
        boxes.append((x, x + choose.randrange(3, 16)))
        x = boxes[-1][1]
    regions = []
    for (left, right), kind in zip(boxes, columns):
        outline = bempd.rectangle(left, 0, right, height)
        if kind == "lattice":
            regions.append(model.add_pd_region(glass, outline, 1, horizon, lattice_angle=angle))
        else:
            regions.append(model.add_bem_region(glass, outline, choose.choice((2.0, 4.0))))
    for k, kind in enumerate(columns):
        for neighbour, edge in ((k - 1, 4), (k + 1, 2)):
            touches = kind == "boundary" and 0 <= neighbour < len(columns) and columns[neighbour] == "lattice"
            if touches and choose.random() < 0.4:
                model.set_edge_mesh(regions[k], edge, choose.choice((1.3, 2.0, 3.1)))
    if OUTLINED:
        add_hole(model, regions, boxes, columns, height, choose)
    add_cracks(model, boxes, columns, height, choose)
    if ELEMENTS:
        add_cracks_with_elements(model, boxes, columns, height, random.Random(seed))
    supports = add_conditions(model, regions, columns, height, boxes, choose, -1 if seed % 5 == 0 else 1)
    return model, supports, choose.choice((1.0, 1.0, 3.0))


def add_conditions(model: bempd.Model, regions: list[int], columns: list[str], height: int,
                   boxes: list[tuple[int, int]], choose: random.Random, sign: int) -> int:
    model.fix_edge(regions[0], 4, choose.choice(("both", "both", "x")))
    if model_is_loose := choose.random() < 0.5:
        model.fix_point((0, 0), "y")
    supports = 2 if model_is_loose else 1
    end = regions[-1]
    way = choose.randrange(6)
    if way < 3:
        model.prescribe_edge(end, 2, choose.choice("xxy"), sign * 1e-3 * boxes[-1][1])
        supports += 1
    elif way == 3:
        model.add_traction(end, 2, "x", sign * 1e-3)
    elif way == 4:
        model.add_traction(end, 2, choose.choice("xy"), sign * 1e-3, constant=choose.choice((0, 3e-4)))
    else:
        model.add_point_force((boxes[-1][1], height), choose.choice("xy"), 4e-3)
    middle = choose.randrange(len(regions))
    edge = choose.choice((1, 3))
    if choose.random() < 0.3:
        model.prescribe_edge(regions[middle], edge, choose.choice("xy"), choose.choice((0, 2e-3)),
                             constant=choose.choice((0, 1e-3)), part=choose.choice(((0, 1), (0.25, 0.5))))
        supports += 1
    if columns[middle] == "boundary" and len(regions) > 1 and choose.random() < 0.2:
        model.prescribe_edge(regions[middle], 4 if middle else 2, "y", 1e-3)
        supports += 1
    return supports


def follow(model: bempd.Model, supports: int, limit: float, events: int) -> Outcome:
    """The model from event to event, with the reactions of all its supports."""
    outcome = Outcome(None, None, [], [])
    try:
        for _ in range(events):
            report = model.step_to_next_event(limit)
            outcome.reports.append(report)
            outcome.reactions.append(np.array([model.reaction(s) for s in range(1, supports + 1)]))
            if report.stop_reason != bempd.StopReason.EVENT:
                break
    except bempd.Error as failed:
        outcome.error = f"{type(failed).__name__}: {failed}"
    return outcome


def run(seed: int, solver: str, rule: str = "line") -> Outcome:
    try:
        model, supports, limit = build(seed, solver, rule)
    except bempd.ArgumentError as refused:  # of both solvers alike
        return Outcome(str(refused), None, [], [])
    outcome = follow(model, supports, 1e9 * limit, EVENTS)
    outcome.history = model.history() if outcome.reports else None
    model.close()
    return outcome


def unsound(outcome: Outcome) -> Optional[str]:
    for number, report in enumerate(outcome.reports, 1):
        values = [getattr(report, name) for name in ("load_factor", "stored_energy", "released_energy", "work",
                                                     "energy_balance_error", "residual")]
        if not np.isfinite(values).all():
            return f"event {number}: a value is not finite"
        if report.residual > MOST_RESIDUAL:
            return f"event {number}: residual {report.residual:.2g}"
        if report.energy_balance_error > MOST_IMBALANCE:
            return f"event {number}: energy balance {report.energy_balance_error:.2g}"
    return None


def far_out(outcome: Outcome) -> bool:
    """What breaks there hardly feels the load: its stretch has lost as many digits."""
    loads = [report.load_factor for report in outcome.reports]
    return bool(loads) and loads[-1] > MOST_GROWTH * min(loads[0], FIRST)


def difference(plain: Outcome, window: Outcome) -> Optional[str]:
    if plain.error != window.error:
        return f"plain: {plain.error}; window: {window.error}"
    largest_energy = max([abs(r.work) for r in plain.reports] + [SMALL_ENERGY])
    # Scale of forces where no reaction is left: the rounding of those that stored the work (Young's modulus is 1).
    natural = math.sqrt(largest_energy)
    size = max((np.abs(r).max() for r in plain.reactions), default=0) + natural + 1e-300
    for number, (a, b) in enumerate(zip(plain.reports, window.reports), 1):
        first = min(plain.reports[0].load_factor, FIRST)
        if a.load_factor > MOST_GROWTH * first:
            return None  # what breaks there hardly feels the load: its stretch has lost as many digits
        if a.total_broken_bonds != b.total_broken_bonds or a.stop_reason != b.stop_reason:
            return (f"event {number}: {a.total_broken_bonds} bonds, {a.stop_reason.name}; with windows "
                    f"{b.total_broken_bonds}, {b.stop_reason.name}")
        close = max(LOADS, STRETCHES * a.load_factor / first) if first > 0 else LOADS
        if abs(a.load_factor - b.load_factor) > close * abs(a.load_factor):
            return f"event {number}: load factor {a.load_factor} and {b.load_factor}"
        for name in ("stored_energy", "released_energy", "work"):
            if abs(getattr(a, name) - getattr(b, name)) > ENERGIES * largest_energy:
                return f"event {number}: {name} {getattr(a, name)} and {getattr(b, name)}"
        off = np.abs(plain.reactions[number - 1] - window.reactions[number - 1]).max()
        if off > REACTIONS * size:
            return f"event {number}: reactions differ by {off / size:.2g}"
    if len(plain.reports) != len(window.reports):
        return f"{len(plain.reports)} events, with windows {len(window.reports)}"
    if plain.history is not None:
        for name in plain.history.dtype.names:
            if name in ("residual", "energy_balance_error"):
                continue
            a, b = plain.history[name].astype(float), window.history[name].astype(float)
            size = np.abs(a).max(initial=0)
            if "energy" in name:
                size = max(size, largest_energy)
            if name == "resistance":  # rounding of nothing where the first event separates the body
                size = max(size, np.abs(plain.history["resistance_before"]).max(initial=0))
            if len(a) != len(b) or np.abs(a - b).max(initial=0) > ENERGIES * size:
                return f"history: {name} differs"
    return None


def arguments_with(count: int) -> argparse.Namespace:
    global POISSON_RATIO, OUTLINED, LINES, ELEMENTS
    parser = argparse.ArgumentParser()
    parser.add_argument("--first", type=int, default=1)
    parser.add_argument("--count", type=int, default=count)
    parser.add_argument("--also", type=int, nargs="*", default=[], help="scenes that failed once")
    parser.add_argument("--ratio", type=float, default=POISSON_RATIO, help="Poisson's ratio")
    parser.add_argument("--outlined", action="store_true", help="points on outlines, lattices turned")
    parser.add_argument("--lines", action="store_true", help="all cracks grow as lines")
    parser.add_argument("--elements", action="store_true", help="cracks with boundary elements, too")
    parser.add_argument("--verbose", action="store_true")
    arguments = parser.parse_args()
    POISSON_RATIO, OUTLINED, LINES, ELEMENTS = arguments.ratio, arguments.outlined, arguments.lines, arguments.elements
    return arguments


def main() -> int:
    arguments = arguments_with(count=200)
    failed = compared = refused = 0
    seeds = [*range(arguments.first, arguments.first + arguments.count), *arguments.also]
    for seed in seeds:
        plain, window = run(seed, "plain"), run(seed, "window")
        finding = unsound(plain) or unsound(window) or difference(plain, window)
        if LINES and plain.error and not far_out(plain) and not run(seed, "plain", "bond").error:
            finding = finding or f"bonds: no error; lines: {plain.error}"
        compared += len(plain.reports)
        refused += 1 if plain.error else 0
        failed += 1 if finding else 0
        if finding:
            print(f"scene {seed}: {finding}", flush=True)
        elif arguments.verbose:
            print(f"scene {seed}: {len(plain.reports)} events, {plain.error}", flush=True)
    print(f"{len(seeds)} scenes, {compared} events compared, {refused} ended with an error, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
