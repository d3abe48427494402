"""Draws docs/accuracy_cost.png anew from the tables docs/research/tables/accuracy_*.csv, without measuring again.

    /usr/bin/python3 benchmarks/accuracy_cost/redraw.py
"""

from __future__ import annotations

import csv
from pathlib import Path

from measure import Row
from report import draw

DOCS = Path(__file__).resolve().parents[2] / "docs"


def rows(name: str) -> list[list[str]]:
    """Rows of a table, the headings first."""
    with open(DOCS / "research/tables" / f"{name}.csv", newline="", encoding="utf-8") as file:
        return list(csv.reader(file))


def column(table: list[list[str]], name: str) -> list[str]:
    """The last column of this name."""
    index = len(table[0]) - 1 - table[0][::-1].index(name)
    return [row[index] for row in table[1:]]


def percent(text: str) -> float:
    return abs(float(text.removesuffix("%"))) / 100


def main() -> None:
    knobs, torn, duels = (rows(f"accuracy_{name}") for name in ("knobs", "torn", "duels"))
    trials: list[Row] = [{"scene": scene, "error": float(error), "seconds": float(time) / 1e3, "megabytes": float(memory)}
                         for scene, error, time, memory in zip(*(column(knobs, name) for name in
                                                                 ("scene", "error", "time [ms]", "memory [MB]")))]
    # Other knobs make another body, which has no error. The second change is that of the energy released, over the bonds
    # one by one.
    trials += [{"scene": scene, "error": percent(energy), "seconds": float(time), "megabytes": float(memory)}
               for knob, scene, energy, time, memory in zip(*(column(torn, name) for name in
                                                              ("knob", "scene", "change", "time [s]", "memory [MB]")))
               if knob not in ("Horizon ratio", "Spacing", "Scheme")]
    best = [{"problem": problem, "program": program, "seconds_solve": float(time) / 1e3}
            for problem, program, time in zip(*(column(duels, name) for name in ("problem", "program", "without meshing [ms]")))]
    draw(DOCS / "accuracy_cost.png", trials, best)
    print(f"drew {len(trials)} settings and {len(best)} duels")


main()
