"""What each number in src/fracture/window/window_settings.hpp is worth: instructions of whole crack runs with the number
halved and doubled, over those of the same runs as it is, and whether the same bonds broke. Writes the table into docs/windows.md.

    benchmarks/run.sh windows [--only NAME,...] [--scenes NAME,...] [--write]

Instructions are counted by valgrind: times of one run differ by more than most of these numbers change. The library is
built with a copy of the header in which the environment variable BEMPD_VARIED names a setting and its value."""

from __future__ import annotations

import argparse
import csv
import dataclasses
import json
import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
HEADER = "fracture/window/window_settings.hpp"
BUILD = ROOT / "build" / "windows"
OUT = pathlib.Path(os.environ["BEMPD_OUTPUT"])
DOCUMENT = ROOT / "docs" / "windows.md"

# Sizes of types, and a list: they are varied by compiling again.
COMPILED = ("states_swept_at_once", "classes", "hot_shares")
# Bounds on rounding are no trade of time: docs/reliability.md has the scenes behind them.
ROUNDING = ("smallest_pivot", "most_growth", "certificate_margin", "energy_rounding", "doubtful_energy",
            "acceptable_residual", "least_class_width")

SCENES = {
    "plate of 60 x 60": {"scene": "plate", "arguments": {"n": 60}},
    "two edge cracks, 50 x 50": {"scene": "plate", "arguments": {"n": 50, "cracks": "two"}},
    "the paper's crack": {"scene": "paper_crack", "arguments": {}},
}

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


def count(scene: str, varied: str, until: str = "separation") -> tuple[int, str]:
    """Instructions of a run, and a digest of which bonds broke."""
    task = SCENES[scene] | {"options": {"threads": 1}, "until": until}
    # The newest kernels of the BLAS have instructions that valgrind does not know.
    environment = os.environ | {"BEMPD_LIBRARY": str(BUILD / "src/capi/libbempd.so"), "OPENBLAS_CORETYPE": "Haswell",
                                "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1", "BEMPD_VARIED": varied}
    command = ["valgrind", "--tool=cachegrind", "--cache-sim=no", "--cachegrind-out-file=/dev/null", sys.executable,
               str(ROOT / "benchmarks/windows/worker.py"), json.dumps(task)]
    done = subprocess.run(command, capture_output=True, text=True, env=environment, check=False)
    counted = re.search(r"I\s+refs:\s+([\d,]+)", done.stderr)
    if done.returncode or not counted:
        raise SystemExit(f"{scene}, {varied}: {done.stderr}")
    return int(counted.group(1).replace(",", "")), done.stdout.strip()


class Runs:
    """The scenes as they are, to compare with; what the interpreter and the scene take is counted once and left out."""

    def __init__(self, scenes: list[str]) -> None:
        self.scenes = scenes
        self.idle = {scene: count(scene, "", "nothing")[0] for scene in scenes}
        self.plain = {scene: count(scene, "") for scene in scenes}

    def ratios(self, varied: str) -> list[str]:
        result = []
        for scene in self.scenes:
            instructions, digest = count(scene, varied)
            ratio = (instructions - self.idle[scene]) / (self.plain[scene][0] - self.idle[scene])
            result.append(f"{ratio:.3f}" + ("" if digest == self.plain[scene][1] else " OTHER BONDS"))
        return result


def table(chosen: list[Setting], scenes: list[str]) -> list[str]:
    build({})
    runs = Runs(scenes)
    for scene in scenes:
        print(f"{scene}: {(runs.plain[scene][0] - runs.idle[scene]) / 1e9:.2f} thousand million instructions", flush=True)
    lines = ["| setting | its value | with | " + " | ".join(scenes) + " |", "|---|---|---|" + "---|" * len(scenes)]
    print("\n".join(lines), flush=True)
    with (OUT / "settings.csv").open("w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(["setting", "value", "with", *scenes])
        for setting in chosen:
            for value in setting.variants():
                if setting.name in COMPILED:
                    build({setting.name: value})
                ratios = runs.ratios(f"{setting.name}={value:.17g}")
                if setting.name in COMPILED:
                    build({})
                row = [setting.name, f"{setting.value:g}", f"{value:g}", *ratios]
                writer.writerow(row)
                file.flush()
                lines.append("| " + " | ".join(row) + " |")
                print(lines[-1], flush=True)
    return lines


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--only", help="settings, with commas between")
    parser.add_argument("--scenes", help="scenes, with commas between")
    parser.add_argument("--write", action="store_true", help="put the table into docs/windows.md")
    arguments = parser.parse_args()
    OUT.mkdir(parents=True, exist_ok=True)
    chosen = [s for s in settings() if s.name not in ROUNDING]
    if arguments.only:
        chosen = [s for s in chosen if s.name in arguments.only.split(",")]
    lines = table(chosen, arguments.scenes.split(";") if arguments.scenes else list(SCENES))
    if arguments.write:
        text = DOCUMENT.read_text()
        before, rest = text.split("<!-- table: benchmarks/run.sh windows --write -->\n", 1)
        after = rest.split("<!-- end of table -->", 1)[1]
        DOCUMENT.write_text(before + "<!-- table: benchmarks/run.sh windows --write -->\n" + "\n".join(lines) +
                            "\n<!-- end of table -->" + after)


if __name__ == "__main__":
    main()
