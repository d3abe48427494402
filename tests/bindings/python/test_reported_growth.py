"""What tips tell of their growth against what the run does: load factor and direction, to the digit."""

from __future__ import annotations

import math

import numpy as np
import pytest

import bempd

LARGEST = float(np.finfo(float).max)
ANGLES = range(-90, 91, 15)


def elements(angle: float, sign: float = 1, **options: str) -> bempd.Model:
    """A crack from the centre of a plate of boundary elements that is pulled where sign times load factor is > 0."""
    model = bempd.Model()
    for name, word in options.items():
        model.options[name.replace("__", ".")] = word
    glass = model.add_material(young_modulus=1, poisson_ratio=0.3, fracture_energy=1)
    plate = model.add_bem_region(glass, bempd.rectangle(-20, -20, 20, 20), 5)
    along = np.array([math.cos(math.radians(angle)), math.sin(math.radians(angle))])
    model.add_crack([-4 * along, 4.5 * along + [0.3, 0.2]])  # not symmetric: one of the two tips comes first
    model.fix_point((-20, -20))
    model.fix_point((20, -20), "y")
    model.add_traction(plate, 3, "y", sign)
    model.add_traction(plate, 1, "y", -sign)
    return model


@pytest.mark.parametrize("angle", ANGLES)
def test_elements_grow_where_their_tips_tell(angle: float) -> None:
    for criterion in ("hoop", "energy"):
        model = elements(angle, growth__criterion=criterion)
        model.step(1e-3)
        tips = model.tips()
        if abs(angle) == 90 and min(tip.critical_load_factor for tip in tips) > 100:
            continue  # along the pull nothing drives it
        first = min(tips, key=lambda tip: tip.critical_load_factor)
        growth = model.grow_cracks(0.5)
        extension = next(e for e in model.extensions() if e.end == first.end)
        assert growth.load_factor == first.critical_load_factor
        assert extension.angle == first.critical_kink_angle
        turned = math.atan2(first.direction_y, first.direction_x) + first.critical_kink_angle
        grown = next(tip for tip in model.tips() if tip.end == first.end)
        assert grown.x - first.x == pytest.approx(0.5 * math.cos(turned), abs=1e-12)
        assert grown.y - first.y == pytest.approx(0.5 * math.sin(turned), abs=1e-12)


@pytest.mark.parametrize("angle", ANGLES[2:-2])
def test_of_loads_that_are_turned_round_the_falling_load_factor_makes_them_grow(angle: float) -> None:
    pulled, pressed = elements(angle), elements(angle, -1)
    pulled.step(1e-3)
    pressed.step(-1e-3)
    for one, other in zip(pulled.tips(), pressed.tips(), strict=True):
        assert one.critical_load_factor == pytest.approx(-other.critical_load_factor_down, rel=1e-12)
        assert one.critical_load_factor < 0.97 * one.straight_load_factor or abs(angle) < 15


def test_of_growth_straight_on_both_load_factors_agree() -> None:
    model = bempd.Model()
    glass = model.add_material(young_modulus=1, poisson_ratio=0.3, fracture_energy=1)
    model.add_bem_region(glass, bempd.rectangle(-20, -20, 20, 20), 5)
    crack = model.add_crack([(-4, 0), (4, 0)])
    model.fix_point((-20, -20))
    model.fix_point((20, -20), "y")
    model.add_crack_traction(crack, "pressure", 1)
    model.step(1e-3)
    for tip in model.tips():
        assert tip.critical_load_factor == pytest.approx(tip.straight_load_factor, rel=1e-6)
        assert tip.critical_load_factor_down == -LARGEST
