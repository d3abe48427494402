"""Cracks across the border of boundary elements and a lattice: the tables of docs/mixed_cracks.md.

usage: benchmarks/run.sh mixed_cracks [--write] [run.py | crossing.py]
    --write: into docs/mixed_cracks.md;  run.py: cracks that stand still only;  crossing.py: cracks that run only
"""

from __future__ import annotations

import math
import re
import sys
from pathlib import Path

import bempd
import crossing

PAGE = Path(__file__).resolve().parents[2] / "docs" / "mixed_cracks.md"
WIDTH, HEIGHT, MIDDLE, HALF_LENGTH = 80, 64, 40, 16  # in spacings
ANGLES = (0, 20, 45, 63)
# Half the way that the border goes sideways, what it is, and the height of the crack's middle.
BORDERS = ((0, "on a row, crossed in the middle", 32.5), (0, "on a row, 0.2 beside the middle", 32.3),
           (0, "on a row, at a point", 32.0), (5, "9 degrees to rows", 32.5), (12, "21 degrees to rows", 32.5))

Tip = tuple[float, float]  # K_I, K_II
Answer = tuple[list[Tip], float]  # of the start and the end, and the stored energy


def plate(kind: str, degrees: float, height: float, slant: float = 0, horizon_ratio: int = 4) -> Answer:
    """A plate that is pulled by its ends, with a crack in its middle."""
    model = bempd.Model()
    solid = model.add_material(young_modulus=1, poisson_ratio=1 / 3)
    left = [(0, 0), (MIDDLE - slant, 0), (MIDDLE + slant, HEIGHT), (0, HEIGHT)]
    right = [(MIDDLE - slant, 0), (WIDTH, 0), (WIDTH, HEIGHT), (MIDDLE + slant, HEIGHT)]
    whole = bempd.rectangle(0, 0, WIDTH, HEIGHT)
    if kind == "elements":
        regions = [model.add_bem_region(solid, whole, 4)]
    elif kind == "lattice":
        regions = [model.add_pd_region(solid, whole, 1, horizon_ratio)]
    else:
        regions = [model.add_bem_region(solid, left, 4), model.add_pd_region(solid, right, 1, horizon_ratio)]
    along = HALF_LENGTH * math.cos(math.radians(degrees)), HALF_LENGTH * math.sin(math.radians(degrees))
    model.add_crack([(MIDDLE - along[0], height - along[1]), (MIDDLE + along[0], height + along[1])])
    for region in regions:
        model.fix_edge(region, 1, "y")
        model.prescribe_edge(region, 3, "y", 1)
    model.fix_point((0, 0), "x")
    energy = model.step(1).stored_energy
    tips = sorted(model.tips(), key=lambda tip: int(tip.end))
    return [(tip.stress_intensity_1, tip.stress_intensity_2) for tip in tips], energy


def off(tip: Tip, reference: Tip) -> float:
    """Difference of both factors over their size, in per cent."""
    return 100 * math.dist(tip, reference) / math.hypot(*reference)


def table() -> list[str]:
    lines = ["| crack to the rows | border | K, tip of elements | K, tip of bonds | K, lattice alone "
             "| energy | energy, lattice alone |", "|---|---|---|---|---|---|---|"]
    for degrees in ANGLES:
        for slant, border, height in BORDERS:
            elements, alone = plate("elements", degrees, height), plate("lattice", degrees, height)
            mixed = plate("mixed", degrees, height, slant)
            lines.append(
                f"| {degrees} | {border} | {off(mixed[0][0], elements[0][0]):.2f} % "
                f"| {off(mixed[0][1], elements[0][1]):.2f} % | {max(map(off, alone[0], elements[0])):.2f} % "
                f"| {100 * (mixed[1] / elements[1] - 1):+.2f} % | {100 * (alone[1] / elements[1] - 1):+.2f} % |")
    return lines


def write(name: str, lines: list[str]) -> None:
    """Put a table in its place on the page."""
    text = PAGE.read_text(encoding="utf-8")
    begin, end = f"<!-- table of {name} -->\n", "<!-- end of it -->"
    found = begin + "\n".join(lines) + "\n" + end
    text = re.sub(re.escape(begin) + ".*?" + re.escape(end), lambda _: found, text, flags=re.DOTALL)
    PAGE.write_text(text, encoding="utf-8")


def main() -> None:
    for name, measure in (("run.py", table), ("crossing.py", crossing.table)):
        if name in sys.argv or not any(one.endswith(".py") for one in sys.argv[1:]):
            lines = measure()
            print("\n".join(lines))
            if "--write" in sys.argv:
                write(name, lines)


if __name__ == "__main__":
    main()
