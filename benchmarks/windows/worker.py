"""Runs one scene of the speed benchmark once and prints a digest of its events; for counting its instructions."""

from __future__ import annotations

import hashlib
import json
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "speed"))

import bempd  # noqa: E402
from scenes import SCENES  # noqa: E402


def main() -> None:
    task = json.loads(sys.argv[1])
    model = bempd.Model(options=task["options"])
    SCENES[task["scene"]](model, **task["arguments"])
    if task["until"] == "nothing":
        return
    model.run_to_separation(1e9)
    digest = hashlib.sha256()
    history = model.history()
    digest.update(history["total_broken_bonds"].tobytes())
    for region in range(1, model.region_count + 1):
        try:
            digest.update(model.bonds(region).states.tobytes())
        except bempd.ArgumentError:  # a region of boundary elements
            continue
    print(digest.hexdigest())


if __name__ == "__main__":
    main()
