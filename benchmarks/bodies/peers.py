"""Bodies beside finite elements of dolfinx that are meshed by gmsh: the same three scenes, processor seconds of one core."""

from __future__ import annotations

import csv
import dataclasses
import importlib.util
import json
import math
import os
import random
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any, Callable, Sequence

import bempd

PROGRAM = Path(__file__).resolve().parents[1] / "peers/dolfinx_body.py"
NOTE = ("The table of peers is left out: python3-dolfinx or python3-gmsh is not installed "
        "(`benchmarks/run.sh bodies --only peers --with-peers`).")
REPEATS = 3
STEP, STEPS = 0.1, 10
QUARTER = (0.1, 0.00125, 0.2, 0.02)  # triangles for steps of a quarter

Sizes = tuple[float, float, float, float]  # of triangles: the largest, at tips, growth with the distance, at holes
Answer = dict[str, Any]


@dataclasses.dataclass
class Scene:
    name: str
    what: dict[str, Any]  # as benchmarks/peers/dolfinx_body.py reads it
    meshes: Sequence[Sizes]
    wanted: Sequence[float]
    reference: Callable[[Scene], Answer]
    show: Callable[[Answer], str]
    error: Callable[[Answer, Answer], str]


def model_of(what: dict[str, Any], options: dict[str, Any]) -> bempd.Model:
    model = bempd.Model(options={"threads": 1, "stepping.control": "path", **options})
    solid = model.add_material(young_modulus=1, poisson_ratio=0.3, fracture_energy=1 if "steps" in what else None)
    width, height = what["size"]
    body = model.add_body(solid, bempd.rectangle(0, 0, width, height))
    for x, y, radius in what["holes"]:
        model.add_circular_hole(body, (x, y), radius)
    for crack in what["cracks"]:
        model.add_crack(crack)
    model.fix_point((0, 0))
    model.fix_point((width, 0), "y")
    model.add_traction(body, 1, "y", proportional=-1)
    model.add_traction(body, 3, "y", proportional=1)
    return model


def solve(what: dict[str, Any], options: dict[str, Any]) -> Answer:
    """From the described scene to its answers, with the meshes that the library tries on the way."""
    model, size, loads = model_of(what, options), what["size"], []
    start = time.process_time()
    if "steps" in what:
        model.options["crack.step"] = what["step"]
        loads = [model.step_to_next_event(1e9).load_factor for _ in range(what["steps"])]
    else:
        model.step(1)
    factors = [(tip.stress_intensity_1, tip.stress_intensity_2) for tip in model.tips()][-1:]
    corner = float(model.evaluate([size], stress=False).displacement[0][1])
    path = [(vertex.x, vertex.y) for vertex in model.crack_path(1)] if what["cracks"] else []
    seconds = time.process_time() - start
    return {"displacement": corner, "factors": factors, "loads": loads, "path": path, "seconds": seconds, "meshing": None,
            "unknowns": model.plan().unknowns}


def own(wanted: float, what: dict[str, Any]) -> Answer:
    return min((solve(what, {"error.wanted": wanted}) for _ in range(REPEATS)), key=lambda answer: answer["seconds"])


def finite_elements(what: dict[str, Any], meshes: Sequence[Sizes], cache: str) -> tuple[dict[str, float], list[Answer]]:
    """Seconds before the first mesh, and the answers; seconds are the least of the repetitions."""
    asked = json.dumps({**what, "meshes": [mesh for mesh in meshes for _ in range(REPEATS)]})
    done = subprocess.run([sys.executable, str(PROGRAM)], check=True, capture_output=True, text=True, input=asked,
                          env={**os.environ, "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1", "XDG_CACHE_HOME": cache})
    before, *answers = [json.loads(line) for line in done.stdout.splitlines() if line.startswith("{")]
    for answer in answers:
        answer["meshing"], answer["seconds"] = answer["seconds_mesh"], answer["seconds_mesh"] + answer["seconds_solve"]
    groups = [answers[k:k + REPEATS] for k in range(0, len(answers), REPEATS)]
    return before, [min(group, key=lambda answer: answer["seconds"]) for group in groups]


def factor(answer: Answer) -> float:
    return float(answer["factors"][0][0]) / math.sqrt(0.5 * math.pi)


