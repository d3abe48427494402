"""First loads of initial cracks beside edges, faces and interfaces, of short cracks and of closed ones.

Each row has the loads at which the last tip grows over those of boundary elements with the same cracks."""

from __future__ import annotations

import dataclasses
import functools
import math
from typing import Callable, Sequence

import bempd
import numpy as np

import scenes

HALF = scenes.SIDE / 2
DISTANCES = (3, 2, 1, 0.5)  # to an edge or a face, in horizons
Measure = Callable[[str], list[float]]


def last_tip(model: bempd.Model) -> bempd.CrackTip:
    model.step(scenes.BELOW_GROWTH)
    return model.tips()[-1]


@functools.lru_cache(maxsize=None)
def known_load(build: Callable, cracks: tuple, values: tuple) -> float:
    """By boundary elements."""
    scene = scene_of([list(crack) for crack in cracks], build, **dict(values))
    return float(last_tip(scenes.make(scene, True, 0, scene.cracks)).critical_load_factor)


def ratio(scene: scenes.Scene, m: int, load: str) -> float:
    values = tuple(sorted((name, value) for name, value in scene.values.items() if name != "rows"))
    known = known_load(scene.build, tuple(tuple(crack) for crack in scene.cracks), values)
    return float(last_tip(scenes.make(scene, False, m, scene.cracks, load)).critical_load_factor / known)


def scene_of(cracks: list[scenes.Polyline], build: Callable, **values: float) -> scenes.Scene:
    return scenes.Scene("", cracks, 0, build, values=values)


def straight(load: str, m: int, length: float) -> list[float]:
    """Mean and scatter for opened cracks with rows at 0 to 45 degrees and the tips at two places between points (section 2)."""
    found = [ratio(scene_of([scenes.inner(length, 0, middle)], scenes.pulled, rows=rows), m, load)
             for rows in (0, 15, 30, 45) for middle in ((0.3, 0.4), (0.55, 0.15))]
    return [float(np.mean(found)), float(np.std(found))]


def towards_edge(load: str, m: int) -> list[float]:
    return [ratio(scene_of([[(HALF - d * m - 30, 0.4), (HALF - d * m, 0.4)]], scenes.pulled, elements=48), m, load) for d in DISTANCES]


def peeled(scene: scenes.Scene, model: bempd.Model, elements: bool, m: int) -> None:
    """The strip above an edge crack is lifted at its end, off the mouth: the crack is parallel to the free upper edge."""
    body = scenes.region(scene, model, scenes.material(model), bempd.rectangle(0, -HALF, scenes.SIDE, HALF), elements, m)
    model.fix_edge(body, 1, "both")
    model.prescribe_edge(body, 4, "y", 1.0, part=(0, 0.75 * (HALF - scene.cracks[0][0][1]) / scenes.SIDE))


def along_edge(load: str, m: int) -> list[float]:
    """Between two rows of points, which a crack through points would pass half a spacing lower."""
    return [ratio(scene_of([[(0, HALF - d * m - 0.4), (12.3, HALF - d * m - 0.4)]], peeled, elements=48), m, load) for d in DISTANCES]


def towards_face(load: str, m: int) -> list[float]:
    face = [(20.3, -20.2), (20.3, 20.3)]
    return [ratio(scene_of([face, [(-10, 0.4), (20.3 - d * m, 0.4)]], scenes.pulled, elements=48), m, load) for d in DISTANCES]


def along_face(load: str, m: int) -> list[float]:
    """Two cracks that overlap by 8 spacings."""
    return [ratio(scene_of([[(-4, 0.4 + d * m), (26, 0.4 + d * m)], [(-26, 0.4), (4, 0.4)]], scenes.pulled, elements=48), m, load) for d in DISTANCES]


def before_interface(load: str, m: int, young: float) -> list[float]:
    return [ratio(scene_of([[(0, 0.4), (HALF - d, 0.4)]], scenes.joined, young=young), m, load) for d in (12.5, 6.5, 4.5, 3.5, 2.5)]


def half_body_energy(length: float, young: float) -> float:
    """Energy of the upper half of a joined plate in which the crack of a length goes through the interface."""
    model = bempd.Model()
    for solid, left, right in ((scenes.material(model), 0.0, HALF), (scenes.material(model, young), HALF, scenes.SIDE)):
        body = model.add_bem_region(solid, bempd.rectangle(left, 0, right, HALF), scenes.SIDE / 96)
        model.prescribe_edge(body, 3, "y", 1.0)
        begin = min(max((length - left) / (right - left), 0), 1)
        if begin < 1:
            model.prescribe_edge(body, 1, "y", 0.0, part=(begin, 1))
    model.fix_point((scenes.SIDE, 0), "x")
    return float(model.step(1.0).stored_energy)


