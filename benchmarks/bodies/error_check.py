"""Estimated errors of random bodies against true ones, which come from a much finer mesh.

usage: BEMPD_TEST_HOOKS=1 error_check.py [first seed] [count]
"""

from __future__ import annotations

import sys
from typing import Any

import numpy as np

import bempd
from random_bodies import RandomBody

def answers(model: bempd.Model, body: int) -> dict[str, Any]:
    """Displacements of nodes by place, reactions and stress intensity factors at the load factor 1."""
    model.step(1)
    places, moved = model.field(body, "position"), model.field(body, "displacement")
    by_place: dict[tuple[float, float], list[Any]] = {}
    for place, u in zip(np.round(places, 9), moved):
        by_place.setdefault(tuple(place), []).append(u)
    return {"displacement": {place: us[0] for place, us in by_place.items() if len(us) == 1},
            "reaction": np.array([model.reaction(support) for support in range(1, len(model._sketch.supports) + 1)]),
            "stress_intensity": np.array([(tip.stress_intensity_1, tip.stress_intensity_2) for tip in model.tips()])}


def true_errors(found: dict[str, Any], exact: dict[str, Any]) -> dict[str, float]:
    same = found["displacement"].keys() & exact["displacement"].keys()
    scale = max(np.linalg.norm(u) for u in exact["displacement"].values())
    errors = {"displacement": max(np.linalg.norm(found["displacement"][p] - exact["displacement"][p]) for p in same) / scale}
    for kind in ("reaction", "stress_intensity"):
        if len(exact[kind]) == 0 or not np.any(exact[kind]):
            errors[kind] = 0.0
            continue
        size = np.linalg.norm(exact[kind], axis=1).max()
        errors[kind] = float(np.linalg.norm(found[kind] - exact[kind], axis=1).max() / size)
    return errors


def check(seed: int, largest: int = 500) -> list[tuple[float, float]]:
    """Told and true error of a random body with its elements halved once and twice, against elements halved three times.

    The differences from those are the true errors times 1 - 1/64 and 1 - 1/8, by the order 3. Nothing for large bodies.
    """
    found, told = [], []
    for halvings in (1, 2, 3):
        model, body = RandomBody(seed).build(0.02, **{"test.halvings": halvings})
        model.prepare()
        plan = model.plan()
        if plan.boundary_elements > largest:
            return []
        found.append(answers(model, body))
        told.append(max(plan.displacement_error, plan.reaction_error, plan.intensity_error))
    true = [max(true_errors(one, found[2]).values()) * share for one, share in zip(found, (64 / 63, 8 / 7))]
    return [(said, error) for said, error in zip(told, true) if error > 1e-8]


def table(first: int, count: int) -> list[str]:
    """How many estimates are at least the true error, and at most three times it."""
    ratios = []
    for seed in range(first, first + count):
        try:
            ratios += [said / true for said, true in check(seed)]
        except bempd.Error as error:
            print(seed, type(error).__name__, error, file=sys.stderr)
    ratios.sort()
    enough, close = sum(ratio >= 1 for ratio in ratios), sum(ratio <= 3 for ratio in ratios)
    return ["| random bodies, at most 500 elements when halved three times | meshes | tell at least the true error | at most three times it "
            "| told over true | in the middle |", "|---|---|---|---|---|---|",
            f"| seeds {first} to {first + count - 1} | {len(ratios)} | {enough} | {close} | {ratios[0]:.2f} to {ratios[-1]:.1f} "
            f"| {ratios[len(ratios) // 2]:.1f} |"]


if __name__ == "__main__":
    print("\n".join(table(*(int(word) for word in (sys.argv[1:] + ["1", "40"][len(sys.argv) - 1:])))))
