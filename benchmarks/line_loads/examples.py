"""Numbers of the examples whose cracks grow as lines in lattices: by fits, by energy, and in boundary elements."""

from __future__ import annotations

import functools
import importlib.util
import math
import pathlib
import sys
import types
from typing import Callable

import bempd
import numpy as np

import scenes

FOLDER = pathlib.Path(__file__).resolve().parents[2] / "examples"
LOADS = ("fit", "energy")
Numbers = dict[str, float]


@functools.lru_cache(maxsize=None)
def program(name: str) -> types.ModuleType:
    spec = importlib.util.spec_from_file_location(f"example_{name}", FOLDER / name / "main.py")
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module  # where its data classes look for it
    spec.loader.exec_module(module)
    return module


def strip(load: str | None) -> Numbers:
    """examples/first_crack; in boundary elements without a load rule."""
    model = bempd.Model(options={"crack.load": load} if load else {})
    pmma = model.add_material(young_modulus=3e9, poisson_ratio=1 / 3, thickness=0.005, fracture_energy=300)
    if load:
        left = model.add_bem_region(pmma, bempd.rectangle(0, 0, 0.02, 0.02), element_length=0.005)
        model.add_pd_region(pmma, bempd.rectangle(0.02, 0, 0.04, 0.02), spacing=0.001)
        right = model.add_bem_region(pmma, bempd.rectangle(0.04, 0, 0.06, 0.02), element_length=0.005)
    else:
        left = right = model.add_bem_region(pmma, bempd.rectangle(0, 0, 0.06, 0.02), element_length=0.005)
    model.add_crack([(0.0295, 0), (0.0295, 0.0045)])
    model.fix_edge(left, 4)
    model.prescribe_edge(right, 2, "x", 1e-6)
    model.step(scenes.BELOW_GROWTH)
    first = model.tips()[0].critical_load_factor
    return {"first load [um]": first, "in two at [um]": model.run_to_separation(1e4).load_factor}


TIPS = (4, 10, 12, 14, 16)  # [mm], at which deflections are compared


def bend(load: str | None) -> Numbers:
    example = program("three_point_bend")
    names = ["largest force [N]", *(f"deflection with the tip at {tip} mm [um]" for tip in TIPS)]
    if not load:
        places = example.fracture_mechanics(np.array(TIPS) * 1e-3)
        peak = example.fracture_mechanics(np.array([example.NOTCH]))[0, 1]
        return dict(zip(names, [peak, *(1e6 * places[:, 0])]))
    spacing = 0.5e-3
    model, _, stamp = example.build(spacing, "line", "path")
    model.options["crack.load"] = load
    model.step(1.0)  # a micrometre, at which nothing grows
    tip = model.tips()[0]
    force = -tip.critical_load_factor * model.reaction(stamp)[1] / model.load_factor
    while model.step_to_next_event(example.END).stop_reason == bempd.StopReason.EVENT:
        pass
    deflections = {round(1e3 * (example.NOTCH + k * spacing), 3): abs(vertex.load_factor * example.PER_LOAD_FACTOR)
                   for k, vertex in enumerate(v for v in model.crack_path(1) if v.event > 0)}
    return dict(zip(names, [force, *(1e6 * deflections[tip] for tip in TIPS)]))


def hole(load: str | None, turned: bool) -> Numbers:
    example = program("round_hole")
    if load:
        model, _ = example.build(0.75e-3, 4, example.TURNED if turned else 0.0, "line")
        model.options["crack.load"] = load
    else:
        model = bempd.Model()
        glass = model.add_material(young_modulus=70e9, poisson_ratio=1 / 3, thickness=1e-3, fracture_energy=10)
        corners = [example.placed(x, y) for x, y in bempd.rectangle(0, 0, example.WIDTH, example.HEIGHT)]
        plate = model.add_bem_region(glass, corners, 3e-3)
        model.add_circular_hole(plate, example.placed(*example.CENTRE), example.RADIUS)
        model.add_crack([example.placed(0, example.NOTCH[0]), example.placed(example.NOTCH[1], example.NOTCH[0])])
        model.fix_edge(plate, 1)
        pull = example.placed(0, 1e-5)
        model.prescribe_edge(plate, 3, "x", [pull[0]])
        model.prescribe_edge(plate, 3, "y", [pull[1]])
    first, ends = 0.0, math.nan
    while math.isnan(ends):
        report = model.step_to_next_event(10)
        first = first or report.load_factor
        if not any(tip.crack == 1 for tip in model.tips()):
            ends = report.load_factor
        if report.stop_reason != bempd.StopReason.EVENT:
            break
    return {"first load": first, "enters the hole at": ends}


def torn(load: str | None, kind: str, turned: float = 0.0, shift: float = 0.0) -> Numbers:
    model = program("one_crack").body(kind if load else "elements", 0.5e-3, turned=turned, shift=shift)
    if load:
        model.options["crack.load"] = load
    model.step(1.0)
    return {"first load [um]": model.tips()[0].critical_load_factor}


EXAMPLES_BY_LINES: dict[str, Callable[[str | None], Numbers]] = {
    "first_crack": strip,
    "three_point_bend": bend,
    "one_crack, lattice": functools.partial(torn, kind="lattice"),
    "one_crack, both": functools.partial(torn, kind="both"),
    "one_crack, lattice turned by 20 degrees": functools.partial(torn, kind="lattice", turned=20.0),
    "one_crack, lattice shifted": functools.partial(torn, kind="lattice", shift=0.25e-3),
    "round_hole, rows along the axes": functools.partial(hole, turned=False),
    "round_hole, rows along the plate": functools.partial(hole, turned=True),
}


def rows(is_asked: Callable[[str], bool]) -> list[str]:
    """Of the table: numbers by fits, by energy and of boundary elements."""
    found = []
    for name, numbers in EXAMPLES_BY_LINES.items():
        if not is_asked(name):
            continue
        by_rule = [numbers(load) for load in (*LOADS, None)]
        found += [f"| {name} | {quantity} | " + " | ".join(f"{one[quantity]:.4g}" for one in by_rule) + " |" for quantity in by_rule[0]]
    return found
