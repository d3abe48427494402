"""What does not depend on how a scene is said: random bodies of random_scenes.py in other units, shifted, turned by 90 degrees,
with their regions added in another order; restarted from state bytes at every event; and reactions that balance the loads.

    properties.py [--first SEED] [--count N] [--also SEED ...] [--verbose]

Prints one line for every property of a scene that fails and a summary; exits with 1 if any does."""

from __future__ import annotations

import sys
from typing import Any, Callable, Optional

import numpy as np

import bempd
import random_scenes
from random_scenes import Outcome

# What rounding may change, relative to the largest value; where bonds tie within it, they may break one event apart.
LOADS, REACTIONS = 1e-7, 1e-6
# Reactions and loads against the largest of them, or against a force far below those that break bonds; the larger the load
# factor the larger it is, because supports that move a body without stress leave rounding as their reactions.
MOST_UNBALANCED, SMALL_FORCE = 1e-8, 1e-6
EVENTS = 12


class Recorder:
    """Takes a model's place while a scene is built, and keeps what was said."""

    def __init__(self, options: dict[str, Any]) -> None:
        # One by one, bonds that are alike by symmetry break in an order that rounding decides.
        self.options = {**options, "crack.tie_share": max(options["crack.tie_share"], 1e-3)}
        self.calls: list[tuple[str, list[Any], dict[str, Any]]] = []
        self.regions = 0

    def __getattr__(self, name: str) -> Callable[..., int]:
        def record(*values: Any, **named: Any) -> int:
            self.calls.append((name, list(values), named))
            self.regions += name.endswith("_region")
            return self.regions if name.endswith("_region") else 1
        return record


class Saying:
    """The identity; others override what they change. `force`, `displacement` and `turned` act on results and values."""

    length, modulus = 1.0, 1.0

    def place(self, point: Any) -> tuple[float, float]:
        return (point[0] * self.length, point[1] * self.length)

    def turned(self, component: str) -> tuple[str, float]:
        return component, 1.0

    def vector(self, v: np.ndarray) -> np.ndarray:
        return v

    def order(self, regions: int) -> list[int]:
        return list(range(regions))


class Units(Saying):
    def __init__(self, length: float, modulus: float) -> None:
        self.length, self.modulus = length, modulus


class Shift(Saying):
    def place(self, point: Any) -> tuple[float, float]:
        return (point[0] + 512.0, point[1] - 37.0)


class Turn(Saying):
    def place(self, point: Any) -> tuple[float, float]:
        return (-point[1], point[0])

    def turned(self, component: str) -> tuple[str, float]:
        return {"x": ("y", 1.0), "y": ("x", -1.0), "both": ("both", 1.0)}[component]

    def vector(self, v: np.ndarray) -> np.ndarray:
        return np.stack([-v[..., 1], v[..., 0]], axis=-1)


class Renumbered(Saying):
    def order(self, regions: int) -> list[int]:
        return list(reversed(range(regions)))


def say(recorder: Recorder, saying: Saying) -> bempd.Model:
    """Builds the recorded scene as `saying` has it."""
    model = bempd.Model(options=recorder.options)
    order = saying.order(recorder.regions)
    number = {old + 1: new + 1 for new, old in enumerate(order)}
    added = [call for call in recorder.calls if call[0].endswith("_region")]
    others = [call for call in recorder.calls if not call[0].endswith("_region")]
    materials = [call for call in others if call[0] == "add_material"]
    rest = [call for call in others if call[0] != "add_material"]
    for name, values, named in materials + [added[k] for k in order] + rest:
        translate(saying, number, name, values := list(values), named := dict(named))
        getattr(model, name)(*values, **named)
    return model


def scale_values(values: list[Any], named: dict[str, Any], place: int, factor: float) -> None:
    if len(values) > place:
        values[place] = values[place] * factor
    if "constant" in named:
        named["constant"] = named["constant"] * factor


