"""Growth by cycles in bodies with lattices: beside elements, across borders, under load cases."""

from __future__ import annotations

import pathlib
import sys

import numpy as np
import pytest

import bempd

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "benchmarks" / "fatigue"))
import lives  # noqa: E402


def test_two_lattices_have_the_life_of_elements() -> None:
    """One half of elements beside one of a lattice, also with a crack across the border: claims.fatigue."""
    scene = "a crack in each half"
    found, exact = (lives.life_in_halves(kind, kind, scene) for kind in ("lattice", "elements"))
    print(f"{scene}: {[f'{100 * (one / other - 1):+.2f} %' for one, other in zip(found, exact)]}")
    assert found == pytest.approx(exact, rel=0.03)


def both(cracks: list[list[tuple[float, float]]], left: str = "elements") -> tuple[bempd.Model, list[int]]:
    return lives.halves(left, "lattice", cracks, spacings=30)


TWO = lives.HALVES["a crack in each half"][0]
BLOCKS = ([1.0, 0.7], [0.0, 0.3], [2e8, 5e8])


def test_a_run_with_both_kinds_goes_on_in_the_middle_of_a_block_also_from_a_state() -> None:
    whole, parts = both(TWO)[0], both(TWO)[0]
    whole.grow_fatigue(*BLOCKS, most_cycles=9e9)
    half = parts.grow_fatigue(*BLOCKS, most_cycles=4.3e9)
    state = parts.save()
    between = [parts.crack_length(crack) for crack in (1, 2)]
    lengths = []
    for _ in range(2):
        rest = parts.grow_fatigue(*BLOCKS, first_cycle=half.cycles, most_cycles=9e9)
        assert rest.stop_reason == bempd.FatigueStop.CYCLES and rest.cycles == 9e9
        lengths.append([parts.crack_length(crack) for crack in (1, 2)])
        parts.restore(state)
        assert [parts.crack_length(crack) for crack in (1, 2)] == between
    assert lengths[0] == lengths[1]
    grown = [whole.crack_length(crack) for crack in (1, 2)]
    assert grown[0] > between[0] + 0.02 and grown[1] > 0.25 + 0.5 / 30
    assert lengths[0][0] == pytest.approx(grown[0], abs=0.01 * grown[0])
    assert lengths[0][1] == pytest.approx(grown[1], abs=1.01 / 30)  # by whole spacings


def test_a_cancelled_run_with_both_kinds_is_taken_back_and_a_stopped_one_goes_on() -> None:
    class EnoughError(Exception):
        pass

    model, _ = both(TWO)
    model.step(0.5)
    reactions = model.tips()[0].stress_intensity_1
    calls: list[int] = []

    def progress(load_factor: float, events: int, broken: int) -> None:
        calls.append(events)
        if len(calls) == 3:
            raise EnoughError

    model.progress = progress
    with pytest.raises(EnoughError):
        model.grow_fatigue(most_length=0.5)
    assert [model.crack_length(crack) for crack in (1, 2)] == pytest.approx([0.3, 0.25])
    assert model.load_factor == 0.5 and len(model.extensions()) == 0 and len(calls) == 3
    assert model.tips()[0].stress_intensity_1 == pytest.approx(reactions, rel=1e-9)
    model.progress = lambda *_: model.request_stop()
    stopped = model.grow_fatigue(most_length=0.5)
    assert stopped.stop_reason == bempd.FatigueStop.REQUESTED and stopped.steps == 1
    model.progress = None
    on = model.grow_fatigue(first_cycle=stopped.cycles, most_length=0.45)
    assert on.stop_reason == bempd.FatigueStop.LENGTH and on.cycles > stopped.cycles
    text = model.explain().text
    assert "limits the life" in text and "times the growth of the next tip" in text


def test_a_line_that_comes_to_another_material_stops() -> None:
    model = bempd.Model(log=None)
    acrylic, steel = (model.add_material(young_modulus=modulus, poisson_ratio=1 / 3, fracture_energy=1e6) for modulus in (3e9, 2e11))
    left = model.add_pd_region(acrylic, bempd.rectangle(-0.5, -0.5, 0, 0.5), spacing=1 / 30)
    right = model.add_bem_region(steel, bempd.rectangle(0, -0.5, 0.5, 0.5), element_length=1 / 8)
    model.add_crack([(-0.5, 0.005), (-0.2, 0.005)])
    for region in (left, right):
        model.fix_edge(region, 1)
        model.prescribe_edge(region, 3, "y", 1e-4)
    for material in (acrylic, steel):
        model.set_growth_rate(material, coefficient=1e-11, exponent=3, unit_intensity=1e6, critical_intensity=1e6)
    life = model.grow_fatigue()
    assert life.stop_reason == bempd.FatigueStop.TIP_STOPPED and life.crack == 1
    assert model.crack_path(1)[-1].x == pytest.approx(0, abs=1.5 / 30)


def test_lines_grow_under_load_cases() -> None:
    found, exact = (lives.life_under_cases(spacings).cycles_at(0.45) for spacings in (40, 0))
    print(f"cycles {found:.6g}, elements {exact:.6g}, {100 * (found / exact - 1):+.2f} %")
    assert found == pytest.approx(exact, rel=0.03)


