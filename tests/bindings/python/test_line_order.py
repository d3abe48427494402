"""By which law a line grows, and which of several grows first: that of the region in which its tip lies, and by overload and
number, not by the order in which the host said things."""

from __future__ import annotations

import numpy as np
import pytest

import bempd

MATERIAL = {"young_modulus": 1, "poisson_ratio": 1 / 3}


def clamped_strip(toughening: float, **options: str) -> bempd.Model:
    """A long crack in a strip whose clamps move apart, where K does not depend on the crack's length; it runs from one lattice
    into another of as many times the fracture energy."""
    model = bempd.Model(options={name.replace("_", ".", 1): word for name, word in options.items()})
    first = model.add_material(**MATERIAL, fracture_energy=1)
    second = model.add_material(**MATERIAL, fracture_energy=toughening)
    for material, left, right in ((first, 0, 24), (second, 24, 56)):
        region = model.add_pd_region(material, bempd.rectangle(left, 0, right, 16), 1, 3)
        for edge, sign in ((1, -1.0), (3, 1.0)):
            model.prescribe_edge(region, edge, "y", sign)
            model.fix_edge(region, edge, "x")
    model.add_crack([(0, 8.3), (16, 8.3)])
    return model


@pytest.mark.parametrize("toughening", [4, 0.25])
@pytest.mark.parametrize("solver", ["plain", "window"])
def test_a_line_takes_the_toughness_of_the_region_that_it_has_come_to(toughening: float, solver: str) -> None:
    model = clamped_strip(toughening, crack_rule="tips", stepping_control="path", test_solver=solver)
    for _ in range(31):
        model.step_to_next_event(1e6)
    places = np.array([e.x for e in model.extensions()])
    loads = np.array([e.load_factor for e in model.extensions()])
    before, after = loads[(places > 18) & (places < 23)].mean(), loads[(places > 28) & (places < 46)].mean()
    print(f"load factor {before:.4f} before, {after:.4f} behind: ratio {after / before:.4f}, sqrt(G0) {toughening**0.5}")
    assert abs(after / before / toughening**0.5 - 1) < 0.05
    rates = [e.energy_release_rate_before for e in model.extensions() if e.x > 28]
    assert np.mean(rates) == pytest.approx(toughening, rel=0.1)


def two_cracks(order: tuple[int, int], constant: float, **options: str) -> tuple[bempd.Model, list[tuple[float, float]]]:
    """Edge cracks of 2.5 and 4.5 from opposite edges; with a constant part of the load both are overloaded at first."""
    model = bempd.Model(options={name.replace("_", ".", 1): word for name, word in options.items()})
    glass = model.add_material(**MATERIAL, critical_stretch=1e-3)
    body = model.add_pd_region(glass, bempd.rectangle(0, 0, 30, 20), 1, 3)
    cracks = ([(7.3, 0), (7.3, 2.5)], [(20.3, 20), (20.3, 15.5)])
    for k in order:
        model.add_crack(cracks[k])
    model.fix_edge(body, 4, "x")
    model.fix_point((0, 0), "y")
    model.add_traction(body, 2, "x", 1e-3, constant=constant)
    return model, [cracks[k][-1] for k in order]


@pytest.mark.parametrize("constant", [0, 1e-3])
def test_the_most_overloaded_tip_grows_first_whatever_the_order_in_which_cracks_were_added(constant: float) -> None:
    first = []
    for order in ((0, 1), (1, 0)):
        model, _ = two_cracks(order, constant)
        if constant == 0:
            model.options["stepping.control"] = "load"
        report = model.step_to_next_event(1e3)
        tip = model.extensions()[0]
        first.append((round(tip.x), report.load_factor, report.total_broken_bonds))
        assert report.ties == 0 and abs(tip.x - 20.3) < 2  # the long one
    assert first[0] == first[1]


