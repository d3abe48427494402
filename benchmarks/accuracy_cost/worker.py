"""Runs one scene with one setting in a process of its own and prints what it cost as JSON.

    worker.py SCENE KNOBS_AS_JSON REPEATS

Options of the library and knobs of the scene stand in one dictionary. Seconds are those of the whole solve in the
library (scene, meshes, operators, factorization, steps), the least of REPEATS after one that warms up."""

import json
import resource
import sys
import time

import bempd

from scenes import SCENES


def main() -> None:
    scene, settings, repeats = SCENES[sys.argv[1]], json.loads(sys.argv[2]), int(sys.argv[3])
    knobs = {**scene.knobs, **{key: value for key, value in settings.items() if key in scene.knobs}}
    options = {**scene.options, **{key: value for key, value in settings.items() if key not in scene.knobs}}
    seconds = []
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    for _ in range(repeats + 1):
        start = time.perf_counter()
        model = bempd.Model(options=options)
        scene.build(model, knobs)
        scene.solve(model)
        seconds.append(time.perf_counter() - start)
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    statistics = model.statistics()
    print(json.dumps({
        "error": scene.error(model, knobs),
        "seconds": min(seconds[1:] or seconds),
        "megabytes": (peak - before) / 1024,
        "unknowns": 2 * (statistics.boundary_nodes + statistics.material_points),
        "residual": float(model.history()["residual"][-1]),
        "stages": {name[8:]: value / len(seconds[:1]) for name, value in vars(statistics).items()
                   if name.startswith("seconds_")} if hasattr(statistics, "__dict__") else {},
    }))


main()
