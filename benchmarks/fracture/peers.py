"""The same factors by finite elements, and what they take beside bempd."""

from __future__ import annotations

import dataclasses
import importlib.util
import json
import math
import os
import subprocess
import sys
import time
from pathlib import Path
from typing import Any, Callable

import bempd
import scenes

TARGET = 1e-3
REPEATS = 7
# Largest triangle, that at the tip, and how much longer they are by distance from it.
STRIP = ((1, 0.1, 0.5), (1, 0.05, 0.4), (1, 0.03, 0.35), (1, 0.02, 0.3), (1, 0.015, 0.25), (1, 0.01, 0.2), (1, 0.005, 0.15))
SQUARE = ((10, 0.1, 0.5), (10, 0.05, 0.4), (10, 0.03, 0.35), (10, 0.02, 0.3), (10, 0.015, 0.25), (10, 0.01, 0.2))
NOTE = ("The finite element peer is left out: python3-dolfinx or python3-gmsh is not installed "
        "(`benchmarks/run.sh fracture --with-peers`).")


@dataclasses.dataclass
class Problem:
    name: str
    kind: str
    crack: float
    tip: int
    parts: tuple[str, ...]
    triangles: tuple[tuple[float, float, float], ...]
    finest: Callable[[], bempd.Model]
    meshes: tuple[tuple[str, Callable[[], bempd.Model]], ...]
    length: float


@dataclasses.dataclass
class Row:
    size: str
    difference: float
    seconds: float
    meshing: float = 0.0


def problems() -> list[Problem]:
    a, hole = 0.5, 1.5
    return [
        Problem("centre, a/W = 0.5", "centre", a, 1, ("whole", "symmetric"), STRIP, lambda: scenes.centre(a, 0.0625),
                tuple((f"{h:g} W", lambda h=h: scenes.centre(a, h)) for h in (3.0, 1.0, 0.5, 0.25)), a),
        Problem("edge, a/W = 0.5", "edge", a, 0, ("whole", "symmetric"), STRIP, lambda: scenes.single_edge(a, 0.0625),
                tuple((f"{h:g} W beside it", lambda h=h: scenes.graded_edge(a, h)) for h in (0.6, 0.4, 0.3, 0.2)), a),
        Problem("inclined, 20 degrees", "inclined", 20, 1, ("whole",), SQUARE, lambda: scenes.inclined(20, 1),
                tuple((f"{h:g} a", lambda h=h: scenes.inclined(20, h)) for h in (40.0, 10.0, 5.0)), 1.0),
        Problem("from a hole, a/R = 1.5", "hole", hole, 0, ("whole", "symmetric"), SQUARE, lambda: scenes.from_hole(hole, 20, 2),
                tuple((f"{h:g} R on the hole", lambda h=h: scenes.from_hole(hole, 20, 40, h)) for h in (0.8, 0.6, 0.4)), hole),
    ]


def installed() -> bool:
    return importlib.util.find_spec("dolfinx") is not None and importlib.util.find_spec("gmsh") is not None


def finite_elements(problem: Problem, part: str) -> list[dict[str, Any]]:
    """Values, unknowns and seconds on every mesh; one core."""
    program = Path(__file__).resolve().parents[1] / "peers/dolfinx_crack.py"
    words = [str(number) for mesh in problem.triangles for number in mesh]
    done = subprocess.run([sys.executable, str(program), problem.kind, part, str(problem.crack), str(REPEATS), *words],
                          check=True, capture_output=True, text=True, env={**os.environ, "OMP_NUM_THREADS": "1"})
    return [json.loads(line) for line in done.stdout.splitlines() if line.startswith("{")]


def factors(model: bempd.Model, problem: Problem) -> tuple[float, float]:
    tip, scale = model.tips()[problem.tip], math.sqrt(math.pi * problem.length)
    return tip.stress_intensity_1 / scale, tip.stress_intensity_2 / scale


def own_rows(problem: Problem, reference: tuple[float, float]) -> list[Row]:
    rows = []
    for name, scene in problem.meshes:
        best, found, elements = math.inf, (0.0, 0.0), 0
        for _ in range(4 * REPEATS):
            model = scene()
            model.options["threads"] = 1
            model.options["bem.quadrature_tolerance"] = 1e-6
            start = time.process_time()
            model.step(1)
            found = factors(model, problem)
            best = min(best, time.process_time() - start)
            elements = model.statistics().boundary_elements
        rows.append(Row(f"{elements} elements, {name}", difference(found, reference), best))
    return rows


def difference(found: tuple[float, float], reference: tuple[float, float]) -> float:
    return math.dist(found, reference) / math.hypot(*reference)


def within(rows: list[Row]) -> list[Row]:
    """Those that are right to the target, as all finer ones are."""
    kept: list[Row] = []
    for row in reversed(rows):
        if row.difference > TARGET:
            break
        kept.append(row)
    return kept


def side_by_side() -> str:
    """Error against seconds: from the finished scene to the factors of the tips."""
    lines = ["| crack | program | unknowns or elements | difference | ms | of them mesh |", "|---|---|---|---|---|---|"]
    ratios = ["| crack | finite elements of | times as long, with meshing | without meshing |", "|---|---|---|---|"]
    for problem in problems():
        fine = problem.finest()
        fine.step(1)
        reference = factors(fine, problem)
        rows = {"bempd": own_rows(problem, reference)}
        for part in problem.parts if installed() else ():
            rows[f"dolfinx, {part}"] = [
                Row(f"{found['unknowns']} unknowns", difference((found["value"], found["value_2"]), reference),
                    found["seconds_mesh"] + found["seconds_solve"], found["seconds_mesh"])
                for found in finite_elements(problem, part)]
        for program, sizes in rows.items():
            for row in sizes:
                lines.append(f"| {problem.name} | {program} | {row.size} | {row.difference:.1e} | {1e3 * row.seconds:.1f} | "
                             f"{format(1e3 * row.meshing, '.1f') if row.meshing else ''} |")
                print(lines[-1], flush=True)
        own = min(row.seconds for row in within(rows.pop("bempd")))
        for program, sizes in rows.items():
            good = within(sizes)
            if good:
                ratios.append(f"| {problem.name} | {program} | {min(row.seconds for row in good) / own:.0f} | "
                              f"{min(row.seconds - row.meshing for row in good) / own:.0f} |")
                print(ratios[-1], flush=True)
    closing = "\n".join(ratios) if installed() else NOTE
    return (f"{chr(10).join(lines)}\n\nThe fastest within {TARGET:g} of the factors, among those whose finer ones are so too, over "
            f"bempd's:\n\n{closing}")
