"""Cracks do not depend on how their scene is said: random plates with cracks that grow as lines, bond by bond or with boundary
elements, mirrored, turned by 90 degrees, with their parts added in another order, and in other units.

    same_cracks.py [--first SEED] [--count N] [--carrier lines|bonds|elements] [--verbose]

The same crack grows at the same load by the same way. Where a report tells of a tie, rounding may choose among cracks or places
that are alike: the other ways to say the scene tell of it too, at the same load, and what follows is not compared. In plates that are their own mirror image the
loads are compared, and of cracks that are alike the one of least number grows, however often the scene is said.
Prints one line for every scene that fails and a summary; exits with 1 if any does."""

from __future__ import annotations

import argparse
import dataclasses
import math
import random
import sys
from typing import Any, Optional

import numpy as np

import bempd

CARRIERS = ("lines", "bonds", "elements")
EVENTS = {"lines": 10, "bonds": 25, "elements": 5}
# What rounding may change of load factors, and of places over the plate's size. Places of elements follow from loads and angles.
LOADS, PLACES = 1e-7, 1e-6


class Saying:
    """The scene as it is; others override what they change."""

    length, modulus, thickness, mirrored, reordered = 1.0, 1.0, 1.0, False, False

    def place(self, point: Any) -> tuple[float, float]:
        return (point[0] * self.length, point[1] * self.length)

    def vector(self, component: str) -> tuple[str, float]:
        return component, 1.0


class Mirrored(Saying):
    mirrored = True

    def place(self, point: Any) -> tuple[float, float]:
        return (-point[0], point[1])

    def vector(self, component: str) -> tuple[str, float]:
        return component, -1.0 if component == "x" else 1.0


class Turned(Saying):
    def place(self, point: Any) -> tuple[float, float]:
        return (-point[1], point[0])

    def vector(self, component: str) -> tuple[str, float]:
        return {"x": ("y", 1.0), "y": ("x", -1.0)}[component]


class Reordered(Saying):
    reordered = True


class Units(Saying):
    length, modulus, thickness = 1e-3, 2e11, 4e-3


SAYINGS: dict[str, Saying] = {"mirrored": Mirrored(), "turned": Turned(), "reordered": Reordered(), "in other units": Units()}


@dataclasses.dataclass
class Scene:
    carrier: str
    size: tuple[int, int]
    horizon: int
    cracks: list[list[tuple[float, float]]]
    loads: list[tuple[int, str, float, float]]  # edge, component, constant and proportional traction
    control: str = "path"


def apart(a: list[tuple[float, float]], b: list[tuple[float, float]]) -> float:
    places = [np.array(line[0]) + np.linspace(0, 1, 20)[:, None] * (np.array(line[-1]) - np.array(line[0])) for line in (a, b)]
    return float(np.linalg.norm(places[0][:, None] - places[1][None], axis=2).min())


def random_scene(seed: int, carrier: str) -> Scene:
    choose = random.Random(1000 * seed + CARRIERS.index(carrier))
    width, height = choose.randrange(20, 30), choose.randrange(18, 26)
    cracks: list[list[tuple[float, float]]] = []
    wanted = choose.choice((2, 3)) if seed % 3 == 0 else choose.choice((1, 2, 3))
    for _ in range(200):
        if len(cracks) == wanted:
            break
        centre = (choose.uniform(5, width - 5), choose.uniform(5, height - 5))
        angle, half = choose.uniform(0, math.pi), choose.uniform(1.7, 4)
        ends = [(centre[0] + s * half * math.cos(angle), centre[1] + s * half * math.sin(angle)) for s in (-1, 1)]
        inside = all(3.2 < x < width - 3.2 and 3.2 < y < height - 3.2 for x, y in ends)
        if inside and all(apart(ends, other) > 3.2 for other in cracks):
            cracks.append(ends)
    bend = random.Random(seed)  # every other crack has a corner
    for ends in cracks:
        (x0, y0), (x1, y1) = ends
        along, aside = bend.uniform(0.4, 0.6), bend.choice((-1, 0, 0, 1)) * bend.uniform(0.05, 0.2)
        if aside:
            ends.insert(1, (x0 + along * (x1 - x0) - aside * (y1 - y0), y0 + along * (y1 - y0) + aside * (x1 - x0)))
    pull, side, shear = choose.uniform(0.5, 1), choose.uniform(-0.2, 0.4), choose.uniform(-0.2, 0.2)
    # A constant load: none, one that leaves all cracks at rest, or one that is too much for several of them at once.
    overloaded = seed % 3 == 0
    constant = choose.uniform(0.02, 0.03) if overloaded else choose.choice((0.0, choose.uniform(0.001, 0.003)))
    if overloaded:
        pull = -1e-3 * pull  # so that no crack has a load factor at which it grows
    loads = [(3, "y", constant, pull), (1, "y", -constant, -pull), (2, "x", 0.0, side), (4, "x", 0.0, -side)]
    # Shear on all four edges balances.
    loads += [(3, "x", 0.0, shear), (1, "x", 0.0, -shear), (2, "y", 0.0, shear), (4, "y", 0.0, -shear)]
    return Scene(carrier, (width, height), choose.choice((3, 4)), cracks, loads, "load" if overloaded else "path")


