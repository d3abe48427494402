"""Tables and pictures of benchmarks/directions from its results, into docs/directions.md between its marks."""

from __future__ import annotations

import collections
import math
import pathlib
import re
import statistics

ROOT = pathlib.Path(__file__).resolve().parents[2]
# What the option critical_stretch = running takes, for horizons from 2 spacings on.
_SOURCE = (ROOT / "src/pd/critical_stretch.cpp").read_text(encoding="utf-8")
RUNNING = dict(enumerate(map(float, re.search(r"from_2 = \{([^}]*)\}", _SOURCE).group(1).split(",")), 2))
FIELDS = ("direction", "end", "first", "largest", "energy", "own", "events", "seconds")
NAMES = {
    ("lattice", "quartic", "stretch"): "bond by bond: the most stretched bond",
    ("lattice", "quartic", "scatter-10"): "critical stretch scatters by 10 %",
    ("lattice", "quartic", "scatter-20"): "critical stretch scatters by 20 %",
    ("lattice", "quartic", "softening-4"): "bonds soften to 4 times the stretch of their peak, 6 teeth",
    ("lattice", "quartic", "half-mean-strain"): "half the mean strain within half a horizon, half the bond's own",
    ("lattice", "quartic", "facet"): "all bonds across a facet at the most stressed point",
    ("lattice", "quartic", "release"): "the bond whose breaking releases most over its own fracture energy",
    ("lattice", "quartic", "release-scatter-10"): "most released over own energy, critical stretch scatters by 10 %",
    ("lattice", "quartic", "even"): "critical stretch by direction, straight cuts with the least ripple",
    ("lattice", "quartic", "release-even"): "both: most released over own energy, least ripple of cuts",
    ("lattice", "conical", "stretch"): "conical kernel",
    ("lattice", "gauss", "stretch"): "Gaussian kernel",
    ("jitter=0.35", "quartic", "stretch"): "points moved by up to 0.35",
    ("jitter=0.35", "quartic", "release"): "moved points, most released over own energy",
    ("lloyd=4", "quartic", "stretch"): "random points, four of Lloyd's steps",
    ("lloyd=4", "quartic", "scatter-10"): "random points, critical stretch scatters by 10 %",
    ("lloyd=4", "quartic", "softening-4"): "random points, bonds soften",
    ("lloyd=4", "quartic", "release"): "random points, most released over own energy",
    ("lattice", "quartic", "line-most-release"): "line: way and load by energy released over 4 spacings",
    ("lattice", "quartic", "line-principal"): "line: way across mean principal stress, load by energy released over 6",
    ("lattice", "quartic", "line-williams"): "line: way and load by Williams' series of displacements",
    ("lattice", "quartic", "line-ahead"): "line: way and load by mean stress ahead",
    ("lattice", "quartic", "line-release-3"): "line: way by mean stress ahead, load by energy released over 3 spacings",
    ("lattice", "quartic", "line-release-6"): "the same over 6 spacings",
    ("lattice", "quartic", "line-field"): "line: way by mean stress ahead, load by fitted stress ahead",
    ("lattice", "quartic", "line-field-learn"): "**the same, corrected by what 8 steps released**",
}


def read(file: pathlib.Path) -> list[dict]:
    found = []
    for line in file.read_text(encoding="ascii").splitlines():
        part = line.split(",")
        row = {"scene": part[0], "kind": tuple(part[1:4]), "m": int(part[4]), "angle": float(part[5]), "mode": float(part[6]),
               "seed": int(part[7])}
        row.update({name: float(value.replace("-nan", "nan")) for name, value in zip(FIELDS, part[8:])})
        found.append(row)
    return found


def span(values: list[float], digits: int = 2) -> str:
    good = [v for v in values if math.isfinite(v)]
    return f"{min(good):.{digits}f} .. {max(good):.{digits}f}" if good else "-"


