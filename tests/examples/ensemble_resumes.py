"""The example `ensemble` is killed after some cases and started again: it runs the others only, and all numbers are those of a
run that was not killed.

usage: ensemble_resumes.py PROGRAM FOLDER"""

import csv
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time

program, folder = sys.argv[1], pathlib.Path(sys.argv[2])
whole, killed = folder / "whole", folder / "killed"
BEFORE_THE_KILL = 3


def command(where: pathlib.Path) -> list[str]:
    return [sys.executable, "-B", program, "--short", str(where)]


def lines_of(where: pathlib.Path) -> list[str]:
    results = where / "results.jsonl"
    return results.read_text(encoding="utf-8").splitlines() if results.exists() else []


def values_of(where: pathlib.Path) -> list[list[str]]:
    """Cases and results in the table; the times that they took are left out."""
    with open(where / "plates.csv", encoding="utf-8", newline="") as file:
        return [[value for name, value in row.items() if name != "seconds"] for row in csv.DictReader(file)]


shutil.rmtree(folder, ignore_errors=True)
folder.mkdir(parents=True)
subprocess.run(command(whole), check=True)
run = subprocess.Popen(command(killed), start_new_session=True)
while len(lines_of(killed)) < BEFORE_THE_KILL + 1 and run.poll() is None:  # the first line describes the study
    time.sleep(0.02)
os.killpg(run.pid, signal.SIGKILL)
run.wait()
kept = lines_of(killed)
done = subprocess.run(command(killed), check=True, text=True, stdout=subprocess.PIPE).stdout
assert done == (whole / "summary.csv").read_text(encoding="utf-8"), done
assert values_of(killed) == values_of(whole)
assert len(kept) > BEFORE_THE_KILL and lines_of(killed)[:BEFORE_THE_KILL] == kept[:BEFORE_THE_KILL], kept
assert len(lines_of(killed)) == len(lines_of(whole))
print(f"killed after {len(kept)} of {len(lines_of(whole))} lines, and continued")
