"""Loads of the first growth of a tip near another crack or an edge: by elements and by lattice patches, against much shorter elements."""

from __future__ import annotations

import time
from typing import Any

import bempd

DISTANCES = (1, 0.3, 0.1, 0.03)  # over the length of a crack
SIDE = 6.0


def scene(beside: str, distance: float, treatment: str, spacing: float = 0, **options: Any) -> bempd.Model:
    """A square plate under tension with a crack of length 1, whose tip on the right is the only one that may grow."""
    model = bempd.Model(options=options)
    material = model.add_material(young_modulus=1000, poisson_ratio=1 / 3, fracture_energy=1e-3)
    body = model.add_body(material, bempd.rectangle(0, 0, SIDE, SIDE))
    tip = SIDE - distance if beside == "edge" else SIDE / 2 - distance / 2
    model.add_crack([(tip - 1, SIDE / 2), (tip, SIDE / 2)])
    if beside == "crack":
        model.add_crack([(tip + distance, SIDE / 2), (tip + distance + 1, SIDE / 2)])
        for end in (bempd.TipEnd.START, bempd.TipEnd.END):
            model.set_tip_frozen(2, end)
    model.set_tip_frozen(1, bempd.TipEnd.START)
    if treatment == "lattice":
        model.set_body_lattice(body, spacing, 4)
        model.set_crack_treatment(1, "lattice")
        if beside == "crack":
            model.set_crack_treatment(2, "lattice")
    model.fix_edge(body, 1, "y")
    model.fix_point((0, 0), "x")
    model.add_traction(body, 3, "y", proportional=1)
    return model


def first_load(model: bempd.Model) -> tuple[float, float, Any]:
    """Load factor of the first growth, processor time of preparing, and the plan."""
    begin = time.process_time()
    model.prepare()
    plan = model.plan()
    return plan.growth_load_factor, time.process_time() - begin, plan


def table(quick: bool) -> list[str]:
    lines = ["| tip beside | distance over length | elements | error told | true | s | spacings of the crack | points | error of the patch | s |",
             "|---|---|---|---|---|---|---|---|---|---|"]
    for beside in ("crack", "edge"):
        for distance in DISTANCES[:2] if quick else DISTANCES:
            exact, _, finest = first_load(scene(beside, distance, "elements", **{"test.halvings": 3}))
            load, seconds, plan = first_load(scene(beside, distance, "elements"))
            if finest.boundary_elements < 3 * plan.boundary_elements:
                raise SystemExit("the reference is no finer than the mesh; halve it once more")
            row = (f"| {beside} | {distance:g} | {plan.boundary_elements} | {plan.growth_load_error:.1e} | {abs(load / exact - 1):.1e} "
                   f"| {seconds:.2f} |")
            try:
                model = scene(beside, distance, "lattice")
                load, seconds, plan = first_load(model)
                patch = model.parts()[1]
                row += (f" {1 / patch.spacing:.0f} | {patch.material_points:,} | {load / exact - 1:+.1e} | {seconds:.1f} |")
            except bempd.Error as error:
                row += f" refused: {type(error).__name__} | | | |"
            lines.append(row)
    return lines
