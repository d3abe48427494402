"""Lattice patches are laid out in little time, or refused with the reason."""

import threading
import time

import bempd
import pytest


def square(cracks, spacing=0, **options):
    """Clamped unit square whose cracks are to have lattice patches."""
    model = bempd.Model(options=options)
    body = model.add_body(model.add_material(young_modulus=1000, poisson_ratio=0.3, fracture_energy=1e-3), bempd.rectangle(0, 0, 1, 1))
    for crack in cracks:
        model.set_crack_treatment(model.add_crack(crack), "lattice")
    model.fix_edge(body, 1)
    if spacing:
        model.set_body_lattice(body, spacing)
    return model


@pytest.mark.parametrize("gap", [1e-4, 1e-5, 1e-7])
def test_a_tip_close_to_an_edge_is_refused_before_blocks_are_laid(gap):
    model = square([[(0.2, 0.5), (1 - gap, 0.5)]], **{"memory.limit": 0.5})
    begin = time.process_time()
    with pytest.raises(bempd.ArgumentError, match=r"crack 1 ends \S+ away from edge 2.*another treatment"):
        model.prepare()
    assert time.process_time() - begin < 1


def test_a_spacing_that_needs_too_much_memory_is_refused_before_blocks_are_laid():
    model = square([[(0.2, 0.5), (0.7, 0.6)]], spacing=1e-9)
    with pytest.raises(bempd.ArgumentError, match="body 1 would have more than .* bonds with a spacing of 1e-09; .* a larger spacing"):
        model.prepare()
    model = square([[(0.2, 0.5), (0.7, 0.6)]], spacing=1e-5, **{"memory.limit": 1})
    with pytest.raises(bempd.ArgumentError, match=r"would need about \d.* GB for lattice patches of body 1 with a spacing of 1e-05; .*allows 1 GB"):
        model.prepare()


def test_cracks_that_touch_need_a_given_spacing():
    cracks = [[(0.3, 0.5), (0.7, 0.5)], [(0.5, 0.5), (0.5, 0.7)]]
    with pytest.raises(bempd.ArgumentError, match=r"crack 2 ends on crack 1 at \(0.5, 0.5\).*set_body_lattice"):
        square(cracks).prepare()


def test_the_layout_of_a_fine_lattice_hears_a_cancel():
    model = square([[(0.2, 0.21), (0.7, 0.8)]], spacing=2e-6, **{"memory.limit": 1e6})
    threading.Timer(0.2, model.request_cancel).start()
    begin = time.monotonic()
    with pytest.raises(bempd.CancelledError):
        model.prepare()
    assert time.monotonic() - begin < 5


def test_a_treatment_goes_with_its_crack():
    for treatment in ("elements", "lattice", "frozen"):
        model = square([[(0.3, 0.5), (0.7, 0.5)]])
        model.set_crack_treatment(1, treatment)
        model.remove_crack(1)
        model.prepare()
        assert len(model.parts()) == 1
