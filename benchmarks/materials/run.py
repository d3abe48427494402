"""Lattices of any Poisson's ratio: what is exact, how errors fall, and what a crack takes; tables in docs/research/tables.
Run it with benchmarks/run.sh materials, those of contact alone with benchmarks/run.sh materials contact,
what contact costs with benchmarks/run.sh materials contact-cost, and what runs take with benchmarks/run.sh materials costs."""

from __future__ import annotations

import math
import sys
import time
from functools import partial
from typing import Callable, Iterator

import bempd
import numpy as np

import contact
from stored_tables import store
from timing import least_in_turns

RATIOS = {"stress": (-0.2, 0.0, 0.2, 1 / 3, 0.45, 0.49), "strain": (0.0, 0.25, 0.4, 0.45, 0.49)}
BONDS = {"crack.rule": "bond"}
Field = Callable[[float, float], tuple[float, float]]


def plane_modulus(ratio: float, plane: str) -> float:
    return 1 if plane == "stress" else 1 / (1 - ratio * ratio)


def plane_ratio(ratio: float, plane: str) -> float:
    return ratio if plane == "stress" else ratio / (1 - ratio)


def materials() -> Iterator[tuple[str, float]]:
    for plane, ratios in RATIOS.items():
        for ratio in ratios:
            yield plane, ratio


def name(plane: str, ratio: float) -> str:
    return f"plane {plane}, {ratio:.4g}"


def table(heads: list[str], rows: list[list[str]]) -> str:
    lines = ["| " + " | ".join(heads) + " |", "|" + "---|" * len(heads)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows])


def worst(model: bempd.Model, regions: list[int], exact: Field) -> float:
    error = size = 0.0
    for region in regions:
        x, u = model.field(region, "position"), model.field(region, "displacement")
        e = np.array([exact(*p) for p in x])
        error, size = max(error, float(np.abs(u - e).max())), max(size, float(np.abs(e).max()))
    return error / size


# --- Exactness and errors


def patch(plane: str, ratio: float, m: int) -> list[str]:
    """Constant strain: a lattice alone, one between boundary elements that follow it, and that do not."""
    gradient = (7e-4, -3e-4, 5e-4, -4e-4)

    def exact(x: float, y: float) -> tuple[float, float]:
        return gradient[0] * x + gradient[1] * y, gradient[2] * x + gradient[3] * y

    def build(columns: str, length: float) -> float:
        model = bempd.Model()
        solid = model.add_material(young_modulus=1, poisson_ratio=ratio, plane=plane)
        regions = []
        for k, kind in enumerate(columns):
            box = bempd.rectangle(k, 0, k + 1, 1)
            regions.append(model.add_pd_region(solid, box, 0.05, m) if kind == "p"
                           else model.add_bem_region(solid, box, 0.2))
        if length > 0:
            model.set_edge_mesh(regions[0], 2, length)
            model.set_edge_mesh(regions[2], 4, length)
        for k, region in enumerate(regions):
            for edge in (1, 3, *((4,) if k == 0 else ()), *((2,) if k + 1 == len(regions) else ())):
                model.prescribe_edge_function(region, edge, exact)
        model.step(1)
        return worst(model, regions, exact)

    return [f"{build(columns, length):.0e}" for columns, length in (("p", 0), ("bpb", 0), ("bpb", 0.13))]


