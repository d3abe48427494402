"""The same bonds by the library and by MUMPS on 1, 2 and 4 ranks: prints a line of JSON for each body.

usage: mpirun -np 4 python3 compare.py FINE EVENTS [BODY ...]
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

WORLD = MPI.COMM_WORLD
RANKS = 1, 2, 4
TOLERANCE = 1e-8  # largest relative difference of the load factors of one event


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


def run(body: str, fine: int, most: int, comm: Any) -> dict[str, Any]:
    """Events of a body, on rank 0; without a communicator by the library's own factorization."""
    model = BODIES[body](fine)
    if comm:
        bempd.mpi.attach(model, comm)
    begin = time.process_time()
    found = events(model, most)
    sizes = model.statistics()
    answer = {"events": found, "seconds": time.process_time() - begin, "unknowns": sizes.sparse_unknowns,
              "factorizations": sizes.sparse_factorizations, "applications": sizes.solver_iterations}
    if comm:
        bempd.mpi.detach(model)
    return answer


def difference(one: list[Any], other: list[Any]) -> str:
    """How two runs differ: empty if the same bonds break in the same order, at the same loads."""
    for number, (first, second) in enumerate(zip(one, other), 1):
        if first[:2] != second[:2]:
            return f"other bonds break at event {number}"
        if abs(first[2] - second[2]) > TOLERANCE * abs(first[2]):
            return f"load factor of event {number}: {first[2]:.12g} and {second[2]:.12g}"
    return "" if len(one) == len(other) else "one run ends before the other"


def main() -> None:
    fine, most, bodies = int(sys.argv[1]), int(sys.argv[2]), sys.argv[3:] or list(BODIES)
    comms = {ranks: WORLD.Split(0 if WORLD.rank < ranks else 1, WORLD.rank) for ranks in RANKS}
    for body in bodies:
        own = run(body, fine, most, None) if WORLD.rank == 0 else {}
        found: dict[str, Any] = {"body": body, "own": own, "ranks": {}}
        for ranks, comm in comms.items():
            if WORLD.rank == 0:
                answer = run(body, fine, most, comm)
                found["ranks"][ranks] = answer | {"difference": difference(own["events"], answer.pop("events"))}
            elif WORLD.rank < ranks:
                bempd.mpi.serve(comm)
        if own:
            own["events"] = len(own["events"])
            print(json.dumps(found), flush=True)
    WORLD.Barrier()


if __name__ == "__main__":
    main()
