"""Loads of cracks that grow as lines in lattices over those of boundary elements on the same paths: the table of docs/cracks.md.

usage: benchmarks/run.sh line_loads [--write] [--only WORD] [--keep]
    --write: into docs/cracks.md;  --keep: as the results that later ones are compared with, before.json

Beside each result is the one of before.json, which the library had while the stress ahead alone told all loads."""

from __future__ import annotations

import argparse
import json
import pathlib

import bempd
import other
import scenes

HERE = pathlib.Path(__file__).resolve().parent
PAGE = HERE.parents[1] / "docs" / "cracks.md"
BEGIN, END = "<!-- line-loads -->", "<!-- end line-loads -->"
HORIZONS = (4,)

Results = dict[str, list[float]]


def measured(only: str) -> Results:
    found: Results = {}
    for scene in scenes.scenes():
        for m in HORIZONS:
            name = f"{scene.name} | {m}"
            if only not in name:
                continue
            try:
                found[name] = [load / known for load, known in scenes.compare(scene, m)]
            except bempd.Error as error:
                print(name, "failed:", error)
                continue
            print(name, " ".join(f"{ratio:.3f}" for ratio in found[name]), flush=True)
    for name, measure in other.MEASURES.items():
        if only in name:
            found[name] = measure()
            print(name, " ".join(f"{value:.3f}" for value in found[name]), flush=True)
    return found


def words(ratios: list[float] | None) -> str:
    return " ".join(f"{ratio:.2f}" for ratio in ratios) if ratios else ""


def table(now: Results, before: Results) -> list[str]:
    rows = ["| scene | m | before | now |", "|---|---|---|---|"]
    for name, ratios in now.items():
        scene, _, m = name.partition(" | ")
        rows.append(f"| {scene} | {m} | {words(before.get(name))} | {words(ratios)} |")
    return rows


def main() -> None:
    options = argparse.ArgumentParser()
    options.add_argument("--write", action="store_true")
    options.add_argument("--keep", action="store_true")
    options.add_argument("--only", default="")
    options = options.parse_args()
    file = HERE / "before.json"
    before: Results = json.loads(file.read_text("ascii")) if file.exists() else {}
    now = measured(options.only)
    if options.keep:
        rounded = {name: [round(value, 4) for value in values] for name, values in (before | now).items()}
        file.write_text("{\n" + ",\n".join(f" {json.dumps(name)}: {json.dumps(values)}" for name, values in rounded.items()) + "\n}\n", "ascii")
        return
    rows = table(now, before)
    print("\n".join(rows))
    if options.write:
        text = PAGE.read_text("utf-8")
        PAGE.write_text(text[:text.index(BEGIN) + len(BEGIN)] + "\n" + "\n".join(rows) + "\n" + text[text.index(END):], "utf-8")


if __name__ == "__main__":
    main()
