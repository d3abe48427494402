"""Cracks that come to where they cannot go on: a step ends there and says so."""

from __future__ import annotations

import bempd
import pytest


def lattice_beside_elements(control: str) -> bempd.Model:
    """A crack in a lattice, 20 spacings wide, runs at boundary elements of another material."""
    model = bempd.Model(options={"stepping.control": control})
    material = model.add_material(young_modulus=1, poisson_ratio=1 / 3, fracture_energy=1)
    lattice = model.add_pd_region(material, bempd.rectangle(0, -10, 20, 10), 1.0, 3)
    tougher = model.add_material(young_modulus=1, poisson_ratio=1 / 3, fracture_energy=2)
    elements = model.add_bem_region(tougher, bempd.rectangle(20, -10, 60, 10), 2.5)
    model.add_crack([(0, 0.5), (8, 0.5)])
    for region in (lattice, elements):
        model.prescribe_edge(region, 1, "y", -1.0)
        model.prescribe_edge(region, 3, "y", 1.0)
    model.fix_point((0, -10), "x")
    return model


@pytest.mark.parametrize("control", ["load", "path"])
def test_a_line_stops_at_the_border_of_its_lattice(control: str) -> None:
    model = lattice_beside_elements(control)
    first = model.step_to_next_event(1e7).load_factor
    stopped = model.run_to_separation(1e7)
    last = model.extensions()[-1]
    print("stopped at", last.x, "at", stopped.load_factor / first, "times the first load factor")
    assert stopped.stop_reason is bempd.StopReason.CRACK_STOPPED
    assert last.ended and last.x == pytest.approx(20, abs=1)
    assert stopped.load_factor < 1.1 * first


def test_steps_before_the_border_are_as_they_were() -> None:
    one, other = lattice_beside_elements("path"), lattice_beside_elements("path")
    whole = one.run_to_separation(1e7)
    while other.step_to_next_event(1e7).stop_reason is bempd.StopReason.EVENT:
        pass
    assert one.extensions() == other.extensions()
    assert whole.total_broken_bonds == other.bonds(1).states.tolist().count(bempd.BondState.BROKEN)


def test_of_tips_that_grow_together_those_stop_that_cannot() -> None:
    """Two tips reach a lattice together. A crack that crosses the border already is in the way of one of them."""
    model = bempd.Model(options={"stepping.control": "path", "crack.tie_share": 1.0})
    glass = model.add_material(young_modulus=1, poisson_ratio=1 / 3, fracture_energy=1)
    elements = model.add_bem_region(glass, bempd.rectangle(0, 0, 30, 48), 3)
    lattice = model.add_pd_region(glass, bempd.rectangle(30, 0, 48, 48), 1.0, 3)
    standing = model.add_crack([(28.5, 28.9), (32.5, 32.6)])
    blocked = model.add_crack([(16, 30.1), (27.75, 30.1)])
    longer = model.add_crack([(0, 16.5), (27.7, 16.5)])
    for crack, end in ((standing, bempd.TipEnd.START), (standing, bempd.TipEnd.END), (blocked, bempd.TipEnd.START)):
        model.set_tip_frozen(crack, end)
    for region in (elements, lattice):
        model.prescribe_edge(region, 1, "y", -1.0)
        model.prescribe_edge(region, 3, "y", 1.0)
    model.fix_point((0, 0), "x")
    reports = [model.step_to_next_event(1e9) for _ in range(3)]
    assert [report.stop_reason for report in reports] == [
        bempd.StopReason.EVENT, bempd.StopReason.CRACK_STOPPED, bempd.StopReason.EVENT]
    last = model.extensions()[-1]
    assert last.crack == longer and last.x > 30
