#!/usr/bin/env python3
"""Shows that a change left the results of the examples alone: compares every number of every summary.csv.

    tests/same_results.py BEFORE AFTER [--tolerance 1e-9] [--all-schemes]

BEFORE and AFTER are each a build tree, whose examples are run in a temporary folder, or a folder with results, such as
`out` after examples/run.sh. For example, with the commit before in a worktree of its own, built by the preset ci:

    tests/same_results.py ../before/build/ci build/ci

prints for every example how many numbers were compared and the largest relative difference, and where it is. Columns and
rows of seconds are left out. Two numbers that are both below 1e-8 are what rounding leaves of a zero (errors of the exact
linear field, energy balance, residual), and count as the same; tests/claims.json holds those to bounds. Of build trees the
programs without a summary (the first program in C and Fortran, the testing machine) must print the same lines. The exit
code is 1 when a number differs by more than the tolerance, a text differs, or a row is in one of the two only.

Scheme paper takes minutes for the examples with cracks, so these run the scheme symmetric alone without --all-schemes.
"""

import argparse
import csv
import os
import pathlib
import subprocess
import sys
import tempfile

ROUNDING = 1e-8
SECONDS = "seconds"
SLOW_WITH_PAPER = ("centre_crack", "mixed_mode_crack", "two_edge_cracks")
PRINTED = "printed"


def run_examples(tree, folder, all_schemes):
    """Runs the examples of a build tree in `folder`; what those without a summary print goes to a file beside."""
    programs = sorted(path for path in (tree / "examples").glob("example_*") if os.access(path, os.X_OK))
    if not programs:
        raise SystemExit(f"{tree} is neither a folder with summaries nor a build tree with examples")
    for program in programs:
        name = program.name.removeprefix("example_")
        out = folder / "out" / name
        out.mkdir(parents=True)
        schemes = ["symmetric"] if name in SLOW_WITH_PAPER and not all_schemes else []
        print(f"  {program} {' '.join(schemes)}", flush=True)
        done = subprocess.run([program.resolve(), *schemes], cwd=folder, capture_output=True, text=True)
        if done.returncode != 0:
            raise SystemExit(f"{program} failed ({done.returncode}):\n{done.stdout}{done.stderr}")
        if not (out / "summary.csv").exists():
            (out / PRINTED).write_text(done.stdout, encoding="utf-8")
    return folder / "out"


def rows_of(file):
    """Row by example, case, scheme and quantity; without columns and rows of seconds."""
    with open(file, newline="", encoding="utf-8") as text:
        for row in csv.DictReader(text):
            if not row["quantity"].startswith(SECONDS):
                key = " / ".join(row[name] for name in ("case", "scheme", "quantity"))
                yield key, {name: cell for name, cell in row.items() if SECONDS not in name}


def results_of(out):
    """Example -> place -> cell, the place being a row and a column of the summary or a printed line."""
    results = {}
    for file in sorted(out.glob("*/summary.csv")):
        results[file.parent.name] = {f"{key}: {name}": cell for key, row in rows_of(file) for name, cell in row.items()}
    for file in sorted(out.glob(f"*/{PRINTED}")):
        lines = file.read_text(encoding="utf-8").splitlines()
        results[file.parent.name] = {f"line {number}": line for number, line in enumerate(lines, 1)}
    return results


def number(cell):
    try:
        return float(cell)
    except ValueError:
        return None


def difference(before, after):
    """Relative difference of two cells; infinite where texts differ."""
    if before == after:
        return 0.0
    a, b = number(before), number(after)
    if a is None or b is None or a != a or b != b:
        return float("inf")
    size = max(abs(a), abs(b))
    return 0.0 if size < ROUNDING else abs(a - b) / size


def compare(before, after, tolerance):
    """Prints a line for each example; the largest difference of all."""
    largest = 0.0
    for example in sorted(before.keys() | after.keys()):
        old, new = before.get(example, {}), after.get(example, {})
        worst, where = 0.0, ""
        for place in old.keys() | new.keys():
            found = difference(old[place], new[place]) if place in old and place in new else float("inf")
            if found > worst:
                worst, where = found, f" at {place}: {old.get(place, 'nothing')} -> {new.get(place, 'nothing')}"
        compared = sum(number(cell) is not None for cell in old.values())
        verdict = "same" if worst <= tolerance else "DIFFERS"
        print(f"{example:22} {compared:4} numbers, {len(old) - compared:4} texts: largest difference {worst:.3g} {verdict}{where}")
        largest = max(largest, worst)
    return largest


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("before", type=pathlib.Path, help="build tree, or folder with <example>/summary.csv")
    parser.add_argument("after", type=pathlib.Path, help="the same after the change")
    parser.add_argument("--tolerance", type=float, default=1e-9, help="largest relative difference that is the same")
    parser.add_argument("--all-schemes", action="store_true", help="scheme paper in the examples with cracks too")
    options = parser.parse_args()
    results = []
    with tempfile.TemporaryDirectory() as work:
        for name, given in (("before", options.before), ("after", options.after)):
            folder = pathlib.Path(work) / name
            out = given if any(given.glob("*/summary.csv")) else run_examples(given, folder, options.all_schemes)
            results.append(results_of(out))
    largest = compare(*results, options.tolerance)
    print(f"largest relative difference {largest:.3g}, tolerance {options.tolerance:g}")
    sys.exit(largest > options.tolerance)


if __name__ == "__main__":
    main()