def kirsch_error(plane: str, ratio: float, m: int, cells: int) -> float:
    """Beside a hole of radius 1 under tension (Timoshenko and Goodier, Theory of Elasticity, art. 35): a square of side 1
    from (0.8, 0.8) on under the exact tractions; mean square error over that of the displacement."""
    shear = 1 / (2 * (1 + ratio))
    kappa = (3 - ratio) / (1 + ratio) if plane == "stress" else 3 - 4 * ratio

    def displacement(x: float, y: float) -> tuple[float, float]:
        r, t = math.hypot(x, y), math.atan2(y, x)
        return ((r * (kappa + 1) * math.cos(t) + 2 / r * ((1 + kappa) * math.cos(t) + math.cos(3 * t))
                 - 2 / r**3 * math.cos(3 * t)) / (8 * shear),
                (r * (kappa - 3) * math.sin(t) + 2 / r * ((1 - kappa) * math.sin(t) + math.sin(3 * t))
                 - 2 / r**3 * math.sin(3 * t)) / (8 * shear))

    def stress(x: float, y: float) -> tuple[float, float, float]:
        r2, t = x * x + y * y, math.atan2(y, x)
        c2, c4, s2, s4 = math.cos(2 * t), math.cos(4 * t), math.sin(2 * t), math.sin(4 * t)
        return (1 - (1.5 * c2 + c4) / r2 + 1.5 * c4 / r2**2, -(0.5 * c2 - c4) / r2 - 1.5 * c4 / r2**2,
                -(0.5 * s2 + s4) / r2 + 1.5 * s4 / r2**2)

    model = bempd.Model()
    solid = model.add_material(young_modulus=1, poisson_ratio=ratio, plane=plane)
    region = model.add_pd_region(solid, bempd.rectangle(0.8, 0.8, 1.8, 1.8), 1 / cells, m)
    for edge, (nx, ny) in ((1, (0, -1)), (2, (1, 0)), (3, (0, 1)), (4, (-1, 0))):

        def traction(x: float, y: float, n: tuple[int, int] = (nx, ny)) -> tuple[float, float]:
            xx, yy, xy = stress(x, y)
            return xx * n[0] + xy * n[1], xy * n[0] + yy * n[1]

        model.add_traction_function(region, edge, traction)
    model.fix_point((0.8, 0.8))
    model.fix_point((1.8, 0.8), "y")
    model.step(1)
    x, u = model.field(region, "position"), model.field(region, "displacement")
    e = np.array([displacement(*p) for p in x])
    rigid = np.zeros((2 * len(x), 3))
    rigid[0::2, 0] = rigid[1::2, 1] = 1
    rigid[0::2, 2], rigid[1::2, 2] = -x[:, 1], x[:, 0]

    def without_rigid(v: np.ndarray) -> np.ndarray:
        return v.ravel() - rigid @ np.linalg.lstsq(rigid, v.ravel(), rcond=None)[0]

    return float(np.linalg.norm(without_rigid(u - e)) / np.linalg.norm(without_rigid(e)))


def cantilever_error(plane: str, ratio: float, m: int) -> float:
    """80 by 20 cells under a parabolic end shear (the same book, art. 21): largest error over largest displacement."""
    young, nu, length, c = plane_modulus(ratio, plane), plane_ratio(ratio, plane), 4.0, 0.5
    inertia = 2 * c**3 / 3
    f = 1 / (6 * young * inertia)

    def exact(x: float, y_of_bottom: float) -> tuple[float, float]:
        y = y_of_bottom - c
        return (-f * y * ((6 * length - 3 * x) * x + (2 + nu) * (y * y - c * c)),
                f * (3 * nu * y * y * (length - x) + (4 + 5 * nu) * c * c * x + (3 * length - x) * x * x))

    model = bempd.Model()
    solid = model.add_material(young_modulus=1, poisson_ratio=ratio, plane=plane)
    region = model.add_pd_region(solid, bempd.rectangle(0, 0, length, 2 * c), 0.05, m)
    model.prescribe_edge_function(region, 4, exact)
    model.add_traction_function(region, 2, lambda x, y: (0, (c * c - (y - c) ** 2) / (2 * inertia)))
    model.step(1)
    return worst(model, [region], exact)


# --- Cracks


def tip_errors(plane: str, ratio: float, m: int) -> list[str]:
    """K_I of a centre crack, by rings in a lattice against boundary elements that are as long as the crack is felt."""

    def tips(spacing: float, left: float, right: float) -> list[bempd.CrackTip]:
        model = bempd.Model()
        solid = model.add_material(young_modulus=1, poisson_ratio=ratio, plane=plane)
        box = bempd.rectangle(-2, -3, 2, 3)
        body = model.add_pd_region(solid, box, spacing, m) if spacing else model.add_bem_region(solid, box, 0.25)
        model.add_crack([(-left, 0.025), (right, 0.025)])
        model.fix_point((-2, -3))
        model.fix_point((2, -3), "y")
        model.add_traction(body, 3, "y", 1)
        model.add_traction(body, 1, "y", -1)
        model.step(1)
        return model.tips()

    found = tips(0.05, 0.475, 0.475)
    felt = tips(0, 0.475 + found[0].felt_ahead, 0.475 + found[1].felt_ahead)
    return [f"{found[1].felt_ahead / 0.05:.2f}", f"{found[1].stress_intensity_1 / felt[1].stress_intensity_1 - 1:+.1e}"]


