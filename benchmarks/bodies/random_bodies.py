"""Random bodies with holes, cracks, supports and loads, to compare estimated errors with true ones."""

from __future__ import annotations

import math
import random
from typing import Any

import bempd


Corners = list[tuple[float, float]]


def inside(corners: Corners, place: tuple[float, float]) -> bool:
    """In a polygon, a twentieth away from its edges."""
    within, least = False, math.inf
    for (ax, ay), (bx, by) in zip(corners, corners[1:] + corners[:1]):
        x, y = place
        if (ay > y) != (by > y) and x < (bx - ax) * (y - ay) / (by - ay) + ax:
            within = not within
        t = max(0.0, min(1.0, ((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / ((bx - ax) ** 2 + (by - ay) ** 2)))
        least = min(least, math.hypot(x - ax - t * (bx - ax), y - ay - t * (by - ay)))
    return within and least > 0.05


class RandomBody:
    """A scene by its number; build() makes it for an error."""

    def __init__(self, seed: int) -> None:
        self.seed = seed

    def build(self, wanted: float, **options: Any) -> tuple[bempd.Model, int]:
        """Model and id of its body."""
        choose = random.Random(self.seed)
        model = bempd.Model(options={"error.wanted": wanted, **options})
        solid = model.add_material(young_modulus=1, poisson_ratio=choose.uniform(0.0, 0.45),
                                   plane=choose.choice(("stress", "strain")))
        corners = self._outline(choose)
        body = model.add_body(solid, corners)
        if choose.random() < 0.25:
            edge = 2
            (ax, ay), (bx, by) = corners[edge - 1], corners[edge % len(corners)]
            bulge = choose.uniform(0.05, 0.25)
            model.set_edge_arc(body, edge, ((ax + bx) / 2 + bulge * (by - ay), (ay + by) / 2 - bulge * (bx - ax)))
        self._holes_and_cracks(choose, model, body, corners)
        self._conditions(choose, model, body, corners)
        return model, body

    def _outline(self, choose: random.Random) -> list[tuple[float, float]]:
        kind = choose.choice(("rectangle", "rectangle", "quadrilateral", "corner", "polygon"))
        width, height = choose.uniform(1, 4), choose.uniform(0.7, 1.6)
        if kind == "rectangle":
            return [(0, 0), (width, 0), (width, height), (0, height)]
        if kind == "quadrilateral":
            return [(0, 0), (width, choose.uniform(-0.3, 0.3)), (width * choose.uniform(0.7, 1.2), height),
                    (choose.uniform(-0.3, 0.3), height * choose.uniform(0.8, 1.2))]
        if kind == "corner":
            inner, step = width * choose.uniform(0.3, 0.7), height * choose.uniform(0.4, 0.7)
            return [(0, 0), (width, 0), (width, step), (inner, step), (inner, height), (0, height)]
        count = choose.randrange(5, 9)
        turn = choose.uniform(0, 1)
        return [(1.5 * math.cos(2 * math.pi * (k + turn) / count) * choose.uniform(0.8, 1.1) + 1.5,
                 0.8 * math.sin(2 * math.pi * (k + turn) / count) * choose.uniform(0.8, 1.1) + 0.5) for k in range(count)]

    def _holes_and_cracks(self, choose: random.Random, model: bempd.Model, body: int, corners: Corners) -> None:
        self.holes: list[int] = []
        taken: list[tuple[float, float, float]] = []

        def free(x: float, y: float, reach: float) -> bool:
            return all(math.hypot(x - a, y - b) > 1.1 * (reach + r) for a, b, r in taken)

        for _ in range(choose.randrange(0, 4)):
            x, y, radius = choose.uniform(0.3, 2.5), choose.uniform(0.15, 1.2), choose.uniform(0.05, 0.2)
            if not free(x, y, radius):
                continue
            try:
                self.holes.append(model.add_circular_hole(body, (x, y), radius))
            except bempd.Error:
                continue
            taken.append((x, y, radius))
        self.cracks = 0
        for _ in range(choose.choice((0, 1, 1, 2))):
            x, y, half = choose.uniform(0.4, 2), choose.uniform(0.2, 0.9), choose.uniform(0.05, 0.25)
            angle = choose.uniform(0, math.pi)
            ways = half * math.cos(angle), half * math.sin(angle)
            if not free(x, y, half):
                continue
            places = [(x + t * ways[0], y + t * ways[1]) for t in (-1, -0.5, 0, 0.5, 1)]
            if not all(inside(corners, place) for place in places):
                continue
            model.add_crack([(x - ways[0], y - ways[1]), (x + ways[0], y + ways[1])])
            taken.append((x, y, half))
            self.cracks += 1

    def _conditions(self, choose: random.Random, model: bempd.Model, body: int, corners: Corners) -> None:
        held = edges = len(corners)  # the last edge: the left one of rectangles
        way = choose.choice(("clamp", "clamp", "slide"))
        if way == "clamp":
            model.fix_edge(body, held)
        else:
            model.fix_edge(body, held, "x")
            model.fix_edge(body, 1, "y")
        for _ in range(choose.randrange(1, 3)):
            edge = choose.randrange(1, edges)
            kind = choose.choice(("traction", "traction", "part", "linear", "pull", "pressure", "weight"))
            if kind == "traction":
                model.add_traction(body, edge, choose.choice("xy"), proportional=choose.uniform(-1, 1))
            elif kind == "part":
                start = choose.uniform(0.1, 0.5)
                model.add_traction(body, edge, choose.choice("xy"), proportional=choose.uniform(0.5, 1),
                                   part=(start, start + choose.uniform(0.1, 0.4)))
            elif kind == "linear":
                model.add_traction(body, edge, choose.choice("xy"), proportional=[-1, choose.uniform(0, 1)])
            elif kind == "pressure" and self.holes:
                for number in range(4):
                    model.add_pressure(body, self.holes[0] + number, proportional=-0.5)
            elif kind == "weight":
                model.add_body_force(body, "y", proportional=-1)
            else:
                try:
                    model.prescribe_edge(body, 2 if held != 2 else 1, "x", 0.01)
                except bempd.Error:
                    model.add_traction(body, edge, "x", proportional=1)
