"""The speed table: what a whole crack run costs, over one elastic solve of the same scene and over other programs.

    benchmarks/run.sh speed [--full] [--repeats N] [--only PART,...] [--with-peers]

Parts: paper, sequences, plate, cracks, outlines, elastic, stages, profile, boundary, memory, peers. Prints Markdown, writes out/speed/*.csv and,
once there are plate and peers, docs/speed.png. One core, one process a row."""

from __future__ import annotations

import argparse
import os
import pathlib
import sys
from typing import Any

import machine
import peers
import plates
import plot
from rows import OUT, Table, measure

PARTS = ("paper", "sequences", "plate", "cracks", "outlines", "elastic", "stages", "profile", "boundary", "memory", "peers")
COLUMNS = ["scene", "way", "seconds", "elastic solve [s]", "ratio", "events", "bonds", "peak force", "memory [MB]",
           "residual"]


def row_of(scene: str, way: str, result: dict[str, Any]) -> list[Any]:
    if "failed" in result:
        return [scene, way, result["failed"]] + [""] * (len(COLUMNS) - 3)
    return [scene, way, result["seconds"], result["elastic"], result["seconds"] / result["elastic"],
            result.get("events", ""), result.get("bonds", ""), result.get("peak_force", ""), result["megabytes"],
            result.get("residual", "")]


def paper(arguments: argparse.Namespace) -> None:
    table = Table("paper", "Paper's centre crack, to separation", COLUMNS)
    increments = {"paper.mode": "paper", "paper.increment": 1}
    ways: list[tuple[str, dict[str, Any]]] = [
        ("symmetric, events, window", {"scheme": "symmetric"}),
        ("symmetric, events, plain", {"scheme": "symmetric", "test.solver": "plain"}),
        ("symmetric, increments", {"scheme": "symmetric"} | increments),
        ("paper, increments", {"scheme": "paper"} | increments)]
    if arguments.full:
        ways.append(("paper, events", {"scheme": "paper"}))
    for way, options in ways:
        result = measure("paper_crack", {"scheme": options["scheme"]}, options, "separation", arguments.repeats,
                         limit=500)
        result.pop("peak_force", None)
        table.add(row_of("centre crack", way, result))


def cracks(arguments: argparse.Namespace) -> None:
    table = Table("cracks", "Several cracks, to 0.1 % of the peak force per opening", COLUMNS)
    for n in (50, 100) if arguments.full else (50,):
        for kind in ("central", "two", "eight"):
            result = measure("plate", {"n": n, "cracks": kind}, {}, "force", 1 if n > 50 else arguments.repeats)
            table.add(row_of(f"{n} x {n}, {kind}", "window, band 0.1 %", result))


def outlines(arguments: argparse.Namespace) -> None:
    table = Table("outlines", "Crack past a hole, to separation: lattice rows and points on the outline", COLUMNS)
    for n in (50, 100) if arguments.full else (50,):
        for way, degrees in (("square hole on rows", None), ("round hole", 0), ("round hole, turned by 17 degrees", 17)):
            result = measure("holed_plate", {"n": n, "degrees": degrees}, {}, "separation", arguments.repeats)
            result.pop("peak_force", None)
            table.add(row_of(f"{n} x {n}", way, result))


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--full", action="store_true")
    parser.add_argument("--repeats", type=int, default=3)
    parser.add_argument("--only", default=",".join(PARTS))
    parser.set_defaults(peers=pathlib.Path(os.environ["BEMPD_BENCHMARKS"]))
    arguments = parser.parse_args()
    wanted = arguments.only.split(",")
    if unknown := set(wanted) - set(PARTS):
        sys.exit(f"no such part: {', '.join(sorted(unknown))}; there are {', '.join(PARTS)}")
    OUT.mkdir(parents=True, exist_ok=True)
    limits = machine.limits()
    print("One core: " + ", ".join(f"{name} {value:.3g} {unit}" for name, (value, unit) in limits.items()))
    own: dict[int, dict[str, Any]] = {}
    if "paper" in wanted:
        paper(arguments)
    if "sequences" in wanted:
        plates.paper_sequences(arguments, COLUMNS, row_of)
    if "plate" in wanted:
        own = plates.plate(arguments, COLUMNS, row_of)
    if "cracks" in wanted:
        cracks(arguments)
    if "outlines" in wanted:
        outlines(arguments)
    if "elastic" in wanted:
        plates.elastic(arguments)
    if "stages" in wanted:
        machine.stages(limits, arguments)
    if "profile" in wanted:
        machine.profile(arguments)
    if "boundary" in wanted:
        machine.boundary(arguments)
    if "memory" in wanted:
        machine.memory(arguments)
    if "peers" in wanted:
        peers.compare(arguments, own)
    if all((OUT / f"{name}.csv").exists() for name in ("plate", "peers")):
        plot.draw()


main()
