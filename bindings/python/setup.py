"""Puts the shared library into the wheel: the one that BEMPD_LIBRARY names, else one that CMake builds here.

CMAKE_ARGS is handed to CMake, for example CMAKE_ARGS="-D BEMPD_LINALG=eigen".
"""

import os
import pathlib
import shlex
import shutil
import subprocess
import sys

from setuptools import Distribution, setup
from setuptools.command.build_py import build_py
from wheel.bdist_wheel import bdist_wheel

SOURCE_TREE = pathlib.Path(__file__).resolve().parents[2]
# Must be the name that bempd/_library.py looks for beside itself.
SONAME = "libbempd.0.dylib" if sys.platform == "darwin" else "libbempd.so.0"


def compilers():
    """As many as the processors that this process may use, and one for each gigabyte of memory, at most: without a
    number some generators start all of them at once. CMAKE_BUILD_PARALLEL_LEVEL says otherwise."""
    chosen = os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL", "")
    if chosen.isdigit() and int(chosen) > 0:
        return int(chosen)
    memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    processors = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    return max(1, min(processors, memory // 2**30))


def built_library(build_folder):
    """The shared library, built from the source tree around this folder."""
    if not (SOURCE_TREE / "include" / "bempd.h").is_file():
        raise SystemExit("this folder is not in bempd's source tree; set BEMPD_LIBRARY to a built libbempd.so")
    subprocess.check_call(["cmake", "-S", str(SOURCE_TREE), "-B", str(build_folder), "-D", "CMAKE_BUILD_TYPE=Release",
                           "-D", "BEMPD_BUILD_TESTS=OFF", "-D", "BEMPD_BUILD_EXAMPLES=OFF",
                           *shlex.split(os.environ.get("CMAKE_ARGS", ""))])
    subprocess.check_call(["cmake", "--build", str(build_folder), "--target", "bempd", "--parallel",
                           str(compilers())])
    return build_folder / "src" / "capi" / SONAME


class BuildWithLibrary(build_py):
    def run(self):
        super().run()
        given = os.environ.get("BEMPD_LIBRARY")
        build_folder = pathlib.Path(self.get_finalized_command("build").build_temp).resolve() / "cmake"
        library = pathlib.Path(given) if given else built_library(build_folder)
        if not library.is_file():
            raise SystemExit(f"there is no shared library {library}; set BEMPD_LIBRARY to a built libbempd.so")
        shutil.copyfile(library, pathlib.Path(self.build_lib) / "bempd" / SONAME)


class PlatformWheel(bdist_wheel):
    """For one platform, but for every Python 3: nothing is compiled against the interpreter."""

    def get_tag(self):
        return ("py3", "none", super().get_tag()[2])


class PlatformDistribution(Distribution):
    def has_ext_modules(self):
        return True


setup(distclass=PlatformDistribution, cmdclass={"build_py": BuildWithLibrary, "bdist_wheel": PlatformWheel})
