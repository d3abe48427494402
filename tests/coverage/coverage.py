"""Branch coverage of src by all tests.

    coverage.py run     builds everything with clang's counters, runs the tests, prints the table and stores it (11 minutes on two idle cores)
    coverage.py count   the same from the counters of the last run of tests
    coverage.py names   stores rows without numbers for new files of src, and none for files that are gone
    coverage.py check   the stored table has the present files, and each gate is kept and not lowered
    coverage.py print   the stored table by folders

The table is coverage.csv: for each file of src the directions of its branches, as llvm-cov counts them, and those that tests took.
"""

from __future__ import annotations

import csv
import json
import math
import os
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = ROOT / "build/coverage"
TABLE = pathlib.Path(__file__).with_name("coverage.csv")

# Least share of branches that tests take, in per cent: of all files, and of folders whose answers hosts trust first, the default
# crack rule, contact and tips. A gate may be raised, not lowered: it follows the stored share by so much at most.
SLACK = 3
GATES = {"src": 90, "src/crack": 92, "src/fracture/line": 92, "src/fracture/contact": 93, "src/regions/tips": 93}


def files() -> list[str]:
    return sorted(str(file.relative_to(ROOT)) for file in (ROOT / "src").rglob("*.cpp"))


def stored() -> dict[str, tuple[int, int]]:
    with open(TABLE, encoding="utf-8") as table:
        return {row["file"]: (int(row["branches"]), int(row["taken"])) for row in csv.DictReader(table)}


def share(counts: dict[str, tuple[int, int]], folder: str) -> tuple[int, float]:
    inside = [count for file, count in counts.items() if file.startswith(folder + "/")]
    branches, taken = sum(b for b, _ in inside), sum(t for _, t in inside)
    return branches, 100 * taken / branches if branches else 100.0


def show(counts: dict[str, tuple[int, int]]) -> None:
    folders = sorted({str(pathlib.Path(file).parent) for file in counts} | {"src"})
    print(f"{'folder':28} {'branches':>9} {'taken':>7}")
    for folder in folders:
        branches, taken = share(counts, folder)
        print(f"{folder:28} {branches:9} {taken:6.1f} %")


def run_tests() -> None:
    profiles = BUILD / "profiles"
    subprocess.run(["cmake", "--preset", "coverage"], cwd=ROOT, check=True)
    subprocess.run(["cmake", "--build", "--preset", "coverage", "-j", str(os.cpu_count())], cwd=ROOT, check=True)
    profiles.mkdir(exist_ok=True)
    for old in profiles.glob("*.profraw"):
        old.unlink()
    subprocess.run(["ctest", "--preset", "coverage", "-j", str(os.cpu_count())], cwd=ROOT, check=False,
                   env={**os.environ, "LLVM_PROFILE_FILE": str(profiles / "%4m.profraw")})


def counted() -> dict[str, tuple[int, int]]:
    profiles, merged = BUILD / "profiles", BUILD / "merged.profdata"
    subprocess.run(["llvm-profdata", "merge", "--sparse", "-o", merged, *map(str, profiles.glob("*.profraw"))], check=True)
    library = next((BUILD / "src/capi").glob("libbempd.so.*.*.*"))
    programs = [path for path in (BUILD / "tests").rglob("*") if path.is_file() and os.access(path, os.X_OK) and path.suffix == ""]
    others = [*BUILD.rglob("libbempd_mpi.so.*.*.*"), *programs]
    objects = [argument for path in others for argument in ("-object", str(path))]
    text = subprocess.run(["llvm-cov", "export", "--summary-only", f"--instr-profile={merged}", str(library), *objects],
                          check=True, capture_output=True, text=True).stdout
    counts = {}
    for file in json.loads(text)["data"][0]["files"]:
        name = pathlib.Path(file["filename"])
        if name.is_relative_to(ROOT / "src") and name.suffix == ".cpp":
            branches = file["summary"]["branches"]
            counts[str(name.relative_to(ROOT))] = (branches["count"], branches["covered"])
    return counts


def store(counts: dict[str, tuple[int, int]]) -> None:
    with open(TABLE, "w", encoding="utf-8", newline="") as table:
        writer = csv.writer(table, lineterminator="\n")
        writer.writerow(["file", "branches", "taken"])
        writer.writerows([file, *counts.get(file, (0, 0))] for file in files())


def check(counted_now: bool = False) -> int:
    counts, wrong = stored(), []
    missing, gone = set(files()) - set(counts), set(counts) - set(files())
    for what, names in (("has no row for", missing), ("has a row for a file that is gone:", gone)):
        wrong += [f"tests/coverage/coverage.csv {what} {name}; `coverage.py names` mends it" for name in sorted(names)]
    for folder, gate in GATES.items():
        _, taken = share(counts, folder)
        if taken < gate:
            wrong.append(f"tests take {taken:.1f} % of the branches of {folder}, less than the gate of {gate} %")
        if gate < math.floor(taken) - SLACK and not counted_now:
            wrong.append(f"the gate of {folder} is {gate} %, and tests take {taken:.1f} %: raise it")
    print("\n".join(wrong) or "the stored table has the present files, and all gates are kept")
    return int(bool(wrong))


def main() -> int:
    task = sys.argv[1] if len(sys.argv) > 1 else "print"
    if task == "run":
        run_tests()
    if task in ("run", "count"):
        store(counted())
        show(stored())
        return check(counted_now=True)
    if task == "names":
        store(stored())
        return 0
    if task == "check":
        return check()
    show(stored())
    return 0


if __name__ == "__main__":
    sys.exit(main())
