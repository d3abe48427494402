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


def picture(found: dict[tuple, dict[str, Any]], file: pathlib.Path) -> None:
    """Ways in the strip and of an inclined edge crack, with the rows of the lattice at 20 degrees."""
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
    figure, axes = pyplot.subplots(1, 2, figsize=(11, 5.2), layout="constrained")
    colours = {"bond": "tab:red", "line": "tab:blue"}
    labels = {"bond": "bond by bond", "line": "crack as a line"}
    for job, result in found.items():
        if "path" not in result or (job[0] == "strip" and job[3] != DRAWN_ANGLE):
            continue
        axis, rule = (axes[0], job[1]) if job[0] == "strip" else (axes[1], job[4])
        axis.plot(*np.array(result["path"]).T, ".", ms=1.5, color=colours[rule],
                  label=labels.pop(rule, None) if job[0] == "strip" else None)
        if "reference" in result:
            axis.plot(*np.array(result["reference"]).T, "k--", lw=1)
    axes[0].set(title="Pulled strip, rows of the lattice at 20 degrees", xlim=(TIP, TIP + GROWTH), ylim=(-20, 20),
                xlabel="spacings", aspect="equal")
    axes[1].set(title="Inclined edge cracks; dashed: boundary elements", xlim=(0, 75), xlabel="spacings", aspect="equal")
    axes[0].legend(loc="lower left", fontsize=8)
    figure.savefig(file, dpi=110)
    pyplot.close(figure)
