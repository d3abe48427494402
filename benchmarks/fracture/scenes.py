"""Bodies with cracks whose stress intensity factors are known, each as a function that returns a loaded model."""

from __future__ import annotations

import math
from typing import Sequence

import bempd

Points = Sequence[tuple[float, float]]
# Size of a plate so large that its edges do not affect a crack of length 2 (the factors of the infinite plate are
# higher by 1e-6).
LARGE = 1000.0


def plate(half_width: float, half_height: float, element: float, cracks: Sequence[Points], *, stress: tuple[float, float] = (0, 1),
          radius: float = 0, left: float | None = None, energy: float = 0, modulus: float = 1, poisson: float = 0.3,
          plane: str = "stress") -> bempd.Model:
    """A plate around the origin pulled by stress (x, y), in plane stress; `radius` of a hole in its middle."""
    model = bempd.Model()
    material = model.add_material(young_modulus=modulus, poisson_ratio=poisson, plane=plane, fracture_energy=energy or None)
    low = -half_width if left is None else left
    corners = bempd.rectangle(low, -half_height, half_width, half_height)
    body = model.add_bem_region(material, corners, element_length=element)
    if radius:
        model.add_circular_hole(body, (0, 0), radius)
    for crack in cracks:
        model.add_crack(crack)
    model.fix_point(corners[0])
    model.fix_point(corners[1], "y")
    for edge, component, value in ((2, "x", stress[0]), (4, "x", -stress[0]), (3, "y", stress[1]), (1, "y", -stress[1])):
        if value:
            model.add_traction(body, edge, component, value)
    return model


def centre(a: float, element: float = 0.25) -> bempd.Model:
    return plate(1, 3, element, [[(-a, 0), (a, 0)]])


def single_edge(a: float, element: float = 0.125) -> bempd.Model:
    return plate(1, 3, element, [[(0, 0), (a, 0)]], left=0)


def double_edge(a: float, element: float = 0.25) -> bempd.Model:
    return plate(1, 3, element, [[(-1, 0), (a - 1, 0)], [(1, 0), (1 - a, 0)]])


def graded_edge(a: float, element: float) -> bempd.Model:
    """As single_edge(), with long elements away from the crack and some of a given length on both sides beside it."""
    model = bempd.Model()
    material = model.add_material(young_modulus=1, poisson_ratio=0.3)
    corners = [(0, -3), (1, -3), (1, -1.2), (1, 1.2), (1, 3), (0, 3), (0, 1.2), (0, -1.2)]
    body = model.add_bem_region(material, corners, element_length=2)
    model.set_edge_mesh(body, 3, element)
    model.set_edge_mesh(body, 7, 3 * element)
    model.add_crack([(0, 0), (a, 0)])
    model.fix_point(corners[0])
    model.fix_point(corners[1], "y")
    model.add_traction(body, 5, "y", 1)
    model.add_traction(body, 1, "y", -1)
    return model


def from_hole(a: float, half: float = 200, element: float = 50, arc: float = 0) -> bempd.Model:
    """Two cracks from a hole of radius 1; their ends lie a from its middle. `arc`: length of elements on the hole."""
    model = plate(half, half, element, [[(1, 0), (a, 0)], [(-1, 0), (-a, 0)]], radius=1)
    for edge in range(5, 9) if arc else ():
        model.set_edge_mesh(1, edge, arc)
    return model


def inclined(degrees: float, element: float = 5) -> bempd.Model:
    angle = math.radians(degrees)
    end = (math.cos(angle), math.sin(angle))
    return plate(20, 20, element, [[(-end[0], -end[1]), end]])


def kinked(length: float, degrees: float = 45, pieces: int = 1) -> bempd.Model:
    """A crack of length 2 with a kink at its right end; length 0: straight. Pulled from all sides. Each leg in pieces, which
    elements do not cross."""
    angle = math.radians(degrees)
    ends = [(-1.0, 0.0), (1.0, 0.0)]
    if length:
        ends.append((1 + length * math.cos(angle), length * math.sin(angle)))
    points = [ends[0]]
    for (x, y), (to_x, to_y) in zip(ends, ends[1:]):
        points += [(x + (to_x - x) * k / pieces, y + (to_y - y) * k / pieces) for k in range(1, pieces + 1)]
    return plate(LARGE, LARGE, 500, [points], stress=(1, 1))


def incompressible() -> bempd.Model:
    return plate(1, 3, 0.25, [[(-0.5, 0), (0.5, 0)]], poisson=0.5, plane="strain")


def pressure() -> bempd.Model:
    model = plate(LARGE, LARGE, 500, [[(-1, 0), (1, 0)]], stress=(0, 0))
    model.add_crack_traction(1, "pressure", 1)
    return model


def shear() -> bempd.Model:
    model = plate(LARGE, LARGE, 500, [[(-1, 0), (1, 0)]], stress=(0, 0))
    model.add_crack_traction(1, "shear", 1)
    return model


def collinear(half_gap: float) -> bempd.Model:
    """Two cracks of length 2."""
    return plate(LARGE, LARGE, 500, [[(-half_gap - 2, 0), (-half_gap, 0)], [(half_gap, 0), (half_gap + 2, 0)]])


def arc(pieces: int = 64, touching: bool = True) -> bempd.Model:
    """Along a quarter of a circle of radius 1, by chords that touch it, or that end on it. Pulled from all sides."""
    half, part = math.pi / 4, math.pi / 2 / pieces
    at = lambda angle, radius: (radius * math.cos(angle), radius * math.sin(angle))
    points = [at(math.pi / 2 + half, 1)]
    if touching:
        points += [at(math.pi / 2 + half - part * (i + 0.5), 1 / math.cos(part / 2)) for i in range(pieces)]
        points.append(at(math.pi / 2 - half, 1))
    else:
        points += [at(math.pi / 2 + half - part * (i + 1), 1) for i in range(pieces)]
    return plate(LARGE, LARGE, 500, [points], stress=(1, 1))


def tiny(a: float) -> bempd.Model:
    return plate(1, 1, 0.5, [[(0.1 - a, 0.2), (0.1 + a, 0.2)]])


def next_to_an_edge(gap: float, element: float = 0.25) -> bempd.Model:
    """The left tip of a crack of length 1 lies `gap` from the edge of a strip."""
    return plate(1, 3, element, [[(0, 0), (gap - 1, 0)]])
