"""A strip between clamps that move apart, torn along its middle: the energy of a crack per length of it, and its way.

Far ahead of the tip and far behind it the strip is uniform, so the energy release rate is that of the whole strip ahead,
wherever the crack ends, and fracture mechanics' path is straight."""

from __future__ import annotations

import math
import pathlib
import re
import statistics
from typing import Any

import bempd
import numpy as np

HEIGHT, LENGTH, TIP, GROWTH = 52.0, 110.0, 40.0, 45.0
ROOT = pathlib.Path(__file__).resolve().parents[2]
# What the option critical_stretch = running takes, for horizons from 2 spacings on.
_SOURCE = (ROOT / "src/pd/critical_stretch.cpp").read_text(encoding="utf-8")
RUNNING = dict(enumerate(map(float, re.search(r"from_2 = \{([^}]*)\}", _SOURCE).group(1).split(",")), 2))
ANGLES = (0.0, 15.0, 22.5, 30.0, 45.0)
DRAWN_ANGLE = 20.0


def strip(rule: str, m: int, angle: float, start: float) -> tuple[bempd.Model, int]:
    model = bempd.Model(options={"crack.rule": rule, "stepping.control": "path"})
    material = model.add_material(young_modulus=8 / 9, poisson_ratio=1 / 3, fracture_energy=1)
    body = model.add_pd_region(material, bempd.rectangle(0, -HEIGHT / 2, LENGTH, HEIGHT / 2), 1.0, m,
                               lattice_angle=math.radians(angle))
    model.add_crack([(0, start), (TIP, start)])
    for edge, value in ((1, -1.0), (3, 1.0)):
        model.prescribe_edge(body, edge, "y", value)
        model.fix_edge(body, edge, "x")
    return model, body


def middles(model: bempd.Model, body: int) -> np.ndarray:
    """Of broken bonds."""
    bonds, points = model.bonds(body), model.field(body, "position")
    broken = bonds.points[bonds.states == bempd.BondState.BROKEN]
    return (points[broken[:, 0]] + points[broken[:, 1]]) / 2


def torn(rule: str, m: int, angle: float, start: float) -> dict[str, Any]:
    """First load over Griffith's, energy released per length, and middles of the bonds that broke."""
    model, body = strip(rule, m, angle, start)
    report = model.step_to_next_event(1e6)
    # The reference is the load factor at which growth releases the energy of the strip ahead per length, with C1111 = 1.
    first = report.load_factor * math.sqrt(2 / HEIGHT)
    energies, ways = [], [0.0]
    while ways[-1] < GROWTH and report.stop_reason == bempd.StopReason.EVENT:
        for _ in range(1 if rule == "line" else 10):
            report = model.step_to_next_event(1e6)
        broken = middles(model, body)
        ways.append(float(broken[:, 0].max()) - TIP)
        energies.append(report.released_energy)
    ways = ways[1:]
    steady = [k for k, way in enumerate(ways) if way > 8]
    energy = np.polyfit([ways[k] for k in steady], [energies[k] for k in steady], 1)[0] if len(steady) > 2 else math.nan
    slope = math.degrees(math.atan(np.polyfit(broken[:, 0], broken[:, 1], 1)[0]))
    return {"first": first, "energy": float(energy), "degrees": slope, "over": ways[-1], "path": broken.round(2).tolist()}


def jobs() -> list[list]:
    found = [["strip", "bond", m, angle, start] for m in (3, 4, 5, 6) for angle in ANGLES for start in (0.513,)]
    return found + [["strip", rule, 3, DRAWN_ANGLE, start] for rule in ("bond", "line") for start in (0.513, 0.237)]


def rows(found: dict[tuple, dict[str, Any]]) -> list[str]:
    """The energy of a crack that grows bond by bond per length of it, over the directions of the lattice."""
    lines = ["| m | runs | first break K / K_IC | energy per length / G0, mean | least .. largest | with `running` |",
             "|---|---|---|---|---|---|"]
    for m in (3, 4, 5, 6):
        some = [r for job, r in found.items() if job[:3] == ("strip", "bond", m) and job[3] != DRAWN_ANGLE
                and math.isfinite(r["energy"]) and r["over"] > 20]
        if some:
            energy, first = [r["energy"] for r in some], [r["first"] for r in some]
            taken = [e / RUNNING.get(m, 1.0) for e in energy]
            lines.append(f"| {m} | {len(some)} | {min(first):.2f} .. {max(first):.2f} | {statistics.mean(energy):.2f} |"
                         f" {min(energy):.2f} .. {max(energy):.2f} | {min(taken):.2f} .. {max(taken):.2f} |")
    return lines


def is_drawn(job: tuple) -> bool:
    """Whether the picture shows the way of a job."""
    if job[0] == "strip":
        return tuple(job[2:5]) == (3, DRAWN_ANGLE, 0.513)
    return tuple(job[1:4]) == (45.0, 3, DRAWN_ANGLE) if job[0] == "inclined" else False


def picture(found: dict[tuple, dict[str, Any]], file: pathlib.Path) -> None:
    """Ways in the strip and of an inclined edge crack, with the rows of the lattice at 20 degrees."""
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
    figure, axes = pyplot.subplots(1, 2, figsize=(9.6, 2.9), layout="constrained", gridspec_kw={"width_ratios": (45, 62)})
    colours = {"bond": "#b3261e", "line": "#1f4e79"}
    shown: set[tuple] = set()
    for job, result in found.items():
        if "path" not in result:
            continue
        axis, rule = (axes[0], job[1]) if job[0] == "strip" else (axes[1], job[4])
        if job[0] == "strip" and (job[3] != DRAWN_ANGLE or job[4] != 0.513) or job[0] != "strip" and job[1] != 45.0:
            continue
        if (job[0], rule) in shown:
            continue
        shown.add((job[0], rule))
        axis.plot(*np.array(result["path"]).T, ".", ms=2, color=colours[rule])
        if "reference" in result:
            axis.plot(*np.array(result["reference"]).T, "k--", lw=1.4)
    axes[0].axhline(0.5, color="black", ls="--", lw=1.4)
    axes[0].set(title="Pulled strip: the crack should go straight on", xlim=(TIP, TIP + GROWTH), ylim=(-6, 16))
    axes[1].set(title="Edge crack that begins at 45 degrees", xlim=(8, 70))
    for axis in axes:
        axis.set(xlabel="spacings", aspect="equal")
        axis.grid(color="#dddddd", lw=0.5)
        (left, right), (low, high) = axis.get_xlim(), axis.get_ylim()
        start = np.array([left + 0.03 * (right - left), high - 0.35 * (high - low)])
        end = start + 0.16 * (right - left) * np.array([math.cos(math.radians(DRAWN_ANGLE)), math.sin(math.radians(DRAWN_ANGLE))])
        axis.annotate("", end, start, arrowprops={"arrowstyle": "-", "color": "#7d838c", "lw": 1.4})
        axis.text(start[0], end[1] + 0.03 * (high - low), "rows of the lattice", color="#7d838c", fontsize=8)
    handles = [pyplot.Line2D([], [], marker=".", ls="", color=colours["line"], label="bonds cut by a line (default)"),
               pyplot.Line2D([], [], marker=".", ls="", color=colours["bond"], label="bonds broken one by one"),
               pyplot.Line2D([], [], color="black", ls="--", label="fracture mechanics; right: boundary elements")]
    figure.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, 0.0), ncol=3, fontsize=9, frameon=False)
    figure.savefig(file, dpi=130, bbox_inches="tight")
    pyplot.close(figure)
