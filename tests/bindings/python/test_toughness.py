"""Fracture energies by place: the load of growth follows the root of G0 at the tip, energies follow its integral."""

import bempd
import numpy as np
import pytest

SIDE, CRACK, STEP = 0.02, 0.0065, 0.001
#: G0 along x [J/m^2]: three linear parts.
PLACES, VALUES = [(0.0, 0.0), (0.008, 0.0), (0.012, 0.0), (0.02, 0.0)], [300.0, 300.0, 900.0, 600.0]


def g0(x):
    return np.interp(x, [place[0] for place in PLACES], VALUES)


def pulled_square(method, field=None, uniform=300.0):
    model = bempd.Model(options={"stepping.control": "path"}, log=None)
    acrylic = model.add_material(young_modulus=3e9, poisson_ratio=1 / 3, thickness=0.005, fracture_energy=uniform)
    square = bempd.rectangle(0, -SIDE / 2, SIDE, SIDE / 2)
    if method == "elements":
        region = model.add_bem_region(acrylic, square, element_length=0.002)
        model.options["crack.step"] = STEP
    else:
        region = model.add_pd_region(acrylic, square, spacing=STEP)
    if field is not None:
        model.set_toughness_at(region, *field)
    model.add_crack([(0, 0), (CRACK, 0)] if method == "elements" else [(0, STEP / 2), (CRACK, STEP / 2)])
    model.fix_edge(region, 1)
    model.prescribe_edge(region, 3, "y", 1e-6)
    return model


def grown(model, steps):
    while len(model.extensions()) < steps:
        model.step_to_next_event(1e6)
    return model.extensions()[:steps]


@pytest.mark.parametrize("method, tolerance", [("elements", 1e-9), ("lines", 2e-3)])
def test_the_load_of_growth_follows_the_root_of_g0_at_the_tip(method, tolerance):
    plain = grown(pulled_square(method), 6)
    graded = grown(pulled_square(method, (PLACES, VALUES)), 6)
    for same, other in zip(plain, graded):
        assert (other.x, other.y) == pytest.approx((same.x, same.y), abs=1e-9)
        expected = np.sqrt(g0(other.from_x) / 300)
        print(f"{method}: x {other.from_x:.4f}: {other.load_factor / same.load_factor:.6f}, root of G0 {expected:.6f}")
        assert other.load_factor / same.load_factor == pytest.approx(expected, rel=tolerance)
        assert other.resistance == pytest.approx(g0(other.from_x))
    assert np.sqrt(g0(graded[-1].from_x) / 300) > 1.3


RISING = ([(0, 0), (SIDE, 0)], [300.0, 900.0])


def test_new_area_of_elements_takes_the_integral_of_g0():
    model = pulled_square("elements", RISING)
    path = grown(model, 6)
    expected = 0.005 * sum(one.length * (300 + 600 * (one.from_x + one.x) / 2 / SIDE) for one in path)
    assert sum(one.surface_energy for one in path) == pytest.approx(expected, rel=1e-9)
    assert model.tips()[-1].critical_load_factor == pytest.approx(model.explain().load_factor, rel=1e-9)


def test_lines_release_as_much_as_elsewhere_of_g0_where_a_step_begins():
    shares = []
    for field, energy in ((None, lambda x: 300.0), (RISING, lambda x: 300 + 600 * x / SIDE)):
        model = pulled_square("lines", field)
        path = grown(model, 6)
        shares.append(sum(one.released_energy for one in path) / sum(one.length * 0.005 * energy(one.from_x) for one in path))
        assert all(one.surface_energy <= one.released_energy * (1 + 1e-12) for one in path)
        assert model.tips()[-1].critical_load_factor == pytest.approx(model.explain().load_factor, rel=1e-9)
    assert shares[1] == pytest.approx(shares[0], rel=0.01)


def stretched_plate(*halves, field=None):
    """A plate of one lattice or of two that act as one, bond by bond."""
    model = bempd.Model(options={"crack.rule": "bond"}, log=None)
    acrylic = model.add_material(young_modulus=3e9, poisson_ratio=1 / 3, thickness=0.005, fracture_energy=300)
    ends = np.linspace(0, SIDE, len(halves) + 1)
    for left, right, varied in zip(ends, ends[1:], halves):
        region = model.add_pd_region(acrylic, bempd.rectangle(left, 0, right, 0.01), spacing=STEP)
        if varied:
            model.set_toughness_at(region, *field)
        model.fix_edge(region, 1, "y")
        model.prescribe_edge(region, 3, "y", 1e-6)
    model.fix_point((0, 0))
    return model


def first_break(model):
    model.step_to_next_event(1e6)
    return model.load_factor


def test_bonds_have_the_mean_of_their_ends():
    """The plate is strained uniformly, so that the first bond breaks where G0 is least."""
    weak = ([(0, 0), (0.009, 0), (0.011, 0), (SIDE, 0)], [300.0, 75.0, 75.0, 300.0])
    plain, one, two = stretched_plate(False), stretched_plate(True, field=weak), stretched_plate(True, True, field=weak)
    half = stretched_plate(True, False, field=weak)
    load = first_break(plain)
    assert first_break(one) / load == pytest.approx(0.5, rel=1e-3)
    assert first_break(two) == pytest.approx(first_break(stretched_plate(True, field=weak)), rel=1e-9)
    assert 0.5 < first_break(half) / load < 0.8


def test_lattices_with_points_on_their_outline_take_them_too():
    loads = []
    for values in (None, [1200.0]):
        model = bempd.Model(options={"crack.rule": "bond"}, log=None)
        acrylic = model.add_material(young_modulus=3e9, poisson_ratio=1 / 3, thickness=0.005, fracture_energy=300)
        region = model.add_pd_region(acrylic, [(0, 0), (0.012, 0), (0.01, 0.01), (0, 0.01)], spacing=STEP)
        if values:
            model.set_toughness_at(region, [(0, 0)], values)
        model.fix_edge(region, 1)
        model.prescribe_edge(region, 3, "y", 1e-6)
        model.step_to_next_event(1e6)
        loads.append(model.load_factor)
    assert loads[1] / loads[0] == pytest.approx(2, rel=1e-9)


def test_misuse_is_told_in_words_of_python():
    model = pulled_square("lines")
    with pytest.raises(bempd.ArgumentError, match=r"set_toughness_at: values has the shape \(1,\); give 2 numbers"):
        model.set_toughness_at(1, [(0, 0), (1, 1)], [1.0])
    with pytest.raises(bempd.ArgumentError, match="set_toughness_at: region 4"):
        model.set_toughness_at(4, [(0, 0)], [1.0])
    with pytest.raises(bempd.ArgumentError, match="places has the shape"):
        model.set_toughness_at(1, [0, 1], [1.0, 2.0])
