"""Cracks in lattices, as lines and bond by bond, against boundary elements: bodies, what is measured, and the tables.

Results are kept line by line in lines.txt; what is there is not run again."""

from __future__ import annotations

import concurrent.futures
import functools
import json
import math
import pathlib
from typing import Any, Callable

import bempd
import bodies
import faces
import ligaments
import numpy as np
import strip

SIDE = 80.0
STEPS = 45
HORIZONS = (3, 4, 5, 6)


def plate(kind: str, crack: list[tuple[float, float]], m: int = 3, angle: float = 0, side: float = SIDE) -> tuple[bempd.Model, int]:
    """A plate between clamps that move apart; `kind` is "bem" or a crack rule, `angle` that of the lattice [deg]."""
    model = bempd.Model()
    if kind != "bem":
        model.options["crack.rule"] = kind
        model.options["stepping.control"] = "path"
    material = model.add_material(young_modulus=8 / 9, poisson_ratio=1 / 3, fracture_energy=1)
    box = bempd.rectangle(0, -side / 2, side, side / 2)
    if kind == "bem":
        body = model.add_bem_region(material, box, side / 16)
    else:
        body = model.add_pd_region(material, box, 1.0, m, lattice_angle=math.radians(angle))
    if crack:
        model.add_crack(crack)
    for edge, value in ((1, -1.0), (3, 1.0)):
        model.prescribe_edge(body, edge, "y", value)
        model.fix_edge(body, edge, "x")
    return model, body


def edge_crack(incline: float, start: float, side: float = SIDE) -> list[tuple[float, float]]:
    a = math.radians(incline)
    return [(0, start), (side / 5 * math.cos(a), start + side / 5 * math.sin(a))]


@functools.lru_cache(None)
def reference(incline: float, start: float, side: float = SIDE) -> tuple[np.ndarray, np.ndarray]:
    """Tips and load factors of boundary elements with steps of one spacing, by the largest hoop stress as lines go."""
    model, _ = plate("bem", edge_crack(incline, start, side), side=side)
    model.step(1)
    places, loads = [edge_crack(incline, start, side)[1]], []
    for _ in range(STEPS + 6):
        model.grow_cracks(1.0)
        loads.append(model.load_factor)
        last = model.extensions()[-1]
        places.append((last.x, last.y))
        if last.x > side - 14:
            break
    return np.array(places), np.array(loads)


def inclined(incline: float, m: int, angle: float, rule: str, start: float, finer: int = 1) -> dict[str, Any]:
    """`finer`: the same body with so many times as many points along its sides."""
    side = SIDE * finer
    places, known = reference(incline, start, side)
    model, body = plate(rule, edge_crack(incline, start, side), m, angle, side)
    loads, reached = [], 0.0
    most = STEPS if rule != "bond" else 20000
    while len(loads) < most and reached < side - 14:
        report = model.step_to_next_event(1e6)
        if report.stop_reason != bempd.StopReason.EVENT:
            break
        loads.append(report.load_factor)
        if rule == "bond" and len(loads) % 50 == 0:
            reached = strip.middles(model, body)[:, 0].max()
    found = strip.middles(model, body)
    off, ways = [], []
    for x in np.arange(places[0, 0] + 3, min(found[:, 0].max() - m, places[-1, 0]), 2.0):
        near = found[abs(found[:, 0] - x) < 1.5]
        if len(near):
            off.append(near[:, 1].mean() - np.interp(x, *places.T))
            ways.append(x)
    slope = np.polyfit(ways, off, 1)[0] if len(ways) > 2 else math.nan
    result: dict[str, Any] = {"first": loads[0] / known[0], "off": float(np.abs(off).max()), "degrees": math.degrees(math.atan(slope)),
              "over": float(ways[-1] - ways[0])}
    if rule != "bond":
        ratios = np.array(loads[:len(known)]) / known[:len(loads)]
        energy = np.diff(model.history()["released_energy"][:len(loads)])
        result |= {"early": float(abs(ratios[1:5] - 1).max()), "steady": float(abs(ratios[5:] - 1).max()), "energy": float(energy[4:].mean())}
    if m == 3 and angle == strip.DRAWN_ANGLE and finer == 1:
        result |= {"path": found.round(2).tolist(), "reference": places.round(2).tolist()}
    return result


def bar(m: int, angle: float, hole: bool) -> tuple[bempd.Model, int]:
    """No crack: a strip with a round hole of 8 spacings, or with slanted sides, pulled at its ends."""
    model = bempd.Model(options={"crack.rule": "line", "test.outline_points": "always"})
    material = model.add_material(young_modulus=1, poisson_ratio=1 / 3, critical_stretch=1e-3)
    outline = bempd.rectangle(0, -24, 64, 24) if hole else [(0, -24), (32, -15), (64, -24), (64, 24), (32, 15), (0, 24)]
    body = model.add_pd_region(material, outline, 1, m, lattice_angle=math.radians(angle))
    if hole:
        model.add_circular_hole(body, (32, 0), 8)
    right = 2 if hole else 3
    left = 4 if hole else 6
    model.prescribe_edge(body, left, "x", -1)
    model.prescribe_edge(body, right, "x", 1)
    model.fix_point((0, -24), "y")
    return model, body