@functools.lru_cache(maxsize=None)
def load_through_interface(length: float, young: float) -> float:
    """Load factor at which the crack grows: two halves release the energy, and the fracture energy is 1."""
    reach = min(0.5, 0.5 * abs(length - HALF))
    released = 2 * (half_body_energy(length - reach, young) - half_body_energy(length + reach, young))
    return 1 / math.sqrt(released / (2 * reach))


def through_interface(load: str, m: int, young: float) -> list[float]:
    found = []
    for d in (-1.5, -0.5, 0.5, 1.5, 3.5, 6.5):
        scene = scene_of([[(0, 0.4), (HALF + d, 0.4)]], scenes.joined, young=young)
        found.append(last_tip(scenes.make(scene, False, m, scene.cracks, load)).critical_load_factor / load_through_interface(HALF + d, young))
    return found


def through_toughness(load: str, m: int, share: float) -> list[float]:
    """The fracture energy behind the interface is a share of that before it; the reference is one body, with the energy at the tip."""
    found = []
    for d in (-3.5, -1.5, -0.5, 0.5, 1.5, 3.5):
        crack = [(0, 0.4), (HALF + d, 0.4)]
        known = known_load(scenes.joined, (tuple(crack),), (("young", 1.0),)) * math.sqrt(share if d > 0 else 1)
        scene = scene_of([crack], scenes.joined, young=1.0, energy=share)
        found.append(last_tip(scenes.make(scene, False, m, scene.cracks, load)).critical_load_factor / known)
    return found


def through_points(load: str, m: int) -> list[float]:
    """Opened cracks of 20 along rows, at 45 degrees and at 26.6 degrees, each exactly through points."""
    return [ratio(scene_of([scenes.inner(20, degrees, (0.5, 0.5))], scenes.pulled), m, load) for degrees in (0, 45, math.degrees(math.atan(0.5)))]


def pressed_first(load: str, m: int, half: float) -> list[float]:
    """Closed cracks at 45 degrees, at three places between points."""
    return [ratio(dataclasses.replace(scene_of([scenes.inner(2 * half, 45, middle)], scenes.pressed), downwards=True), m, load)
            for middle in ((0.3, 0.45), (0.05, 0.4), (0.55, 0.1))]


def wings(load: str, m: int) -> list[float]:
    """Pressed crack at 45 degrees with straight wings of 1, 2, 4, 8 and 12 spacings in the direction of boundary elements."""
    closed = scenes.inner(20, 45, (0.3, 0.45))
    kink = last_tip(scenes.make(scene_of([closed], scenes.pressed), True, m, [closed])).kink_angle
    way = np.array([math.cos(math.radians(45) + kink), math.sin(math.radians(45) + kink)])
    found = []
    for length in (1, 2, 4, 8, 12):
        crack: Sequence = [tuple(np.array(closed[0]) - length * way), *closed, tuple(np.array(closed[1]) + length * way)]
        found.append(ratio(scene_of([list(crack)], scenes.pressed), m, load))
    return found


def measures() -> dict[str, Measure]:
    found: dict[str, Measure] = {}
    for m in (3, 4, 5, 6):
        for length in (40, 20, 10, 6, 4, 2):
            found[f"crack of {length}, rows at 0 to 45: mean, scatter | {m}"] = functools.partial(straight, m=m, length=length)
    found["edge ahead at 3, 2, 1, 1/2 horizons | 4"] = functools.partial(towards_edge, m=4)
    found["along an edge at 3, 2, 1, 1/2 horizons | 4"] = functools.partial(along_edge, m=4)
    found["towards a face at 3, 2, 1, 1/2 horizons | 4"] = functools.partial(towards_face, m=4)
    found["along a face, overlapping, at 3, 2, 1, 1/2 horizons | 4"] = functools.partial(along_face, m=4)
    for young in (3, 1 / 3):
        found[f"modulus {young:.2g}, 12.5, 6.5, 4.5, 3.5, 2.5 before it | 4"] = functools.partial(before_interface, m=4, young=young)
    for young in (3, 1 / 3, 4, 1 / 4):
        found[f"through modulus {young:.2g}, -1.5, -.5, .5, 1.5, 3.5, 6.5 behind | 4"] = functools.partial(through_interface, m=4, young=young)
    for share in (4, 1 / 4):
        found[f"through G0 times {share:.2g}, -3.5, -1.5, -.5, .5, 1.5, 3.5 behind | 4"] = functools.partial(through_toughness, m=4, share=share)
    found["crack of 20 through points, at 0, 45, 26.6 | 4"] = functools.partial(through_points, m=4)
    for half in (3, 6, 10, 12):
        found[f"pressed crack, half length {half}, first loads at three places | 4"] = functools.partial(pressed_first, m=4, half=half)
    found["wings of 1, 2, 4, 8, 12 of a pressed crack, half length 10 | 4"] = functools.partial(wings, m=4)
    return found
