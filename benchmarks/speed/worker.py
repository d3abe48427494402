"""Measures one row in a process of its own and prints it as JSON.

    worker.py TASK    with the task as JSON: scene, its arguments, options, until (elastic, force, separation), limit,
                      repeats, history (file for the sequence of events)

A repeat is one elastic solve of the scene (new model, scene, lattice, weights, assembly, analysis, factorization, one
solution) and one run, so that both meet the same machine; the least of the repeats counts. Seconds are processor time: the
rows have one thread, and a busy machine counts less so."""

from __future__ import annotations

import hashlib
import json
import sys
import time
from typing import Any

import numpy as np

import bempd
from scenes import SCENES, clamped_error

# Stop at this share of the largest force per opening.
FORCE_LEFT = 1e-3


def new_model(task: dict[str, Any]) -> bempd.Model:
    """Cracks grow bond by bond unless the task says otherwise."""
    model = bempd.Model(options={"crack.rule": "bond"} | task["options"])
    SCENES[task["scene"]](model, **task["arguments"])
    return model


def elastic(task: dict[str, Any]) -> tuple[float, bempd.Model]:
    start = time.process_time()
    model = new_model(task)
    # Far below the first break where there are cracks, which is found without another solution.
    model.step(1.0 if task["scene"] == "clamped" else 1e-9)
    return time.process_time() - start, model


def tear_to_force(model: bempd.Model) -> bempd.StepReport:
    """The opening per load factor is the same all the way: energy over its square falls as force per opening does."""
    largest = 0.0
    while True:
        report = model.step_to_next_event(1e9)
        unit_force = report.stored_energy / report.load_factor**2
        largest = max(largest, unit_force)
        if unit_force < FORCE_LEFT * largest or report.stop_reason != bempd.StopReason.EVENT:
            return report


def run(task: dict[str, Any]) -> tuple[float, bempd.Model, bempd.StepReport]:
    start = time.process_time()
    model = new_model(task)
    if task["until"] == "force":
        report = tear_to_force(model)
    else:
        report = model.run_to_separation(task.get("limit", 1e9))
    return time.process_time() - start, model, report


def sequence(model: bempd.Model) -> tuple[Any, str]:
    """Bonds and load factor of every event, and a digest of which bonds are broken in the end."""
    history = model.history()
    events = history[history["event"] > 0]
    digest = hashlib.sha256()
    for region in range(1, model.region_count + 1):
        try:
            digest.update(model.bonds(region).states.tobytes())
        except bempd.ArgumentError:  # a region of boundary elements
            continue
    return np.stack([events["total_broken_bonds"], events["load_factor"]], axis=1), digest.hexdigest()


def peak_force(model: bempd.Model) -> float:
    """Largest force on an end of a plate, each end of which moves by the load factor: their work is twice the energy."""
    history = model.history()
    return float((history["stored_energy"] / history["load_factor"]).max())


def peak_megabytes() -> float:
    """Of this process; what getrusage() tells begins with the parent's."""
    with open("/proc/self/status") as status:
        return next(int(line.split()[1]) for line in status if line.startswith("VmHWM")) / 1024


def least_stages(before: dict[str, float], statistics: bempd.Statistics) -> dict[str, float]:
    """Sizes, and the least wall time of each stage."""
    now = {name: getattr(statistics, name) for name in statistics.__dataclass_fields__}
    return {name: min(value, before.get(name, value)) for name, value in now.items()}


def main() -> None:
    before = peak_megabytes()
    task = json.loads(sys.argv[1])
    solves, runs = [], []
    row: dict[str, Any] = {}
    stages: dict[str, float] = {}
    run_stages: dict[str, float] = {}
    for _ in range(task["repeats"]):
        seconds, model = elastic(task)
        solves.append(seconds)
        stages = least_stages(stages, model.statistics())
        if task["scene"] == "clamped":
            row["error"] = clamped_error(model, **task["arguments"])
        model.close()
        if task["until"] != "elastic":
            seconds, model, report = run(task)
            runs.append(seconds)
            run_stages = least_stages(run_stages, model.statistics())
            row |= {"events": report.total_events, "bonds": report.total_broken_bonds, "residual": report.residual,
                    "balance": report.energy_balance_error, "load_factor": report.load_factor,
                    "peak_force": peak_force(model), "stop": report.stop_reason.name}
    if task.get("history"):
        events, digest = sequence(model)
        np.savez(task["history"], events=events, states=digest)
    row |= {"elastic": min(solves), "seconds": min(runs or solves),
            "megabytes": peak_megabytes() - before, "statistics": stages,
            "run_statistics": run_stages}
    print(json.dumps(row))


main()
