"""Cracks in boundary elements that tear a body in two: steps end as they do in lattices."""

from __future__ import annotations

import bempd
import pytest


def plate(control: str) -> tuple[bempd.Model, int, int]:
    """One wide and two high, with a crack from its left side; the upper edge is moved up."""
    model = bempd.Model(options={"stepping.control": control})
    material = model.add_material(young_modulus=1, poisson_ratio=0.3, fracture_energy=1e-4)
    region = model.add_bem_region(material, bempd.rectangle(0, 0, 1, 2), 0.25)
    model.add_crack([(0, 1), (0.3, 1.02)])
    below = model.fix_edge(region, 1)
    model.fix_edge(region, 3, "x")
    above = model.prescribe_edge(region, 3, "y", 0.01)
    return model, below, above


@pytest.mark.parametrize("control", ["load", "path"])
def test_a_plate_is_torn_in_two(control: str) -> None:
    model, below, above = plate(control)
    first = model.tips()[0].critical_load_factor
    torn = model.run_to_separation(100)
    print(control, torn.events, "events, torn at", torn.load_factor / first, "of the first load factor")
    assert torn.stop_reason is bempd.StopReason.SEPARATED and torn.separated
    assert torn.peak_resistance > 0 and torn.resistance < 1e-6 * torn.peak_resistance
    assert model.piece_count == 2
    assert abs(model.reaction(above)[1]) < 1e-9 * torn.peak_resistance
    history = model.history()
    assert history["energy_balance_error"].max() < 1e-9
    assert torn.bond_energy == pytest.approx(1e-4 * sum(e.length for e in model.extensions()), rel=1e-9)
    if control == "path":
        before_last = history["released_energy"][-2] / history["bond_energy"][-2]
        assert before_last == pytest.approx(1, abs=1e-2)
    # Nothing is left that could grow, and the pieces go on.
    assert model.tips() == []
    on = model.step(2 * torn.load_factor)
    assert on.events == 0 and on.load_factor == 2 * torn.load_factor
    assert abs(model.reaction(above)[1]) < 1e-9 * torn.peak_resistance


def test_a_step_goes_on_when_the_body_is_torn() -> None:
    model, _, above = plate("load")
    first = model.tips()[0].critical_load_factor
    report = model.step(1.5 * first)
    assert report.separated and report.load_factor == 1.5 * first
    assert abs(model.reaction(above)[1]) < 1e-9 * report.peak_resistance


@pytest.mark.parametrize("control", ["load", "path"])
def test_a_plate_that_dead_loads_pull_is_torn_in_two(control: str) -> None:
    """Held at two points of its lower edge against rigid motions: the upper half loses its loads."""
    told: "list[str]" = []
    model = bempd.Model(options={"stepping.control": control}, log=lambda level, message: told.append(message))
    material = model.add_material(young_modulus=1, poisson_ratio=0.3, fracture_energy=1)
    region = model.add_bem_region(material, bempd.rectangle(-1, -2, 1, 2), 0.25)
    model.add_crack([(-0.3, 0), (0.3, 0)])
    model.fix_point((-1, -2))
    model.fix_point((1, -2), "y")
    model.add_traction(region, 3, "y", 1)
    model.add_traction(region, 1, "y", -1)
    first = model.tips()[0].critical_load_factor
    torn = model.run_to_separation(10 * first)
    print(control, torn.events, "events, torn at", torn.load_factor / first, "of the first load factor")
    assert torn.stop_reason is bempd.StopReason.SEPARATED
    assert torn.peak_resistance == pytest.approx(2 * first, rel=1e-6)
    assert any("come free" in message for message in told) and not any("but for a hinge" in message for message in told)
    assert model.piece_count == 2 and torn.fragments == 1
