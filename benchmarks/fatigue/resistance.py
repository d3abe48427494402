"""Growth against a resistance that depends on growth or on direction, and what it is compared with."""

from __future__ import annotations

import math

import bempd
import numpy as np

#: Peaks of sigma sqrt(a0 / (E G)) for R = G (1 - exp(-da / l)) and the growth there, where e^(da / l) = 1 + (a0 + da) / l.
PEAKS = {0.25: (0.42842, 0.48421), 0.5: (0.37591, 0.75262), 1.0: (0.31808, 1.14619)}


def peak(length: float, step: float = 0.05, half_width: float = 100.0) -> float:
    """Largest stress that a centre crack of half length 1 bears in a wide plate of E = 1, with the rising resistance."""
    model = bempd.Model(options={"stepping.control": "path", "crack.step": step}, log=None)
    material = model.add_material(young_modulus=1.0, poisson_ratio=0.3, fracture_energy=1.0)
    growth = np.concatenate([[0.0], np.linspace(0.01, 8.0, 400)]) * length
    model.set_resistance_curve(material, growth, np.maximum(1 - np.exp(-growth / length), 1e-6))
    w = half_width
    region = model.add_bem_region(material, bempd.rectangle(-w, -w, w, w), element_length=w / 4)
    model.add_crack([(-1, 0), (1, 0)])
    model.fix_point((-w, -w))
    model.fix_point((w, -w), "y")
    model.add_traction(region, 3, "y", 1.0)
    model.add_traction(region, 1, "y", -1.0)
    largest = 0.0
    while model.crack_length(1) < 2 * (1.4 + PEAKS[length][1]):
        model.step_to_next_event(1e9)
        largest = max(largest, model.load_factor)
    return largest


def kink_on_weak_plane(ratio: float, kind: str = "elements", criterion: str = "energy") -> tuple[float, float]:
    """First turn of a crack in mode I beside a weak plane at 45 degrees, and its load over that of growth straight on."""
    loads = []
    for weak in (1.0, ratio):
        model = bempd.Model(options={"stepping.control": "path", "crack.criterion": criterion}, log=None)
        material = model.add_material(young_modulus=1.0, poisson_ratio=1 / 3, fracture_energy=1.0)
        plane = math.pi / 4
        model.set_resistance_directions(material, [plane - 0.01, plane, plane + 0.01], [1.0, weak, 1.0])
        if kind == "elements":
            region = model.add_bem_region(material, bempd.rectangle(-10, -10, 10, 10), element_length=2.5)
        else:
            region = model.add_pd_region(material, bempd.rectangle(-10, -10, 10, 10), spacing=0.5)
        model.add_crack([(-2.5, 0), (2.5, 0)])
        model.fix_edge(region, 1)
        model.prescribe_edge(region, 3, "y", 1.0)
        model.step_to_next_event(1e9)
        loads.append(model.load_factor)
    return model.extensions()[0].angle, loads[1] / loads[0]


def critical_ratio(kind: str = "elements", criterion: str = "energy") -> float:
    """G_c of the plane over that of the rest below which it is taken, by bisection."""
    low, high = 0.4, 1.0
    while high - low > 1e-5:
        middle = (low + high) / 2
        taken = abs(kink_on_weak_plane(middle, kind, criterion)[0]) > 0.5
        low, high = (middle, high) if taken else (low, middle)
    return (low + high) / 2
