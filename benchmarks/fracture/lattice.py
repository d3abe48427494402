"""Tips of cracks in lattices against those of cracks in boundary elements that are as long as stated, and as long as the
lattice's are felt."""

from __future__ import annotations

import dataclasses
import math
import time
from typing import Callable, Optional

import bempd

Ends = tuple[tuple[float, float], tuple[float, float]]


@dataclasses.dataclass
class Plate:
    """A plate around the origin, or from x = 0 on, pulled by 1 in y; of boundary elements, a lattice, or a lattice around
    the crack in boundary elements."""

    half_width: float
    half_height: float
    crack: Ends
    left: Optional[float] = None
    patch: Optional[tuple[float, float]] = None  # half width and half height
    energy: float = 1e9

    def model(self, spacing: float = 0, horizon_ratio: int = 0, ahead: tuple[float, float] = (0, 0)) -> bempd.Model:
        """`ahead`: by how much the crack is longer at its ends."""
        model = bempd.Model(options={"crack.rule": "bond"})
        material = model.add_material(young_modulus=1, poisson_ratio=1 / 3, fracture_energy=self.energy)
        low = -self.half_width if self.left is None else self.left
        corners = bempd.rectangle(low, -self.half_height, self.half_width, self.half_height)
        if spacing and not self.patch:
            body = model.add_pd_region(material, corners, spacing=spacing, horizon_ratio=horizon_ratio)
        else:
            body = model.add_bem_region(material, corners, element_length=0.125 * self.half_width)
        if spacing and self.patch:
            x, y = self.patch
            model.add_hole(body, [(-x, -y), (-x, y), (x, y), (x, -y)])
            model.add_pd_region(material, bempd.rectangle(-x, -y, x, y), spacing=spacing, horizon_ratio=horizon_ratio)
        (x0, y0), (x1, y1) = self.crack
        length = math.hypot(x1 - x0, y1 - y0)
        c, s = (x1 - x0) / length, (y1 - y0) / length
        model.add_crack([(x0 - ahead[0] * c, y0 - ahead[0] * s), (x1 + ahead[1] * c, y1 + ahead[1] * s)])
        model.fix_point(corners[0])
        model.fix_point(corners[1], "y")
        model.add_traction(body, 3, "y", 1)
        model.add_traction(body, 1, "y", -1)
        return model


def centre(cells: int) -> tuple[Plate, float]:
    """A crack of about 2 in 4 x 6; its tips midway between columns and rows: an odd number of cells along each side."""
    spacing = 4 / (4 * cells + 1)
    height = (6 * cells + 1) * spacing
    return Plate(2, height / 2, ((-cells * spacing, 0), (cells * spacing, 0))), spacing


def edge(cells: int) -> tuple[Plate, float]:
    """A crack of about 1 from the edge of a strip of width 2.5."""
    spacing = 1 / (cells + 0.5)
    width, height = round(2.5 / spacing) * spacing, (6 * cells + 1) * spacing
    return Plate(width, height / 2, ((0, 0), (1, 0)), left=0), spacing


def inclined(degrees: float, cells: int) -> tuple[Plate, float]:
    spacing = 4 / (4 * cells + 1)
    height = (6 * cells + 1) * spacing
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    length, x, y = cells * spacing, -0.25 * spacing, 0.25 * spacing
    return Plate(2, height / 2, ((x - length * c, y - length * s), (x + length * c, y + length * s))), spacing


def patch(cells: int, margin: float) -> tuple[Plate, float]:
    """The lattice goes on for some spacings beyond the crack and its tips."""
    spacing = 1 / cells
    rows = (round(2 * margin) | 1) * spacing / 2
    return Plate(4, 4, ((-1, 0), (1, 0)), patch=(1 + (round(margin) + 0.5) * spacing, rows)), spacing


