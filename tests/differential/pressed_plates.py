"""Random plates with crossing cracks, pressed, sheared and pulled, under loads of which some are constant: parts come free,
faces press on them and open on the way. No call fails, and each has forces and energies in balance.

    pressed_plates.py [--first SEED] [--count N] [--rule line|bond] [--contact faces|none]

Prints a line for every plate that fails and a summary; exits with 1 if any does."""

from __future__ import annotations

import argparse
import math
import random
import sys
from typing import Optional

import bempd

EVENTS = 40
MOST_RESIDUAL, MOST_IMBALANCE = 1e-8, 1e-8


def add_cracks(model: bempd.Model, width: int, height: int, choose: random.Random) -> None:
    for _ in range(choose.choice((1, 2, 3, 5, 8))):
        x, y = choose.uniform(1, width - 1), choose.uniform(1, height - 1)
        angle, length = choose.uniform(0, 2 * math.pi), choose.uniform(2, 0.7 * max(width, height))
        end = (min(max(x + length * math.cos(angle), 0.07), width - 0.07), min(max(y + length * math.sin(angle), 0.07), height - 0.07))
        model.add_crack([(0 if choose.random() < 0.3 else x, y), end])


def add_loads(model: bempd.Model, body: int, width: int, height: int, choose: random.Random) -> None:
    sign = choose.choice((-1, -1, 1))
    if choose.random() < 0.2:
        corner = (0 if choose.random() < 0.3 else width, height)
        model.add_point_force(corner, choose.choice("xy"), sign * 4e-3, constant=choose.choice((0, 1e-3)))
    kind = choose.randrange(5)
    if kind in (0, 4):
        model.prescribe_edge(body, 3, "y", sign * 1e-3 * height)
    if kind == 1:
        model.add_traction(body, 3, "y", sign * 1e-3)
    if kind in (2, 4):
        model.prescribe_edge(body, 3, "x", choose.choice((-1, 1)) * 1e-3 * height)
    if kind == 2:
        model.add_traction(body, 3, "y", 0, constant=-choose.choice((1e-3, 3e-4)))
    if kind == 3:
        model.add_point_force((width, height), choose.choice("xy"), sign * 4e-3)


def build(seed: int, rule: str, contact: str) -> bempd.Model:
    choose = random.Random(seed)
    width, height, horizon = choose.randrange(6, 26), choose.randrange(6, 20), choose.choice((2, 3, 3, 4))
    model = bempd.Model(options={"contact": contact, "crack.rule": rule,
                                 "crack.tie_share": choose.choice((1e-3, 0.0, 0.02))})
    material = model.add_material(young_modulus=1, poisson_ratio=1 / 3, critical_stretch=1e-3)
    body = model.add_pd_region(material, bempd.rectangle(0, 0, width, height), 1, horizon)
    add_cracks(model, width, height, choose)
    if choose.random() < 0.25:
        model.fix_edge(body, 1, "y")
        model.fix_point((0, 0), "x")
    else:
        model.fix_edge(body, 1, "both")
    add_loads(model, body, width, height, choose)
    return model


def failure(seed: int, rule: str, contact: str) -> Optional[str]:
    event = 0
    try:
        model = build(seed, rule, contact)
        for event in range(1, EVENTS + 1):
            report = model.step_to_next_event(1e4)
            if report.residual > MOST_RESIDUAL or report.energy_balance_error > MOST_IMBALANCE:
                return f"event {event}: residual {report.residual:.1e}, balance {report.energy_balance_error:.1e}"
            if report.stop_reason != bempd.StopReason.EVENT:
                return None
    except bempd.Error as failed:
        return f"event {event}: {failed}"
    return None


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--rule", choices=("line", "bond"), default="line")
    parser.add_argument("--contact", choices=("faces", "none"), default="faces")
    given = parser.parse_args()
    failed = 0
    for seed in range(given.first, given.first + given.count):
        if found := failure(seed, given.rule, given.contact):
            failed += 1
            print(f"plate {seed}, {given.rule}, {given.contact}: {found}", flush=True)
    print(f"{given.count} plates, {given.rule}, {given.contact}: {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
