"""Large BEM regions, whole and cut into subdomains: the tables of docs/scaling.md.

usage: benchmarks/run.sh subdomains [--write] [--quick] [--growth [--holes N]]
    --write: into docs/scaling.md;  --quick: small bodies only;  --growth: growing cracks only, in sheets of at most N holes
"""

from __future__ import annotations

import json
import math
import random
import re
import resource
import subprocess
import sys
import time
from pathlib import Path
from typing import Any, Iterator

import bempd

PAGE = Path(__file__).resolve().parents[2] / "docs" / "scaling.md"
POROSITY, THREADS, WHOLE = 0.2, 2, 10**9
# Holes, elements on each, largest subdomain (0: the library's choice).
SHEETS = ((16, 48, 0), (16, 48, WHOLE), (64, 48, 0), (256, 48, 0), (1024, 48, 0))
OTHER_CUTS = ((64, 48, 40), (64, 48, 160), (256, 48, 40), (256, 48, 160))
SQUARES = ((500, 0), (1000, WHOLE), (1000, 0), (2000, 0), (8000, 0), (32000, 0))

# Sheets with cracks, likewise, and the steps of growth that are timed.
GROWING = ((16, 24, WHOLE), (16, 24, 80), (64, 48, 0), (256, 48, 0), (1024, 48, 0))
STEPS, MOST_CRACKS = 3, 10

Answer = dict[str, Any]


def sheet(holes: int, elements_of_hole: int, most: int) -> bempd.Model:
    """Square sheet with a round hole of random size and place in each unit cell, to be stretched by its left and right edge."""
    count = math.isqrt(holes)
    model = new_model(most)
    solid = model.add_material(young_modulus=1, poisson_ratio=0.3, fracture_energy=1e-9)
    region = model.add_bem_region(solid, bempd.rectangle(0, 0, count, count), 1 / 8)
    for x, y, radius in holes_of(count):
        first = model.add_circular_hole(region, (x, y), radius)
        for edge in range(first, first + 4):
            model.set_edge_mesh(region, edge, 2 * math.pi * radius / elements_of_hole)
    stretch(model, region, count)
    return model


