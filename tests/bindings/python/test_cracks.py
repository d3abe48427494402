"""Cracks in boundary element regions, seen from Python."""

import math

import bempd
import numpy as np
import pytest


def cracked_plate(points, **material):
    """A plate 2 x 6 around the origin pulled by 1, with its crack."""
    model = bempd.Model()
    glass = model.add_material(young_modulus=1, poisson_ratio=0.3, **material)
    plate = model.add_bem_region(glass, bempd.rectangle(-1, -3, 1, 3), element_length=0.25)
    crack = model.add_crack(points)
    model.fix_point((-1, -3))
    model.fix_point((1, -3), "y")
    model.add_traction(plate, 3, "y", 1)
    model.add_traction(plate, 1, "y", -1)
    return model, crack


def test_tips_of_a_centre_crack():
    model, crack = cracked_plate([(-0.5, 0), (0.5, 0)], fracture_energy=1)
    for number in bempd.TipEnd:
        model.set_tip_frozen(crack, number)
    model.step(2)
    start, end = model.tips()
    assert (start.crack, start.end, end.end) == (crack, bempd.TipEnd.START, bempd.TipEnd.END)
    assert (end.x, end.y, end.direction_x, end.direction_y) == pytest.approx((0.5, 0, 1, 0))
    factor = 1.1867 * math.sqrt(0.5 * math.pi)
    assert end.stress_intensity_1 == pytest.approx(2 * factor, rel=1e-4)
    assert abs(end.stress_intensity_2) < 1e-4
    assert end.energy_release_rate == pytest.approx((2 * factor) ** 2, rel=2e-4)
    assert end.critical_load_factor == pytest.approx(1 / factor, rel=1e-4)
    assert 0 < end.error < 1e-3 * factor
    assert abs(end.kink_angle) < 1e-3
    assert end.t_stress == pytest.approx(-2.514, rel=2e-3)


def test_opening_along_a_crack():
    model, crack = cracked_plate([(-1, 0), (0, 0)])
    model.step(1)
    opening = model.crack_opening(crack, np.linspace(0, 1, 11))
    assert opening.normal.shape == (11,)
    assert (np.diff(opening.normal) < 0).all() and opening.normal[-1] == pytest.approx(0, abs=1e-12)
    assert np.abs(opening.tangential).max() < 1e-6 * opening.normal[0]
    assert model.crack_opening(crack, 0.5).normal == pytest.approx(opening.normal[5:6])


def test_loads_on_faces_take_new_values():
    model, crack = cracked_plate([(-0.01, 0), (0.01, 0)])
    load = model.add_crack_traction(crack, "pressure", constant=3)
    model.add_crack_traction(crack, "shear", constant=[2, 2])
    assert model.tips()[1].stress_intensity_1 == pytest.approx(3 * math.sqrt(math.pi * 0.01), rel=3e-4)
    assert model.tips()[1].stress_intensity_2 == pytest.approx(2 * math.sqrt(math.pi * 0.01), rel=3e-4)
    model.set_load_values(load, constant=1)
    assert model.tips()[1].stress_intensity_1 == pytest.approx(math.sqrt(math.pi * 0.01), rel=3e-4)


def test_misuse():
    model, crack = cracked_plate([(-0.5, 0), (0.5, 0)])
    with pytest.raises(bempd.ArgumentError, match="pressure"):
        model.add_crack_traction(crack, "x", 1)
    with pytest.raises(bempd.ArgumentError, match="crack 2"):
        model.add_crack_traction(2, "shear", 1)
    with pytest.raises(bempd.ArgumentError, match="fraction"):
        model.crack_opening(crack, [1.5])
    with pytest.raises(bempd.ArgumentError, match="shape"):
        model.crack_opening(crack, [[0.5]])
    with pytest.raises(bempd.ArgumentError, match="infinite"):
        model.evaluate([(0.5, 0)])


def test_cracks_grow_straight_on_at_their_fracture_energy():
    model, crack = cracked_plate([(-0.3, 0), (0.3, 0)], fracture_energy=2)
    model.options["crack.tie_share"] = 0.01
    first = model.tips()[0].critical_load_factor
    growth = model.grow_cracks(0.05)
    assert (growth.tips, growth.ended) == (2, 0)
    assert growth.load_factor == pytest.approx(first, rel=1e-6)
    assert model.load_factor == growth.load_factor
    assert model.tips()[1].x == pytest.approx(0.35) and abs(model.tips()[1].y) < 1e-4
    assert model.grow_cracks(0.05).load_factor < first


def lattice_plate():
    """A square of 41 spacings with a crack of 20 in its middle."""
    model = bempd.Model()
    glass = model.add_material(young_modulus=1, poisson_ratio=1 / 3, fracture_energy=1)
    plate = model.add_pd_region(glass, bempd.rectangle(-20.5, -20.5, 20.5, 20.5), spacing=1, horizon_ratio=3)
    model.add_crack([(-10, 0), (10, 0)])
    model.fix_point((-20.5, -20.5))
    model.fix_point((20.5, -20.5), "y")
    model.add_traction(plate, 3, "y", 1)
    model.add_traction(plate, 1, "y", -1)
    return model


def test_tips_in_a_lattice():
    model = lattice_plate()
    model.step(0.01)
    start, end = model.tips()
    assert (end.method, end.contours, end.grown, end.branched) == (bempd.TipMethod.CONTOURS, 3, False, False)
    assert abs(end.felt_ahead) < 0.15 and 8 < end.contour_radius <= 20
    assert end.stress_intensity_1 == pytest.approx(start.stress_intensity_1, rel=1e-9)
    elements, _ = cracked_plate([(-0.5, 0), (0.5, 0)])
    assert elements.tips()[0].method == bempd.TipMethod.ELEMENTS


