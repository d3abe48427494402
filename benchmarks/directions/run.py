"""What turns a crack: every candidate on one table, into out/directions/ and docs/directions.md.

    run.py [--jobs N] [--only WORD] [--lines] [--table]    --table: from what is there; --lines: the library's own lines only;
                                                           --only: jobs with this word, and the first table's rows of them

A strip between clamps, the crack along its middle, the lattice turned under it; and a disc about a crack tip in mixed
mode. Results are kept line by line in results.csv: what is there is not run again."""

from __future__ import annotations

import argparse
import concurrent.futures
import os
import pathlib
import subprocess
import sys

import lines as own_lines
import report

OUT = pathlib.Path(os.environ.get("BEMPD_OUTPUT", "out/directions"))
PROGRAM = pathlib.Path(os.environ.get("BEMPD_BENCHMARKS", "build/release/benchmarks")) / "bempd_directions"
BONDS = ["stretch:name=stretch", "stretch:scatter=0.1:name=scatter-10", "stretch:scatter=0.2:name=scatter-20",
         "bond:radius=0.5:mix=0.5:name=half-mean-strain", "facet:radius=0.5:name=facet"]
RELEASE = ["stretch:release=1:name=release", "stretch:release=1:even=1:name=release-even",
           "stretch:release=1:scatter=0.1:name=release-scatter-10"]
EVEN = ["stretch:even=1:name=even"]
SOFT = ["stretch:teeth=6:ductility=4:name=softening-4"]
AHEAD = "line:turn=ahead:radius=1.5:cone=0.5:opening=0.79:shear=0.482"
FIELD = AHEAD + ":load=field:inner=1:outer=3"
BEST = [FIELD + ":learn=8:name=line-field-learn", FIELD + ":name=line-field"]
LINES = [AHEAD + ":look=3:name=line-release-3", AHEAD + ":look=6:name=line-release-6", AHEAD + ":load=ahead:name=line-ahead",
         "line:turn=stress:radius=1:smooth=1:look=6:name=line-principal", "line:turn=release:look=4:name=line-most-release",
         "line:turn=williams:radius=2:load=williams:name=line-williams"]


def jobs() -> list[tuple]:
    """(scene, m, angle, mode, seed, points, kernel, rules)."""
    found = []
    for seed in range(1, 9):
        for m in (3, 4):
            for angle in (0, 7.5, 15, 22.5, 30, 45):
                found.append(("narrow", m, angle, 0, seed, "lattice", "quartic", BEST))
    for incline in (15, 30, 45, 60, 75):
        for m in (3, 4):
            for angle in (0, 20):
                found.append(("plate", m, angle, incline, 1, "lattice", "quartic", BEST[:1] + BONDS[:1]))
    for seed in (1, 2):
        for m in (5, 6):
            for angle in (0, 15, 30, 45):
                found.append(("narrow", m, angle, 0, seed, "lattice", "quartic", BEST[:1]))
    for seed in range(1, 5):
        for m in (3, 4):
            for angle in (10, 30):
                for mode in (15, 30, 45, 60, 75):
                    found.append(("disc", m, angle, mode, seed, "lattice", "quartic", BEST[:1] + LINES[1:2] + BONDS[:1]))
    for seed in range(1, 5):
        for m in (3, 4):
            for angle in (0, 7.5, 15, 22.5, 30, 45):
                found.append(("narrow", m, angle, 0, seed, "lattice", "quartic", LINES))
    for seed in range(1, 5):
        for m in (3, 4):
            for angle in (10, 20):
                found.append(("strip", m, angle, 0, seed, "lattice", "quartic", BONDS))
                found.append(("strip", m, angle, 0, seed, "jitter=0.35", "quartic", BONDS[:1]))
                found.append(("strip", m, angle, 0, seed, "lattice", "conical", BONDS[:1]))
                found.append(("strip", m, angle, 0, seed, "lattice", "gauss", BONDS[:1]))
    for m in (3, 4):
        for angle, seed in [(a, s) for s in (1, 2, 3, 4) for a in (10, 20)] + [(a, 1) for a in (0, 15, 22.5, 30, 45)]:
            found.append(("strip", m, angle, 0, seed, "lattice", "quartic", RELEASE + EVEN + BONDS[:1]))
        for seed in (1, 2, 3, 4):
            for angle in (10, 20):
                found.append(("strip", m, angle, 0, seed, "jitter=0.35", "quartic", RELEASE[:1] + BONDS[:1]))
        for seed in (1, 2):
            found.append(("strip", m, 0, 0, seed, "lloyd=4", "quartic", RELEASE[:1]))
    for seed in (1, 2):
        for m in (2, 3, 4, 5, 6, 7):
            for angle in (0, 15, 22.5, 30, 45):
                found.append(("strip", m, angle, 0, seed, "lattice", "quartic", BONDS[:1]))
    for seed in range(1, 9):
        for m in (3, 4):
            found.append(("strip", m, 0, 0, seed, "lloyd=4", "quartic", BONDS[:2]))
    for seed in range(1, 5):
        for m in (3, 4):
            for angle in (10, 20):
                found.append(("strip", m, angle, 0, seed, "lattice", "quartic", SOFT))
            found.append(("strip", m, 0, 0, seed, "lloyd=4", "quartic", SOFT))
    return found


