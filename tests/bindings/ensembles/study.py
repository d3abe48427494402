"""Plates with a random crack, as the tests of ensembles run them: study.py EXECUTOR CASES FILE"""

import os
import random
import sys

import bempd

SEED_OF_ERROR = 2


def plate(seed, pid=True):
    if seed == SEED_OF_ERROR:
        raise ValueError("this seed has no plate")
    place = random.Random(seed)
    model = bempd.Model(log=None)
    glass = model.add_material(young_modulus=70e9, poisson_ratio=1 / 3, fracture_energy=8)
    body = model.add_pd_region(glass, bempd.rectangle(0, 0, 0.016, 0.016), spacing=0.001)
    x, y = place.uniform(0.005, 0.011), place.uniform(0.005, 0.011)
    model.add_crack([(x - 0.003, y - 0.001), (x + 0.003, y + 0.001)])
    model.fix_edge(body, 1)
    model.prescribe_edge(body, 3, "y", 1e-6)
    report = model.run_to_separation(1e4)
    found = {"strength": report.peak_resistance, "energy": report.released_energy, "events": report.events}
    return {**found, "threads": model.options["threads"], "process": os.getpid()} if pid else found


def ends_its_process(seed):
    if seed == 1:
        os.kill(os.getpid(), 9)
    return seed


if __name__ == "__main__":
    executor, count, path = sys.argv[1:]
    bempd.ensemble(plate, int(count), executor=executor, workers=2, results=path)
