"""What closed cracks do: the table of contact in docs/research/README.md."""

from __future__ import annotations

import math
import time
from functools import partial
from typing import Callable

import bempd
import numpy as np

from timing import least_in_turns

RULES = ("none", "faces")
BONDS = {"crack.rule": "bond"}


def squeezed(rule: str, m: int, stress: tuple[float, float, float], crack: list[tuple[float, float]], cells: int = 60,
             ratio: float = 1 / 3, options: dict[str, str] | None = None, energy: float | None = None
             ) -> tuple[bempd.Model, int]:
    """A square whose outline moves as under a stress (xx, yy, xy) of plane stress, the load factor being the share of it."""
    xx, yy, xy = stress
    exx, eyy, exy = xx - ratio * yy, yy - ratio * xx, (1 + ratio) * xy
    model = bempd.Model(options={"contact": rule, **BONDS, **(options or {})})
    solid = model.add_material(young_modulus=1, poisson_ratio=ratio, **({"fracture_energy": energy} if energy else {}))
    region = model.add_pd_region(solid, bempd.rectangle(0, 0, cells, cells), 1, m)
    if crack:
        model.add_crack(crack)
    half = cells / 2

    def field(x: float, y: float) -> tuple[float, float]:
        return exx * (x - half) + exy * (y - half), exy * (x - half) + eyy * (y - half)

    for edge in (1, 2, 3, 4):
        model.prescribe_edge_function(region, edge, field)
    return model, region


def along_rows(half_length: float, cells: int = 60) -> list[tuple[float, float]]:
    return [(cells / 2 - half_length, cells / 2 + 0.5), (cells / 2 + half_length, cells / 2 + 0.5)]


def displacement_error(rule: str, m: int, stress: tuple[float, float, float]) -> float:
    """Of a pressed crack of 21 spacings, against the body without it: largest difference over largest displacement."""
    fields = []
    for crack in (along_rows(10.5), []):
        model, region = squeezed(rule, m, stress, crack)
        model.step(1)
        fields.append(model.field(region, "displacement"))
    return float(np.abs(fields[0] - fields[1]).max() / np.abs(fields[1]).max())


def slip(rule: str, m: int, shear_over_pressure: float) -> float:
    """In the middle of the crack, over that of the same crack under the shear alone, which faces without friction have
    under any pressure."""
    slips = []
    for contact, pressure in ((rule, 1 / shear_over_pressure), ("none", 0.0)):
        model, region = squeezed(contact, m, (0, -pressure, 1), along_rows(10.5))
        model.step(1)
        x, u = model.field(region, "position"), model.field(region, "displacement")
        at = {tuple(p): k for k, p in enumerate(np.round(x).astype(int).tolist())}
        slips.append(float(u[at[(30, 31)], 0] - u[at[(30, 30)], 0]))
    return slips[0] / slips[1]


def first_break(rule: str, m: int) -> float:
    """Load at which the first bond breaks of a crack along the rows, pressed at 45 degrees to them, over that of the same
    crack under the share of the shear in it alone."""
    loads = []
    for contact, pressure in ((rule, 0.5), ("none", 0.0)):
        model, _ = squeezed(contact, m, (-pressure, -pressure, 0.5), along_rows(10.5), energy=1e-6)
        loads.append(model.step_to_next_event(1e9).load_factor)
    return loads[0] / loads[1]


def hoop_strain_angle(half_length: float, distance: float, ratio: float = 1 / 3) -> float:
    """Where the hoop strain around the tip of a closed crack without friction is largest at a distance, in degrees from
    its direction: uniform stress without the shear on the faces, which is Westergaard's field (Tada, Paris and Irwin, The
    Stress Analysis of Cracks Handbook, part 1)."""
    best = (-math.inf, 0.0)
    for degrees in np.arange(0.0, 180.0, 0.1):
        t = math.radians(degrees)
        z = complex(half_length + distance * math.cos(t), distance * math.sin(t))
        root = np.sqrt(z - half_length) * np.sqrt(z + half_length)
        f, df = 0.5 * z / root, 0.5 * (1 / root - z * z / root**3)
        xx = -0.5 - 2 * f.imag - z.imag * df.real
        yy = -0.5 + z.imag * df.real
        xy = -f.real + z.imag * df.imag
        c, s = math.cos(t), math.sin(t)
        hoop = xx * s * s - 2 * xy * s * c + yy * c * c
        radial = xx * c * c + 2 * xy * s * c + yy * s * s
        best = max(best, (hoop - ratio * radial, degrees))
    return best[1]


