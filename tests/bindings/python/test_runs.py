"""Steps, states, callbacks, threads."""

import io
import logging
import pickle
import threading

import bempd
import numpy as np
import pytest
from conftest import make_plate, make_strip


def test_steps_report_what_they_did(strip):
    report = strip.model.step(50)
    assert report.stop_reason is bempd.StopReason.LOAD_FACTOR and report.load_factor == 50 and report.events == 0
    report = strip.model.step_to_next_event(1e4)
    assert report.stop_reason is bempd.StopReason.EVENT and report.events == 1 and report.separated is False
    first = report.broken_bonds
    report = strip.model.run_to_separation(1e4)
    assert report.stop_reason is bempd.StopReason.SEPARATED and report.separated is True
    assert report.total_broken_bonds == first + report.broken_bonds and report.total_events == 1 + report.events
    assert report.energy_balance_error < 1e-9 and report.released_energy > 0


def test_the_path_of_equilibrium_costs_what_bonds_take(strip):
    strip.model.options["crack.rule"] = "bond"
    lowest, highest = strip.model.admissible_load_factors()
    assert lowest < 0 < highest
    held = strip.model.run_to_separation(1e4)
    other = make_strip()
    other.model.options["crack.rule"] = "bond"
    other.model.options["stepping.control"] = "path"
    path = other.model.run_to_separation(1e4)
    assert path.stop_reason is bempd.StopReason.SEPARATED and path.unstable_event == 0 < held.unstable_event
    assert path.released_energy == pytest.approx(held.bond_energy, rel=1e-9)
    assert path.released_energy < held.released_energy
    lines, on_path = strip.model.history(), other.model.history()
    np.testing.assert_allclose(lines["critical_load_factor"][:-1], on_path["load_factor"][:-1], rtol=1e-9)
    assert on_path["load_factor"][0] == pytest.approx(highest, rel=1e-9)


def test_a_step_repeats_bit_by_bit_from_a_saved_state(strip):
    strip.model.step_to_next_event(1e4)
    state = strip.model.save()
    strip.model.run_to_separation(1e4)
    first = strip.model.copy_field(strip.middle, "displacement")
    strip.model.restore(state)
    strip.model.run_to_separation(1e4)
    np.testing.assert_array_equal(strip.model.copy_field(strip.middle, "displacement"), first)


def test_states_travel_as_bytes_and_pickles(strip):
    strip.model.step_to_next_event(1e4)
    state = strip.model.save()
    for copy in (bempd.State.from_bytes(state.to_bytes()), pickle.loads(pickle.dumps(state)),
                 bempd.State.from_bytes(bytearray(state.to_bytes()))):
        assert copy == state
        other = make_strip()
        other.model.restore(copy)
        assert other.model.load_factor == strip.model.load_factor
        assert other.model.bonds(other.middle).states.tolist() == strip.model.bonds(strip.middle).states.tolist()


def test_damaged_and_foreign_states_are_refused(strip):
    with pytest.raises(bempd.OrderError, match="save: "):
        strip.model.save()
    strip.model.prepare()
    data = strip.model.save().to_bytes()
    for damaged in (data[:-1], b"", data[:40] + bytes([data[40] ^ 1]) + data[41:]):
        with pytest.raises(bempd.ArgumentError, match="State.from_bytes: "):
            bempd.State.from_bytes(damaged)
    with pytest.raises(bempd.ArgumentError, match="data is a str"):
        bempd.State.from_bytes("text")
    other = make_plate()
    with pytest.raises(bempd.ArgumentError, match="restore: .*another scene"):
        other.model.restore(bempd.State.from_bytes(data))


def test_progress_is_told_of_every_event(strip):
    seen = []
    strip.model.progress = lambda *values: seen.append(values)
    report = strip.model.run_to_separation(1e4)
    assert [events for _, events, _ in seen] == list(range(1, report.events + 1))
    assert seen[-1][2] == report.total_broken_bonds
    strip.model.progress = None
    assert strip.model.progress is None


@pytest.mark.parametrize("kind", [ZeroDivisionError, SystemExit])
def test_an_exception_in_progress_cancels_the_step_and_comes_out(strip, kind):
    strip.model.step(50)

    def fail(load_factor, events, broken_bonds):
        if events == 2:
            raise kind("enough")

    strip.model.progress = fail
    with pytest.raises(kind, match="enough"):
        strip.model.run_to_separation(1e4)
    assert strip.model.load_factor == 50 and strip.model.statistics().broken_bonds == 0
    strip.model.progress = None
    assert strip.model.run_to_separation(1e4).separated


def test_an_interrupt_keeps_the_events_and_comes_out(strip):
    def interrupted(load_factor, events, broken_bonds):
        if events == 2:
            raise KeyboardInterrupt("enough")

    strip.model.progress = interrupted
    with pytest.raises(KeyboardInterrupt, match="enough"):
        strip.model.run_to_separation(1e4)
    assert strip.model.statistics().broken_bonds > 0 and strip.model.load_factor > 0
    strip.model.progress = None
    report = strip.model.run_to_separation(1e4)
    assert report.separated and report.total_events == report.events + 2


