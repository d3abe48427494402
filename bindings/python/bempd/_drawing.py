"""Draws bodies in matplotlib's axes: faces by colours of a quantity, outlines, meshes, crack lines."""

from __future__ import annotations

import dataclasses
from typing import Any, Optional, Tuple

import numpy as np
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.colors import Normalize
from matplotlib.ticker import MaxNLocator

from ._bodies import Body, free_sides, halves, quantity_values
from .errors import ArgumentError

BODY_FACE, BODY_EDGE, CURVE, MARK = "#e9ebee", "#6d737c", "#1f4e79", "#b3261e"
# Signed quantities get two colours that part at zero.
SIGNED, UNSIGNED = "RdBu_r", "viridis"
COLOURS = {"damage": "YlOrRd", "displacement": UNSIGNED, "displacement x": SIGNED, "displacement y": SIGNED,
           "stress xx": SIGNED, "stress yy": SIGNED, "stress xy": SIGNED, "stress principal": SIGNED,
           "stress smallest principal": SIGNED, "stress shear": UNSIGNED, "stress von Mises": UNSIGNED}
QUANTITIES = ("outline", "lattice", *COLOURS)
# Short words for them.
SHORT = {**{name.split(" ", 1)[1]: name for name in QUANTITIES if name.startswith("stress ")}, "x": "displacement x",
         "y": "displacement y"}
UNITS = {"damage": "-", "displacement": "m", "stress": "Pa"}
Limits = Tuple[float, float]


@dataclasses.dataclass(frozen=True)
class ColourScale:
    """What the colours of a quantity mean."""

    quantity: str
    low: float  #: in SI units
    high: float
    factor: float  #: from SI units to `unit`
    unit: str

    def values(self, body: Body) -> Any:
        """Values at the points of a body within the limits, in the unit of the scale."""
        levels = self.levels()
        # A hair inside: contours leave out what rounding puts beyond the outermost level.
        hair = 1e-9 * (levels[-1] - levels[0])
        return np.clip(self.factor * quantity_values(body, self.quantity), levels[0] + hair, levels[-1] - hair)

    def norm(self) -> Normalize:
        """Positions in the colour map: those of signed quantities have zero in the middle."""
        low, high = self.factor * self.low, self.factor * self.high
        if COLOURS[self.quantity] == SIGNED:
            low, high = min(low, -high), max(high, -low)
        return Normalize(low, high)

    def levels(self) -> Any:
        """Borders of the colours of contours, in the unit of the scale."""
        return self.factor * np.linspace(self.low, self.high, 31)


def colour_scale(found: list[Body], quantity: str, limits: Optional[Limits]) -> Optional[ColourScale]:
    """The scale of a quantity; None for those that show no values."""
    if quantity not in COLOURS:
        return None
    unit = UNITS[quantity.split()[0]]
    values = np.concatenate([quantity_values(body, quantity) for body in found])
    if np.isnan(values).any():
        raise ArgumentError(f"draw: the {quantity[7:]} stress of a heated region in plane strain is not known here: the temperature "
                            "changes the stress across the plane; draw 'stress shear' or 'stress principal'")
    if limits is not None:
        low, high = limits
    elif quantity == "damage":
        low, high = 0.0, max(0.1, float(np.ceil(10 * values.max() - 1e-9)) / 10)
    else:
        # One point next to a crack or corner must not fade all others; nor may a loose fragment.
        low, high = (float(value) for value in np.quantile(values, (0.01, 0.99)))
        if COLOURS[quantity] == UNSIGNED:
            low = 0.0
    largest = max(abs(low), abs(high))
    high = max(high, low + max(1e-6 * largest, 1e-300))
    factor, shown_unit = engineering(largest, unit) if unit != "-" else (1.0, unit)
    return ColourScale(quantity, low, high, factor, shown_unit)


def engineering(largest: float, unit: str) -> tuple[float, str]:
    """(factor, unit with prefix) that bring numbers up to `largest` between 1 and 1000."""
    prefixes = {-9: "n", -6: "\u00b5", -3: "m", 0: "", 3: "k", 6: "M", 9: "G"}
    exponent = 0 if not largest > 0 else int(np.clip(3 * np.floor(np.log10(largest) / 3 + 1e-12), -9, 9))
    return 10.0**-exponent, prefixes[exponent] + unit


def round_magnification(found: list[Body], share: float = 0.05) -> float:
    """1, 2 or 5 times a power of ten that shows all but the largest displacements as a share of the body's size."""
    points = np.concatenate([body.points for body in found])
    size = float(np.hypot(*np.ptp(points, axis=0)))
    # A loose fragment may fly far; it must not set the scale.
    typical = float(np.quantile(np.concatenate([np.hypot(*body.displacement.T) for body in found]), 0.98))
    if not typical > 0:
        return 1.0
    power = 10.0 ** np.floor(np.log10(share * size / typical))
    return float(power * max(step for step in (1, 2, 5) if step * power * typical <= share * size * (1 + 1e-9)))


