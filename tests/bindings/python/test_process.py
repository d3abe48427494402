"""How the library is found, and how the interpreter ends: each in a process of its own."""

import os
import pathlib
import shutil
import signal
import subprocess
import sys

import bempd
import pytest

HERE = pathlib.Path(__file__).resolve().parent
PACKAGE = pathlib.Path(bempd.__file__).resolve().parent


def run(code, *, folder=HERE, **environment):
    return subprocess.run([sys.executable, "-c", code], cwd=folder, capture_output=True, text=True, timeout=120,
                          env={**os.environ, **environment})


@pytest.mark.parametrize("end", ["", "sys.exit(0)", "import gc; gc.disable()"])
def test_the_interpreter_ends_well_with_everything_alive(end):
    result = run(f"""
import sys, conftest, bempd, threading
scene = conftest.make_strip(progress=lambda *_: None, log=lambda *_: None)
scene.model.step_to_next_event(1e4)
view = scene.model.view_field(scene.middle, "stress")[1:]
state = scene.model.save()
cycle = [scene, view, state]
cycle.append(cycle)
sys.modules["kept"] = scene
{end}
""")
    assert (result.returncode, result.stderr) == (0, "")


def test_the_package_run_as_a_program_says_what_is_at_work():
    """Version, library and BLAS, and the strip of the tutorial."""
    shown = subprocess.run([sys.executable, "-m", "bempd"], capture_output=True, text=True, timeout=120)
    rows = dict(line.split(maxsplit=1) if not line.startswith("first") else ("first crack", line) for line in shown.stdout.splitlines())
    assert shown.returncode == 0 and shown.stderr == "", shown
    assert rows["bempd"] == bempd.version() and rows["library"] == bempd.library_path and rows["built"] == bempd.build_info()
    assert "in two at 137.35 micrometres: 560 bonds in 12 events, 0.0441 J released" in rows["first crack"]


def test_an_exception_ends_a_program_as_always():
    result = run("import conftest; scene = conftest.make_strip(progress=lambda *_: 1 / 0)\n"
                 "scene.model.run_to_separation(1e4)")
    assert result.returncode == 1 and result.stderr.rstrip().endswith("ZeroDivisionError: division by zero")


def test_an_interrupt_cancels_a_step_between_events():
    result = run("""
import conftest, signal, threading
scene = conftest.make_strip(spacing=0.0005)  # runs long enough to be met in its call
scene.model.step(50)
main, in_call = threading.get_ident(), scene.model._handle._lock

def interrupt():
    while not in_call.locked():
        pass
    signal.pthread_kill(main, signal.SIGINT)

thread = threading.Thread(target=interrupt, daemon=True)
try:
    thread.start()
    scene.model.run_to_separation(1e4)
except KeyboardInterrupt:
    print("interrupted at", scene.model.load_factor, scene.model.statistics().broken_bonds)
""")
    assert result.stdout == "interrupted at 50.0 0\n", result.stderr


def copied_package(folder):
    shutil.copytree(PACKAGE, folder / "bempd", ignore=shutil.ignore_patterns("*.so*", "__pycache__"))
    return folder


def imported(folder, **environment):
    return run("import bempd; print(bempd.library_path)", folder=folder, PYTHONPATH=str(folder), **environment)


def test_a_missing_library_is_reported_with_the_places(tmp_path):
    message = imported(copied_package(tmp_path), BEMPD_LIBRARY="").stderr.split("ImportError: ")[1]
    assert "set BEMPD_LIBRARY" in message
    for place in ("beside the module): no such file", "libbempd.so.0 (system)"):
        assert place in message


def test_a_file_beside_the_module_that_is_no_library_is_not_taken(tmp_path):
    (copied_package(tmp_path) / "bempd" / "libbempd.so.0").write_bytes(b"no library")
    assert "beside the module" in imported(tmp_path, BEMPD_LIBRARY="").stderr


def test_the_library_that_the_environment_names_comes_first(tmp_path):
    shutil.copy(bempd.library_path, copied_package(tmp_path) / "bempd" / "libbempd.so.0")
    assert imported(tmp_path, BEMPD_LIBRARY="").stdout.strip() == str(tmp_path / "bempd" / "libbempd.so.0")
    assert imported(tmp_path, BEMPD_LIBRARY=bempd.library_path).stdout.strip() == bempd.library_path


def test_a_library_that_the_environment_names_and_does_not_fit_is_an_error(tmp_path):
    # One that fits lies beside the module: it is not taken in place of the other.
    shutil.copy(bempd.library_path, copied_package(tmp_path) / "bempd" / "libbempd.so.0")
    text = tmp_path / "notes.so"
    text.write_text("no library")
    libm = next(line.split()[-1] for line in open("/proc/self/maps") if "libm.so" in line or "libm-" in line)
    for named, why in (("/nowhere/libbempd.so", "no such file"), (str(tmp_path), "no such file"),
                       (str(text), "notes.so"), (libm, "another version, it has no bempd_")):
        message = imported(tmp_path, BEMPD_LIBRARY=named).stderr
        assert f"ImportError: the environment variable BEMPD_LIBRARY names {named}" in message
        assert why in message and "or unset it" in message


def test_matplotlib_is_not_needed_until_something_is_drawn():
    result = run("import sys, bempd; print(sorted(name for name in sys.modules if name.startswith('matplotlib')))")
    assert result.stdout == "[]\n"


def test_the_version_is_the_package_s():
    text = (PACKAGE.parent / "pyproject.toml").read_text(encoding="utf-8")
    assert f'version = "{bempd.__version__}"' in text
    assert bempd.version() in bempd.build_info()
