"""The program of docs/checkpoints.md, as printed there: killed in a chunk and started again it gives what it gives in one go.

    checkpoints.py ROOT WORK
"""

from __future__ import annotations

import csv
import pathlib
import re
import shutil
import subprocess
import sys

root, work = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
page = (root / "docs/checkpoints.md").read_text(encoding="utf-8")
program = re.search(r"^```python\n(.*?)^```", page, re.DOTALL | re.MULTILINE)[1]

# What is put before it: the process ends by a signal that cannot be caught, before the state of its twelfth chunk is there.
KILLED = """
import os, signal, bempd
chunks, write = [], bempd.Model.checkpoint
def checkpoint(model, path):
    chunks.append(path)
    if len(chunks) == 12:
        os.kill(os.getpid(), signal.SIGKILL)
    write(model, path)
bempd.Model.checkpoint = checkpoint
"""
WITHOUT = "import bempd\nbempd.Model.checkpoint = lambda model, path: None\n"


def run(folder: str, before: str = "", clean: bool = True) -> subprocess.CompletedProcess:
    place = work / folder
    if clean:
        shutil.rmtree(place, ignore_errors=True)
        place.mkdir(parents=True)
    return subprocess.run([sys.executable, "-c", before + program], cwd=place, capture_output=True, text=True)


def expect(holds: bool, what: str) -> None:
    if not holds:
        raise SystemExit(f"not so: {what}")


whole = run("whole")
expect(whole.returncode == 0 and whole.stdout == "", f"the program runs: {whole.stderr}")
killed = run("parts", KILLED)
expect(killed.returncode == -9 and not (work / "parts/strip.csv").exists(), "the first process is killed")
expect([file.name for file in (work / "parts").iterdir()] == ["strip.state"], "it leaves the state and nothing else")
again = run("parts", clean=False)
expect(again.stdout == "goes on at 55\n", f"the second one goes on where the eleventh chunk ended: {again.stdout}{again.stderr}")
one, other = ((work / folder / "strip.csv").read_bytes() for folder in ("whole", "parts"))
expect(one == other, "both histories are the same, byte by byte")
expect((work / "whole/strip.state").read_bytes() == (work / "parts/strip.state").read_bytes(), "and so are the states")

expect(run("without", WITHOUT).returncode == 0, "the program runs without checkpoints")
without = (work / "without/strip.csv").read_bytes()
expect(without == one, "the history without checkpoints is the same, byte by byte")
last = list(csv.DictReader((work / "whole/strip.csv").open()))[-1]
expect(last["total_broken_bonds"] == "344", "as many bonds break")
size = (work / "whole/strip.state").stat().st_size
expect(f"takes {size / 1000:.0f} kB after its {last['total_broken_bonds']} broken bonds" in page.replace("\n ", ""),
       f"the page says how long the state is: {size} bytes")
print(f"killed and resumed at load factor 55, and without checkpoints: the same {len(one)} bytes of history; the state has "
      f"{size} bytes")
