"""bempd and finite element programs on the same plates: the fastest way of each to one displacement within TARGET."""

from __future__ import annotations

import importlib.util
import shutil
import sys
from itertools import product

from measure import Row, bempd_command, measure, run_json
from scenes import CLAMPED

TARGET = 1e-4
PROBLEMS = ("plate", "shear", "hole")
SIZES, REFINEMENTS = (0.2, 0.1, 0.05, 0.025, 0.0125, 0.00625), (1, 8, 32)
FINALISTS, ROUNDS, REPEATS = 2, 3, 5
ELEMENT_LENGTHS, GRADINGS = (0.2, 0.17, 0.126, 0.1, 0.08, 1 / 15, 0.05), (0, 2, 3, 4)


def has_module(*names: str) -> bool:
    return all(importlib.util.find_spec(name) for name in names)


def installed() -> list[str]:
    programs = {"FreeFem++": bool(shutil.which("FreeFem++")), "dolfinx": has_module("dolfinx", "gmsh"),
                "CalculiX": bool(shutil.which("ccx")) and has_module("gmsh")}
    return [name for name, there in programs.items() if there]


def command(program: str, problem: str, size: float, refinement: float, repeats: int) -> list[str]:
    start = {"FreeFem++": ["FreeFem++", "-nw", "-v", "0", "../peers/freefem.edp"],
             "dolfinx": [sys.executable, "../peers/dolfinx_p2.py"],
             "CalculiX": [sys.executable, "../peers/calculix.py"]}[program]
    return [*start, problem, str(size), str(refinement), str(repeats)]


def candidates_of_peer(program: str, problem: str) -> list[Row]:
    """One run per setting. A finer mesh than the coarsest good one of its family is slower, so it is not tried."""
    rows: list[Row] = []
    good_sizes = 0
    for size in SIZES:
        for refinement in REFINEMENTS:
            result = run_json(command(program, problem, size, refinement, 3), 1)
            if "refused" in result:
                continue
            error = abs(result["displacement"] / CLAMPED[problem][0] - 1)
            result["seconds_solve"] -= result.get("seconds_start", 0.0)
            rows.append({"problem": problem, "program": program, "setting": f"{size:g} m, corners / {refinement}",
                         "command": command(program, problem, size, refinement, REPEATS), **result, "error": error})
            if error <= TARGET:
                good_sizes += 1
                break
        if good_sizes == 2:
            break
    return rows


def candidates_of_bempd(problem: str) -> list[Row]:
    rows: list[Row] = []
    for length, grading in product(ELEMENT_LENGTHS, GRADINGS):
        settings = {"element_length": length, "edge_grading": grading, "bem.quadrature_tolerance": 1e-6, "threads": 1}
        result = run_json(bempd_command(problem, settings, 0.05), 1)
        by = f"graded by hand, {grading}" if grading else "graded automatically"
        rows.append({"problem": problem, "program": "bempd", "setting": f"{length:.3g} m, {by}, draft",
                     "command": bempd_command(problem, settings, 0.1), **result,
                     "seconds_solve": result["seconds"], "seconds_mesh": 0.0})
    return rows


def finalists(rows: list[Row]) -> list[Row]:
    good = sorted((row for row in rows if row["error"] <= TARGET), key=lambda row: row["seconds_solve"])
    return good[:FINALISTS]


def duel() -> tuple[list[Row], list[Row]]:
    """All that was tried, and per problem and program the fastest within TARGET, measured in turns."""
    tried: list[Row] = []
    best: list[Row] = []
    for problem in PROBLEMS:
        contestants: list[Row] = []
        for program in ["bempd", *installed()]:
            rows = candidates_of_bempd(problem) if program == "bempd" else candidates_of_peer(program, problem)
            tried += rows
            contestants += finalists(rows)
        for row, again in zip(contestants, measure([row["command"] for row in contestants], ROUNDS)):
            # Starting a program is taken off what was least of both, or noise would make the difference negative.
            row["seconds_solve"] = again.get("seconds_solve", again.get("seconds")) - again.get("seconds_start", 0.0)
            row["seconds_mesh"] = again.get("seconds_mesh", 0.0)
        for program in ["bempd", *installed()]:
            own = [row for row in contestants if row["program"] == program]
            if own:
                best.append(min(own, key=lambda row: row["seconds_solve"]))
                best[-1]["seconds_meshed"] = min(row["seconds_solve"] + row["seconds_mesh"] for row in own)
    return tried, best
