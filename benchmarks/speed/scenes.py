"""Scenes of the speed table: each builds itself in a model. Lattice plates have spacing 1, E = 1, nu = 1/3, plane stress,
horizon ratio 4, a critical stretch of 1e-3, and both end columns held in x and y and pulled apart."""

from __future__ import annotations

import importlib.util
import math
import pathlib
import sys
from typing import Any, Callable

import bempd

def accuracy_scenes() -> Any:
    """The scenes of the folder beside this one, whose module has the same name."""
    path = pathlib.Path(__file__).resolve().parents[1] / "accuracy_cost" / "scenes.py"
    specification = importlib.util.spec_from_file_location("accuracy_scenes", path)
    assert specification is not None and specification.loader is not None
    module = importlib.util.module_from_spec(specification)
    sys.modules[module.__name__] = module
    specification.loader.exec_module(module)
    return module.SCENES


ACCURACY_SCENES = accuracy_scenes()
Crack = tuple[float, float, float]  # x, lower and upper end


def central_crack(n: int) -> list[Crack]:
    """0.2 n rows across the pull; midway between two columns where n is even, tips midway between rows."""
    rows, middle = math.floor(0.2 * n), 0.5 * (n - 1)
    low = math.ceil(middle - 0.5 * rows) - 0.5
    return [(math.floor(middle) + 0.5, low, low + rows)]


def two_edge_cracks(n: int) -> list[Crack]:
    """From opposite edges, a tenth of the side apart, growing towards each other."""
    rows, middle, offset = math.floor(0.2 * n), math.floor(0.5 * n), n // 20
    return [(middle - offset - 0.5, -0.5, rows - 0.5), (middle + offset - 0.5, n - rows - 0.5, n - 0.5)]