def straight(rows: list[dict]) -> list[str]:
    """Mode I: fracture mechanics' path goes straight ahead."""
    lines = ["| candidate | m | runs | mean error [deg] | worst | spread over offsets | first break K / K_IC | largest G / G0 |"
             " energy per length / G0 | seconds |", "|---|---|---|---|---|---|---|---|---|---|"]
    for kind, name in NAMES.items():
        for m in (3, 4, 5, 6):
            some = [r for r in rows if r["scene"] in ("strip", "narrow") and r["kind"] == kind and r["m"] == m
                    and math.isfinite(r["direction"]) and r["end"] > 15]
            if not some:
                continue
            groups = collections.defaultdict(list)
            for r in some:
                groups[r["angle"]].append(r["direction"])
            spreads = [statistics.stdev(g) for g in groups.values() if len(g) > 1]
            errors = [abs(r["direction"]) for r in some]
            lines.append(f"| {name} | {m} | {len(some)} | {statistics.mean(errors):.1f} | {max(errors):.1f} |"
                         f" {statistics.mean(spreads) if spreads else math.nan:.1f} | {span([r['first'] for r in some])} |"
                         f" {span([r['largest'] for r in some])} | {span([r['energy'] for r in some])} |"
                         f" {statistics.median(r['seconds'] for r in some):.1f} |")
    return lines


def with_page(lines: list[str]) -> list[str]:
    """Rows of candidates that have fewer runs here than on the page, or none, as they are on the page."""
    def keyed(rows: list[str]) -> dict:
        cells = [[cell.strip() for cell in row.split("|")[1:4]] for row in rows]
        return {(name, m): (int(runs), row) for (name, m, runs), row in zip(cells, rows)}

    old, new = keyed(section("straight")[2:]), keyed(lines[2:])
    order = [(name, str(m)) for name in NAMES.values() for m in (3, 4, 5, 6)]
    return lines[:2] + [max(old.get(k, (0, "")), new.get(k, (0, "")), key=lambda found: (found[0], found == new.get(k)))[1]
                        for k in order if k in old or k in new]


def cuts(file: pathlib.Path) -> list[str]:
    """What straight cuts cost over their directions."""
    lines = ["| m | cost of straight cuts / G0, one critical stretch | critical stretch by direction | that over the one |",
             "|---|---|---|---|"]
    for line in file.read_text(encoding="ascii").splitlines():
        m, *values = line.split(",")
        value = [float(v) for v in values]
        lines.append(f"| {m} | {value[0]:.3f} .. {value[1]:.3f} ({value[1] / value[0] - 1:.1%}) | {value[2]:.3f} .. {value[3]:.3f}"
                     f" ({value[3] / value[2] - 1:.1%}) | {value[4]:.2f} .. {value[5]:.2f} |".replace("%", " %"))
    return lines


def straight_and_cuts(out: pathlib.Path) -> dict[str, list[str]]:
    return {"straight": with_page(straight(read(out / "results.csv"))), "cuts": cuts(out / "cuts.csv")}


def over_angle(rows: list[dict]) -> list[str]:
    """Toughness over the direction of the lattice, before and after."""
    lines = ["| m | rows at | bond by bond: direction | first | largest G | energy | line: direction | first | largest G | energy |",
             "|---|---|---|---|---|---|---|---|---|---|"]
    for m in (3, 4, 5, 6):
        for angle in (0, 7.5, 10, 15, 20, 22.5, 30, 45):
            cells = []
            for name in ("stretch", "line-field-learn"):
                some = [r for r in rows if r["scene"] in ("strip", "narrow") and r["kind"] == ("lattice", "quartic", name)
                        and r["m"] == m and r["angle"] == angle and math.isfinite(r["direction"])]
                mean = {k: statistics.mean(r[k] for r in some) for k in FIELDS} if some else None
                cells.append(f"{mean['direction']:.1f} | {mean['first']:.2f} | {mean['largest']:.2f} | {mean['energy']:.2f}"
                             if mean else "- | - | - | -")
            if cells != ["- | - | - | -"] * 2:
                lines.append(f"| {m} | {angle:g} | {cells[0]} | {cells[1]} |")
    return lines


