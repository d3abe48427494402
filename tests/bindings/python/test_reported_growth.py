"""What tips tell of their growth against what the run does: load factor and direction, to rounding."""

from __future__ import annotations

import math

import numpy as np
import pytest

import bempd

LARGEST = float(np.finfo(float).max)
ANGLES = range(-90, 91, 15)
DRIVEN = range(-78, 79, 13)  # as many, none of them along the pull


def elements(angle: float, sign: float = 1, **options: str) -> bempd.Model:
    """A crack from the centre of a plate of boundary elements that is pulled where sign times load factor is > 0."""
    model = bempd.Model()
    for name, word in options.items():
        model.options[name.replace("__", ".")] = word
    glass = model.add_material(young_modulus=1, poisson_ratio=0.3, fracture_energy=1)
    plate = model.add_bem_region(glass, bempd.rectangle(-20, -20, 20, 20), 5)
    along = np.array([math.cos(math.radians(angle)), math.sin(math.radians(angle))])
    model.add_crack([-4 * along, 4.5 * along + [0.3, 0.2]])  # not symmetric: one of the two tips comes first
    model.fix_point((-20, -20))
    model.fix_point((20, -20), "y")
    model.add_traction(plate, 3, "y", sign)
    model.add_traction(plate, 1, "y", -sign)
    return model


@pytest.mark.parametrize("angle", ANGLES)
def test_elements_grow_where_their_tips_tell(angle: float) -> None:
    for criterion in ("hoop", "energy"):
        model = elements(angle, crack__criterion=criterion)
        model.step(1e-3)
        tips = model.tips()
        if abs(angle) == 90 and min(tip.critical_load_factor for tip in tips) > 100:
            continue  # along the pull nothing drives it
        first = min(tips, key=lambda tip: tip.critical_load_factor)
        growth = model.grow_cracks(0.5)
        extension = next(e for e in model.extensions() if e.end == first.end)
        assert growth.load_factor == first.critical_load_factor
        assert extension.angle == first.critical_kink_angle
        turned = math.atan2(first.direction_y, first.direction_x) + first.critical_kink_angle
        grown = next(tip for tip in model.tips() if tip.end == first.end)
        assert grown.x - first.x == pytest.approx(0.5 * math.cos(turned), abs=1e-12)
        assert grown.y - first.y == pytest.approx(0.5 * math.sin(turned), abs=1e-12)


@pytest.mark.parametrize("angle", DRIVEN)
@pytest.mark.parametrize("sign", [1, -1])
def test_steps_grow_elements_where_their_tips_tell(angle: float, sign: float) -> None:
    model = elements(angle, sign, stepping__control="path", contact="none")
    model.step(0)
    for _ in range(2):
        first = first_of(model, sign > 0)
        report = model.step_to_next_event(sign * 1e9)
        told = first.critical_load_factor if sign > 0 else first.critical_load_factor_down
        assert report.load_factor == pytest.approx(told, rel=1e-12)
        extension = model.extensions()[-1]
        assert (extension.crack, extension.end) == (first.crack, first.end)


@pytest.mark.parametrize("angle", ANGLES[2:-2])
def test_of_loads_that_are_turned_round_the_falling_load_factor_makes_them_grow(angle: float) -> None:
    pulled, pressed = elements(angle), elements(angle, -1)
    pulled.step(1e-3)
    pressed.step(-1e-3)
    for one, other in zip(pulled.tips(), pressed.tips(), strict=True):
        assert one.critical_load_factor == pytest.approx(-other.critical_load_factor_down, rel=1e-12)
        assert one.critical_load_factor < 0.97 * one.straight_load_factor or abs(angle) < 15


def test_of_growth_straight_on_both_load_factors_agree() -> None:
    model = bempd.Model()
    glass = model.add_material(young_modulus=1, poisson_ratio=0.3, fracture_energy=1)
    model.add_bem_region(glass, bempd.rectangle(-20, -20, 20, 20), 5)
    crack = model.add_crack([(-4, 0), (4, 0)])
    model.fix_point((-20, -20))
    model.fix_point((20, -20), "y")
    model.add_crack_traction(crack, "pressure", 1)
    model.step(1e-3)
    for tip in model.tips():
        assert tip.critical_load_factor == pytest.approx(tip.straight_load_factor, rel=1e-6)
        assert tip.critical_load_factor_down == -LARGEST


