"""Initial cracks through material points: they pass them by, whichever way they run."""

from __future__ import annotations

import numpy as np
import pytest

import bempd

SIDE = 24.0


def plate(crack: list[tuple[float, float]], rule: str = "line", lattices: int = 1) -> bempd.Model:
    model = bempd.Model(options={"crack.rule": rule})
    material = model.add_material(young_modulus=1, poisson_ratio=1 / 3, critical_stretch=1e-3)
    for k in range(lattices):
        left, right = k * SIDE / lattices, (k + 1) * SIDE / lattices
        body = model.add_pd_region(material, bempd.rectangle(left, 0, right, SIDE), 1, 3)
        model.prescribe_edge(body, 1, "y", -1)
        model.prescribe_edge(body, 3, "y", 1)
    model.add_crack(crack)
    model.fix_edge(1, 4, "x") if lattices > 1 else model.fix_point((0, 0), "x")
    return model


def cut(model: bempd.Model) -> set[tuple[int, int]]:
    model.prepare()
    found: set[tuple[int, int]] = set()
    for region in range(1, model.region_count + 1 if hasattr(model, "region_count") else 2):
        bonds = model.bonds(region)
        found |= {tuple(pair) for pair in bonds.points[bonds.states == bempd.BondState.CUT].tolist()}
    return found


@pytest.mark.parametrize(("through", "beside"), [
    ([(0, 12), (10.5, 12)], [(0, 11.99), (10.5, 11.99)]),  # along a row, from an edge; its right is below
    ([(10.5, 12), (0, 12)], [(10.5, 12.01), (0, 12.01)]),
    ([(12, 0), (12, 8.5)], [(12.01, 0), (12.01, 8.5)]),  # along a column
    ([(6.5, 6.5), (14.5, 14.5)], [(6.505, 6.495), (14.505, 14.495)]),  # along a diagonal
])
def test_a_crack_along_a_row_cuts_what_one_on_its_right_cuts(through, beside) -> None:
    assert cut(plate(through)) == cut(plate(beside)) != set()


def test_a_word_tells_which_side() -> None:
    model, said = plate([(0, 12), (10.5, 12)]), []
    model.log = lambda level, message: said.append(message)
    model.prepare()
    assert said[0].startswith("crack 1 passes through 11 material points, the first at (0, 12); it passes them by on its right")


def test_a_crack_through_single_points_and_a_bent_one_are_taken() -> None:
    for crack in ([(3.2, 5), (9, 8.5), (9, 14)], [(3.5, 3.5), (9, 6), (14.5, 8.5)], [(2, 2), (20, 17)]):
        model = plate(crack)
        assert cut(model)
        assert model.run_to_separation(1e6).separated


@pytest.mark.parametrize("rule", ["line", "bond"])
def test_it_grows_at_the_load_of_one_half_a_spacing_beside(rule: str) -> None:
    loads = [plate([(0, y), (10.5, y)], rule).step_to_next_event(1e6).load_factor for y in (12.0, 11.5)]
    assert loads[0] == pytest.approx(loads[1], rel=0.1 if rule == "bond" else 0.05)


def test_along_the_common_edge_of_two_lattices_it_parts_them() -> None:
    loads = [plate([(12, 0), (12, 8.5)], "line", lattices).step_to_next_event(1e6).load_factor for lattices in (1, 2)]
    assert np.isfinite(loads).all()


def test_along_an_outer_edge_it_is_refused() -> None:
    with pytest.raises(bempd.ArgumentError, match="crack 1 passes through .* material points of region 1"):
        plate([(0, 3.5), (0, 9.5)]).prepare()