def row(name: str, case: tuple[Plate, float], horizon_ratio: int) -> str:
    plate, spacing = case
    model = plate.model(spacing, horizon_ratio)
    model.step(1)
    start = time.process_time()
    tips = model.tips()
    seconds = time.process_time() - start
    tip = tips[-1]
    ahead = {found.end: found.felt_ahead for found in tips}
    first = ahead.get(bempd.TipEnd.START, 0.0)
    stated = reference(plate, (0, 0))
    felt = reference(plate, (first, ahead[bempd.TipEnd.END]))
    size = math.hypot(felt.stress_intensity_1, felt.stress_intensity_2)

    def off(of: bempd.CrackTip) -> str:
        one = (tip.stress_intensity_1 - of.stress_intensity_1) / size
        two = (tip.stress_intensity_2 - of.stress_intensity_2) / size
        return f"{one:+.1e}, {two:+.1e}"

    length = round(math.dist(*plate.crack) / spacing / (1 if plate.left == 0 else 2))
    return (f"| {name} | {length} | {horizon_ratio} | {tip.contour_radius / spacing:.0f} | {tip.felt_ahead / spacing:.2f} | "
            f"{off(stated)} | {off(felt)} | {tip.t_stress - felt.t_stress:+.3f} | {tip.error / size:.0e} | "
            f"{1e3 * seconds:.0f} |")


def reference(plate: Plate, ahead: tuple[float, float]) -> bempd.CrackTip:
    model = plate.model(ahead=ahead)
    model.step(1)
    return model.tips()[-1]


def grown(events: int, every: int, horizon_ratio: int) -> list[str]:
    """A centre crack in a patch, while it grows."""
    plate, spacing = patch(40, 24)
    plate.energy = 1
    model = plate.model(spacing, horizon_ratio)
    lines = []
    for _ in range(events // every):
        for _ in range(every):
            model.step_to_next_event(1e6)
        tip = model.tips()[-1]
        longer = tip.x - plate.crack[1][0] + tip.felt_ahead
        of = reference(plate, (longer, longer))
        value = of.stress_intensity_1 * model.load_factor
        lines.append(f"| {model.statistics().broken_bonds} | {(tip.x - plate.crack[1][0]) / spacing:.1f} | "
                     f"{tip.felt_ahead / spacing:+.2f} | {tip.stress_intensity_1 / value - 1:+.1e} | "
                     f"{tip.error / tip.stress_intensity_1:.0e} | {tip.energy_release_rate:.3f} |")
    return lines


def cases() -> list[tuple[str, Callable[[], tuple[Plate, float]], int]]:
    found: list[tuple[str, Callable[[], tuple[Plate, float]], int]] = []
    for cells in (10, 20, 40):
        found += [("centre crack", lambda n=cells: centre(n), m) for m in (3, 4, 5)]
    for cells in (16, 32):
        found += [("edge crack", lambda n=cells: edge(n), m) for m in (3, 4)]
    for cells in (10, 20, 40):
        found += [("inclined, 45 degrees", lambda n=cells: inclined(45, n), m) for m in (3, 4, 5)]
    found += [("inclined, 30 degrees", lambda: inclined(30, 20), m) for m in (3, 4, 5)]
    for margin in (8, 16):
        found += [(f"patch, {margin} spacings around", lambda d=margin: patch(40, d), m) for m in (3, 4)]
    return found


def section() -> str:
    lines = ["| lattice | a over spacing | horizon | ring | felt ahead | K_I, K_II against stated | against felt | T | spread | ms |",
             "|---|---|---|---|---|---|---|---|---|---|"]
    for name, case, horizon_ratio in cases():
        lines.append(row(name, case(), horizon_ratio))
        print(lines[-1], flush=True)
    lines += ["", "While a centre crack of 40 spacings to the middle grows in a patch (horizon of 4 spacings, G0 = 1):", "",
              "| bonds broken | tip has moved by | felt ahead | K_I against felt | spread | G |", "|---|---|---|---|---|---|"]
    for line in grown(120, 30, 4):
        lines.append(line)
        print(line, flush=True)
    return "\n".join(lines)


if __name__ == "__main__":
    section()
