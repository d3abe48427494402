"""Growth against a resistance that depends on growth or on direction: peaks of R-curves, weak planes."""

from __future__ import annotations

import pathlib
import sys

import numpy as np
import pytest

import bempd

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "benchmarks" / "fatigue"))
import resistance  # noqa: E402


@pytest.mark.parametrize("length", [0.25, 0.5])
def test_peak_of_a_rising_resistance_is_that_of_the_closed_form(length: float) -> None:
    peak, exact = resistance.peak(length), resistance.PEAKS[length][0]
    print(f"peak {peak:.5f}, closed form {exact:.5f}, relative difference {peak / exact - 1:.1e}")
    assert peak == pytest.approx(exact, rel=1e-3)


@pytest.mark.parametrize("kind", ["elements", "lines"])
@pytest.mark.parametrize("criterion, ratio", [("energy", 0.7300), ("hoop", 0.6219)])
def test_weak_plane_is_taken_below_a_ratio(kind: str, criterion: str, ratio: float) -> None:
    # The tips are in mode I within 1e-3, so the ratio of the loads is known within that.
    for share in (0.99, 1.01):
        angle, load = resistance.kink_on_weak_plane(share * ratio, kind, criterion)
        assert angle == pytest.approx(np.pi / 4 if share < 1 else 0.0, abs=2e-3)
        assert load == pytest.approx(min(1.0, share**0.5), abs=1e-3)


def test_a_crack_stays_on_a_weak_plane() -> None:
    model = bempd.Model(options={"stepping.control": "path", "crack.criterion": "energy"}, log=None)
    slate = model.add_material(young_modulus=50e9, poisson_ratio=0.2, fracture_energy=40)
    plane = np.radians(30)
    model.set_resistance_directions(slate, [plane - 0.01, plane, plane + 0.01], [40, 8, 40])
    plate = model.add_bem_region(slate, bempd.rectangle(-1, -1, 1, 1), element_length=0.25)
    model.add_crack([(-1, 0), (-0.6, 0)])
    model.fix_edge(plate, 1)
    model.prescribe_edge(plate, 3, "y", 1e-4)
    for _ in range(6):
        model.step_to_next_event(1e6)
    steps = model.extensions()
    assert steps[0].angle == pytest.approx(plane, abs=1e-6)
    assert all(abs(step.angle) < 1e-6 for step in steps[1:])
    assert all(step.resistance == pytest.approx(8, rel=1e-6) for step in steps)


def test_growth_by_cycles_turns_on_to_the_weak_plane() -> None:
    model = bempd.Model(options={"crack.criterion": "energy"}, log=None)
    steel = model.add_material(young_modulus=210e9, poisson_ratio=0.3, fracture_energy=1e4)
    model.set_resistance_directions(steel, [0.49, 0.5, 0.51], [1e4, 2e3, 1e4])
    plate = model.add_bem_region(steel, bempd.rectangle(0, -1, 2, 1), element_length=0.25)
    model.add_crack([(0, 0), (0.5, 0)])
    model.fix_edge(plate, 1)
    model.add_traction(plate, 3, "y", 1e6)
    model.set_growth_rate(steel, coefficient=1e-11, exponent=3, unit_intensity=1e6)
    model.grow_fatigue(most_length=0.6)
    (first, *_), path = model.extensions(), model.crack_path(1)
    assert first.angle == pytest.approx(0.5, abs=1e-6)
    assert np.arctan2(path[-1].y - path[-2].y, path[-1].x - path[-2].x) == pytest.approx(0.5, abs=1e-6)


def test_arrays_of_different_lengths_are_refused() -> None:
    model = bempd.Model(log=None)
    glass = model.add_material(young_modulus=70e9, poisson_ratio=0.2, fracture_energy=8)
    with pytest.raises(bempd.ArgumentError, match=r"set_resistance_curve: extensions has the shape \(2,\) and energies \(3,\)"):
        model.set_resistance_curve(glass, [0, 1], [1, 2, 3])
    with pytest.raises(bempd.ArgumentError, match="set_resistance_directions: angle 2 is 0.1, not above the one before"):
        model.set_resistance_directions(glass, [0.2, 0.1], [1, 2])
