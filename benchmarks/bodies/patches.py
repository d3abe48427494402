"""Lattice patches of bodies against whole lattices and against elements, cost over a body's size, and treatments of a crack."""

from __future__ import annotations

import math
import resource
import time

import numpy as np
import numpy.typing as npt

import bempd

POINTS = 20  # spacings along the crack
ENERGY = 1e-3


def plate(width: float, height: float, angle: float, carrier: str, horizon_ratio: int,
          shift: npt.ArrayLike = (0, 0), rule: str = "line") -> tuple[bempd.Model, int, int]:
    """A plate that its long sides pull apart, with a crack of 20 spacings, shifted from its middle; the spacing is 1."""
    model = bempd.Model(options={"stepping.control": "path", "crack.rule": rule})
    material = model.add_material(young_modulus=1000, poisson_ratio=1 / 3, fracture_energy=ENERGY)
    corners = bempd.rectangle(0, 0, width, height)
    if carrier == "whole lattice":
        body = model.add_pd_region(material, corners, spacing=1, horizon_ratio=horizon_ratio)
    else:
        body = model.add_body(material, corners)
    left = np.array([math.floor(width / 2) - POINTS / 2, math.floor(height / 2)]) - shift
    along = POINTS * np.array([math.cos(angle), math.sin(angle)])
    crack = model.add_crack([left, left + along])
    if carrier == "patch":
        model.set_crack_treatment(crack, "lattice")
        model.set_body_lattice(body, 1, horizon_ratio)
    if rule == "line":
        model.set_tip_frozen(crack, bempd.TipEnd.START)  # else rounding decides which end grows first
    model.fix_edge(body, 1)
    model.prescribe_edge(body, 3, "x", proportional=0)
    model.prescribe_edge(body, 3, "y", proportional=1)
    return model, body, crack


def grown(model: bempd.Model, steps: int) -> np.ndarray:
    """Load factor, place, and crack length of every extension in the first steps of the run."""
    for _ in range(steps):
        if model.step_to_next_event(1e9).separated:
            break
    return np.array([(e.load_factor, e.x, e.y, e.crack_length) for e in model.extensions()])


def against_lattices(quick: bool) -> list[str]:
    lines = ["| m | angle | steps | layouts | loads from the whole lattice | places [spacings] | loads from elements, "
             "patch | whole | points, patch | whole | s, patch | whole |", "|---|---|---|---|---|---|---|---|---|---|---|---|"]
    for ratio in (3,) if quick else (3, 4, 5):
        for degrees in (0,) if quick else (0, 20):
            lines.append(one_against_lattice(ratio, degrees))
    return lines


def one_against_lattice(ratio: int, degrees: float) -> str:
    width, height, steps = 44 * ratio, 22 * ratio, 8 * ratio
    # The crack is moved so that the patch has material points at whole numbers, as the whole lattice has.
    shift = plate(width, height, math.radians(degrees), "patch", ratio)[0].parts()[1].outline[0][0] % 1
    found, seconds, points = {}, {}, {}
    for carrier in ("patch", "whole lattice", "elements"):
        begin = time.process_time()
        model, _, _ = plate(width, height, math.radians(degrees), carrier, ratio, shift)
        found[carrier] = grown(model, steps)
        seconds[carrier], points[carrier] = time.process_time() - begin, model.statistics().material_points
        if carrier == "patch":
            layouts = np.count_nonzero(model.history()["event"] == 0)
    patch, whole = found["patch"], found["whole lattice"]
    count = min(len(patch), len(whole))
    loads = np.abs(patch[:count, 0] / whole[:count, 0] - 1)
    places = np.linalg.norm(patch[:count, 1:3] - whole[:count, 1:3], axis=1).max()
    lengths, of_elements = found["elements"][:, 3], found["elements"][:, 0]

    def off(lattice: np.ndarray) -> str:
        known = [row for row in lattice if lengths[0] <= row[3] <= lengths[-1]]
        errors = [row[0] / np.interp(row[3], lengths, of_elements) - 1 for row in known]
        return f"{100 * min(errors):+.1f} to {100 * max(errors):+.1f} %" if errors else "-"

    return (f"| {ratio} | {degrees} | {count} | {layouts} | {loads.max():.1e} | {places:.3f} | {off(patch)} | {off(whole)} "
            f"| {points['patch']:,} | {points['whole lattice']:,} | {seconds['patch']:.1f} | {seconds['whole lattice']:.1f} |")


def bond_by_bond(quick: bool) -> list[str]:
    """A patch and a whole lattice in which bonds break one by one. Loads are those of events that begin with the same broken
    bonds: of bonds that tie, either may be the first."""
    lines = ["| m | angle | events | with the same broken bonds | layouts | loads from the whole lattice | broken bonds | in one only "
             "| points, patch | whole | s, patch | whole |", "|---|---|---|---|---|---|---|---|---|---|---|---|"]
    for ratio in (3,) if quick else (3, 4, 5):
        for degrees in (0, 20):
            lines.append(one_bond_by_bond(ratio, degrees, 30 if quick else {3: 540, 4: 960, 5: 1100}[ratio]))
    return lines


def broken_bonds(model: bempd.Model, region: int) -> bytes:
    """Places of the ends of all broken bonds, in an order of their own."""
    bonds = model.bonds(region)
    ends = model.field(region, "position")[bonds.points[bonds.states == bempd.BondState.BROKEN]]
    numbers = np.rint(2 * ends).astype(np.int64) @ (1, 100000)
    return np.sort(np.sort(numbers, axis=1) @ (1, 10**10)).tobytes()


