"""What peridynamic regions with slanted and round edges are good for, as tables.

usage: benchmarks/run.sh outlines [--only TABLE,...] [--write]      --write: into docs/research/tables
"""

from __future__ import annotations

import math
import os
import pathlib
import subprocess
import sys
import time

import bempd
import numpy as np
from stored_tables import store

NU = 1 / 3


def turned(points, angle: float) -> np.ndarray:
    c, s = math.cos(angle), math.sin(angle)
    return np.asarray(points, float) @ np.array([[c, s], [-s, c]])


def kirsch_stress(x: float, y: float) -> tuple[float, float, float]:
    """Plate with a hole of radius 1 under unit tension along x (Timoshenko and Goodier, art. 35)."""
    r2, t = x * x + y * y, math.atan2(y, x)
    c2, c4, s2, s4 = math.cos(2 * t), math.cos(4 * t), math.sin(2 * t), math.sin(4 * t)
    return (1 - (1.5 * c2 + c4) / r2 + 1.5 * c4 / r2**2, -(0.5 * c2 - c4) / r2 - 1.5 * c4 / r2**2,
            -(0.5 * s2 + s4) / r2 + 1.5 * s4 / r2**2)


def kirsch_displacement(x, y, nu: float = NU, plane: str = "stress"):
    kappa = (3 - nu) / (1 + nu) if plane == "stress" else 3 - 4 * nu
    r, t, shear = np.hypot(x, y), np.arctan2(y, x), 1 / (2 + 2 * nu)
    return np.array([r * (kappa + 1) * np.cos(t) + 2 / r * ((1 + kappa) * np.cos(t) + np.cos(3 * t))
                     - 2 / r**3 * np.cos(3 * t),
                     r * (kappa - 3) * np.sin(t) + 2 / r * ((1 - kappa) * np.sin(t) + np.sin(3 * t))
                     - 2 / r**3 * np.sin(3 * t)]).T / (8 * shear)


def plate_with_hole(spacings: int, horizon_ratio: int, angle: float, nu: float = NU,
                    plane: str = "stress") -> tuple[float, float]:
    """Relative error of the displacement and the largest stress at the hole."""
    model = bempd.Model()
    material = model.add_material(young_modulus=1, poisson_ratio=nu, plane=plane)
    corners = turned(bempd.rectangle(-3, -3, 3, 3), angle)
    plate = model.add_pd_region(material, corners, 1 / spacings, horizon_ratio)
    model.add_circular_hole(plate, (0, 0), 1)
    for k in range(4):
        nx, ny = math.cos(angle + (k - 1) * math.pi / 2), math.sin(angle + (k - 1) * math.pi / 2)

        def traction(x, y, nx=nx, ny=ny):
            xx, yy, xy = kirsch_stress(x, y)
            return xx * nx + xy * ny, xy * nx + yy * ny

        model.add_traction_function(plate, k + 1, traction)
    for corner, components in ((corners[0], "xy"), (corners[1], "y")):
        for component in components:
            model.prescribe_point(corner, component, kirsch_displacement(*corner, nu, plane)["xy".index(component)])
    model.step(1)
    x, u, s = (model.field(plate, name) for name in ("position", "displacement", "stress"))
    exact = kirsch_displacement(x[:, 0], x[:, 1], nu, plane)
    on = abs(np.hypot(*x.T) - 1) < 1e-9
    c, n = x[on, 0], x[on, 1]
    hoop = s[on, 0] * n**2 + s[on, 1] * c**2 - 2 * s[on, 2] * c * n
    return float(np.linalg.norm(u - exact) / np.linalg.norm(exact)), float(hoop.max())


def kirsch_table() -> str:
    lines = ["| horizon ratio, edges turned by | " + " | ".join(f"radius {n} spacings" for n in (4, 8, 16, 32))
             + " | order |", "|---|---|---|---|---|---|"]
    for horizon_ratio, angle in ((3, 0), (4, 0), (4, 17), (4, 45), (5, 0)):
        found = [plate_with_hole(n, horizon_ratio, math.radians(angle)) for n in (4, 8, 16, 32)]
        order = math.log2(found[1][0] / found[3][0]) / 2
        lines.append(f"| {horizon_ratio}, {angle} degrees | " + " | ".join(f"{e:.1e}, {s:.2f}" for e, s in found)
                     + f" | {order:.1f} |")
    return "\n".join(lines)


