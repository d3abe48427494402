"""Runs one scene with one setting in a process of its own and prints what it cost as JSON.

    worker.py SCENE SETTINGS_AS_JSON SECONDS

Options of the library and knobs of the scene stand in one dictionary. Seconds are those of the whole solve through the
Python binding (scene, meshes, operators, factorization, steps), the least of as many runs as fit in SECONDS, after one
that warms up; a run that is longer than that is done once. Megabytes are the peak above that of the idle process.
"""

from __future__ import annotations

import json
import sys
import time
from typing import Any

import bempd

from cracks import CRACKS
from scenes import SCENES


def peak_megabytes() -> float:
    """Of this program alone: getrusage() would count what the process was before it became this program."""
    with open("/proc/self/status") as status:
        return next(float(line.split()[1]) / 1024 for line in status if line.startswith("VmHWM:"))


def main() -> None:
    scene, settings, budget = (SCENES | CRACKS)[sys.argv[1]], json.loads(sys.argv[2]), float(sys.argv[3])
    knobs = {**scene.knobs, **{key: value for key, value in settings.items() if key in scene.knobs}}
    # Plates are torn bond by bond.
    options = {"crack.rule": "bond", **{key: value for key, value in settings.items() if key not in scene.knobs}}
    idle = peak_megabytes()

    def run() -> tuple[float, Any]:
        start = time.perf_counter()
        model = bempd.Model(options=options)
        scene.build(model, knobs)
        scene.solve(model)
        return time.perf_counter() - start, model

    try:
        seconds, model = run()
    except bempd.Error as refusal:
        print(json.dumps({"refused": str(refusal)}))
        return
    megabytes = peak_megabytes() - idle
    statistics, elapsed = [model.statistics()], [seconds]
    # The first run also warms up libraries and caches, so it does not count when there is time for more.
    while budget > 0 and (len(elapsed) == 1 or sum(elapsed[1:]) + elapsed[-1] < budget):
        seconds, again = run()
        elapsed.append(seconds)
        statistics.append(again.statistics())
    print(json.dumps({
        "error": scene.error(model, knobs),
        **(scene.outcome(model) if scene.outcome else {}),
        "seconds": min(elapsed[1:] or elapsed),
        "megabytes": megabytes,
        "unknowns": 2 * (statistics[0].boundary_nodes + statistics[0].material_points),
        "elements": statistics[0].boundary_elements,
        "kernel_evaluations": statistics[0].kernel_evaluations,
        "seconds_boundary": min(s.seconds_boundary for s in statistics),
        "seconds_assembly": min(s.seconds_assembly for s in statistics),
    }))


main()
