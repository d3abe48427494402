"""Runs the Python blocks of README.md, of the tutorials and of the cookbook, each page as one program: it must end, print what the page says, and
write every picture that the page shows of it. Blocks of other pages must end. Commands of README.md must be there; its program in C runs in
example.readme_programs_run_and_print_the_same.

    blocks.py ROOT WORK

Needs the Python package on PYTHONPATH and the library as BEMPD_LIBRARY. A page says what is printed in `code` of its text or in a
block of ```text, and shows a picture FILE.png that a block writes as docs/FILE.png.
The program of docs/index.md is that of README.md.
"""

from __future__ import annotations

import importlib.util
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

PAGES = ["README.md", "docs/first_path.md", "docs/cookbook.md", "docs/tutorial.md", "docs/fatigue.md"]
TIMED = ["docs/converge.md"]  # what its blocks print ends with seconds
FOR_THEMSELVES = ["docs/bodies.md", "docs/mixed_cracks.md"]  # whose blocks do not say what they print
DRAWN = "docs/import.md"  # whose blocks read a drawing that docs/scene_figures.py writes
MOST_CHANGED = 0.005  # share of the pixels of a picture
PICTURE = re.compile(r"savefig\(\"([\w.]+)\"\)")


def compare(drawn: pathlib.Path, stored: pathlib.Path, page: str) -> None:
    """A stored picture is what the block draws. Other fonts may change its size by some pixels; then the size alone counts."""
    new, old = (pyplot.imread(file)[..., :3].mean(axis=2) for file in (drawn, stored))
    if max(abs(a - b) for a, b in zip(new.shape, old.shape)) > 60:
        raise SystemExit(f"{page}: docs/{stored.name} has {old.shape} pixels, its block draws {new.shape}; copy {drawn}")
    changed = float((abs(new - old) > 0.25).mean()) if new.shape == old.shape else 0.0
    if changed > MOST_CHANGED:
        raise SystemExit(f"{page}: {100 * changed:.1f} % of docs/{stored.name} is not what its block draws; copy {drawn}")


def look_for_commands(root: pathlib.Path, page: str) -> None:
    """Presets and scripts of this tree that the ```sh blocks of a page name."""
    presets = {preset["name"] for preset in json.loads((root / "CMakePresets.json").read_text())["configurePresets"]}
    commands = "\n".join(re.findall(r"^```sh\n(.*?)^```$", (root / page).read_text(encoding="utf-8"), re.DOTALL | re.MULTILINE))
    named = re.findall(r"--preset (\w+)", commands)
    scripts = re.findall(r"^([\w./]+\.sh)\b", commands, re.MULTILINE)
    for name in named:
        if name not in presets:
            raise SystemExit(f"{page}: there is no preset {name}")
    for script in scripts:
        if not os.access(root / script, os.X_OK):
            raise SystemExit(f"{page}: {script} cannot be run")
    for folder in re.findall(r"\$PWD/((?!build/)[\w/]+)", commands):
        if not (root / folder).exists():
            raise SystemExit(f"{page}: there is no {folder}")
    if not named or not scripts:
        raise SystemExit(f"{page} has no commands")


def run(root: pathlib.Path, page: str, work: pathlib.Path) -> str:
    text = (root / page).read_text(encoding="utf-8")
    program = "\n".join(re.findall(r"^```python\n(.*?)^```$", text, re.DOTALL | re.MULTILINE))
    folder = work / page.replace("/", "_")
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    if page == DRAWN:
        sys.path.insert(0, str(root / "docs"))
        from scene_figures import write_bracket

        write_bracket(folder / "bracket.dxf")
    done = subprocess.run([sys.executable, "-c", program], cwd=folder, capture_output=True, text=True,
                          env={**os.environ, "MPLBACKEND": "Agg"})
    if done.returncode:
        raise SystemExit(f"{page}: the blocks fail:\n{done.stderr}")
    shown = " ".join(re.sub(r"^```python\n.*?^```$", "", text, flags=re.DOTALL | re.MULTILINE).split())
    for line in done.stdout.splitlines() if page in PAGES + TIMED else ():
        words = line.split()
        if " ".join(words) not in shown and (page not in TIMED or " ".join(words[:-1]) not in shown):
            raise SystemExit(f"{page} does not say what its blocks print: {line}")
    for name in PICTURE.findall(program):
        if f"{name})" not in text:
            raise SystemExit(f"{page} does not show {name}, which its blocks draw")
        compare(folder / name, root / "docs" / name, page)
    return f"{page}: {len(done.stdout.splitlines())} printed lines and {len(PICTURE.findall(program))} pictures as shown"


def main() -> None:
    root, work = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
    drawn = [DRAWN] if importlib.util.find_spec("ezdxf") else []
    for page in PAGES + TIMED + FOR_THEMSELVES + drawn:
        print(run(root, page, work))
    look_for_commands(root, "README.md")
    first, landing = ((root / page).read_text(encoding="utf-8") for page in ("README.md", "docs/index.md"))
    for block in re.findall(r"^```python\n.*?^```$", landing, re.DOTALL | re.MULTILINE):
        if block not in first:
            raise SystemExit("docs/index.md: its program is not that of README.md")


main()
