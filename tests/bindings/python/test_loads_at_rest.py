"""Load programs and steps that rest where nothing acts, and what programs report of faces."""

import bempd
import pytest
from bempd import rectangle


def block(kind, law, **options):
    """A block held on its left, with a dead load or a moved edge on its right; a lattice has an edge crack."""
    model = bempd.Model(**options)
    acrylic = model.add_material(young_modulus=3e9, poisson_ratio=1 / 3, fracture_energy=300)
    outline = rectangle(0, 0, 0.02, 0.01)
    if kind == "lattice":
        body = model.add_pd_region(acrylic, outline, spacing=0.001, horizon_ratio=3)
        model.add_crack([(0.0105, 0), (0.0105, 0.0031)])
    else:
        body = model.add_bem_region(acrylic, outline, element_length=0.0025)
    model.fix_edge(body, 4)
    if law == "traction":
        pulled, unit, set_values = model.add_traction(body, 2, "x", 1e5), 1e5, model.set_load_values
    else:
        pulled, unit, set_values = model.prescribe_edge(body, 2, "x", 1e-6), 1e-6, model.set_support_values
    return model, lambda factor: set_values(pulled, constant=factor * unit)


scenes = pytest.mark.parametrize(("kind", "law"), [(kind, law) for kind in ("lattice", "elements")
                                                   for law in ("traction", "displacement")])


@scenes
@pytest.mark.parametrize(("times", "factors"), [([5, 6], [0, 1]), ([0.37, 0.51, 3], [0, 0, 1]), ([1, 2.3, 2.9, 7.7, 8.1], [1, 0, 0, 0, 1]),
                                                ([100.3, 100.4, 101.7], [0, 0, 1])])
def test_a_program_rests_at_zero(kind, law, times, factors):
    model, _ = block(kind, law)
    report = model.run_program(times, factors)
    assert report.load_factor == times[-1] and report.residual < 1e-10 and report.energy_balance_error < 1e-10
    expected, _ = block(kind, law)
    at_once = expected.step(1)
    assert report.stored_energy == pytest.approx(at_once.stored_energy, rel=1e-9)


@scenes
def test_a_host_rests_at_zero_between_loads(kind, law):
    model, give = block(kind, law)
    for time, factor in enumerate([0, 0.3, 0, 0, 0.7, 0, 1], start=1):
        give(factor)
        for moment in (0.37, 0.51):
            report = model.step_to_values(time + moment)
        report = model.step(time + 0.6)
    assert report.residual < 1e-10 and report.energy_balance_error < 1e-10
    expected, _ = block(kind, law)
    assert report.stored_energy == pytest.approx(expected.step(1).stored_energy, rel=1e-9)


@scenes
def test_a_step_to_where_nothing_acts(kind, law):
    model, give = block(kind, law)
    give(0)
    report = model.step(3.3)
    assert (report.residual, report.stored_energy, report.energy_balance_error) == (0, 0, 0)


def test_a_program_reports_what_its_ways_report():
    """Faces close when the block is pressed, and open when it is pulled."""
    model, _ = block("lattice", "displacement")
    whole = model.run_program([1, 2, 3], [1, -1, 1])
    parts, give = block("lattice", "displacement")
    steps = []
    for time, factor in ((1, 1), (2, -1), (3, 1)):
        give(factor)
        steps.append(parts.step_to_values(time))
    switches = sum(step.face_switches for step in steps)
    assert switches > 0 and whole.face_switches == switches
    for counted in ("events", "broken_bonds"):
        assert getattr(whole, counted) == sum(getattr(step, counted) for step in steps)