def symmetric_scene(seed: int, carrier: str) -> Scene:
    """Two cracks that are each other's mirror image, in a plate that is its own: both grow at the same load."""
    choose = random.Random(7000 + seed)
    half, height = choose.randrange(12, 15), choose.randrange(18, 24)
    x, y, angle, reach = choose.uniform(5.3, 6.5), height / 2 + 0.27, choose.uniform(-0.3, 0.3), choose.uniform(1.7, 2.3)
    right = [(half + x + s * reach * math.cos(angle), y + s * reach * math.sin(angle)) for s in (-1, 1)]
    left = [(2 * half - px, py) for px, py in right]
    return Scene(carrier, (2 * half, height), 3, [right, left], [(3, "y", 0.0, 1.0), (1, "y", 0.0, -1.0)])


def say(scene: Scene, saying: Saying) -> tuple[bempd.Model, int, list[int]]:
    """The model, its region, and for each of its cracks the number that it has in the scene."""
    model = bempd.Model(options={"crack.rule": "bond" if scene.carrier == "bonds" else "line", "stepping.control": scene.control})
    stress = saying.modulus
    material = model.add_material(young_modulus=saying.modulus, poisson_ratio=1 / 3, thickness=saying.thickness,
                                  fracture_energy=1e-3 * saying.modulus * saying.length)
    width, height = scene.size
    corners = [saying.place(corner) for corner in ((0, 0), (width, 0), (width, height), (0, height))]
    if saying.mirrored:
        corners.reverse()
    edge_of = {edge: (4 - 2 - (edge - 1)) % 4 + 1 if saying.mirrored else edge for edge in (1, 2, 3, 4)}
    if scene.carrier == "elements":
        region = model.add_bem_region(material, corners, 3 * saying.length)
    else:
        region = model.add_pd_region(material, corners, saying.length, scene.horizon)
    numbers = list(range(len(scene.cracks)))
    loads = list(scene.loads)
    if saying.reordered:
        numbers.reverse()
        loads.reverse()
    for number in numbers:
        model.add_crack([saying.place(point) for point in scene.cracks[number]])
    for edge, component, constant, proportional in loads:
        component, sign = saying.vector(component)
        model.add_traction(region, edge_of[edge], component, sign * stress * proportional, constant=sign * stress * constant)
    first, second = saying.place((0, 0)), saying.place((width, 0))
    for point, component in ((first, "x"), (first, "y"), (second, "y")):
        model.fix_point(point, saying.vector(component)[0])
    return model, region, [0] + [number + 1 for number in numbers]


@dataclasses.dataclass
class Event:
    load_factor: float
    crack: int            # of the scene, that grew; 0: unknown
    places: np.ndarray    # of what has grown or broken so far
    is_tie: bool


def broken(model: bempd.Model, region: int) -> np.ndarray:
    bonds, points = model.bonds(region), model.field(region, "position")
    gone = bonds.points[bonds.states == bempd.BondState.BROKEN]
    return (points[gone[:, 0]] + points[gone[:, 1]]) / 2


