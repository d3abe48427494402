"""Cracks that grow as lines in windows: the steps of the whole body, at the cost of a few of its solutions."""

from __future__ import annotations

import math
import struct
from typing import Callable, NamedTuple

import numpy as np
import pytest

import bempd

WIDTH = 40.0
COLUMNS = ("load_factor", "stored_energy", "released_energy", "work", "critical_load_factor", "stretch_ratio")


def plate(solver: str, rule: str = "line", control: str = "load", incline: float = 0) -> tuple[bempd.Model, int]:
    """An edge crack at an incline in a plate whose clamps move apart."""
    model = bempd.Model(options={"crack.rule": rule, "stepping.control": control, "test.solver": solver})
    material = model.add_material(young_modulus=8 / 9, poisson_ratio=1 / 3, fracture_energy=1, thermal_expansion=1e-3)
    body = model.add_pd_region(material, bempd.rectangle(0, -WIDTH / 2, WIDTH, WIDTH / 2), 1.0, 3)
    angle, start = math.radians(incline), 0.513
    model.add_crack([(0, start), (WIDTH / 4 * math.cos(angle), start + WIDTH / 4 * math.sin(angle))])
    for edge, value in ((1, -1.0), (3, 1.0)):
        model.prescribe_edge(body, edge, "y", value)
        model.fix_edge(body, edge, "x")
    return model, body


class Spent(NamedTuple):
    factor_updates: int
    solves: int


def run(model: bempd.Model, body: int, events: int) -> tuple[np.ndarray, np.ndarray, Spent]:
    """Events, states, and what the steps after the first took: that one has its load from sums in the whole body."""
    model.step_to_next_event(1e6)
    first = model.statistics()
    for _ in range(events - 1):
        model.step_to_next_event(1e6)
    spent = model.statistics()
    after_first = Spent(spent.factor_updates - first.factor_updates, spent.solves - first.solves)
    return model.history(), model.bonds(body).states, after_first


def expect_same(window: np.ndarray, plain: np.ndarray) -> None:
    assert len(window) == len(plain)
    for column in COLUMNS:
        assert window[column] == pytest.approx(plain[column], rel=1e-9, abs=1e-12), column


@pytest.mark.parametrize("rule,control,incline,events", [("line", "path", 0, 27), ("line", "load", 0, 27), ("tips", "path", 0, 27),
                                                         ("line", "path", 30, 20), ("tips", "load", 60, 20)])
def test_windows_take_the_steps_of_the_whole_body(rule: str, control: str, incline: float, events: int) -> None:
    window, states, spent = run(*plate("window", rule, control, incline), events)
    plain, same_states, plainly = run(*plate("plain", rule, control, incline), events)
    assert (states == same_states).all()
    expect_same(window, plain)
    assert window["residual"].max() < 1e-11
    if incline == 0:  # columns by which factors are changed, and solutions: windows do without
        print("updates", spent.factor_updates, "of", plainly.factor_updates, "solves", spent.solves, "of", plainly.solves)
        assert spent.factor_updates < plainly.factor_updates / 4
        assert spent.solves < plainly.solves / 2


def test_a_plate_is_torn_in_few_windows() -> None:
    """Straight across, a window a time: factorizations, each with a window, against a change of the factor a step. Four more
    belong to the first steps of both tips, with loads from sums, and to those before the edges, with loads of trial steps."""
    model = bempd.Model(options={"crack.rule": "line"})
    material = model.add_material(young_modulus=1, poisson_ratio=1 / 3, critical_stretch=1e-3)
    body = model.add_pd_region(material, bempd.rectangle(0, 0, 49, 49), 1, 4)
    model.add_crack([(24.5, 19.500001), (24.5, 29.499999)])
    for edge, pull in ((4, -1.0), (2, 1.0)):
        model.prescribe_edge(body, edge, "x", pull)
        model.prescribe_edge(body, edge, "y", 0.0)
    model.run_to_separation(1e9)
    spent = model.statistics()
    print(len(model.history()), "lines of the history,", spent.sparse_factorizations, "factorizations,", spent.factor_updates,
          "updates,", spent.solves, "solves")
    assert model.history()["event"].max() == 32 and spent.sparse_factorizations <= 5 and spent.factor_updates < 800