def begun(m: int, angle: float, hole: bool) -> dict[str, Any]:
    """Where a crack begins without one, its direction, and whether the body ends in two pieces."""
    model, body = bar(m, angle, hole)
    first = model.step_to_next_event(1e6)
    start = strip.middles(model, body)
    for _ in range(400):
        last = model.step_to_next_event(1e6)
        if last.stop_reason != bempd.StopReason.EVENT:
            break
    found = strip.middles(model, body)
    if hole:
        upper = found[(found[:, 1] > 9) & (found[:, 1] < 23)]
        lower = found[(found[:, 1] < -9) & (found[:, 1] > -23)]
        parts = [part for part in (upper, lower) if len(part)]
    else:
        parts = [found[abs(found[:, 1]) < 13]]
    tilt = max(abs(math.degrees(math.atan(np.polyfit(part[:, 1], part[:, 0], 1)[0]))) for part in parts)
    return {"load": first.load_factor, "x": float(start[:, 0].mean()), "y": float(abs(start[:, 1].mean())), "tilt": tilt,
            "separated": model.piece_count > 1, "bonds": int(last.total_broken_bonds)}


def known_body(name: str, spacing: float, m: int) -> dict[str, Any]:
    return bodies.compared(name, spacing, m, 240)


def jobs() -> list[list]:
    """Larger horizons at fewer angles; a crack that almost follows the edge without what else the large loads would break."""
    found: list[list] = []
    for m in HORIZONS:
        few = m > 4
        for incline in (15.0, 45.0, 75.0) if few else (15.0, 30.0, 45.0, 60.0, 75.0):
            for angle in (0.0, 20.0):
                found.append(["inclined", incline, m, angle, "tips" if incline > 70 else "line", 0.513 if angle == 0 else 0.0])
        for angle in (0.0, 15.0, 30.0) if few else (0.0, 7.5, 15.0, 22.5, 30.0, 45.0):
            for start in (0.513,) if few else (0.513, 0.237):
                found.append(["inclined", 0.0, m, angle, "line", start])
    found += [["inclined", incline, 3, strip.DRAWN_ANGLE, "bond", 0.0] for incline in (15.0, 30.0, 45.0)] + strip.jobs()
    # The plate again with its tip at two and three times as many spacings from the edge. With m = 3 and the lattice
    # turned no network of bonds is found if the crack's mouth is in the middle of the edge.
    for finer in (2, 3):
        for m in (3, 4):
            for angle in (0.0, 20.0):
                found.append(["inclined", 75.0, m, angle, "tips", 0.0 if m == 4 and angle else 0.513, finer])
    for scene in faces.SCENES:
        for m in (3, 4):
            for angle in (0.0, 20.0):
                found.append(["face", scene, m, angle])
    for spacing in (1e-3, 5e-4, 2.5e-4):
        for m in (3, 4):
            found.append(["ligament", spacing, m])
    found += [["tip", m, part] for m in (3, 4) for part in ligaments.TIP_PARTS]
    for m in (3, 4):
        for angle in (0.0, 20.0):
            for hole in (True, False):
                found.append(["begun", m, angle, hole])
    for name, spacing, m in (("plate free", 0.2, 3), ("plate free", 0.1, 3), ("plate free", 0.1, 4), ("plate held", 0.1, 3),
                             ("beam 1.0 6", 0.125, 4), ("beam 1.0 6", 0.0625, 4), ("beam 1.5 5", 0.125, 4), ("beam 1.5 5", 0.0625, 3),
                             ("beam 1.5 5", 0.0625, 4)):
        found.append(["body", name, spacing, m])
    return found


def one(job: list) -> tuple[list, dict[str, Any]]:
    try:
        return job, {"inclined": inclined, "begun": begun, "body": known_body, "face": faces.compared,
                     "ligament": ligaments.compared, "tip": ligaments.tip_at, "strip": strip.torn}[job[0]](*job[1:])
    except bempd.Error as failed:
        return job, {"failed": str(failed)}


def run(out: pathlib.Path, workers: int, only: str, wanted: Callable[[tuple], bool]) -> None:
    file = out / "lines.txt"
    have = {json.dumps(json.loads(line)[0]) for line in file.read_text("ascii").splitlines()} if file.exists() else set()
    chosen = [job for job in jobs() if json.dumps(job) not in have and only in json.dumps(job) and wanted(tuple(job))]
    with concurrent.futures.ProcessPoolExecutor(workers) as pool:
        for answer in pool.map(one, chosen):
            print(*answer, flush=True)
            with file.open("a", encoding="ascii") as kept:
                kept.write(json.dumps(answer) + "\n")