def cracked(holes: int, elements_of_hole: int, most: int) -> bempd.Model:
    """Such a sheet, pulled, with a crack that begins at the right side of one hole in each of some rows of cells."""
    model, count = sheet(holes, elements_of_hole, most), math.isqrt(holes)
    for row in [*range(0, count, max(1, count // MOST_CRACKS))][:MOST_CRACKS]:
        column = (7 * row + 1) % count
        x, y, radius = hole_in(count, column, row)
        model.add_crack([(x + radius * math.cos(0.5), y + radius * math.sin(0.5)),
                         (x + (radius + 0.08) * math.cos(0.5), y + (radius + 0.08) * math.sin(0.5))])
    return model


def hole_in(count: int, column: int, row: int) -> tuple[float, float, float]:
    return list(holes_of(count))[column * count + row]


def holes_of(count: int) -> Iterator[tuple[float, float, float]]:
    """Centre and radius of the hole in each cell."""
    choose = random.Random(1)
    for i in range(count):
        for j in range(count):
            radius = math.sqrt(POROSITY / math.pi) * choose.uniform(0.7, 1.3)
            room = 0.8 * (0.5 - radius)
            yield (i + 0.5 + room * choose.uniform(-1, 1), j + 0.5 + room * choose.uniform(-1, 1), radius)


def square(elements: int, most: int) -> bempd.Model:
    model = new_model(most)
    region = model.add_bem_region(model.add_material(young_modulus=1, poisson_ratio=0.3), bempd.rectangle(0, 0, 1, 1),
                                  4 / elements)
    stretch(model, region, 1)
    return model


def new_model(most: int) -> bempd.Model:
    return bempd.Model(options={"threads": THREADS, "test.subdomain_elements": most, "bem.grading": "none"})


def stretch(model: bempd.Model, region: int, width: float) -> None:
    """By a thousandth, with both ends held across the pull, so that no field is uniform."""
    model.fix_edge(region, 4)
    model.fix_edge(region, 2, "y")
    model.prescribe_edge(region, 2, "x", 1e-3 * width)


def grow(*numbers: int) -> Answer:
    """Growth of the cracks, step by step: load factors, stress intensity factors and processor seconds of a step."""
    model = cracked(*numbers)
    begin = time.process_time()
    loads = [model.step_to_next_event(1e9).load_factor]
    first, begin = time.process_time() - begin, time.process_time()
    for _ in range(STEPS):
        loads.append(model.step_to_next_event(1e9).load_factor)
    seconds = (time.process_time() - begin) / STEPS
    sizes = model.statistics()
    ends = [[grown.x, grown.y] for grown in model.extensions()]
    return {"nodes": sizes.boundary_nodes, "subdomains": sizes.subdomains, "cracks": model.crack_count(), "first": first,
            "seconds": seconds, "parts": [sizes.seconds_boundary, sizes.seconds_factorization, sizes.seconds_solve],
            "memory": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e6, "loads": loads, "ends": ends,
            "factors": [tip.stress_intensity_1 for tip in model.tips()]}


def solve(kind: str, *numbers: int) -> Answer:
    if kind == "grow":
        return grow(*numbers)
    model = {"sheet": sheet, "square": square}[kind](*numbers)
    begin = time.perf_counter()
    report = model.step(1)
    seconds = time.perf_counter() - begin
    sizes = model.statistics()
    used = resource.getrusage(resource.RUSAGE_SELF)
    return {"nodes": sizes.boundary_nodes, "subdomains": sizes.subdomains, "cut_nodes": sizes.cut_nodes, "seconds": seconds,
            "memory": used.ru_maxrss / 1e6, "processor": used.ru_utime + used.ru_stime, "energy": report.stored_energy}


def in_process(kind: str, *numbers: int) -> Answer:
    """A process of its own for each, so that its peak of memory is known."""
    command = [sys.executable, __file__, "--solve", kind, *map(str, numbers)]
    return json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)  # type: ignore[no-any-return]


def row(name: str, answer: Answer) -> str:
    parts = f"{answer['subdomains']:,}" if answer["subdomains"] else "whole"
    return (f"| {name} | {answer['nodes']:,} | {parts} | {answer['cut_nodes']:,} | {answer['seconds']:.2f} "
            f"| {answer['memory']:.2f} | {answer['energy']:.9g} |")


def table(quick: bool) -> list[str]:
    lines = ["| body | nodes | subdomains | nodes on cuts | seconds | memory [GB] | energy |", "|---|---|---|---|---|---|---|"]
    energies: dict[tuple[int, int], float] = {}
    for holes, elements, most in SHEETS[:2] if quick else SHEETS:
        answer = in_process("sheet", holes, elements, most)
        energies[holes, most] = answer["energy"]
        lines.append(row(f"sheet, {holes:,} holes", answer))
    for holes, elements, most in () if quick else OTHER_CUTS:
        answer = in_process("sheet", holes, elements, most)
        energies[holes, most] = answer["energy"]
        lines.append(row(f"sheet, {holes:,} holes, subdomains of {most}", answer))
    finer = in_process("sheet", 16, 96, 0)
    for elements, most in SQUARES[:3] if quick else SQUARES:
        lines.append(row(f"square, {elements:,} elements", in_process("square", elements, most)))
    cut = energies[16, 0] / energies[16, WHOLE] - 1
    lines += ["", f"* 16 holes: the cuts change the energy by {cut:+.1e}. Twice as many elements on the holes change it by "
              f"{finer['energy'] / energies[16, 0] - 1:+.1e}."]
    for holes in () if quick else (64, 256):
        others = [energies[holes, most] / energies[holes, 0] - 1 for most in (40, 160)]
        lines.append(f"* {holes} holes: subdomains of 40 and of 160 elements change the energy by {others[0]:+.1e} and "
                     f"{others[1]:+.1e}.")
    return lines


def growth(quick: bool) -> list[str]:
    lines = ["| body | cracks | nodes | subdomains | processor seconds until the first growth | of a step "
             "| wall seconds of the last scene: operators, factor, solutions | memory [GB] |", "|---|---|---|---|---|---|---|---|"]
    most = int(sys.argv[sys.argv.index("--holes") + 1]) if "--holes" in sys.argv else GROWING[-1][0]
    answers = {numbers: in_process("grow", *numbers) for numbers in (GROWING[:2] if quick else GROWING) if numbers[0] <= most}
    for (holes, _, _), answer in answers.items():
        parts = f"{answer['subdomains']:,}" if answer["subdomains"] else "whole"
        lines.append(f"| sheet, {holes:,} holes | {answer['cracks']} | {answer['nodes']:,} | {parts} | {answer['first']:.0f} "
                     f"| {answer['seconds']:.2f} | {', '.join(f'{one:.2f}' for one in answer['parts'])} "
                     f"| {answer['memory']:.2f} |")
    whole, cut = answers[GROWING[0]], answers[GROWING[1]]
    off = {name: max(abs(b / a - 1) for a, b in zip(whole[name], cut[name])) for name in ("loads", "factors")}
    ends = max(math.dist(a, b) for a, b in zip(whole["ends"], cut["ends"]))
    return [*lines, "", f"* Cut and whole, after {STEPS + 1} steps: loads {off['loads']:.1e} apart, stress intensity factors "
            f"{off['factors']:.1e}, ends of cracks {ends:.1e} of a cell."]


def write(name: str, lines: list[str]) -> None:
    begin, end = f"<!-- {name} of benchmarks/subdomains -->\n", "<!-- end of it -->"
    found = begin + "\n".join(lines) + "\n" + end
    text = PAGE.read_text(encoding="utf-8")
    PAGE.write_text(re.sub(re.escape(begin) + ".*?" + re.escape(end), lambda _: found, text, count=1, flags=re.DOTALL),
                    encoding="utf-8")


def main() -> None:
    if "--solve" in sys.argv:
        print(json.dumps(solve(sys.argv[2], *map(int, sys.argv[3:]))))
        return
    quick, writes = "--quick" in sys.argv, "--write" in sys.argv
    tables = {"growth": growth} if "--growth" in sys.argv else {"table": table, "growth": growth}
    for name, make in tables.items():
        lines = make(quick)
        print("\n".join(lines))
        if writes:
            write(name, lines)


if __name__ == "__main__":
    main()
