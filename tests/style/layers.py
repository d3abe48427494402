"""Arrows run down only: a source file includes its own folder and those below it.

    layers.py ROOT

The folders of src/ by height; those of the same height do not know each other. Files directly in src/ belong to all. Folders
inside one of them use its own files and are used by them; among each other they may not include in a circle."""

from __future__ import annotations

import pathlib
import re
import sys

HEIGHT = {"capi": 9, "mpi": 9, "model": 8, "paper": 7, "results": 7, "regions": 6, "fracture": 6, "scene": 5, "coupling": 4, "bem": 3,
          "pd": 3, "crack": 2, "elasticity": 1, "output": 1, "geometry": 0, "linalg": 0}

# Folders that are registered with one above them, with the reason.
EXCEPTIONS: dict[tuple[str, str], str] = {}


def circle(graph: dict[str, set[str]], path: list[str]) -> list[str]:
    """Folders that include each other in a circle from the last one of `path` on; empty if there is none."""
    for other in sorted(graph.get(path[-1], ())):
        found = path[path.index(other):] + [other] if other in path else circle(graph, [*path, other])
        if found:
            return found
    return []


def main() -> int:
    source = pathlib.Path(sys.argv[1]) / "src"
    complaints = []
    inner: dict[str, set[str]] = {}  # folders inside a folder of src/, and those beside them that they include
    for path in sorted(p for ending in ("*.cpp", "*.hpp") for p in source.rglob(ending)):
        name = path.relative_to(source).as_posix()
        own = name.split("/")[0] if "/" in name else None
        if own is not None and own not in HEIGHT:
            complaints.append(f"{name}: the folder {own} has no place among the layers")
            continue
        for line, included in re.findall(r'^(#include "([^"]+)")', path.read_text(), re.MULTILINE):
            if own not in ("capi", "mpi") and included == "bempd.h":
                complaints.append(f"{name}: includes the C header")
            here, there = name.rsplit("/", 1)[0], included.rpartition("/")[0]
            if here != there and here.count("/") == there.count("/") == 1 and there.startswith(f"{own}/"):
                inner.setdefault(here, set()).add(there)
            other = included.split("/")[0]
            if own is None or "/" not in included or other == own or (name, other) in EXCEPTIONS:
                continue
            if HEIGHT.get(other, 99) >= HEIGHT[own]:
                complaints.append(f"{name}: {line} goes up or sideways")
    if around := next(filter(None, (circle(inner, [folder]) for folder in sorted(inner))), []):
        complaints.append("folders include each other in a circle: " + " -> ".join(around))
    print("\n".join(complaints) or "all arrows run down")
    return 1 if complaints else 0


sys.exit(main())
