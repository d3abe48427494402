"""Tables of measurements: CSV files in docs/research/tables. The notes in docs/research link to them."""

from __future__ import annotations

import csv
import re
from pathlib import Path
from typing import Iterator, Sequence, Union

FOLDER = Path(__file__).resolve().parents[1] / "docs" / "research" / "tables"


def blocks(text: str) -> Iterator[list[list[str]]]:
    """Cells of every Markdown table in a text, the headings first."""
    for block in re.findall(r"(?:^\|.*\n?)+", text, re.MULTILINE):
        lines = [line for line in block.splitlines() if not set(line) <= set("|-: ")]
        yield [[cell.strip() for cell in line.strip().strip("|").split(" | ")] for line in lines]


def store(name: str, text: Union[str, Sequence[str]]) -> None:
    """Write the Markdown tables of a text as NAME.csv, NAME_2.csv and so on."""
    FOLDER.mkdir(exist_ok=True)
    for number, rows in enumerate(blocks(text if isinstance(text, str) else "\n".join(text)), 1):
        path = FOLDER / (f"{name}.csv" if number == 1 else f"{name}_{number}.csv")
        with open(path, "w", newline="", encoding="utf-8") as file:
            csv.writer(file, lineterminator="\n").writerows(rows)
        print(f"wrote {path}")
