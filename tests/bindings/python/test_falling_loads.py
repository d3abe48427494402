"""Cracks that grow as lines while the load factor falls: what they do under loads of the other sign while it rises."""

from __future__ import annotations

import pathlib
import random
import sys

import numpy as np
import pytest

import bempd

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "differential"))
import properties  # noqa: E402
import random_scenes  # noqa: E402

MIRRORED = ("load_factor", "critical_load_factor")
COLUMNS = ("total_broken_bonds", "stored_energy", "released_energy", "work", "stretch_ratio", *MIRRORED)


def strip(sign: float, **options: str) -> bempd.Model:
    """README's, whose end is moved by `sign` micrometres per unit of load factor."""
    model = bempd.Model(options={name.replace("_", ".", 1): word for name, word in options.items()})
    acrylic = model.add_material(young_modulus=3e9, poisson_ratio=1 / 3, thickness=0.005, fracture_energy=300)
    left = model.add_bem_region(acrylic, bempd.rectangle(0, 0, 0.02, 0.02), element_length=0.005)
    model.add_pd_region(acrylic, bempd.rectangle(0.02, 0, 0.04, 0.02), spacing=0.001, horizon_ratio=4)
    right = model.add_bem_region(acrylic, bempd.rectangle(0.04, 0, 0.06, 0.02), element_length=0.005)
    model.add_crack([(0.0295, 0), (0.0295, 0.0045)])
    model.fix_edge(left, 4)
    model.prescribe_edge(right, 2, "x", sign * 1e-6)
    return model


def plate(sign: float, constant: float, crack: bool, **options: str) -> bempd.Model:
    """Constant tractions along its right edge and proportional ones across it, with a hole where there is no crack."""
    model = bempd.Model(options={name.replace("_", ".", 1): word for name, word in options.items()})
    glass = model.add_material(young_modulus=1, poisson_ratio=1 / 3, critical_stretch=1e-3)
    body = model.add_pd_region(glass, bempd.rectangle(0, 0, 24, 17), 1, 3)
    if crack:
        model.add_crack([(11.4, 13.5), (14.4, 8.2)])
    else:
        model.add_circular_hole(body, (12, 8.3), 3)
    model.fix_edge(body, 4, "x")
    model.fix_point((0, 0), "y")
    model.add_traction(body, 2, "y", 0, constant=constant)
    model.add_traction(body, 2, "x", sign * 1e-3)
    return model


def followed(model: bempd.Model, targets: list[float]) -> np.ndarray:
    for target in targets:
        for _ in range(12):
            if model.step_to_next_event(target).stop_reason != bempd.StopReason.EVENT:
                break
    return model.history()


def expect_mirrored(up: np.ndarray, down: np.ndarray) -> None:
    assert len(up) == len(down)
    for name in COLUMNS:
        sign = -1 if name in MIRRORED else 1
        assert np.array_equal(up[name], sign * down[name]), name


def test_a_strip_pulled_by_a_falling_load_factor_separates_where_it_does_by_a_rising_one() -> None:
    up, down = strip(1).run_to_separation(1e4), strip(-1).run_to_separation(-1e4)
    print("load factors at separation", up.load_factor, down.load_factor)
    assert up.stop_reason == down.stop_reason == bempd.StopReason.SEPARATED
    assert abs(down.load_factor + up.load_factor) < 1e-9 * up.load_factor
    assert down.total_broken_bonds == up.total_broken_bonds and down.total_events == up.total_events


@pytest.mark.parametrize("control", ["load", "path"])
def test_with_loads_and_load_factors_negated_all_events_are_the_same(control: str) -> None:
    up, down = (strip(sign, test_solver="plain", stepping_control=control) for sign in (1, -1))
    expect_mirrored(followed(up, [1e4]), followed(down, [-1e4]))


@pytest.mark.parametrize("crack", [True, False])
@pytest.mark.parametrize("constant", [0, 3e-5])
@pytest.mark.parametrize("control", ["load", "path"])
def test_constant_loads_and_loads_that_reverse(crack: bool, constant: float, control: str) -> None:
    up, down = (plate(sign, constant, crack, test_solver="plain", stepping_control=control) for sign in (1, -1))
    targets = [0.2, -1.0, 50.0]
    a, b = followed(up, targets), followed(down, [-t for t in targets])
    assert a["total_broken_bonds"][-1] > 0 and a["load_factor"].min() < 0 < a["load_factor"].max()
    expect_mirrored(a, b)


@pytest.mark.parametrize("crack", [True, False])
def test_what_has_not_grown_on_the_way_up_grows_on_the_way_down(crack: bool) -> None:
    """Pressed first, and pulled while the load factor falls: as pulled at once."""
    pulled = plate(1, 0, crack).step_to_next_event(1e3)
    model = plate(-1, 0, crack)
    assert model.step(0.1 * pulled.load_factor).total_events == 0
    found = model.step_to_next_event(-1e3)
    assert abs(found.load_factor + pulled.load_factor) < 1e-9 * pulled.load_factor
    assert found.total_broken_bonds == pulled.total_broken_bonds


