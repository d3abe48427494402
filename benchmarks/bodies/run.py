"""Bodies: wanted errors against true ones, the plan's promises against what came, cost over size, and lattice patches: tables of
docs/bodies.md.

usage: benchmarks/run.sh bodies [--write] [--quick] [--only TABLE]
    --write: into docs/bodies.md;  --quick: four scenes and two errors;  --only: trade, random, calibration, runs, promises, sheets, patches, bonds, following,
    near, sizes, treatments, peers or paper
"""

from __future__ import annotations

import math
import re
import resource
import subprocess
import sys
import time
import json
from pathlib import Path
from typing import Any, Callable

import numpy as np

import bempd
import calibration
import growing
import near
import paper
import patches
import peers
from error_check import answers, table, true_errors

PAGE = Path(__file__).resolve().parents[2] / "docs" / "bodies.md"
WANTED = (0.1, 0.03, 0.01, 0.003, 0.001)

Scene = Callable[[float, dict[str, Any]], tuple[bempd.Model, int]]


def new(wanted: float, options: dict[str, Any], corners: Any) -> tuple[bempd.Model, int]:
    model = bempd.Model(options={"error.wanted": wanted, **options})
    steel = model.add_material(young_modulus=1, poisson_ratio=0.3)
    return model, model.add_body(steel, corners)


def cantilever(wanted: float, options: dict[str, Any]) -> tuple[bempd.Model, int]:
    model, body = new(wanted, options, bempd.rectangle(0, 0, 4, 1))
    model.fix_edge(body, 4)
    model.add_traction(body, 2, "y", proportional=-1)
    return model, body


def plate_with_hole(wanted: float, options: dict[str, Any]) -> tuple[bempd.Model, int]:
    model, body = new(wanted, options, bempd.rectangle(0, 0, 2, 2))
    model.add_circular_hole(body, (1, 1), 0.3)
    model.fix_edge(body, 4, "x")
    model.fix_edge(body, 1, "y")
    model.add_traction(body, 2, "x", proportional=1)
    return model, body


def bracket(wanted: float, options: dict[str, Any]) -> tuple[bempd.Model, int]:
    model, body = new(wanted, options, [(0, 0), (2, 0), (2, 0.8), (0.8, 0.8), (0.8, 2), (0, 2)])
    model.fix_edge(body, 5)
    model.add_traction(body, 2, "y", proportional=-1)
    return model, body


def centre_crack(wanted: float, options: dict[str, Any]) -> tuple[bempd.Model, int]:
    model, body = new(wanted, options, bempd.rectangle(0, 0, 2, 4))
    model.add_crack([(0.5, 2), (1.5, 2)])
    model.fix_edge(body, 1, "y")
    model.fix_edge(body, 4, "x")
    model.add_traction(body, 3, "y", proportional=1)
    return model, body


def edge_crack(wanted: float, options: dict[str, Any]) -> tuple[bempd.Model, int]:
    model, body = new(wanted, options, bempd.rectangle(0, 0, 1, 3))
    model.add_crack([(0, 1.5), (0.4, 1.7)])
    model.fix_edge(body, 1)
    model.add_traction(body, 3, "y", proportional=1)
    return model, body


def two_cracks(wanted: float, options: dict[str, Any]) -> tuple[bempd.Model, int]:
    model, body = new(wanted, options, bempd.rectangle(0, 0, 3, 2))
    model.add_crack([(0.8, 1), (1.4, 1.1)])
    model.add_crack([(1.5, 1), (2.1, 0.9)])
    model.fix_edge(body, 1)
    model.prescribe_edge(body, 3, "y", 0.01)
    return model, body


def hole_and_crack(wanted: float, options: dict[str, Any]) -> tuple[bempd.Model, int]:
    model, body = new(wanted, options, bempd.rectangle(0, 0, 3, 1))
    model.add_circular_hole(body, (2, 0.5), 0.2)
    model.add_crack([(1, 0.35), (1.2, 0.65)])
    model.fix_edge(body, 4)
    model.add_traction(body, 2, "y", proportional=-1)
    return model, body


def thin_ligament(wanted: float, options: dict[str, Any]) -> tuple[bempd.Model, int]:
    model, body = new(wanted, options, bempd.rectangle(0, 0, 3, 1.5))
    model.add_circular_hole(body, (1.2, 0.75), 0.3)
    model.add_circular_hole(body, (1.83, 0.75), 0.3)
    model.fix_edge(body, 4, "x")
    model.fix_edge(body, 1, "y")
    model.add_traction(body, 2, "x", proportional=1)
    return model, body


