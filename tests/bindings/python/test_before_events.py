"""What the history has of the state just before each event: load-displacement curves have their peak there."""

import bempd
import numpy as np
import pytest
from bempd import plot, rectangle
from conftest import make_strip


def torn(limit=1e4, **options):
    strip = make_strip()
    for name, value in options.items():
        strip.model.options[name.replace("__", ".")] = value
    report = strip.model.run_to_separation(limit)
    return strip, report, strip.model.history()


ways = pytest.mark.parametrize("options", [{}, {"test__solver": "plain"}, {"crack__rule": "bond"}, {"stepping__control": "path"}],
                               ids=["lines", "whole body", "bonds", "path"])


@ways
def test_the_peak_is_the_largest_force_before_an_event(options):
    _, report, history = torn(**options)
    events = history[history["event"] > 0]
    assert report.peak_resistance == events["resistance_before"].max() > 1.01 * events["resistance"].max()
    assert report.resistance == events["resistance"][-1]


@ways
def test_energies_balance_before_events(options):
    _, _, history = torn(**options)
    released = np.append(0, history["released_energy"][:-1])
    off = history["work_before"] - history["stored_energy_before"] - released
    assert np.abs(off).max() < 1e-10 * history["work"].max()
    np.testing.assert_array_equal(history["load_factor_before"], history["load_factor"])


def test_forces_before_an_event_are_those_of_a_step_to_just_before_it():
    strip, _, history = torn()
    line = int(np.argmax(history["event"] == 1))
    uncracked = make_strip()
    report = uncracked.model.step(history["load_factor"][line] * (1 - 1e-9))
    of_pulled, of_held = (strip.model.support_history(support) for support in (strip.pulled, strip.held))
    assert report.total_events == 0
    assert of_pulled.force_before[line] == pytest.approx(uncracked.model.reaction(strip.pulled), rel=1e-6, abs=1e-6)
    assert of_held.force_before[line] == pytest.approx(uncracked.model.reaction(strip.held), rel=1e-6, abs=1e-6)
    assert history["stored_energy_before"][line] == pytest.approx(report.stored_energy, rel=1e-6)
    # The pull falls where bonds break; the support goes on with the load factor, and leaves y free.
    assert of_pulled.force[line][0] < 0.999 * of_pulled.force_before[line][0]
    np.testing.assert_allclose(of_pulled.displacement[:, 0], 1e-6 * history["load_factor"], rtol=1e-12)
    assert np.isnan(of_pulled.displacement[:, 1]).all() and not of_held.displacement.any()


def test_the_end_of_a_step_has_no_jump(strip):
    strip.model.step(50)
    (line,), supports = strip.model.history(), strip.model.support_history(strip.pulled)
    for name in ("stored_energy", "work", "load_factor", "resistance"):
        assert line[name] == line[f"{name}_before"]
    np.testing.assert_array_equal(supports.force, supports.force_before)


def test_the_load_curve_has_its_peak():
    strip, report, history = torn()
    axes = plot.load_displacement(strip.model, strip.pulled)
    x, y = axes.lines[0].get_data()
    assert y.max() == pytest.approx(report.peak_resistance, rel=1e-9)
    assert f"{report.peak_resistance:.3g} N" in axes.get_legend().get_texts()[0].get_text()
    assert x[int(np.argmax(y))] == pytest.approx(history["load_factor"][int(np.argmax(history["resistance_before"]))])
    plot.plt.close("all")


def test_increments_end_in_the_curve_where_bonds_just_reach_what_they_bear():
    """A step overshoots the first break by 3 % of an increment, which no body bears."""
    coarse, report, history = torn(crack__rule="bond", paper__mode="paper", paper__increment=7.0)
    exact = torn(crack__rule="bond")[1].peak_resistance
    y = plot.load_displacement(coarse.model, coarse.pulled).lines[0].get_ydata()
    first = history[history["event"] == 1][0]
    assert first["stretch_ratio"] > 1.001
    assert y[1] == pytest.approx(first["resistance_before"], rel=1e-9) and y.max() == pytest.approx(exact, rel=0.05)
    plot.plt.close("all")


def test_a_program_moves_supports_by_its_factors(strip):
    strip.model.run_program([1, 2, 3], [10, 10, -5])
    moved = strip.model.support_history(strip.pulled).displacement[:, 0]
    assert moved == pytest.approx([1e-5, 1e-5, -5e-6])
    x, _ = plot.load_displacement(strip.model, strip.pulled).lines[0].get_data()
    assert x == pytest.approx([0, 10, 10, -5])
    plot.plt.close("all")


def test_states_and_tables_keep_what_was_before(strip, tmp_path):
    strip.model.run_to_separation(1e4)
    strip.model.write_history(tmp_path / "history.csv")
    table, supports = bempd.read_history(tmp_path / "history.csv"), strip.model.support_history(strip.pulled)
    np.testing.assert_allclose(table[f"reaction_before_x_{strip.pulled}"], supports.force_before[:, 0], rtol=1e-12)
    np.testing.assert_allclose(table[f"displacement_x_{strip.pulled}"], supports.displacement[:, 0], rtol=1e-12)
    np.testing.assert_allclose(table["work_before"], strip.model.history()["work_before"], rtol=1e-12)
    again = make_strip().model
    again.restore(bempd.State.from_bytes(strip.model.save().to_bytes()))
    np.testing.assert_array_equal(again.history(), strip.model.history())
    for one, other in zip(again.support_history(strip.pulled), supports):
        np.testing.assert_array_equal(one, other)


def test_growth_of_elements_has_its_state_before():
    model = bempd.Model()
    glass = model.add_material(young_modulus=7e10, poisson_ratio=0.2, fracture_energy=8)
    body = model.add_bem_region(glass, rectangle(0, 0, 2, 1), element_length=0.25)
    model.add_crack([(1, 0), (1, 0.3)])
    model.fix_edge(body, 4)
    pulled = model.prescribe_edge(body, 2, "x", 1e-6)
    model.grow_cracks(0.02)
    entry, supports = model.history()[-1], model.support_history(pulled)
    assert entry["event"] == 1 and supports.force_before[-1][0] > 1.001 * supports.force[-1][0] > 0
    assert entry["stored_energy_before"] > entry["stored_energy"] and entry["resistance_before"] > entry["resistance"]
    assert model.step(model.load_factor).peak_resistance == entry["resistance_before"]


def test_lines_and_supports_that_are_not_there(strip):
    strip.model.step(1)
    with pytest.raises(bempd.ArgumentError, match="support"):
        strip.model.support_history(9)
