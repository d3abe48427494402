"""Fracture mechanics' own path of the inclined edge crack of `bempd_directions plate`, by boundary elements.

    boundary_path.py INCLINE...     prints: incline, then load factor and tip after each step of 2 spacings"""

from __future__ import annotations

import math
import sys

import bempd

WIDTH, STEP = 80.0, 2.0


def path(incline: float) -> list[tuple[float, float, float]]:
    model = bempd.Model()
    material = model.add_material(young_modulus=8 / 9, poisson_ratio=1 / 3, fracture_energy=1)
    body = model.add_bem_region(material, bempd.rectangle(0, -WIDTH / 2, WIDTH, WIDTH / 2), element_length=WIDTH / 16)
    angle = math.radians(incline)
    model.add_crack([(0, 0), (WIDTH / 5 * math.cos(angle), WIDTH / 5 * math.sin(angle))])
    for edge, value in ((1, -1.0), (3, 1.0)):
        model.prescribe_edge(body, edge, "y", value)
        model.fix_edge(body, edge, "x")
    found = []
    model.step(1.0)
    for _ in range(27):
        tip = model.tips()[0]
        found.append((tip.critical_load_factor, tip.x, tip.y))
        if tip.x > WIDTH - 12:
            break
        model.grow_cracks(STEP)
    return found


if __name__ == "__main__":
    for text in sys.argv[1:]:
        print(text, *(f"{value:.5g}" for place in path(float(text)) for value in place))
