"""One body with one solver, on all ranks that mpirun starts: prints a line of JSON.

usage: mpirun -np N python3 worker.py BODY FINE own|mumps run|solve EVENTS [FOLDER]
    own: the library's factorization, on one rank;  FOLDER: of linalg.scratch
"""

from __future__ import annotations

import hashlib
import json
import sys
import time
from typing import Any

from mpi4py import MPI

import bempd
import bempd.mpi
from bodies import BODIES


def peak() -> float:
    """Largest resident memory of this process so far [MB]."""
    with open("/proc/self/status", encoding="ascii") as file:
        return next(int(line.split()[1]) for line in file if line.startswith("VmHWM")) / 1e3


def is_lattice(model: bempd.Model, region: int) -> bool:
    try:
        return bool(model.bonds(region).states.size)
    except bempd.ArgumentError:
        return False


def events(model: bempd.Model, most: int) -> list[list[Any]]:
    """Bonds broken so far (as a digest of all states) and load factor after each event."""
    found = []
    regions = [region for region in range(1, model.region_count + 1) if is_lattice(model, region)]
    while len(found) < most:
        report = model.step_to_next_event(1e9)
        states = b"".join(model.bonds(region).states.tobytes() for region in regions)
        found.append([hashlib.sha1(states).hexdigest()[:12], report.broken_bonds, model.load_factor])
        if report.stop_reason.name != "EVENT":
            break
    return found


def work(body: str, fine: int, own: bool, goal: str, most: int, scratch: str) -> dict[str, Any]:
    model = BODIES[body](fine)
    if scratch:
        model.options["linalg.scratch"] = scratch
    if not own:
        bempd.mpi.attach(model, MPI.COMM_WORLD)
    model.prepare()
    before, begin = peak(), time.process_time()
    answer: dict[str, Any] = {"events": []}
    if goal == "run":
        answer["events"] = events(model, most)
    else:
        model.step(1e-6)
    answer["seconds"] = time.process_time() - begin
    sizes = model.statistics()
    answer |= {"unknowns": sizes.sparse_unknowns, "factorizations": sizes.sparse_factorizations, "before": before,
               "factorization": sizes.seconds_factorization, "entries": sizes.factor_nonzeros}
    if not own:
        bempd.mpi.detach(model)
    return answer


def main() -> None:
    body, fine, solver, goal, most, *folder = sys.argv[1:]
    answer = None
    if MPI.COMM_WORLD.rank == 0:
        answer = work(body, int(fine), solver == "own", goal, int(most), folder[0] if folder else "")
    else:
        bempd.mpi.serve(MPI.COMM_WORLD)
    peaks = MPI.COMM_WORLD.gather(peak())
    if answer:
        print(json.dumps(answer | {"memory": peaks}))


if __name__ == "__main__":
    main()
