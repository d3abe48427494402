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


# What a scene is made of: none of these is the colour of a program.
FAMILIES = {"boundary elements": ("#5e3c99", ["lame", "kirsch", "cantilever", "plate", "shear", "hole", "l_shape"]),
            "coupled with a lattice": ("#008b8b", ["coupled_cantilever"]),
            "plates torn apart": ("#6b6b6b", ["centre_crack", "slanted_crack"])}


def draw_duel(axis: Any, best: Sequence[Row]) -> None:
    """Bars: the time to the target, problem by problem."""
    programs = [name for name in COLOURS if any(row["program"] == name for row in best)]
    for k, problem in enumerate(PROBLEMS):
        for j, program in enumerate(programs):
            own = [row for row in best if row["problem"] == problem and row["program"] == program]
            place = len(PROBLEMS) - 1 - k + 0.2 * (1.5 - j)
            label = program if k == 0 else None
            if own:
                seconds = own[0]["seconds_solve"]
                axis.barh(place, 1e3 * seconds, 0.18, color=COLOURS[program], label=label)
                axis.text(1.1e3 * seconds, place, f"{1e3 * seconds:.{1 if seconds < 0.01 else 0}f}", va="center",
                          fontsize=10)
            else:
                axis.barh(place, 0, 0.18, color=COLOURS[program], label=label)
                axis.text(0.45, place, f"{program}: not reached", va="center", fontsize=9, color=COLOURS[program])
    axis.set(xscale="log", xlim=(0.4, 3e4), yticks=range(len(PROBLEMS)), xlabel="milliseconds, one core, without meshing",
             title=f"Time to an error of {TARGET:g} of a displacement")
    axis.set_yticklabels(list(PROBLEMS)[::-1])
    axis.legend(fontsize=10, loc="upper right", frameon=False)


def draw_prices(axis: Any, trials: Sequence[Row], price: str, factor: float) -> None:
    """Errors over a price: the front of every scene, named at its end."""
    for family, (colour, scenes) in FAMILIES.items():
        for scene in scenes:
            points = front([(factor * max(row[price], 1e-4), row["error"]) for row in trials if row["scene"] == scene])
            if not points:
                continue
            axis.loglog(*zip(*points), "-o", color=colour, markersize=4, linewidth=1.4, label=family if scene == scenes[0] else None)
            lower = {"plate": -12, "lame": -12}.get(scene, -2)
            axis.annotate(scene.replace("_", " "), points[-1], (5, lower), textcoords="offset points", fontsize=9.5, color=colour)


def draw(path: Path, trials: Sequence[Row], best: Sequence[Row]) -> None:
    """The plates against peers, and all scenes in time and in memory."""
    good = [row for row in trials if "refused" not in row and row["error"] > LEAST_ERROR]
    with plt.rc_context({"font.size": 11, "axes.titlesize": 12, "axes.labelsize": 11}):
        figure, axes = plt.subplots(1, 3, figsize=(15, 5), layout="constrained", width_ratios=[1, 1.15, 1.15])
        draw_duel(axes[0], best)
        draw_prices(axes[1], good, "seconds", 1e3)
        draw_prices(axes[2], good, "megabytes", 1)
        axes[1].set(title="bempd: error against time, a line for each scene", xlabel="milliseconds, one core", ylabel="relative error",
                    xlim=(0.4, 5e4))
        axes[2].set(title="bempd: error against memory", xlabel="megabytes", xlim=(1.5, 3e3))
        axes[2].legend(*axes[1].get_legend_handles_labels(), fontsize=10, frameon=False, loc="upper right")
        for axis in axes[1:]:
            axis.grid(color="#dddddd", linewidth=0.5)
            axis.set_ylim(1e-7, 1)
        figure.savefig(path, dpi=120)


def shown(settings: Row, key: str) -> str:
    others = [f"{name} {value}" for name, value in settings.items() if name not in (key, "threads", "bem.grading")]
    return ", ".join([f"{key} {settings[key]:g}" if not isinstance(settings[key], str) else settings[key], *others])
