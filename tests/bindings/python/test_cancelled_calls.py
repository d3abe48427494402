"""A call that fails leaves the state from before it, and the run goes on from there as if nothing had been asked: without windows to
the last byte, with them up to rounding."""

import bempd
import pytest
from conftest import make_strip


class Enough(Exception):
    """Raised by the progress function to cancel a call."""


def run_cancelled(model, events, run):
    told = []

    def progress(load_factor, so_far, broken_bonds):
        told.append(so_far)
        if len(told) == events:
            raise Enough

    model.progress = progress
    with pytest.raises(Enough):
        run()
    model.progress = None


@pytest.mark.parametrize("solver", ["window", "plain"])
@pytest.mark.parametrize("rule", ["line", "bond"])
def test_a_cancelled_run_leaves_the_same_bytes_and_digits(rule, solver):
    strip = make_strip(spacing=0.001, options={"crack.rule": rule, "test.solver": solver})
    model = strip.model
    for _ in range(2):
        model.step_to_next_event(1e9)
    before = model.save().to_bytes()
    for events in (1, 3):
        run_cancelled(model, events, lambda: model.run_to_separation(1e9))
        if solver == "plain":
            assert model.save().to_bytes() == before
    model.step_to_next_event(1e9)
    undisturbed = make_strip(spacing=0.001, options={"crack.rule": rule, "test.solver": solver}).model
    for _ in range(3):
        undisturbed.step_to_next_event(1e9)
    for name in ("load_factor", "released_energy", "stored_energy"):
        exact = 0 if solver == "plain" else 1e-11
        assert model.history()[name] == pytest.approx(undisturbed.history()[name], rel=exact, abs=0)
    assert model.history()["total_broken_bonds"].tolist() == undisturbed.history()["total_broken_bonds"].tolist()


@pytest.mark.parametrize("rule", ["line", "bond"])
def test_a_cancelled_run_under_new_loads_leaves_those_before(rule):
    strip, other = (make_strip(spacing=0.001, options={"crack.rule": rule}) for _ in range(2))
    for model in (strip.model, other.model):
        for _ in range(2):
            model.step_to_next_event(1e9)
    strip.model.set_support_values(strip.pulled, 2e-6)
    before = strip.model.save().to_bytes()
    run_cancelled(strip.model, 1, lambda: strip.model.run_to_separation(1e9))
    assert len(strip.model.save().to_bytes()) == len(before)
    strip.model.step_to_next_event(1e9)
    other.model.set_support_values(other.pulled, 2e-6)
    other.model.step_to_next_event(1e9)
    assert strip.model.history()["load_factor"] == pytest.approx(other.model.history()["load_factor"], rel=1e-11)


@pytest.mark.parametrize("rule", ["line", "bond"])
def test_a_state_saved_after_a_cancelled_run_is_restored(rule):
    strip, other = (make_strip(spacing=0.001, options={"crack.rule": rule, "test.solver": "window"}) for _ in range(2))
    for _ in range(2):
        strip.model.step_to_next_event(1e9)
    run_cancelled(strip.model, 3, lambda: strip.model.run_to_separation(1e9))
    state = strip.model.save()
    other.model.restore(bempd.State.from_bytes(state.to_bytes()))
    for model in (strip.model, other.model):
        model.step_to_next_event(1e9)
    assert strip.model.save().to_bytes() == other.model.save().to_bytes()
