"""Rows as CSV, Markdown and pictures."""

from __future__ import annotations

import csv
from pathlib import Path
from typing import Any, Callable, Sequence

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

from measure import Row
from peers import PROBLEMS, TARGET

Columns = Sequence[tuple[str, Callable[[Row], Any]]]
LEAST_ERROR = 1e-8  # shown in pictures; plates torn apart bond by bond are equal up to rounding
COLOURS = {"bempd": "#1f4e79", "FreeFem++": "#b3261e", "dolfinx": "#d08a00", "CalculiX": "#5b8c3a"}


def write_csv(path: Path, rows: Sequence[Row]) -> None:
    columns = ["scene", "program", "knob", "setting", "error", "seconds", "seconds_mesh", "megabytes", "unknowns", "refused"]
    with path.open("w", newline="") as file:
        writer = csv.DictWriter(file, columns, extrasaction="ignore", restval="")
        writer.writeheader()
        writer.writerows(rows)


def table(columns: Columns, rows: Sequence[Row]) -> str:
    lines = ["| " + " | ".join(name for name, _ in columns) + " |", "|" + "---|" * len(columns)]
    lines += ["| " + " | ".join(str(value(row)) for _, value in columns) + " |" for row in rows]
    return "\n".join(lines) + "\n"


def milliseconds(seconds: float) -> str:
    return f"{1e3 * seconds:.3g}"


SWEEP_COLUMNS: Columns = [
    ("scene", lambda r: r["scene"]), ("setting", lambda r: r["shown"]), ("error", lambda r: f"{r['error']:.1e}"),
    ("time [ms]", lambda r: milliseconds(r["seconds"])), ("memory [MB]", lambda r: f"{r['megabytes']:.1f}"),
    ("unknowns", lambda r: r["unknowns"])]


def sweep_tables(rows: Sequence[Row], columns: Columns) -> str:
    text = ""
    for knob in dict.fromkeys(row["knob"] for row in rows):
        own = [row for row in rows if row["knob"] == knob]
        text += f"### {knob[0].upper()}{knob[1:]}\n\n" + table(columns, [r for r in own if "refused" not in r]) + "\n"
        text += "".join(f"Refused: {r['scene']}, {r['shown']}: {r['refused']}\n\n" for r in own if "refused" in r)
    return text


def duel_table(best: Sequence[Row]) -> str:
    own = {row["problem"]: row for row in best if row["program"] == "bempd"}

    def ratio(key: str) -> Callable[[Row], str]:
        return lambda r: f"{r[key] / own[r['problem']][key]:.1f}" if r["problem"] in own else "-"

    return table([("problem", lambda r: r["problem"]), ("program", lambda r: r["program"]),
                  ("fastest setting", lambda r: r["setting"]), ("error", lambda r: f"{r['error']:.1e}"),
                  ("unknowns", lambda r: r["unknowns"]),
                  ("without meshing [ms]", lambda r: milliseconds(r["seconds_solve"])),
                  ("over bempd", ratio("seconds_solve")),
                  ("with meshing [ms]", lambda r: milliseconds(r["seconds_meshed"])),
                  ("over bempd", ratio("seconds_meshed"))], best)


def limits_table(rows: Sequence[Row]) -> str:
    return table([("stage, one core", lambda r: r["stage"]), ("bempd", lambda r: r["rate"]),
                  ("machine", lambda r: r["limit"]), ("factor", lambda r: f"{r['factor']:.1f}"),
                  ("within 3", lambda r: "yes" if r["factor"] <= 3 else "no")], rows)


def front(points: Sequence[tuple[float, float]]) -> list[tuple[float, float]]:
    """Those of (price, error) that no other beats in both."""
    kept: list[tuple[float, float]] = []
    for price, error in sorted(points):
        if not kept or error < kept[-1][1]:
            kept.append((price, error))
    return kept


def draw(path: Path, trials: Sequence[Row], tried: Sequence[Row]) -> None:
    """Pareto fronts: the plates in time against peers, and all scenes in time and in memory."""
    figure, axes = plt.subplots(1, 5, figsize=(15, 3.4), layout="constrained", sharey=True)
    for axis, problem in zip(axes, PROBLEMS):
        for program, colour in COLOURS.items():
            points = [(r["seconds_solve"], r["error"]) for r in tried
                      if r["problem"] == problem and r["program"] == program]
            if points:
                axis.loglog(*zip(*points), ".", color=colour, alpha=0.3, markersize=4)
                axis.loglog(*zip(*front(points)), "-o", color=colour, label=program, markersize=3, linewidth=1.2)
        axis.axhline(TARGET, color="grey", linewidth=0.6, linestyle=":")
        axis.set(title=f"{problem}: whole solve without meshing", xlabel="seconds, one core")
    for axis, price, label in ((axes[3], "seconds", "seconds"), (axes[4], "megabytes", "megabytes")):
        good = [row for row in trials if "refused" not in row and row["error"] > LEAST_ERROR]
        for scene in dict.fromkeys(row["scene"] for row in good):
            points = [(max(row[price], 1e-4), row["error"]) for row in good if row["scene"] == scene]
            axis.loglog(*zip(*front(points)), "-o", label=scene, markersize=3, linewidth=1)
        axis.set(title="bempd: every scene over all its knobs", xlabel=label)
    axes[0].set_ylabel("relative error")
    axes[0].legend(fontsize=8)
    axes[3].legend(fontsize=6.5)
    for axis in axes:
        axis.title.set_fontsize(9)
        axis.set_ylim(LEAST_ERROR, 1)
    figure.savefig(path, dpi=80)


def shown(settings: Row, key: str) -> str:
    others = [f"{name} {value}" for name, value in settings.items() if name not in (key, "threads", "bem.grading")]
    return ", ".join([f"{key} {settings[key]:g}" if not isinstance(settings[key], str) else settings[key], *others])
