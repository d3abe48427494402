"""The picture of the example: plates, Weibull plot, size effect."""

from __future__ import annotations

import pathlib

import bempd
import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from main import DENSITY, EXPONENT, LONGEST, SHORTEST, SIDES, modulus  # noqa: E402
from matplotlib.ticker import LogLocator, NullFormatter  # noqa: E402

COLOURS = "#4477aa", "#228833", "#ee6677"


def draw(sides: np.ndarray, strengths: np.ndarray, folder: pathlib.Path) -> None:
    """Writes ensemble.png: one plate of each size, the Weibull plot, and mean strengths by area."""
    figure, (plates, weibull, effect) = plt.subplots(1, 3, figsize=(11, 3.6), constrained_layout=True)
    left = 0.0
    for seed, (side, colour) in enumerate(zip(SIDES, COLOURS)):
        for crack in bempd.random_cracks(seed, (0, 0, side, side), count=round(DENSITY * side**2), length=(SHORTEST, LONGEST),
                                         exponent=EXPONENT):
            plates.plot([left + x for x, _ in crack], [y for _, y in crack], color=colour, linewidth=1.2)
        plates.plot(left + np.array([0, side, side, 0, 0]), [0, 0, side, side, 0], color="black", linewidth=0.8)
        left += side + 0.03
    plates.set_aspect("equal")
    plates.axis("off")
    plates.set_title("one plate of each size")
    means = []
    for side, colour in zip(SIDES, COLOURS):
        ordered = np.sort(strengths[sides == side])
        share = (np.arange(len(ordered)) + 0.5) / len(ordered)
        m, scale = modulus(ordered)
        weibull.plot(np.log(ordered), np.log(-np.log(1 - share)), ".", color=colour, markersize=3)
        at = np.log(ordered[[0, -1]])
        weibull.plot(at, m * (at - np.log(scale)), color=colour, linewidth=1, label=f"{1e3 * side:.0f} mm: m = {m:.1f}")
        means.append(ordered.mean())
    weibull.set_xlabel("log(strength / MPa)")
    weibull.set_ylabel("log(-log(share of stronger plates))")
    weibull.legend(frameon=False, fontsize=8)
    weibull.set_title("Weibull plot")
    areas = 1e4 * np.array(SIDES) ** 2
    effect.loglog(areas, means, "o", color="black", label="mean")
    m = 2 * (EXPONENT - 1)
    effect.loglog(areas, means[0] * (areas / areas[0]) ** (-1 / m), color="gray", label=f"area^(-1/{m:.0f})")
    effect.set_xlabel("area [cm$^2$]")
    effect.set_ylabel("mean strength [MPa]")
    effect.yaxis.set_major_locator(LogLocator(subs=range(1, 10)))
    effect.yaxis.set_major_formatter("{x:g}")
    effect.yaxis.set_minor_formatter(NullFormatter())
    effect.legend(frameon=False, fontsize=8)
    effect.set_title("size effect")
    figure.savefig(folder / "ensemble.png", dpi=130)