def lattice(angle: float, sign: float = 1, constant: float = 0, **properties: float) -> bempd.Model:
    """The same crack in a lattice; `properties` of its material, a fracture energy of 1 without."""
    model = bempd.Model()
    material = model.add_material(young_modulus=1, poisson_ratio=1 / 3, **(properties or {"fracture_energy": 1.0}))
    plate = model.add_pd_region(material, bempd.rectangle(-20, -20, 20, 20), 1.0, 3)
    along = np.array([math.cos(math.radians(angle)), math.sin(math.radians(angle))])
    model.add_crack([-7 * along + [0, 0.04], 7.4 * along + [0.3, 0.24]])
    model.fix_point((-20, -20))
    model.fix_point((20, -20), "y")
    model.add_traction(plate, 3, "y", sign, constant=constant)
    model.add_traction(plate, 1, "y", -sign, constant=-constant)
    return model


def first_of(model: bempd.Model, upwards: bool) -> bempd.reports.CrackTip:
    if upwards:
        return min(model.tips(), key=lambda tip: tip.critical_load_factor)
    return max(model.tips(), key=lambda tip: tip.critical_load_factor_down)


@pytest.mark.parametrize("sign, angle", [((-1) ** k, angle) for k, angle in enumerate(DRIVEN)])
def test_lines_grow_where_their_tips_tell(angle: float, sign: float) -> None:
    for constant in (0.0, 0.02):
        model = lattice(angle, sign, constant)
        model.options["stepping.control"] = "path"
        model.options["crack.rule"] = "tips"
        model.options["contact"] = "none"  # faces that close on the way change what tips carry
        model.step(0)
        for _ in range(3):
            first = first_of(model, sign > 0)
            report = model.step_to_next_event(sign * 1e9)
            told = first.critical_load_factor if sign > 0 else first.critical_load_factor_down
            assert report.load_factor == pytest.approx(told, rel=1e-12)
            grown = next(tip for tip in model.tips() if (tip.crack, tip.end) == (first.crack, first.end))
            assert grown.grown
            if sign < 0:
                continue
            turned = math.atan2(first.direction_y, first.direction_x) + first.critical_kink_angle
            step = model.extensions()[-1]
            # The cut of an initial crack ends up to 0.6 spacings from where its tip acts.
            assert math.hypot(step.from_x - first.x, step.from_y - first.y) < (0 if first.grown else 0.6) + 1e-9
            assert math.hypot(grown.x - step.from_x, grown.y - step.from_y) == pytest.approx(1)
            assert grown.x - step.from_x == pytest.approx(math.cos(turned), abs=1e-9)
            assert grown.y - step.from_y == pytest.approx(math.sin(turned), abs=1e-9)


def test_a_critical_stretch_is_a_toughness_too() -> None:
    model = lattice(30, critical_stretch=0.02)
    model.step(1e-3)
    told = first_of(model, True).critical_load_factor
    assert told < 1e9
    assert model.step_to_next_event(1e9).load_factor == pytest.approx(told, rel=1e-12)


def test_tips_of_lines_are_where_the_crack_has_come_to() -> None:
    model = lattice(45)
    for step in range(1, 13):
        model.step_to_next_event(1e9)
        for tip in model.tips():
            path = model.crack_path(tip.crack)
            vertex = path[0 if tip.end == bempd.TipEnd.START else -1]
            assert (tip.x, tip.y) == (vertex.x, vertex.y)
            assert not math.isnan(tip.stress_intensity_1)
            if not tip.contours:
                assert tip.method == bempd.TipMethod.STRESS
                assert math.isnan(tip.t_stress) and math.isnan(tip.error) and math.isnan(tip.felt_ahead)
        assert len(model.crack_path(1)) == 2 + step
        last = model.extensions()[-1]
        came_to = [(vertex.x, vertex.y) for vertex in model.crack_path(1) if vertex.event == step]
        assert came_to == [(last.x, last.y)] and last.state == bempd.TipState.GROWS
        assert math.hypot(last.x - last.from_x, last.y - last.from_y) == pytest.approx(last.length)
        assert last.resistance == pytest.approx(1) and not math.isnan(last.stress_intensity_1)


def test_a_crack_that_begins_has_tips_a_path_and_a_length() -> None:
    model = bempd.Model()
    material = model.add_material(young_modulus=1, poisson_ratio=1 / 3, fracture_energy=1.0)
    plate = model.add_pd_region(material, bempd.rectangle(-20, -20, 20, 20), 1.0, 3)
    model.add_circular_hole(plate, (0, 0), 6)
    model.fix_point((-20, -20))
    model.fix_point((20, -20), "y")
    model.add_traction(plate, 3, "y", 1)
    model.add_traction(plate, 1, "y", -1)
    model.options["stepping.control"] = "path"
    assert model.crack_count() == 0 and not model.tips()
    born = model.step_to_next_event(1e9)
    assert model.crack_count() == 1
    path = model.crack_path(1)
    assert [vertex.end for vertex in path] == [bempd.TipEnd.START, None, bempd.TipEnd.END]
    assert all(vertex.event == 1 and vertex.load_factor == born.load_factor for vertex in path)
    assert model.crack_length(1) == pytest.approx(1)
    for _ in range(4):
        tips = [(tip.crack, tip.end) for tip in model.tips()]
        assert tips and tips == sorted(tips)
        model.step_to_next_event(1e9)
    assert model.crack_count() >= 1
    assert model.crack_length() == pytest.approx(sum(model.crack_length(c + 1) for c in range(model.crack_count())))
    grown = [vertex for vertex in model.crack_path(1) if vertex.event > 1]
    if grown:
        assert all(vertex.energy_release_rate > 0 and vertex.resistance == pytest.approx(1, rel=0.05) for vertex in grown)


