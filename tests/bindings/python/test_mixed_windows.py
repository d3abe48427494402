"""Lattices in windows beside cracks of boundary element regions that may grow: the events of the whole body, at a lower cost."""

from __future__ import annotations

import pytest

import bempd

WIDTH = 24.0


def plate(solver: str, rule: str, toughness: float) -> bempd.Model:
    """An edge crack in a lattice, and one in boundary elements at its right, each between clamps that move apart."""
    model = bempd.Model(options={"crack.rule": rule, "test.solver": solver})
    weak = model.add_material(young_modulus=8 / 9, poisson_ratio=1 / 3, fracture_energy=1)
    tough = model.add_material(young_modulus=8 / 9, poisson_ratio=1 / 3, fracture_energy=toughness)
    lattice = model.add_pd_region(weak, bempd.rectangle(0, 0, WIDTH, WIDTH), 1.0, 3)
    box = model.add_bem_region(tough, bempd.rectangle(WIDTH, 0, 2 * WIDTH, WIDTH), 4.0)
    model.add_crack([(0, WIDTH / 2 + 0.013), (WIDTH / 4, WIDTH / 2 + 0.013)])
    model.add_crack([(2 * WIDTH, WIDTH / 2 + 0.1), (1.8 * WIDTH, WIDTH / 2 + 0.1)])
    for region in (lattice, box):
        for edge, value in ((1, -1.0), (3, 1.0)):
            model.prescribe_edge(region, edge, "y", value)
            model.fix_edge(region, edge, "x")
    return model


# The crack in elements grows not at all, or first.
@pytest.mark.parametrize(("rule", "toughness"), [("bond", 3.0), ("line", 3.0), ("bond", 1.4)])
def test_events_and_loads_are_those_of_the_whole_body(rule: str, toughness: float) -> None:
    windows, plain = plate("window", rule, toughness), plate("plain", rule, toughness)
    for _ in range(12):
        ahead, whole = windows.step_to_next_event(1e6), plain.step_to_next_event(1e6)
        assert (ahead.total_broken_bonds, ahead.stop_reason) == (whole.total_broken_bonds, whole.stop_reason)
        assert ahead.load_factor == pytest.approx(whole.load_factor, rel=1e-9)
        assert ahead.work == pytest.approx(whole.work, rel=1e-9)
        assert ahead.released_energy == pytest.approx(whole.released_energy, rel=1e-8)
    assert [e.crack for e in windows.extensions()] == [e.crack for e in plain.extensions()]


def test_breaks_change_no_factor_of_the_whole_body() -> None:
    windows, plain = plate("window", "bond", 3.0), plate("plain", "bond", 3.0)
    for model in (windows, plain):
        for _ in range(12):
            model.step_to_next_event(1e6)
    assert plain.statistics().factor_updates >= 12
    assert windows.statistics().factor_updates == 0


def test_supports_that_share_corners_of_elements_have_the_reactions_of_the_whole_body() -> None:
    windows, plain = plate("window", "bond", 3.0), plate("plain", "bond", 3.0)
    for model in (windows, plain):
        model.fix_edge(2, 2, "x")  # shares its ends with edges 1 and 3
        for _ in range(4):
            model.step_to_next_event(1e6)
    assert windows.statistics().factor_updates == 0
    for support in (6, 8, 9):
        ahead, whole = windows.support_history(support), plain.support_history(support)
        assert abs(whole.force[-1, 0]) > 0.3
        assert ahead.force == pytest.approx(whole.force, abs=1e-12)
        assert ahead.force_before == pytest.approx(whole.force_before, abs=1e-12)
        assert windows.reaction(support) == pytest.approx(whole.force[-1], abs=1e-12)


def pressed_row() -> bempd.Model:
    """Four parts in a row, pressed together; a crack that begins in the second one, a lattice, runs into the third, of elements."""
    model = bempd.Model(options={"crack.tie_share": 0.02})
    glass = model.add_material(young_modulus=1, poisson_ratio=1 / 3, fracture_energy=1.6e-6)
    for left, right in ((0, 4), (4, 10), (10, 20), (20, 28)):
        outline = bempd.rectangle(left, 0, right, 4)
        if left == 10:
            model.add_bem_region(glass, outline, 4.0)
        else:
            model.add_pd_region(glass, outline, 1, 2)
    model.fix_edge(1, 4)
    model.prescribe_edge(4, 2, "x", -0.028)
    model.prescribe_edge(2, 3, "y", 0.002, part=(0.25, 0.5))
    return model


def test_a_crack_that_began_in_a_lattice_and_runs_in_elements_is_restored() -> None:
    """The state was refused: faces of bonds that broke before the crack left the lattice are cut by the longer crack now."""
    model = pressed_row()
    for _ in range(3):
        model.step_to_next_event(1e9)
        state = model.save()
        loads = [model.step_to_next_event(1e9).load_factor for _ in range(2)]
        model.restore(state)
        assert [model.step_to_next_event(1e9).load_factor for _ in range(2)] == loads
        model.restore(state)


def test_a_piece_cut_off_that_leaves_a_node_without_a_bond_is_held() -> None:
    """It was refused as indefinite where rounding made the node's stiffness negative."""
    model = pressed_row()
    broken = [model.step_to_next_event(1e9).total_broken_bonds for _ in range(13)]
    assert broken[-1] > broken[0]
