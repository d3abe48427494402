"""Standard specimens beside the formulas of their standards: cases for the table of docs/fatigue.md."""

from __future__ import annotations

import math
from typing import Any

import bempd

CASES: list[tuple[str, dict[str, Any], str]] = [
    ("M(T)", {"width": 0.1, "crack": 0.03, "stress": 1e6}, "2a/W 0.3"),
    ("SENT", {"width": 0.1, "crack": 0.04, "stress": 1e6}, "a/W 0.4"),
    ("DENT", {"width": 0.1, "crack": 0.02, "stress": 1e6}, "2a/W 0.4"),
    ("C(T)", {"width": 0.05, "crack": 0.025, "force": 1e3, "thickness": 0.0125}, "a/W 0.5"),
    ("C(T)", {"width": 0.05, "crack": 0.035, "force": 1e3, "thickness": 0.0125}, "a/W 0.7"),
    ("C(T)", {"width": 0.05, "crack": 0.015, "force": 1e3, "thickness": 0.0125}, "a/W 0.3"),
    ("C(T)", {"width": 0.05, "crack": 0.01, "force": 1e3, "thickness": 0.0125}, "a/W 0.2"),
    ("SE(B)", {"width": 0.05, "crack": 0.035, "force": 1e3, "thickness": 0.0125}, "a/W 0.7"),
    ("SE(B)", {"width": 0.05, "crack": 0.025, "force": 1e3, "thickness": 0.0125}, "a/W 0.5"),
    ("SE(B)", {"width": 0.05, "crack": 0.015, "force": 1e3, "thickness": 0.0125}, "a/W 0.3"),
    ("SE(B)", {"width": 0.05, "crack": 0.005, "force": 1e3, "thickness": 0.0125}, "a/W 0.1"),
    ("four-point bend", {"width": 0.05, "crack": 0.01, "force": 1e3, "thickness": 0.01}, "a/W 0.2"),
    ("four-point bend", {"width": 0.05, "crack": 0.02, "force": 1e3, "thickness": 0.01}, "a/W 0.4"),
    ("DCB", {"height": 0.01, "crack": 0.02, "force": 100.0, "thickness": 0.01}, "a/h 2"),
    ("DCB", {"height": 0.01, "crack": 0.05, "force": 100.0, "thickness": 0.01}, "a/h 5"),
    ("CTS", {"width": 0.09, "crack": 0.045, "force": 1e3, "thickness": 0.01, "angle": 0.0}, "a/W 0.5, 0 degrees"),
    ("CTS", {"width": 0.09, "crack": 0.045, "force": 1e3, "thickness": 0.01, "angle": math.pi / 4}, "a/W 0.5, 45 degrees"),
    ("cracked hole", {"radius": 0.01, "crack": 0.005, "width": 0.9, "stress": 1e6, "cracks": 1}, "one crack, a/R 0.5"),
    ("cracked hole", {"radius": 0.01, "crack": 0.02, "width": 1.8, "stress": 1e6, "cracks": 1}, "one crack, a/R 2"),
    ("cracked hole", {"radius": 0.01, "crack": 0.005, "width": 0.9, "stress": 1e6, "cracks": 2}, "two cracks, a/R 0.5"),
    ("cracked hole", {"radius": 0.01, "crack": 0.02, "width": 1.8, "stress": 1e6, "cracks": 2}, "two cracks, a/R 2"),
    ("lug", {"width": 0.06, "hole": 0.03, "crack": 0.0001, "force": 1e4, "thickness": 0.01}, "2a/d 0.0067"),
    ("lug", {"width": 0.06, "hole": 0.03, "crack": 0.006, "force": 1e4, "thickness": 0.01}, "2a/d 0.4"),
]


def stored_energy(specimen: bempd.specimens.Specimen) -> float:
    specimen.model.step(1.0)
    return float(specimen.model.history()[-1]["stored_energy"])


def by_energy(kind: str, sizes: dict[str, Any], share: float = 0.005) -> float:
    """Factors of a specimen over those of its energy, less 1: its crack is made longer and shorter by a share."""
    make = bempd.specimens.KINDS[kind]
    longer, shorter = (stored_energy(make(**{**sizes, "crack": sizes["crack"] * by})) for by in (1 + share, 1 - share))
    tips = make(**sizes).tips()
    per_tip = 2 if kind == "M(T)" else 1  # its length counts from tip to tip
    squares = sum(tip.stress_intensity_1**2 + tip.stress_intensity_2**2 for tip in tips) / per_tip
    new_area = 2 * share * sizes["crack"] * sizes.get("thickness", 1.0)
    released = (longer - shorter) / new_area * bempd.specimens.STEEL["young_modulus"]
    return math.sqrt(squares / released) - 1
