"""A wheel with the library that BEMPD_LIBRARY names works where nothing else is.

    python_wheel.py SOURCE_TREE WORK_FOLDER

The package is built without network by the pip of a fresh environment, installed there, and a program runs there in an
empty folder. What the library in it links is listed, because it decides the licence of the whole.
"""

import os
import pathlib
import re
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

# A user who has Debian's packages and a fresh environment of them builds and installs in it.
subprocess.run([sys.executable, "-m", "venv", "--system-site-packages", work / "venv"], check=True)
python = work / "venv" / "bin" / "python"
pip = [python, "-m", "pip", "--disable-pip-version-check", "--quiet"]
subprocess.run([*pip, "wheel", "--no-build-isolation", "--no-deps", "--no-index", "-w", work, package], check=True, cwd=empty)
wheels = list(work.glob("*.whl"))
assert len(wheels) == 1, wheels
assert wheels[0].name.startswith("bempd-") and "-py3-none-linux_" in wheels[0].name, wheels[0].name
wheel = zipfile.ZipFile(wheels[0])
names = wheel.namelist()
for name in ("bempd/libbempd.so.0", "bempd/py.typed", "bempd/_cdef.py", "bempd/plot.py", "bempd/__main__.py"):
    assert name in names, (name, names)

# Nothing from here on points to the source or build tree.
environment = {name: value for name, value in os.environ.items() if name not in ("PYTHONPATH", "BEMPD_LIBRARY")}
subprocess.run([*pip, "install", "--no-deps", "--no-index", wheels[0]], check=True, cwd=empty, env=environment)

# The wheel carries bempd's library and no other: the system has what that one links.
library = next((work / "venv").rglob("libbempd.so.0"))
dynamic = subprocess.run(["readelf", "-d", library], check=True, capture_output=True, text=True).stdout
linked = re.findall(r"\(NEEDED\).*\[(.+)\]", dynamic)
print("links", *linked)
SYSTEM = r"lib(c|m|stdc\+\+|gcc_s|pthread|gomp)\.so\.\d+|ld-linux.*|lib(openblas|blas|lapack|mkl_rt|flexiblas).*\.so.*"
SUITESPARSE = r"lib(cholmod|umfpack|amd|suitesparseconfig|colamd|ccolamd|camd)\.so\.\d+"
for name in linked:
    assert re.fullmatch(f"{SYSTEM}|{SUITESPARSE}", name), f"{name} is linked; say where users get it, and under which licence"
said = subprocess.run([python, "-m", "bempd"], check=True, cwd=empty, env=environment, capture_output=True, text=True).stdout
assert "in two at " in said and any(re.fullmatch(SUITESPARSE, name) for name in linked) == ("factorization suitesparse" in said), said
metadata = wheel.read(next(name for name in names if name.endswith("/METADATA"))).decode()
assert "GPL" in metadata and "eigen" in metadata, "the wheel has to say what SuiteSparse means for its licence"
shutil.rmtree(package)
program = (source_tree / "examples" / "first_crack" / "main.py").read_text(encoding="utf-8")
program += "\nimport bempd\nprint(bempd.library_path)\n"
printed = subprocess.run([python, "-c", program], check=True, cwd=empty, env=environment, capture_output=True,
                         text=True)
line, library = printed.stdout.splitlines()
print(line, library, sep="\n")
assert line.startswith("growth at ")
assert pathlib.Path(library).is_relative_to(work / "venv"), library
