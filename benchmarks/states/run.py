"""What states cost: 100 steps of a run, never saved and saved before each step, with events in the steps and without.

    benchmarks/run.sh states [LIBRARY.so ...] [--scene NAME ...] [--way NAME ...] [--cells N] [--repeats N]

Prints processor seconds and peak memory over those of the run without states. Further libraries are measured in turns with
the one of this tree, and their ratios are printed beside it."""

from __future__ import annotations

import argparse
import json
import os
import resource
import subprocess
import sys
import time
from typing import Callable, Optional

import numpy

STEPS = 100


def lattice(cells: int, rule: str):
    """A plate of unit cells with a crack from its left edge, pulled upwards."""
    import bempd
    model = bempd.Model(options={"threads": 1, "crack.rule": rule})
    material = model.add_material(young_modulus=1, poisson_ratio=1 / 3, fracture_energy=1e-6)
    plate = model.add_pd_region(material, bempd.rectangle(0, 0, 2 * cells, cells), 1, 3)
    model.add_crack([(0, cells / 2 + 0.3), (cells / 4 + 0.2, cells / 2 + 0.3)])
    model.fix_edge(plate, 1)
    model.prescribe_edge(plate, 3, "y", 1e-3)
    return model


def elements(cells: int, rule: str):
    """A plate of boundary elements with a crack from its left edge and one inside."""
    import bempd
    model = bempd.Model(options={"threads": 1})
    material = model.add_material(young_modulus=1, poisson_ratio=0.3, fracture_energy=1e-6)
    plate = model.add_bem_region(material, bempd.rectangle(0, 0, 2, 4), 20 / cells)
    model.add_crack([(0, 2), (0.2, 2)])
    model.fix_edge(plate, 1)
    model.prescribe_edge(plate, 3, "y", 1e-2)
    return model


SCENES: dict[str, Callable] = {"bonds": lambda n: lattice(n, "bond"), "lines": lambda n: lattice(n, "line"),
                               "elements": lambda n: elements(n, "")}


class States:
    """What a host does before each step, and after it."""

    def __init__(self, way: str):
        self.way, self.kept, self.size, self.copy = way, [], 0, None

    def before(self, model) -> None:
        if self.way == "never":
            return
        state = model.save()
        if self.way == "factor copied":  # what a state would hold that shares the factor, once the run has changed it
            self.copy = None
            self.copy = numpy.ones(model.statistics().factor_nonzeros)
        if self.way == "bytes":
            self.size = len(state.to_bytes())
        elif self.way == "all kept":
            self.kept.append(state)
        else:
            self.kept = [state]

    def after(self, model, step: Callable) -> None:
        if self.way == "repeated":
            model.restore(self.kept[0])
            step()


WAYS = ("never", "in memory", "all kept", "factor copied", "repeated", "bytes")


def worker(scene: str, breaks: bool, way: str, cells: int) -> dict[str, float]:
    model = SCENES[scene](cells)
    for _ in range(3):
        model.step_to_next_event(1e9)
    top = model.load_factor
    if not breaks:
        model.step(0.2 * top)
    states = States(way)
    begin = time.process_time()
    for k in range(STEPS):
        states.before(model)
        step = (lambda: model.step_to_next_event(1e9)) if breaks else (lambda: model.step(top * (0.2 + 0.6 * k / STEPS)))
        step()
        states.after(model, step)
    seconds = time.process_time() - begin
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    statistics = model.statistics()
    return {"seconds": seconds, "memory": memory, "size": states.size / 1e6, "factor": statistics.factor_nonzeros * 8e-6,
            "factorizations": statistics.sparse_factorizations}


def measure(library: Optional[str], arguments: list[str]) -> dict[str, float]:
    environment = dict(os.environ) | ({"BEMPD_LIBRARY": library} if library else {})
    done = subprocess.run([sys.executable, __file__, "--worker", *arguments], env=environment, check=True,
                          capture_output=True, text=True)
    return json.loads(done.stdout)


def least(results: list[dict[str, float]]) -> dict[str, float]:
    return {name: min(result[name] for result in results) for name in results[0]}


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("libraries", nargs="*")
    parser.add_argument("--scene", nargs="+", default=list(SCENES))
    parser.add_argument("--way", nargs="+", default=list(WAYS))
    parser.add_argument("--cells", type=int, default=60)
    parser.add_argument("--repeats", type=int, default=3)
    parser.add_argument("--worker", action="store_true")
    words = parser.parse_args()
    if words.worker:
        scene, breaks, way, cells = words.libraries
        print(json.dumps(worker(scene, breaks == "events", way, int(cells))))
        return
    libraries = [None, *words.libraries]
    print(f"{STEPS} steps, {words.cells} cells, processor seconds and MB, least of {words.repeats}\n")
    print("| scene | steps | states | " + " | ".join(
        f"{name or 'this tree'}: seconds | over never | MB | over never | factorizations | MB of bytes" for name in libraries) + " |")
    print("|---" * (3 + 6 * len(libraries)) + "|")
    for scene in words.scene:
        for steps in ("still", "events"):
            never: dict = {}
            for way in ["never", *(way for way in words.way if way != "never")]:
                results: dict = {library: [] for library in libraries}
                for _ in range(words.repeats):
                    for library in libraries:
                        results[library].append(measure(library, [scene, steps, way, str(words.cells)]))
                cells = []
                for library in libraries:
                    best = least(results[library])
                    base = never.setdefault(library, best)
                    cells.append(f"{best['seconds']:.3f} | {best['seconds'] / base['seconds']:.2f} | {best['memory']:.0f} | "
                                 f"{best['memory'] / base['memory']:.2f} | {best['factorizations']} | {best['size']:.2f}")
                print(f"| {scene} | {steps} | {way} | " + " | ".join(cells) + " |", flush=True)


if __name__ == "__main__":
    main()
