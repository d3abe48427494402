"""Parts that springs hold where cracks have freed them, and the faces that press on them (option contact)."""

from __future__ import annotations

from typing import Any, Sequence

import pytest

import bempd

Crack = Sequence[tuple[float, float]]


def plate(width: float, height: float, horizon_ratio: int, cracks: Sequence[Crack], **options: Any) -> tuple[bempd.Model, int]:
    model = bempd.Model(options={name.replace("__", "."): value for name, value in options.items()})
    material = model.add_material(young_modulus=1, poisson_ratio=1 / 3, critical_stretch=1e-3)
    body = model.add_pd_region(material, bempd.rectangle(0, 0, width, height), 1, horizon_ratio)
    for crack in cracks:
        model.add_crack(crack)
    return model, body


def tear(model: bempd.Model, events: int) -> bempd.StepReport:
    """Forces and energies in balance to the last event, which a call that succeeds promises."""
    for _ in range(events):
        report = model.step_to_next_event(1e4)
        assert report.residual < 1e-8 and report.energy_balance_error < 1e-10
        if report.stop_reason != bempd.StopReason.EVENT:
            break
    return report


SOLVERS = pytest.mark.parametrize("solver", ["window", "plain"])


@SOLVERS
def test_what_a_spring_holds_grows_as_bonds_break(solver: str) -> None:
    """A sliver at the edge; what may press on it was asked when the spring came, and never again."""
    model, body = plate(10, 14, 3, [[(0, 6.681), (0.07, 1.831)]], contact="faces", crack__tie_share=0.02,
                        test__solver=solver)
    model.fix_edge(body, 1, "y")
    model.fix_point((0, 0), "x")
    model.prescribe_edge(body, 3, "y", -0.014)
    tear(model, 40)


@SOLVERS
def test_a_part_that_comes_free_where_faces_open_takes_its_energy_along(solver: str) -> None:
    """Pressed and sheared until nothing but faces holds the upper part; nothing breaks where they open."""
    model, body = plate(25, 9, 3, [[(0, 7.271), (0.07, 5.768)]], contact="faces", crack__tie_share=0.02,
                        test__solver=solver)
    model.fix_edge(body, 1, "y")
    model.fix_point((0, 0), "x")
    model.prescribe_edge(body, 3, "x", 0.009)
    model.add_traction(body, 3, "y", 0, constant=-3e-4)
    assert tear(model, 60).stop_reason == bempd.StopReason.SEPARATED


def test_windows_in_which_faces_close_and_nothing_breaks() -> None:
    """All of a window's pending changes are of faces: the product with those of bonds, of which there are none, ended the
    process by a division."""
    cracks = [[(0, 2.5388), (13.93, 0.3298)], [(2.4863, 16.6179), (0.07, 17.93)]]
    model, body = plate(14, 18, 4, cracks, contact="faces", crack__tie_share=0.0)
    model.fix_edge(body, 1, "both")
    model.prescribe_edge(body, 3, "y", -0.018)
    model.prescribe_edge(body, 3, "x", 0.018)
    tear(model, 40)


def test_faces_do_not_press_on_a_piece_that_slides_along_a_support() -> None:
    """The crack comes to an edge that is held in x: the end of its faces there, whose other component no support knows,
    closed and pushed the piece along the edge."""
    model = bempd.Model()
    material = model.add_material(young_modulus=1, poisson_ratio=1 / 3, fracture_energy=1.6e-6)
    body = model.add_bem_region(material, bempd.rectangle(0, 0, 13, 6), 2)
    model.add_crack([(2.21024885418835, 6), (3.7901015494690635, 1.7573967604503584)])
    model.fix_edge(body, 4, "both")
    model.fix_point((0, 0), "y")
    model.prescribe_edge(body, 2, "x", 0.013)
    model.prescribe_edge(body, 1, "x", 0.002, constant=0.001, part=(0.25, 0.5))
    report = tear(model, 40)
    assert model.extensions()[-1].state == bempd.TipState.AT_EDGE
    assert report.stop_reason == bempd.StopReason.NO_FURTHER_EVENT and model.piece_count == 2
