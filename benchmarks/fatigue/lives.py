"""Lives of cracked plates under cycles, and what they are compared with: closed forms, integrations, small steps.

da/dN = 1e-11 dK^3 in MPa m^(1/2) and m; loads are 1 MPa per unit of the load factor, unless a scene says otherwise.
"""

from __future__ import annotations

import math
from typing import Any

import bempd
import numpy as np

COEFFICIENT, EXPONENT, UNIT = 1e-11, 3.0, 1e6
# Cycles with steps of at most 2 %, as --references measures them: 131 and 136 steps.
CENTRE_CRACK_FINE, CRACKS_FROM_A_HOLE_FINE = 1.02832969e11, 2.54062536e10


def plate(width: float, height: float, element_length: float) -> tuple[bempd.Model, int, int]:
    """A plate of half these sizes that is pulled upwards: the model, its material and its region."""
    model = bempd.Model(log=None)
    steel = model.add_material(young_modulus=210e9, poisson_ratio=0.3)
    region = model.add_bem_region(steel, bempd.rectangle(-width, -height, width, height), element_length)
    model.fix_point((-width, -height))
    model.fix_point((width, -height), "y")
    model.add_traction(region, 3, "y", 1e6)
    model.add_traction(region, 1, "y", -1e6)
    model.set_growth_rate(steel, coefficient=COEFFICIENT, exponent=EXPONENT, unit_intensity=UNIT)
    return model, steel, region


def centre_crack(**options: Any) -> bempd.FatigueLife:
    """From 0.05 to 0.5 of half the width of a strip."""
    model, _, _ = plate(1.0, 3.0, 0.25)
    model.add_crack([(-0.05, 0), (0.05, 0)])
    return model.grow_fatigue(most_length=1.0, **options)


def centre_crack_by_handbook() -> float:
    """The life by the formula of Tada, Paris and Irwin, section 2.1, whose error is 0.1 %: Simpson's rule."""
    a = np.linspace(0.05, 0.5, 20001)
    factor = (1 - 0.025 * a**2 + 0.06 * a**4) / np.sqrt(np.cos(0.5 * math.pi * a)) * np.sqrt(math.pi * a)
    cycles = 1 / (COEFFICIENT * factor**EXPONENT)
    return float((a[1] - a[0]) / 3 * (cycles[0] + cycles[-1] + 4 * cycles[1:-1:2].sum() + 2 * cycles[2:-1:2].sum()))


def wide_plate(**options: Any) -> bempd.FatigueLife:
    """From 0.01 to 0.05 in a plate of half width 8, which is as good as infinite."""
    model, _, _ = plate(8.0, 8.0, 2.0)
    model.add_crack([(-0.01, 0), (0.01, 0)])
    return model.grow_fatigue(most_length=0.1, **options)


def wide_plate_by_closed_form() -> float:
    return (0.01**-0.5 - 0.05**-0.5) / (0.5 * COEFFICIENT * math.pi**1.5)


def cracks_from_a_hole(**options: Any) -> bempd.FatigueLife:
    """Two unequal cracks from a hole of radius 0.1 in a square of half width 1, until the longer one has 0.25."""
    model, _, region = plate(1.0, 1.0, 0.25)
    model.add_circular_hole(region, (0, 0), 0.1)
    model.add_crack([(0.1, 0), (0.15, 0)])
    model.add_crack([(-0.12, 0), (-0.1, 0)])
    return model.grow_fatigue(most_length=0.25, **options)


BLOCKS = {"high": [10.0, 5.0], "low": [0.0, 1.0], "cycles": [3e6, 4e7]}


def blocks_in_order(order: list[int], most_cycles: float = 2e7) -> tuple[float, float]:
    """Growth of a crack of 0.01 in the wide plate by two long blocks: by the library, and by an integration."""
    model, steel, _ = plate(8.0, 8.0, 2.0)
    model.set_growth_rate(steel, coefficient=10 * COEFFICIENT, exponent=EXPONENT, unit_intensity=UNIT)
    model.add_crack([(-0.01, 0), (0.01, 0)])
    high, low, cycles = ([BLOCKS[name][k] for k in order] for name in ("high", "low", "cycles"))
    model.grow_fatigue(high, low, cycles, most_cycles=most_cycles)
    a, left = 0.01, most_cycles
    while left > 0:
        for top, bottom, count in zip(high, low, cycles):
            passed = min(left, count)
            rate = 10 * COEFFICIENT * (top - bottom) ** EXPONENT * math.pi ** (EXPONENT / 2)
            a, left = (a**-0.5 - 0.5 * rate * passed) ** -2, left - passed
    return model.crack_length(1) / 2 - 0.01, a - 0.01


def many_blocks() -> tuple[float, float]:
    """Cycles by a spectrum of three short blocks, and by its mean rate: a power law's ratios do not change."""
    high, low, cycles = np.array([1.0, 0.8, 0.6]), np.array([0.1, 0.2, 0.0]), np.array([1000.0, 5000.0, 20000.0])
    model, _, _ = plate(8.0, 8.0, 2.0)
    model.add_crack([(-0.01, 0), (0.01, 0)])
    life = model.grow_fatigue(high, low, cycles, most_length=0.1)
    mean = float((cycles * (high - low) ** EXPONENT).sum() / cycles.sum())
    return life.cycles, wide_plate_by_closed_form() / mean
