"""The strip of README's first program, torn by a crack that ends at the other side, against boundary elements that grow it."""

from __future__ import annotations

import functools
from typing import Any

import bempd
import numpy as np

LENGTH, HEIGHT, DEPTH, YOUNG, TOUGHNESS = 0.06, 0.02, 0.0045, 3e9, 300.0
# Boundary elements come this near to the other side; the last ligaments of lattices are asked from three horizons on.
NEAREST, ASKED = 2e-4, 3
TIPS_SPACING, TIP_PARTS = 5e-4, (0, 0.1, 0.25, 0.4, 0.5, 0.6, 0.75, 0.9)


def strip(rule: str, spacing: float = 0.001, m: int = 4, control: str = "load", beyond: float = 0) -> bempd.Model:
    """`rule`: "bem" or a crack rule; `beyond`: so many spacings deeper."""
    model = bempd.Model() if rule == "bem" else bempd.Model(options={"crack.rule": rule, "stepping.control": control})
    material = model.add_material(young_modulus=YOUNG, poisson_ratio=1 / 3, thickness=0.005, fracture_energy=TOUGHNESS)
    if rule == "bem":
        left = right = model.add_bem_region(material, bempd.rectangle(0, 0, LENGTH, HEIGHT), 0.002)
    else:
        left = model.add_bem_region(material, bempd.rectangle(0, 0, 0.02, HEIGHT), 0.005)
        model.add_pd_region(material, bempd.rectangle(0.02, 0, 0.04, HEIGHT), spacing, m)
        right = model.add_bem_region(material, bempd.rectangle(0.04, 0, LENGTH, HEIGHT), 0.005)
    x = LENGTH / 2 - spacing / 2
    model.add_crack([(x, 0), (x, DEPTH + beyond * spacing)])
    model.fix_edge(left, 4)
    model.prescribe_edge(right, 2, "x", 1e-6)
    return model


@functools.lru_cache(None)
def reference() -> tuple[np.ndarray, np.ndarray]:
    """Depths of the crack and load factors at which it grows on."""
    model = strip("bem")
    model.step(1)
    depths, loads = [], []
    while True:
        tip = model.tips()[0]
        depths.append(tip.y)
        loads.append(tip.critical_load_factor)
        left = HEIGHT - tip.y
        if left <= NEAREST * 1.5:
            return np.array(depths), np.array(loads)
        model.grow_cracks(0.0005 if left > 0.0015 else NEAREST)


def compared(spacing: float, m: int) -> dict[str, Any]:
    depths, loads = reference()
    model, ratios, tip = strip("tips", spacing, m, "path"), [], DEPTH
    while model.step_to_next_event(1e6).stop_reason == bempd.StopReason.EVENT:
        ligament = HEIGHT - tip
        if ligament <= ASKED * m * spacing:
            ratios.append(model.load_factor / np.interp(tip, depths, loads))
        tip += spacing
    torn = {rule: strip(rule, spacing, m).run_to_separation(1e6) for rule in ("line", "bond")}
    return {"last": ratios, "events": {rule: int(report.total_events) for rule, report in torn.items()},
            "torn": {rule: report.load_factor for rule, report in torn.items()}, "known": float(loads.max())}


def tip_at(m: int, part: float) -> dict[str, float]:
    """Load factors at which the crack first grows, its tip at a part of the way between two rows, over boundary elements'."""
    elements = strip("bem", TIPS_SPACING, beyond=part)
    elements.step(1)
    known = elements.tips()[0].critical_load_factor
    return {rule: strip(rule, TIPS_SPACING, m, beyond=part).step_to_next_event(1e6).load_factor / known for rule in ("line", "bond")}


def tip_rows(found: dict[tuple, dict[str, float]]) -> list[str]:
    table = ["| m | `crack.rule` | first load over boundary elements', tip at " + ", ".join(f"{part:g}" for part in TIP_PARTS) +
             " of the way between rows |", "|---|---|---|"]
    for m in (3, 4):
        some = {job[2]: result for job, result in found.items() if job[:2] == ("tip", m)}
        for kind in next(iter(some.values()), {}):
            table.append(f"| {m} | {kind} | " + ", ".join(f"{some[part][kind]:.2f}" for part in TIP_PARTS if part in some) + " |")
    return table


def rows(found: dict[tuple, dict[str, Any]]) -> list[str]:
    table = ["| spacing [mm] | m | loads from a ligament of 3 horizons on, over boundary elements' | in two at: boundary elements | line | bond |", "|---|---|---|---|---|---|"]
    for job, r in found.items():
        if job[0] == "ligament":
            table.append(f"| {job[1] * 1e3:g} | {job[2]} | {min(r['last']):.2f} .. {max(r['last']):.2f} | {r['known']:.1f} | {r['torn']['line']:.1f} |"
                         f" {r['torn']['bond']:.1f} |")
    return table
