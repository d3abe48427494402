"""A wheel with the library that BEMPD_LIBRARY names works where nothing else is.

    python_wheel.py SOURCE_TREE WORK_FOLDER

The package is built without network, installed into a fresh environment, and a program runs there in an empty folder.
"""

import os
import pathlib
import shutil
import subprocess
import sys
import zipfile

source_tree, work = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])
shutil.rmtree(work, ignore_errors=True)
empty = work / "empty folder"
empty.mkdir(parents=True)

# A copy, since setuptools leaves files in the folder that it builds.
package = shutil.copytree(source_tree / "bindings" / "python", work / "package",
                          ignore=shutil.ignore_patterns("__pycache__", "build", "*.egg-info"))
# What builds the library starts as many compilers as there are processors, or as it is told.
seen = work / "cmake calls"
(work / "bin").mkdir()
(work / "bin" / "cmake").write_text(f'#!/bin/sh\necho "$@" >>"{seen}"\n')
(work / "bin" / "cmake").chmod(0o755)
for level, expected in ((None, None), ("3", "3")):
    seen.unlink(missing_ok=True)
    building = {**os.environ, "PATH": f"{work / 'bin'}:{os.environ['PATH']}", **({"CMAKE_BUILD_PARALLEL_LEVEL": level} if level else {})}
    building.pop("BEMPD_LIBRARY", None)
    failed = subprocess.run([sys.executable, source_tree / "bindings/python/setup.py", "-q", "build_py", "-d", work / "nothing"],
                            cwd=source_tree / "bindings/python", env=building, capture_output=True, text=True)
    assert "there is no shared library" in failed.stderr, failed.stderr
    number = seen.read_text().split("--parallel")[1].split()[0]
    assert number == expected if expected else 1 <= int(number) <= len(os.sched_getaffinity(0)), number
shutil.rmtree(source_tree / "bindings/python/build", ignore_errors=True)

pip = ["-m", "pip", "--disable-pip-version-check", "--quiet"]
subprocess.run([sys.executable, *pip, "wheel", "--no-build-isolation", "--no-deps", "--no-index", "-w", work, package],
               check=True, cwd=empty)
wheels = list(work.glob("*.whl"))
assert len(wheels) == 1, wheels
assert wheels[0].name.startswith("bempd-") and "-py3-none-linux_" in wheels[0].name, wheels[0].name
names = zipfile.ZipFile(wheels[0]).namelist()
for name in ("bempd/libbempd.so.0", "bempd/py.typed", "bempd/_cdef.py", "bempd/plot.py"):
    assert name in names, (name, names)

# The environment below has no path to the source or build tree.
environment = {name: value for name, value in os.environ.items() if name not in ("PYTHONPATH", "BEMPD_LIBRARY")}
subprocess.run([sys.executable, "-m", "venv", "--system-site-packages", work / "venv"], check=True, env=environment)
python = work / "venv" / "bin" / "python"
subprocess.run([python, *pip, "install", "--no-deps", "--no-index", wheels[0]], check=True, cwd=empty, env=environment)
shutil.rmtree(package)
program = (source_tree / "examples" / "first_crack" / "main.py").read_text(encoding="utf-8")
program += "\nimport bempd\nprint(bempd.library_path)\n"
printed = subprocess.run([python, "-c", program], check=True, cwd=empty, env=environment, capture_output=True,
                         text=True)
line, library = printed.stdout.splitlines()
print(line, library, sep="\n")
assert line.startswith("in two at ")
assert pathlib.Path(library).is_relative_to(work / "venv"), library