def ratios_table() -> str:
    lines = ["| material | radius 4 spacings | radius 8 spacings | radius 16 spacings | order |", "|---|---|---|---|---|"]
    for plane, nu in (("stress", -0.2), ("stress", 0.0), ("stress", 0.2), ("stress", NU), ("stress", 0.45),
                      ("stress", 0.49), ("strain", 0.25), ("strain", 0.4), ("strain", 0.45), ("strain", 0.49)):
        found = [plate_with_hole(n, 4, math.radians(17), nu, plane) for n in (4, 8, 16)]
        order = math.log2(found[0][0] / found[2][0]) / 2
        lines.append(f"| plane {plane}, {nu:.4g} | " + " | ".join(f"{e:.1e}, {s:.2f}" for e, s in found)
                     + f" | {order:.1f} |")
    return "\n".join(lines)


def first_break(radius: float, horizon_ratio: int | None, angle: float, place: float) -> float:
    """Load factor of the first break at a hole in a square plate, side 10 radii; of boundary elements by their stress."""
    model = bempd.Model(options={"threads": 1, "crack.rule": "bond"})
    half, strength = 5 * radius, 1e-3
    outline, centre = bempd.rectangle(-half, -half, half, half), (place, 0.7 * place)
    if horizon_ratio is None:
        plate = model.add_bem_region(model.add_material(young_modulus=1, poisson_ratio=NU), outline, half / 12)
    else:
        material = model.add_material(young_modulus=1, poisson_ratio=NU, critical_stretch=strength)
        plate = model.add_pd_region(material, outline, 1, horizon_ratio, lattice_angle=angle)
    model.add_circular_hole(plate, centre, radius)
    model.add_traction(plate, 1, "y", -1)
    model.add_traction(plate, 3, "y", 1)
    model.fix_point((-half, -half))
    model.fix_point((half, -half), "y")
    if horizon_ratio is None:
        model.step(1)
        return strength / max(model.evaluate([(centre[0] + side * radius, centre[1])]).stress[0][1] for side in (-1, 1))
    model.step_to_next_event(1)
    return model.load_factor


def breaks_table() -> str:
    lines = ["| radius, horizon ratio | first load over boundary elements |", "|---|---|"]
    angles, places = (0, 7.5, 15, 22.5, 30, 45), (0.1, 0.3)
    for radius in (3, 5):
        references = {place: first_break(radius, None, 0, place) for place in places}
        for horizon_ratio in (3, 4, 5):
            found = [first_break(radius, horizon_ratio, math.radians(angle), place) / references[place]
                     for angle in angles for place in places]
            lines.append(f"| {radius}, {horizon_ratio} | {min(found):.2f} .. {max(found):.2f} |")
    return "\n".join(lines)


def cracked_hole(radius: float, lengths: tuple[float, float], lattice_angle: float | None) -> list[bempd.CrackTip]:
    """Tips of two cracks at a hole in a square plate, side 8 radii, pulled across them (Bowie, Journal of Mathematics and
    Physics 35, 1956, has the wide plate): in a lattice, or in boundary elements."""
    model = bempd.Model(options={"threads": 1})
    material = model.add_material(young_modulus=1, poisson_ratio=NU)
    half = 4 * radius
    outline = bempd.rectangle(-half, -half, half, half)
    if lattice_angle is None:
        plate = model.add_bem_region(material, outline, half / 6)
    else:
        plate = model.add_pd_region(material, outline, 1, 4, lattice_angle=lattice_angle)
    model.add_circular_hole(plate, (0, 0), radius)
    for side, length in zip((1, -1), lengths):
        model.add_crack([(side * radius, 0), (side * (radius + length), 0)])
    model.fix_point((-half, -half))
    model.fix_point((half, -half), "y")
    model.add_traction(plate, 3, "y", 1)
    model.add_traction(plate, 1, "y", -1)
    model.step(1)
    return model.tips()


def tips_table() -> str:
    """K_I by rings over that of boundary elements whose cracks are as long as those in the lattice are felt to be."""
    angles = (0, 15, 30, 45)
    lines = ["| crack over radius | " + " | ".join(f"{angle} degrees" for angle in angles) + " |", "|---" * 5 + "|"]
    radius = 12
    for length in (9.5, 12.5, 18.5, 24.5):
        cells = []
        for angle in angles:
            tips = cracked_hole(radius, (length, length), math.radians(angle))
            felt = cracked_hole(radius, (length + tips[0].felt_ahead, length + tips[1].felt_ahead), None)
            ratios = [tip.stress_intensity_1 / other.stress_intensity_1 for tip, other in zip(tips, felt)]
            ahead = [f"{tip.felt_ahead:.2f}" for tip in tips]
            cells.append(", ".join(f"{ratio:.3f}" for ratio in ratios) + f" ({', '.join(ahead)})")
        lines.append(f"| {length / radius:.2f} | " + " | ".join(cells) + " |")
    return "\n".join(lines)