def spread(values: list[float]) -> str:
    return f"{min(values):.2f} .. {max(values):.2f}"


def finer_rows(found: dict[tuple, dict[str, Any]]) -> list[str]:
    rows = ["| spacings from the edge | lattice | m | first load | loads after 1 to 4 spacings, worst | after 5 and more | distance |", "|---|---|---|---|---|---|---|"]
    for finer in (1, 2, 3):
        for job, r in sorted((item for item in found.items() if item[0][:2] == ("inclined", 75) and (*item[0], 1)[6] == finer),
                             key=lambda item: item[0][2:4]):
            if job[2] <= 4 and job[4] != "bond":
                rows.append(f"| {SIDE / 5 * finer * math.cos(math.radians(75)):.0f} | {job[3]:g} | {job[2]} | {r['first']:.2f} |"
                            f" {100 * r['early']:.0f} % | {100 * r['steady']:.0f} % | {r['off']:.1f} |")
    return rows


def face_rows(found: dict[tuple, dict[str, Any]]) -> list[str]:
    rows = ["| crack | lattice | m | loads 3 horizons and more before the face | 1.5 to 3 | less than 1.5 | way off by, in spacings |", "|---|---|---|---|---|---|---|"]
    return rows + [faces.row(*job[1:], result) for job, result in found.items() if job[0] == "face"]


def results(out: pathlib.Path) -> dict[tuple, dict[str, Any]]:
    rows = [json.loads(line) for line in (out / "lines.txt").read_text("ascii").splitlines()]
    return {tuple(job): result for job, result in rows if "failed" not in result}


def tables(found: dict[tuple, dict[str, Any]]) -> dict[str, list[str]]:
    straight = ["| m | runs | direction, mean error [deg] | worst | first load over boundary elements' | loads from 5 spacings on, worst | energy per length / G0 |",
                "|---|---|---|---|---|---|---|"]
    for m in HORIZONS:
        some = [r for job, r in found.items() if job[0] == "inclined" and job[1] == 0 and job[2] == m and job[4] != "bond"]
        if some:
            errors = [abs(r["degrees"]) for r in some]
            straight.append(f"| {m} | {len(some)} | {np.mean(errors):.1f} | {max(errors):.1f} | {spread([r['first'] for r in some])} |"
                            f" {100 * max(r['steady'] for r in some):.0f} % | {spread([r['energy'] for r in some])} |")
    inclines = ["| incline | lattice | m | first load | loads after 1 to 4 spacings, worst | after 5 and more | distance | direction off by [deg] | energy per length / G0 |",
                "|---|---|---|---|---|---|---|---|---|"]
    for job, r in sorted((item for item in found.items() if item[0][0] == "inclined"), key=lambda item: item[0][1:4]):
        if job[1] > 0 and len(job) == 6 and job[4] != "bond":
            inclines.append(f"| {job[1]:g} | {job[3]:g} | {job[2]} | {r['first']:.2f} | {100 * r['early']:.0f} % | {100 * r['steady']:.0f} % |"
                            f" {r['off']:.1f} | {abs(r['degrees']):.1f} | {r['energy']:.2f} |")
    births = ["| strip without a crack | lattice | m | first load factor | begins at (x, y) | its way off by [deg] | in two pieces |",
              "|---|---|---|---|---|---|---|"]
    for job, r in sorted(found.items(), key=lambda item: str(item[0])):
        if job[0] == "begun":
            births.append(f"| {'round hole, radius 8' if job[3] else 'slanted sides, waist 30'} | {job[2]:g} | {job[1]} | {r['load']:.4f} |"
                          f" {r['x']:.1f}, {r['y']:.1f} | {r['tilt']:.1f} | {'yes' if r['separated'] else 'no'} |")
    known = ["| body | spacing | m | places compared | largest distance, in spacings | the lattice's crack comes to |", "|---|---|---|---|---|---|"]
    for job, r in found.items():
        if job[0] == "body":
            known.append(f"| {job[1]} | {job[2]} | {job[3]} | {r['compared']} | {r['spacings']:.1f} | {r['end'][0]:.2f}, {r['end'][1]:.2f} |")
    return {"lines-straight": straight, "lines-inclined": inclines, "lines-finer": finer_rows(found), "lines-faces": face_rows(found),
            "lines-ligaments": ligaments.rows(found), "lines-tips": ligaments.tip_rows(found),
            "lines-begun": births, "lines-bodies": known, "running": strip.rows(found)}
