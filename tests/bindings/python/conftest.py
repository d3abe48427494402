"""Scenes that the tests share."""

import os
import types

import bempd
import matplotlib
import pytest
from bempd import rectangle

matplotlib.use("Agg")
os.environ["BEMPD_TEST_HOOKS"] = "1"  # options whose names begin with test.


def make_strip(spacing=0.002, **options):
    """An edge crack in a strip pulled at its ends; small, and breaks in a fraction of a second."""
    model = bempd.Model(**options)
    acrylic = model.add_material(young_modulus=3e9, poisson_ratio=1 / 3, thickness=0.005, fracture_energy=300)
    left = model.add_bem_region(acrylic, rectangle(0, 0, 0.02, 0.02), element_length=0.01)
    middle = model.add_pd_region(acrylic, rectangle(0.02, 0, 0.04, 0.02), spacing=spacing,
                                 horizon_ratio=3)
    right = model.add_bem_region(acrylic, rectangle(0.04, 0, 0.06, 0.02), element_length=0.01)
    crack = model.add_crack([(0.0295 - spacing / 4, 0), (0.0295 - spacing / 4, 0.0049)])
    held = model.fix_edge(left, 4)
    pulled = model.prescribe_edge(right, 2, "x", 1e-6)
    return types.SimpleNamespace(model=model, material=acrylic, left=left, middle=middle, right=right, crack=crack,
                                 held=held, pulled=pulled)


def make_plate(**options):
    """A plate of boundary elements under tension; no cracks."""
    model = bempd.Model(**options)
    steel = model.add_material(young_modulus=2e11, poisson_ratio=0.3)
    plate = model.add_bem_region(steel, rectangle(0, 0, 2, 1), element_length=0.25)
    held = [model.fix_edge(plate, 4, "x"), model.fix_point((0, 0), "y")]
    return types.SimpleNamespace(model=model, steel=steel, plate=plate, held=held)


@pytest.fixture
def strip():
    return make_strip()


@pytest.fixture
def plate():
    return make_plate()
