"""An ensemble of small plates with a random crack: prints a line of JSON with the forces.

usage: python3 plates.py EXECUTOR WORKERS CASES     (for mpi by mpirun -np N python3 -m mpi4py.futures)
"""

from __future__ import annotations

import json
import random
import sys

import bempd


def strength(seed: int) -> float:
    place = random.Random(seed)
    model = bempd.Model(log=None)
    glass = model.add_material(young_modulus=70e9, poisson_ratio=1 / 3, fracture_energy=8)
    plate = model.add_pd_region(glass, bempd.rectangle(0, 0, 0.024, 0.024), spacing=0.001)
    x, y = place.uniform(0.006, 0.018), place.uniform(0.006, 0.018)
    model.add_crack([(x - 0.003, y), (x + 0.003, y)])
    model.fix_edge(plate, 1)
    model.prescribe_edge(plate, 3, "y", 1e-6)
    return model.run_to_separation(1e4).peak_resistance


def main() -> None:
    executor, workers, cases = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
    found = bempd.ensemble(strength, cases, executor=executor, workers=workers, quiet=True)
    print(json.dumps({"errors": len(found.errors), "values": found.values().tolist()}))


if __name__ == "__main__":
    main()
