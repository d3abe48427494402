"""Draws docs/speed.png from the tables in out/speed: time of a whole crack run against the size of the plate."""

from __future__ import annotations

import csv
from typing import Any

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot

from rows import OUT, ROOT


def read(name: str) -> list[dict[str, Any]]:
    with (OUT / f"{name}.csv").open() as file:
        return list(csv.DictReader(file))


def series(rows: list[dict[str, Any]], size: str, key: str, value: str, label: str) -> tuple[list[int], list[float]]:
    points = [(int(row[size].split()[0]), float(row[value])) for row in rows if row[key] == label]
    return [2 * n * (n - 2) for n, _ in points], [seconds for _, seconds in points]


def draw() -> None:
    figure, axes = pyplot.subplots(figsize=(7, 4.5))
    own = [row for row in read("plate") if row["ratio"]]
    first = "window, band 0.001, to 0.1 % of the force"
    axes.loglog(*series(own, "scene", "way", "elastic solve [s]", first), "k--", label="one elastic solve")
    axes.loglog(*series(own, "scene", "way", "seconds", first), "o-", label="bempd, every bond in its turn")
    axes.loglog(*series(own, "scene", "way", "seconds", "plain, band 0.001, to separation"), "s-",
                label="bempd, solver plain")
    others = [row for row in read("peers") if row["finished"] == "True" and not row["program"].startswith("bempd")]
    for program in dict.fromkeys(row["program"] for row in others):
        axes.loglog(*series(others, "N", "program", "seconds", program), "x:", label=program)
    axes.set_xlabel("unknowns")
    axes.set_ylabel("processor seconds, one core")
    axes.set_title("Tearing a plate with a central crack")
    axes.grid(True, which="both", alpha=0.3)
    axes.legend(fontsize=7)
    figure.tight_layout()
    figure.savefig(ROOT / "docs" / "speed.png", dpi=120)
