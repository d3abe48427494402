"""Lives of cracked plates under cycles, and what they are compared with: closed forms, integrations, small steps.

da/dN = 1e-11 dK^3 in MPa m^(1/2) and m; loads are 1 MPa per unit of the load factor, unless a scene says otherwise.
"""

from __future__ import annotations

import functools
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


def two_load_cases() -> tuple[float, float]:
    """Cycles by blocks of a pull and of a pressure in the crack, which have the same factor in a wide plate; and its mean rate."""
    model, _, _ = plate(8.0, 8.0, 2.0)
    crack = model.add_crack([(-0.01, 0), (0.01, 0)])
    pull = model.add_load_case([1, 2])
    pressure = model.add_load_case([model.add_crack_pressure(crack, proportional=1e6)])
    high = [{pull: 1.0, pressure: 0.5}, {pull: 0.8}, {pressure: 0.9}]
    low = [{}, {pressure: 0.2}, {pull: 0.3}]
    cycles, ranges = np.array([1e6, 2e6, 4e6]), np.array([1.5, 0.6, 0.6])
    life = model.grow_fatigue(high, low, cycles, most_length=0.1)
    mean = float((cycles * ranges**EXPONENT).sum() / cycles.sum())
    return life.cycles, wide_plate_by_closed_form() / mean


FLOW_STRESS = 2e6  # over the pull of 1 MPa


def net_section(kind: str) -> tuple[float, float]:
    """Length of a crack in a square of half width 1 at which what is left yields: by the library, and by limit analysis."""
    model, steel, _ = plate(1.0, 1.0, 0.25)
    model.set_growth_rate(steel, coefficient=COEFFICIENT, exponent=EXPONENT, unit_intensity=UNIT, flow_stress=FLOW_STRESS)
    model.add_crack([(-0.1, 0), (0.1, 0)] if kind == "middle crack" else [(-1, 0), (-0.9, 0)])
    life = model.grow_fatigue()
    assert life.stop_reason == bempd.FatigueStop.NET_SECTION
    if kind == "middle crack":
        return model.crack_length(1), 2 * (1 - 1e6 / FLOW_STRESS)
    # Force and moment about the middle of what is left, n^2 + 2 n a / b = 1 with n = pull W / (flow stress b), b = W - a.
    low, high = 0.1, 1.9
    for _ in range(60):
        a = (low + high) / 2
        n = 1e6 * 2 / (FLOW_STRESS * (2 - a))
        low, high = (a, high) if n * n + 2 * n * a / (2 - a) < 1 else (low, a)
    return model.crack_length(1), low


# Overloads: factors in MPa m^(1/2), the wide plate pulled by 100 MPa per unit of the load factor.
YIELD, CONSTRAINT, WHEELER, SHUTOFF, RETARDED_COEFFICIENT, WALKER = 300.0, 2.0, 1.5, 3.0, 1e-11, 0.5
PROGRAMS = {"an overload in each 5000 cycles": ([2.0, 1.0], [0.0, 0.2], [1.0, 5000.0], 3e5),
            "one overload": ([2.0, 1.0], [0.0, 0.2], [1.0, 1e9], 1.5e5),
            "none": ([1.0], [0.2], [1e9], 1.5e5)}


def retarded(kind: str, program: str) -> tuple[float, float]:
    """Growth of one end of a crack of 0.02 in the wide plate under overloads: by the library, and by a fine integration."""
    high, low, cycles, most = PROGRAMS[program]
    model, steel, _ = plate(8.0, 8.0, 2.0)
    kinds = {"wheeler": {"wheeler_exponent": WHEELER}, "willenborg": {"shutoff_ratio": SHUTOFF}}
    model.set_growth_rate(steel, coefficient=RETARDED_COEFFICIENT, exponent=EXPONENT, unit_intensity=UNIT, walker=WALKER,
                          retardation=kind, yield_strength=YIELD * 1e6, **kinds[kind])
    model.add_crack([(-0.01, 0), (0.01, 0)])
    model.grow_fatigue([100 * value for value in high], [100 * value for value in low], cycles, most_cycles=most)
    return model.crack_length(1) / 2 - 0.01, _integrated(kind, high, low, cycles, most) - 0.01


def _integrated(kind: str, high: list[float], low: list[float], cycles: list[float], most: float) -> float:
    """Half the length of the crack after so many cycles, with K = stress sqrt(pi a), by short steps of fourth order."""
    a, passed = 0.01, 0.0
    end, zone, overload = -math.inf, 0.0, 0.0

    def rate(at: float, top: float, bottom: float) -> float:
        root = math.sqrt(math.pi * at)
        most_k, least_k, share = 100 * top * root, 100 * bottom * root, 1.0
        own = (most_k / YIELD) ** 2 / (CONSTRAINT * math.pi)
        if at + own < end:
            if kind == "wheeler":
                share = (own / (end - at)) ** WHEELER
            else:
                less = (overload * math.sqrt((end - at) / zone) - most_k) / (SHUTOFF - 1)
                most_k, least_k = most_k - max(0.0, less), least_k - max(0.0, less)
        if most_k <= 0:
            return 0.0
        return share * RETARDED_COEFFICIENT * ((1 - least_k / most_k) ** (WALKER - 1) * (most_k - least_k)) ** EXPONENT

    while passed < most:
        for top, bottom, count in zip(high, low, cycles):
            left = min(count, most - passed)
            while left > 0:
                k = 100 * top * math.sqrt(math.pi * a)
                own = (k / YIELD) ** 2 / (CONSTRAINT * math.pi)
                if a + own >= end:
                    end, zone, overload = a + own, own, k
                first = rate(a, top, bottom)
                step = min(left, 1.0 if count < 100 else 20.0) if first > 0 else left
                second = rate(a + 0.5 * step * first, top, bottom)
                third = rate(a + 0.5 * step * second, top, bottom)
                fourth = rate(a + step * third, top, bottom)
                a += step / 6 * (first + 2 * (second + third) + fourth)
                left, passed = left - step, passed + step
    return a


