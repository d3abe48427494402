"""What tips of lines report, besides the loads of their steps."""

from __future__ import annotations

import functools
import math
from typing import Callable

import bempd
import numpy as np

import scenes

HALF = 10.0


def square(elements: bool, crack: scenes.Polyline, build: Callable, load: str = "energy") -> bempd.Model:
    scene = scenes.Scene("", [crack], 0, build)
    model = scenes.make(scene, elements, 4, [crack], load)
    model.step(1.0)
    return model


def through_points(load: str) -> list[float]:
    """K of both tips over that of boundary elements where the crack runs through material points (L6)."""
    found = []
    for middle in ((0.5, 0.5), (0.3, 0.4)):
        crack = scenes.inner(2 * HALF, 45, middle)
        known = {int(t.end): t for t in square(True, crack, scenes.pulled).tips()}
        for tip in square(False, crack, scenes.pulled, load).tips():
            found.append(math.hypot(tip.stress_intensity_1, tip.stress_intensity_2) /
                         math.hypot(known[int(tip.end)].stress_intensity_1, known[int(tip.end)].stress_intensity_2))
    return found


def closed(load: str) -> list[float]:
    """K_I of a crack that lies across the pressure, over p sqrt(pi a), and 1 over its critical load factor (L7)."""
    model = square(False, scenes.inner(2 * HALF, 0, (0.3, 0.4)), scenes.pressed, load)
    pressure = 2 / scenes.SIDE
    tip = model.tips()[0]
    return [tip.stress_intensity_1 / (pressure * math.sqrt(math.pi * HALF)), 1 / tip.critical_load_factor]


def onset(load: str) -> list[float]:
    """First loads of cracks whose tips lie at different places between points, over those of boundary elements (L8)."""
    found = []
    for part in (0.05, 0.3, 0.55, 0.8):
        scene = scenes.Scene("", [scenes.inner(20, 0, (part, 0.3))], 1, scenes.pulled)
        found += [ours / known for ours, known in scenes.compare(scene, 4, load).loads]
    return found


def inclined(load: str, m: int) -> list[float]:
    """Least and largest first load of edge cracks of 14 spacings at 20 to 60 degrees, with rows at 0 to 45, over those of elements."""
    found, side = [], 60.0
    for degrees in (20, 30, 45, 60):
        way = np.array([math.cos(math.radians(degrees)), math.sin(math.radians(degrees))])
        start = np.array([0, 0.27]) - [0, 7 * way[1]]
        loads = []
        for rows in (None, 0, 10, 20, 30, 45):
            model = bempd.Model(options={"crack.load": load, "crack.rule": "tips", "stepping.control": "path"})
            box = bempd.rectangle(0, -side / 2, side, side / 2)
            solid = scenes.material(model, 8 / 9)
            body = model.add_bem_region(solid, box, side / 12) if rows is None else model.add_pd_region(solid, box, 1.0, m, lattice_angle=math.radians(rows))
            model.add_crack([tuple(start), tuple(start + 14 * way)])
            for edge, value in ((1, -1.0), (3, 1.0)):
                model.prescribe_edge(body, edge, "y", value)
                model.fix_edge(body, edge, "x")
            model.step(1e-3)
            loads.append(model.tips()[0].critical_load_factor)
        found += [one / loads[0] for one in loads[1:]]
    return [min(found), max(found)]


MEASURES: dict[str, Callable[[str], list[float]]] = {
    "L6 K of tips, crack of 20 at 45, through points and beside them | 4": through_points,
    "L7 crack across pressure: K_I / p sqrt(pi a), 1 / critical load | 4": closed,
    "L8 first loads, tip at four places between points | 4": onset,
    "first loads of inclined edge cracks, least and largest | 3": functools.partial(inclined, m=3),
    "first loads of inclined edge cracks, least and largest | 4": functools.partial(inclined, m=4),
    "first loads of inclined edge cracks, least and largest | 5": functools.partial(inclined, m=5),
}
