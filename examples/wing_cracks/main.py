"""Presses a plate with a crack at 45 degrees to the pressure until wing cracks grow from its tips, with faces that press on each
other and with faces that pass through each other.

usage: main.py [--short] [FOLDER]      --short: a coarse lattice and no pictures, as a test; FOLDER: out/wing_cracks
"""

from __future__ import annotations

import argparse
import csv
import math
import pathlib

import bempd
import numpy as np

SIDE, THICKNESS = 150e-3, 5e-3
YOUNG, RATIO, FRACTURE_ENERGY = 3e9, 1 / 3, 300.0  # of PMMA
HALF_LENGTH = 12e-3  # of the crack, which lies along the rows of the lattice; the plate is turned
ANGLE = math.radians(45)  # of the pressure, to the crack
CORE = 32e-3, 26e-3  # half width and half height of the lattice
PRESSURE = 1e6  # at load factor one
DISTANCES = (1, 3), (3, 6), (6, 9), (9, 14)  # from the tip, in spacings


def build(spacing: float, contact: str) -> tuple[bempd.Model, int]:
    model = bempd.Model(options={"crack.rule": "bond", "contact": contact, "pd.criterion": "opening"})
    pmma = model.add_material(young_modulus=YOUNG, poisson_ratio=RATIO, thickness=THICKNESS, fracture_energy=FRACTURE_ENERGY)
    corners = SIDE / math.sqrt(2) * np.array([(math.cos(a), math.sin(a)) for a in ANGLE + np.pi / 4 * np.array([-3, -1, 1, 3])])
    plate = model.add_bem_region(pmma, corners, 15e-3)
    half_width, half_height = (round(size / spacing) * spacing for size in CORE)
    core_corners = bempd.rectangle(-half_width, -half_height, half_width, half_height)
    model.add_hole(plate, core_corners[::-1])
    core = model.add_pd_region(pmma, core_corners, spacing, 4)
    tip = (round(HALF_LENGTH / spacing) + 0.5) * spacing  # half way between two columns of points
    model.add_crack([(-tip, spacing / 2), (tip, spacing / 2)])
    model.add_pressure(plate, 2, PRESSURE)  # along the direction ANGLE
    model.add_pressure(plate, 4, PRESSURE)
    model.fix_point(corners[0], "both")
    model.fix_point(corners[2], "x")
    return model, core


