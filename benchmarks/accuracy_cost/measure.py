"""Programs run in processes of their own, in turns, so that a slow spell of the machine hits all of them."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any, Sequence

HERE = Path(__file__).parent
Row = dict[str, Any]


def run_json(command: Sequence[str], threads: int) -> Row:
    """The last line of the program's output as JSON, and the peak memory of its process in megabytes."""
    environment = {**os.environ, "OMP_NUM_THREADS": str(threads), "OPENBLAS_NUM_THREADS": str(threads)}
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=environment,
                               cwd=HERE)
    output, errors = process.communicate()
    if process.returncode != 0 or not output.strip():
        return {"refused": (errors.strip() or f"exit code {process.returncode}").splitlines()[-1]}
    return json.loads(output.strip().splitlines()[-1])


def bempd_command(scene: str, settings: Row, budget: float) -> list[str]:
    return [sys.executable, "worker.py", scene, json.dumps(settings), str(budget)]


def measure(commands: Sequence[Sequence[str]], rounds: int, threads: int = 1) -> list[Row]:
    """Every command once in each round; the least of each of its times and of its memory."""
    best: list[Row] = [{} for _ in commands]
    for number in range(rounds):
        for row, command in zip(best, commands):
            if "refused" in row:
                continue
            for key, value in run_json(command, threads).items():
                is_price = key.startswith(("seconds", "megabytes"))
                row[key] = min(value, row[key]) if is_price and key in row else value
            if sys.stderr.isatty():
                print(f"\rround {number + 1} of {rounds}: {' '.join(command[1:4])[:90]:90}", end="", file=sys.stderr)
    if sys.stderr.isatty():
        print(file=sys.stderr)
    return best
