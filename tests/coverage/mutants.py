"""Counts changes of formulas that no test notices. Each mutant changes one constant or one sign in a kernel, a fit or a law of
growth; the tests that are named for its file are built and run; a mutant survives if all of them pass.

    mutants.py [--count N] [--seed S] [--jobs J] [--build DIRECTORY]

N mutants in all (20), drawn from all files by the seed. The working tree is changed for as long as a mutant lives, and is as it
was at the end. The build (build/mutants) is configured here: the listed files are compiled alone, the others together.
"""

from __future__ import annotations

import argparse
import os
import pathlib
import random
import re
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]

# Files of formulas, and the test programs that are to notice a change, some with the test of them that is to run.
FILES = {
    "src/bem/kernel_sums.cpp": ["bem_test"],
    "src/bem/singular_pairs.cpp": ["bem_test"],
    "src/bem/crack_field.cpp": ["bem_test", "cracks_tests crack_operator_test"],
    "src/bem/crack_tips.cpp": ["cracks_tests crack_factors_test"],
    "src/elasticity/kinked_tip.cpp": ["crack_test", "cracks_tests crack_kinks_test"],
    "src/elasticity/crack_tip_field.cpp": ["elasticity_test"],
    "src/elasticity/wedge_exponent.cpp": ["elasticity_test"],
    "src/elasticity/griffith.cpp": ["crack_test"],
    "src/crack/growth_law.cpp": ["crack_test"],
    "src/crack/order.cpp": ["crack_test"],
    "src/crack/cycle_program.cpp": ["crack_test"],
    "src/crack/cycle_step.cpp": ["crack_test"],
    "src/crack/laws/forman.hpp": ["crack_test"],
    "src/crack/laws/nasgro.hpp": ["crack_test"],
    "src/crack/laws/paris_walker.hpp": ["crack_test"],
    "src/crack/laws/rate_parameters.cpp": ["crack_test"],
    "src/crack/laws/resistance_curve.cpp": ["crack_test"],
    "src/crack/laws/resistance_directions.cpp": ["crack_test"],
    "src/crack/laws/retardation.hpp": ["crack_test"],
    "src/coupling/motion_resistance.cpp": ["coupling_test", "fracture_tests fracture_fragments_test"],
    "src/coupling/stiffness_assembly.cpp": ["coupling_test", "cracks_tests contact_test"],
    "src/fracture/contact/crack_faces.cpp": ["cracks_tests contact_test"],
    "src/fracture/contact/gap_rule.cpp": ["cracks_tests contact_test"],
    "src/fracture/line/line_load.cpp": ["fracture_test"],
    "src/fracture/line/point_moments.cpp": ["regions_tests regions_tip_fit_test"],
    "src/fracture/line/tip_stress.cpp": ["regions_tests regions_tip_fit_test", "fracture_tests line_loads_test"],
    "src/fracture/line/williams_fit.cpp": ["fracture_test"],
    "src/pd/bond_family.cpp": ["pd_test"],
    "src/pd/micromodulus.hpp": ["pd_test"],
    "src/pd/critical_stretch.cpp": ["pd_test"],
    "src/regions/shared_reactions.cpp": ["coupling_tests edge_reaction_test"],
    "src/regions/tips/tip_rings.cpp": ["regions_tests regions_tip_fit_test", "fracture_tests lattice_tips_test"],
}

NUMBER = re.compile(r"(?<![\w.])(?<!\de[-+])(\d+\.\d+|\d+)(?![\w.])")
SIGN = re.compile(r"(?<=[\w\)\]] )[+-](?= [\w\(])")


def places(text: str) -> list[tuple[int, int, str]]:
    """Start, end and replacement of every change, outside of comments, includes and strings."""
    found, start = [], 0
    for line in text.splitlines(keepends=True):
        code = line.split("//")[0]
        if not code.lstrip().startswith("#") and '"' not in code:
            for match in NUMBER.finditer(code):
                number = match[0]
                changed = f"{float(number) * 1.25 + 0.01:g}" if "." in number else str(int(number) + 1)
                found.append((start + match.start(), start + match.end(), changed))
            for match in SIGN.finditer(code):
                found.append((start + match.start(), start + match.end(), "-" if match[0] == "+" else "+"))
        start += len(line)
    return found