def one_bond_by_bond(ratio: int, degrees: float, events: int) -> str:
    width, height = 44 * ratio, 26 * ratio
    shift = plate(width, height, math.radians(degrees), "patch", ratio)[0].parts()[1].outline[0][0] % 1
    loads: dict[str, dict[bytes, float]] = {}
    seconds, points, last, layouts = {}, {}, {}, 0
    for carrier in ("patch", "whole lattice"):
        model, _, _ = plate(width, height, math.radians(degrees), carrier, ratio, shift + (4 * ratio, 0), "bond")
        loads[carrier], seconds[carrier], last[carrier] = {}, 0.0, b""
        for _ in range(events):
            begin = time.process_time()
            report = model.step_to_next_event(1e9)
            seconds[carrier] += time.process_time() - begin
            assert report.stop_reason == bempd.StopReason.EVENT
            loads[carrier][last[carrier]] = report.load_factor
            last[carrier] = broken_bonds(model, 2 if carrier == "patch" else 1)
        points[carrier] = model.statistics().material_points
        if carrier == "patch":
            layouts = np.count_nonzero(model.history()["event"] == 0)
    patch, whole = loads["patch"], loads["whole lattice"]
    same = patch.keys() & whole.keys()
    broken = {carrier: set(np.frombuffer(ends, np.int64)) for carrier, ends in last.items()}
    return (f"| {ratio} | {degrees} | {events} | {len(same)} | {layouts} | {max(abs(patch[key] / whole[key] - 1) for key in same):.1e} "
            f"| {len(broken['whole lattice'])} | {len(broken['patch'] ^ broken['whole lattice'])} "
            f"| {points['patch']:,} | {points['whole lattice']:,} | {seconds['patch']:.1f} | {seconds['whole lattice']:.1f} |")


def following(quick: bool) -> list[str]:
    """One end of a crack grows on, and its patch with it."""
    lines = ["| grown by [spacings] | layouts | points | elements | s | of them layouts | s for a step, last half | memory [GB] | "
             "stored energy by layouts |", "|---|---|---|---|---|---|---|---|---|"]
    model, _, crack = pulled(2000.0, "lattice")
    model.set_tip_frozen(crack, bempd.TipEnd.START)
    model.prepare()
    begin, seconds, layouts = time.process_time(), [], [0]
    for goal in (20, 40) if quick else (100, 200, 400, 800):
        while len(seconds) < goal:
            before = time.process_time()
            model.step_to_next_event(1e9)
            seconds.append(time.process_time() - before)
            layouts.append(np.count_nonzero(model.history()["event"] == 0))
        is_layout, spent = np.diff(layouts) != 0, np.array(seconds)
        usual = np.mean(spent[len(spent) // 2:][~is_layout[len(spent) // 2:]])  # many steps are computed at once
        of_layouts = np.sum(spent[is_layout] - usual)
        history = model.history()
        stored = history["stored_energy"]
        jumps = np.abs(stored[1:] / stored[:-1] - 1)[history["event"][1:] == 0]
        memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e6
        lines.append(f"| {model.crack_length(crack) - POINTS:.0f} | {len(jumps)} | {model.statistics().material_points:,} "
                     f"| {model.parts()[0].boundary_elements} | {time.process_time() - begin:.1f} | {of_layouts:.1f} | {usual:.3f} "
                     f"| {memory:.2f} | {jumps.max(initial=0):.1e} |")
    return lines


def sizes(quick: bool) -> list[str]:
    lines = ["| body, times the smallest | elements | points | first growth, patch | by elements | 12 steps, s | times the smallest |",
             "|---|---|---|---|---|---|---|"]
    first = 0.0
    for times in (1, 10) if quick else (1, 10, 100, 1000):
        best = math.inf
        for _ in range(3):
            begin = time.process_time()
            model, body, _ = pulled(100.0 * times, "lattice")
            grown(model, 12)
            best = min(best, time.process_time() - begin)
        elements, patch = model.parts()
        first = first or best
        lines.append(f"| {times} | {elements.boundary_elements} | {patch.material_points:,} | {patch.growth_load_factor:.5f} "
                     f"| {patch.element_growth_load_factor:.5f} | {best:.2f} | {best / first:.2f} |")
    return lines


def pulled(side: float, treatment: str) -> tuple[bempd.Model, int, int]:
    """A square plate under tension with a crack of 20 in its middle."""
    model = bempd.Model(options={"stepping.control": "path"})
    material = model.add_material(young_modulus=1000, poisson_ratio=1 / 3, fracture_energy=ENERGY)
    body = model.add_body(material, bempd.rectangle(-side / 2, -side / 2, side / 2, side / 2))
    crack = model.add_crack([(-POINTS / 2, 0), (POINTS / 2, 0)])
    model.set_crack_treatment(crack, treatment)
    model.set_body_lattice(body, 1, 4)
    model.fix_edge(body, 1, "y")
    model.fix_point((-side / 2, -side / 2), "x")
    model.add_traction(body, 3, "y", proportional=1)
    return model, body, crack


def treatments(quick: bool) -> list[str]:
    lines = ["| treatment | unknowns | K_I, start of the crack | load of growth | length after 12 events | s |", "|---|---|---|---|---|---|"]
    for treatment in ("automatic", "elements", "lattice", "frozen"):
        begin = time.process_time()
        model, body, crack = pulled(100, treatment)
        model.step(0.01)
        tip, unknowns = model.tips()[0], model.plan().unknowns
        growth = model.plan().growth_load_factor
        if treatment == "frozen":
            model.step(0.5)
        else:
            grown(model, 12)
        lines.append(f"| {treatment} | {unknowns} | {100 * tip.stress_intensity_1:.4f} | "
                     f"{'-' if growth > 1e300 else format(growth, '.5f')} | {model.crack_length(crack):.2f} "
                     f"| {time.process_time() - begin:.2f} |")
    return lines
