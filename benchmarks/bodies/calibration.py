"""Errors that are told against true ones, for scenes that nobody has chosen: of displacements, reactions, stress intensity factors,
stresses at places, the load of first growth, and of peak and paths of runs.

usage: BEMPD_TEST_HOOKS=1 calibration.py [first seed] [scenes] [runs]
"""

from __future__ import annotations

import math
import random
import sys
from typing import Any, Callable

import numpy as np

import bempd
from growing import apart, curve, peak
from random_bodies import Corners, inside

EVENTS = 6
WANTED = (0.03, 0.01, 0.003)
REFERENCE = 1e-4  # wanted error of references, which grades their elements; these are halved more often too
WHOLE = {"test.subdomain_elements": 1e9}  # references are not cut: cuts change factors and stresses by up to 2e-4
LEAST = 1e-6  # true errors below this do not count
GROWTH = ("first growth of a run", "peak", "path")
STATIC = ("displacement", "reaction", "stress intensity", "load of first growth")
Pairs = dict[str, tuple[float, float]]  # error told and true, by what it is of


class Scene:
    """A scene by its number: an outline, holes, cracks inside or from edges, supports and loads."""

    def __init__(self, seed: int) -> None:
        self.seed = seed
        self.wanted = WANTED[seed % len(WANTED)]

    def build(self, grows: bool, wanted: float = 0, **options: Any) -> tuple[bempd.Model, int]:
        """Model and body; if cracks do not grow, their material is a million times as tough."""
        choose = random.Random(self.seed)
        model = bempd.Model(options={"stepping.control": "path", "error.wanted": wanted or self.wanted, **options})
        solid = model.add_material(young_modulus=1000, poisson_ratio=choose.uniform(0, 0.45),
                                   fracture_energy=1e-3 if grows else 1e9, plane=choose.choice(("stress", "strain")))
        corners = outline(choose)
        body = model.add_body(solid, corners)
        taken = cracks(choose, model, corners)
        holes(choose, model, body, corners, taken)
        conditions(choose, model, body, len(corners))
        return model, body


def outline(choose: random.Random) -> Corners:
    """The last edge is the left one, the first one the lower one."""
    kind = choose.choice(("rectangle", "parallelogram", "corner", "polygon"))
    width, height = choose.uniform(1, 3), choose.uniform(1, 3)
    lean = choose.uniform(-0.3, 0.3)
    if kind == "rectangle":
        return [(0, 0), (width, 0), (width, height), (0, height)]
    if kind == "parallelogram":
        return [(0, 0), (width, lean), (width + lean, height), (lean, height)]
    if kind == "corner":
        inner, step = width * choose.uniform(0.4, 0.7), height * choose.uniform(0.4, 0.7)
        return [(0, 0), (width, 0), (width, step), (inner, step), (inner, height), (0, height)]
    return [(0, 0), (width, 0), (1.2 * width, 0.5 * height), (width, height), (0.3 * width, 1.1 * height), (0, height)]


def cracks(choose: random.Random, model: bempd.Model, corners: Corners) -> list[tuple[float, float, float]]:
    """One or two cracks, and circles around them. Tips that go on are those away from the edge a crack begins at."""
    taken: list[tuple[float, float, float]] = []
    (lx, ly), (ux, uy) = corners[-1], corners[0]
    width = max(x for x, _ in corners)
    wanted = choose.choice((1, 1, 2))
    for _ in range(20):
        if len(taken) == wanted:
            break
        length, angle = choose.uniform(0.08, 0.25) * width, choose.uniform(-0.7, 0.7)
        from_edge = choose.random() < 0.5 and not taken
        if from_edge:
            at = choose.uniform(0.3, 0.7)
            start = (lx + at * (ux - lx), ly + at * (uy - ly))
        else:
            angle *= 2
            start = (choose.uniform(0.1, 0.7) * width, choose.uniform(0.2, 0.8) * ly)
        end = (start[0] + length * math.cos(angle), start[1] + length * math.sin(angle))
        middle = ((start[0] + end[0]) / 2, (start[1] + end[1]) / 2)
        is_free = all(math.hypot(middle[0] - x, middle[1] - y) > 1.1 * (length / 2 + r) for x, y, r in taken)
        if is_free and inside(corners, end) and inside(corners, middle) and (from_edge or inside(corners, start)):
            model.add_crack([start, end])
            taken.append((*middle, length / 2))
    return taken


def holes(choose: random.Random, model: bempd.Model, body: int, corners: Corners, taken: list[tuple[float, float, float]]) -> None:
    width, height = max(x for x, _ in corners), max(y for _, y in corners)
    for _ in range(choose.choice((0, 0, 1, 1, 2))):
        x, y, radius = choose.uniform(0.15, 0.85) * width, choose.uniform(0.15, 0.85) * height, choose.uniform(0.05, 0.15) * min(width, height)
        ring = [(x + 1.1 * radius * math.cos(k * math.pi / 6), y + 1.1 * radius * math.sin(k * math.pi / 6)) for k in range(12)]
        if all(inside(corners, place) for place in ring) and all(math.hypot(x - a, y - b) > 1.1 * (radius + r) for a, b, r in taken):
            model.add_circular_hole(body, (x, y), radius)
            taken.append((x, y, radius))