def follow(scene: Scene, saying: Saying) -> tuple[list[Event], str]:
    model, region, numbers = say(scene, saying)
    events: list[Event] = []
    try:
        for _ in range(EVENTS[scene.carrier]):
            report = model.step_to_next_event(1e9)
            if report.stop_reason != bempd.StopReason.EVENT:
                break
            if scene.carrier == "elements":
                extensions = model.extensions()
                places = np.array([(e.x, e.y) for e in extensions])
                events.append(Event(report.load_factor, numbers[extensions[-1].crack], places, report.ties > 0))
            else:
                events.append(Event(report.load_factor, 0, broken(model, region), report.ties > 0))
    except bempd.Error as failed:
        return events, type(failed).__name__
    return events, ""


def differ(scene: Scene, one: tuple[list[Event], str], other: tuple[list[Event], str], saying: Saying) -> Optional[str]:
    size = max(scene.size)
    for number, (a, b) in enumerate(zip(one[0], other[0]), 1):
        if abs(a.load_factor - b.load_factor) > LOADS * abs(a.load_factor):
            return f"event {number}: load factor {a.load_factor}; otherwise {b.load_factor}"
        if a.is_tie != b.is_tie:
            return f"event {number}: {'a' if a.is_tie else 'no'} tie is told; otherwise {'a' if b.is_tie else 'none'}"
        if a.is_tie:
            return None
        if a.crack != b.crack:
            return f"event {number}: crack {a.crack} grows; otherwise {b.crack}"
        if len(a.places) != len(b.places):
            return f"event {number}: {len(a.places)} bonds or tips; otherwise {len(b.places)}"
        expected = np.array([saying.place(place) for place in a.places]) / saying.length
        nearest = np.linalg.norm(expected[:, None] - b.places[None] / saying.length, axis=2).min(axis=1)
        if nearest.max(initial=0) > PLACES * size:
            return f"event {number}: places differ by {nearest.max():.2g}"
    if one[1] != other[1] or len(one[0]) != len(other[0]):
        return f"{one[1]}, {len(one[0])} events; otherwise {other[1]}, {len(other[0])}"
    return None


def tied(scene: Scene) -> Optional[str]:
    """Two cracks that are alike grow at the same load: the one that was added first goes first, however the scene is said."""
    loads = []
    for name, saying in {"said once": Saying(), "said again": Saying(), **SAYINGS}.items():
        events, error = follow(scene, saying)
        if not events:
            return f"{name}: {error}"
        first = np.array([saying.place(np.mean(crack, axis=0)) for crack in scene.cracks])
        grown = int(np.linalg.norm(first - events[0].places.mean(axis=0), axis=1).argmin()) + 1
        if grown != (2 if saying.reordered else 1):
            return f"{name}: crack {grown} grows first"
        loads.append(events[0].load_factor)
    if np.ptp(loads) > LOADS * loads[0]:
        return f"first loads {loads}"
    return None


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("--first", type=int, default=1)
    parser.add_argument("--count", type=int, default=10)
    parser.add_argument("--carrier", choices=CARRIERS)
    parser.add_argument("--verbose", action="store_true")
    arguments = parser.parse_args()
    failed = scenes = events = ties = 0
    for seed in range(arguments.first, arguments.first + arguments.count):
        for carrier in [arguments.carrier] if arguments.carrier else CARRIERS:
            scene = random_scene(seed, carrier)
            one = follow(scene, Saying())
            scenes, events, ties = scenes + 1, events + len(one[0]), ties + any(event.is_tie for event in one[0])
            findings = {name: differ(scene, one, follow(scene, saying), saying) for name, saying in SAYINGS.items()}
            if seed % 2 and carrier != "bonds":
                findings["two alike"] = tied(symmetric_scene(seed, carrier))
            failed += any(findings.values())
            for name, finding in findings.items():
                if finding or arguments.verbose:
                    print(f"scene {seed}, {carrier}, {name}: {finding or f'holds over {len(one[0])} events {one[1]}'}", flush=True)
    print(f"{scenes} scenes, {events} events, {len(SAYINGS)} ways to say each, {ties} scenes with ties, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
