"""Where torn plates end: by the last bond, and by what they bear. Writes docs/research/tables.

    benchmarks/run.sh separation
"""

from __future__ import annotations

from typing import Callable

import numpy as np
from bempd import Model, rectangle
from stored_tables import store

LAST_BOND, SHARE = 0.0, 0.02  # of the option stepping.separation_share
BONDS = {"crack.rule": "bond"}


def strip(crack: float) -> Model:
    """README's first program with a crack of another length [mm]."""
    model = Model(options=BONDS)
    acrylic = model.add_material(young_modulus=3e9, poisson_ratio=1 / 3, thickness=0.005, fracture_energy=300)
    model.add_bem_region(acrylic, rectangle(0, 0, 0.02, 0.02), 0.005)
    model.add_pd_region(acrylic, rectangle(0.02, 0, 0.04, 0.02), 0.001, 4)
    model.add_bem_region(acrylic, rectangle(0.04, 0, 0.06, 0.02), 0.005)
    model.add_crack([(0.0295, 0), (0.0295, crack * 1e-3)])
    model.fix_edge(1, 4)
    model.prescribe_edge(3, 2, "x", 1e-6)
    return model


def plate(half_crack: float = 5, slant: float = 0, horizon_ratio: int = 4) -> Model:
    """The paper's centre-cracked plate [mm]; `slant`: how far the tips lie beside the middle."""
    width, height, half_strip = 50, 49.5, 4.25
    model = Model(options=BONDS)
    stone = model.add_material(young_modulus=30e9, poisson_ratio=1 / 3, critical_stretch=8e-4)
    ends = [0, width / 2 - half_strip, width / 2 + half_strip, width]
    left, middle, right = (rectangle(a * 1e-3, 0, b * 1e-3, height * 1e-3) for a, b in zip(ends, ends[1:]))
    model.add_bem_region(stone, left, 0.005)
    model.add_pd_region(stone, middle, 0.0005, horizon_ratio)
    model.add_bem_region(stone, right, 0.005)
    tip = np.array([slant, half_crack])
    model.add_crack([(np.array([width, height]) / 2 + side * tip) * 1e-3 for side in (-1, 1)])
    model.prescribe_edge(1, 4, "x", -2e-8)
    model.prescribe_edge(3, 2, "x", 2e-8)
    model.fix_point((0, height / 2 * 1e-3), "y")
    return model


def ends(build: Callable[[], Model], bonds: str) -> list[str]:
    """Load factor, energy and what is left, by the last bond and by the share."""
    cells = []
    for share in (LAST_BOND, SHARE):
        model = build()
        model.options["stepping.separation_share"] = share
        if bonds == "one by one":
            model.options["crack.tie_share"] = 0
        report = model.run_to_separation(3e6)
        cells += [f"{report.load_factor:.1f}", f"{report.released_energy:.4g}"]
    left = report.resistance / report.peak_resistance
    return [*cells, f"{100 * left:.2g} %" if left > 1e-6 else "nothing"]


def table(name: str, rows: list[tuple[str, Callable[[], Model]]]) -> list[str]:
    lines = [f"| {name} | bonds | last bond: load factor | energy [J] | by the share: load factor | energy [J] | left |",
             "|---|---|---|---|---|---|---|"]
    for label, build in rows:
        for bonds in ("within 0.1 %", "one by one"):
            lines.append("| " + " | ".join([label, bonds, *ends(build, bonds)]) + " |")
            print(lines[-1], flush=True)
    return lines


def main() -> None:
    strips = [(f"{length:g} mm", lambda length=length: strip(length)) for length in
              (4.5, 5.5, *np.arange(6.5, 8.51, 0.25))]
    plates = [(f"half a crack of {half:g} mm", lambda half=half: plate(half)) for half in (3, 4, 5, 5.25, 6, 8, 10, 12.25)]
    plates += [(f"tips {slant:g} mm aside", lambda slant=slant: plate(slant=slant)) for slant in (0.6, 1.1, 2.1)]
    plates += [(f"horizon of {ratio} spacings", lambda ratio=ratio: plate(horizon_ratio=ratio)) for ratio in (3, 5)]
    for mark, rows in (("strips", table("crack of the strip", strips)), ("plates", table("plate", plates))):
        store(f"separation_{mark}", rows)


main()