def running(rows: list[dict]) -> list[str]:
    """Energy of a crack that grows bond by bond per length of it, over the lattice's directions."""
    lines = ["| m | runs | first break K / K_IC | energy per length / G0, mean | least .. largest | with `running` |", "|---|---|---|---|---|---|"]
    for m in range(2, 8):
        some = [r for r in rows if r["scene"] == "strip" and r["kind"] == ("lattice", "quartic", "stretch") and r["m"] == m
                and math.isfinite(r["energy"]) and r["end"] > 11]
        if not some:
            continue
        by_angle = collections.defaultdict(list)
        for r in some:
            by_angle[r["angle"]].append(r["energy"])
        energies = [statistics.mean(values) for values in by_angle.values()]
        taken = RUNNING.get(m, 1.0)
        lines.append(f"| {m} | {len(some)} | {span([r['first'] for r in some])} | {statistics.mean(energies):.2f} | {span(energies)} |"
                     f" {span([e / taken for e in energies])} |")
    return lines


def hoop(mode: float) -> float:
    one, two = math.cos(math.radians(mode)), math.sin(math.radians(mode))
    return math.degrees(2 * math.atan((one / two - math.sqrt((one / two) ** 2 + 8)) / 4))


def mixed(rows: list[dict]) -> list[str]:
    """Kinks: directions less that of the largest hoop stress."""
    names = ("stretch", "line-field-learn", "line-release-6")
    lines = ["| m | arctan(K_II/K_I) [deg] | hoop stress | bond by bond | spread | recommended line | spread | by energy over 6 | spread |",
             "|---|---|---|---|---|---|---|---|---|"]
    for m in (3, 4):
        for mode in (15, 30, 45, 60, 75):
            cells = []
            for name in names:
                some = [r["direction"] for r in rows if r["scene"] == "disc" and r["kind"] == ("lattice", "quartic", name)
                        and r["m"] == m and r["mode"] == mode]
                cells.append(f"{statistics.mean(some):.1f} | {statistics.stdev(some):.1f}" if len(some) > 1 else "- | -")
            lines.append(f"| {m} | {mode} | {hoop(mode):.1f} | {' | '.join(cells)} |")
    return lines


def paths(file: pathlib.Path) -> list[dict]:
    found = []
    for line in file.read_text(encoding="ascii").splitlines():
        part = line.split()
        values = [float(v) for v in part[8:]]
        found.append({"scene": part[0], "name": part[1], "kind": (part[2], part[3], part[1]), "m": int(part[4]),
                      "angle": float(part[5]), "mode": float(part[6]), "seed": int(part[7]),
                      "points": list(zip(values[::2], values[1::2]))})
    return found


def height(path: list[tuple[float, float]], x: float) -> float:
    for (x0, y0), (x1, y1) in zip(path, path[1:]):
        if x0 <= x <= x1:
            return y0 + (y1 - y0) * (x - x0) / (x1 - x0)
    return math.nan


def off(points: list[tuple[float, float]], is_line: bool, reference: list[tuple[float, float]]) -> float:
    """Largest distance, upright, of a path from the reference."""
    worst = 0.0
    for x in range(int(reference[0][0]) + 2, int(reference[-1][0]) - 1, 2):
        if is_line:
            y = height(points[1:], x)
        else:
            near = [q[1] for q in points if abs(q[0] - x) < 1.5]
            y = statistics.mean(near) if near else math.nan
        if math.isfinite(y):
            worst = max(worst, abs(y - height(reference, x)))
    return worst


