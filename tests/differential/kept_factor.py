"""Cracks that grow in a sheet cut into subdomains, whose factor takes over most of the one before: the same digits come from
a run in one piece, from one with cancelled steps, from a saved state in a model that has no factor yet, and from a
second restoring of it. Faces of cracks are pressed, unless the sheet is pulled, and begin as they were before growth.

    kept_factor.py [--steps N] [--pulled] [--verbose]

Exits with 1 if any digit differs."""

from __future__ import annotations

import argparse
import os
import sys

import bempd

os.environ["BEMPD_TEST_HOOKS"] = "1"  # option test.subdomain_elements
MOST_SOLVES = 5  # of a scene, in the mean; with all faces open at first they are 6


def build(pressed: bool) -> bempd.Model:
    """A sheet with nine holes of three sizes, cracks at three of them and one between others."""
    model = bempd.Model(options={"test.subdomain_elements": 24, "threads": 1})
    solid = model.add_material(young_modulus=1, poisson_ratio=0.3, fracture_energy=1e-9)
    sheet = model.add_bem_region(solid, bempd.rectangle(0, 0, 3, 3), 1 / 3)
    for cell in range(9):
        radius = (0.2, 0.24, 0.17)[cell % 3]
        model.add_circular_hole(sheet, (cell % 3 + 0.5, cell // 3 + 0.5), radius)
        if cell % 4 == 0:
            begin = (cell % 3 + 0.5 + radius, cell // 3 + 0.5)
            model.add_crack([begin, (begin[0] + 0.08, begin[1] + 0.03)])
    model.add_crack([(1.9, 0.98), (2.1, 1.02)])
    model.fix_edge(sheet, 4)
    model.add_traction(sheet, 2, "x", proportional=-1e-3 if pressed else 1e-3)
    model.add_traction(sheet, 2, "y", proportional=5e-4)
    return model


def answer(model: bempd.Model) -> tuple[float, ...]:
    report = model.step_to_next_event(1e9)
    factors = [value for tip in model.tips() for value in (tip.stress_intensity_1, tip.stress_intensity_2, tip.error)]
    return (report.load_factor, report.stored_energy, report.work, *factors, *model.reaction(1))


class Stopped(Exception):
    """What a host says that ends a step."""


def stop(*_: object) -> None:
    raise Stopped


def cancelled(model: bempd.Model) -> None:
    """A step that the host cancels after its event, which leaves the model as it was."""
    model.progress = stop
    try:
        model.step_to_next_event(1e9)
    except Stopped:
        model.progress = None
    assert model.progress is None, "the step was not cancelled"


def differences(pressed: bool, steps: int, verbose: bool) -> list[str]:
    model, found = build(pressed), []
    middle, state = steps // 2, None
    straight, solves = [], 0
    for step in range(steps):
        straight.append(answer(model))
        solves += model.statistics().solves
        if step == middle:
            state = model.save()
    assert state is not None and model.statistics().subdomains >= 8

    def compare(name: str, own: list[tuple[float, ...]], expected: list[tuple[float, ...]]) -> None:
        found.extend(f"{name}, step {k}: {a} instead of {b}" for k, (a, b) in enumerate(zip(own, expected)) if a != b)
    if solves >= MOST_SOLVES * steps:
        found.append(f"{solves} solutions in the scenes of {steps} steps, in which most faces stay closed or open")
    restored = build(pressed)
    restored.restore(state)
    compare("restored", [answer(restored) for _ in range(middle + 1, steps)], straight[middle + 1:])
    model.restore(state)
    compare("restored in the run itself", [answer(model) for _ in range(middle + 1, steps)], straight[middle + 1:])
    other, own = build(pressed), []
    for _ in range(steps):
        cancelled(other)
        own.append(answer(other))
    compare("cancelled", own, straight)
    if verbose:
        print(*straight, sep="\n")
    return found


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("--steps", type=int, default=4)
    parser.add_argument("--pulled", action="store_true")
    parser.add_argument("--verbose", action="store_true")
    arguments = parser.parse_args()
    found = differences(not arguments.pulled, arguments.steps, arguments.verbose)
    print("\n".join(found) or f"the same digits in all {arguments.steps} steps")
    return int(bool(found))


if __name__ == "__main__":
    sys.exit(main())