def test_a_tip_that_is_overloaded_goes_on_wherever_the_load_factor_goes() -> None:
    model = plate(1, 0, True)
    first = model.step_to_next_event(1e3)
    back = model.step_to_next_event(-1e3)
    assert back.stop_reason == bempd.StopReason.EVENT and back.load_factor == first.load_factor


def built(recorder: properties.Recorder, sign: int, control: str) -> bempd.Model:
    """The recorded scene with as many times its proportional loads."""
    model = bempd.Model(options={**recorder.options, "test.solver": "plain", "stepping.control": control})
    for name, values, named in recorder.calls:
        place = {"prescribe_edge": 3, "add_traction": 3, "add_point_force": 2}.get(name)
        getattr(model, name)(*[sign * value if k == place else value for k, value in enumerate(values)], **named)
    return model


def all_ways(model: bempd.Model, sign: int) -> list[tuple[float, ...] | str]:
    """Up, to zero and down, some events each; load factors as those of the loads that are not negated."""
    found: list[tuple[float, ...] | str] = []
    try:
        for target in (1e9, 0.0, -1e9):
            for _ in range(8):
                report = model.step_to_next_event(sign * target)
                found.append((sign * report.load_factor + 0.0, report.total_broken_bonds, report.stored_energy,
                              report.released_energy, report.stop_reason, report.ties))
                if report.stop_reason != bempd.StopReason.EVENT:
                    break
    except bempd.Error as failed:
        found.append(type(failed).__name__)
    return found


def test_random_scenes_with_loads_and_load_factors_negated_go_the_same_way_to_the_last_digit() -> None:
    random_scenes.LINES = True
    events = 0
    for seed in range(1, 31):
        recorder, _ = properties.record(seed)
        control = ("load", "path")[seed % 2]
        up, down = (all_ways(built(recorder, sign, control), sign) for sign in (1, -1))
        assert up == down, f"scene {seed}"
        events += len(up)
    assert events > 150


def up_and_down(seed: int, solver: str) -> list[tuple[float, int, float]]:
    """Load factor, bonds and energy of a random scene whose load falls, to below zero in most, and rises again."""
    random_scenes.LINES = True
    model, _, _ = random_scenes.build(seed, solver)
    choose = random.Random(7 * seed + 1)
    found = []

    def add(report: bempd.StepReport) -> bempd.StepReport:
        found.append((report.load_factor, report.total_broken_bonds, report.stored_energy))
        return report

    for _ in range(2):
        for _ in range(choose.randrange(1, 6)):
            report = add(model.step_to_next_event(1e9))
            if report.stop_reason != bempd.StopReason.EVENT:
                return found
        reached = report.load_factor
        add(model.step(choose.choice((0.5, 0.0, -0.3, -1.0)) * reached))
        if choose.random() < 0.5:
            add(model.step(0.5 * reached))
    for _ in range(6):
        if add(model.step_to_next_event(1e9)).stop_reason != bempd.StopReason.EVENT:
            break
    return found


# Bonds that were critical while the load factor fell broke as it rose again, and windows broke others than whole bodies
# did.
@pytest.mark.parametrize("seed", [40, 150, 446, 705, 894, 1030, 1150])
def test_after_the_load_fell_windows_break_the_bonds_of_the_whole_body(seed: int) -> None:
    plain, window = up_and_down(seed, "plain"), up_and_down(seed, "window")
    assert [bonds for _, bonds, _ in plain] == [bonds for _, bonds, _ in window]
    for (f, _, energy), (g, _, other) in zip(plain, window):
        assert f == pytest.approx(g, rel=1e-7, abs=1e-9 * max(abs(p[0]) for p in plain))
        assert energy == pytest.approx(other, abs=1e-6 * max(p[2] for p in plain))


@pytest.mark.parametrize("crack", [True, False])
@pytest.mark.parametrize("through", [0.0, -0.05])
def test_a_load_that_goes_through_zero_and_back_without_a_break_leaves_the_same_state(crack: bool, through: float) -> None:
    model = plate(1, 0, crack, contact="faces")
    for _ in range(3):
        reached = model.step_to_next_event(1e3).load_factor
    there = model.step(0.3 * reached)
    for _ in range(2):
        model.step(through * reached)
        back = model.step(0.3 * reached)
        assert back.total_broken_bonds == there.total_broken_bonds
        assert back.stored_energy == pytest.approx(there.stored_energy, rel=1e-9)
        assert back.closed_places == there.closed_places
