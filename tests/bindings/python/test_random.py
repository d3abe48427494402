"""Random fields, Weibull strengths and random cracks: their statistics, the same for a seed, and what is refused."""

import math

import bempd
import numpy as np
import pytest
from bempd._random import distance

BOX = (0.0, 0.0, 0.2, 0.1)


def test_a_seed_gives_the_same_with_any_numpy():
    places, values = bempd.random_field(7, BOX, 0.02)
    again = bempd.random_field(7, BOX, 0.02)[1]
    assert np.array_equal(values, again) and not np.array_equal(values, bempd.random_field(8, BOX, 0.02)[1])
    assert places[0].tolist() == [0, 0] and places[-1] == pytest.approx([0.2, 0.1])
    assert values[:2] == pytest.approx([-0.9121386641106454, -1.6466852928939815], rel=1e-12)


def test_a_field_is_normal_with_its_correlation():
    length, lag = 0.02, 4  # of the grid: one correlation length
    fields = []
    for seed in range(40):
        places, values = bempd.random_field(seed, BOX, length)
        columns = len(np.unique(places[:, 0].round(9)))
        fields.append(values.reshape(-1, columns))
    every = np.array(fields)
    assert every.mean() == pytest.approx(0, abs=0.06) and every.std() == pytest.approx(1, abs=0.03)
    for shifted, whole in ((every[:, :, lag:], every[:, :, :-lag]), (every[:, lag:, :], every[:, :-lag, :])):
        assert (shifted * whole).mean() == pytest.approx(math.exp(-1), abs=0.04)


def test_the_weakest_place_follows_the_volume_whatever_the_grid():
    """A body of the volume V has the mean strength (volume / V)^(1/m) Gamma(1 + 1/m)."""
    for side, step in ((0.1, 0.01), (0.2, 0.01), (0.1, 0.04)):
        least = [bempd.weibull_field(seed, (0, 0, side, side), step, modulus=4, strength=3e6, volume=1e-6, thickness=0.004)[1].min()
                 for seed in range(500)]
        assert np.mean(least) == pytest.approx(3e6 * (1e-6 / (side**2 * 0.004)) ** (1 / 4) * math.gamma(1.25), rel=0.03)


def test_cracks_lie_apart_inside_the_box():
    cracks = bempd.random_cracks(3, BOX, count=20, length=(0.004, 0.03), exponent=3, apart=0.002)
    assert len(cracks) == 20 and cracks == bempd.random_cracks(3, BOX, count=20, length=(0.004, 0.03), exponent=3, apart=0.002)
    for number, crack in enumerate(cracks):
        assert 0.004 <= math.dist(*crack) <= 0.03
        assert all(0.002 <= x <= 0.198 and 0.002 <= y <= 0.098 for x, y in crack)
        assert all(distance(crack, other) >= 0.002 for other in cracks[:number])


def test_lengths_follow_their_power_and_numbers_their_density():
    lengths = [math.dist(*crack) for seed in range(60) for crack in bempd.random_cracks(seed, (0, 0, 1, 1), count=10, length=(0.01, 0.1), exponent=3)]
    longer = (0.02**-2 - 0.1**-2) / (0.01**-2 - 0.1**-2)
    assert np.mean(np.array(lengths) > 0.02) == pytest.approx(longer, abs=0.06)
    counts = [len(bempd.random_cracks(seed, (0, 0, 1, 1), density=8, length=0.01)) for seed in range(200)]
    assert np.mean(counts) == pytest.approx(8, abs=0.7) and np.var(counts) == pytest.approx(8, abs=2.5)


@pytest.mark.parametrize("call, message", [
    (lambda: bempd.random_field(-1, BOX, 0.02), "seed is -1"),
    (lambda: bempd.random_field(1.0, BOX, 0.02), "seed is 1.0"),
    (lambda: bempd.random_field(1, (0, 0, 0, 1), 0.02), "give .left, bottom, right, top."),
    (lambda: bempd.random_field(1, BOX, 0), "correlation_length is 0"),
    (lambda: bempd.random_field(1, BOX, 1e-6), "give a larger spacing"),
    (lambda: bempd.weibull_field(1, BOX, 0.02, modulus=math.nan), "modulus is nan"),
    (lambda: bempd.random_cracks(1, BOX, count=3, density=2, length=0.01), "either count or density"),
    (lambda: bempd.random_cracks(1, BOX, count=3, length=1), "fit into the box"),
    (lambda: bempd.random_cracks(1, BOX, count=500, length=0.05), "no room is left after"),
])
def test_misuse_is_told(call, message):
    with pytest.raises(bempd.ArgumentError, match=message):
        call()