def stress_of_closed_crack(x: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """xx, yy and xy over the pressure: a uniform pressure whose shear on the faces, which slide without friction, is gone
    (Westergaard 1939)."""
    shear = -math.sin(ANGLE) * math.cos(ANGLE)
    z = x + 1j * y
    root = np.sqrt(z - HALF_LENGTH) * np.sqrt(z + HALF_LENGTH)
    own, slope = shear * z / root, -shear * HALF_LENGTH**2 / root**3
    xx = y * slope.real + 2 * own.imag - math.cos(ANGLE)**2
    yy = -y * slope.real - math.sin(ANGLE)**2
    return xx, yy, own.real - y * slope.imag


def largest_hoop_strain(distance: float) -> float:
    """Its angle to the crack [degrees] so far from the tip in that field."""
    angle = np.radians(np.arange(-179, 179, 0.1))
    c, s = np.cos(angle), np.sin(angle)
    xx, yy, xy = stress_of_closed_crack(HALF_LENGTH + distance * c, distance * s)
    hoop, radial = xx * s * s + yy * c * c - 2 * xy * s * c, xx * c * c + yy * s * s + 2 * xy * s * c
    return abs(math.degrees(angle[np.argmax(hoop - RATIO * radial)]))


def wings(model: bempd.Model, core: int, spacing: float) -> np.ndarray:
    """Middles of neighbours that have parted, from the nearer tip, the left one turned to the right."""
    points, bonds = model.field(core, "position"), model.bonds(core)
    ends = points[bonds.points[bonds.states == bempd.BondState.BROKEN]]
    middle = ends[np.linalg.norm(ends[:, 0] - ends[:, 1], axis=1) < 1.1 * spacing].mean(axis=1) - [0, spacing / 2]
    return np.sign(middle[:, :1]) * middle - [HALF_LENGTH + spacing / 2, 0]


def direction(places: np.ndarray, near: float, far: float) -> float:
    """From the tip to the places at these distances [degrees]."""
    distance = np.linalg.norm(places, axis=1)
    some = places[(distance > near) & (distance < far)]
    return math.degrees(math.atan2(abs(some[:, 1].mean()), some[:, 0].mean())) if len(some) else math.nan


def run(spacing: float, contact: str, length: float,
        film: pathlib.Path | None) -> tuple[bempd.Model, list[float], list[float], bempd.StepReport]:
    """Until the wings are so long."""
    model, core = build(spacing, contact)
    movie = None
    if film:
        from bempd import plot

        movie = plot.Movie(film, model, "damage", magnification=20, frames_per_second=6)
        movie.add_frame()
    first, longest, events = 0.0, 0.0, 0
    while longest < length:
        report = model.step_to_next_event(1e6)
        first = first or report.load_factor
        events += 1
        if events % 10 == 0:
            places = wings(model, core, spacing)
            longest = np.linalg.norm(places, axis=1).max() if len(places) else 0.0
            if movie and events % 40 == 0:
                movie.add_frame()
    if movie:
        movie.add_frame()
        movie.close()
    places = wings(model, core, spacing)
    angles = [direction(places, near * spacing, far * spacing) for near, far in DISTANCES]
    return model, [first * PRESSURE, report.load_factor * PRESSURE], angles, report


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--short", action="store_true")
    parser.add_argument("folder", nargs="?", default="out/wing_cracks", type=pathlib.Path)
    arguments = parser.parse_args()
    arguments.folder.mkdir(parents=True, exist_ok=True)
    spacing, length = (1.5e-3, 7e-3) if arguments.short else (0.75e-3, 12e-3)
    reference = largest_hoop_strain(4 * spacing)
    table = [["contact", "pressure at the first break [MPa]", "pressure at the end [MPa]",
              *(f"direction {near} to {far} spacings away" for near, far in DISTANCES), "exact hoop strain at the horizon",
              "closed places", "bonds broken", "balance error"]]
    models = []
    for contact in ("faces", "none"):
        film = arguments.folder / "wing_cracks.gif" if contact == "faces" and not arguments.short else None
        model, pressures, angles, report = run(spacing, contact, length, film)
        models.append(model)
        table.append([contact, *(f"{p / 1e6:.2f}" for p in pressures), *(f"{a:.1f}" for a in angles), f"{reference:.1f}",
                      str(report.closed_places), str(report.total_broken_bonds), f"{report.energy_balance_error:.0e}"])
    with (arguments.folder / "summary.csv").open("w", newline="") as file:
        csv.writer(file).writerows(table)
    for line in zip(*table):
        print(f"{line[0]:36s}" + "".join(f"{word:>10s}" for word in line[1:]))
    if not arguments.short:
        import matplotlib

        matplotlib.use("Agg")
        import matplotlib.pyplot as plt

        figure, axes = plt.subplots(1, 2, figsize=(9, 4.2), layout="constrained")
        for model, one, (contact, _, last, *_) in zip(models, axes, table[1:]):
            model.plot("damage", axes=one, magnification=20, limits=(0, 0.6))
            faces = "faces press on each other" if contact == "faces" else "faces pass through each other"
            one.set_title(f"contact = {contact}: {faces}\npressure {last} MPa, displacements x 20", fontsize=10)
            one.set_xlim(-45, 45)
            one.set_ylim(-40, 40)
        figure.savefig(arguments.folder / "wing_cracks.png", dpi=110)
        print(f"written: {arguments.folder / 'wing_cracks.png'}")


main()
