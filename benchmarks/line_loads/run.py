"""Loads of cracks that grow as lines in lattices over those of boundary elements on the same paths: the table of docs/cracks.md.

usage: benchmarks/run.sh line_loads [--write] [--only WORD ...]
    --write: into docs/cracks.md; only the rows whose names contain a WORD are measured, the others stay

Each scene is run with crack.load = fit, the stress ahead alone, and with energy, the default. Rows of a growing crack have its loads,
its largest load over that of boundary elements on their own path, and the distance of both paths. Times are those of the processor, by
energy over by fits. The second table has numbers of examples; a WORD may be the name of one."""

from __future__ import annotations

import argparse
import pathlib
from typing import Callable

import bempd
import examples
import first_loads
import other
import scenes

HERE = pathlib.Path(__file__).resolve().parent
PAGE = HERE.parents[1] / "docs" / "cracks.md"
LOADS_TABLE = "line-loads", ["| scene | m | fit | energy |", "|---|---|---|---|"]
EXAMPLES_TABLE = "example-loads", ["| example | number | fit | energy | boundary elements |", "|---|---|---|---|---|"]

LOADS = ("fit", "energy")
TIMED = ("straight crack of 40 | 4", "L1 kink, upper edge at 65 | 4", "L4 towards modulus 3, from 13 spacings before | 4")

Rows = dict[str, dict[str, str]]  # of the table: name and horizon, then by load


def words(ratios: list[float]) -> str:
    return " ".join(f"{ratio:.2f}" for ratio in ratios)


def grown(scene: scenes.Scene, m: int, load: str, timed: bool) -> tuple[str, float]:
    """Cell of a crack that grows, and the time of its run."""
    try:
        run = scenes.compare(scene, m, load, timed)
    except bempd.Error as error:
        return f"failed: {error}", 0
    if not run.loads:
        return "no growth", 0
    text = words([ours / known for ours, known in run.loads])
    if len(run.loads) > 1:
        text += f"; peak {run.peak:.2f}; {run.off:.1f} off"
    return text, run.seconds


def is_asked(name: str, only: list[str]) -> bool:
    return not only or any(word in name for word in only)


def measured(only: list[str]) -> Rows:
    found: Rows = {}

    def add(name: str, of_load: Callable[[str], str]) -> None:
        found[name] = {load: of_load(load) for load in LOADS}
        print(name, found[name], flush=True)

    for scene in scenes.scenes():
        for m in scene.horizons:
            name = f"{scene.name} | {m}"
            if not is_asked(name, only):
                continue
            runs = {load: grown(scene, m, load, name in TIMED) for load in LOADS}
            add(name, lambda load: runs[load][0])
            if name in TIMED and runs["fit"][1] > 0:
                add(f"time over that by fits, {scene.name} | {m}", lambda load: f"{runs[load][1] / runs['fit'][1]:.2f}")
    for name, measure in {**other.MEASURES, **first_loads.measures()}.items():
        if is_asked(name, only):
            add(name, lambda load: words(measure(load)))
    return found


def table(found: Rows) -> list[str]:
    return [f"| {name} | {by_load['fit']} | {by_load['energy']} |" for name, by_load in found.items()]


def write(table_of: tuple[str, list[str]], rows: list[str]) -> None:
    """Rows that were not measured keep what the page has, in its order."""
    name, head = table_of
    text, begin, end = PAGE.read_text("utf-8"), f"<!-- {name} -->\n", f"<!-- end {name} -->"
    first, last = text.index(begin) + len(begin), text.index(end)
    known = [line for line in text[first:last].strip().splitlines() if line not in head]

    def key(row: str) -> str:
        return "|".join(row.split("|")[1:3])

    fresh = {key(row): row for row in rows}
    kept = [fresh.pop(key(row), row) for row in known]
    PAGE.write_text(text[:first] + "\n".join(head + kept + list(fresh.values())) + "\n" + text[last:], "utf-8")


def main() -> None:
    options = argparse.ArgumentParser()
    options.add_argument("--write", action="store_true")
    options.add_argument("--only", nargs="+", default=[])
    options = options.parse_args()
    for of_table, rows in ((LOADS_TABLE, table(measured(options.only))),
                           (EXAMPLES_TABLE, examples.rows(lambda name: is_asked(name, options.only)))):
        print("\n".join(rows))
        if options.write:
            write(of_table, rows)


if __name__ == "__main__":
    main()
