"""Growth by cycles that is divided into many calls: what the cracks have grown by does not depend on it."""

from __future__ import annotations

import math

import pytest

import bempd

HIGH, LOW, CYCLES = [1.0, 0.8, 0.6], [0.1, 0.2, 0.0], [1e8, 3e8, 5e8]


def wide_plate(*cracks: tuple[float, float]) -> bempd.Model:
    """A plate of 16 x 16 with cracks on the x axis, by their middles and half lengths, under 1 MPa."""
    model = bempd.Model(log=None)
    steel = model.add_material(young_modulus=210e9, poisson_ratio=0.3)
    region = model.add_bem_region(steel, bempd.rectangle(-8, -8, 8, 8), element_length=2)
    for middle, half in cracks:
        model.add_crack([(middle - half, 0), (middle + half, 0)])
    model.fix_point((-8, -8))
    model.fix_point((8, -8), "y")
    model.add_traction(region, 3, "y", 1e6)
    model.add_traction(region, 1, "y", -1e6)
    model.set_growth_rate(steel, coefficient=1e-11, exponent=3, unit_intensity=1e6)
    return model


def grown(half: float, cycles: float, share: float = 1.0) -> float:
    """Half the length of a crack in a wide plate after cycles, K = pull sqrt(pi a); the closed form for the exponent 3."""
    return float((half**-0.5 - 0.5e-11 * math.pi**1.5 * share * cycles) ** -2)


def test_a_slow_crack_grows_beside_a_fast_one_also_in_many_calls() -> None:
    """In each call its growth is too little for an extension, and waits for the next one, also in a state."""
    cycles, calls = 1.5e10, 12
    exact = grown(0.0008, cycles)
    parts, saved = (wide_plate((0, 0.01), (2, 0.0008)) for _ in range(2))
    for k in range(calls):
        for model in (parts, saved):
            model.grow_fatigue(first_cycle=cycles * k / calls, most_cycles=cycles * (k + 1) / calls)
        state = saved.save()
        saved = wide_plate((0, 0.01), (2, 0.0008))
        saved.set_growth_rate(1, coefficient=1e-11, exponent=3, unit_intensity=1e6)
        saved.restore(state)
    assert exact > 1.015 * 0.0008
    for model in (parts, saved):
        print(f"half length {model.crack_length(2) / 2:.6g}, closed form {exact:.6g}")
        # What is less than 0.005 of its length, or 0.05 of the other crack's growth, may still wait.
        assert model.crack_length(2) / 2 == pytest.approx(exact, abs=0.006 * 0.0008)
        assert model.crack_length(1) / 2 == pytest.approx(grown(0.01, cycles), rel=1e-3)


def test_blocks_that_are_cut_into_calls_keep_their_tips() -> None:
    """The last steps of a call are as short as places that count as one; the tips are there for the next call."""
    calls, cycles = 7, 321645555290.4
    model = wide_plate((0, 0.01))
    for k in range(calls):
        life = model.grow_fatigue(HIGH, LOW, CYCLES, first_cycle=cycles * k / calls, most_cycles=cycles * (k + 1) / calls)
        assert life.stop_reason == bempd.FatigueStop.CYCLES
        assert len(model.tips()) == 2 and len(life.table) == 2 * (life.steps + 1)
    mean = sum(n * (high - low) ** 3 for high, low, n in zip(HIGH, LOW, CYCLES)) / sum(CYCLES)
    exact = grown(0.01, cycles, mean)
    print(f"half length {model.crack_length(1) / 2:.6g}, by the mean rate {exact:.6g}")
    assert model.crack_length(1) / 2 - 0.01 == pytest.approx(exact - 0.01, rel=2e-3)


@pytest.mark.parametrize("length", [1e-6, 1e-8, 1e-9, 1e-10])
def test_extensions_of_no_length_to_speak_of_leave_the_tips(length: float) -> None:
    model = wide_plate((0, 0.01))
    model.step(1)
    before = [tip.stress_intensity_1 for tip in model.tips()]
    for _ in range(3):
        model.extend_cracks({(1, end): length for end in bempd.TipEnd})
    assert [tip.stress_intensity_1 for tip in model.tips()] == pytest.approx(before, rel=1e-3)
    assert model.extensions()[-1].released_energy >= 0


def test_a_crack_with_short_pieces_at_its_end_has_both_tips() -> None:
    model = wide_plate()
    model.add_crack([(-0.01, 0), (0.01, 0), (0.01 + 1e-9, 0), (0.01 + 2e-9, 0)])
    model.step(1)
    assert [tip.stress_intensity_1 for tip in model.tips()] == pytest.approx([1e6 * math.sqrt(math.pi * 0.01)] * 2, rel=1e-3)
