"""Standard specimens beside the formulas of their standards: cases for the table of docs/fatigue.md."""

from __future__ import annotations

import math
from typing import Any

CASES: list[tuple[str, dict[str, Any], str]] = [
    ("M(T)", {"width": 0.1, "crack": 0.03, "stress": 1e6}, "2a/W 0.3"),
    ("SENT", {"width": 0.1, "crack": 0.04, "stress": 1e6}, "a/W 0.4"),
    ("DENT", {"width": 0.1, "crack": 0.02, "stress": 1e6}, "2a/W 0.4"),
    ("C(T)", {"width": 0.05, "crack": 0.025, "force": 1e3, "thickness": 0.0125}, "a/W 0.5"),
    ("C(T)", {"width": 0.05, "crack": 0.035, "force": 1e3, "thickness": 0.0125}, "a/W 0.7"),
    ("C(T)", {"width": 0.05, "crack": 0.015, "force": 1e3, "thickness": 0.0125}, "a/W 0.3"),
    ("SE(B)", {"width": 0.05, "crack": 0.035, "force": 1e3, "thickness": 0.0125}, "a/W 0.7"),
    ("SE(B)", {"width": 0.05, "crack": 0.025, "force": 1e3, "thickness": 0.0125}, "a/W 0.5"),
    ("SE(B)", {"width": 0.05, "crack": 0.015, "force": 1e3, "thickness": 0.0125}, "a/W 0.3"),
    ("four-point bend", {"width": 0.05, "crack": 0.01, "force": 1e3, "thickness": 0.01}, "a/W 0.2"),
    ("four-point bend", {"width": 0.05, "crack": 0.02, "force": 1e3, "thickness": 0.01}, "a/W 0.4"),
    ("DCB", {"height": 0.01, "crack": 0.02, "force": 100.0, "thickness": 0.01}, "a/h 2"),
    ("DCB", {"height": 0.01, "crack": 0.05, "force": 100.0, "thickness": 0.01}, "a/h 5"),
    ("CTS", {"width": 0.09, "crack": 0.045, "force": 1e3, "thickness": 0.01, "angle": 0.0}, "a/W 0.5, 0 degrees"),
    ("CTS", {"width": 0.09, "crack": 0.045, "force": 1e3, "thickness": 0.01, "angle": math.pi / 4}, "a/W 0.5, 45 degrees"),
    ("cracked hole", {"radius": 0.01, "crack": 0.005, "stress": 1e6, "cracks": 1}, "one crack, a/R 0.5"),
    ("cracked hole", {"radius": 0.01, "crack": 0.02, "stress": 1e6, "cracks": 1}, "one crack, a/R 2"),
    ("cracked hole", {"radius": 0.01, "crack": 0.005, "stress": 1e6, "cracks": 2}, "two cracks, a/R 0.5"),
    ("cracked hole", {"radius": 0.01, "crack": 0.02, "stress": 1e6, "cracks": 2}, "two cracks, a/R 2"),
]