def first_break(plane: str, ratio: float, m: int, slanted: bool) -> float:
    """K_I over sqrt(E' G0) at which the first bond breaks: a square whose outline moves as the field of a crack along the
    rows of the lattice or at 45 degrees to them, whose tip lies in its middle."""
    n, turn = 60, math.pi / 4 if slanted else 0.0
    shear = 1 / (2 * (1 + ratio))
    kappa = (3 - ratio) / (1 + ratio) if plane == "stress" else 3 - 4 * ratio
    model = bempd.Model(options=BONDS)
    solid = model.add_material(young_modulus=1, poisson_ratio=ratio, plane=plane, fracture_energy=1e-6)
    region = model.add_pd_region(solid, bempd.rectangle(0, 0, n, n), 1, m)
    tip = (n / 2, n / 2 + 0.5)
    model.add_crack([(0, 0.5), tip] if slanted else [(0, tip[1]), tip])

    def field(x: float, y: float) -> tuple[float, float]:
        dx, dy = x - tip[0], y - tip[1]
        r, t = math.hypot(dx, dy), math.atan2(dy, dx) - turn
        t = (t + math.pi) % (2 * math.pi) - math.pi
        scale = math.sqrt(r / (2 * math.pi)) / (2 * shear)
        along = scale * math.cos(t / 2) * (kappa - math.cos(t))
        across = scale * math.sin(t / 2) * (kappa - math.cos(t))
        c, s = math.cos(turn), math.sin(turn)
        return c * along - s * across, s * along + c * across

    for edge in (1, 2, 3, 4):
        model.prescribe_edge_function(region, edge, field)
    report = model.step_to_next_event(1e9)
    return report.load_factor / math.sqrt(plane_modulus(ratio, plane) * 1e-6)


def strip_model(plane: str, ratio: float, m: int, height: int, length: int, start: float,
                options: dict[str, str]) -> tuple[bempd.Model, int, float]:
    """A strip between clamps that move apart, a crack along its middle, so that the load factor is the root of G over G0,
    G being that of the strip ahead; the model, its region and G0."""
    energy = 1e-6
    model = bempd.Model(options={**BONDS, **options})
    solid = model.add_material(young_modulus=1, poisson_ratio=ratio, plane=plane, fracture_energy=energy)
    region = model.add_pd_region(solid, bempd.rectangle(0, 0, length, height), 1, m)
    model.add_crack([(0, height / 2), (start, height / 2)])
    nu, modulus = plane_ratio(ratio, plane), plane_modulus(ratio, plane)
    strain = math.sqrt(energy * 2 * (1 - nu * nu) / modulus / height)
    for edge, sign in ((1, -1), (3, 1)):
        model.prescribe_edge(region, edge, "x", 0)
        model.prescribe_edge(region, edge, "y", sign * strain * height / 2)
    return model, region, energy


def strip(plane: str, ratio: float, m: int) -> tuple[list[float], int]:
    """Root of G over G0 at the first break and at most in steady growth, energy released per length over G0; how many
    events that took."""
    length, start = 150, 40.5
    model, region, energy = long_strip(plane, ratio, m, length, start)
    front = Front(model, region, 61 / 2)
    loads, released, places = [], [], []
    while not places or places[-1] < length - 1.3 * 61:
        report = model.step_to_next_event(1e9)
        loads.append(report.load_factor)
        released.append(report.released_energy)
        places.append(front.place())
    first = next(k for k, x in enumerate(places) if x > start + 6)
    per_length = (released[-1] - released[first]) / (places[-1] - places[first]) / energy
    return [loads[0], max(loads[first:]), per_length], len(loads)