def conditions(choose: random.Random, model: bempd.Model, body: int, edges: int) -> None:
    """Supports below, loads above: edges of number 3 to the last but one of those with more than four corners are above too."""
    top = edges - 1
    way = choose.choice(("clamp", "clamp", "slide", "part"))
    if way == "clamp":
        model.fix_edge(body, 1)
    elif way == "slide":
        model.fix_edge(body, 1, "y")
        model.fix_point((0, 0), "x")
    else:
        held = (0, choose.uniform(0.3, 0.8))
        for component in "xy":
            model.prescribe_edge(body, 1, component, constant=0, part=held)
    shear = 0 if way == "slide" else choose.uniform(-0.5, 0.5)  # a force on the point has no finite displacement
    load = choose.choice(("traction", "traction", "part", "linear", "pull", "weight"))
    if load == "pull":
        model.prescribe_edge(body, top, "y", proportional=0.01)
        if shear and choose.random() < 0.5:
            model.prescribe_edge(body, top, "x", proportional=0.01 * shear)
        return
    if load == "part":
        start = choose.uniform(0, 0.4)
        model.add_traction(body, top, "y", proportional=1, part=(start, start + choose.uniform(0.2, 0.5)))
    elif load == "linear":
        model.add_traction(body, top, "y", proportional=[choose.uniform(0, 1), 1])
    elif load == "weight":
        model.add_body_force(body, "y", proportional=1)
    else:
        model.add_traction(body, top, "y", proportional=1)
    if shear:
        model.add_traction(body, top, "x", proportional=shear)


def distances(found: Any, exact: Any) -> float:
    """Largest difference of vectors over the largest vector."""
    scale = np.linalg.norm(exact, axis=-1).max() if len(exact) else 0
    return float(np.linalg.norm(found - exact, axis=-1).max() / scale) if scale else 0.0


def single_nodes(model: bempd.Model, body: int) -> tuple[Any, Any]:
    """Places of nodes and their displacements, without those that two nodes have."""
    places, moved = model.field(body, "position"), model.field(body, "displacement")
    _, index, counts = np.unique(np.round(places, 9), axis=0, return_index=True, return_counts=True)
    return places[index[counts == 1]], moved[index[counts == 1]]


def finer(scene: Scene, grows: bool, elements: float, **options: Any) -> tuple[bempd.Model, int]:
    """The scene with the least halvings that make so many elements."""
    for halvings in range(2, 7):
        model, body = scene.build(grows, REFERENCE, **{"test.halvings": halvings, **options})
        model.prepare()
        if model.plan().boundary_elements >= elements:
            break
    return model, body


def reactions(model: bempd.Model) -> Any:
    return np.array([model.reaction(support) for support in range(1, len(model._sketch.supports) + 1)])


def factors(model: bempd.Model) -> Any:
    return np.array([(tip.stress_intensity_1, tip.stress_intensity_2) for tip in model.tips()])


def exact_answers(scene: Scene, elements: float, places: Any) -> dict[str, Any]:
    """Answers with at least so many elements; displacements and stresses are those at places."""
    model, body = finer(scene, False, elements, **WHOLE)
    model.step(1)
    values = model.evaluate_in(body, places, stress=False)
    return {"displacement": values.displacement, "reaction": reactions(model), "stress intensity": factors(model),
            "load": model.plan().growth_load_factor, "stress": model.evaluate(stressed(scene, body, model, places)).stress}


def stressed(scene: Scene, body: int, model: bempd.Model, places: Any) -> Any:
    """Twelve nodes and twelve places inside at which stresses are compared."""
    choose = random.Random(scene.seed)
    found = [tuple(places[k]) for k in choose.sample(range(len(places)), 12)]
    low, high = places.min(axis=0), places.max(axis=0)
    while len(found) < 24:
        place = choose.uniform(low[0], high[0]), choose.uniform(low[1], high[1])
        try:
            model.evaluate([place], stress=False)
        except bempd.ArgumentError:
            continue
        found.append(place)
    return np.array(found)


def stress_errors(scene: Scene, body: int, model: bempd.Model, places: Any, exact: Any) -> Pairs:
    """Of each place where stress is bounded, in shares of the mean stress."""
    where = stressed(scene, body, model, places)
    told, apart_by = model.evaluate_errors(where).stress, model.evaluate(where).stress - exact
    true = np.sqrt(apart_by[:, 0] ** 2 + apart_by[:, 1] ** 2 + 2 * apart_by[:, 2] ** 2)
    scale = np.abs(exact).mean()
    return {f"stress {'on edges' if k < 12 else 'inside'}{' ' * k}": (told[k] / scale, true[k] / scale)
            for k in range(len(where)) if np.isfinite(told[k])}


