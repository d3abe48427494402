"""Beyond one process: one body by MUMPS, and ensembles. The tables of docs/scaling.md.

usage: benchmarks/run.sh mpi [--write] [--quick] [--large] [--only PART,...]
    --write: into docs/scaling.md;  --quick: small bodies only;  --large: a plate of a million unknowns too, with up to 16 GB
    --only:  events, costs, schur, ensembles
       run.py --events short|long     only whether the same bonds break in the same order, as a test; short: of three bodies
"""

from __future__ import annotations

import json
import math
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

PAGE = Path(__file__).resolve().parents[2] / "docs" / "scaling.md"
HERE = Path(__file__).resolve().parent
EVENTS = 300  # at most, of a body in the table
PARTS = "events", "costs", "schur", "ensembles"
SHORT = "plate, as a line", "paper: inclined crack", "body with holes, as lines"

Answer = dict[str, Any]
Lines = list[str]


def environment() -> dict[str, str]:
    """Open MPI runs as root and with more ranks than cores; OpenBLAS knows processors that it takes for old ones."""
    given = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMPI_MCA_mpi_yield_when_idle": "1",
             "OPENBLAS_NUM_THREADS": "1"}
    if "avx2" in Path("/proc/cpuinfo").read_text(encoding="utf-8"):
        given["OPENBLAS_CORETYPE"] = "Haswell"
    return {**given, **os.environ}


def lines_of(command: list[str], ranks: int = 0) -> list[Answer]:
    """Lines of JSON of a command, started by mpirun if it has ranks."""
    start = ["mpirun", "-np", str(ranks), "--oversubscribe"] if ranks else []
    ended = subprocess.run([*start, *command], capture_output=True, text=True, env=environment())
    if ended.returncode != 0:
        raise SystemExit(f"{' '.join([*start, *command])}\n{ended.stdout}{ended.stderr}")
    return [json.loads(line) for line in ended.stdout.splitlines()]


def python(script: str, *arguments: Any) -> list[str]:
    return [sys.executable, "-W", "ignore", "-B", str(HERE / script), *map(str, arguments)]


def note(lines: Lines, line: str) -> None:
    lines.append(line)
    print(line, file=sys.stderr, flush=True)


def megabytes(answer: Answer) -> str:
    return " / ".join(f"{one:,.0f}" for one in answer["memory"])


def same_events(most: int, *bodies: str) -> tuple[Lines, bool]:
    lines: Lines = []
    note(lines, "| body | unknowns | events | same bonds in the same order by ranks | library [s] | 1 rank [s] | factorizations: library, MUMPS |")
    lines.append("|---|---|---|---|---|---|---|")
    good = True
    for found in lines_of(python("compare.py", 1, most, *bodies), 4):
        own, ranks = found["own"], found["ranks"]
        wrong = [f"NOT by {count}: {one['difference']}" for count, one in ranks.items() if one["difference"]]
        good = good and not wrong and own["events"] > 3
        note(lines, f"| {found['body']} | {own['unknowns']:,} | {own['events']} | {'; '.join(wrong) or ', '.join(ranks)} | {own['seconds']:.2f} | "
                    f"{ranks['1']['seconds']:.2f} | {own['factorizations']}, {ranks['1']['factorizations']} |")
    return lines, good


def costs(fines: tuple[int, ...]) -> tuple[Lines, list[Answer], float]:
    """Elastic solutions of a plate; the library's own figures of each size; and the memory of a rank over its share of the
    largest factor that four ranks had."""
    lines: Lines = []
    note(lines, "| unknowns | solver | elastic solve [s] | over the library | memory of each process [MB] | entries of the factor |")
    lines.append("|---|---|---|---|---|---|")
    of_library: list[Answer] = []
    over_share = 0.0
    for fine in fines:
        with tempfile.TemporaryDirectory(dir="/var/tmp") as scratch:
            for name, ranks, solver, folder in (("the library", 1, "own", ""), ("MUMPS, 1 rank", 1, "mumps", ""),
                                                ("MUMPS, 2 ranks", 2, "mumps", ""), ("MUMPS, 4 ranks", 4, "mumps", ""),
                                                ("MUMPS, 1 rank, out of core", 1, "mumps", scratch)):
                if fine > 12 and ranks == 4:
                    continue
                answer = lines_of(python("worker.py", "plate, bond by bond", fine, solver, *([folder] if folder else [])), ranks)[0]
                if solver == "own":
                    of_library.append(answer)
                if ranks == 4:
                    over_share = max(answer["memory"][1:]) / (2e-6 * answer["entries"])
                note(lines, f"| {answer['unknowns']:,} | {name} | {answer['seconds']:.2f} | {answer['seconds'] / of_library[-1]['seconds']:.2f} | "
                            f"{megabytes(answer)} | {answer['entries']:,} |")
    return lines, of_library, over_share


def schur(points: int) -> Lines:
    lines: Lines = []
    note(lines, "| unknowns | kept | ranks | analysis [s] | factorization [s] | memory of each process [MB] |")
    lines.append("|---|---|---|---|---|---|")
    program = str(Path(os.environ["BEMPD_BENCHMARKS"]) / "bempd_schur")
    for ranks in (1, 2):
        for kept in (0, 100, 300) if points < 200 else (0, 300, 1000, 2000):
            one = lines_of([program, str(points), str(kept)], ranks)[0]
            note(lines, f"| {one['unknowns']:,} | {kept:,} | {ranks} | {one['analysis']:.2f} | {one['factorization']:.2f} | {megabytes(one)} |")
    return lines


