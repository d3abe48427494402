"""Plans of bodies, and what the cracks in them do, are those of the present options and tips."""

from __future__ import annotations

import math

import bempd
import pytest
from bempd import TipEnd


def body(**options: object) -> tuple[bempd.Model, int, int]:
    """Two cracks, of which the first one grows first."""
    model = bempd.Model(options={"error.wanted": 0.05, **options}, log=lambda level, message: None)
    glass = model.add_material(young_modulus=1, poisson_ratio=0.3, fracture_energy=1e-3)
    region = model.add_body(glass, bempd.rectangle(0, 0, 2, 2))
    cracks = model.add_crack([(0, 0.7), (0.5, 0.7)]), model.add_crack([(2, 1.3), (1.6, 1.5)])
    model.fix_edge(region, 1)
    model.prescribe_edge(region, 3, "y", 1)
    return (model, *cracks)


def freeze(model: bempd.Model, crack: int) -> None:
    for end in TipEnd:
        model.set_tip_frozen(crack, end)


def test_a_plan_names_no_tip_that_has_been_frozen_since() -> None:
    model, first, second = body()
    load = model.plan().growth_load_factor
    assert model.plan().growth_crack == first
    freeze(model, first)
    assert model.plan().growth_crack == second and model.plan().growth_load_factor > load
    model.prepare()
    assert model.plan().growth_crack == second
    other = body()[0]
    freeze(other, first)
    assert other.plan().growth_load_factor == model.plan().growth_load_factor


def test_loads_of_growth_are_those_of_the_present_criterion() -> None:
    other, _, second = body(**{"crack.criterion": "energy"})
    freeze(other, 1)
    model = body()[0]
    freeze(model, 1)
    before = model.plan().growth_load_factor
    model.options["crack.criterion"] = "energy"
    planned = model.plan().growth_load_factor
    assert planned != before and planned == other.plan().growth_load_factor
    # The tips of a prepared body, under its own loads and under a combination of cases, have them as well.
    case = model.add_load_case(supports=[2])
    loads = []
    for criterion in ("energy", "hoop"):
        model.options["crack.criterion"] = criterion
        own, combined = model.tips()[-1], model.combine({case: 1}).tips[-1]
        assert own.crack == combined.crack == second
        loads.append((own.critical_load_factor, combined.critical_load_factor))
    (own_energy, case_energy), (own_hoop, case_hoop) = loads
    assert own_energy != own_hoop and case_energy != case_hoop
    assert own_energy == pytest.approx(case_energy) and own_hoop == pytest.approx(case_hoop)
    assert math.isclose(own_energy, own_hoop, rel_tol=0.05)


def test_parts_have_loads_of_the_present_function_of_resistance() -> None:
    model, first, _ = body()
    glass = 1
    loads = []
    for factor in (1, 4):
        model.set_resistance_function(glass, lambda *tip, factor=factor: factor * 1e-3)
        loads.append(model.plan().growth_load_factor)
    assert loads[1] == pytest.approx(2 * loads[0], rel=1e-6)


def test_errors_of_a_run_are_told_if_its_crack_grows_in_the_lattice_alone() -> None:
    model = bempd.Model(options={"stepping.control": "load", "crack.load": "fit", "error.wanted": 0.1},
                        log=lambda level, message: None)
    material = model.add_material(young_modulus=1000, poisson_ratio=1 / 3, fracture_energy=1e-3)
    region = model.add_body(material, bempd.rectangle(0, 0, 60, 90))
    crack = model.add_crack([(0, 45.3), (20 * math.cos(0.5), 45.3 + 20 * math.sin(0.5))])
    model.set_crack_treatment(crack, "lattice")
    model.set_body_lattice(region, 1, 3)
    model.fix_edge(region, 1)
    model.prescribe_edge(region, 3, "x", proportional=0)
    model.prescribe_edge(region, 3, "y", proportional=1)
    model.plan()
    patch = model.parts()[1]
    assert patch.growth_load_factor < 0.995 * patch.element_growth_load_factor
    model.step_to_next_event(0.5 * (patch.growth_load_factor + patch.element_growth_load_factor))
    assert len(model.extensions()) == 1
    told = model.run_error_estimate()
    assert told.is_made and told.lattice_first_growth == 1
    assert math.isfinite(told.first_growth) and math.isfinite(told.peak) and math.isfinite(told.path)
