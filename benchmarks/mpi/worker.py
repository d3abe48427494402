"""An elastic solution of one body on all ranks that mpirun starts: prints a line of JSON.

usage: mpirun -np N python3 worker.py BODY FINE own|mumps [FOLDER]
    own: the library's factorization, on one rank;  FOLDER: of linalg.scratch
"""

from __future__ import annotations

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


def work(body: str, fine: int, own: bool, scratch: str) -> dict[str, Any]:
    model = BODIES[body](fine)
    if scratch:
        model.options["linalg.scratch"] = scratch
    if not own:
        bempd.mpi.attach(model, MPI.COMM_WORLD)
    model.prepare()
    begin = time.process_time()
    model.step(1e-6)
    seconds = time.process_time() - begin
    sizes = model.statistics()
    if not own:
        bempd.mpi.detach(model)
    return {"seconds": seconds, "unknowns": sizes.sparse_unknowns, "entries": sizes.factor_nonzeros}


def main() -> None:
    body, fine, solver, *folder = sys.argv[1:]
    answer = None
    if MPI.COMM_WORLD.rank == 0:
        answer = work(body, int(fine), solver == "own", folder[0] if folder else "")
    else:
        bempd.mpi.serve(MPI.COMM_WORLD)
    peaks = MPI.COMM_WORLD.gather(peak())
    if answer:
        print(json.dumps(answer | {"memory": peaks}))


if __name__ == "__main__":
    main()
