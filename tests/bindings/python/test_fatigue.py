"""Growth by cycles: lives against closed forms and integrations, laws, blocks, callbacks."""

from __future__ import annotations

import csv
import pathlib
import sys
import warnings
from typing import Any

import numpy as np
import pytest

import bempd

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "benchmarks" / "fatigue"))
import lives  # noqa: E402


def plate(half_length: float = 0.05, *, width: float = 1.0, height: float = 3.0, **rate: float) -> bempd.Model:
    """A plate 2 * width with a crack in its centre, pulled by 1 MPa; da/dN = 1e-11 dK^3 in MPa m^(1/2) and m."""
    model = bempd.Model(log=None)
    steel = model.add_material(young_modulus=210e9, poisson_ratio=0.3)
    region = model.add_bem_region(steel, bempd.rectangle(-width, -height, width, height), element_length=0.25 * width)
    model.add_crack([(-half_length, 0), (half_length, 0)])
    model.fix_point((-width, -height))
    model.fix_point((width, -height), "y")
    model.add_traction(region, 3, "y", 1e6)
    model.add_traction(region, 1, "y", -1e6)
    model.set_growth_rate(steel, **{"coefficient": 1e-11, "exponent": 3.0, "unit_intensity": 1e6, **rate})
    return model


def test_wide_plate_has_the_life_of_the_closed_form() -> None:
    life = plate(0.01, width=8.0, height=8.0).grow_fatigue(most_length=0.1)
    exact = (0.01**-0.5 - 0.05**-0.5) / (0.5 * 1e-11 * np.pi**1.5)
    print(f"cycles {life.cycles:.6g}, closed form {exact:.6g}, relative difference {life.cycles / exact - 1:.1e}")
    assert life.cycles == pytest.approx(exact, rel=1e-3)


def test_the_error_counts_all_steps_and_is_not_known_after_one() -> None:
    assert np.isnan(plate(0.01).grow_fatigue(most_length=0.1, most_steps=1).error)
    lives = [plate(0.01).grow_fatigue(most_length=0.1, tolerance=tolerance) for tolerance in (1e-2, 1e-3, 1e-5)]
    for life in lives[:2]:
        assert abs(life.cycles / lives[2].cycles - 1) < life.error < 1e-2


def test_walker_and_sustained_rates_follow_from_the_range() -> None:
    amplitude = plate(0.01).grow_fatigue(most_length=0.1)
    walker = plate(0.01, walker=0.5).grow_fatigue(1.0, 0.5, most_length=0.1)
    assert walker.cycles == pytest.approx(amplitude.cycles / (0.5 * 0.5**-0.5) ** 3, rel=1e-4)
    model = plate(0.01)
    model.set_growth_rate(1, "sustained", coefficient=1e-11, exponent=3, unit_intensity=1e6)
    assert model.grow_fatigue(1.0, 1.0, most_length=0.1).cycles == pytest.approx(amplitude.cycles, rel=1e-4)


def test_order_of_blocks_matters_as_in_an_integration_cycle_by_cycle() -> None:
    blocks = {"high": np.array([1.0, 0.5]), "low": np.array([0.0, 0.1]), "cycles": np.array([3e6, 4e7])}
    lengths = []
    for order in ([0, 1], [1, 0]):
        model = plate(0.01, width=8.0, height=8.0, coefficient=1e-10)
        life = model.grow_fatigue(blocks["high"][order] * 10, blocks["low"][order] * 10, blocks["cycles"][order],
                                  most_cycles=1e7)
        lengths.append(model.crack_length(1) / 2)
        # a^(1 - m/2) is linear in the cycles of a block.
        a, left = 0.01, 1e7
        for high, low, cycles in zip(*(blocks[name][order] for name in ("high", "low", "cycles"))):
            n = min(left, cycles)
            a, left = (a**-0.5 - 0.5 * 1e-10 * n * (10 * (high - low)) ** 3 * np.pi**1.5) ** -2, left - n
        print(f"half length {lengths[-1]:.6f}, closed form {a:.6f}")
        assert lengths[-1] - 0.01 == pytest.approx(a - 0.01, rel=2e-3)
        assert life.stop_reason == bempd.FatigueStop.CYCLES
    assert abs(lengths[0] - lengths[1]) > 0.01 * lengths[0]