def body_force(model: bempd.Model, body: int) -> None:
    model.add_body_force(body, "x", 0, constant=1e-4)


def heat(model: bempd.Model, body: int) -> None:
    model.add_temperature(body, constant=-1.0)


def pressed_crack(model: bempd.Model, body: int) -> None:
    model.add_crack_pressure(1, constant=1e-3)


def growing_force(model: bempd.Model, body: int) -> None:
    model.add_body_force(body, "x", 1e-4)


def growing_heat(model: bempd.Model, body: int) -> None:
    model.add_temperature(body, -0.1)


@pytest.mark.parametrize("control", ["load", "path"])
@pytest.mark.parametrize("add", [body_force, heat, pressed_crack, growing_force, growing_heat])
def test_other_loads_leave_the_steps_to_whom_they_fit(add: Callable[[bempd.Model, int], None], control: str) -> None:
    found = []
    for solver in ("window", "plain"):
        model, body = plate(solver, control=control)
        add(model, body)
        found.append(run(model, body, 12))
    (window, states, spent), (plain, same_states, plainly) = found
    assert (states == same_states).all()
    expect_same(window, plain)
    if add is growing_force:
        assert spent.factor_updates < plainly.factor_updates
    if add in (body_force, pressed_crack):  # constant parts: windows of lines have none
        assert spent.factor_updates == plainly.factor_updates


def test_faces_that_were_pressed_open_and_grow_alike() -> None:
    found = []
    for solver in ("window", "plain"):
        model, body = plate(solver, incline=30)
        model.step(-0.5)
        assert model.step(-1.0).closed_places > 0
        found.append(run(model, body, 12))
    assert (found[0][1] == found[1][1]).all()
    expect_same(found[0][0], found[1][0])


def test_a_window_goes_on_from_a_state_and_back_to_one() -> None:
    model, _ = plate("window", control="path")
    for _ in range(5):
        model.step_to_next_event(1e6)
    state = model.save()
    loads = [model.step_to_next_event(1e6).load_factor for _ in range(8)]
    model.restore(state)
    assert [model.step_to_next_event(1e6).load_factor for _ in range(8)] == loads
    other, _ = plate("window", control="path")
    other.restore(bempd.State.from_bytes(state.to_bytes()))
    assert [other.step_to_next_event(1e6).load_factor for _ in range(8)] == loads
    assert other.save().to_bytes() == model.save().to_bytes()


def signed(body: bytes) -> bytes:
    """With the checksum of states: FNV-1a, 64 bits."""
    found = 14695981039346656037
    for byte in body:
        found = (found ^ byte) * 1099511628211 & (1 << 64) - 1
    return body + struct.pack("<Q", found)


@pytest.mark.parametrize("what,place,value", [("place", 0, math.nan), ("direction", 16, 3.0), ("law", 32, 1), ("law", 32, -7), ("crack", 44, 0), ("end", 48, 2)])
def test_altered_tips_of_a_window_are_refused(what: str, place: int, value: float) -> None:
    """The last of a state's bytes: of the tip with which the window was opened, at first, and of no energies."""
    model, _ = plate("window")
    model.options["crack.load"] = "fit"  # the first step needs the whole body else
    for _ in range(3):
        model.step_to_next_event(1e6)
    body = model.save().to_bytes()[:-8]
    tip = len(body) - 4 * 8 - 4 - 8 - 4 - 4 - 1 - 9 - 8
    count, x, *others = struct.unpack("<q4diqiiBBdd", body[tip - 8:])  # the cut ends beside the described tip
    assert count == 1 and abs(x - WIDTH / 4) < 0.6 and others[:9] == [0.513, 1, 0, 0, 0, 1, 1, 0, 1]
    assert bempd.State.from_bytes(signed(body)).to_bytes()[:-8] == body
    packed = struct.pack("<d" if what in ("place", "direction") else "<i", value)
    altered = body[:tip + place] + packed + body[tip + place + len(packed):]
    with pytest.raises(bempd.ArgumentError):
        model.restore(bempd.State.from_bytes(signed(altered)))