def wing(rule: str, m: int, options: dict[str, str], breaks: int, half_length: float = 20.5, cells: int = 120
         ) -> list[str]:
    """Directions from the tips to what breaks between neighbours, 1 to 3, 3 to 6 and 6 to 9 spacings away, of a crack
    along the rows that is pressed at 45 degrees to them."""
    model, region = squeezed(rule, m, (-0.5, -0.5, -0.5), along_rows(half_length, cells), cells, energy=1e-6,
                             options=options)
    model.prepare()
    x, bonds = model.field(region, "position"), model.bonds(region)
    neighbours = np.linalg.norm(x[bonds.points[:, 0]] - x[bonds.points[:, 1]], axis=1) < 1.01
    before = bonds.states != 0
    while model.step_to_next_event(1e9).total_broken_bonds < breaks:
        pass
    broken = (model.bonds(region).states != 0) & ~before & neighbours
    middles = 0.5 * (x[bonds.points[broken, 0]] + x[bonds.points[broken, 1]])
    away = middles - cells / 2 - np.array((0, 0.5))
    away *= np.where(away[:, :1] < 0, -1, 1)  # both ends are alike, turned by half a turn
    away -= np.array((half_length, 0))
    angles, distances = np.degrees(np.arctan2(away[:, 1], away[:, 0])), np.hypot(*away.T)
    cells_of = []
    for low, high in ((1, 3), (3, 6), (6, 9)):
        inside = (distances >= low) & (distances < high)
        cells_of.append(f"{abs(float(np.mean(angles[inside]))):.0f}" if inside.any() else "-")
    return cells_of


def rows() -> list[list[str]]:
    found = []
    for m in (3, 4):
        for rule in RULES:
            found.append([f"{m}", rule, f"{displacement_error(rule, m, (0, -1, 0)):.1e}",
                          f"{displacement_error(rule, m, (-1, -1, 0)):.1e}",
                          *(f"{slip(rule, m, s):.3f}" for s in (0.3, 1, 3)), f"{first_break(rule, m):.2f}"])
            print(found[-1], flush=True)
    return found


def wing_rows() -> list[list[str]]:
    """Until wings are some 10 spacings long. By lines a crack that overlaps finds no way to grow on."""
    found = []
    for m, breaks in ((3, 330), (4, 800), (5, 1500)):
        limit = f"{hoop_strain_angle(20.5, m):.0f}"
        for rule in ("none", "faces"):
            line = wing(rule, m, {"crack.rule": "line"}, breaks) if rule == "faces" else ["-"] * 3
            found.append([f"{m}", rule, limit, *wing(rule, m, {}, breaks), *line])
            print(found[-1], flush=True)
    return found


def torn_plate(model: bempd.Model) -> float:
    """Lattice plate of 100 points a side with a central crack, as in the speed benchmark; a load factor without breaks."""
    solid = model.add_material(young_modulus=1, poisson_ratio=1 / 3, critical_stretch=1e-3)
    region = model.add_pd_region(solid, bempd.rectangle(0, 0, 99, 99), 1, 4)
    model.add_crack([(49.5, 39.500001), (49.5, 59.499999)])
    for edge, pull in ((4, -1.0), (2, 1.0)):
        model.prescribe_edge(region, edge, "x", pull)
        model.prescribe_edge(region, edge, "y", 0.0)
    return 1e-3


def torn_strip(model: bempd.Model) -> float:
    """README's strip with a finer lattice."""
    acrylic = model.add_material(young_modulus=3e9, poisson_ratio=1 / 3, thickness=5e-3, fracture_energy=300)
    left = model.add_bem_region(acrylic, bempd.rectangle(0, 0, 0.02, 0.02), 0.005)
    model.add_pd_region(acrylic, bempd.rectangle(0.02, 0, 0.04, 0.02), 0.00025, 4)
    right = model.add_bem_region(acrylic, bempd.rectangle(0.04, 0, 0.06, 0.02), 0.005)
    model.add_crack([(0.029625, 0), (0.029625, 0.007)])
    model.fix_edge(left, 4, "both")
    model.prescribe_edge(right, 2, "x", 1e-6)
    return 1.0


def seconds_of_run(build: Callable[[bempd.Model], float], rule: str, torn: bool) -> float:
    """Processor seconds from an empty model to its elastic answer, or until it is in two."""
    model = bempd.Model(options={"contact": rule, "threads": 1, **BONDS})
    began = time.process_time()
    load_factor = build(model)
    if torn:
        model.run_to_separation(1e9)
    else:
        model.step(load_factor)
    return time.process_time() - began


def cost_rows() -> list[list[str]]:
    """Processor seconds of whole runs over those of an elastic solve."""
    found = []
    for name, build in (("plate of 100 x 100", torn_plate), ("README's strip, spacing 0.25 mm", torn_strip)):
        least = least_in_turns({(rule, torn): partial(seconds_of_run, build, rule, torn)
                                for rule in ("none", "faces") for torn in (False, True)})
        for rule in ("none", "faces"):
            model = bempd.Model(options={"contact": rule, "threads": 1, **BONDS})
            build(model)
            report, s = model.run_to_separation(1e9), model.statistics()
            found.append([name, rule, f"{report.total_events}", f"{report.face_switches}",
                          f"{least[rule, True] / least[rule, False]:.1f}", f"{s.sparse_factorizations}", f"{s.factor_updates}",
                          f"{s.solves}"])
            print(found[-1], flush=True)
    return found


COST_HEADS = ["run until it is in two", "contact", "events", "places switched", "elastic solves' time", "factorizations",
              "changes of rank one", "solutions"]
HEADS = ["m", "contact", "pressed across", "pressed both ways", "slip at shear / pressure 0.3", "1", "3", "first break"]
WING_HEADS = ["m", "contact", "largest hoop strain at the horizon", "bond: 1 to 3 spacings", "3 to 6", "6 to 9",
              "line: 1 to 3", "3 to 6", "6 to 9"]