def test_life_tells_of_lengths_inspections_and_writes_its_table(tmp_path: pathlib.Path) -> None:
    life = plate(critical_intensity=0.8).grow_fatigue()
    assert life.stop_reason == bempd.FatigueStop.CRITICAL and life.crack == 1
    assert life.cycles_at(0.1) == 0 and np.isnan(life.cycles_at(0.09))
    half = life.cycles_at(0.2)
    assert 0 < half < life.cycles
    assert life.cycles_at(life.table["length"][-1]) == pytest.approx(life.cycles)
    assert life.inspection_interval(0.2, inspections=3) == pytest.approx((life.cycles - half) / 3)
    with pytest.raises(bempd.ArgumentError, match="never"):
        life.inspection_interval(5.0)
    with pytest.raises(bempd.ArgumentError, match="crack 7"):
        life.tip(7)
    tip = life.tip(1, bempd.TipEnd.START)
    assert np.all(np.diff(tip["cycles"]) > 0) and tip["rate"] == pytest.approx(1e-11 * (tip["range"] / 1e6) ** 3)
    life.write_csv(tmp_path / "life.csv")
    with open(tmp_path / "life.csv", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == len(life.table) and float(rows[-1]["cycles"]) == life.table["cycles"][-1]


def test_curves_are_drawn() -> None:
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    life = plate().grow_fatigue(most_length=0.2)
    growth, rates = life.plot()
    steps = np.unique(life.table["step"])
    assert len(growth.lines) == 1 and len(growth.lines[0].get_xdata()) == len(steps)
    assert growth.lines[0].get_ydata()[-1] == pytest.approx(0.2)
    assert len(rates.lines) == 2 and rates.get_xscale() == rates.get_yscale() == "log"
    assert rates.lines[0].get_ydata() == pytest.approx(1e-11 * (rates.lines[0].get_xdata() / 1e6) ** 3)


def test_laws_of_the_user_may_fail() -> None:
    calls = []

    def rate(crack: int, end: int, highest: float, ratio: float, first: float, second: float, t_stress: float,
             length: float, x: float, y: float) -> float:
        calls.append(length)
        if len(calls) > 50:
            raise RuntimeError("no data")
        return 1e-11

    model = plate()
    model.set_growth_rate(1, rate)
    with pytest.raises(RuntimeError, match="no data"):
        model.grow_fatigue(most_length=0.2)
    assert model.crack_length(1) == pytest.approx(0.1) and len(model.extensions()) == 0
    with pytest.raises(bempd.ArgumentError, match="law is 'pariss'"):
        model.set_growth_rate(1, "pariss")
    with pytest.raises(bempd.ArgumentError, match="R = low / high"):
        model.grow_fatigue(1.0, 2.0)


def test_resistances_of_the_user_may_fail() -> None:
    def pulled(resistance: Any) -> bempd.Model:
        model = bempd.Model(log=None)
        glass = model.add_material(young_modulus=1.0, poisson_ratio=0.3, fracture_energy=1.0)
        region = model.add_bem_region(glass, bempd.rectangle(-1, -1, 1, 1), element_length=0.25)
        model.add_crack([(-0.3, 0), (0.3, 0)])
        model.fix_edge(region, 1)
        model.prescribe_edge(region, 3, "y", 1.0)
        model.set_resistance_function(glass, resistance)
        return model

    def failing(*_: Any) -> float:
        raise RuntimeError("no data")

    model = pulled(failing)
    with pytest.raises(RuntimeError, match="no data"):
        model.step_to_next_event(1e9)
    assert model.crack_length(1) == pytest.approx(0.6) and len(model.extensions()) == 0
    loads = []
    for factor in (1.0, 4.0):
        model = pulled(lambda *_, factor=factor: factor)
        model.step_to_next_event(1e9)
        loads.append(model.load_factor)
    assert loads[1] == pytest.approx(2 * loads[0], rel=1e-9)


def test_a_spectrum_of_load_cases_has_the_closed_form() -> None:
    found, exact = lives.two_load_cases()
    print(f"cycles {found:.6g}, closed form {exact:.6g}, {found / exact - 1:+.1e}")
    assert found == pytest.approx(exact, rel=1e-3)
    model = plate()
    with pytest.raises(bempd.ArgumentError, match="load case 1 does not exist"):
        model.grow_fatigue({1: 1.0}, {1: 0.0})
    pull = model.add_load_case([1, 2])
    with pytest.raises(bempd.ArgumentError, match="both be load factors"):
        model.grow_fatigue({pull: 1.0}, 0.0)
    with pytest.raises(bempd.ArgumentError, match="must be a finite number"):
        model.grow_fatigue({pull: float("nan")}, {pull: 0.0})


@pytest.mark.parametrize("kind", ["middle crack", "edge crack"])
def test_net_sections_end_the_growth(kind: str) -> None:
    found, exact = lives.net_section(kind)
    print(f"{kind}: ends at {found:.5f}, closed form {exact:.5f}")
    assert found == pytest.approx(exact, rel=5e-3)


def test_tips_grow_by_lengths() -> None:
    model = plate()
    growth = model.extend_cracks({(1, bempd.TipEnd.START): 0.01, (1, bempd.TipEnd.END): 0.02})
    assert growth.tips == 2 and growth.length == pytest.approx(0.03)
    assert [round(vertex.x, 6) for vertex in model.crack_path(1)] == [-0.06, -0.05, 0.05, 0.07]


def lattice_strip(**settings: Any) -> bempd.Model:
    model = bempd.Model(log=None, **settings)
    acrylic = model.add_material(young_modulus=3e9, poisson_ratio=1 / 3, fracture_energy=1e6)
    region = model.add_pd_region(acrylic, bempd.rectangle(0, -0.5, 1, 0.5), spacing=1 / 40)
    model.add_crack([(0, 0), (0.3, 0)])
    model.fix_edge(region, 1)
    model.prescribe_edge(region, 3, "y", 1e-4)
    model.prescribe_edge(region, 3, "x", 0)
    model.set_growth_rate(acrylic, coefficient=1e-11, exponent=3, unit_intensity=1e6, critical_intensity=1e6)
    return model


@pytest.mark.parametrize("scene", ["edge crack", "two edge cracks"])
def test_a_line_in_a_lattice_has_the_life_of_boundary_elements(scene: str) -> None:
    found, elements = lives.square_life(scene, 60), lives.square_life(scene)
    print(f"{scene}: {found:.4g}, elements {elements:.4g}, {100 * (found / elements - 1):+.2f} %")
    assert found == pytest.approx(elements, rel=0.03)


def test_growth_in_a_lattice_is_taken_back_by_an_exception_and_goes_on() -> None:
    class EnoughError(Exception):
        pass

    calls: list[int] = []

    def progress(load_factor: float, events: int, broken: int) -> None:
        calls.append(events)
        if len(calls) == 2:
            raise EnoughError

    cancelled = lattice_strip()
    cancelled.step(1.0)
    before = cancelled.crack_length(1)
    cancelled.progress = progress
    with pytest.raises(EnoughError):
        cancelled.grow_fatigue(most_length=0.5)
    assert cancelled.crack_length(1) == before and cancelled.load_factor == 1.0 and len(calls) == 2
    model = lattice_strip()
    half = model.grow_fatigue(most_length=0.4)
    rest = model.grow_fatigue(first_cycle=half.cycles, most_length=0.5)
    whole = lattice_strip().grow_fatigue(most_length=0.5)
    assert rest.cycles_at(0.5) == pytest.approx(whole.cycles_at(0.5), rel=5e-3)


def test_what_a_lattice_does_not_take_is_refused() -> None:
    model = bempd.Model(options={"crack.rule": "bond"}, log=None)
    acrylic = model.add_material(young_modulus=3e9, poisson_ratio=1 / 3, fracture_energy=300)
    region = model.add_pd_region(acrylic, bempd.rectangle(0, 0, 1, 1), spacing=0.05)
    model.add_crack([(0, 0.5), (0.3, 0.5)])
    model.fix_edge(region, 1)
    model.set_growth_rate(acrylic, coefficient=1e-11, exponent=3)
    with pytest.raises(bempd.ArgumentError, match="do not grow as lines"):
        model.grow_fatigue()


def test_faces_in_a_lattice_close_at_the_low_load() -> None:
    """Reversed loads press the crack together: R = 0, and the life is that of pulsating loads."""
    pulsating, reversed_ = (lattice_strip().grow_fatigue(1.0, low, most_length=0.4) for low in (0.0, -1.0))
    assert np.abs(reversed_.table["ratio"]).max() < 0.01
    assert reversed_.cycles_at(0.4) == pytest.approx(pulsating.cycles_at(0.4), rel=0.01)
    model = lattice_strip(options={"contact": "none"})
    assert model.grow_fatigue(1.0, -1.0, most_steps=1).table["ratio"][0] == pytest.approx(-1, abs=0.01)


@pytest.mark.parametrize("kind", ["wheeler", "willenborg"])
@pytest.mark.parametrize("program", ["an overload in each 5000 cycles", "one overload"])
def test_retardation_is_that_of_an_integration_cycle_by_cycle(kind: str, program: str) -> None:
    growth, exact = lives.retarded(kind, program)
    unretarded = lives.retarded(kind, "none")[0]
    print(f"{kind}, {program}: {growth:.6g}, integration {exact:.6g}, {growth / exact - 1:+.1e}")
    assert growth == pytest.approx(exact, rel=1e-3)
    if program == "one overload":
        assert growth < 0.8 * unretarded


def test_one_call_has_the_life_and_the_interval_of_inspections() -> None:
    life = plate(0.01).grow_fatigue(most_length=0.1, detectable=0.04, inspections=3)
    assert life.interval == pytest.approx((life.cycles - life.cycles_at(0.04)) / 3)
    assert np.isnan(plate(0.01).grow_fatigue(most_length=0.1).interval)
    with pytest.raises(bempd.ArgumentError, match="inspections is 0"):
        plate(0.01).grow_fatigue(most_length=0.1, detectable=0.04, inspections=0)
    model = plate(0.01)
    for refused, told in ((5, "length 5 when growth ends at 0.1"), (-1, "a length > 0"), (float("nan"), "a length > 0")):
        with pytest.raises(bempd.ArgumentError, match=told):
            model.grow_fatigue(most_length=0.1, detectable=refused)
    with pytest.raises(bempd.ArgumentError, match="inspections is 0.5"):
        model.grow_fatigue(most_length=0.1, detectable=0.04, inspections=0.5)
    assert model.crack_length(1) == pytest.approx(0.02)  # nothing has grown
    with pytest.warns(UserWarning, match="never has the length 0.01 here"):
        life = model.grow_fatigue(most_length=0.1, detectable=0.01)
    assert life.cycles > 0 and np.isnan(life.interval)


@pytest.mark.parametrize("spacings", [4, 12])
def test_a_crack_of_a_few_spacings_has_a_warning(spacings: int) -> None:
    model = bempd.Model()
    acrylic = model.add_material(young_modulus=3e9, poisson_ratio=1 / 3, fracture_energy=300)
    square = model.add_pd_region(acrylic, bempd.rectangle(0, 0, 1, 1), spacing=1 / 40)
    model.add_crack([(0.5 - spacings / 80, 0.4875), (0.5 + spacings / 80, 0.4875)])
    model.fix_edge(square, 1)
    model.add_traction(square, 3, "y", 1e4)
    model.set_growth_rate(acrylic, coefficient=1e-11, exponent=3)
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        model.grow_fatigue(most_steps=1)
    assert [str(one.message).startswith("crack 1 is 4 spacings") for one in told] == ([True] if spacings == 4 else [])


@pytest.mark.parametrize("spacings, short", [(2, 0.39), (6, 0.10)])
def test_lives_of_a_few_spacings_are_as_short_as_the_warning_says(spacings: int, short: float) -> None:
    found = []
    for in_lattice in (True, False):
        model = bempd.Model(log=None)
        acrylic = model.add_material(young_modulus=3e9, poisson_ratio=1 / 3, fracture_energy=1e6)
        square = bempd.rectangle(0, -0.5, 1, 0.5)
        region = (model.add_pd_region(acrylic, square, spacing=1 / 40) if in_lattice else
                  model.add_bem_region(acrylic, square, element_length=1 / 16))
        model.add_crack([(0.5 - spacings / 80, 1 / 80), (0.5 + spacings / 80, 1 / 80)])
        model.fix_point((1, -0.5))
        model.fix_point((1, 0.5), "x")
        model.add_traction(region, 3, "y", 1e6)
        model.add_traction(region, 1, "y", -1e6)
        model.set_growth_rate(acrylic, coefficient=1e-11, exponent=3, unit_intensity=1e6)
        found.append(model.grow_fatigue(most_length=0.5).cycles)
    print(f"{spacings} spacings: {found[0] / found[1] - 1:+.1%} from elements")
    assert 1 - found[0] / found[1] == pytest.approx(short, abs=0.02)


def test_a_crack_that_does_not_grow_has_its_length_from_the_beginning() -> None:
    model = plate(0.01)
    model.set_growth_rate(1, coefficient=1e-11, exponent=3, unit_intensity=1e6, threshold=1e3)
    life = model.grow_fatigue(most_cycles=100)
    assert life.cycles_at(0.02) == 0
    assert np.isnan(life.cycles_at(0.03))


@pytest.mark.parametrize("given, told", [({"high": [1, 0.8, 0.6], "low": [0, 0.1], "cycles": 5}, "high 3, low 2, cycles 1"),
                                         ({"high": [1, 0.8], "cycles": [1, 2, 3]}, "high 2, low 1, cycles 3"),
                                         ({"most_cycles": 0}, "most_cycles is 0"), ({"most_length": -1}, "most_length is -1")])
def test_blocks_that_differ_in_number_and_limits_of_zero_are_refused(given: dict[str, Any], told: str) -> None:
    model = plate(0.01)
    with pytest.raises(bempd.ArgumentError, match=told):
        model.grow_fatigue(**given)
    assert model.crack_length(1) == pytest.approx(0.02)
