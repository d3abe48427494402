"""A call that fails leaves nothing behind: neither cracks, nor plans, nor factors of a scene that is gone."""

from __future__ import annotations

import bempd
import pytest
from bempd import TipEnd


class Enough(Exception):
    """Raised by a function of the host to cancel a call."""


@pytest.mark.parametrize("share", [0.6, 0.999])
def test_a_plan_that_was_cancelled_in_a_late_mesh_is_made_anew(share: float) -> None:
    def square(most_calls: float) -> tuple[bempd.Model, list[int]]:
        calls = [0]

        def pull(x: float, y: float) -> tuple[tuple[float, float], tuple[float, float]]:
            calls[0] += 1
            if calls[0] == most_calls:
                raise Enough
            return (0, 0), (1, 0)

        model = bempd.Model(options={"error.wanted": 0.05, "test.halvings": 2}, log=lambda level, message: None)
        body = model.add_body(model.add_material(young_modulus=1, poisson_ratio=0.3), bempd.rectangle(0, 0, 1, 1))
        model.fix_edge(body, 4)
        model.add_traction_function(body, 2, pull)
        return model, calls

    undisturbed, calls = square(0)
    undisturbed.prepare()
    model, _ = square(int(share * calls[0]))
    with pytest.raises(Enough):
        model.prepare()
    assert model.plan().boundary_elements > 0
    model.prepare()
    assert model.plan().boundary_elements == undisturbed.plan().boundary_elements
    model.step(1), undisturbed.step(1)
    assert (model.reaction(1) == undisturbed.reaction(1)).all()


def test_a_program_that_was_cancelled_after_growth_is_taken_back() -> None:
    model = bempd.Model(options={"stepping.control": "load", "crack.step": 0.2})
    glass = model.add_material(young_modulus=1, poisson_ratio=0.3, fracture_energy=1e-3)
    beam = model.add_bem_region(glass, [(0, 0), (4, 0), (4, 1), (0, 1), (0, 0.5)], 0.5)
    crack = model.add_crack([(0, 0.5), (1, 0.5)])
    model.fix_edge(beam, 2)
    model.prescribe_edge(beam, 4, "y", 1)
    model.prescribe_edge(beam, 5, "y", -1)
    model.step(0.1)
    before, grown = model.history(), list[int]()

    def cancel_in_the_second_row(time: float, events: int, broken_bonds: int) -> None:
        if time > 1:
            grown.append(events)
            model.request_cancel()

    model.progress = cancel_in_the_second_row
    with pytest.raises(bempd.CancelledError):
        model.run_program([1, 2], [0.24, 0.5])
    assert grown == [2]  # the first event was in the first row
    assert model.load_factor == 0.1 and model.crack_length(crack) == 1 and (model.history() == before).all()
    model.progress = None
    assert model.step_to_next_event(1).load_factor == pytest.approx(0.184, rel=0.02)


def test_growth_after_a_failed_call_asks_the_present_material() -> None:
    """The scene of the failed call may have been where that of the next one is."""
    loads = []
    for _ in range(8):
        model = bempd.Model(options={"stepping.control": "path"})
        glass = model.add_material(young_modulus=1, poisson_ratio=0.3, fracture_energy=1e-3)
        plate = model.add_bem_region(glass, bempd.rectangle(0, 0, 2, 2), 1)
        crack = model.add_crack([(0, 1), (0.4, 1)])
        model.fix_edge(plate, 1)
        model.prescribe_edge(plate, 3, "y", 1)
        for end in TipEnd:
            model.set_tip_frozen(crack, end)
        with pytest.raises(bempd.ArgumentError, match="frozen"):
            model.grow_cracks(0.1)
        for end in TipEnd:
            model.set_tip_frozen(crack, end, False)
        model.set_resistance_curve(glass, [0], [4e-3])
        loads.append(model.grow_cracks(0.1).load_factor)
    assert loads == pytest.approx([loads[0]] * len(loads)) and loads[0] > 0.1  # 0.065 at the material's own energy


def test_a_growth_that_would_separate_the_body_leaves_its_crack() -> None:
    """Two tips tie: one cannot grow, and the other one would cut off a corner that has weight."""
    model = bempd.Model(options={"stepping.control": "load", "crack.tie_share": 1e9, "contact": "none"}, log=lambda level, message: None)
    glass = model.add_material(young_modulus=1, poisson_ratio=1 / 3, fracture_energy=1)
    elements = model.add_bem_region(glass, bempd.rectangle(0, 0, 30, 48), 3)
    lattice = model.add_pd_region(glass, bempd.rectangle(30, 0, 48, 48), 1.0, 3)
    standing = model.add_crack([(28.5, 28.9), (32.5, 32.6)])
    blocked = model.add_crack([(16, 30.1), (28, 30.1)])  # by the one before, at the first points of the lattice
    cutter = model.add_crack([(0, 42), (5.9, 47.9)])
    for crack, end in ((standing, TipEnd.START), (standing, TipEnd.END), (blocked, TipEnd.START)):
        model.set_tip_frozen(crack, end)
    for region, part in ((elements, (0, 0.7)), (lattice, (0, 1))):
        model.prescribe_edge(region, 1, "y", -1.0)
        model.prescribe_edge(region, 3, "y", 1.0, part=part)
    weight = model.add_body_force(elements, "y", 1e-3)
    model.fix_point((0, 0), "x")
    assert model.step_to_next_event(1e9).stop_reason is bempd.StopReason.SEPARATED
    assert model.extensions() == []
    # No corner comes off when another tip grows without the weight, while this tip is kept where it is.
    model.set_load_values(weight, 0)
    for crack in (blocked, cutter):
        model.set_tip_frozen(crack, TipEnd.END)
    model.set_tip_frozen(blocked, TipEnd.START, False)
    report = model.step_to_next_event(1e9)
    assert [one.crack for one in model.extensions()] == [blocked] and report.fragments == 0
