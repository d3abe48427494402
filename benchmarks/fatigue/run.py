"""Lives of cracks under cycles, resistances and specimens: the tables of docs/fatigue.md.

usage: benchmarks/run.sh fatigue [--write] [--references]
    --write: into docs/fatigue.md;  --references: measures the lives with small steps anew and prints them
"""

from __future__ import annotations

import re
import sys
import time
from pathlib import Path

import bempd
import bodies
import lives
import resistance

PAGE = Path(__file__).resolve().parents[2] / "docs" / "fatigue.md"


def row(what: str, steps: int, value: float, reference: float, against: str, seconds: float) -> str:
    return f"| {what} | {steps} | {100 * (value / reference - 1):+.3f} % | {against} | {seconds:.2f} |"


def rows_of_square(scene: str) -> list[str]:
    elements, lines = lives.square_life(scene), []
    for spacings in (40, 60, 80):
        begin = time.perf_counter()
        found = lives.square_life(scene, spacings)
        lines.append(f"| {scene} as a line in a lattice of {spacings} spacings | | {100 * (found / elements - 1):+.3f} % "
                     f"| boundary elements | {time.perf_counter() - begin:.2f} |")
    return lines


def rows_of_halves(scene: str) -> list[str]:
    elements, lines = lives.life_in_halves("elements", "elements", scene), []
    for left, right in (("elements", "lattice"), ("lattice", "elements"), ("lattice", "lattice")):
        begin = time.perf_counter()
        found = lives.life_in_halves(left, right, scene)
        lines.append(f"| {scene}, {left} and {right} of 40 spacings | | {100 * (found[-1] / elements[-1] - 1):+.3f} % "
                     f"| boundary elements | {time.perf_counter() - begin:.2f} |")
    return lines


def rows_of_cases(shear: float) -> list[str]:
    end = lives.SQUARES["centre crack"][1]
    elements, lines = lives.life_under_cases(shear=shear).cycles_at(end), []
    for spacings in (40, 60, 80):
        begin = time.perf_counter()
        found = lives.life_under_cases(spacings, shear).cycles_at(end)
        lines.append(f"| spectrum of load cases with {shear:g} of shear, a line in {spacings} spacings | | {100 * (found / elements - 1):+.3f} % "
                     f"| boundary elements | {time.perf_counter() - begin:.2f} |")
    return lines