def test_openings_in_a_lattice_are_those_of_boundary_elements() -> None:
    half, openings = 10.0, {}
    fractions = np.array([0.1, 0.2, 0.35, 0.5])
    felt = 0.0
    for kind in ("lattice", "elements"):
        model = bempd.Model()
        material = model.add_material(young_modulus=1, poisson_ratio=1 / 3, fracture_energy=1.0)
        box = bempd.rectangle(-30.5, -30.5, 30.5, 30.5)
        lattice_here = kind == "lattice"
        plate = model.add_pd_region(material, box, 1.0, 3) if lattice_here else model.add_bem_region(material, box, 8)
        crack = model.add_crack([(-half - felt, 0), (half + felt, 0)])
        model.fix_point((-30.5, -30.5))
        model.fix_point((30.5, -30.5), "y")
        model.add_traction(plate, 3, "y", 1)
        model.add_traction(plate, 1, "y", -1)
        model.step(1e-3)
        places = (2 * half * fractions + felt) / (2 * half + 2 * felt)
        openings[kind] = model.crack_opening(crack, places)
        felt = model.tips()[0].felt_ahead
    ratio = openings["lattice"].normal / openings["elements"].normal
    print("opening over that of boundary elements", ratio)
    # The crack acts 0.06 spacings longer by its opening.
    assert np.all(np.abs(ratio - 1) < [2e-2, 9e-3, 7e-3, 7e-3])
    assert np.all(np.abs(openings["lattice"].tangential) < 1e-9 * openings["lattice"].normal)


def inclined(kind: str, sign: float, degrees: float) -> bempd.Model:
    """A crack in a plate that a rising load factor pulls (sign 1) or presses together."""
    model = bempd.Model(options={"stepping.control": "path", "crack.rule": "tips"})
    material = model.add_material(young_modulus=1, poisson_ratio=1 / 3, fracture_energy=1)
    box = bempd.rectangle(-20, -20, 20, 20)
    plate = model.add_bem_region(material, box, 5) if kind == "elements" else model.add_pd_region(material, box, 1, 3)
    along = np.array([math.cos(math.radians(degrees)), math.sin(math.radians(degrees))])
    model.add_crack([-7 * along + [0, 0.04], 7.4 * along + [0.3, 0.04]])
    model.fix_point((-20, -20))
    model.fix_point((20, -20), "y")
    model.add_traction(plate, 3, "y", sign)
    model.add_traction(plate, 1, "y", -sign)
    return model


@pytest.mark.parametrize("kind", ["elements", "lattice"])
@pytest.mark.parametrize("sign", [1, -1])
@pytest.mark.parametrize("degrees", [-55, 40])
def test_at_rest_tips_tell_their_growth_with_faces_as_they_will_be(kind: str, sign: float, degrees: float) -> None:
    """Under proportional loads faces open or close as soon as the load factor leaves zero. Of the two ways one was told with the
    faces of the other: a pressed crack in a lattice would grow at up to 1.6 times its load."""
    at_rest, looked_at = (inclined(kind, sign, degrees) for _ in range(2))
    at_rest.prepare()
    told = {upwards: first_of(at_rest, upwards) for upwards in (True, False)}
    for upwards in (True, False):
        model = inclined(kind, sign, degrees)
        way = 1 if upwards else -1
        report = model.step_to_next_event(way * 1e9)
        first = told[upwards]
        assert report.load_factor == pytest.approx(first.critical_load_factor if upwards else first.critical_load_factor_down, rel=1e-6)
        assert model.extensions()[-1].end == first.end
    looked_at.prepare()
    looked_at.tips()
    assert looked_at.step_to_next_event(1e9).load_factor == pytest.approx(first_of(at_rest, True).critical_load_factor, rel=1e-9)


@pytest.mark.parametrize("kind", ["elements", "lattice"])
def test_at_rest_a_crack_that_is_pressed_shut_never_grows(kind: str) -> None:
    for tip in inclined(kind, -1, 0.0).tips():
        assert tip.critical_load_factor > 1e6 and tip.critical_load_factor_down > -1e3