def eight_cracks(n: int) -> list[Crack]:
    """Two columns of four staggered cracks, each longer by a row than the one before."""
    cracks = []
    for k in range(8):
        column, row = k % 2, k // 2
        x = math.floor(n * (0.38 + 0.24 * column)) + 0.5
        low = math.floor(n * (0.08 + 0.24 * row + 0.06 * column)) + 0.5
        cracks.append((x, low, low + max(2, n // 20) + k))
    return cracks


CRACKS = {"central": central_crack, "two": two_edge_cracks, "eight": eight_cracks}


def plate(model: bempd.Model, n: int, cracks: str = "central", ratio: float = 1 / 3) -> None:
    material = model.add_material(young_modulus=1, poisson_ratio=ratio, critical_stretch=1e-3)
    side = n - 1
    region = model.add_pd_region(material, bempd.rectangle(0, 0, side, side), 1, 4)
    for x, low, high in CRACKS[cracks](n):
        # A bond that only touches a tip counts as cut: a hair's breadth keeps those at the tips.
        model.add_crack([(x, max(low + 1e-6, 0)), (x, min(high - 1e-6, side))])
    for edge, pull in ((4, -1.0), (2, 1.0)):
        model.prescribe_edge(region, edge, "x", pull)
        model.prescribe_edge(region, edge, "y", 0.0)


def holed_plate(model: bempd.Model, n: int, degrees: float | None) -> None:
    """An edge crack that points past a hole of radius 0.1 n; the lattice's rows at an angle to the edges, points on the
    outline, or, without an angle, a square hole on lattice rows."""
    material = model.add_material(young_modulus=1, poisson_ratio=1 / 3, critical_stretch=1e-3)
    half = 0.5 * (n - 1)
    c, s = math.cos(math.radians(degrees or 0)), math.sin(math.radians(degrees or 0))

    def turned(*points: tuple[float, float]) -> list[tuple[float, float]]:
        return [(c * x - s * y, s * x + c * y) for x, y in points]

    region = model.add_pd_region(material, turned((-half, -half), (half, -half), (half, half), (-half, half)), 1, 4)
    if degrees is None:
        side, middle = n // 10, half - math.floor(half)
        corners = ((-side, -side), (-side, side), (side, side), (side, -side))
        model.add_hole(region, [(x + middle, y + middle) for x, y in corners])
    else:
        model.add_circular_hole(region, (0, 0), 0.1 * n)
    row = math.floor(0.05 * n) + (0.5 if n % 2 else 0)
    model.add_crack(turned((-half, row + 1e-6), (-half + math.floor(0.2 * n) + 0.5, row + 1e-6)))
    for edge, pull in ((1, -1.0), (3, 1.0)):
        model.prescribe_edge(region, edge, "x", -s * pull)
        model.prescribe_edge(region, edge, "y", c * pull)


def paper_crack(model: bempd.Model, scheme: str = "symmetric") -> None:
    """The plate of examples/centre_crack: boundary elements left and right, a strip of lattice between."""
    mm = 1e-3
    cells = scheme == "paper"
    half_strip, height = (6.5 if cells else 4.25) * mm, (50.0 if cells else 49.5) * mm
    left, right, width = 25 * mm - half_strip, 25 * mm + half_strip, 50 * mm
    material = model.add_material(young_modulus=30e9, poisson_ratio=1 / 3, critical_stretch=8e-4)
    model.add_bem_region(material, bempd.rectangle(0, 0, left, height), 5 * mm)
    model.add_pd_region(material, bempd.rectangle(left, 0, right, height), 0.5 * mm, 4)
    model.add_bem_region(material, bempd.rectangle(right, 0, width, height), 5 * mm)
    model.add_crack([(25 * mm, 0.5 * height - 5 * mm), (25 * mm, 0.5 * height + 5 * mm)])
    model.prescribe_edge(1, 4, "x", -2e-8)
    model.prescribe_edge(3, 2, "x", 2e-8)
    model.fix_point((0, 0.5 * height), "y")


def paper_slanted_crack(model: bempd.Model) -> None:
    """The plate of examples/mixed_mode_crack: the crack at 45 degrees runs between the points."""
    mm, half = 1e-3, 5e-3 * math.sqrt(0.5)
    left, right, side = 14.75 * mm, 35.25 * mm, 50 * mm
    material = model.add_material(young_modulus=30e9, poisson_ratio=1 / 3, critical_stretch=8e-4)
    model.add_bem_region(material, bempd.rectangle(0, 0, left, side), 5 * mm)
    model.add_pd_region(material, bempd.rectangle(left, 0, right, side), 0.5 * mm, 4)
    model.add_bem_region(material, bempd.rectangle(right, 0, side, side), 5 * mm)
    model.add_crack([(side / 2 - half,) * 2, (side / 2 + half,) * 2])
    model.prescribe_edge(1, 4, "x", -2e-8)
    model.prescribe_edge(3, 2, "x", 2e-8)
    model.fix_point((0, side / 2), "y")


def paper_edge_cracks(model: bempd.Model) -> None:
    """The plate of examples/two_edge_cracks, pulled by tractions on both edges."""
    mm, side, traction = 1e-3, 50e-3, 0.1e6
    low, high, middle = 17.25 * mm, 32.75 * mm, side / 2
    material = model.add_material(young_modulus=72e9, poisson_ratio=1 / 3, fracture_energy=3.28876)
    model.add_bem_region(material, bempd.rectangle(0, 0, side, low), 5 * mm)
    model.add_pd_region(material, bempd.rectangle(0, low, side, high), 0.5 * mm, 4)
    model.add_bem_region(material, bempd.rectangle(0, high, side, side), 5 * mm)
    model.add_crack([(0, middle - mm), (2 * mm, middle - mm)])
    model.add_crack([(side, middle + mm), (side - 2 * mm, middle + mm)])
    model.add_traction(1, 1, "y", -traction)
    model.add_traction(3, 3, "y", traction)
    model.fix_point((middle, 0), "both")
    model.fix_point((middle, side), "x")


def square(model: bempd.Model, elements: int) -> None:
    """Boundary elements only: the unit square, a quarter of the elements on each side."""
    material = model.add_material(young_modulus=1, poisson_ratio=1 / 3)
    model.add_bem_region(material, bempd.rectangle(0, 0, 1, 1), 4 / elements * (1 + 1e-9))
    model.fix_edge(1, 4)
    model.add_traction(1, 2, "x", 1.0)


def clamped(model: bempd.Model, name: str, element_length: float) -> None:
    """An elastic plate of benchmarks/accuracy_cost."""
    scene = ACCURACY_SCENES[name]
    scene.build(model, scene.knobs | {"element_length": element_length})


def clamped_error(model: bempd.Model, name: str, element_length: float) -> float:
    scene = ACCURACY_SCENES[name]
    return float(scene.error(model, scene.knobs | {"element_length": element_length}))


SCENES: dict[str, Callable[..., Any]] = {"plate": plate, "holed_plate": holed_plate, "paper_crack": paper_crack,
                                          "paper_slanted_crack": paper_slanted_crack,
                                          "paper_edge_cracks": paper_edge_cracks, "square": square, "clamped": clamped}