def table() -> list[str]:
    lines = ["| life | steps | difference | from | time [s] |", "|---|---|---|---|---|"]
    for options in ({}, {"tolerance": 1e-2, "largest_step": 0.5}, {"largest_step": 0.1}):
        begin = time.perf_counter()
        life = lives.centre_crack(**options)
        seconds = time.perf_counter() - begin
        said = ", ".join(f"{name} {value}" for name, value in options.items()) or "defaults"
        lines.append(row(f"centre crack, {said}", life.steps, life.cycles, lives.CENTRE_CRACK_FINE, "small steps", seconds))
        if not options:
            lines.append(row("the same", life.steps, life.cycles, lives.centre_crack_by_handbook(),
                             "Tada's formula (0.1 %)", seconds))
    begin = time.perf_counter()
    life = lives.wide_plate()
    lines.append(row("wide plate", life.steps, life.cycles, lives.wide_plate_by_closed_form(), "closed form",
                     time.perf_counter() - begin))
    for options in ({}, {"tolerance": 1e-2, "largest_step": 0.5}):
        begin = time.perf_counter()
        life = lives.cracks_from_a_hole(**options)
        said = ", ".join(f"{name} {value}" for name, value in options.items()) or "defaults"
        lines.append(row(f"two unequal cracks from a hole, {said}", life.steps, life.cycles,
                         lives.CRACKS_FROM_A_HOLE_FINE, "small steps", time.perf_counter() - begin))
    for order, name in (([0, 1], "high block first"), ([1, 0], "low block first")):
        begin = time.perf_counter()
        growth, exact = lives.blocks_in_order(order)
        lines.append(f"| growth by two long blocks, {name} | | {100 * (growth / exact - 1):+.3f} % | integration "
                     f"| {time.perf_counter() - begin:.2f} |")
    begin = time.perf_counter()
    cycles, exact = lives.many_blocks()
    lines.append(f"| spectrum of three short blocks | | {100 * (cycles / exact - 1):+.3f} % | closed form "
                 f"| {time.perf_counter() - begin:.2f} |")
    begin = time.perf_counter()
    cycles, exact = lives.two_load_cases()
    lines.append(f"| spectrum of a pull and a pressure in the crack as load cases | | {100 * (cycles / exact - 1):+.3f} % "
                 f"| closed form | {time.perf_counter() - begin:.2f} |")
    for kind in ("middle crack", "edge crack"):
        begin = time.perf_counter()
        length, exact = lives.net_section(kind)
        lines.append(f"| length at which the net section yields, {kind} | | {100 * (length / exact - 1):+.3f} % "
                     f"| limit analysis | {time.perf_counter() - begin:.2f} |")
    for kind, name in (("wheeler", "Wheeler"), ("willenborg", "Willenborg")):
        for program in ("an overload in each 5000 cycles", "one overload"):
            begin = time.perf_counter()
            growth, exact = lives.retarded(kind, program)
            lines.append(f"| growth by {name}'s model, {program} | | {100 * (growth / exact - 1):+.3f} % | integration "
                         f"| {time.perf_counter() - begin:.2f} |")
    for scene in lives.SQUARES:
        lines += rows_of_square(scene)
    for scene in lives.HALVES:
        lines += rows_of_halves(scene)
    for shear in (0.0, 0.4):
        lines += rows_of_cases(shear)
    return lines


def resistance_table() -> list[str]:
    lines = ["| resistance | value | reference | difference |", "|---|---|---|---|"]
    for length, (exact, _) in resistance.PEAKS.items():
        found = resistance.peak(length)
        lines.append(f"| peak of sigma (a0 / E G)^(1/2), l / a0 = {length:g} | {found:.5f} | {exact:.5f} "
                     f"| {100 * (found / exact - 1):+.3f} % |")
    for kind in ("elements", "lines"):
        found = resistance.critical_ratio(kind)
        lines.append(f"| weak plane at 45 degrees taken below, {kind} | {found:.4f} | 0.7300 | {100 * (found / 0.73 - 1):+.3f} % |")
    return lines


def specimen_table() -> list[str]:
    lines = ["| specimen | shape | from the formula | the source states | from the energy | source |", "|---|---|---|---|---|---|"]
    for kind, sizes, shape in bodies.CASES:
        specimen = bempd.specimens.KINDS[kind](**sizes)
        formula = specimen.formula
        stated = "nothing" if formula.accuracy != formula.accuracy else f"{100 * formula.accuracy:g} %"
        difference = f"{100 * specimen.difference():+.2f} %" if formula.holds else "does not hold"
        lines.append(f"| {kind} | {shape} | {difference} | {stated} | {100 * bodies.by_energy(kind, sizes):+.3f} % | {formula.source} |")
    return lines


def main() -> None:
    if "--references" in sys.argv:
        for name, life in (("CENTRE_CRACK_FINE", lives.centre_crack), ("CRACKS_FROM_A_HOLE_FINE", lives.cracks_from_a_hole)):
            fine = life(largest_step=0.018, tolerance=0.01)
            print(f"{name}: {fine.cycles:.9g} with {fine.steps} steps")
        return
    text = PAGE.read_text(encoding="utf-8")
    for name, lines in (("table", table()), ("resistances", resistance_table()), ("specimens", specimen_table())):
        print("\n".join(lines))
        begin, end = f"<!-- {name} of run.py -->\n", "<!-- end of it -->"
        found = begin + "\n".join(lines) + "\n" + end
        text = re.sub(re.escape(begin) + ".*?" + re.escape(end), lambda _, found=found: found, text, flags=re.DOTALL)
    if "--write" in sys.argv:
        PAGE.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