def long_strip(plane: str, ratio: float, m: int, length: float = 150, start: float = 40.5) -> tuple[bempd.Model, int, float]:
    return strip_model(plane, ratio, m, 61, length, start, {"stepping.control": "path"})


# --- What runs take


def strip_seconds(plane: str, ratio: float, m: int, events: int) -> float:
    """Processor seconds of so many events."""
    model, _, _ = long_strip(plane, ratio, m)
    model.prepare()
    began = time.process_time()
    for _ in range(events):
        model.step_to_next_event(1e9)
    return time.process_time() - began


def factor_entries(plane: str, ratio: float, m: int) -> int:
    model, _, _ = long_strip(plane, ratio, m)
    model.step_to_next_event(1e9)
    return int(model.statistics().factor_nonzeros)


def cracked_plate(plane: str, ratio: float) -> bempd.Model:
    """60 by 60 spacings between columns that are pulled apart, a crack of 12 in the middle."""
    model = bempd.Model(options={"threads": 1, **BONDS})
    solid = model.add_material(young_modulus=1, poisson_ratio=ratio, plane=plane, critical_stretch=1e-3)
    region = model.add_pd_region(solid, bempd.rectangle(0, 0, 59, 59), 1, 4)
    model.add_crack([(29.5, 23.500001), (29.5, 35.499999)])
    for edge, pull in ((4, -1.0), (2, 1.0)):
        model.prescribe_edge(region, edge, "x", pull)
        model.prescribe_edge(region, edge, "y", 0.0)
    return model


def cracked_layers(plane: str, ratio: float) -> bempd.Model:
    """The same crack in a lattice of 17 by 99 spacings between boundary elements 41 spacings wide."""
    model = bempd.Model(options={"threads": 1, **BONDS})
    solid = model.add_material(young_modulus=1, poisson_ratio=ratio, plane=plane, critical_stretch=1e-3)
    left = model.add_bem_region(solid, bempd.rectangle(0, 0, 41, 99), 10)
    model.add_pd_region(solid, bempd.rectangle(41, 0, 58, 99), 1, 4)
    right = model.add_bem_region(solid, bempd.rectangle(58, 0, 99, 99), 10)
    model.add_crack([(49.5, 39.5), (49.5, 59.5)])
    model.prescribe_edge(left, 4, "x", -1)
    model.prescribe_edge(right, 2, "x", 1)
    model.fix_point((0, 49.5), "y")
    return model


def run_seconds(build: Callable[[str, float], bempd.Model], plane: str, ratio: float) -> float:
    """Processor seconds of a run to separation."""
    model = build(plane, ratio)
    model.prepare()
    began = time.process_time()
    model.run_to_separation(1e9)
    return time.process_time() - began


def run_events(build: Callable[[str, float], bempd.Model], plane: str, ratio: float) -> int:
    model = build(plane, ratio)
    model.run_to_separation(1e9)
    return len(model.history())


def is_of_bonds(plane: str, ratio: float) -> bool:
    return ratio == (1 / 3 if plane == "stress" else 0.25)


def runs_table() -> list[list[str]]:
    """Seconds of whole runs and of their events over those without squares, of the same plane state."""
    builds = (cracked_plate, cracked_layers)
    times = [least_in_turns({of: partial(run_seconds, build, *of) for of in materials()}) for build in builds]
    found = {of: [(least[of], run_events(build, *of)) for least, build in zip(times, builds)] for of in materials()}
    rows = []
    for of, costs in found.items():
        plain = found[next(other for other in found if other[0] == of[0] and is_of_bonds(*other))]
        cells = []
        for (seconds, events), (plain_seconds, plain_events) in zip(costs, plain):
            cells += [f"{seconds:.2f}", f"{seconds / plain_seconds:.2f}",
                      f"{seconds / events / (plain_seconds / plain_events):.2f}"]
        rows.append([name(*of), *cells])
        print(rows[-1], flush=True)
    return rows


