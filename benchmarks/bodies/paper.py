"""The three cracks of Yang and Liu (2021) as bodies, beside the layouts by hand of examples/centre_crack, mixed_mode_crack and
two_edge_cracks: boundary elements with a strip of lattice, in which bonds break one by one, or cracks grow as lines."""

from __future__ import annotations

import dataclasses
import math
import time
from typing import Any, Callable, Sequence

import bempd

MM = 1e-3
SPACING, HORIZON_RATIO, ELEMENT = 0.5 * MM, 4, 5 * MM
LIMIT = 1000.0  # increments, more than any of them bears

Place = tuple[float, float]


@dataclasses.dataclass
class Plate:
    name: str
    size: Place
    strip: tuple[float, float, float, float]  # of the layout by hand
    cracks: Sequence[Sequence[Place]]
    young: float
    stretch: float  # critical, of bonds
    hold: Callable[[bempd.Model, int, int], None]  # supports and loads, on the regions with the first and the last edge
    options: dict[str, Any] = dataclasses.field(default_factory=dict)


def fracture_energy(young: float, stretch: float) -> float:
    """Of a critical stretch, by the paper's Eq. 15."""
    horizon = HORIZON_RATIO * SPACING
    return stretch**2 * 7 * (120 * math.pi - 133) * young * horizon / (1024 * math.pi)


def pulled_ends(height: float) -> Callable[[bempd.Model, int, int], None]:
    """Both ends go apart by 2e-8 m an increment; one pin keeps the plate from sliding."""

    def hold(model: bempd.Model, left: int, right: int) -> None:
        model.prescribe_edge(left, 4, "x", proportional=-2e-8)
        model.prescribe_edge(right, 2, "x", proportional=2e-8)
        model.fix_point((0, height / 2), "y")

    return hold


def pulled_by_tractions(model: bempd.Model, lower: int, upper: int) -> None:
    """By 0.1 MPa an increment. Half a turn brings the plate onto itself."""
    model.add_traction(lower, 1, "y", proportional=-0.1e6)
    model.add_traction(upper, 3, "y", proportional=0.1e6)
    model.fix_point((25 * MM, 0))
    model.fix_point((25 * MM, 50 * MM), "x")


def plates() -> list[Plate]:
    half = 5 * MM
    slanted = half * math.sqrt(0.5)
    middle, low, high = 25 * MM, 25 * MM - slanted, 25 * MM + slanted
    edge_stretch = math.sqrt(3.28876 / fracture_energy(72e9, 1))
    return [
        Plate("centre crack", (50 * MM, 49.5 * MM), (20.75 * MM, 0, 29.25 * MM, 49.5 * MM),
              [[(middle, 24.75 * MM - half), (middle, 24.75 * MM + half)]], 30e9, 8e-4, pulled_ends(49.5 * MM)),
        Plate("inclined crack", (50 * MM, 50 * MM), (14.75 * MM, 0, 35.25 * MM, 50 * MM), [[(low, low), (high, high)]], 30e9, 8e-4,
              pulled_ends(50 * MM)),
        Plate("two edge cracks", (50 * MM, 50 * MM), (0, 17.25 * MM, 50 * MM, 32.75 * MM),
              [[(0, 24 * MM), (2 * MM, 24 * MM)], [(50 * MM, 26 * MM), (48 * MM, 26 * MM)]], 72e9, edge_stretch,
              pulled_by_tractions, {"crack.tie_share": 0.02})]


def by_hand(plate: Plate, rule: str) -> bempd.Model:
    """Boundary elements on both sides of the strip of lattice."""
    model = bempd.Model(options={"threads": 1, "crack.rule": rule, **plate.options})
    energy = fracture_energy(plate.young, plate.stretch)
    breaks: dict[str, float] = {"critical_stretch": plate.stretch} if rule == "bond" else {"fracture_energy": energy}
    solid = model.add_material(young_modulus=plate.young, poisson_ratio=1 / 3, **breaks)
    x0, y0, x1, y1 = plate.strip
    width, height = plate.size
    before = (0, 0, x0, height) if x0 > 0 else (0, 0, width, y0)
    after = (x1, 0, width, height) if x0 > 0 else (0, y1, width, height)
    first = model.add_bem_region(solid, bempd.rectangle(*before), ELEMENT)
    model.add_pd_region(solid, bempd.rectangle(*plate.strip), SPACING, HORIZON_RATIO)
    last = model.add_bem_region(solid, bempd.rectangle(*after), ELEMENT)
    for crack in plate.cracks:
        model.add_crack(crack)
    plate.hold(model, first, last)
    return model


def as_body(plate: Plate, wanted: float) -> bempd.Model:
    model = bempd.Model(options={"threads": 1, "error.wanted": wanted, **plate.options})
    solid = model.add_material(young_modulus=plate.young, poisson_ratio=1 / 3,
                               fracture_energy=fracture_energy(plate.young, plate.stretch))
    body = model.add_body(solid, bempd.rectangle(0, 0, *plate.size))
    for crack in plate.cracks:
        model.add_crack(crack)
    plate.hold(model, body, body)
    return model


def row(plate: Plate, layout: str, model: bempd.Model) -> str:
    """A run until the plate is in two, or nothing grows any more."""
    begin = time.process_time()
    model.prepare()
    unknowns = model.statistics().sparse_unknowns or model.plan().unknowns
    prepared = time.process_time() - begin
    report = model.step_to_next_event(LIMIT)
    first, largest, force, events = report.load_factor, report.load_factor, report.peak_resistance, 0
    while report.events > 0:
        events += report.events
        largest, force = max(largest, report.load_factor), max(force, report.peak_resistance)
        if report.separated:
            break
        report = model.step_to_next_event(LIMIT)
    seconds = time.process_time() - begin
    return (f"| {plate.name} | {layout} | {unknowns:,} | {prepared:.2f} | {seconds:.2f} | {events:,} | {first:.2f} | {largest:.2f} "
            f"| {force / 1e3:.4g} |")


def table(quick: bool) -> list[str]:
    lines = ["| the paper's | layout | unknowns | seconds to prepare | of the run | events | first load | largest load, increments "
             "| largest force [kN/m] |", "|---|---|---|---|---|---|---|---|---|"]
    for plate in plates()[:1] if quick else plates():
        lines.append(row(plate, "by hand, bond by bond", by_hand(plate, "bond")))
        lines.append(row(plate, "by hand, as a line", by_hand(plate, "line")))
        lines.append(row(plate, "body, 1 % wanted", as_body(plate, 0.01)))
    return lines
