"""Bouchard's plate and the beam with three holes: cracks of a lattice that grow as lines against those of boundary elements.
Sizes and loads are those of examples/crack_paths; Poisson's ratio is 1/3 in plane stress in both."""

from __future__ import annotations

import functools
import math
from typing import Any

import bempd
import numpy as np

Place = tuple[float, float]
HOLES = {"plate": (((3, 7), 2.0), ((17, 3), 2.0)), "beam": tuple(((6.0, y), 0.25) for y in (2.75, 4.75, 6.75))}
CRACKS = {
    "plate": [[(0, 2.85), (1, 2.85)], [(20, 7.15), (19, 7.15)]],
    "beam 1.5 5": [[(5.0, 0), (5.0, 1.5)]],
    "beam 1.0 6": [[(4.0, 0), (4.0, 1.0)]],
}


def build(name: str, spacing: float, m: int) -> tuple[bempd.Model, int]:
    """`spacing` 0: boundary elements."""
    is_plate = name.startswith("plate")
    model = bempd.Model()
    if spacing:
        # No strength: holes and the short cracks beside them are small for the horizon.
        model.options["crack.rule"] = "tips"
        model.options["stepping.control"] = "path"
    else:
        model.options["crack.direction"] = "chord"
        if is_plate:
            model.options["crack.tie_share"] = 0 if name == "plate held" else 1e6
    material = model.add_material(young_modulus=1, poisson_ratio=1 / 3, fracture_energy=1)
    # A crack opens at the middle of a chord of the outline: with the finest spacing all chords are alike only if the beam with its
    # supports lies half a spacing to the left, else no network of bonds is found.
    left = -spacing / 2 if 0 < spacing < 0.1 and not is_plate else 0.0
    box = bempd.rectangle(left, 0, 20 + left, 10 if is_plate else 8)
    body = model.add_pd_region(material, box, spacing, m) if spacing else model.add_bem_region(material, box, 1.0)
    for centre, radius in HOLES["plate" if is_plate else "beam"]:
        model.add_circular_hole(body, centre, radius)
    for crack in CRACKS["plate" if is_plate else name]:
        model.add_crack(crack)
    if is_plate:
        model.prescribe_edge(body, 1, "y", -1)
        model.prescribe_edge(body, 3, "y", 1)
        if name == "plate held":
            model.fix_edge(body, 1, "x")
            model.fix_edge(body, 3, "x")
        else:
            model.fix_point((0, 10), "x")
            model.fix_point((20, 0), "x")
    else:
        # The supports and the load are spread over half an inch, so that bonds beside them do not break; the crack is
        # not affected.
        model.prescribe_edge(body, 1, "y", 0, part=(0.0375, 0.0625))
        model.prescribe_edge(body, 1, "y", 0, part=(0.9375, 0.9625))
        model.fix_point((1 + left, 0), "x")
        model.prescribe_edge(body, 3, "y", -1, part=(0.4875, 0.5125))
    return model, body


@functools.lru_cache(None)
def elements_way(name: str) -> list[list[Place]]:
    """One extension after the other in the plate with its sides held: its loads fall, so that one crack runs ahead."""
    model, _ = build(name, 0, 0)
    for _ in range(120 if name == "plate held" else 60):
        try:
            model.grow_cracks(0.2)
        except (bempd.ArgumentError, bempd.UnsolvableError):
            break
    ways = [list(crack) for crack in CRACKS["plate" if name.startswith("plate") else name]]
    for extension in model.extensions():
        ways[extension.crack - 1].append((extension.x, extension.y))
    return ways


def known_ways(name: str) -> list[list[list[Place]]]:
    """Which of two equal cracks runs ahead is left to rounding: the same turned by half a turn is as good."""
    ways = elements_way(name)
    return [ways, [[(20 - x, 10 - y) for x, y in way] for way in ways]] if name == "plate held" else [ways]


def nearest(place: np.ndarray, way: list[Place]) -> tuple[float, bool]:
    """Distance from a polyline, and whether the place lies beside it."""
    points = np.array(way, dtype=float)
    starts, along = points[:-1], np.diff(points, axis=0)
    parts = ((place - starts) * along).sum(axis=1) / (along**2).sum(axis=1)
    feet = starts + np.clip(parts, 0, 1)[:, None] * along
    distances = np.hypot(*(place - feet).T)
    least = int(distances.argmin())
    return float(distances[least]), not (least == len(along) - 1 and parts[-1] > 1)


def along(ways: list[list[Place]], places: list[np.ndarray]) -> tuple[float, int]:
    """Largest distance, and over how many places: until a millimetre or inch before the end of one of the ways. That lies in a
    hole, beside which little decides whether it is met."""
    worst, count = 0.0, 0
    for place in places:
        if min(math.dist(place, way[-1]) for way in ways) < 1:
            break
        distance, is_beside = min(nearest(place, way) for way in ways)
        if is_beside:
            worst, count = max(worst, distance), count + 1
    return worst, count


def compared(name: str, spacing: float, m: int, events: int) -> dict[str, Any]:
    """The centres of what broke at each event are taken for places of the crack."""
    known = known_ways(name)
    ends = [way[-1] for ways in known for way in ways] if len(known) == 1 else []
    model, body = build(name, spacing, m)
    points = model.field(body, "position")
    broken = model.bonds(body).states == bempd.BondState.BROKEN
    places: list[np.ndarray] = []
    for _ in range(events):
        report = model.step_to_next_event(1e9)
        if report.stop_reason != bempd.StopReason.EVENT:
            break
        bonds = model.bonds(body)
        now = bonds.states == bempd.BondState.BROKEN
        places.append(points[bonds.points[now & ~broken]].mean(axis=(0, 1)))
        broken = now
        if ends and min(math.dist(places[-1], end) for end in ends) < 1:
            break
    worst, count = min((along(ways, places) for ways in known), key=lambda found: found[0])
    return {"spacings": worst / spacing, "compared": count, "end": [float(v) for v in places[-1]], "bem": [list(w[-1]) for w in known[0]]}