def at_lengths(places: Sequence[Any], count: int) -> list[Any]:
    """Those at the ends of the long steps, of a path whose steps are a whole part of these."""
    return list(places)[::len(places) // count][:count]


def load_error(found: Answer, exact: Answer) -> float:
    pairs = zip(*(at_lengths(answer["loads"], STEPS) for answer in (found, exact)))
    return max(abs(load / true - 1) for load, true in pairs)


def growth_error(found: Answer, exact: Answer) -> str:
    """Of the loads, and how far the path's end lies from the other path."""
    x, y = found["path"][-1]
    off = min(distance((x, y), p, q) for p, q in zip(exact["path"], exact["path"][1:]))
    return f"{100 * load_error(found, exact):.2f} %, {off:.4f}"


def distance(place: Sequence[float], p: Sequence[float], q: Sequence[float]) -> float:
    (x, y), (u, v) = (place[0] - p[0], place[1] - p[1]), (q[0] - p[0], q[1] - p[1])
    share = min(max((x * u + y * v) / (u * u + v * v), 0), 1)
    return math.hypot(x - share * u, y - share * v)


def with_steps(what: dict[str, Any], parts: int) -> dict[str, Any]:
    return {**what, "step": STEP / parts, "steps": STEPS * parts, "ring": what["ring"] / parts}


def sixteen_holes() -> list[tuple[float, float, float]]:
    """A hole of pseudo-random radius and place in each unit cell."""
    choose = random.Random(1)
    holes = []
    for cell in range(16):
        radius = choose.uniform(0.18, 0.33)
        x, y = (0.8 * (0.5 - radius) * choose.uniform(-1, 1) for _ in range(2))
        holes.append((cell // 4 + 0.5 + x, cell % 4 + 0.5 + y, radius))
    return holes


def scenes() -> list[Scene]:
    centre = {"size": [2, 6], "holes": [], "cracks": [[[0.5, 3], [1.5, 3]]], "tips": [[0, -1]], "ring": 0.4}
    growing = {"size": [2, 2], "holes": [[0.7, 1.5, 0.2], [1.2, 0.6, 0.2], [1.6, 1.4, 0.15]], "cracks": [[[0, 1], [0.3, 1]]],
               "tips": [[0, -1]], "step": STEP, "steps": STEPS, "ring": 0.09}
    sheet = {"size": [4, 4], "holes": sixteen_holes(), "cracks": [], "tips": []}
    isida = {"factors": [(1.1867 * math.sqrt(0.5 * math.pi), 0)]}
    share = lambda value: lambda found, exact: f"{100 * abs(value(found) / value(exact) - 1):.3f} %"
    corner = lambda answer: float(answer["displacement"])
    return [
        Scene("centre crack, a/W = 0.5: K_I / p sqrt(pi a)", centre,
              ((1, 0.1, 0.5, 1), (1, 0.05, 0.4, 1), (1, 0.02, 0.3, 1), (1, 0.01, 0.2, 1)), (0.01, 0.001),
              lambda scene: isida, lambda answer: f"{factor(answer):.5f}", share(factor)),
        Scene(f"crack among holes, {STEPS} steps: first and last load; y of its end", growing,
              ((0.3, 0.02, 0.4, 0.08), (0.2, 0.01, 0.3, 0.04), (0.1, 0.005, 0.2, 0.02)), (0.01, 0.003),
              lambda scene: solve(with_steps(scene.what, 8), {"error.wanted": 0.003}),
              lambda answer: f"{answer['loads'][0]:.4f}, {at_lengths(answer['loads'], STEPS)[-1]:.4f}; "
                             f"{answer['path'][-1][1]:.4f}", growth_error),
        Scene("sheet with 16 holes: displacement of a corner", sheet,
              ((0.6, 1, 0.5, 0.2), (0.4, 1, 0.5, 0.1), (0.2, 1, 0.3, 0.05), (0.1, 1, 0.2, 0.02)), (0.01, 0.001),
              lambda scene: solve(scene.what, {"test.halvings": 3}), lambda answer: f"{corner(answer):.5f}", share(corner))]


def installed() -> bool:
    return importlib.util.find_spec("dolfinx") is not None and importlib.util.find_spec("gmsh") is not None


def row(scene: Scene, program: str, answer: Answer, exact: Answer) -> str:
    meshing = "" if answer["meshing"] is None else f"{answer['meshing']:.2f}"
    return (f"| {scene.name} | {program} | {scene.show(answer)} | {scene.error(answer, exact)} | {answer['seconds']:.2f} "
            f"| {meshing} | {answer['unknowns']:,} |")


def write_steps(file: Path, rows: Sequence[tuple[Any, ...]]) -> None:
    file.parent.mkdir(parents=True, exist_ok=True)
    with file.open("w", newline="", encoding="utf-8") as out:
        csv.writer(out).writerows([("program", "unknowns", "step", "x", "y", "load"), *rows])


def own_start() -> float:
    """Processor seconds of a process that imports bempd and makes a model."""
    before = os.times()
    subprocess.run([sys.executable, "-c", "import bempd; bempd.Model()"], check=True)
    after = os.times()
    return after.children_user + after.children_system - before.children_user - before.children_system


def table(quick: bool) -> list[str]:
    if not installed():
        return [NOTE]
    lines = ["| scene | program | answer | error | seconds | of them meshing | unknowns |", "|---|---|---|---|---|---|---|"]
    with tempfile.TemporaryDirectory() as cache:
        before: dict[str, float] = {}
        grown: list[tuple[Any, ...]] = []
        for scene in scenes()[:1] if quick else scenes():
            exact = scene.reference(scene)
            cases: list[tuple[str, dict[str, Any]]] = [("", scene.what)]
            if "steps" in scene.what:
                cases.append((", steps of a quarter", with_steps(scene.what, 4)))
            for name, what in cases:
                found = [(f"body, {100 * wanted:g} % wanted{name}", own(wanted, what))
                         for wanted in (scene.wanted[:1] if name else scene.wanted)]
                start, answers = finite_elements(what, [QUARTER] if name else scene.meshes, cache)
                before = before or start
                found += [(f"dolfinx{name}", answer) for answer in answers]
                lines += [row(scene, program, answer, exact) for program, answer in found]
                grown += [(program, answer["unknowns"], k + 1, *answer["path"][k + 2], load)
                          for program, answer in found for k, load in enumerate(answer.get("loads", ()))]
    if folder := os.environ.get("BEMPD_OUTPUT"):
        write_steps(Path(folder) / "peers_growth.csv", grown)
    return lines + ["", f"* Not counted, once a process: imports of dolfinx {before['imports']:.1f} s, of bempd {own_start():.1f} s. Not "
                        f"counted, once a user: compilation of dolfinx' forms, {before['compilation']:.1f} s.",
                    "* Errors of the growing crack: that of the loads, and the distance of the end from the path of steps an eighth as "
                    "long."]
