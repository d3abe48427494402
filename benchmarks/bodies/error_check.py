"""Estimated errors of random bodies against true ones, which come from a much finer mesh.

usage: error_check.py [first seed] [count]
"""

from __future__ import annotations

import math
import random
import sys
from typing import Any

import numpy as np

import bempd
from random_bodies import RandomBody

KINDS = ("displacement", "reaction", "stress_intensity")


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


def check(seed: int) -> dict[str, Any]:
    wanted = random.Random(seed + 1000).choice((0.1, 0.03, 0.01, 0.003, 0.001))
    model, body = RandomBody(seed).build(wanted)
    found = answers(model, body)
    plan, estimate = model.plan(), model.error_estimate()
    finer, same = RandomBody(seed).build(min(1e-5, wanted / 300), **{"budget.seconds": 8})
    exact = answers(finer, same)
    true = true_errors(found, exact)
    left = finer.plan()
    if max(left.displacement_error, left.reaction_error, left.intensity_error) > 0.2 * max(true.values()):
        raise bempd.ConvergenceError(f"the finer mesh is not fine enough: {left} {true} {plan}")
    return {"seed": seed, "wanted": wanted, "elements": plan.boundary_elements, "seconds": plan.seconds + plan.seconds_spent,
            "finer": finer.plan().boundary_elements,
            "true": true,
            "plan": dict(zip(KINDS, (plan.displacement_error, plan.reaction_error, plan.intensity_error))),
            "now": {"displacement": estimate.displacement, "reaction": estimate.reaction,
                    "stress_intensity": estimate.stress_intensity}}


def main() -> None:
    first, count = (int(word) for word in (sys.argv[1:] + ["1", "40"][len(sys.argv) - 1:]))
    rows = []
    for seed in range(first, first + count):
        try:
            row = check(seed)
        except bempd.Error as error:
            print(seed, type(error).__name__, error)
            continue
        rows.append(row)
        print(f"{seed:4d} {row['wanted']:6.3f} {row['elements']:5d} {row['finer']:5d} {row['seconds']:6.2f}s " + "  ".join(
            f"{kind[:5]} true {row['true'][kind]:.1e} plan {row['plan'][kind]:.1e} now {row['now'][kind]:.1e}" for kind in KINDS), flush=True)
    for which in ("plan", "now"):
        for kind in (*KINDS, "largest"):
            pairs = [(max(row[which].values()), max(row["true"].values())) if kind == "largest" else
                     (row[which][kind], row["true"][kind]) for row in rows]
            ratios = sorted(said / true for said, true in pairs if true > 1e-8)
            if ratios:
                print(f"{which} {kind}: {len(ratios)} scenes, at least the true one {sum(r >= 1 for r in ratios) / len(ratios):.2f}, "
                      f"at most three times it {sum(r <= 3 for r in ratios) / len(ratios):.2f}, median {ratios[len(ratios) // 2]:.2f}, "
                      f"range {ratios[0]:.2f} to {ratios[-1]:.2f}")
    met = sum(max(row["true"].values()) <= row["wanted"] for row in rows)
    print(f"{met} of {len(rows)} have true errors within the wanted one")


if __name__ == "__main__":
    main()
