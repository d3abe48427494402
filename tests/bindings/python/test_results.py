"""Fields in three ways, and what else a model answers."""

import gc
import weakref

import bempd
import numpy as np
import pytest
from conftest import make_plate, make_strip


def test_a_field_keeps_its_values_when_the_model_moves_on(strip):
    before = strip.model.field(strip.middle, "displacement")
    assert before.shape == (121, 2) and before.dtype == np.float64 and not before.any()
    assert strip.model.field(strip.middle, "displacement") is before
    strip.model.step(10)
    after = strip.model.field(strip.middle, "displacement")
    assert after is not before and after[:, 0].max() > 0 and not before.any()


def test_fields_are_read_only_and_copies_are_not(strip):
    field = strip.model.field(strip.middle, "stress")
    with pytest.raises(ValueError):
        field[0] = 1
    own = strip.model.copy_field(strip.middle, "stress")
    own[:] = 1
    assert not strip.model.field(strip.middle, "stress").any()
    assert strip.model.copy_field(strip.middle, "stress", out=own) is own and not own.any()


def test_the_shape_of_every_field(strip):
    shapes = {(strip.left, "position"): 2, (strip.left, "displacement"): 2, (strip.left, "stress"): 3,
              (strip.middle, "damage"): 1, (strip.middle, "stress"): 3}
    for (region, name), components in shapes.items():
        expected = (strip.model.node_count(region),) + ((components,) if components > 1 else ())
        assert strip.model.field(region, name).shape == strip.model.view_field(region, name).shape == expected
    assert strip.model.field(strip.left, "traction").shape == (3 * len(strip.model.elements(strip.left)), 2)
    bonds = strip.model.bonds(strip.middle)
    assert strip.model.field(strip.middle, "bond_stretch").shape == bonds.states.shape == (len(bonds.points),)


def test_a_view_is_the_library_s_memory_read_only(strip):
    strip.model.step(10)
    view, again = (strip.model.view_field(strip.middle, "displacement") for _ in range(2))
    assert view.__array_interface__["data"] == again.__array_interface__["data"]
    assert view.__array_interface__["data"][1] is True
    np.testing.assert_array_equal(view, strip.model.field(strip.middle, "displacement"))
    with pytest.raises(ValueError):
        view.flags.writeable = True


def test_a_view_holds_the_model_still(strip):
    state = (strip.model.prepare(), strip.model.save())[1]
    part = strip.model.view_field(strip.middle, "displacement")[3:, 0]
    for change in (lambda: strip.model.step(1), lambda: strip.model.step_to_next_event(1),
                   lambda: strip.model.run_to_separation(1), lambda: strip.model.restore(state),
                   lambda: strip.model.set_support_values(strip.pulled, 2e-6)):
        with pytest.raises(bempd.OrderError, match=r"1 array\(s\) made by view_field\(\)"):
            change()
    strip.model.field(strip.middle, "stress")  # asking is no change
    assert strip.model.load_factor == 0 and not part.any()
    del part
    assert strip.model.step(1).load_factor == 1


def test_a_refused_view_does_not_hold_the_model(strip):
    with pytest.raises(bempd.ArgumentError):
        strip.model.view_field(strip.left, "damage")
    strip.model.step(1)


@pytest.mark.parametrize("close", [True, False])
def test_views_outlive_the_model(close):
    scene = make_strip()
    scene.model.step(10)
    expected = scene.model.copy_field(scene.middle, "displacement")
    view = scene.model.view_field(scene.middle, "displacement")[::2]
    handle = weakref.ref(scene.model._handle)
    if close:
        scene.model.close()
    del scene
    gc.collect()
    others = [make_plate() for _ in range(20)]  # would reuse the memory
    np.testing.assert_array_equal(view, expected[::2])
    assert handle() is not None and others
    del view
    gc.collect()
    assert handle() is None


def test_nothing_keeps_a_dropped_model():
    scene = make_plate(progress=lambda *_: None, log=lambda *_: None)
    scene.model.add_traction_function(scene.plate, 2, lambda x, y: (0, scene.model is None))
    scene.model.step(1)
    handle = weakref.ref(scene.model._handle)
    del scene
    gc.collect()
    assert handle() is None


def test_bonds_and_cells(strip):
    bonds = strip.model.bonds(strip.middle)
    cells = strip.model.elements(strip.middle)
    assert cells.shape == (100, 4) and cells.max() == 120 and bonds.points.max() == 120
    assert set(np.unique(bonds.states)) == {bempd.BondState.INTACT, bempd.BondState.CUT}
    report = strip.model.run_to_separation(1e4)
    states = strip.model.bonds(strip.middle).states
    assert np.count_nonzero(states == bempd.BondState.BROKEN) == report.total_broken_bonds > 0
    corners = strip.model.field(strip.middle, "position")[cells]
    first, second = corners[:, 1] - corners[:, 0], corners[:, 3] - corners[:, 0]
    np.testing.assert_allclose(first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0], 0.002**2)


