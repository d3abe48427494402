"""The study by MPI ranks, in C and Fortran: the same lines by one rank and by three.

usage: mpi_study.py MPIRUN PROGRAM [PROGRAM ...]"""

import os
import subprocess
import sys

CASES = 6


def lines(mpirun: str, ranks: int, program: str) -> str:
    environment = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
    command = [mpirun, "-np", str(ranks), "--oversubscribe", program, str(CASES)]
    return subprocess.run(command, check=True, text=True, stdout=subprocess.PIPE, env=environment).stdout


mpirun, *programs = sys.argv[1:]
reference = lines(mpirun, 1, programs[0])
print(reference)
assert len(reference.splitlines()) == CASES + 1 and len(set(reference.split())) > CASES, reference
assert f"of {CASES} plates" in reference, reference
for program in programs:
    assert lines(mpirun, 3, program) == reference, program