def translate(saying: Saying, number: dict[int, int], name: str, values: list[Any], named: dict[str, Any]) -> None:
    length, stress = saying.length, saying.modulus
    if name == "add_material":
        named["young_modulus"] *= saying.modulus
    elif name.endswith("_region"):
        values[1] = [saying.place(vertex) for vertex in values[1]]
        values[2] *= length
    elif name == "add_crack":
        values[0] = [saying.place(point) for point in values[0]]
    elif name == "set_edge_mesh":
        values[0], values[2] = number[values[0]], values[2] * length
    elif name in ("fix_point", "add_point_force"):
        values[0] = saying.place(values[0])
        values[1], sign = saying.turned(values[1])
        scale_values(values, named, 2, sign * stress * length)
    elif name in ("fix_edge", "prescribe_edge", "add_traction"):
        values[0] = number[values[0]]
        values[2], sign = saying.turned(values[2])
        scale_values(values, named, 3, sign * (stress if name == "add_traction" else length))
    else:
        raise AssertionError(f"no translation for {name}")


def record(seed: int) -> tuple[Recorder, int]:
    original = random_scenes.bempd.Model
    random_scenes.bempd.Model = Recorder
    try:
        recorder, supports, _ = random_scenes.build(seed, ("window", "plain")[seed // 2 % 2])
    finally:
        random_scenes.bempd.Model = original
    return recorder, supports


def run(model: bempd.Model, supports: int) -> Outcome:
    outcome = random_scenes.follow(model, supports, 1e9, EVENTS)
    if outcome.error:
        outcome.error = outcome.error.split(":")[0]  # the sentence speaks of numbers, which have other units
    return outcome


def small_force(report: bempd.StepReport) -> float:
    return SMALL_FORCE * max(1.0, abs(report.load_factor))


def difference(recorder: Recorder, one: Outcome, other: Outcome, saying: Saying) -> Optional[str]:
    """Of two lines that are alike by symmetry the one that grows first is left to rounding, of places within the tie band in which
    lines may begin the one of least number is taken: where something else breaks the comparison ends."""
    lines = recorder.options["crack.rule"] != "bond"
    first = min(one.reports[0].load_factor, random_scenes.FIRST) if one.reports else 0
    size = max((max(np.abs(r).max(), small_force(report)) for r, report in zip(one.reactions, one.reports)), default=0)
    for event, (a, b) in enumerate(zip(one.reports, other.reports), 1):
        if a.load_factor > random_scenes.MOST_GROWTH * first:
            return None  # what breaks there hardly feels the load
        same_load = abs(a.load_factor - b.load_factor) <= LOADS * abs(a.load_factor)
        if a.total_broken_bonds != b.total_broken_bonds:
            return None if lines and same_load else f"event {event}: {a.total_broken_bonds} bonds; otherwise {b.total_broken_bonds}"
        if not same_load:
            if lines and abs(a.load_factor - b.load_factor) <= recorder.options["crack.tie_share"] * abs(a.load_factor):
                return None
            if lines and event > 1 and went_another_way(recorder, saying, event - 1):
                return None
            return f"event {event}: load factor {a.load_factor}; otherwise {b.load_factor}"
        expected = saying.vector(one.reactions[event - 1])
        found = other.reactions[event - 1] / (saying.length * saying.modulus)
        off = np.abs(expected - found).max() / size
        if off > REACTIONS:
            return None if lines else f"event {event}: reactions differ by {off:.2g}"
    if one.error != other.error or len(one.reports) != len(other.reports):
        return f"{one.error}, {len(one.reports)} events; otherwise {other.error}, {len(other.reports)}"
    return None


def broken_places(model: bempd.Model, recorder: Recorder, saying: Saying) -> np.ndarray:
    """Middles of all broken bonds, shape [bonds][2]."""
    added = [name for name, _, _ in recorder.calls if name.endswith("_region")]
    found = [np.empty((0, 2))]
    for region, old in enumerate(saying.order(recorder.regions), 1):
        if added[old] == "add_bem_region":
            continue
        bonds, points = model.bonds(region), model.field(region, "position")
        ends = bonds.points[bonds.states == bempd.BondState.BROKEN]
        found.append((points[ends[:, 0]] + points[ends[:, 1]]) / 2)
    return np.concatenate(found)


def went_another_way(recorder: Recorder, saying: Saying, events: int) -> bool:
    """Whether after as many events other bonds are broken, though as many at the same loads: they are alike by symmetry."""
    one, other = say(recorder, Saying()), say(recorder, saying)
    for model in (one, other):
        for _ in range(events):
            model.step_to_next_event(1e9)
    expected = np.array([saying.place(place) for place in broken_places(one, recorder, Saying())]) / saying.length
    found = broken_places(other, recorder, saying) / saying.length
    apart = np.abs(expected[:, None, :] - found[None, :, :]).max(axis=2)
    return bool((apart.min(axis=1) > 1e-6).any())


def imbalance(recorder: Recorder, outcome: Outcome) -> Optional[str]:
    """Loads and reactions add up to nothing, as long as no piece has come free with the loads on it or at the end."""
    corners = [values[1] for name, values, _ in recorder.calls if name.endswith("_region")]
    for report, reactions in zip(outcome.reports, outcome.reactions):
        if report.fragments or report.stop_reason == bempd.StopReason.SEPARATED:
            return None
        total, size = reactions.sum(axis=0), max(np.abs(reactions).max(), small_force(report))
        for name, values, named in recorder.calls:
            if name not in ("add_traction", "add_point_force"):
                continue
            edge = values[1] if name == "add_traction" else 0
            outline = np.array(corners[values[0] - 1]) if edge else None
            length = np.linalg.norm(outline[edge % 4] - outline[edge - 1]) if edge else 1.0
            component, value = values[2:4] if edge else values[1:3]
            force = length * (value * report.load_factor + named.get("constant", 0))
            total[{"x": 0, "y": 1}[component]] += force
            size = max(size, abs(force))
        if np.abs(total).max() > MOST_UNBALANCED * size:
            return f"reactions and loads add up to {total} at load factor {report.load_factor}"
    return None


def restarted(recorder: Recorder) -> Optional[str]:
    """From the bytes of every state another model goes on to the same event, to the last bit, as one does that nobody saves."""
    model, unsaved = (say(recorder, Saying()) for _ in range(2))
    try:
        for one in (model, unsaved):
            one.prepare()
        for event in range(1, EVENTS + 1):
            data = model.save().to_bytes()
            other = say(recorder, Saying())
            other.restore(bempd.State.from_bytes(data))
            a, *others = (one.step_to_next_event(1e9) for one in (model, other, unsaved))
            for b in others:
                if (a.load_factor, a.total_broken_bonds, a.work) != (b.load_factor, b.total_broken_bonds, b.work):
                    return (f"event {event}: {a.load_factor}, {a.total_broken_bonds} bonds; otherwise {b.load_factor}, "
                            f"{b.total_broken_bonds}")
            if model.save().to_bytes() != other.save().to_bytes():
                return f"event {event}: other state bytes"
            if a.stop_reason != bempd.StopReason.EVENT:
                break
    except bempd.Error:
        return None
    same = model.save().to_bytes() == unsaved.save().to_bytes()
    return None if same else "other state bytes without saves"


SAYINGS: dict[str, Saying] = {"lengths x 1e-6": Units(1e-6, 1), "lengths x 1e5, moduli x 1e9": Units(1e5, 1e9),
                              "moduli x 1e-12": Units(1, 1e-12), "shift": Shift(), "turn": Turn(),
                              "renumbering": Renumbered()}


def main() -> int:
    arguments = random_scenes.arguments_with(count=20)
    failed = events = compared = 0
    for seed in [*range(arguments.first, arguments.first + arguments.count), *arguments.also]:
        recorder, supports = record(seed)
        try:
            one = run(say(recorder, Saying()), supports)
        except bempd.ArgumentError:  # of the scene, however it is said
            continue
        findings = {"balance": imbalance(recorder, one), "restart": restarted(recorder)}
        for name, saying in SAYINGS.items():
            findings[name] = difference(recorder, one, run(say(recorder, saying), supports), saying)
        events, compared = events + len(one.reports), compared + 1
        failed += any(findings.values())
        for name, finding in findings.items():
            if finding or arguments.verbose:
                print(f"scene {seed}, {name}: {finding or 'holds'}", flush=True)
    print(f"{arguments.count + len(arguments.also)} scenes, {compared} of them run, {events} events, {len(SAYINGS) + 2} properties each, "
          f"{failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
