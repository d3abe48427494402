"""What tips of lines report, besides the loads of their steps."""

from __future__ import annotations

import math
from typing import Callable

import bempd

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


MEASURES: dict[str, Callable[[str], list[float]]] = {
    "L6 K of tips, crack of 20 at 45, through points and beside them | 4": through_points,
    "L7 crack across pressure: K_I / p sqrt(pi a), 1 / critical load | 4": closed,
    "L8 first loads, tip at four places between points | 4": onset,
}
