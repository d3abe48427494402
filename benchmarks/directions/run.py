"""Cracks in lattices against boundary elements and G0: tables into docs/research/tables, and the picture of
docs/directions.md.

    run.py [--jobs N] [--only WORD] [--table | --picture]
        --only: jobs with this word; --table: tables from what is there; --picture: what the picture shows, and no table

Results are kept line by line in out/directions/lines.txt: what is there is not run again."""

from __future__ import annotations

import argparse
import os
import pathlib

import lines
import strip
from stored_tables import store

ROOT = pathlib.Path(__file__).resolve().parents[2]
OUT = pathlib.Path(os.environ.get("BEMPD_OUTPUT", "out/directions"))


def put(tables: dict[str, list[str]]) -> None:
    for name, rows in tables.items():
        store("directions_" + name.replace("-", "_"), rows)
        print("\n".join(rows), "\n")


def main() -> None:
    options = argparse.ArgumentParser()
    options.add_argument("--jobs", type=int, default=1)
    options.add_argument("--only", default="")
    options.add_argument("--table", action="store_true")
    options.add_argument("--picture", action="store_true")
    options = options.parse_args()
    OUT.mkdir(parents=True, exist_ok=True)
    if not options.table:
        lines.run(OUT, options.jobs, options.only, strip.is_drawn if options.picture else lambda job: True)
    found = lines.results(OUT)
    if not options.picture:
        put({name: rows for name, rows in lines.tables(found).items() if len(rows) > 2})
    strip.picture(found, ROOT / "docs" / "directions.png")


if __name__ == "__main__":
    main()