def static_errors(scene: Scene) -> Pairs:
    """Of the results at the load factor 1, as the plan tells them and as the estimate of the present results does."""
    model, body = scene.build(False)
    model.step(1)
    places, moved = single_nodes(model, body)
    plan, now = model.plan(), model.error_estimate()
    exact = exact_answers(scene, 3.5 * plan.boundary_elements, places)
    true = {"displacement": distances(moved, exact["displacement"]), "reaction": distances(reactions(model), exact["reaction"]),
            "stress intensity": distances(factors(model), exact["stress intensity"]), "load of first growth": 0.0}
    if max(plan.growth_load_factor, exact["load"]) < 1e300:
        true["load of first growth"] = abs(plan.growth_load_factor / exact["load"] - 1)
    told = (plan.displacement_error, plan.reaction_error, plan.intensity_error, plan.growth_load_error)
    told_now = (now.displacement, now.reaction, now.stress_intensity, now.growth_load)
    pairs = {kind: (said, true[kind]) for kind, said in zip(STATIC, told)}
    pairs.update({f"{kind}, present": (said, true[kind]) for kind, said in zip(STATIC, told_now)})
    for number, (tip, own) in enumerate(zip(model.tips(), exact["stress intensity"])):
        true_error = float(np.hypot(tip.stress_intensity_1 - own[0], tip.stress_intensity_2 - own[1]))
        pairs[f"stress intensity, one tip{' ' * number}"] = (tip.error / np.hypot(*own), true_error / np.hypot(*own))
    pairs.update(stress_errors(scene, body, model, places, exact["stress"]))
    return pairs


def grown(model: bempd.Model) -> float:
    return float(sum(e.length for e in model.extensions()))


def advance(model: bempd.Model, goes_on: Callable[[int], bool]) -> None:
    count = 0
    while goes_on(count) and model.step_to_next_event(1e9).stop_reason == bempd.StopReason.EVENT:
        count += 1


def exact_run(scene: Scene, elements: float, length: float) -> tuple[Any, Any]:
    """Growth and resistance before each event, and the extensions, of a run with extensions a fifth as long."""
    model, _ = finer(scene, True, elements, **{"test.step_share": 0.2})
    advance(model, lambda count: count < 60 * EVENTS and grown(model) < length)
    return curve(model)


def run_errors(scene: Scene) -> Pairs:
    """Of a run of some extensions."""
    model, _ = scene.build(True)
    model.prepare()
    elements = model.plan().boundary_elements
    advance(model, lambda count: count < EVENTS)
    if not model.extensions():
        return {}
    places, path = curve(model)
    told = model.run_error_estimate()
    found, exact_path = exact_run(scene, 1.8 * elements, grown(model))
    tips = {(e.crack, e.end) for e in (*path, *exact_path)}
    paths = [[[e for e in extensions if (e.crack, e.end) == tip] for extensions in (path, exact_path)] for tip in tips]
    away = max(apart(one, other) if one and other else sum(e.length for e in one or other) for one, other in paths)
    first, end = path[0].load_factor / exact_path[0].load_factor, places[-1][0]
    return dict(zip(GROWTH, ((told.first_growth, abs(first - 1)), (told.peak, abs(peak(places, end) / peak(found, end) - 1)),
                             (told.path, away))))


def collect(first: int, scenes: int, runs: int) -> dict[str, list[tuple[float, float]]]:
    """Errors told and true of scenes from a number on. Scenes that are refused are left out, and named."""
    found: dict[str, list[tuple[float, float]]] = {}
    for seed in range(first, first + max(scenes, runs)):
        for errors, count in ((static_errors, scenes), (run_errors, runs)):
            if seed >= first + count:
                continue
            try:
                pairs = errors(Scene(seed))
            except bempd.Error as error:
                print(seed, errors.__name__, error, file=sys.stderr, flush=True)
                continue
            for kind, (told, true) in pairs.items():
                found.setdefault(kind.strip(), []).append((told, true))
                mark = "" if true < LEAST else "low" if told < true else "high" if told > 3 * true else ""
                print(seed, Scene(seed).wanted, kind.strip(), f"{told:.3g} {true:.3g} {mark}", file=sys.stderr, flush=True)
    return found


def table(first: int, scenes: int, runs: int) -> list[str]:
    """How many errors told are at least the true one, and at most three times it."""
    lines = [f"| error of, seeds {first} to {first + scenes - 1} | values | true | tell at least it | at most three times it "
             "| told over true | in the middle |", "|---|---|---|---|---|---|---|"]
    for kind, pairs in sorted(collect(first, scenes, runs).items()):
        pairs = [pair for pair in pairs if pair[1] > LEAST]
        if not pairs:
            continue
        ratios, true = sorted(told / error for told, error in pairs), [error for _, error in pairs]
        lines.append(f"| {kind} | {len(ratios)} | {min(true):.1e} to {max(true):.1e} | {sum(r >= 1 for r in ratios)} "
                     f"| {sum(r <= 3 for r in ratios)} | {ratios[0]:.2g} to {ratios[-1]:.2g} | {ratios[len(ratios) // 2]:.1f} |")
    return lines


if __name__ == "__main__":
    print("\n".join(table(*(int(word) for word in (sys.argv[1:] + ["101", "40", "8"][len(sys.argv) - 1:])))))
