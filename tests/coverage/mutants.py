"""Counts changes of formulas that no test notices. Each mutant changes one constant or one sign in a kernel, a fit or a law of
growth; the tests that are named for its file are built and run; a mutant survives if all of them pass.

    mutants.py [--count N] [--seed S] [--build DIRECTORY]

N mutants in all (20), drawn from all files by the seed. The working tree is changed for as long as a mutant lives, and is as it
was at the end. A mutant takes half a minute on two idle cores.
"""

from __future__ import annotations

import argparse
import pathlib
import random
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]

# Files of formulas, and the test programs that are to notice a change, some with the test of them that is to run.
FILES = {
    "src/bem/kernel_sums.cpp": ["bem_test"],
    "src/bem/crack_field.cpp": ["cracks_tests"],
    "src/elasticity/kinked_tip.cpp": ["crack_test", "cracks_tests"],
    "src/elasticity/crack_tip_field.cpp": ["elasticity_test", "cracks_tests"],
    "src/elasticity/wedge_exponent.cpp": ["elasticity_test"],
    "src/elasticity/griffith.cpp": ["crack_test", "cracks_tests"],
    "src/crack/growth_law.cpp": ["crack_test"],
    "src/crack/order.cpp": ["crack_test"],
    "src/fracture/line/williams_fit.cpp": ["fracture_test", "fracture_tests line_loads_test"],
    "src/fracture/line/line_load.cpp": ["fracture_test", "fracture_tests line_loads_test"],
    "src/pd/bond_family.cpp": ["pd_test"],
    "src/pd/micromodulus.hpp": ["pd_test"],
    "src/pd/critical_stretch.cpp": ["pd_test", "bodies_tests"],
}

NUMBER = re.compile(r"(?<![\w.])(\d+\.\d+|\d+)(?![\w.])")
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


def tests_pass(build: pathlib.Path, programs: list[str]) -> str:
    """What became of a mutant."""
    made = subprocess.run(["cmake", "--build", str(build), "--target", *(line.split()[0] for line in programs)], capture_output=True, text=True, check=False)
    if made.returncode != 0:
        return "does not compile"
    for line in programs:
        program, *arguments = line.split()
        executable = next(path for path in (build / "tests").rglob(program) if path.is_file())
        try:
            run = subprocess.run([executable, *arguments], capture_output=True, cwd=executable.parent, timeout=600, check=False)
        except subprocess.TimeoutExpired:
            return "noticed: no end"
        if run.returncode != 0:
            return f"noticed by {line}"
    return "SURVIVES"


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("--count", type=int, default=20)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/ci")
    given = parser.parse_args()
    every = [(file, place) for file in FILES for place in places((ROOT / file).read_text(encoding="utf-8"))]
    drawn = random.Random(given.seed).sample(every, min(given.count, len(every)))
    count = {"SURVIVES": 0, "does not compile": 0}
    for file, (start, end, changed) in drawn:
        path = ROOT / file
        text = path.read_text(encoding="utf-8")
        try:
            path.write_text(text[:start] + changed + text[end:], encoding="utf-8")
            fate = tests_pass(given.build, FILES[file])
        finally:
            path.write_text(text, encoding="utf-8")
        line = text.count("\n", 0, start) + 1
        print(f"{file}:{line}: {text[start:end]} -> {changed}: {fate}", flush=True)
        count[fate] = count.get(fate, 0) + 1
    tried = len(drawn) - count["does not compile"]
    print(f"{count['SURVIVES']} of {tried} mutants survive, of {len(every)} possible ones")
    return 0


if __name__ == "__main__":
    sys.exit(main())