def round_body(wanted: float, options: dict[str, Any]) -> tuple[bempd.Model, int]:
    model, body = new(wanted, options, [(1, 0), (0, 1), (-1, 0), (0, -1)])
    for edge in range(1, 5):
        middle = math.pi / 4 + (edge - 1) * math.pi / 2
        model.set_edge_arc(body, edge, (math.cos(middle), math.sin(middle)))
    model.prescribe_edge(body, 1, "x", constant=0, part=(0, 0.1))
    model.fix_edge(body, 3)
    model.add_pressure(body, 1, proportional=1)
    return model, body


def strip(wanted: float, options: dict[str, Any]) -> tuple[bempd.Model, int]:
    model, body = new(wanted, options, bempd.rectangle(0, 0, 20, 1))
    model.fix_edge(body, 4)
    model.add_traction(body, 3, "y", proportional=-1, part=(0.4, 0.6))
    return model, body


def spinning(wanted: float, options: dict[str, Any]) -> tuple[bempd.Model, int]:
    model, body = new(wanted, options, bempd.rectangle(-1, -1, 1, 1))
    model.add_hole(body, [(-0.3, -0.3), (-0.3, 0.3), (0.3, 0.3), (0.3, -0.3)])
    model.fix_edge(body, 4)
    model.add_body_force(body, "y", proportional=-1)
    return model, body


def four_holes(wanted: float, options: dict[str, Any]) -> tuple[bempd.Model, int]:
    model, body = new(wanted, options, bempd.rectangle(0, 0, 2, 2))
    for x in (0.5, 1.5):
        for y in (0.5, 1.5):
            model.add_circular_hole(body, (x, y), 0.25)
    model.fix_edge(body, 1)
    model.add_traction(body, 3, "x", proportional=1)
    return model, body


SCENES: tuple[tuple[str, Scene], ...] = (
    ("cantilever", cantilever), ("plate with a hole", plate_with_hole), ("bracket", bracket), ("centre crack", centre_crack),
    ("slanted edge crack", edge_crack), ("two cracks", two_cracks), ("hole and crack", hole_and_crack),
    ("ligament of a tenth of the holes", thin_ligament), ("round body under pressure", round_body), ("strip of 20 to 1", strip),
    ("square hole under weight", spinning), ("four holes in shear", four_holes))


def trade(quick: bool) -> list[str]:
    """Wanted, told and true error, elements and seconds of each scene. The true error is that against elements halved four times."""
    lines = ["| scene | wanted | told | true | elements | seconds |", "|---|---|---|---|---|---|"]
    told_enough = close = met = count = 0
    for name, scene in SCENES[:4] if quick else SCENES:
        finest, body = scene(0.001, {"test.halvings": 4})
        exact = answers(finest, body)
        most = finest.plan().boundary_elements
        for wanted in WANTED[1:4:2] if quick else WANTED:
            model, body = scene(wanted, {})
            begin = time.perf_counter()
            model.prepare()
            seconds = time.perf_counter() - begin
            plan = model.plan()
            if plan.boundary_elements >= most:
                raise SystemExit(f"{name}: the reference has {most} elements, no more than the mesh for {wanted:g}; halve it once more")
            told = max(plan.displacement_error, plan.reaction_error, plan.intensity_error)
            true = max(true_errors(answers(model, body), exact).values())
            count += 1
            told_enough, close, met = told_enough + (true <= told), close + (told <= 3 * true), met + (true <= wanted)
            lines.append(f"| {name} | {100 * wanted:g} % | {100 * told:.2g} % | {100 * true:.2g} % | {plan.boundary_elements} "
                         f"| {seconds:.2f} |")
    return lines + ["", f"* {met} of {count} have a true error below the one wanted.",
                    f"* {told_enough} of {count} tell at least the true error, {close} at most three times it."]


def random_bodies(quick: bool) -> list[str]:
    """Told and true errors of bodies that nobody has chosen."""
    return table(1, 5 if quick else 24)


def calibrated(quick: bool) -> list[str]:
    """Told and true errors of all results, of scenes with which no factor was chosen."""
    return calibration.table(101, 4 if quick else 40, 1 if quick else 8)


def runs(quick: bool) -> list[str]:
    """Told and true errors of runs in which cracks grow."""
    return growing.table(201, 3 if quick else 8)


