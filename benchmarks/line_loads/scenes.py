"""Cracks that grow as lines in lattices where the field around their tips is not theirs alone, and the same in boundary elements.

Lengths are in spacings, E = 1, Poisson's ratio 1/3, G0 = 1."""

from __future__ import annotations

import dataclasses
import functools
import math
import time
from typing import Callable

import bempd
import numpy as np

Polyline = list[tuple[float, float]]
SIDE = 90.0
BELOW_GROWTH = 1e-3  # a load factor at which no crack grows, but faces that press on each other do so


@dataclasses.dataclass
class Scene:
    name: str
    cracks: list[Polyline]
    steps: int
    build: Callable[["Scene", bempd.Model, bool, int], None]  # regions, supports and loads, for elements or of a horizon
    downwards: bool = False  # pressed: load factors fall from zero
    values: dict[str, float] = dataclasses.field(default_factory=dict)
    options: dict[str, str] = dataclasses.field(default_factory=dict)
    horizons: tuple[int, ...] = (4,)  # in spacings, with which the table has the scene


def material(model: bempd.Model, young: float = 1.0, energy: float = 1.0) -> int:
    return model.add_material(young_modulus=young, poisson_ratio=1 / 3, fracture_energy=energy)


def region(scene: Scene, model: bempd.Model, solid: int, box: list, elements: bool, m: int) -> int:
    if elements:
        return model.add_bem_region(solid, box, SIDE / scene.values.get("elements", 24))
    return model.add_pd_region(solid, box, 1.0, m, lattice_angle=math.radians(scene.values.get("rows", 0)))


def sheared(scene: Scene, model: bempd.Model, elements: bool, m: int) -> None:
    """A plate whose upper edge moves at an angle to the vertical."""
    body = region(scene, model, material(model), bempd.rectangle(0, -SIDE / 2, SIDE, SIDE / 2), elements, m)
    angle = math.radians(scene.values["angle"])
    model.fix_edge(body, 1, "both")
    model.prescribe_edge(body, 3, "y", math.cos(angle))
    model.prescribe_edge(body, 3, "x", -math.sin(angle))


def beam(scene: Scene, model: bempd.Model, elements: bool, m: int) -> None:
    """Four-point shear: the notch lies between two forces that shear it."""
    body = region(scene, model, material(model), bempd.rectangle(0, 0, 160, 48), elements, m)
    for edge, middle, value in ((1, 10, 0.0), (1, 90, 0.0), (3, 70, -1.0), (3, 150, -0.125)):
        part = sorted(((middle - 3) / 160, (middle + 3) / 160) if edge == 1 else ((160 - middle - 3) / 160, (160 - middle + 3) / 160))
        if edge == 1:
            model.prescribe_edge(body, edge, "y", value, part=tuple(part))
        else:
            model.add_traction(body, edge, "y", value, part=tuple(part))
    model.fix_point((0, 0), "x")


def pulled(scene: Scene, model: bempd.Model, elements: bool, m: int) -> None:
    half = SIDE / 2
    body = region(scene, model, material(model), bempd.rectangle(-half, -half, half, half), elements, m)
    for edge, value in ((1, -1.0), (3, 1.0)):
        model.prescribe_edge(body, edge, "y", value)
    model.fix_point((-half, -half), "x")


def pressed(scene: Scene, model: bempd.Model, elements: bool, m: int) -> None:
    half = SIDE / 2
    body = region(scene, model, material(model), bempd.rectangle(-half, -half, half, half), elements, m)
    for edge, value in ((1, 1.0), (3, -1.0)):
        model.prescribe_edge(body, edge, "y", value)
    model.fix_point((-half, -half), "x")


def joined(scene: Scene, model: bempd.Model, elements: bool, m: int) -> None:
    """An edge crack runs towards another material, pulled up and down."""
    half = SIDE / 2
    left, right = bempd.rectangle(0, -half, half, half), bempd.rectangle(half, -half, SIDE, half)
    soft, stiff = material(model), material(model, scene.values["young"], scene.values.get("energy", 1.0))
    for body in (region(scene, model, soft, left, elements, m), region(scene, model, stiff, right, elements, m)):
        model.prescribe_edge(body, 1, "y", -1.0)
        model.prescribe_edge(body, 3, "y", 1.0)
    model.fix_point((0, -half), "x")


def inner(length: float, degrees: float, middle: tuple[float, float]) -> Polyline:
    a = math.radians(degrees)
    d = length / 2 * np.array([math.cos(a), math.sin(a)])
    return [tuple(np.array(middle) - d), tuple(np.array(middle) + d)]


