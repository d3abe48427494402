"""What a torn body consists of."""

import bempd
import numpy as np
import pytest
from bempd import rectangle
from conftest import make_strip


def test_a_torn_strip_is_in_pieces(strip):
    model = strip.model
    assert model.piece_count == 1 and model.are_connected(strip.held, strip.pulled)
    report = model.run_to_separation(1e4)
    assert report.separated and report.resistance < 0.02 * report.peak_resistance
    assert model.options["stepping.separation_share"] == 0.02
    assert report.hanging == model.are_connected(strip.held, strip.pulled)


def test_loads_and_supports_know_their_pieces():
    model = bempd.Model()
    stone = model.add_material(young_modulus=1e9, poisson_ratio=1 / 3)
    block = model.add_pd_region(stone, rectangle(0, 0, 8, 4), spacing=1, horizon_ratio=2)
    model.add_crack([(4.5, 0), (4.5, 4)])
    left, turned = model.fix_edge(block, 4), model.prescribe_edge(block, 2, "x", constant=[0.01, 0.05])
    load, both = model.add_point_force((8, 2), "y", 0), model.add_traction(block, 1, "y", 0)
    assert (model.support_piece(left), model.support_piece(turned), model.load_piece(load)) == (1, 2, 2)
    assert model.load_piece(both) == 0
    assert model.piece_count == 2 and not model.are_connected(left, turned)
    pieces, places = model.node_pieces(block), model.field(block, "position")
    np.testing.assert_array_equal(pieces, np.where(places[:, 0] < 4.5, 1, 2))
    piece = model.piece(2)
    assert (piece.nodes, piece.loads, piece.free_motions) == (20, 2, 1)
    assert piece.rotation == pytest.approx(-0.01) and piece.move_x == pytest.approx(0.03)
    assert piece.deviation < 1e-12
    with pytest.raises(bempd.ArgumentError, match="piece 3"):
        model.piece(3)


def test_a_host_that_gives_its_own_values_learns_of_the_end():
    host = make_strip()
    for step in range(1, 400):
        host.model.set_support_values(host.pulled, constant=1e-6 * step)
        report = host.model.step_to_values(step, until="separated")
        if report.separated:
            break
    assert report.stop_reason is bempd.StopReason.SEPARATED
    expected = make_strip().model.run_to_separation(1e4)
    assert report.load_factor == pytest.approx(expected.load_factor, rel=1e-9)
    assert report.total_broken_bonds == expected.total_broken_bonds