def paint(axes: Any, found: list[Body], colours: Optional[ColourScale], magnification: float, factor: float,
          mesh: bool) -> Any:
    """Fill the bodies; returns what a colour bar needs, or None."""
    mapped = None
    for body in found:
        points = factor * body.shown(magnification)
        # A crack in the deformed shape is the gap that the cut cells leave.
        cells = body.cells if magnification == 0 else body.cells[~body.cut]
        triangles = halves(cells) if body.is_lattice else body.triangles
        if colours is None or (colours.quantity == "damage" and not body.is_lattice):
            paint_plain(axes, points, triangles)
        elif colours.quantity == "damage":
            mapped = paint_cells(axes, points, cells, colours, colours.values(body))
        elif len(triangles):
            # Contours must not join the two faces of a crack: the cells that it cuts have each corner's colour.
            whole = halves(cells[~body.cut]) if body.is_lattice and magnification == 0 else triangles
            mapped = axes.tricontourf(*points.T, whole, colours.values(body), levels=colours.levels(),
                                      cmap=COLOURS[colours.quantity], norm=colours.norm(), zorder=2)
            if body.is_lattice and magnification == 0:
                paint_quarters(axes, points, cells[body.cut], colours, colours.values(body))
        if mesh and body.is_lattice:
            draw_lattice(axes, points, cells)
        elif mesh:
            axes.plot(*points[body.nodes].T, ".", color=MARK, markersize=3, zorder=5)
        outline: Any = free_sides(cells) if body.is_lattice else body.outline + (body.faces if magnification else [])
        lines = [points[line] for line in outline]
        axes.add_collection(LineCollection(lines, colors=BODY_EDGE, linewidths=0.8, zorder=4))
    return mapped


def draw_cracks(axes: Any, found: list[Body], factor: float, colour: str) -> None:
    """Lines along cracks and broken bonds, in the undeformed shape."""
    segments = [segment for body in found for segment in factor * body.crack]
    axes.add_collection(LineCollection(segments, colors=colour, linewidths=1.2, capstyle="round", zorder=5))


def paint_plain(axes: Any, points: Any, triangles: Any) -> None:
    """A face without values."""
    axes.add_collection(PolyCollection(points[triangles], facecolors=BODY_FACE, edgecolors=BODY_FACE, linewidths=0.8,
                                       zorder=1))


def paint_cells(axes: Any, points: Any, cells: Any, colours: ColourScale, values: Any) -> Any:
    """Lattice cells by the mean of their corners."""
    painted = PolyCollection(points[cells], cmap=COLOURS[colours.quantity], edgecolors="face", linewidths=0.2, zorder=2)
    painted.set_array(values[cells].mean(axis=1))
    painted.set_norm(colours.norm())
    painted.set_rasterized(True)
    axes.add_collection(painted)
    return painted


def paint_quarters(axes: Any, points: Any, cells: Any, colours: ColourScale, values: Any) -> None:
    """Lattice cells that a crack cuts, a quarter for each corner."""
    corners = points[cells]
    middles, centres = 0.5 * (corners + np.roll(corners, -1, axis=1)), corners.mean(axis=1)
    quarters = [np.stack([corners[:, k], middles[:, k], centres, middles[:, k - 1]], axis=1) for k in range(4)]
    painted = PolyCollection(np.concatenate(quarters) if len(cells) else [], cmap=COLOURS[colours.quantity],
                             edgecolors="face", linewidths=0.2, zorder=2)
    painted.set_array(np.concatenate([values[cells[:, k]] for k in range(4)]))
    painted.set_norm(colours.norm())
    axes.add_collection(painted)


def draw_lattice(axes: Any, points: Any, cells: Any) -> None:
    """Lattice cells with the material points."""
    axes.add_collection(PolyCollection(points[cells], facecolors="none", edgecolors="#aab0b8", linewidths=0.3,
                                       zorder=2))
    axes.plot(*points.T, ".", color=CURVE, markersize=1.5, zorder=3)


def add_colour_bar(axes: Any, mapped: Any, label: str) -> None:
    """A bar as high as the axes, whatever the shape of the body."""
    (left, right), (low, high) = axes.get_xlim(), axes.get_ylim()
    width, height = right - left, high - low
    place = axes.inset_axes([1 + 0.02 * max(width, height) / width, 0, 0.025 * max(width, height) / width, 1])
    ticks = MaxNLocator(max(3, int(7 * min(1, 2 * height / width))))
    bar = axes.figure.colorbar(mapped, cax=place, label=label, ticks=ticks)
    bar.outline.set_linewidth(0.5)
    place.tick_params(labelsize=8, width=0.7)
