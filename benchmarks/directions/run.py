"""Cracks in lattices against boundary elements and G0: tables into docs/directions.md, between its marks, and its picture.

    run.py [--jobs N] [--only WORD] [--table]    --only: jobs with this word; --table: tables from what is there

Results are kept line by line in out/directions/lines.txt: what is there is not run again."""

from __future__ import annotations

import argparse
import os
import pathlib

import lines
import strip

ROOT = pathlib.Path(__file__).resolve().parents[2]
OUT = pathlib.Path(os.environ.get("BEMPD_OUTPUT", "out/directions"))


def put(tables: dict[str, list[str]]) -> None:
    document = ROOT / "docs" / "directions.md"
    text = document.read_text(encoding="utf-8")
    for name, rows in tables.items():
        begin, end = f"<!-- {name} -->", f"<!-- end {name} -->"
        text = text[:text.index(begin) + len(begin)] + "\n" + "\n".join(rows) + "\n" + text[text.index(end):]
        print("\n".join(rows), "\n")
    document.write_text(text, encoding="utf-8")


def main() -> None:
    options = argparse.ArgumentParser()
    options.add_argument("--jobs", type=int, default=1)
    options.add_argument("--only", default="")
    options.add_argument("--table", action="store_true")
    options = options.parse_args()
    OUT.mkdir(parents=True, exist_ok=True)
    if not options.table:
        lines.run(OUT, options.jobs, options.only)
    found = lines.results(OUT)
    put({name: rows for name, rows in lines.tables(found).items() if len(rows) > 2})
    strip.picture(found, ROOT / "docs" / "directions.png")


if __name__ == "__main__":
    main()
