"""Standard specimens beside the formulas of their standards, and load cases that they are read by. claims.fatigue has them beside the
energy of the body."""

from __future__ import annotations

import math
import pathlib
import sys

import numpy as np
import pytest

import bempd

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "benchmarks" / "fatigue"))
import bodies  # noqa: E402

#: Where the library's factors, which are those of the body's energy, are farther from the formula than its source states.
MEASURED = {("SE(B)", "a/W 0.5"): 0.0075, ("SE(B)", "a/W 0.1"): 0.028, ("four-point bend", "a/W 0.2"): 0.0025,
            ("four-point bend", "a/W 0.4"): 0.0040}
#: Differences from formulas whose sources state no accuracy.
UNSTATED = {"CTS": 0.03, "cracked hole": 0.02, "lug": 0.022}


@pytest.mark.parametrize("kind, sizes, shape", [case for case in bodies.CASES if case[2] != "2a/d 0.0067"])
def test_factors_are_those_of_the_formula(kind: str, sizes: dict[str, float], shape: str) -> None:
    """Of a lug's shortest crack, whose formula does not hold, see the next test."""
    specimen = bempd.specimens.KINDS[kind](**sizes)
    difference, formula = specimen.difference(), specimen.formula
    print(f"{kind} {shape}: {100 * difference:+.2f} %, the source states {100 * formula.accuracy:g} %")
    stated = UNSTATED[kind] if math.isnan(formula.accuracy) else formula.accuracy
    assert not formula.holds or abs(difference) < MEASURED.get((kind, shape), stated)
    assert formula.holds or kind == "lug"


def test_short_cracks_of_a_lug_tend_to_edge_cracks() -> None:
    differences = [bempd.specimens.lug(width=0.06, hole=0.03, crack=crack, force=1e4, thickness=0.01).difference()
                   for crack in (1e-4, 2.5e-5)]
    print(f"from the limit of a short crack: {[f'{100 * one:+.2f} %' for one in differences]}")
    assert differences[1] == pytest.approx(differences[0] / 4, abs=5e-4)


def test_a_specimen_is_a_model_that_grows() -> None:
    specimen = bempd.specimens.compact_tension(width=0.05, crack=0.02, force=5000, thickness=0.0125)
    specimen.model.set_growth_rate(specimen.material, coefficient=1e-11, exponent=3, unit_intensity=1e6)
    life = specimen.model.grow_fatigue(1.0, 0.1, most_length=0.045)
    assert life.stop_reason == bempd.FatigueStop.LENGTH and life.cycles > 0


def test_other_materials_thicknesses_and_forces_scale_the_factors() -> None:
    one = bempd.specimens.three_point_bend(width=0.05, crack=0.025, force=1e3, thickness=0.0125)
    other = bempd.specimens.three_point_bend(width=0.05, crack=0.025, force=3e3, thickness=0.025,
                                             material={"young_modulus": 3e9, "poisson_ratio": 0.4})
    factors = [specimen.tips()[0].stress_intensity_1 for specimen in (one, other)]
    assert factors[1] == pytest.approx(1.5 * factors[0], rel=1e-5)


def test_wrong_sizes_are_refused() -> None:
    specimens = bempd.specimens
    with pytest.raises(bempd.ArgumentError, match="middle_tension: crack is 0.2; it must be below the width, 0.1"):
        specimens.middle_tension(width=0.1, crack=0.2, stress=1.0)
    with pytest.raises(bempd.ArgumentError, match="double_edge_tension: crack is 0.05; it must be below half the width"):
        specimens.double_edge_tension(width=0.1, crack=0.05, stress=1.0)
    with pytest.raises(bempd.ArgumentError, match="compact_tension: thickness is 0"):
        specimens.compact_tension(width=0.1, crack=0.05, force=1.0, thickness=0)
    with pytest.raises(bempd.ArgumentError, match="compact_tension_shear: angle is 2"):
        specimens.compact_tension_shear(width=0.09, crack=0.05, force=1.0, angle=2.0, thickness=1.0)
    with pytest.raises(bempd.ArgumentError, match="lug: hole / 2 \\+ crack is 0.035"):
        specimens.lug(width=0.06, hole=0.03, crack=0.02, force=1.0, thickness=1.0)
    with pytest.raises(bempd.ArgumentError, match="cracked_hole: cracks is 3"):
        specimens.cracked_hole(radius=0.01, crack=0.01, stress=1.0, cracks=3)


def test_unknown_load_cases_are_refused() -> None:
    specimen = bempd.specimens.middle_tension(width=0.1, crack=0.03, stress=1e6)
    with pytest.raises(bempd.ArgumentError, match="combine: load case 2 does not exist; there are 1"):
        specimen.model.combine({2: 1.0})
    with pytest.raises(bempd.ArgumentError, match="neither loads nor supports"):
        specimen.model.add_load_case()


def test_moved_supports_are_load_cases_too() -> None:
    model = bempd.Model(log=None)
    glass = model.add_material(young_modulus=70e9, poisson_ratio=0.2)
    plate = model.add_bem_region(glass, bempd.rectangle(-1, -1, 1, 1), element_length=0.5)
    crack = model.add_crack([(-0.3, 0), (0.3, 0)])
    held, pulled = model.fix_edge(plate, 1), model.prescribe_edge(plate, 3, "y", 1e-4)
    inside = model.add_crack_traction(crack, "pressure", 1e6)
    pull, open_it = model.add_load_case(supports=[pulled]), model.add_load_case([inside])
    both = model.combine({pull: 2.0, open_it: -1.0})
    apart = [model.combine({case: 1.0}) for case in (pull, open_it)]
    assert both.pressed_faces == apart[0].pressed_faces == apart[1].pressed_faces == 0
    force = 2 * apart[0].reaction(held) - apart[1].reaction(held)
    assert both.reaction(held)[1] == pytest.approx(force[1], rel=1e-9)
    stress = 2 * apart[0].evaluate([(0.5, 0.5)]).stress - apart[1].evaluate([(0.5, 0.5)]).stress
    np.testing.assert_allclose(both.evaluate([(0.5, 0.5)]).stress, stress, rtol=1e-8)
