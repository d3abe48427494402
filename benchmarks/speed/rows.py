"""Measures rows in processes of their own and keeps tables."""

from __future__ import annotations

import csv
import json
import os
import pathlib
import subprocess
import sys
from typing import Any

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
OUT = pathlib.Path(os.environ["BEMPD_OUTPUT"])
SECONDS_ALLOWED = 900

# One core for everybody.
ONE_CORE = {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1", "OMP_WAIT_POLICY": "passive"}


def call(command: list[str], allowed: float = SECONDS_ALLOWED) -> dict[str, Any]:
    """The line of JSON that a program prints, or {"failed": why}."""
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=allowed,
                              env=os.environ | ONE_CORE)
    except subprocess.TimeoutExpired:
        return {"failed": f"not in {allowed:.0f} s"}
    except OSError as problem:
        return {"failed": str(problem)}
    lines = [line for line in done.stdout.splitlines() if line.startswith("{")]
    if done.returncode or not lines:
        return {"failed": (done.stderr.strip().splitlines() or ["no output"])[-1]}
    return dict(json.loads(lines[-1]))


def measure(scene: str, arguments: dict[str, Any], options: dict[str, Any], until: str, repeats: int,
            **more: Any) -> dict[str, Any]:
    task = {"scene": scene, "arguments": arguments, "options": {"threads": 1} | options, "until": until,
            "repeats": repeats} | more
    return call([sys.executable, str(HERE / "worker.py"), json.dumps(task)])


def text_of(value: Any) -> str:
    return f"{value:.3g}" if isinstance(value, float) else str(value)


class Table:
    """Rows are printed as they come, so that an interrupted run has shown and kept what it measured."""

    def __init__(self, name: str, title: str, columns: list[str]) -> None:
        self.path = OUT / f"{name}.csv"
        print(f"\n### {title}\n\n| " + " | ".join(columns) + " |\n|" + "---|" * len(columns), flush=True)
        with self.path.open("w", newline="") as file:
            csv.writer(file).writerow(columns)

    def add(self, row: list[Any]) -> None:
        print("| " + " | ".join(map(text_of, row)) + " |", flush=True)
        with self.path.open("a", newline="") as file:
            csv.writer(file).writerow(row)
