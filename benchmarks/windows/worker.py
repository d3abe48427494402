"""Runs scenes of the speed benchmark to separation, each so often, and prints processor seconds and digests of what broke.

    worker.py SCENES REPEATS    SCENES as JSON: [[scene, arguments, options], ...], the
    options may be left out; bond by bond unless they say otherwise"""

from __future__ import annotations

import hashlib
import json
import pathlib
import sys
import time
from typing import Any

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "speed"))

import bempd  # noqa: E402
from scenes import SCENES  # noqa: E402


def digest(model: bempd.Model) -> str:
    found = hashlib.sha256(model.history()["total_broken_bonds"].tobytes())
    for region in range(1, model.region_count + 1):
        try:
            found.update(model.bonds(region).states.tobytes())
        except bempd.ArgumentError:  # a region of boundary elements
            continue
    return found.hexdigest()


def run(scene: str, arguments: dict[str, Any], options: dict[str, Any] = {}) -> tuple[float, str]:
    start = time.process_time()
    model = bempd.Model(options={"threads": 1, "crack.rule": "bond", **options})
    SCENES[scene](model, **arguments)
    model.run_to_separation(1e9)
    return time.process_time() - start, digest(model)


def main() -> None:
    scenes, repeats = json.loads(sys.argv[1]), int(sys.argv[2])
    runs = [[run(*scene) for scene in scenes] for _ in range(repeats)]
    print(json.dumps([{"seconds": [one[k][0] for one in runs], "digest": runs[0][k][1]} for k in range(len(scenes))]))


if __name__ == "__main__":
    main()