def inclined(drawn: list[dict], reference: dict[float, list[tuple[float, float]]]) -> list[str]:
    lines = ["| incline | lattice | m | bond by bond | recommended line |", "|---|---|---|---|---|"]
    for incline, path in sorted(reference.items()):
        for angle in (0, 20):
            for m in (3, 4):
                cells = []
                for name in ("stretch", "line-field-learn"):
                    some = [p for p in drawn if p["scene"] == "plate" and p["mode"] == incline and p["name"] == name
                            and p["m"] == m and p["angle"] == angle]
                    cells.append(f"{off(some[-1]['points'], name != 'stretch', path):.1f}" if some else "-")
                if cells != ["-", "-"]:
                    lines.append(f"| {incline:g} | {angle} | {m} | {cells[0]} | {cells[1]} |")
    return lines


def picture(drawn: list[dict], reference: dict[float, list[tuple[float, float]]], file: pathlib.Path) -> None:
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
    figure, axes = pyplot.subplots(1, 2, figsize=(11, 5.2), layout="constrained")
    colours = {"stretch": "tab:red", "scatter-10": "tab:orange", "softening-4": "tab:purple", "line-field-learn": "tab:blue"}
    labels = {"stretch": "bond by bond", "scatter-10": "scatter of 10 %", "softening-4": "softening", "line-field-learn": "crack as a line"}
    for p in drawn:
        if p["name"] not in colours or p["kind"][:2] != ("lattice", "quartic") or p["m"] != 3:
            continue
        x, y = zip(*p["points"])
        style = dict(color=colours[p["name"]])
        if p["scene"] == "plate" and p["angle"] == 20:
            axes[1].plot(x, y, "-" if p["name"] != "stretch" else ".", ms=2, **style)
        elif p["scene"] == "strip" and p["angle"] == 20 and p["seed"] <= 4 or p["scene"] == "narrow" and p["angle"] == 22.5:
            axes[0].plot(x, y, "-" if p["name"].startswith("line") else ".", ms=1.5, label=labels.pop(p["name"], None), **style)
    axes[0].set(title="Pulled strip, rows of the lattice at 20 degrees (line: 22.5)", xlim=(0, 60), ylim=(-20, 20), xlabel="spacings", aspect="equal")
    axes[0].legend(loc="lower left", fontsize=8)
    for path in reference.values():
        axes[1].plot(*zip(*path), "k--", lw=1)
    axes[1].set(title="Inclined edge cracks; dashed: boundary elements", xlim=(0, 75), ylim=(-10, 40), xlabel="spacings", aspect="equal")
    figure.savefig(file, dpi=110)


def write(out: pathlib.Path) -> None:
    rows, drawn = read(out / "results.csv"), paths(out / "paths.txt")
    reference = {}
    for line in (out / "boundary_paths.txt").read_text(encoding="ascii").splitlines():
        values = [float(v) for v in line.split()]
        reference[values[0]] = list(zip(values[2::3], values[3::3]))
    picture(drawn, reference, ROOT / "docs" / "directions.png")
    tables = straight_and_cuts(out) | {"angles": over_angle(rows), "running": running(rows), "mixed": mixed(rows), "inclined": inclined(drawn, reference)}
    put(tables)


def section(name: str) -> list[str]:
    text = (ROOT / "docs" / "directions.md").read_text(encoding="utf-8")
    return text.split(f"<!-- {name} -->\n")[1].split(f"\n<!-- end {name} -->")[0].splitlines()


def put(tables: dict[str, list[str]]) -> None:
    document = ROOT / "docs" / "directions.md"
    text = document.read_text(encoding="utf-8")
    for name, lines in tables.items():
        begin, end = f"<!-- {name} -->", f"<!-- end {name} -->"
        text = text[:text.index(begin) + len(begin)] + "\n" + "\n".join(lines) + "\n" + text[text.index(end):]
        print("\n".join(lines), "\n")
    document.write_text(text, encoding="utf-8")
