"""What each number in src/fracture/window/window_settings.hpp is worth: processor seconds of whole crack runs with the
number halved and doubled, over those of the same runs as it is, taken in turns, and whether the same bonds broke. Writes the table into
docs/research/tables.

    benchmarks/run.sh windows [--only NAME,...] [--write]

The library is built with a copy of the header in which the environment variable BEMPD_VARIED names a setting and its
value."""

from __future__ import annotations

import argparse
import dataclasses
import json
import os
import pathlib
import re
import subprocess
import sys
from typing import Any

from stored_tables import store

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
HEADER = "fracture/window/window_settings.hpp"
BUILD = ROOT / "build" / "windows"
OUT = pathlib.Path(os.environ["BEMPD_OUTPUT"])

# Sizes of types, and a list: they are varied by compiling again.
COMPILED = ("states_swept_at_once", "classes", "hot_shares")
# Bounds on rounding are no trade of time: docs/research/tables/reliability_findings.csv has the scenes behind them.
ROUNDING = ("smallest_pivot", "most_growth", "certificate_margin", "energy_rounding", "doubtful_energy",
            "acceptable_residual", "negligible_residual", "least_class_width", "surely_driven")

SCENES = {
    "plate of 60 x 60": ["plate", {"n": 60}],
    "two edge cracks, 50 x 50": ["plate", {"n": 50, "cracks": "two"}],
    "the paper's crack": ["paper_crack", {}],
}
# What acts in lattices with squares of cells, which follow their bonds, and where faces of cracks meet.
BESIDES = ("hot_in_present", "opening_all_around", "reach_of_followers", "events_between_balances",
           "events_beside_faces")
SCENES_BESIDES = {
    "plate of 50 x 50, Poisson's ratio 0.45": ["plate", {"n": 50, "ratio": 0.45}],
    "plate of 100 x 100, whose faces meet": ["plate", {"n": 100}],
}
# What acts where cracks grow as lines.
LINES = ("least_way", "beside_way", "worthwhile_steps")
LINE = {"crack.rule": "line"}
SCENES_OF_LINES = {
    "plate of 50 x 50": ["plate", {"n": 50}, LINE],
    "plate of 100 x 100": ["plate", {"n": 100}, LINE],
    "plate of 200 x 200": ["plate", {"n": 200}, LINE],
    "two edge cracks, 50 x 50": ["plate", {"n": 50, "cracks": "two"}, LINE],
    "eight cracks, 50 x 50": ["plate", {"n": 50, "cracks": "eight"}, LINE],
}
REPEATS = 7

VARIED = """
#include <cstdlib>
#include <cstring>
namespace bempd::fracture {
template <typename T>
T varied(const char* name, T value) {
  const char* wanted = std::getenv("BEMPD_VARIED");
  const std::size_t length = std::strlen(name);
  if (!wanted || std::strncmp(wanted, name, length) != 0 || wanted[length] != '=') return value;
  return static_cast<T>(std::strtod(wanted + length + 1, nullptr));
}
"""


@dataclasses.dataclass(frozen=True)
class Setting:
    name: str
    type: str
    value: float

    def variants(self) -> list[float]:
        """Half and double; of a share its own, or what it leaves, whichever is less than a half."""
        if self.name == "hot_shares":  # the first of the list, which the others follow
            return [0.4, 0.79]
        if 0.5 < self.value < 1:
            return [1 - 2 * (1 - self.value), 1 - (1 - self.value) / 2]
        values = [self.value / 2, self.value * 2]
        return values if self.type == "double" else [float(round(value)) for value in values]


DECLARATION = re.compile(r"static constexpr ([\w:]+) ([^;{}]+);")


def settings() -> list[Setting]:
    text = (ROOT / "src" / HEADER).read_text()
    first_share = re.search(r"hot_shares\{([\d.]+)", text)
    assert first_share is not None
    found = [Setting("hot_shares", "list", float(first_share.group(1)))]
    for kind, names in DECLARATION.findall(text):
        for name, value in re.findall(r"(\w+) = ([\d.e+-]+)", names):
            found.append(Setting(name, kind, float(value)))
    return found


def write_header(compiled: dict[str, float]) -> None:
    def changed(match: re.Match[str]) -> str:
        kind, names = match.groups()
        if any(re.search(rf"\b{name} =", names) for name in COMPILED):
            for name, value in compiled.items():
                names = re.sub(rf"\b{name} = \d+", f"{name} = {value:g}", names)
            return f"static constexpr {kind} {names};"
        return f"static inline const {kind} " + re.sub(r"(\w+) = ([\d.e+-]+)", r'\1 = varied<' + kind + r'>("\1", \2)', names) + ";"

    text = DECLARATION.sub(changed, (ROOT / "src" / HEADER).read_text())
    if "hot_shares" in compiled:
        text = re.sub(r"hot_shares\{[\d.]+", f"hot_shares{{{compiled['hot_shares']:g}", text)
    text = text.replace("namespace bempd::fracture {", VARIED, 1)
    target = BUILD / "varied" / HEADER
    target.parent.mkdir(parents=True, exist_ok=True)
    if not target.exists() or target.read_text() != text:
        target.write_text(text)