def ensembles(cases: int) -> tuple[Lines, float]:
    """Processor time of starting and ending, and of what the executor adds to a run, over that of the same run without one; what
    follows for an hour in which each worker has a core; and seconds of a run alone."""
    lines: Lines = []
    note(lines, "| executor | workers | runs an hour | start and end [s] | added to a run [ms] |")
    lines.append("|---|---|---|---|---|")
    alone, reference = 0.0, None
    for executor, workers in (("serial", 1), ("processes", 1), ("processes", 2), ("mpi", 1), ("mpi", 2), ("dask", 1), ("dask", 2)):
        seconds = []
        for count in (2, cases):
            command = python("plates.py", executor, workers, count)
            if executor == "mpi":
                command = [sys.executable, "-W", "ignore", "-m", "mpi4py.futures", *command[4:]]
            before = os.times()
            answer = lines_of(command, workers + 1 if executor == "mpi" else 0)[0]
            after = os.times()
            seconds.append(after.children_user + after.children_system - before.children_user - before.children_system)
        reference = reference or answer["values"]
        if answer["errors"] or answer["values"] != reference:
            raise SystemExit(f"{executor}: other results")
        each = (seconds[1] - seconds[0]) / (cases - 2)
        alone = alone or each
        note(lines, f"| {executor} | {workers} | {3600 * workers / each:,.0f} | {seconds[0] - 2 * each:.1f} | {1e3 * (each - alone):.0f} |")
    return lines, alone


def on_paper(solves: list[Answer], over_share: float, run: float) -> Lines:
    """What 10^7 points, 16 nodes and 10^6 runs need, from the two largest plates and from one run."""
    small, large = solves[-2:]
    grown = 2e7 / large["unknowns"]

    def power(name: str) -> float:
        return math.log(large[name] / small[name]) / math.log(large["unknowns"] / small["unknowns"])

    factor = 8e-9 * large["entries"] * grown ** power("entries")
    hours = [large["seconds"] / 3600 * grown**one for one in (power("seconds"), 1.5)]
    rest = 1e-3 * (large["memory"][0] - 8e-6 * large["entries"]) * grown
    return [f"On paper, from these figures: 10^7 points have a factor of {factor:,.0f} GB. That is {factor / 16 * over_share:,.0f} GB on each of "
            f"16 nodes, with {over_share:.1f} times its share as on 4 ranks. Rank 0 needs {rest:,.0f} GB more for lattice, bonds and matrix: it "
            f"is the limit. An elastic solve takes {hours[0]:.1f} to {hours[1]:.1f} hours of one core (unknowns to the power "
            f"{power('seconds'):.2f} or 1.5). Sixteen that share the work evenly take {hours[0] * 3.75:.0f} to {hours[1] * 3.75:.0f} minutes. 10^6 "
            f"runs of {run:.2f} s take {run * 1e6 / 3600:,.0f} hours of one core, or {run * 1e6 / 3600 / 128 * 60:.0f} minutes of 16 nodes with "
            f"8 cores each."]


def measure(parts: list[str]) -> tuple[dict[str, Lines], bool]:
    quick = "--quick" in sys.argv
    found: dict[str, Lines] = {}
    solves: list[Answer] = []
    over_share, run, good = 0.0, 0.0, True
    if "events" in parts:
        found["events"], good = same_events(12 if quick else EVENTS)
    if "costs" in parts:
        found["costs"], solves, over_share = costs((1, 2) if quick else (2, 5, 10, 18) if "--large" in sys.argv else (2, 5, 10))
    if "schur" in parts:
        found["schur"] = schur(100 if quick else 260)
    if "ensembles" in parts:
        found["ensembles"], run = ensembles(10 if quick else 100)
    kept = Path(os.environ.get("BEMPD_OUTPUT", "out/mpi")) / "figures.json"  # for parts that are measured one by one
    figures = json.loads(kept.read_text(encoding="utf-8")) if kept.exists() else {}
    figures |= {name: value for name, value in (("solves", solves), ("over_share", over_share), ("run", run)) if value}
    kept.parent.mkdir(parents=True, exist_ok=True)
    kept.write_text(json.dumps(figures), encoding="utf-8")
    if {"solves", "over_share", "run"} <= set(figures):
        found["paper"] = on_paper(figures["solves"], figures["over_share"], figures["run"])
    return found, good


def main() -> int:
    if "--events" in sys.argv:
        lines, good = same_events(10**6) if sys.argv[-1] == "long" else same_events(5, *SHORT)
        return 0 if good else 1
    parts = sys.argv[sys.argv.index("--only") + 1].split(",") if "--only" in sys.argv else list(PARTS)
    found, good = measure(parts)
    text = PAGE.read_text(encoding="utf-8")
    for part, lines in found.items():
        print("\n".join(["", *lines]))
        begin, end = f"<!-- benchmarks/mpi: {part} -->\n", "<!-- end of it -->"
        text = re.sub(re.escape(begin) + ".*?" + re.escape(end), lambda _: begin + "\n".join(lines) + "\n" + end, text, flags=re.DOTALL)
    if "--write" in sys.argv:
        PAGE.write_text(text, encoding="utf-8")
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