def scenes() -> list[Scene]:
    kink = [[(0.0, 0.3), (45.5, 0.3)]]
    found = [Scene(f"L1 kink, upper edge at {angle}", kink, 8, sheared, values={"angle": angle}, horizons=(3, 4, 5, 6))
             for angle in (45, 65, 80, 90)]
    # Faces that pass through each other: K_I < 0, and kinks sharper than under shear alone.
    found += [Scene(f"kink, upper edge at {angle}, no contact", kink, 4, sheared, values={"angle": angle}, horizons=(3, 4, 5),
                    options={"contact": "none"}) for angle in (95, 100)]
    found.append(Scene("straight crack of 40", [inner(40.0, 0, (0.3, 0.4))], 6, pulled))
    for notch, horizons in ((12.5, (4, 6)), (25.5, (4,))):
        found.append(Scene(f"L2 four-point shear, notch {notch}", [[(80.3, 0.0), (80.3, notch)]], 8, beam, horizons=horizons))
    found.append(Scene("L2 sheared square, inner crack", [inner(24.0, 0, (45.3, 0.4))], 4, sheared, values={"angle": 90}))
    for half in (3, 6, 10, 12):
        found.append(Scene(f"L3 pressed crack at 45, half length {half}", [inner(2 * half, 45, (0.3, 0.45))], 8, pressed))
    for young in (3.0, 1 / 3):
        found.append(Scene(f"L4 towards modulus {young:.2g}, from 13 spacings before", [[(0.0, 0.4), (32.3, 0.4)]], 10, joined, values={"young": young}))
    for length in (8, 6, 4, 2):
        for degrees, middle in ((0, (0.3, 0.4)), (30, (0.15, 0.3))):
            found.append(Scene(f"L5 crack of {length}, at {degrees}", [inner(length, degrees, middle)], 1, pulled))
    return found


def make(scene: Scene, elements: bool, m: int, cracks: list[Polyline], load: str = "energy") -> bempd.Model:
    model = bempd.Model()
    if not elements:
        model.options["crack.rule"] = "tips"
        model.options["crack.load"] = load
        model.options["stepping.control"] = "path"
    model.options.update(scene.options)
    scene.build(scene, model, elements, m)
    for crack in cracks:
        model.add_crack(crack)
    return model


def reference(scene: Scene, cracks: list[Polyline], crack: int, end: int) -> float:
    """Load factor at which a tip grows by boundary elements."""
    model = make(scene, True, 0, cracks)
    model.step(BELOW_GROWTH)
    tip = next(t for t in model.tips() if t.crack == crack and int(t.end) == end)
    return float(tip.critical_load_factor)


@dataclasses.dataclass
class Run:
    """A run of a lattice."""

    loads: list[tuple[float, float]]  # of its steps, and those of boundary elements with the same cracks before each of them
    rules: list[bempd.LoadRule]  # that gave the loads
    kinks: list[float]  # by which its steps turn [degrees]
    seconds: float  # of the processor, the least of three runs; 0 if not measured
    peak: float = 0  # largest load factor over that of boundary elements on their own path
    off: float = 0  # largest distance of its path from theirs [spacings]


def seconds(scene: Scene, m: int, load: str) -> float:
    """Time of the processor for the same run, without anything that is asked in between."""
    begin = time.process_time()
    model = make(scene, False, m, scene.cracks, load)
    for _ in range(scene.steps):
        if model.step_to_next_event(1e9).stop_reason != bempd.StopReason.EVENT:
            break
    return time.process_time() - begin


def distance_to(path: Polyline, place: tuple[float, float]) -> float:
    best = math.inf
    for start, end in zip(np.array(path[:-1]), np.array(path[1:])):
        way = end - start
        share = min(max(float((place - start) @ way / (way @ way)), 0), 1)
        best = min(best, float(np.linalg.norm(start + share * way - place)))
    return best


@functools.lru_cache(maxsize=None)
def own_path(name: str, steps: int) -> tuple[float, dict[int, Polyline]]:
    """Largest load factor of as many steps of boundary elements, each a spacing long, and their cracks."""
    scene = next(one for one in scenes() if one.name == name)
    model = make(scene, True, 0, scene.cracks)
    model.options["crack.step"] = 1.0
    model.options["stepping.control"] = "path"
    for _ in range(steps):
        if model.step_to_next_event(1e9).stop_reason != bempd.StopReason.EVENT:
            break
    peak = max((abs(extension.load_factor) for extension in model.extensions()), default=0)
    return peak, {k + 1: [(v.x, v.y) for v in model.crack_path(k + 1)] for k in range(len(scene.cracks))}


def add_path(run: Run, scene: Scene, cracks: list[Polyline]) -> None:
    peak, known = own_path(scene.name, len(run.loads) + 1)
    run.peak = max(abs(ours) for ours, _ in run.loads) / peak
    run.off = max(distance_to(known[k + 1], np.array(place)) for k, crack in enumerate(cracks) for place in crack)


def compare(scene: Scene, m: int, load: str = "energy", timed: bool = False) -> Run:
    model = make(scene, False, m, scene.cracks, load)
    cracks = [list(crack) for crack in scene.cracks]
    run = Run([], [], [], min(seconds(scene, m, load) for _ in range(3)) if timed else 0)
    for _ in range(scene.steps):
        rules = {(tip.crack, int(tip.end)): tip.load_rule for tip in model.tips()}
        report = model.step_to_next_event(1e9)
        if report.stop_reason != bempd.StopReason.EVENT:
            break
        for extension in model.extensions()[len(run.loads):]:
            end = int(extension.end)
            crack = cracks[extension.crack - 1]
            run.loads.append((extension.load_factor, reference(scene, cracks, extension.crack, end)))
            run.rules.append(rules.get((extension.crack, end), bempd.LoadRule.UNKNOWN))
            run.kinks.append(math.degrees(extension.angle))
            place = (extension.x, extension.y)
            crack.append(place) if end == 2 else crack.insert(0, place)
    if len(run.loads) > 1:
        add_path(run, scene, cracks)
    return run