def key(scene, m, angle, mode, seed, points, kernel, rule) -> str:
    return f"{scene},{points},{kernel},{rule},{m},{angle},{mode},{seed}"


def name_of(rule: str) -> str:
    return next((part[5:] for part in rule.split(":") if part.startswith("name=")), rule)


def done(file: pathlib.Path) -> set[str]:
    if not file.exists():
        return set()
    return {",".join(line.split(",")[:8]) for line in file.read_text().splitlines()}


def run(job: tuple, have: set[str]) -> list[str]:
    scene, m, angle, mode, seed, points, kernel, rules = job
    wanted = [r for r in rules if key(scene, m, angle, mode, seed, points, kernel, name_of(r)) not in have]
    if not wanted:
        return []
    paths = OUT / f"paths-{os.getpid()}-{id(job)}.txt"
    answer = subprocess.run([PROGRAM, scene, str(m), str(angle), str(mode), str(seed), points, kernel, paths, *wanted],
                            capture_output=True, text=True)
    lines = []
    for line in answer.stdout.splitlines():
        part = line.split(",")
        lines.append(key(scene, m, angle, mode, seed, points, kernel, part[0]) + "," + ",".join(part[5:]))
    if paths.exists():
        with open(OUT / "paths.txt", "a", encoding="ascii") as file:
            file.write("".join(f"{scene} {line}\n" for line in paths.read_text().splitlines()))
        paths.unlink()
    return lines


def main() -> None:
    options = argparse.ArgumentParser()
    options.add_argument("--jobs", type=int, default=1)
    options.add_argument("--only", default="")
    options.add_argument("--table", action="store_true")
    options.add_argument("--lines", action="store_true")
    options = options.parse_args()
    OUT.mkdir(parents=True, exist_ok=True)
    if options.lines or not options.only:
        if not options.table:
            own_lines.run(OUT, options.jobs, options.only)
        report.put(own_lines.tables(OUT))
    if options.lines:
        return
    file = OUT / "results.csv"
    have = done(file)
    chosen = [job for job in jobs() if options.only in str(job)]
    if options.table:
        chosen = []
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for lines in pool.map(lambda job: run(job, have), chosen):
            if lines:
                with open(file, "a", encoding="ascii") as table:
                    table.write("\n".join(lines) + "\n")
    cuts = subprocess.run([PROGRAM, "check"], stdout=subprocess.PIPE, text=True, check=True).stdout
    (OUT / "cuts.csv").write_text(cuts, encoding="ascii")
    if options.only:
        report.put(report.straight_and_cuts(OUT))
        return
    references = OUT / "boundary_paths.txt"
    if not references.exists():
        answer = subprocess.run([sys.executable, pathlib.Path(__file__).with_name("boundary_path.py"), "15", "30", "45", "60", "75"],
                                capture_output=True, text=True, check=True)
        references.write_text(answer.stdout, encoding="ascii")
    report.write(OUT)


if __name__ == "__main__":
    main()