# Lives of cracks in lattices beside those in boundary elements: cracks in a square of side 1, and the length of the first one to
# which they grow. The last one turns in its first step.
SQUARES: dict[str, tuple[list[list[tuple[float, float]]], float]] = {
    "edge crack": ([[(0, 0), (0.3, 0)]], 0.55),
    "centre crack": ([[(0.345, 0.005), (0.655, 0.005)]], 0.45),
    "two edge cracks": ([[(0.75, 0.01), (1, 0.01)], [(0, 0.01), (0.2, 0.01)]], 0.3),
    "slanted crack": ([[(0.375, -0.125), (0.625, 0.125)]], 0.475),
}


@functools.cache
def square_life(scene: str, spacings: int = 0) -> float:
    """Cycles until the first crack has its last length, with elements, or as a line in a lattice of so many spacings."""
    cracks, end = SQUARES[scene]
    model = bempd.Model(log=None)
    acrylic = model.add_material(young_modulus=3e9, poisson_ratio=1 / 3, fracture_energy=1e6)
    square = bempd.rectangle(0, -0.5, 1, 0.5)
    if spacings:
        region = model.add_pd_region(acrylic, square, spacing=1 / spacings)
    else:
        region = model.add_bem_region(acrylic, square, element_length=1 / 8)
    for crack in cracks:
        model.add_crack(crack)
    model.fix_edge(region, 1)
    model.add_traction(region, 3, "y", 1e6)
    model.set_growth_rate(acrylic, coefficient=COEFFICIENT, exponent=EXPONENT, unit_intensity=UNIT, critical_intensity=1e6)
    return model.grow_fatigue(most_length=end).cycles_at(end)


# A plate 2 x 2 of two halves, each of elements or of a lattice. Its cracks: one from each side; or one that runs from the left
# half into the right one. Then the lengths of the first crack at which lives are compared, the last one at which they end.
HALVES: dict[str, tuple[list[list[tuple[float, float]]], list[float]]] = {
    "a crack in each half": ([[(-1, 0.005), (-0.7, 0.005)], [(0.75, 0.005), (1, 0.005)]], [0.5]),
    "a crack across the border": ([[(-1, 0.005), (-0.3, 0.005)]], [0.8, 1.2]),
}


def halves(left: str, right: str, cracks: list[list[tuple[float, float]]], spacings: int = 40) -> tuple[bempd.Model, list[int]]:
    """The plate, and its loads. A half is of `elements` or a `lattice`."""
    model = bempd.Model(log=None)
    acrylic = model.add_material(young_modulus=3e9, poisson_ratio=1 / 3, fracture_energy=1e6)
    loads = []
    for kind, x in ((left, -1.0), (right, 0.0)):
        half = bempd.rectangle(x, -1, x + 1, 1)
        region = (model.add_bem_region(acrylic, half, element_length=1 / 8) if kind == "elements"
                  else model.add_pd_region(acrylic, half, spacing=1 / spacings))
        model.fix_edge(region, 1)
        loads.append(model.add_traction(region, 3, "y", 1e6))
    for crack in cracks:
        model.add_crack(crack)
    model.set_growth_rate(acrylic, coefficient=COEFFICIENT, exponent=EXPONENT, unit_intensity=UNIT, critical_intensity=1e6)
    return model, loads


@functools.cache
def life_in_halves(left: str, right: str, scene: str, spacings: int = 40) -> list[float]:
    """Cycles at which the first crack has its lengths."""
    cracks, lengths = HALVES[scene]
    model, _ = halves(left, right, cracks, spacings)
    life = model.grow_fatigue(most_length=lengths[-1])
    return [life.cycles_at(length) for length in lengths]


def life_under_cases(spacings: int = 0, shear: float = 0.0, **options: Any) -> bempd.FatigueLife:
    """A middle crack in a square under two cases, a pull and a shear, in blocks: elements, or a lattice of so many spacings."""
    model = bempd.Model(log=None)
    acrylic = model.add_material(young_modulus=3e9, poisson_ratio=1 / 3, fracture_energy=1e6)
    square = bempd.rectangle(0, -0.5, 1, 0.5)
    region = model.add_pd_region(acrylic, square, spacing=1 / spacings) if spacings else model.add_bem_region(acrylic, square, element_length=1 / 8)
    model.add_crack(SQUARES["centre crack"][0][0])
    model.fix_edge(region, 1)
    pull, slide = (model.add_load_case([model.add_traction(region, 3, axis, 1e6)]) for axis in ("y", "x"))
    model.set_growth_rate(acrylic, coefficient=COEFFICIENT, exponent=EXPONENT, unit_intensity=UNIT, critical_intensity=1e6)
    return model.grow_fatigue([{pull: 1.0, slide: shear}, {pull: 0.6}], [{}, {pull: 0.2}], [1e6, 2e6],
                              most_length=SQUARES["centre crack"][1], **options)