def build(compiled: dict[str, float]) -> None:
    write_header(compiled)
    subprocess.run(["cmake", "--preset", "release", "-B", str(BUILD), "-Wno-dev", "-D", f"CMAKE_CXX_FLAGS=-I{BUILD / 'varied'}", "-D", "BEMPD_COMPILE_TOGETHER=ON"],
                   cwd=ROOT, check=True, stdout=subprocess.DEVNULL)
    subprocess.run(["cmake", "--build", str(BUILD), "--target", "bempd", "-j", str(os.cpu_count())], check=True,
                   stdout=subprocess.DEVNULL)


def measure(scenes: dict[str, Any], varied: str) -> list[dict[str, Any]]:
    """Of each scene processor seconds of some runs and a digest of which bonds broke."""
    environment = os.environ | {"BEMPD_LIBRARY": str(BUILD / "src/capi/libbempd.so"), "OMP_NUM_THREADS": "1",
                                "OPENBLAS_NUM_THREADS": "1", "BEMPD_VARIED": varied}
    command = [sys.executable, str(HERE / "worker.py"), json.dumps(list(scenes.values())), "1"]
    done = subprocess.run(command, capture_output=True, text=True, env=environment, check=False)
    if done.returncode:
        raise SystemExit(f"{varied}: {done.stderr}")
    return list(json.loads(done.stdout))


def ratios(scenes: dict[str, Any], varied: str) -> list[str]:
    """Least seconds with a setting over least seconds without, of runs in turns."""
    plain, changed = [], []
    for _ in range(REPEATS):
        plain.append(measure(scenes, ""))
        changed.append(measure(scenes, varied))
    return [ratio([one[k] for one in plain], [one[k] for one in changed]) for k in range(len(scenes))]


def ratio(plain: list[dict[str, Any]], changed: list[dict[str, Any]]) -> str:
    least, with_it = (min(run["seconds"][0] for run in runs) for runs in (plain, changed))
    words = f"{with_it / least:.2f}"
    return words if changed[0]["digest"] == plain[0]["digest"] else words + " OTHER BONDS"


def table(chosen: list[Setting], scenes: dict[str, Any]) -> list[str]:
    if not chosen:
        return []
    if any(setting.name not in COMPILED for setting in chosen):
        build({})
    lines = ["| setting | its value | with | " + " | ".join(scenes) + " |", "|---|---|---|" + "---|" * len(scenes)]
    print("\n".join(lines), flush=True)

    def add(name: str, value: str, changed: str, seconds: list[str]) -> None:
        lines.append("| " + " | ".join([name, value, changed, *seconds]) + " |")
        print(lines[-1], flush=True)

    add("none", "", "the same once more", ratios(scenes, "nothing=0"))
    for setting in sorted(chosen, key=lambda one: one.name in COMPILED):
        for value in setting.variants():
            varied = f"{setting.name}={value:.17g}"
            add(setting.name, f"{setting.value:g}", f"{value:g}",
                ratios_of_compiled(scenes, setting.name, value) if setting.name in COMPILED else ratios(scenes, varied))
    return lines


def ratios_of_compiled(scenes: dict[str, Any], name: str, value: float) -> list[str]:
    build({})
    plain = [measure(scenes, "") for _ in range(REPEATS)]
    build({name: value})
    changed = [measure(scenes, "") for _ in range(REPEATS)]
    return [ratio([one[k] for one in plain], [one[k] for one in changed]) for k in range(len(scenes))]


def write(name: str, lines: list[str], keep: bool) -> None:
    if not lines:
        return
    (OUT / f"{name}.md").write_text("\n".join(lines) + "\n")
    if keep and len(lines) > 2:
        store(f"windows_{name}", lines)


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--only", help="settings, with commas between")
    parser.add_argument("--write", action="store_true", help="keep the tables in docs/research/tables")
    arguments = parser.parse_args()
    OUT.mkdir(parents=True, exist_ok=True)
    chosen = [s for s in settings() if s.name not in ROUNDING]
    if arguments.only:
        chosen = [s for s in chosen if s.name in arguments.only.split(",")]
    write("windows", table([one for one in chosen if one.name not in BESIDES + LINES], SCENES), arguments.write)
    write("besides", table([one for one in chosen if one.name in BESIDES], SCENES_BESIDES), arguments.write)
    write("lines", table([one for one in chosen if one.name in LINES], SCENES_OF_LINES), arguments.write)


if __name__ == "__main__":
    main()
