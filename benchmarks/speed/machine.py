"""Limits of the machine, the stages of a set-up against them, and what boundary operators and lattices need."""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import time
from typing import Any, Callable

import numpy as np

from rows import Table, measure

Limits = dict[str, tuple[float, str]]


def least_seconds(work: Callable[[], Any], repeats: int = 5) -> float:
    seconds = []
    for _ in range(repeats):
        start = time.process_time()
        work()
        seconds.append(time.process_time() - start)
    return min(seconds)


def kernel_rate() -> float:
    """Pairs of points a second for which the kernels can be computed, with everything in the first cache."""
    program = os.path.join(os.environ["BEMPD_BENCHMARKS"], "bempd_kernel_rate")
    output = subprocess.run([program, "--benchmark_filter=^kernels_in_lanes", "--benchmark_format=json"], check=True,
                            capture_output=True, text=True).stdout
    return float(json.loads(output)["benchmarks"][0]["items_per_second"])


def limits() -> Limits:
    """Reached on one core by numpy, a copy of 64 MB, read and written, and a product of two matrices of 1000; and the
    kernels of boundary elements."""
    source = np.ones(8 << 20)
    target = np.zeros_like(source)
    copy = 2 * source.nbytes / least_seconds(lambda: np.copyto(target, source))
    a = np.ones((1000, 1000))
    product = 2e9 / least_seconds(lambda: a @ a)
    return {"copy": (copy / 1e9, "GB/s"), "matrix product": (product / 1e9, "GFLOP/s"),
            "kernels": (kernel_rate() / 1e6, "million pairs of points/s")}


def stages(limit: Limits, arguments: argparse.Namespace) -> None:
    """The stages of one elastic solve. A factor with z entries in n columns needs z^2 / n operations at least; a
    solution reads it twice."""
    table = Table("stages", "Stages of one elastic solve", ["scene", "stage", "seconds", "rate", "unit", "share of limit"])
    copy, product = limit["copy"][0], limit["matrix product"][0]
    for scene, settings in (("paper_crack", {}), ("plate", {"n": 100}), ("plate", {"n": 200})):
        name = f"plate {settings['n']}^2" if settings else "centre crack"
        result = measure(scene, settings, {}, "elastic", arguments.repeats)
        if "failed" in result:
            table.add([name, result["failed"], "", "", "", ""])
            continue
        s = result["statistics"]
        if s["seconds_boundary"] > 0:
            rate = s["kernel_evaluations"] / s["seconds_boundary"]
            table.add([name, "boundary operators", s["seconds_boundary"], rate / 1e6, "million kernels/s",
                       rate / 1e6 / limit["kernels"][0]])
        table.add([name, "lattice, bonds, weights", s["seconds_lattice"], s["bonds"] / s["seconds_lattice"] / 1e6,
                   "million bonds/s", ""])
        table.add([name, "condensation, assembly", s["seconds_assembly"], s["bonds"] / s["seconds_assembly"] / 1e6,
                   "million bonds/s", ""])
        entries, columns = s["factor_nonzeros"], s["sparse_unknowns"]
        flops = entries**2 / columns / s["seconds_factorization"] / 1e9
        table.add([name, "factorization", s["seconds_factorization"], flops, "GFLOP/s, at least", flops / product])
        bandwidth = 16 * entries * s["solver_iterations"] / s["seconds_solve"] / 1e9
        table.add([name, "solution", s["seconds_solve"], bandwidth, "GB/s of factor", bandwidth / copy])


def profile(arguments: argparse.Namespace) -> None:
    """Where a whole run spends its time, in elastic solves of the same scene."""
    table = Table("profile", "Where a whole run spends its time, in elastic solves of the same scene",
                  ["scene", "elastic solve [s]", "lattice, boundary, assembly", "factorizations", "their time",
                   "solutions of the whole body", "windows: inverse, events, certificate", "the rest", "sum"])
    for scene, settings in (("paper_crack", {}), ("plate", {"n": 100}), ("plate", {"n": 200})):
        name = f"plate {settings['n']}^2" if settings else "centre crack"
        result = measure(scene, settings, {}, "separation", 1 if settings.get("n", 0) > 100 else arguments.repeats)
        if "failed" in result:
            table.add([name, result["failed"]] + [""] * 7)
            continue
        s, unit = result["run_statistics"], result["elastic"]
        set_up = s["seconds_lattice"] + s["seconds_boundary"] + s["seconds_assembly"]
        parts = [set_up, s["seconds_factorization"], s["seconds_solve"] + s["seconds_update"], s["seconds_search"]]
        table.add([name, unit, set_up / unit, s["sparse_factorizations"], parts[1] / unit, parts[2] / unit, parts[3] / unit,
                   (result["seconds"] - sum(parts)) / unit, result["seconds"] / unit])


def boundary(arguments: argparse.Namespace) -> None:
    table = Table("boundary", "Dense operators of one boundary element region, a square pulled at one side",
                  ["elements", "nodes", "seconds", "memory [MB]", "kernels", "million kernels/s"])
    for elements in (250, 500, 1000) + ((2000,) if arguments.full else ()):
        result = measure("square", {"elements": elements}, {"bem.grading": "none"}, "elastic", 1)
        if "failed" in result:
            table.add([elements, result["failed"], "", "", "", ""])
            continue
        s = result["statistics"]
        table.add([s["boundary_elements"], s["boundary_nodes"], result["seconds"], result["megabytes"],
                   s["kernel_evaluations"], s["kernel_evaluations"] / result["seconds"] / 1e6])


def memory(arguments: argparse.Namespace) -> None:
    table = Table("memory", "Lattice plate, one elastic solve",
                  ["N", "unknowns", "seconds", "memory [MB]", "bytes per point", "factor entries per unknown",
                   "seconds / unknowns^1.5 [us]"])
    for n in (100, 200, 400) + ((700,) if arguments.full else ()):
        result = measure("plate", {"n": n}, {}, "elastic", 1)
        if "failed" in result:
            table.add([n, result["failed"]] + [""] * 8)
            continue
        s = result["statistics"]
        table.add([n, s["sparse_unknowns"], result["seconds"], result["megabytes"],
                   round(result["megabytes"] * 2**20 / n**2), s["factor_nonzeros"] / s["sparse_unknowns"],
                   1e6 * result["seconds"] / s["sparse_unknowns"]**1.5])
