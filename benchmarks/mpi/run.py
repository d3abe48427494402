"""One body on several processes by MUMPS: the tables of docs/scaling.md.

usage: benchmarks/run.sh mpi [--write] [--quick] [--one-rank] [--large]
    --write: into docs/scaling.md;  --quick: small bodies only;  --one-rank: events by one rank, as on a machine that is busy;
    --large: a plate of 318,400 unknowns too
       run.py --events short|long     only whether the same bonds break in the same order, as a test
"""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

PAGE = Path(__file__).resolve().parents[2] / "docs" / "scaling.md"
WORKER = Path(__file__).resolve().parent / "worker.py"
BODIES = ("plate, bond by bond", "plate, as a line", "paper: centre crack", "paper: inclined crack", "paper: two edge cracks",
          "body with holes, as lines")
RANKS = 1, 2, 4
EVENTS = 300  # at most, of a body in the table
TOLERANCE = 1e-8  # largest relative difference of the load factors of one event

Answer = dict[str, Any]


def work(ranks: int, body: str, fine: int, solver: str, goal: str, events: int = 0, scratch: str = "") -> Answer:
    """Answer of the worker in processes of its own, so that their peaks of memory are known."""
    environment = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
                   "OMPI_MCA_mpi_yield_when_idle": "1", "OPENBLAS_NUM_THREADS": "1"}
    command = ["mpirun", "-np", str(ranks), "--oversubscribe", sys.executable, "-W", "ignore", "-B", str(WORKER), body, str(fine), solver,
               goal, str(events), *([scratch] if scratch else [])]
    ended = subprocess.run(command, capture_output=True, text=True, env=environment)
    if ended.returncode != 0:
        raise SystemExit(f"{' '.join(command)}\n{ended.stdout}{ended.stderr}")
    return json.loads(ended.stdout)  # type: ignore[no-any-return]


def difference(one: Answer, other: Answer) -> str:
    """How two runs differ: empty if the same bonds break in the same order, at the same loads."""
    for number, (first, second) in enumerate(zip(one["events"], other["events"]), 1):
        if first[:2] != second[:2]:
            return f"other bonds break at event {number}"
        if abs(first[2] - second[2]) > TOLERANCE * abs(first[2]):
            return f"load factor of event {number}: {first[2]:.12g} and {second[2]:.12g}"
    return "" if len(one["events"]) == len(other["events"]) else "one run ends before the other"


def same_events(fine: int, most: int, ranks_of: Any) -> tuple[list[str], bool]:
    lines = ["| body | unknowns | events | broken bonds in the same order by ranks | library [s] | 1 rank [s] |", "|---|---|---|---|---|---|"]
    good = True
    for body in BODIES:
        own = work(1, body, fine, "own", "run", most)
        words, seconds = [], 0.0
        for ranks in ranks_of(body):
            answer = work(ranks, body, fine, "mumps", "run", most)
            how = difference(own, answer)
            good = good and not how and len(own["events"]) > 3
            print(body, ranks, how or "the same", f"{answer['seconds']:.2f} s", file=sys.stderr)
            words.append(f"{ranks}" if not how else f"NOT {ranks} ({how})")
            if ranks == 1:
                seconds = answer["seconds"]
        lines.append(f"| {body} | {own['unknowns']:,} | {len(own['events'])} | {', '.join(words)} | {own['seconds']:.2f} | "
                     + (f"{seconds:.2f} |" if seconds else "|"))
    return lines, good


def megabytes(answer: Answer) -> str:
    return " / ".join(f"{one:,.0f}" for one in answer["memory"])


def costs(quick: bool) -> list[str]:
    lines = ["| unknowns | solver | elastic solve [s] | memory of each process [MB] | entries of the factor |", "|---|---|---|---|---|"]
    for fine in (1, 2) if quick else (2, 5, 10) if "--large" in sys.argv else (2, 5):
        with tempfile.TemporaryDirectory() as scratch:
            for name, ranks, solver, folder in (("the library", 1, "own", ""), ("MUMPS, 1 rank", 1, "mumps", ""),
                                                ("MUMPS, 2 ranks", 2, "mumps", ""), ("MUMPS, 4 ranks", 4, "mumps", ""),
                                                ("MUMPS, 1 rank, out of core", 1, "mumps", scratch)):
                answer = work(ranks, BODIES[0], fine, solver, "solve", 0, folder)
                lines.append(f"| {answer['unknowns']:,} | {name} | {answer['seconds']:.2f} | {megabytes(answer)} | {answer['entries']:,} |")
                print(lines[-1], file=sys.stderr)
    return lines


def main() -> int:
    if "--events" in sys.argv:
        is_long = sys.argv[-1] == "long"
        lines, good = same_events(1, 10**6 if is_long else 12,
                                  lambda body: RANKS if is_long else (4,) if body == BODIES[0] else (2,) if "paper" in body else (1,))
        print("\n".join(lines))
        return 0 if good else 1
    quick = "--quick" in sys.argv
    lines, good = same_events(1, 12 if quick else EVENTS, lambda body: RANKS[:1] if "--one-rank" in sys.argv else RANKS)
    lines += ["", *costs(quick)]
    print("\n".join(lines))
    if "--write" in sys.argv:
        begin, end = "<!-- table of benchmarks/mpi -->\n", "<!-- end of it -->"
        found = begin + "\n".join(lines) + "\n" + end
        text = PAGE.read_text(encoding="utf-8")
        PAGE.write_text(re.sub(re.escape(begin) + ".*?" + re.escape(end), lambda _: found, text, flags=re.DOTALL),
                        encoding="utf-8")
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
