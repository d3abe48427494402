"""Loads of cracks that grow as lines in lattices over those of boundary elements on the same paths: the table of docs/cracks.md.

usage: benchmarks/run.sh line_loads [--write] [--only WORD] [--horizons M ...]
    --write: into docs/cracks.md

Each scene is run with crack.load = fit, the stress ahead alone, and with energy, the default. The last line has the time that the
runs by energy take over that by fits: all runs, and those whose loads are all by fits."""

from __future__ import annotations

import argparse
import pathlib

import bempd
import other
import scenes

HERE = pathlib.Path(__file__).resolve().parent
PAGE = HERE.parents[1] / "docs" / "cracks.md"
BEGIN, END = "<!-- line-loads -->", "<!-- end line-loads -->"
HORIZONS = (4,)

LOADS = ("fit", "energy")

Results = dict[str, dict[str, list[float]]]
Spent = dict[str, dict[str, tuple[float, list[bempd.LoadRule]]]]


def ratios_of(scene: scenes.Scene, m: int, load: str, spent: Spent) -> list[float]:
    try:
        run = scenes.compare(scene, m, load)
    except bempd.Error as error:
        print(scene.name, load, "failed:", error)
        return []
    spent.setdefault(scene.name, {})[load] = (run.seconds, run.rules)
    return [ours / known for ours, known in run.loads]


def measured(only: str, horizons: list[int]) -> tuple[Results, Spent]:
    found: Results = {}
    spent: Spent = {}
    for scene in scenes.scenes():
        for m in horizons:
            name = f"{scene.name} | {m}"
            if only not in name:
                continue
            found[name] = {load: ratios_of(scene, m, load, spent) for load in LOADS}
            for load in LOADS:
                print(name, load, " ".join(f"{ratio:.3f}" for ratio in found[name][load]), flush=True)
    for name, measure in other.MEASURES.items():
        if only in name:
            found[name] = {load: measure(load) for load in LOADS}
            print(name, found[name], flush=True)
    return found, spent


def words(ratios: list[float]) -> str:
    return " ".join(f"{ratio:.2f}" for ratio in ratios)


def table(found: Results) -> list[str]:
    rows = ["| scene | m | fit | energy |", "|---|---|---|---|"]
    for name, by_load in found.items():
        scene, _, m = name.partition(" | ")
        rows.append(f"| {scene} | {m} | {words(by_load['fit'])} | {words(by_load['energy'])} |")
    return rows


def cost(spent: Spent) -> str:
    whole = {load: sum(by_load[load][0] for by_load in spent.values() if len(by_load) == 2) for load in LOADS}
    valid = [by_load for by_load in spent.values() if len(by_load) == 2 and set(by_load["energy"][1]) == {bempd.LoadRule.FIT}]
    text = f"time by energy over that by fits: {whole['energy'] / whole['fit']:.2f}"
    if valid:
        text += f"; where all loads are by fits: {sum(one['energy'][0] for one in valid) / sum(one['fit'][0] for one in valid):.2f}"
    return text


def main() -> None:
    options = argparse.ArgumentParser()
    options.add_argument("--write", action="store_true")
    options.add_argument("--only", default="")
    options.add_argument("--horizons", type=int, nargs="+", default=list(HORIZONS))
    options = options.parse_args()
    found, spent = measured(options.only, options.horizons)
    rows = table(found)
    print("\n".join(rows))
    if spent:
        print(cost(spent))
    if options.write:
        text = PAGE.read_text("utf-8")
        PAGE.write_text(text[:text.index(BEGIN) + len(BEGIN)] + "\n" + "\n".join(rows) + "\n" + text[text.index(END):], "utf-8")


if __name__ == "__main__":
    main()
