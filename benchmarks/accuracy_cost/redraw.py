"""Draws docs/accuracy_cost.png anew from the tables of docs/research/accuracy.md, without measuring again.

    /usr/bin/python3 benchmarks/accuracy_cost/redraw.py
"""

from __future__ import annotations

import re
from pathlib import Path

from measure import Row
from report import draw

DOCS = Path(__file__).resolve().parents[2] / "docs"


def rows(section: str) -> list[dict[str, str]]:
    """Lines of all tables of a section, by their headings."""
    found: list[dict[str, str]] = []
    heading: list[str] = []
    for line in section.splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")] if line.startswith("|") else []
        if not cells:
            heading = []
        elif not heading:
            heading = cells
        elif not set(line) <= set("|-: "):
            found.append(dict(zip(heading, cells)))
    return found


def percent(text: str) -> float:
    return abs(float(text.removesuffix("%"))) / 100


def main() -> None:
    sections = dict(re.findall(r"^## (.*?)\n(.*?)(?=^## |\Z)", (DOCS / "research/accuracy.md").read_text(), re.DOTALL | re.MULTILINE))
    trials: list[Row] = [{"scene": row["scene"], "error": float(row["error"]), "seconds": float(row["time [ms]"]) / 1e3,
                          "megabytes": float(row["memory [MB]"])} for row in rows(sections["Every knob"])]
    # Other knobs make another body, which has no error.
    torn = [part for part in re.split(r"^### ", sections["Plates torn apart"], flags=re.MULTILINE)
            if not part.startswith(("Horizon ratio", "Spacing", "Scheme"))]
    for row in rows("\n".join(torn)):
        # The second change is that of the energy released, over the bonds one by one.
        energy = [value for name, value in row.items() if name == "change"]
        trials.append({"scene": row["scene"], "error": percent(energy[-1]), "seconds": float(row["time [s]"]),
                       "megabytes": float(row["memory [MB]"])})
    best = [{"problem": row["problem"], "program": row["program"], "seconds_solve": float(row["without meshing [ms]"]) / 1e3}
            for row in rows(sections["Against finite elements"])]
    draw(DOCS / "accuracy_cost.png", trials, best)
    print(f"drew {len(trials)} settings and {len(best)} duels")


main()