def test_points_are_evaluated_where_they_lie(strip):
    strip.model.step(50)
    places = np.array([(0.01, 0.01), (0.03, 0.012), (0.05, 0.01)])
    values = strip.model.evaluate(places)
    assert values.region.tolist() == [strip.left, strip.middle, strip.right]
    assert values.stress.shape == (3, 3) and (values.stress[:, 0] > 0).all()
    nodes = strip.model.field(strip.middle, "position")
    at = np.argmin(np.hypot(*(nodes - places[1]).T))
    np.testing.assert_allclose(values.displacement[1], strip.model.field(strip.middle, "displacement")[at])
    fast = strip.model.evaluate(places, stress=False)
    assert fast.stress is None
    np.testing.assert_allclose(fast.displacement, values.displacement, rtol=1e-12)
    assert strip.model.evaluate(np.empty((0, 2))).displacement.shape == (0, 2)


def test_history_matches_the_file(strip, tmp_path):
    assert len(strip.model.history()) == 0
    strip.model.step(50)
    report = strip.model.run_to_separation(1e4)
    history = strip.model.history()
    assert history["total_broken_bonds"][-1] == report.total_broken_bonds
    assert history["event"].max() == report.total_events and history.dtype.names[0] == "event"
    strip.model.write_history(tmp_path / "history.csv")
    table = bempd.read_history(tmp_path / "history.csv")
    for name in history.dtype.names:
        np.testing.assert_array_equal(table[name], history[name])
    assert table[f"reaction_x_{strip.pulled}"].max() > 0


def test_reports_have_every_member_of_the_structs(strip):
    from bempd._library import members

    import dataclasses

    for kind, struct in ((bempd.StepReport, "bempd_step_report"), (bempd.Statistics, "bempd_statistics")):
        assert [field.name for field in dataclasses.fields(kind)] == [name for name, _ in members(struct)]
    strip.model.step(1)
    statistics = strip.model.statistics()
    assert statistics.material_points == 121 and statistics.bonds == len(strip.model.bonds(strip.middle).states)
    assert statistics.cut_bonds > 0 and isinstance(statistics.seconds_solve, float)


def test_a_new_member_of_a_struct_does_not_break_reports(strip, monkeypatch):
    from bempd import reports

    known = reports.members
    monkeypatch.setattr(reports, "members", lambda name: known(name) + [("added_later", None)])

    class Struct:
        """A struct of a library that knows more."""

        added_later = 1

        def __getattr__(self, name):
            return 1

    assert reports.step_report(Struct()).events == 1
    assert reports.values_of(Struct(), "bempd_statistics", bempd.Statistics)["bonds"] == 1


def test_enumerations_are_those_of_the_header():
    from bempd._library import lib

    assert {reason.name: reason.value for reason in bempd.StopReason} == {
        name: getattr(lib, "BEMPD_STOP_" + name) for name in ("LOAD_FACTOR", "EVENT", "SEPARATED", "NO_FURTHER_EVENT",
                                                       "NO_ADMISSIBLE_LOAD", "NO_EQUILIBRIUM", "REQUESTED", "CRACK_STOPPED")}
    assert {state.name: state.value for state in bempd.BondState} == {
        name: getattr(lib, "BEMPD_BOND_" + name) for name in ("INTACT", "BROKEN", "CUT")}


def test_snapshots_go_where_they_are_sent(strip, tmp_path):
    folder = tmp_path / "größe 1"
    folder.mkdir()
    strip.model.step(1)
    strip.model.write_snapshot(folder / "run")
    parts = {f"run_0000_{part}.vtu" for part in ("lattice", "boundary", "inside", "cracks")}
    assert {path.name for path in folder.iterdir()} == {"run.pvd"} | parts


def test_snapshots_of_another_run_are_not_overwritten_in_silence(strip, tmp_path):
    strip.model.write_snapshot(tmp_path / "run")
    again = make_strip().model
    before = (tmp_path / "run.pvd").read_bytes()
    with pytest.raises(bempd.FileError, match="is there already, of another run.*snapshots.existing"):
        again.write_snapshot(tmp_path / "run")
    assert (tmp_path / "run.pvd").read_bytes() == before
    again.options["snapshots.existing"] = "continue"
    again.write_snapshot(tmp_path / "run")
    assert (tmp_path / "run_0001_lattice.vtu").exists()
    assert (tmp_path / "run.pvd").read_text().count("_lattice.vtu") == 2