def crossing(lean: float | None, rule: str) -> float:
    """Largest load factor until a crack from the left edge has run halfway through a plate that is two regions with a
    common edge upright or leaning in its middle, or one region."""
    width, height, start, energy = 40, 30, 8.5, 1e-4
    model = bempd.Model(options={"test.outline_points": "always", "crack.rule": rule, "threads": 1})
    material = model.add_material(young_modulus=1, poisson_ratio=NU, fracture_energy=energy)
    parts = [bempd.rectangle(0, 0, width, height)]
    if lean is not None:
        low, high = width / 2 - lean * height / 2, width / 2 + lean * height / 2
        parts = [[(0, 0), (low, 0), (high, height), (0, height)],
                 [(low, 0), (width, 0), (width, height), (high, height)]]
    for part in parts:
        region = model.add_pd_region(material, part, 1, 4)
        model.prescribe_edge(region, 1, "y", [-0.01])
        model.prescribe_edge(region, 3, "y", [0.01])
    model.fix_point((width, 0), "x")
    model.add_crack([(0, height / 2 - 0.5), (start, height / 2 - 0.5)])
    model.run_to_separation(100)
    history = model.history()
    # Bonds take 0.9 to 1.3 times the fracture energy for a length.
    running = history["bond_energy"] < 0.6 * (width - start) * energy
    return float(history["load_factor"][running].max())


def crossings_table() -> str:
    lines = ["| cracks grow | one region | common edge upright | leaning by 10 degrees | by 20 degrees |",
             "|---|---|---|---|---|"]
    leans = [None, *(math.tan(math.radians(degrees)) for degrees in (0, 10, 20))]
    for rule in ("bond", "line"):
        whole, *others = (crossing(lean, rule) for lean in leans)
        lines.append(f"| by {rule} | {whole:.3f} | "
                     + " | ".join(f"{one:.3f} ({one / whole - 1:+.0%})" for one in others) + " |")
    return "\n".join(lines)


ROUNDS = 7
PLATES = {"lattice rows": ("slanted", 0, False), "points on its outline": ("always", 0, False),
          "turned by 17 degrees": ("slanted", 17, False), "with a round hole": ("slanted", 0, True),
          "turned, with the hole": ("slanted", 17, True)}


def costs(side: int, points: str, degrees: float, hole: bool) -> tuple[int, float, float]:
    """Points, and processor seconds of preparing and of the elastic solve."""
    angle = math.radians(degrees)
    model = bempd.Model(options={"test.outline_points": points, "threads": 1})
    material = model.add_material(young_modulus=1, poisson_ratio=NU)
    plate = model.add_pd_region(material, turned(bempd.rectangle(0, 0, side, side), angle), 1, 4)
    if hole:
        model.add_circular_hole(plate, turned([(side / 2, side / 2)], angle)[0], side / 8)
    model.fix_edge(plate, 1)
    model.prescribe_edge(plate, 3, "y", [1e-3])
    start = time.process_time()
    model.prepare()
    prepared = time.process_time()
    model.step(1)
    return model.node_count(plate), prepared - start, time.process_time() - prepared


def cost_table() -> str:
    """The least of runs in turns: what else the machine does then meets all of them."""
    lines = ["| square plate, m = 4 | points | preparing [s] | over lattice rows | elastic solve [s] | over lattice rows |",
             "|---|---|---|---|---|---|"]
    for side in (50, 100, 200):
        found = [{name: costs(side, *plate) for name, plate in PLATES.items()} for _ in range(ROUNDS)]
        least = {name: (found[0][name][0], *(min(one[name][k] for one in found) for k in (1, 2))) for name in PLATES}
        _, rows_prepare, rows_solve = least["lattice rows"]
        for name, (count, prepare, solve) in least.items():
            lines.append(f"| {side} x {side}, {name} | {count} | {prepare:.3f} | {prepare / rows_prepare:.2f} | {solve:.3f} "
                         f"| {solve / rows_solve:.2f} |")
    return "\n".join(lines)


def main() -> None:
    program = pathlib.Path(os.environ["BEMPD_BENCHMARKS"]) / "bempd_outlines"

    def printed(*arguments: str) -> str:
        return subprocess.run([program, *arguments], check=True, stdout=subprocess.PIPE, text=True).stdout.strip()

    makers = {"networks": printed, "mouths": lambda: printed("mouths"), "rows": lambda: printed("rows"),
              "kirsch": kirsch_table, "breaks": breaks_table, "ratios": ratios_table, "tips": tips_table, "crossings": crossings_table,
              "cost": cost_table}
    chosen = sys.argv[2].split(",") if sys.argv[1:2] == ["--only"] else list(makers)
    tables = {name: makers[name]() for name in chosen}
    for name, table in tables.items():
        print(f"{name}\n{table}\n")
    if "--write" in sys.argv:
        for name, table in tables.items():
            store(f"outlines_{name}", table)


main()