class Front:
    """How far bonds of length 1 across the middle row are gone."""

    def __init__(self, model: bempd.Model, region: int, middle: float) -> None:
        x, ends = model.field(region, "position"), model.bonds(region).points
        low, high = x[ends[:, 0]], x[ends[:, 1]]
        self.across = np.flatnonzero((low[:, 0] == high[:, 0]) & (low[:, 1] == middle - 0.5) & (high[:, 1] == middle + 0.5))
        self.places = low[self.across, 0]
        self.model, self.region = model, region

    def place(self) -> float:
        gone = self.model.bonds(self.region).states[self.across] != 0
        return float(self.places[gone].max())


def updates_per_bond(plane: str, ratio: float, m: int) -> float:
    """Changes of rank one of the factor for each bond that breaks, where the whole body is solved at every event."""
    model, _, _ = strip_model(plane, ratio, m, 41, 60, 20.5, {"test.solver": "plain"})
    for _ in range(40):
        model.step_to_next_event(1e9)
    statistics = model.statistics()
    return statistics.factor_updates / statistics.broken_bonds


def write(tables: dict[str, str]) -> None:
    for name_of_table, text in tables.items():
        store(f"materials_{name_of_table.replace(' ', '_')}", text)


def strip_tables() -> dict[str, str]:
    """Toughness, and what that takes."""
    rows, costs = [], []
    for m in (3, 4):
        events_of = {}
        for of in materials():
            values, events = strip(*of, m)
            rows.append([f"{m}", name(*of), *(f"{first_break(*of, m, slanted):.2f}" for slanted in (False, True)),
                         *(f"{value:.2f}" for value in values)])
            events_of[of] = events
            print(rows[-1], flush=True)
        seconds = least_in_turns({of: partial(strip_seconds, *of, m, events) for of, events in events_of.items()})
        taken = {of: (least, factor_entries(*of, m), events_of[of]) for of, least in seconds.items()}
        costs += [cost_row(m, of, taken) for of in taken]
    return {"toughness": table(["m", "material", "first break along rows", "at 45 degrees", "strip: first break",
                                "most in growth", "energy per length"], rows),
            "cost": table(["m", "material", "nonzeros of the factor", "seconds", "over bonds alone", "of one event",
                           "updates per bond"], costs),
            "runs": table(["material", "plate [s]", "over bonds alone", "of one event", "layers [s]", "over bonds alone",
                           "of one event"], runs_table())}


def main() -> None:
    write({"contact cost": table(contact.COST_HEADS, contact.cost_rows())})
    if sys.argv[1:] == ["contact-cost"]:
        return
    if sys.argv[1:] != ["costs"]:
        write({"contact": table(contact.HEADS, contact.rows()), "wings": table(contact.WING_HEADS, contact.wing_rows())})
    if sys.argv[1:] == ["contact"]:
        return
    write(strip_tables())
    if sys.argv[1:] == ["costs"]:
        return
    tables = {}
    tables["patch"] = table(
        ["material", "lattice alone", "with boundary elements", "that do not match"],
        [[name(*of), *patch(*of, 4)] for of in materials()])
    rows = []
    for of in materials():
        errors = [kirsch_error(*of, 4, cells) for cells in (10, 20, 40)]
        rows.append([name(*of), *(f"{e:.2e}" for e in errors), f"{math.log2(errors[1] / errors[2]):.2f}",
                     f"{cantilever_error(*of, 4):.1e}"])
    tables["order"] = table(["material", "10 cells", "20", "40", "order", "cantilever"], rows)
    tables["tips"] = table(["material", "felt ahead, m = 3", "K_I", "felt ahead, m = 4", "K_I"],
                           [[name(*of), *tip_errors(*of, 3), *tip_errors(*of, 4)] for of in materials()])
    write(tables)


def cost_row(m: int, of: tuple[str, float], taken: dict[tuple[str, float], tuple[float, int, int]]) -> list[str]:
    plain = taken[next(other for other in taken if other[0] == of[0] and is_of_bonds(*other))]
    seconds, nonzeros, events = taken[of]
    return [f"{m}", name(*of), f"{nonzeros}", f"{seconds:.2f}", f"{seconds / plain[0]:.2f}",
            f"{seconds / events / (plain[0] / plain[2]):.2f}", f"{updates_per_bond(*of, m):.2f}"]


if __name__ == "__main__":
    main()
