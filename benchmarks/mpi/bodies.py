"""Bodies whose cracks run with the factor of the library and with MUMPS. `fine` divides the spacing of the lattices."""

from __future__ import annotations

import math
from typing import Callable

import bempd

MM = 1e-3


def plate(rule: str, fine: int) -> bempd.Model:
    """Lattice of 40 fine x 40 fine points with an edge crack, pulled at its ends."""
    side, spacing = 0.1, 0.1 / (40 * fine)
    model = bempd.Model(options={"crack.rule": rule})
    solid = model.add_material(young_modulus=30e9, poisson_ratio=1 / 3, fracture_energy=100)
    region = model.add_pd_region(solid, bempd.rectangle(0, 0, side, side), spacing, 4)
    middle = side / 2 + spacing / 2
    model.add_crack([(middle, 0), (middle, 0.3 * side)])
    model.fix_edge(region, 4)
    model.prescribe_edge(region, 2, "x", 1e-6)
    return model


def cracked(fine: int, height: float, half_strip: float, cracks: list[list[tuple[float, float]]]) -> bempd.Model:
    """The paper's plate: boundary elements left and right of a lattice, pulled apart."""
    model = bempd.Model(options={"crack.rule": "bond"})
    solid = model.add_material(young_modulus=30e9, poisson_ratio=1 / 3, critical_stretch=8e-4)
    left, right = (25 - half_strip) * MM, (25 + half_strip) * MM
    first = model.add_bem_region(solid, bempd.rectangle(0, 0, left, height * MM), 5 * MM)
    model.add_pd_region(solid, bempd.rectangle(left, 0, right, height * MM), 0.5 * MM / fine, 4)
    last = model.add_bem_region(solid, bempd.rectangle(right, 0, 50 * MM, height * MM), 5 * MM)
    for crack in cracks:
        model.add_crack([(x * MM, y * MM) for x, y in crack])
    model.prescribe_edge(first, 4, "x", -2e-8)
    model.prescribe_edge(last, 2, "x", 2e-8)
    model.fix_point((0, height / 2 * MM), "y")
    return model


def centre(fine: int) -> bempd.Model:
    return cracked(fine, 49.5, 4.25, [[(25, 19.75), (25, 29.75)]])


def inclined(fine: int) -> bempd.Model:
    half = 5 * math.sqrt(0.5)
    return cracked(fine, 50, 10.25, [[(25 - half, 25 - half), (25 + half, 25 + half)]])


def two_edges(fine: int) -> bempd.Model:
    """The paper's third crack example: cracks from opposite sides of a band between boundary elements."""
    model = bempd.Model(options={"crack.rule": "bond"})
    solid = model.add_material(young_modulus=72e9, poisson_ratio=1 / 3, critical_stretch=2e-4)
    low, high = (25 - 7.75) * MM, (25 + 7.75) * MM
    lower = model.add_bem_region(solid, bempd.rectangle(0, 0, 50 * MM, low), 5 * MM)
    model.add_pd_region(solid, bempd.rectangle(0, low, 50 * MM, high), 0.5 * MM / fine, 4)
    upper = model.add_bem_region(solid, bempd.rectangle(0, high, 50 * MM, 50 * MM), 5 * MM)
    model.add_crack([(0, 24 * MM), (2 * MM, 24 * MM)])
    model.add_crack([(50 * MM, 26 * MM), (48 * MM, 26 * MM)])
    model.add_traction(upper, 3, "y", 0.1e6)
    model.fix_edge(lower, 1, "y")
    model.fix_point((25 * MM, 0), "x")
    return model


def holes(fine: int) -> bempd.Model:
    """Irregular body: a lattice of any outline with round holes and slanted sides."""
    model = bempd.Model()
    solid = model.add_material(young_modulus=30e9, poisson_ratio=1 / 3, fracture_energy=100)
    outline = [(0, 0), (100 * MM, 0), (90 * MM, 60 * MM), (10 * MM, 70 * MM)]
    region = model.add_pd_region(solid, outline, 2 * MM / fine, 4)
    for x, y, radius in ((30, 45, 9), (68, 40, 8)):
        model.add_circular_hole(region, (x * MM, y * MM), radius * MM)
    model.add_crack([(50.3 * MM, 0), (50.3 * MM, 15.2 * MM)])
    model.fix_edge(region, 4)
    model.prescribe_edge(region, 2, "x", 1e-6)
    return model


BODIES: dict[str, Callable[[int], bempd.Model]] = {
    "plate, bond by bond": lambda fine: plate("bond", fine),
    "plate, as a line": lambda fine: plate("line", fine),
    "paper: centre crack": centre,
    "paper: inclined crack": inclined,
    "paper: two edge cracks": two_edges,
    "body with holes, as lines": holes,
}
