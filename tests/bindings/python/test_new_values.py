"""New values of loads and supports, as a host that couples gives them."""

import bempd
import numpy as np
import pytest
from conftest import make_strip


def events(model):
    history = model.history()
    return history[history["event"] > 0]


def test_steps_to_values_break_what_one_proportional_load_breaks(strip):
    end = 1.05 * strip.model.run_to_separation(1e4).load_factor
    host = make_strip()
    for time in np.linspace(0, 1, 9)[1:]:
        host.model.set_support_values(host.pulled, constant=1e-6 * end * time)
        report = host.model.step_to_values(time)
        assert report.load_factor == time
    expected, found = events(strip.model), events(host.model)
    assert len(expected) > 3
    np.testing.assert_array_equal(found["total_broken_bonds"], expected["total_broken_bonds"])
    np.testing.assert_allclose(found["load_factor"] * end, expected["load_factor"], rtol=1e-9)
    np.testing.assert_allclose(found["released_energy"], expected["released_energy"], rtol=1e-9)


def test_a_way_can_be_followed_from_event_to_event(strip):
    end = 1.05 * strip.model.run_to_separation(1e4).load_factor
    host = make_strip()
    host.model.set_support_values(host.pulled, constant=1e-6 * end)
    reasons = [host.model.step_to_values(1.0, until="event").stop_reason for _ in events(strip.model)]
    assert set(reasons) <= {bempd.StopReason.EVENT, bempd.StopReason.SEPARATED}
    np.testing.assert_array_equal(events(host.model)["total_broken_bonds"], events(strip.model)["total_broken_bonds"])


def test_progress_is_told_the_end_of_the_way(strip):
    class Told:
        def start(self, load_factor, goal):
            self.goal = goal

        def __call__(self, load_factor, events, broken_bonds):
            return None

    strip.model.progress = told = Told()
    strip.model.set_support_values(strip.pulled, constant=1e-6)
    strip.model.step_to_values(2.0)
    assert told.goal == 2.0
    strip.model.step_to_values(3.0, until="event")
    assert told.goal is None


def test_bad_ends_of_a_way_are_refused(strip):
    with pytest.raises(bempd.ArgumentError, match="until"):
        strip.model.step_to_values(1.0, until="now")
    with pytest.raises(bempd.ArgumentError, match="already"):
        strip.model.step_to_values(0.0)
