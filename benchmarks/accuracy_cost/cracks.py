"""Plates torn apart, and what settings change in the peak load, the energy released and the path of the crack."""

from __future__ import annotations

import math
from typing import Any, Sequence

import numpy as np

import bempd
from bempd import rectangle
from measure import Row
from scenes import POISSON, Knobs, Model, Scene
from sweeps import ONE_THREAD, Trial, over

SIDE, PULL = 50e-3, 2e-8  # pull of each end per unit of load factor, in m
TOUGHNESS = 27.5  # J/m^2, near that of the paper's critical stretch for its spacing and horizon
STRIP = 2  # region of the lattice
REFERENCE = {"crack.tie_share": 0.0}  # bonds one by one, everything else by default
OTHER_BODY = ("horizon ratio", "spacing", "scheme")  # knobs of the discretization, not of how breaks are followed


def build(model: Model, knobs: Knobs, half_strip: float, height: float, crack: Sequence[tuple[float, float]]) -> None:
    left, right = SIDE / 2 - half_strip, SIDE / 2 + half_strip
    material = model.add_material(young_modulus=30e9, poisson_ratio=POISSON, fracture_energy=TOUGHNESS)
    model.add_bem_region(material, rectangle(0, 0, left, height), 5e-3)
    model.add_pd_region(material, rectangle(left, 0, right, height), knobs["spacing"], knobs["horizon_ratio"])
    model.add_bem_region(material, rectangle(right, 0, SIDE, height), 5e-3)
    model.add_crack(crack)
    model.prescribe_edge(1, 4, "x", -PULL)
    model.prescribe_edge(3, 2, "x", PULL)
    model.fix_point((0, height / 2), "y")


def build_centre_crack(model: Model, knobs: Knobs) -> None:
    """The paper's first crack example; the crack runs midway between two columns of points."""
    build(model, knobs, 4.25e-3, 49.5e-3, [(25e-3, 19.75e-3), (25e-3, 29.75e-3)])


def build_slanted_crack(model: Model, knobs: Knobs) -> None:
    """The paper's second one; a strip of an odd number of spacings keeps the line of the crack off the points."""
    dx = knobs["spacing"]
    half = 5e-3 * math.sqrt(0.5)
    build(model, knobs, (math.floor(10e-3 / dx) + 0.5) * dx, SIDE, [(25e-3 - half,) * 2, (25e-3 + half,) * 2])


def tear(model: Model) -> None:
    model.step(1.0)  # below the first break: the elastic response is the first row of the history
    model.run_to_separation(1e4)


def path(model: Model) -> list[tuple[float, float]]:
    """Mean place of the broken bonds in each millimetre of height, (y, x) in m."""
    bonds, points = model.bonds(STRIP), model.field(STRIP, "position")
    middles = points[bonds.points[bonds.states == bempd.BondState.BROKEN]].mean(axis=1)
    cells = np.floor(middles[:, 1] / 1e-3)
    return [((cell + 0.5) * 1e-3, float(middles[cells == cell, 0].mean())) for cell in np.unique(cells)]


def outcome(model: Model) -> Row:
    history = model.history()
    load, energy = history["load_factor"], history["stored_energy"]
    # The energy grows with the square of the load factor between two events; the work of the ends is twice the energy.
    peak = float((2 * energy[:-1] * load[1:] / load[:-1] ** 2).max()) / (2 * PULL)
    return {"peak_load": peak, "released_energy": float(history["released_energy"][-1]),
            "broken": int(history["total_broken_bonds"][-1]), "path": path(model)}


def error(model: Model, knobs: Knobs) -> float:
    return 0.0  # a torn plate has no closed form; relate() compares the runs


CRACKS = {
    scene.name: scene
    for scene in (Scene("centre_crack", "bonds one by one", {"spacing": 0.5e-3, "horizon_ratio": 4}, build_centre_crack,
                        tear, error, outcome),
                  Scene("slanted_crack", "bonds one by one", {"spacing": 0.5e-3, "horizon_ratio": 4}, build_slanted_crack,
                        tear, error, outcome))
}


def crack_trials() -> list[Trial]:
    trials: list[Trial] = []
    increments = {**ONE_THREAD, "paper.mode": "paper"}
    for scene in CRACKS:
        trials += over(scene, "tie band", "crack.tie_share", (0.0, 1e-3, 1e-2, 5e-2, 0.1), slow=True)
        trials += over(scene, "increments", "paper.increment", (1.0, 10.0), increments, slow=True)
        trials += over(scene, "horizon ratio", "horizon_ratio", (3, 4, 5), slow=True)
    trials += over("slanted_crack", "spacing", "spacing", (1e-3, 0.5e-3, 0.25e-3), slow=True)
    trials += over("centre_crack", "scheme", "scheme", ("symmetric", "paper"), {**ONE_THREAD, "paper.lattice": "nodal"},
                   slow=True)
    return trials


def relate(rows: Sequence[Row]) -> None:
    """Changes of a torn plate against bonds that break one by one."""
    good = [row for row in rows if "refused" not in row]
    for scene in CRACKS:
        own = [row for row in good if row["scene"] == scene]
        reference = next(row for row in own if row["settings"] == ONE_THREAD | REFERENCE)
        y, x = np.array(reference["path"]).T
        for row in own:
            own_y, own_x = np.array(row["path"]).T
            row["path_off"] = float(np.abs(np.interp(y, own_y, own_x) - x).max())
            row["peak_change"] = row["peak_load"] / reference["peak_load"] - 1
            row["energy_change"] = row["released_energy"] / reference["released_energy"] - 1
            row["error"] = 0.0 if row["knob"] in OTHER_BODY else abs(row["energy_change"])


def crack_columns() -> list[tuple[str, Any]]:
    return [("scene", lambda r: r["scene"]), ("setting", lambda r: r["shown"]), ("bonds", lambda r: r["broken"]),
            ("peak load [kN]", lambda r: f"{1e-3 * r['peak_load']:.5g}"),
            ("change", lambda r: f"{100 * r['peak_change']:+.2g} %"),
            ("energy released [J]", lambda r: f"{r['released_energy']:.4g}"),
            ("change", lambda r: f"{100 * r['energy_change']:+.2g} %"),
            ("path off by [mm]", lambda r: f"{1e3 * r['path_off']:.2g}"),
            ("time [s]", lambda r: f"{r['seconds']:.3g}"), ("memory [MB]", lambda r: f"{r['megabytes']:.0f}")]
