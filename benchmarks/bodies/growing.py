"""Told and true errors of runs in which cracks of random bodies grow: load of first growth, peak and path.

usage: BEMPD_TEST_HOOKS=1 growing.py [first seed] [count]
"""

from __future__ import annotations

import math
import random
import sys
from typing import Any

import numpy as np

import bempd

EVENTS = 6
Place = tuple[float, float]


def build(seed: int, **options: Any) -> bempd.Model:
    """A plate, often with a hole, that is pulled or sheared, with one crack from an edge or inside."""
    choose = random.Random(seed)
    model = bempd.Model(options={"stepping.control": "path", "error.wanted": choose.choice((0.1, 0.02, 0.005)), **options})
    solid = model.add_material(young_modulus=1000, poisson_ratio=choose.uniform(0, 0.4), fracture_energy=1e-3,
                               plane=choose.choice(("stress", "strain")))
    width, height = choose.uniform(1.5, 3), choose.uniform(1.5, 3)
    lean = choose.uniform(-0.3, 0.3)
    body = model.add_body(solid, [(0, 0), (width, 0), (width + lean, height), (lean, height)])
    middle = height * choose.uniform(0.35, 0.65)
    if choose.random() < 0.6:
        radius = choose.uniform(0.1, 0.2) * height
        model.add_circular_hole(body, (0.65 * width, middle + choose.choice((-1, 1)) * radius * choose.uniform(1.1, 1.5)), radius)
    length, angle = choose.uniform(0.1, 0.25) * width, choose.uniform(-0.6, 0.6)
    start = (lean * middle / height, middle) if choose.random() < 0.5 else (0.12 * width, middle)
    model.add_crack([start, (start[0] + length * math.cos(angle), start[1] + length * math.sin(angle))])
    if start[0] == 0.12 * width:
        model.set_tip_frozen(1, bempd.TipEnd.START)
    model.fix_edge(body, 1)
    if choose.random() < 0.5:
        model.add_traction(body, 3, "y", proportional=1)
        model.add_traction(body, 3, "x", proportional=choose.uniform(-0.4, 0.4))
    else:
        model.prescribe_edge(body, 3, "y", proportional=1)
        model.prescribe_edge(body, 3, "x", proportional=choose.uniform(-0.4, 0.4))
    return model


def curve(model: bempd.Model) -> tuple[list[Place], Any]:
    """Growth and resistance before each event, and the extensions."""
    extensions, grown, found = model.extensions(), 0.0, []
    for row in model.history():
        if row["event"]:
            found.append((grown, float(row["resistance_before"])))
            grown += sum(e.length for e in extensions if e.event == row["event"])
    return found, extensions


def peak(places: list[Place], end: float) -> float:
    """Largest resistance until cracks have grown by `end`."""
    grown, values = zip(*places)
    return float(max([v for g, v in places if g <= end * (1 + 1e-9)] + [np.interp(end, grown, values)]))


def apart(path: Any, other: Any) -> float:
    """Largest distance of the vertices of a crack's path from another path that goes as far, or a little farther."""
    line = np.array([(other[0].from_x, other[0].from_y)] + [(e.x, e.y) for e in other])
    most, length, ends = 0.0, 0.0, sum(e.length for e in other)
    for e in path:
        length += e.length
        if length > ends * (1 + 1e-9):
            break
        a, way = line[:-1], np.diff(line, axis=0)
        t = np.clip(np.einsum("ij,ij->i", (e.x, e.y) - a, way) / np.einsum("ij,ij->i", way, way), 0, 1)
        most = max(most, np.linalg.norm((e.x, e.y) - a - t[:, None] * way, axis=1).min())
    return most


def reference(seed: int, least_elements: float) -> bempd.Model:
    """The run with extensions a fifth as long and the least halvings that make so many elements."""
    for halvings in range(2, 6):
        model = build(seed, **{"test.halvings": halvings, "test.step_share": 0.2})
        model.prepare()
        if model.plan().boundary_elements >= least_elements:
            break
    return model


def check(seed: int, events: int = EVENTS) -> dict[str, tuple[float, float]]:
    """Told and true errors of a run. The true ones compare with elements halved once more and extensions a fifth as long, those of the
    first growth with elements halved twice: errors of small bodies are told by elements halved once."""
    model = build(seed)
    for _ in range(events):
        if model.step_to_next_event(1e9).stop_reason != bempd.StopReason.EVENT:
            break
    places, path = curve(model)
    told = model.run_error_estimate()
    elements = build(seed).plan().boundary_elements
    finer, finest = reference(seed, 1.8 * elements), reference(seed, 3.5 * elements)
    finest.step_to_next_event(1e9)
    end, goal = places[-1][0], sum(e.length for e in path)
    for _ in range(100 * events):
        if (finer.step_to_next_event(1e9).stop_reason != bempd.StopReason.EVENT
                or sum(e.length for e in finer.extensions()) >= goal):
            break
    exact, exact_path = curve(finer)
    return {"first growth": (told.first_growth, abs(path[0].load_factor / curve(finest)[1][0].load_factor - 1)),
            "peak": (told.peak, abs(peak(places, end) / peak(exact, end) - 1)),
            "path": (told.path, apart(path, exact_path))}


def table(first: int, count: int) -> list[str]:
    """How many estimates are at least the true error, and at most three times it. Seeds whose hole does not fit are left out."""
    found: dict[str, list[tuple[float, float]]] = {"first growth": [], "peak": [], "path": []}
    seed = first
    while len(found["path"]) < count:
        try:
            for kind, pair in check(seed).items():
                found[kind].append(pair)
            print(seed, {kind: f"{pairs[-1][0]:.2g} {pairs[-1][1]:.2g}" for kind, pairs in found.items()}, file=sys.stderr, flush=True)
        except bempd.Error as error:
            print(seed, error, file=sys.stderr)
        seed += 1
    lines = ["| error of | runs | true | tell at least it | at most three times it | told over true | in the middle |",
             "|---|---|---|---|---|---|---|"]
    for kind, pairs in found.items():
        pairs = [(told, true) for told, true in pairs if true > 1e-6]
        ratios = sorted(told / true for told, true in pairs)
        true_errors = [true for _, true in pairs]
        lines.append(f"| {kind} | {len(ratios)} | {min(true_errors):.1e} to {max(true_errors):.1e} | {sum(r >= 1 for r in ratios)} "
                     f"| {sum(r <= 3 for r in ratios)} | {ratios[0]:.2f} to {ratios[-1]:.1f} | {ratios[len(ratios) // 2]:.1f} |")
    return lines


if __name__ == "__main__":
    print("\n".join(table(*(int(word) for word in (sys.argv[1:] + ["201", "12"][len(sys.argv) - 1:])))))
