"""What is tried: for every knob the scenes it matters in, one line of settings each."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

Settings = dict[str, Any]
ONE_THREAD: Settings = {"threads": 1}


@dataclass(frozen=True)
class Trial:
    scene: str
    knob: str
    key: str  # name of the knob in the settings
    settings: Settings
    slow: bool = False  # one run is enough


def over(scene: str, knob: str, key: str, values: Any, base: Settings = ONE_THREAD, slow: bool = False) -> list[Trial]:
    return [Trial(scene, knob, key, {**base, key: value}, slow) for value in values]


def all_trials() -> list[Trial]:
    trials: list[Trial] = []
    for scene, lengths in {"lame": (0.8, 0.4, 0.2, 0.1), "kirsch": (0.8, 0.4, 0.2, 0.1),
                           "cantilever": (1.0, 0.5, 0.25, 0.125)}.items():
        trials += over(scene, "element length", "element_length", lengths)
    for scene, lengths in {"plate": (0.2, 0.1, 0.05, 0.025), "shear": (0.2, 0.1, 0.05, 0.025),
                           "hole": (0.1, 0.05, 0.025), "l_shape": (0.5, 0.25, 0.125, 0.0625)}.items():
        for grading in ("auto", "none"):
            trials += over(scene, f"element length, grading {grading}", "element_length", lengths,
                           {**ONE_THREAD, "bem.grading": grading})
    for scene in ("kirsch", "plate", "shear", "hole"):
        trials += over(scene, "quadrature tolerance", "bem.quadrature_tolerance",
                       (1e-3, 1e-4, 1e-6, 1e-8, 1e-14, 1e-15))
    for scene in ("cantilever", "plate", "shear", "coupled_cantilever"):
        # Scheme paper has bonds that are not calibrated at edges and interfaces, so this is also the price of that.
        trials += over(scene, "scheme, with its bonds", "scheme", ("symmetric", "paper"))
    trials += over("shear", "threads", "threads", (1, 2), {"element_length": 0.01})
    trials += over("coupled_cantilever", "spacing", "spacing", (0.1, 0.05, 0.025, 0.0125))
    trials += over("coupled_cantilever", "horizon ratio", "horizon_ratio", (2, 3, 4, 5, 6))
    return trials