def prepare(build: pathlib.Path) -> None:
    """Configures a build in which each file of the list is compiled alone and the others together."""
    together = ["-D", "BEMPD_COMPILE_TOGETHER=ON", "-D", f"CMAKE_PROJECT_INCLUDE={ROOT / 'tests/coverage/mutants.cmake'}"]
    alone = ["-D", "BEMPD_ALONE=" + ";".join(str(ROOT / file) for file in FILES if file.endswith(".cpp"))]
    unused = [f"-DBEMPD_{part}=OFF" for part in ("BUILD_EXAMPLES", "MPI", "SCHEME_PAPER", "WARNINGS_AS_ERRORS")]
    options = [*together, *alone, "-D", "CMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG", *unused]
    subprocess.run(["cmake", "--preset", "ci", "-B", str(build), *options], cwd=ROOT, check=True, capture_output=True)


def built(build: pathlib.Path, programs: list[str], jobs: int) -> bool:
    targets = [line.split()[0] for line in programs]
    command = ["cmake", "--build", str(build), "-j", str(jobs), "--target", *targets]
    return subprocess.run(command, capture_output=True, check=False).returncode == 0


def passes(build: pathlib.Path, line: str, at_most: float | None = None) -> bool:
    program, *arguments = line.split()
    executable = next(path for path in (build / "tests").rglob(program) if path.is_file())
    environment = os.environ | {"GTEST_FAIL_FAST": "1"}
    run = subprocess.run([executable, *arguments], capture_output=True, cwd=executable.parent, env=environment, timeout=at_most, check=False)
    return run.returncode == 0


def seconds_of(build: pathlib.Path, line: str) -> float:
    """How long a test takes that has to pass."""
    begun = time.monotonic()
    if not passes(build, line):
        sys.exit(f"{line} fails without any mutant")
    return time.monotonic() - begun


def fate_of(build: pathlib.Path, programs: list[str], seconds: dict[str, float], jobs: int) -> str:
    for line in programs:
        if not built(build, [line], jobs):
            return "does not compile"
        try:
            if not passes(build, line, 60 + 10 * seconds[line]):
                return f"noticed by {line}"
        except subprocess.TimeoutExpired:
            return f"noticed by {line}, which does not end"
    return "SURVIVES"


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("--count", type=int, default=20)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/mutants")
    given = parser.parse_args()
    every = [(file, place) for file in FILES for place in places((ROOT / file).read_text(encoding="utf-8"))]
    drawn = random.Random(given.seed).sample(every, min(given.count, len(every)))
    prepare(given.build)
    programs = sorted({line for file, _ in drawn for line in FILES[file]})
    if not built(given.build, programs, given.jobs):
        sys.exit("the tests do not compile without any mutant")
    seconds = {line: seconds_of(given.build, line) for line in programs}
    count = {"SURVIVES": 0, "does not compile": 0}
    for file, (start, end, changed) in drawn:
        path = ROOT / file
        text = path.read_text(encoding="utf-8")
        try:
            path.write_text(text[:start] + changed + text[end:], encoding="utf-8")
            fate = fate_of(given.build, FILES[file], seconds, given.jobs)
        finally:
            path.write_text(text, encoding="utf-8")
        line, column = text.count("\n", 0, start) + 1, start - text.rfind("\n", 0, start)
        print(f"{file}:{line}:{column}: {text[start:end]} -> {changed}: {fate}", flush=True)
        count[fate] = count.get(fate, 0) + 1
    tried = len(drawn) - count["does not compile"]
    print(f"{count['SURVIVES']} of {tried} mutants survive, of {len(every)} possible ones")
    return 0


if __name__ == "__main__":
    sys.exit(main())