def test_a_step_can_be_asked_to_stop(strip):
    def enough(load_factor, events, broken_bonds):
        if events == 2:
            strip.model.request_stop()

    strip.model.progress = enough
    report = strip.model.run_to_separation(1e4)
    assert report.stop_reason == bempd.StopReason.REQUESTED and report.events == 2
    strip.model.progress = None
    assert strip.model.run_to_separation(1e4).separated


def test_long_parts_say_how_far_they_are():
    told = []
    scene = make_plate()
    scene.model.phase_progress = lambda *words: told.append(words)
    scene.model.prepare()
    scene.model.step(1)
    assert told
    for phase, share, seconds, expected in told:
        assert phase and 0 <= share <= 1 and seconds >= 0 and (expected >= seconds if share > 0 else expected == 0)


def test_an_interrupt_while_preparing_cancels():
    scene = make_plate()

    def interrupted(phase, share, seconds, expected):
        raise KeyboardInterrupt(phase)

    scene.model.phase_progress = interrupted
    with pytest.raises(KeyboardInterrupt):
        scene.model.step(1)
    scene.model.phase_progress = None
    assert scene.model.phase_progress is None
    scene.model.step(1)


def test_an_exception_in_the_log_comes_out():
    scene = make_plate()

    def fail(level, message):
        raise ValueError(message)

    scene.model.log = fail
    with pytest.raises(ValueError, match="prepared: "):
        scene.model.prepare()
    scene.model.log = None
    scene.model.step(1)


def test_an_exception_in_a_boundary_function_comes_out(plate):
    def fail(x, y):
        raise LookupError(f"nothing at {x:g}")

    with pytest.raises(LookupError, match="nothing at 2"):
        plate.model.add_traction_function(plate.plate, 2, fail)
        plate.model.step(1)


@pytest.mark.parametrize("wrong", [3.0, (1, 2, 3), "ab", None])
def test_a_boundary_function_must_give_pairs(plate, wrong):
    with pytest.raises((bempd.ArgumentError, TypeError, ValueError)):
        plate.model.add_traction_function(plate.plate, 2, lambda x, y: wrong)
        plate.model.step(1)


def test_a_model_that_is_in_a_call_says_so(strip):
    caught = []

    def meddle(load_factor, events, broken_bonds):
        for call in (lambda: strip.model.load_factor, lambda: strip.model.step(1), strip.model.save):
            with pytest.raises(bempd.OrderError, match="in another call") as error:
                call()
            caught.append(error)

    strip.model.progress = meddle
    strip.model.step_to_next_event(1e4)
    assert len(caught) == 3


def test_a_model_closed_in_a_callback_ends_its_call_first():
    scene = make_strip()
    scene.model.progress = lambda *_: scene.model.close()
    assert scene.model.run_to_separation(1e4).separated
    assert scene.model.closed


def test_another_thread_may_cancel(strip):
    running, asked = threading.Event(), threading.Event()

    def wait(load_factor, events, broken_bonds):
        running.set()
        assert asked.wait(60)

    strip.model.progress = wait
    raised = []

    def run():
        try:
            strip.model.run_to_separation(1e4)
        except bempd.Error as error:
            raised.append(error)

    thread = threading.Thread(target=run)
    thread.start()
    assert running.wait(60)
    with pytest.raises(bempd.OrderError, match="in another call"):
        strip.model.load_factor
    strip.model.request_cancel()
    asked.set()
    thread.join(60)
    assert isinstance(raised[0], bempd.CancelledError) and "run_to_separation: cancelled" in str(raised[0])
    assert strip.model.load_factor == 0


def test_models_run_in_threads_of_their_own():
    results = [None] * 4

    def run(index):
        results[index] = make_strip(options={"threads": 1}).model.run_to_separation(1e4).released_energy

    threads = [threading.Thread(target=run, args=(index,)) for index in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert results[0] > 0 and len(set(results)) == 1


def test_the_log_goes_to_a_logger(caplog):
    caplog.set_level(logging.DEBUG)
    scene = make_plate(log=logging.getLogger("bempd"))
    scene.model.prepare()
    assert any(record.levelno == logging.INFO and "prepared: " in record.message for record in caplog.records)
    assert scene.model.log is logging.getLogger("bempd")


class Terminal(io.StringIO):
    def isatty(self):
        return True


def test_the_progress_bar_leaves_one_line_a_run():
    stream = io.StringIO()
    scene = make_strip(progress=bempd.progress_bar(stream))
    scene.model.step(1)
    assert stream.getvalue() == ""
    report = scene.model.run_to_separation(1e4)
    lines = stream.getvalue().splitlines()
    assert len(lines) == 1
    assert f"{report.total_events} events, {report.total_broken_bonds} bonds" in lines[0]


def test_the_progress_bar_shows_the_share_of_a_step_on_a_terminal():
    stream = Terminal()
    scene = make_strip(progress=bempd.progress_bar(stream))
    first = scene.model.step_to_next_event(1e4).load_factor
    scene.model.step(first + 1)
    text = stream.getvalue()
    assert "%" in text and "\r" in text and text.endswith("\n")


def test_a_model_is_closed_at_the_end_of_a_with_statement():
    with make_plate().model as model:
        assert not model.closed
    assert model.closed
