"""Finite elements of CalculiX (Debian: calculix-ccx, python3-gmsh) on the elastic plates: quadratic triangles CPS6.

    /usr/bin/python3 calculix.py PROBLEM SIZE REFINEMENT REPEATS

Arguments and output as those of dolfinx_p2.py. CalculiX is a program: seconds_solve are those of the process, and
seconds_start what it needs for a mesh of a few triangles, to be taken off.
"""
import json
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import gmsh
import numpy as np

from plate_mesh import HEIGHT, LENGTH, POISSON, YOUNG, load_of, mesh_plate

# CalculiX expands plane elements to solids that share their displacement across the plate: only thin plates are right.
THICKNESS = 1e-3


def numbered(tags, columns):
    return "\n".join(f"{tag}, " + ", ".join(map(repr, row)) for tag, row in zip(tags, columns))


def write_input(path, problem, size, refinement):
    """Returns the number of nodes."""
    mesh_plate(problem, size, refinement)
    tags, coordinates, _ = gmsh.model.mesh.getNodes()
    x = np.asarray(coordinates).reshape(-1, 3)
    _, elements, nodes = gmsh.model.mesh.getElements(2)
    triangles = nodes[0].reshape(-1, 6)
    gmsh.finalize()
    # Consistent nodal forces of a uniform traction on quadratic edges: 1/6, 4/6, 1/6.
    traction, component = load_of(problem)
    place = dict(zip(tags.tolist(), x))
    force = {}
    for triangle in triangles.tolist():
        for a, b, middle in ((0, 1, 3), (1, 2, 4), (2, 0, 5)):
            ends = [triangle[a], triangle[b], triangle[middle]]
            if all(place[node][0] > LENGTH - 1e-9 for node in ends):
                length = abs(place[ends[0]][1] - place[ends[1]][1])
                for node, share in zip(ends, (1 / 6, 1 / 6, 4 / 6)):
                    force[node] = force.get(node, 0) + share * length * THICKNESS * traction[component]
    clamped = [tag for tag, place_of in zip(tags.tolist(), x) if place_of[0] < 1e-9]
    target = min(tags.tolist(), key=lambda tag: np.hypot(place[tag][0] - LENGTH, place[tag][1] - HEIGHT / 2))
    path.write_text("\n".join([
        "*NODE, NSET=ALL", numbered(tags.tolist(), x.tolist()),
        "*ELEMENT, TYPE=CPS6, ELSET=PLATE", numbered(elements[0].tolist(), triangles.tolist()),
        "*NSET, NSET=CLAMPED", ",\n".join(map(str, clamped)),
        "*NSET, NSET=TARGET", str(target),
        "*MATERIAL, NAME=M", "*ELASTIC", f"{YOUNG!r}, {POISSON!r}",
        "*SOLID SECTION, ELSET=PLATE, MATERIAL=M", repr(THICKNESS),
        "*BOUNDARY", "CLAMPED, 1, 2",
        "*STEP", "*STATIC", "*CLOAD", "\n".join(f"{node}, {component + 1}, {value!r}" for node, value in force.items()),
        "*NODE PRINT, NSET=TARGET", "U", "*END STEP", ""]))
    return len(tags)


def run(folder, name):
    start = time.perf_counter()
    subprocess.run(["ccx", name], cwd=folder, check=True, stdout=subprocess.DEVNULL,
                   env={**os.environ, "OMP_NUM_THREADS": str(os.cpu_count())})
    return time.perf_counter() - start


def main():
    problem, size, refinement, repeats = sys.argv[1], float(sys.argv[2]), float(sys.argv[3]), int(sys.argv[4])
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        write_input(folder / "tiny.inp", "plate", HEIGHT, 1)
        start_up = min(run(folder, "tiny") for _ in range(repeats))
        start = time.perf_counter()
        nodes = write_input(folder / "job.inp", problem, size, refinement)
        seconds_mesh = time.perf_counter() - start
        seconds = min(run(folder, "job") for _ in range(repeats))
        values = (folder / "job.dat").read_text().split("\n")
    line = next(line.split() for line in reversed(values) if line.strip())
    print(json.dumps({
        "displacement": float(line[1 + load_of(problem)[1]]),
        "unknowns": 2 * nodes,
        "seconds_mesh": seconds_mesh,
        "seconds_solve": seconds,
        "seconds_start": start_up,
    }))


main()