def test_recorded_tips(tmp_path):
    model = lattice_plate()
    assert model.tip_history() == []
    model.options["tips.record"] = 2
    model.step(0.01)
    for _ in range(4):
        model.step_to_next_event(10)
    records = model.tip_history()
    assert [record.event for record in records] == [0, 0, 2, 2, 4, 4]
    assert records[-1].tip == model.tips()[1]
    assert records[-1].load_factor == model.load_factor and records[-1].total_broken_bonds > 2
    model.write_tips(tmp_path / "tips.csv")
    table = bempd.read_history(tmp_path / "tips.csv")
    assert table["stress_intensity_1"] == pytest.approx([record.tip.stress_intensity_1 for record in records], rel=1e-15)
    assert table["crack"].tolist() == [1] * 6 and table["end"].tolist() == [1, 2] * 3
    model.write_snapshot(tmp_path / "shot")
    assert (tmp_path / "shot_0000_tips.vtu").exists() and (tmp_path / "shot_0000_cracks.vtu").exists()


def test_growth_by_lengths_is_recorded():
    model, _ = cracked_plate([(-0.3, 0), (0.3, 0)], fracture_energy=2)
    model.options["crack.tie_share"] = 0.01
    model.options["tips.record"] = 1
    for _ in range(3):
        model.grow_cracks(0.05)
    ends = [record.tip for record in model.tip_history() if record.tip.end == bempd.TipEnd.END]
    assert [tip.x for tip in ends] == pytest.approx([0.35, 0.4, 0.45])
    assert ends[2].stress_intensity_1 > 0


def test_history_goes_on_while_cracks_grow():
    model, crack = cracked_plate([(-0.3, 0), (0.3, 0)], fracture_energy=2)
    model.set_tip_frozen(crack, bempd.TipEnd.START)
    assert model.extensions() == []
    growth = [model.grow_cracks(0.05) for _ in range(3)]
    assert [g.tips for g in growth] == [1, 1, 1]
    extensions = model.extensions()
    assert [e.event for e in extensions] == [1, 2, 3] == [e.count for e in extensions]
    assert all(e.end is bempd.TipEnd.END and e.ended is False and e.crack == crack for e in extensions)
    assert extensions[-1].x == pytest.approx(0.45) and extensions[-1].crack_length == pytest.approx(0.75)
    assert model.history()["released_energy"][-1] == pytest.approx(sum(g.released_energy for g in growth))
    assert sum(e.released_energy for e in extensions) == pytest.approx(sum(g.released_energy for g in growth), rel=1e-2)
    model.set_tip_frozen(crack, bempd.TipEnd.START, False)
    assert model.grow_cracks(0.05).tips == 1


def test_a_state_brings_shorter_cracks_back():
    model, crack = cracked_plate([(-0.3, 0), (0.3, 0)], fracture_energy=2)
    model.options["crack.tie_share"] = 0.01
    model.grow_cracks(0.05)
    state = model.save()
    model.grow_cracks(0.05)
    assert len(model.extensions()) == 4
    model.restore(state)
    assert len(model.extensions()) == 2 and model.tips()[1].x == pytest.approx(0.35)


def test_misuse_of_growth():
    model, crack = cracked_plate([(-0.3, 0), (0.3, 0)], fracture_energy=2)
    with pytest.raises(bempd.ArgumentError, match="crack 2"):
        model.set_tip_frozen(2, bempd.TipEnd.END)
    with pytest.raises(bempd.ArgumentError, match="end is 3"):
        model.set_tip_frozen(crack, 3)
    with pytest.raises(bempd.ArgumentError, match="crack.criterion"):
        model.options["crack.criterion"] = "strain"


def test_faces_of_crossing_cracks_meet_where_the_load_turns_round():
    # All gaps pass zero at one load factor, at which as many places close as are open.
    model = bempd.Model()
    steel = model.add_material(young_modulus=2e11, poisson_ratio=1 / 3, plane="strain")
    plate = model.add_bem_region(steel, bempd.rectangle(0, 0, 6, 10), 1.5)
    model.add_crack([(3.4247986250787656, 6.232911910303123), (2.438611830628353, 7.7544249397797875),
                     (4.399748154549009, 3.971060738089508)])
    model.add_crack([(4.030846176863626, 3.8961101029586604), (3.932056775058208, 6.288360650134045)])
    model.add_crack([(6, 2.3729463246317586), (3.39707878719296, 1.9261199432182754)])
    support = model.fix_edge(plate, 4)
    model.add_pressure(plate, 2, -2e8)
    report = model.run_program([0.3, 0.5, 1.2], [0.5, -0.2, 0.8])
    assert report.energy_balance_error < 1e-9 and report.residual < 1e-9
    assert abs(model.reaction(support)[0] + 0.8 * 2e8 * 10) < 1e-9 * 2e9


def test_a_support_that_ends_at_the_mouth_of_a_crack_holds_one_of_its_lips():
    def energy(part):
        model = bempd.Model()
        glass = model.add_material(young_modulus=1, poisson_ratio=0.3)
        plate = model.add_bem_region(glass, bempd.rectangle(0, 0, 4, 2), element_length=0.25)
        model.add_crack([(2, 0), (2, 0.6)])
        model.fix_edge(plate, 3)
        model.prescribe_edge(plate, 1, "y", -0.01, part=part)
        return model.step(1).stored_energy

    assert energy((0, 0.5)) == pytest.approx(energy((0, 0.499)), rel=1e-3)
    assert energy((0.5, 1)) == pytest.approx(energy((0, 0.5)), rel=1e-6)