def two_equal_cracks(order: tuple[int, int]) -> bempd.Model:
    model = bempd.Model()
    glass = model.add_material(**MATERIAL, critical_stretch=1e-3)
    body = model.add_pd_region(glass, bempd.rectangle(0, 0, 30, 20), 1, 3)
    cracks = ([(15.3, 0), (15.3, 5)], [(15.3, 20), (15.3, 15)])
    for k in order:
        model.add_crack(cracks[k])
    model.prescribe_edge(body, 4, "x", -1)
    model.prescribe_edge(body, 2, "x", 1)
    model.fix_point((0, 10), "y")
    return model


@pytest.mark.parametrize("order", [(0, 1), (1, 0)])
@pytest.mark.parametrize("solver", ["plain", "window"])
def test_of_equal_cracks_the_one_that_was_added_first_grows_and_the_tie_is_counted(order: tuple[int, int], solver: str) -> None:
    model = two_equal_cracks(order)
    model.options["test.solver"] = solver
    report = model.step_to_next_event(1e3)
    assert report.ties == 1
    assert model.extensions()[0].crack == 1
    assert (model.extensions()[0].y > 10) == (order[0] == 1)


@pytest.mark.parametrize("turns", range(4))
def test_of_two_ends_the_start_grows_first_however_the_body_is_turned(turns: int) -> None:
    """A centre crack in a square."""

    def place(x: float, y: float) -> tuple[float, float]:
        for _ in range(turns):
            x, y = -y, x
        return x, y

    model = bempd.Model()
    glass = model.add_material(**MATERIAL, critical_stretch=1e-3)
    corners = [place(*corner) for corner in ((-12, -12), (12, -12), (12, 12), (-12, 12))]
    body = model.add_pd_region(glass, corners, 1, 3)
    model.add_crack([place(-4.5, 0.5), place(4.5, 0.5)])
    component, sign = ("y", 1 if turns in (0, 3) else -1) if turns % 2 == 0 else ("x", 1)
    for edge, way in ((1, -1), (3, 1)):
        pulled = np.array(place(0, way))
        component = "x" if abs(pulled[0]) > 0.5 else "y"
        model.prescribe_edge(body, edge, component, float(pulled.sum()))
    model.fix_point(place(-12, 0), "y" if component == "x" else "x")
    report = model.step_to_next_event(1e3)
    assert report.ties == 1
    assert [e.end for e in model.extensions()] == [bempd.TipEnd.START]


def test_places_where_cracks_begin_tie_too() -> None:
    model = bempd.Model()
    glass = model.add_material(**MATERIAL, critical_stretch=1e-3)
    body = model.add_pd_region(glass, bempd.rectangle(-12, -12, 12, 12), 1, 3)
    model.add_hole(body, [(-4, -4), (-4, 4), (4, 4), (4, -4)])
    model.prescribe_edge(body, 4, "x", -1)
    model.prescribe_edge(body, 2, "x", 1)
    model.fix_point((0, -12), "y")
    report = model.step_to_next_event(1e3)
    assert report.ties >= 1 and model.extensions()[0].crack == 1


def test_the_energy_release_rate_may_say_when_a_line_grows() -> None:
    """Under shear G exceeds the square of the largest hoop stress, by 8 % before long; the way is the same."""
    found = {}
    for criterion in ("hoop", "energy"):
        model = bempd.Model(options={"crack.criterion": criterion})
        glass = model.add_material(**MATERIAL, fracture_energy=1)
        body = model.add_pd_region(glass, bempd.rectangle(0, 0, 40, 40), 1, 3)
        model.add_crack([(0, 10.3), (16, 22.3)])
        for edge, value in ((1, -1.0), (3, 1.0)):
            model.prescribe_edge(body, edge, "y", value)
            model.fix_edge(body, edge, "x")
        model.step_to_next_event(1e6)
        found[criterion] = model.extensions()[0]
    ratio = found["energy"].load_factor / found["hoop"].load_factor
    print(f"load factor by G over that by hoop stress {ratio:.4f}")
    assert 0.9 < ratio < 0.999
    assert found["energy"].angle == pytest.approx(found["hoop"].angle, abs=1e-12)
    assert found["energy"].energy_release_rate_before == pytest.approx(1, rel=1e-9)