def promise(name: str) -> dict[str, float]:
    """Promises of a plan and what came, in a process of its own for the memory."""
    scene = dict(SCENES)[name]
    model, _ = scene(0.001, {})
    plan = model.plan()
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    begin = time.perf_counter()
    model.prepare()
    seconds = time.perf_counter() - begin
    came = model.plan()
    return {"elements": plan.boundary_elements, "elements_came": came.boundary_elements, "unknowns": plan.unknowns,
            "unknowns_came": came.unknowns, "error": max(plan.displacement_error, plan.reaction_error, plan.intensity_error),
            "error_came": max(came.displacement_error, came.reaction_error, came.intensity_error),
            "seconds": plan.seconds, "seconds_came": seconds, "memory": plan.memory / 1e6, "solved": plan.is_solved,
            "memory_came": (resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before) / 1e3}


def promises(quick: bool) -> list[str]:
    lines = ["| scene, 0.1 % | elements | came | unknowns | came | error | came | seconds | came |", "|---|---|---|---|---|---|---|---|---|"]
    for name, _ in SCENES[:4] if quick else SCENES:
        command = [sys.executable, "-W", "ignore", __file__, "--promise", name]
        p = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
        lines.append(f"| {name} | {p['elements']} | {p['elements_came']} | {p['unknowns']} | {p['unknowns_came']} "
                     f"| {100 * p['error']:.2g} % | {100 * p['error_came']:.2g} % | {p['seconds']:.2f} "
                     f"| {'solved by the plan' if p['solved'] else format(p['seconds_came'], '.2f')} |")
    return lines


def largest_memory() -> float:
    """Of this process [GB]. The resource module would tell that of the process which started it, if it is larger."""
    with open("/proc/self/status", encoding="ascii") as file:
        status = file.read()
    found = re.search(r"VmHWM:\s+(\d+) kB", status)
    return float(found.group(1)) / 1e6 if found else float("nan")


def sheet(count: int) -> list[str]:
    """Cost of sheets with count x count holes."""
    model, body = new(0.01, {"threads": 2}, bempd.rectangle(0, 0, count, count))
    for i in range(count):
        for j in range(count):
            model.add_circular_hole(body, (i + 0.5, j + 0.5), 0.2 + 0.1 * math.sin(i + 2 * j))
    model.fix_edge(body, 1)
    model.add_traction(body, 3, "y", proportional=1)
    begin = time.perf_counter()
    model.prepare()
    plan, sizes = model.plan(), model.statistics()
    return [f"| {count * count} | {plan.boundary_elements:,} | {sizes.subdomains} | {100 * plan.displacement_error:.2g} % "
            f"| {time.perf_counter() - begin:.1f} | {largest_memory():.2f} |"]


def sheets(quick: bool) -> list[str]:
    lines = ["| holes | elements | subdomains | error told, 1 % wanted | seconds with coarser meshes | memory [GB] |",
             "|---|---|---|---|---|---|"]
    for count in (2, 4) if quick else (2, 4, 8):
        command = [sys.executable, "-W", "ignore", __file__, "--sheet", str(count)]
        lines.append(subprocess.run(command, check=True, capture_output=True, text=True).stdout.strip())
    return lines


def main() -> None:
    np.seterr(all="raise")
    if "--promise" in sys.argv:
        print(json.dumps(promise(sys.argv[-1])))
        return
    if "--sheet" in sys.argv:
        print(sheet(int(sys.argv[-1]))[0])
        return
    quick = "--quick" in sys.argv
    only = sys.argv[sys.argv.index("--only") + 1] if "--only" in sys.argv else None
    for name, make in (("trade", trade), ("random", random_bodies), ("calibration", calibrated), ("runs", runs), ("promises", promises), ("sheets", sheets),
                       ("patches", patches.against_lattices), ("bonds", patches.bond_by_bond), ("following", patches.following), ("near", near.table),
                       ("sizes", patches.sizes), ("treatments", patches.treatments), ("peers", peers.table), ("paper", paper.table)):
        if only not in (None, name):
            continue
        lines = make(quick)
        print("\n".join(lines), flush=True)
        if "--write" in sys.argv and len(lines) > 1:  # more than a sentence that says why there is no table
            text = PAGE.read_text(encoding="utf-8")
            block = f"<!-- {name} -->\n" + "\n".join(lines) + "\n<!-- end -->"
            found = re.sub(rf"<!-- {name} -->.*?<!-- end -->", lambda _: block, text, flags=re.DOTALL)
            PAGE.write_text(found, encoding="utf-8")


if __name__ == "__main__":
    main()
