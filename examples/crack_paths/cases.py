"""Bodies in which the way of cracks is known, each as a function that returns a loaded model."""

from __future__ import annotations

import math
from typing import Sequence

import bempd

Place = tuple[float, float]


def two_holes(sides_held: bool) -> bempd.Model:
    """Bouchard's plate, 20 x 10 mm, with two holes and two edge cracks, its top and bottom drawn apart; `sides_held`: they
    do not move sideways. Bouchard, Bay and Chastel, Comput. Methods Appl. Mech. Eng. 192, 2003."""
    model = bempd.Model()
    material = model.add_material(young_modulus=2e5, poisson_ratio=0.3, plane="strain", fracture_energy=1)
    plate = model.add_bem_region(material, bempd.rectangle(0, 0, 20, 10), element_length=1.25)
    model.add_circular_hole(plate, (3, 7), 2)
    model.add_circular_hole(plate, (17, 3), 2)
    model.add_crack([(0, 2.85), (1, 2.85)])
    model.add_crack([(20, 7.15), (19, 7.15)])
    model.prescribe_edge(plate, 1, "y", -0.05)
    model.prescribe_edge(plate, 3, "y", 0.05)
    if sides_held:
        model.fix_edge(plate, 1, "x")
        model.fix_edge(plate, 3, "x")
    else:
        model.fix_point((0, 10), "x")
        model.fix_point((20, 0), "x")
    return model


HOLES = ((6.0, 2.75), (6.0, 4.75), (6.0, 6.75))
HOLE_RADIUS = 0.25


def three_holes(notch: float, offset: float) -> bempd.Model:
    """Beam of acrylic glass, 20 x 8 inches, in three-point bending, with three holes and a notch `offset` to the left of the
    middle. Ingraffea and Grigoriu 1990; Bittencourt et al., Eng. Fract. Mech. 55, 1996."""
    model = bempd.Model()
    material = model.add_material(young_modulus=205e3, poisson_ratio=0.3, plane="strain", fracture_energy=1)
    beam = model.add_bem_region(material, bempd.rectangle(0, 0, 20, 8), element_length=1)
    for hole in HOLES:
        model.add_circular_hole(beam, hole, HOLE_RADIUS)
    model.add_crack([(10 - offset, 0), (10 - offset, notch)])
    model.fix_point((1, 0))
    model.fix_point((19, 0), "y")
    model.add_point_force((10, 8), "y", -1)
    return model


def edge_cracks(offset: float = 0.5, length: float = 8.0, width: float = 40.0) -> bempd.Model:
    """Two edge cracks that run past each other, `offset` above and below the middle of a square plate under tension. Sumi
    and Wang, Mech. Mater. 28, 1998 (40 mm, 8 mm, 1 mm between them)."""
    model = bempd.Model()
    material = model.add_material(young_modulus=1, poisson_ratio=0.3, fracture_energy=1)
    corners = bempd.rectangle(0, -width / 2, width, width / 2)
    plate = model.add_bem_region(material, corners, element_length=4)
    model.add_crack([(0, offset), (length, offset)])
    model.add_crack([(width, -offset), (width - length, -offset)])
    model.fix_point(corners[0])
    model.fix_point(corners[1], "y")
    model.add_traction(plate, 3, "y", 1)
    model.add_traction(plate, 1, "y", -1)
    return model


def four_points() -> bempd.Model:
    """Notched beam of mortar, 1322 x 306 mm, in four-point shear: supports 61 mm to the left of the notch and 458 mm to the
    right of it, the load 61 mm to the right and 0.13 of it 458 mm to the left. Arrea and Ingraffea, Cornell University
    report 81-13, 1982."""
    model = bempd.Model()
    material = model.add_material(young_modulus=24800, poisson_ratio=0.18, thickness=156, fracture_energy=0.1)
    corners = [(-661, 0), (661, 0), (661, 306), (-661, 306)]
    model.add_bem_region(material, corners, element_length=76.5)
    model.add_crack([(0, 0), (0, 82)])
    model.fix_point((-61, 0))
    model.fix_point((458, 0), "y")
    model.add_point_force((61, 306), "y", -1)
    model.add_point_force((-458, 306), "y", -0.13)
    return model


def compressed_plate(tip: Place) -> bempd.Model:
    """Plate of acrylic glass, 140 x 70 mm, with a hole of radius 15 mm and a notch from it, pressed together at the middle 40
    mm of its ends. Its tip is where the photographs have it. Rethore, open data set on mixed mode fracture, 2018."""
    model = bempd.Model()
    material = model.add_material(young_modulus=5e3, poisson_ratio=0.32, plane="strain", fracture_energy=0.43)
    corners = [(0, 0), (140, 0), (140, 15), (140, 55), (140, 70), (0, 70), (0, 55), (0, 15)]
    plate = model.add_bem_region(material, corners, element_length=8)
    centre, radius = (95.0, 35.0), 15.0
    model.add_circular_hole(plate, centre, radius)
    way = math.dist(centre, tip)
    mouth = tuple(c + radius / way * (t - c) for c, t in zip(centre, tip))
    model.add_crack([mouth, tip])
    model.fix_edge(plate, 7)
    model.prescribe_edge(plate, 3, "x", -1)
    model.fix_edge(plate, 3, "y")
    return model


def run(model: bempd.Model, length: float, steps: int, **options: float | str) -> bempd.Model:
    """Lets cracks grow until they cut the body in two or have no tip left."""
    model.options["crack.direction"] = "chord"
    model.options["crack.tie_share"] = 0.01  # symmetric tips grow together
    for name, value in options.items():
        model.options["crack." + name] = value
    for _ in range(steps):
        try:
            model.grow_cracks(length)
        except (bempd.ArgumentError, bempd.UnsolvableError):
            break
    return model


def path(model: bempd.Model, crack: int, start: Sequence[Place]) -> list[Place]:
    """Where a crack has gone, from its first points on."""
    return [*start, *((e.x, e.y) for e in model.extensions() if e.crack == crack)]
