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


def test_a_missing_library_is_reported_with_the_places(tmp_path):
    shutil.copytree(PACKAGE, tmp_path / "bempd", ignore=shutil.ignore_patterns("*.so*", "__pycache__"))
    result = run("import bempd", folder=tmp_path, PYTHONPATH=str(tmp_path), BEMPD_LIBRARY="/nowhere/libbempd.so")
    message = result.stderr.split("ImportError: ")[1]
    assert "set BEMPD_LIBRARY" in message
    for place in ("beside the module): no such file", "/nowhere/libbempd.so (environment variable BEMPD_LIBRARY)",
                  "libbempd.so.0 (system)"):
        assert place in message


def test_a_library_that_is_another_is_not_taken(tmp_path):
    shutil.copytree(PACKAGE, tmp_path / "bempd", ignore=shutil.ignore_patterns("*.so*", "__pycache__"))
    (tmp_path / "bempd" / "libbempd.so.0").write_bytes(b"no library")
    result = run("import bempd; print(bempd.library_path)", folder=tmp_path, PYTHONPATH=str(tmp_path),
                 BEMPD_LIBRARY=bempd.library_path)
    assert result.stdout.strip() == bempd.library_path
    libm = next(line.split()[-1] for line in open("/proc/self/maps") if "libm.so" in line or "libm-" in line)
    result = run("import bempd", folder=tmp_path, PYTHONPATH=str(tmp_path), BEMPD_LIBRARY=libm)
    assert "another version, it has no bempd_" in result.stderr


def test_matplotlib_is_not_needed_until_something_is_drawn():
    result = run("import sys, bempd; print(sorted(name for name in sys.modules if name.startswith('matplotlib')))")
    assert result.stdout == "[]\n"


def test_the_version_is_the_package_s():
    text = (PACKAGE.parent / "pyproject.toml").read_text(encoding="utf-8")
    assert f'version = "{bempd.__version__}"' in text
    assert bempd.version() in bempd.build_info()
