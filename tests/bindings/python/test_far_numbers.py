"""Numbers near the ends of what a double holds: an error where there is no answer, and no harm to what comes after."""

import bempd
import numpy as np
import pytest
from bempd import rectangle


def strip(**material):
    model = bempd.Model()
    glass = model.add_material(young_modulus=1000, poisson_ratio=1 / 3, **material)
    bar = model.add_bem_region(glass, rectangle(0, 0, 10, 8), element_length=2)
    plate = model.add_pd_region(glass, rectangle(10, 0, 20, 8), spacing=1, horizon_ratio=3)
    model.fix_edge(bar, 4)
    return model, bar, plate


@pytest.mark.parametrize("place", [(np.nan, 1), (np.inf, 2), (1e308, 1e308)])
def test_places_without_a_distance_to_an_edge_are_refused(place):
    model, bar, _ = strip()
    assert model.fractions_on_edge(bar, 2, [(10, 4)]).fractions == [0.5]
    with pytest.raises(bempd.ArgumentError, match="point 2"):
        model.fractions_on_edge(bar, 2, [(10, 4), place])


@pytest.mark.parametrize("far", [1e155, 1e300])
@pytest.mark.parametrize("loaded", ["support", "force"])
def test_steps_go_on_after_energies_that_no_number_holds(far, loaded):
    model, _, plate = strip()
    if loaded == "support":
        model.prescribe_edge(plate, 2, "x", 0.01)
    else:
        model.add_traction(plate, 2, "x", 1.0)
    report = model.step(far)
    assert report.work == np.finfo(float).max
    first = model.history()[0]
    assert np.isfinite(first["resistance"]) and first["resistance"] > 1e-3 * far
    assert report.energy_balance_error == 0 and np.isfinite(report.resistance)
    near = model.step(1)
    assert near.work == pytest.approx(near.stored_energy, rel=1e-9) and near.energy_balance_error < 1e-12
    again = model.step(2)
    assert again.work == pytest.approx(4 * near.work, rel=1e-9)


@pytest.mark.parametrize("rule", ["line", "bond"])
def test_a_body_that_has_parted_at_far_loads_goes_on(rule):
    model, _, plate = strip(fracture_energy=1)
    model.options["crack.rule"] = rule
    model.prescribe_edge(plate, 2, "x", 0.01)
    model.add_crack([(15.5, 0), (15.5, 2.5)])
    assert model.step(1e300).separated
    for load_factor in (1, 2):
        assert model.step(load_factor).load_factor == load_factor


@pytest.mark.parametrize("height, words", [(2e-4, "thinner than some thousandth"), (1e-6, "hold it at another place")])
def test_messages_on_thin_strips_do_not_ask_for_supports(height, words):
    model = bempd.Model()
    steel = model.add_material(young_modulus=1000, poisson_ratio=0.3)
    bar = model.add_bem_region(steel, rectangle(0, 0, 10, height), element_length=1)
    model.fix_edge(bar, 4)
    model.add_traction(bar, 2, "x", 1.0)
    with pytest.raises(bempd.UnsolvableError, match=words) as raised:
        model.step(1)
    assert "check its supports" not in str(raised.value) and "add supports" not in str(raised.value)
