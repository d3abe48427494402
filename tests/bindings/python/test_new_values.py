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


def test_a_program_loads_unloads_and_goes_on(strip):
    end = 1.05 * strip.model.run_to_separation(1e4).load_factor
    host = make_strip()
    report = host.model.run_program([1, 2, 3], [0.5 * end, -0.1 * end, end])
    assert report.load_factor == 3 and report.energy_balance_error < 1e-9
    assert report.total_broken_bonds == strip.model.history()["total_broken_bonds"][-1]


def test_columns_of_a_program_are_of_supports(strip):
    host = make_strip()
    host.model.run_program([1.0, 2.0], supports={host.pulled: [3.0, 2.0]})
    strip.model.step(2.0)
    np.testing.assert_allclose(host.model.reaction(host.pulled), strip.model.reaction(strip.pulled), rtol=1e-9, atol=1e-9)


@pytest.mark.parametrize("given, words", [
    (dict(times=[1, 2], factors=[1]), "shape"),
    (dict(times=[[1, 2]], factors=[[1, 2]]), "row"),
    (dict(times=[1, 2]), "give factors"),
    (dict(times=[], factors=[]), "row"),
    (dict(times=[2, 1], factors=[1, 2]), "increase"),
    (dict(times=[1, float("nan")], factors=[1, 2]), "finite"),
    (dict(times=[1], factors=[float("inf")]), "finite"),
    (dict(times=[1], loads={1: [1]}), "load 1"),
    (dict(times=[1], supports={"one": [1]}), "whole"),
    (dict(times=[1], factors=[1], until="now"), "until")])
def test_tables_that_cannot_be_meant_are_refused(strip, given, words):
    with pytest.raises(bempd.ArgumentError, match=words):
        strip.model.run_program(given.pop("times"), given.pop("factors", None), **given)


def test_a_pressure_goes_with_its_crack():
    model = bempd.Model()
    solid = model.add_material(young_modulus=1, poisson_ratio=0.2)
    body = model.add_pd_region(solid, bempd.rectangle(0, 0, 8, 10), 1, 3)
    load = model.add_crack_pressure(model.add_crack([(0, 5.5), (8, 5.5)]), 2.0)
    top, bottom = model.fix_edge(body, 3), model.fix_edge(body, 1)
    model.step(1)
    np.testing.assert_allclose(model.reaction(top), [0, -16], atol=1e-9)
    model.set_load_values(load, constant=3.0)
    model.step(2)
    np.testing.assert_allclose(model.reaction(bottom), [0, 24], atol=1e-9)


@pytest.mark.parametrize("kind", ["bem", "pd"])
def test_a_region_turns_about_an_axis(kind):
    model = bempd.Model()
    solid = model.add_material(young_modulus=1000, poisson_ratio=0.2)
    add = model.add_bem_region if kind == "bem" else model.add_pd_region
    body = add(solid, bempd.rectangle(1, 0, 9, 10), 1)
    load = model.add_rotation(body, (1, 0), 0.5)
    bottom = model.fix_edge(body, 1)
    model.step(1)
    np.testing.assert_allclose(model.reaction(bottom), [-160, -200], rtol=1e-8)
    model.set_load_values(load, constant=1.0)
    model.step(2)
    np.testing.assert_allclose(model.reaction(bottom), [-320, -400], rtol=1e-8)
