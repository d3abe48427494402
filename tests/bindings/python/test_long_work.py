"""Long work is told of from its first second on, and Ctrl-C is heard while the library works: in processes of their own."""

import io
import os
import pathlib
import re
import signal
import subprocess
import sys
import time

import bempd
import pytest
from bempd import rectangle
from conftest import make_strip

HERE = pathlib.Path(__file__).resolve().parent
# A lattice that takes some ten seconds to prepare and to factorize, and minutes to tear.
LONG = """
import bempd, sys
model = bempd.Model({bar})
glass = model.add_material(young_modulus=3e9, poisson_ratio=1 / 3, fracture_energy=300)
plate = model.add_pd_region(glass, bempd.rectangle(0, 0, 0.02, 0.02), spacing=0.02 / {cells}, horizon_ratio=4)
model.add_crack([(0.0101, 0), (0.0101, 0.0051)])
model.fix_edge(plate, 4)
model.prescribe_edge(plate, 2, "x", 1e-6)
print("begins", flush=True)
try:
    {call}
except KeyboardInterrupt:
    print("interrupted", flush=True)
print("kept", model.load_factor > 0, flush=True)
"""


def begin(call, cells, bar=""):
    code = LONG.format(call=call, cells=cells, bar=bar)
    process = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                               env={**os.environ, "OPENBLAS_NUM_THREADS": "1"})
    assert process.stdout.readline() == "begins\n"
    return process


def processor_time(process):
    """Seconds that a process has computed, which other programs on the machine do not lengthen."""
    fields = pathlib.Path(f"/proc/{process.pid}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def children_time():
    """Seconds that processes have computed which have ended."""
    times = os.times()
    return times.children_user + times.children_system


def test_an_interrupt_is_heard_while_a_scene_is_prepared():
    process = begin("model.step(1)", 400)
    time.sleep(0.6)
    sent = processor_time(process)
    process.send_signal(signal.SIGINT)
    assert process.stdout.readline() == "interrupted\n"
    assert processor_time(process) - sent < 2
    process.kill()
    process.communicate()


def test_an_interrupt_keeps_the_events_before_it():
    """The progress function says when events have begun; the run would go on for long."""
    process = begin("model.run_to_separation(1e4)", 100,
                    "progress=lambda factor, events, bonds: events == 2 and print('event', flush=True)")
    assert process.stdout.readline() == "event\n"
    process.send_signal(signal.SIGINT)
    output, errors = process.communicate(timeout=60)
    assert output.startswith("interrupted\nkept True"), output + errors


def test_a_second_interrupt_ends_the_process():
    """The run keeps the library in one call for the whole time, so that Python itself does not hear the first one."""
    process = begin("""
    import signal, threading, bempd._interrupts as hearing
    from bempd._library import ffi, lib
    hearing.lib = type("Deaf", (), {"bempd_request_cancel": staticmethod(lambda model: 0)})  # as in a long factorization
    lib.bempd_set_phase_progress(model._handle.pointer, ffi.NULL, ffi.NULL)  # which calls back, where Python hears Ctrl-C
    model.step(1)""", 400)
    time.sleep(0.6)
    process.send_signal(signal.SIGINT)
    time.sleep(0.3)
    assert process.poll() is None
    sent, ended = processor_time(process), children_time()
    process.send_signal(signal.SIGINT)
    output, errors = process.communicate(timeout=60)
    assert process.returncode == 130 and "second Ctrl-C" in errors, (process.returncode, output, errors)
    assert children_time() - ended - sent < 2


def test_a_host_s_own_handler_is_left_alone():
    before = signal.signal(signal.SIGINT, lambda *_: None)
    try:
        strip = make_strip()
        strip.model.step(1)
        assert signal.set_wakeup_fd(-1) == -1
    finally:
        signal.signal(signal.SIGINT, before)


def test_the_file_descriptor_of_an_event_loop_is_put_back():
    reading, writing = os.pipe()
    os.set_blocking(writing, False)
    before = signal.set_wakeup_fd(writing)
    try:
        make_strip().model.step(1)
    finally:
        assert signal.set_wakeup_fd(before) == writing
    os.close(reading), os.close(writing)


class Terminal(io.StringIO):
    def isatty(self):
        return True


def lines_of(stream):
    return [line for line in re.split("[\r\n]", stream.getvalue()) if line.strip()]


@pytest.mark.parametrize("stream", [Terminal(), io.StringIO()], ids=["terminal", "log"])
def test_the_bar_follows_the_preparation(stream, monkeypatch):
    monkeypatch.setattr("bempd._bar.FIRST_LINE", 0.05)
    model = bempd.Model(progress=bempd.progress_bar(stream))
    glass = model.add_material(young_modulus=3e9, poisson_ratio=1 / 3, fracture_energy=300)
    plate = model.add_pd_region(glass, rectangle(0, 0, 0.02, 0.02), spacing=0.02 / 160, horizon_ratio=4)
    model.fix_edge(plate, 4)
    model.prescribe_edge(plate, 2, "x", 1e-6)
    model.step(1)
    lines = lines_of(stream)
    assert any(re.match(r"\s*\d+% \|.*\| (bonds of a lattice|ordering of the sparse system|sparse factorization) \[.* s(, .* to go)?\]", line) for line in lines), lines
    if stream.isatty():
        assert stream.getvalue().endswith("\r"), "a run without an event leaves no line"


def test_the_bar_says_the_time_to_go():
    stream = Terminal()
    bar = bempd.progress_bar(stream)
    bar.start(0.0, 10.0)
    bar._began -= 4
    bar._shown = 0
    bar(2.5, 3, 7)
    bar.phase("sparse factorization", 0.25, 5.0, 20.0)
    bar._shown = 0
    bar.phase("sparse factorization", 0.25, 5.0, 20.0)
    bar.finish()
    text = stream.getvalue()
    assert re.search(r" 25% \|█+ +\| load factor 2.5, 3 events, 7 bonds \[4.0 s, 12 s to go\]", text), text
    assert re.search(r" 25% \|█+ +\| sparse factorization \[5.0 s, 15 s to go\]", text), text
