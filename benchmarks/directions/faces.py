"""Cracks of a lattice that grow as lines near other cracks, against boundary elements that grow the same crack at each event:
straight at the face of another crack, at a slanted one, and two edge cracks that pass and hook onto one another."""

from __future__ import annotations

import math
from typing import Any

import bempd
import bodies
import numpy as np

Place = tuple[float, float]
MOST_STEPS = 80


def slanted(degrees: float, half: float) -> list[list[Place]]:
    """An edge crack that runs at the middle of another one, 16 spacings before it; 0 degrees: straight across its way."""
    a, x, y = math.radians(degrees), 28.47, 0.513
    reach = half * math.sin(a), half * math.cos(a)
    return [[(0, y), (12.5, y)], [(x - reach[0], y - reach[1]), (x + reach[0], y + reach[1])]]


def passing(beside: float) -> list[list[Place]]:
    return [[(0, beside + 0.013), (20.5, beside + 0.013)], [(64, -beside - 0.013), (47.5, -beside - 0.013)]]


# Side of the plate, whether its clamps hold it sideways, its cracks, and which of their ends may grow.
SCENES = {
    "at a face": (48, True, slanted(0, 9), (1,)),
    "at a face, slanted by 20 degrees": (56, True, slanted(20, 7), (1,)),
    "passing, 12 spacings apart": (64, False, passing(6), (1, 2)),
    "passing, 8 spacings apart": (64, False, passing(4), (1, 2)),
}


def plate(name: str, kind: str, m: int = 3, angle: float = 0) -> tuple[bempd.Model, int]:
    """`kind`: "bem" or a crack rule."""
    side, held, cracks, _ = SCENES[name]
    model = bempd.Model()
    if kind != "bem":
        model.options["crack.rule"] = kind
        model.options["stepping.control"] = "path"
    material = model.add_material(young_modulus=8 / 9, poisson_ratio=1 / 3, fracture_energy=1)
    box = bempd.rectangle(0, -side / 2, side, side / 2)
    if kind == "bem":
        body = model.add_bem_region(material, box, side / 16)
    else:
        body = model.add_pd_region(material, box, 1.0, m, lattice_angle=math.radians(angle))
    for crack in cracks:
        model.add_crack(crack)
    for edge, value in ((1, -1.0), (3, 1.0)):
        model.prescribe_edge(body, edge, "y", value)
        if held:
            model.fix_edge(body, edge, "x")
    if not held:
        model.fix_point((0, -side / 2), "x")
    return model, body


class Reference:
    """Boundary elements, one crack by a spacing at a time."""

    def __init__(self, name: str) -> None:
        self.model, _ = plate(name, "bem")
        cracks, self.growing = SCENES[name][2], SCENES[name][3]
        self.ways = {number: list(crack) for number, crack in enumerate(cracks, 1)}
        for number in self.ways:
            if number not in self.growing:
                self.model.set_tip_frozen(number, bempd.TipEnd.START)

    def gap(self, crack: int) -> float:
        """From its tip to the face of the other one."""
        other = next(way for number, way in self.ways.items() if number != crack)
        return bodies.nearest(np.array(self.ways[crack][-1]), other)[0]

    def grow(self, crack: int) -> tuple[float, bool]:
        """The load factor, and whether the crack has met another one."""
        for number in self.ways:
            self.model.set_tip_frozen(number, bempd.TipEnd.END, number != crack)
        self.model.grow_cracks(1.0)
        last = self.model.extensions()[-1]
        self.ways[crack].append((last.x, last.y))
        return self.model.load_factor, last.ended


def events(name: str, m: int, angle: float) -> list[tuple[float, np.ndarray]]:
    """Load factors, and the centres of what broke."""
    model, body = plate(name, "tips", m, angle)
    points = model.field(body, "position")
    broken = model.bonds(body).states == bempd.BondState.BROKEN
    found = []
    for _ in range(MOST_STEPS):
        report = model.step_to_next_event(1e6)
        if report.stop_reason != bempd.StopReason.EVENT:
            break
        bonds = model.bonds(body)
        now = bonds.states == bempd.BondState.BROKEN
        found.append((report.load_factor, points[bonds.points[now & ~broken]].mean(axis=(0, 1))))
        broken = now
    return found


def compared(name: str, m: int, angle: float) -> dict[str, Any]:
    """Until a crack comes within a step of the other one's face: gaps in horizons with ratios of loads, and the largest distance
    of what broke from the way of boundary elements."""
    known = Reference(name)
    tips = {number: np.array(way[-1]) for number, way in known.ways.items() if number in known.growing}
    ratios, places = [], []
    for load, centre in events(name, m, angle):
        crack = min(tips, key=lambda number: math.dist(tips[number], centre))
        tips[crack] = centre
        gap = known.gap(crack)
        if gap < 1.5:
            break
        expected, ended = known.grow(crack)
        if ended:
            break
        ratios.append((gap / m, load / expected))
        places.append((crack, centre))
    off = max(bodies.nearest(centre, known.ways[crack])[0] for crack, centre in places)
    return {"ratios": ratios, "off": off}


def row(name: str, m: int, angle: float, result: dict[str, Any]) -> str:
    def spread(low: float, high: float) -> str:
        some = [ratio for gap, ratio in result["ratios"] if low <= gap < high]
        return f"{min(some):.2f} .. {max(some):.2f}" if some else "-"

    return f"| {name} | {angle:g} | {m} | {spread(3, math.inf)} | {spread(1.5, 3)} | {spread(0, 1.5)} | {result['off']:.1f} |"
