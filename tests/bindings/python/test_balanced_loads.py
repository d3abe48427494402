"""Plates under dead loads that balance each other, held at points that only stop rigid motions: what tears them in two
ends the run, before the half that is held is torn off its points."""

import bempd
import pytest
from bempd import rectangle

WIDTH, HEIGHT, SPACING = 0.06, 0.02, 0.001


def plate(points, rule="line", kind="lattice", bent=False):
    model = bempd.Model()
    model.options["crack.rule"] = rule
    acrylic = model.add_material(young_modulus=3e9, poisson_ratio=1 / 3, thickness=0.005, fracture_energy=300)
    if kind == "lattice":
        left = right = model.add_pd_region(acrylic, rectangle(0, 0, WIDTH, HEIGHT), spacing=SPACING, horizon_ratio=3)
    else:
        left = model.add_bem_region(acrylic, rectangle(0, 0, WIDTH / 3, HEIGHT), element_length=0.005)
        model.add_pd_region(acrylic, rectangle(WIDTH / 3, 0, 2 * WIDTH / 3, HEIGHT), spacing=SPACING, horizon_ratio=3)
        right = model.add_bem_region(acrylic, rectangle(2 * WIDTH / 3, 0, WIDTH, HEIGHT), element_length=0.005)
    middle = WIDTH / 2 - SPACING / 4
    model.add_crack([(middle, 0), (middle, HEIGHT / 4)])
    # A traction that goes from one value to another along its edge; both edges go round the body.
    bend = [1, -1] if bent else [1, 1]
    for edge, region, pull in ((4, left, [-1e4 * one for one in reversed(bend)]), (2, right, [1e4 * one for one in bend])):
        model.add_traction(region, edge, "x", pull)
    for place, components in points:
        for component in components:
            model.fix_point(place, component)
    return model


LEFT = [((0, HEIGHT / 2), "xy"), ((0, 0), "x")]
CORNERS = [((0, 0), "xy"), ((WIDTH, 0), "y")]
NEAR = [((0, 0), "xy"), ((0.01, 0), "y")]
# Load factor, and force [N]; bonds; energy that they take [J], and its relative error. As with points in both halves, which lose
# their loads. A crack of boundary elements grows at 505.5. The energy of lines is the fracture energy of the new area.
TORN = {"line": (501.8, 225, 300 * 0.005 * 0.75 * HEIGHT, 0.025), "bond": (567.6, 215, 0.03268, 0.01)}


@pytest.mark.parametrize("rule", ["line", "bond"])
@pytest.mark.parametrize("kind", ["lattice", "mixed"])
@pytest.mark.parametrize("points", [LEFT, CORNERS, NEAR], ids=["left edge", "two corners", "near each other"])
def test_a_plate_that_is_torn_in_two_is_separated(points, kind, rule):
    report = plate(points, rule, kind).run_to_separation(1e6)
    load_factor, bonds, energy, error = TORN[rule]
    assert report.stop_reason is bempd.StopReason.SEPARATED
    assert report.load_factor == pytest.approx(load_factor, rel=2e-3)
    assert report.peak_resistance == pytest.approx(load_factor, rel=2e-3)
    assert report.total_broken_bonds == bonds
    assert report.bond_energy == pytest.approx(energy, rel=error) and report.released_energy < 1.45 * energy  # dead loads tear it
    assert report.energy_balance_error < 1e-9


def test_what_is_borne_after_the_tear_is_no_peak():
    model = plate(LEFT)
    torn = model.run_to_separation(1e6)
    report = model.step(3 * torn.load_factor)
    assert report.separated and report.total_broken_bonds > torn.total_broken_bonds
    assert report.peak_resistance == torn.peak_resistance


def test_moments_that_balance_each_other():
    """Each end is bent by a couple, of which no force is left."""
    report = plate(LEFT, bent=True).run_to_separation(1e6)
    assert report.stop_reason is bempd.StopReason.SEPARATED and report.fragments == 1
    assert report.released_energy < 0.1


def test_a_spall_does_not_end_the_run():
    """Forces tear a corner off a plate, which goes on to bear the pull at its edges: 7 % is left for the points."""
    model = bempd.Model()
    stone = model.add_material(young_modulus=3e9, poisson_ratio=1 / 3, thickness=0.005, fracture_energy=300)
    block = model.add_pd_region(stone, rectangle(0, 0, 0.02, 0.02), spacing=0.001, horizon_ratio=3)
    for edge, pull in ((4, -1e4), (2, 1e4)):
        model.add_traction(block, edge, "x", pull)
    for place, force in (((0.02, 0), -0.15), ((0.02, 0.02), 0.075), ((0, 0.02), 0.075)):
        model.add_point_force(place, "y", force)
    points = [model.fix_point(place, component) for place, component in
              (((0.01, 0.01), "x"), ((0.01, 0.01), "y"), ((0.01, 0.005), "x"))]
    for _ in range(100):
        report = model.step_to_next_event(1e6)
        if report.fragments or report.separated:
            break
    assert report.fragments == 1 and not report.separated
    held = sum(abs(model.reaction(point)[1]) for point in points)
    assert 0.05 * report.resistance < held < 0.1 * report.resistance
    assert model.run_to_separation(1e6).stop_reason is bempd.StopReason.SEPARATED