def test_lines_turn_by_the_combination_that_opens_them_most() -> None:
    angles = []
    for spacings in (60, 0):
        life = lives.life_under_cases(spacings, shear=0.4)
        tip = life.tip(1, bempd.TipEnd.END)
        angles.append(np.arctan2(tip["y"][-1] - tip["y"][0], tip["x"][-1] - tip["x"][0]))
    print(f"directions of growth [rad]: {angles[0]:.3f} in the lattice, {angles[1]:.3f} in elements")
    assert angles[1] < -0.5 and angles[0] == pytest.approx(angles[1], abs=0.06)


def test_a_case_that_presses_lines_together_has_no_share() -> None:
    """Pull and push with the crack closed by the push: R = 0, as in a run by load factors."""
    lives_found = []
    for low in (0.0, -1.0):
        model, (left, right) = both([[(0.7, 0.005), (1, 0.005)]], left="lattice")
        pull = model.add_load_case([left, right])
        lives_found.append(model.grow_fatigue({pull: 1.0}, {pull: low}, most_length=0.4))
    assert np.abs(lives_found[1].table["ratio"]).max() < 0.01
    assert lives_found[1].cycles_at(0.4) == pytest.approx(lives_found[0].cycles_at(0.4), rel=0.01)


def test_many_short_calls_let_a_line_grow_as_much_as_one() -> None:
    whole, parts = (lives.halves("lattice", "lattice", TWO, spacings=20)[0] for _ in range(2))
    whole.grow_fatigue(most_cycles=8e9)
    for k in range(8):
        parts.grow_fatigue(first_cycle=k * 1e9, most_cycles=(k + 1) * 1e9)
        if k == 3:
            parts.restore(bempd.State.from_bytes(parts.save().to_bytes()))
    lengths = [[model.crack_length(crack) for crack in (1, 2)] for model in (whole, parts)]
    print(f"lengths by one call {lengths[0]}, by eight {lengths[1]}")
    assert lengths[0][0] > 0.3 + 1.5 / 20
    assert lengths[1] == pytest.approx(lengths[0], abs=1.01 / 20)  # by whole spacings


def test_faces_close_at_the_low_load_also_behind_the_border() -> None:
    """A crack that goes on from elements into the lattice within a step has R = 0 under reversed loads from there on, too."""
    lives_of = []
    for low in (0.0, -1.0):
        model = both([[(-1, 0.005), (-0.2, 0.005)]])[0]
        life = model.grow_fatigue(1.0, low, most_length=1.1)
        assert life.table["x"][0] < 0 < life.table["x"][-1]
        assert np.abs(life.table["ratio"]).max() < 0.03
        lives_of.append(life.cycles_at(1.1))
    assert lives_of[1] == pytest.approx(lives_of[0], rel=0.01)


FLOW_STRESS = 1.8e6  # over the pull of 1 MPa


def yielding(kind: str, spacings: int = 0, horizon_ratio: int = 4) -> tuple[float, float]:
    """Cycles and length of a middle crack in a square of side 1 at which its net section yields: `plate`, `body` or `patch`."""
    model = bempd.Model(log=None)
    acrylic = model.add_material(young_modulus=3e9, poisson_ratio=1 / 3, fracture_energy=1e6)
    square = bempd.rectangle(0, -0.5, 1, 0.5)
    region = (model.add_pd_region(acrylic, square, spacing=1 / spacings, horizon_ratio=horizon_ratio) if spacings else
              model.add_bem_region(acrylic, square, element_length=1 / 8) if kind == "plate" else model.add_body(acrylic, square))
    y = 0.5 / spacings if spacings else 0.005
    crack = model.add_crack([(0.345, y), (0.655, y)])
    if kind == "patch":
        model.set_crack_treatment(crack, "lattice")
    model.fix_point((0, -0.5))
    model.fix_point((1, -0.5), "y")
    model.add_traction(region, 3, "y", 1e6)
    model.add_traction(region, 1, "y", -1e6)
    model.set_growth_rate(acrylic, coefficient=1e-11, exponent=3, unit_intensity=1e6, critical_intensity=1e6, flow_stress=FLOW_STRESS)
    life = model.grow_fatigue()
    assert life.stop_reason == bempd.FatigueStop.NET_SECTION
    return life.cycles, float(life.table["length"][-1])


@pytest.mark.parametrize("kind, spacings, horizon_ratio", [("plate", 40, 4), ("plate", 80, 4), ("plate", 80, 6), ("plate", 80, 3), ("body", 0, 4), ("patch", 0, 4)])
def test_net_sections_with_lines_yield_as_those_with_elements(kind: str, spacings: int, horizon_ratio: int) -> None:
    """Lattices spread the stress at tips over two horizons, and a patch ends before the body does: neither counts."""
    found, other, limit = yielding(kind, spacings, horizon_ratio), yielding("plate"), 1 - 1e6 / FLOW_STRESS
    print(f"{kind}, {spacings} spacings: life {found[0] / other[0] - 1:+.2%} from elements, length {found[1] / limit - 1:+.2%} from limit analysis")
    assert found[0] == pytest.approx(other[0], rel=0.02)
    assert found[1] == pytest.approx(limit, rel=0.01)
