"""Shapes of an SVG drawing, read by svgelements."""

from __future__ import annotations

import io
import math
import pathlib
import re
import xml.etree.ElementTree as xml
from typing import Any, Optional

import numpy as np

from ._curves import arcs_of, bezier, circular_arc, elliptic_arc
from ._loops import UNITS, Piece, size_of
from ._sketch import Place
from .errors import ArgumentError, FileError

#: Metres of the units of CSS that have a size on paper.
METRES = {"mm": UNITS["mm"], "cm": UNITS["cm"], "in": UNITS["in"], "pt": 0.0254 / 72, "pc": 0.0254 / 6, "Q": 0.25e-3}
LENGTH = re.compile(r"\s*([-+0-9.eE]+?)\s*([a-zA-Z%]*)\s*")


class Drawing:
    """The shapes of a drawing in the coordinates of its page, y upwards."""

    def __init__(self, svgelements: Any, file: pathlib.Path, ids: Optional[set[str]]) -> None:
        self._package, self._file = svgelements, file
        try:
            root = xml.parse(file).getroot()
            self._width, self._height, self._box = page_of(root)
            # The page is as large as its coordinates, so that svgelements leaves these as they are.
            root.set("width", repr(self._box[2]))
            root.set("height", repr(self._box[3]))
            drawing = svgelements.SVG.parse(io.StringIO(xml.tostring(root, encoding="unicode")), reify=True)
        except (xml.ParseError, OSError, ValueError) as problem:
            if isinstance(problem, ArgumentError):
                raise
            raise FileError(f"from_svg: {file} cannot be read as an SVG drawing: {problem}") from None
        shapes = [shape for shape in drawing.elements() if isinstance(shape, svgelements.Shape) and visible(shape)]
        self._ids = sorted({shape.id for shape in shapes if shape.id})
        unknown = sorted((ids or set()) - set(self._ids))
        if unknown:
            raise ArgumentError(f"from_svg: {file.name} has no shape with the id {unknown[0]!r}; it has "
                                f"{', '.join(map(repr, self._ids)) or 'none'}")
        self._shapes = [(number, shape) for number, shape in enumerate(shapes, 1) if ids is None or shape.id in ids]

    def ids(self) -> list[str]:
        """Ids of the shapes."""
        return self._ids

    def metres(self) -> float:
        """Metres of one unit of the coordinates, from the size of the page."""
        sizes = []
        for what, (number, unit), extent in (("width", self._width, self._box[2]), ("height", self._height, self._box[3])):
            if unit not in METRES:
                raise ArgumentError(f"from_svg: {self._file.name} does not say its unit: its {what} is {number:g}{unit}; give "
                                    "unit='mm', or the metres of one unit of its coordinates")
            sizes.append(number * METRES[unit] / extent)
        if abs(sizes[0] - sizes[1]) > 1e-3 * sizes[0]:
            raise ArgumentError(f"from_svg: width and height of {self._file.name} stretch the drawing: {sizes[0]:g} m by {sizes[1]:g} "
                                "m for one unit; give unit='mm', or the metres of one unit of its coordinates")
        return sizes[0]

    def size(self) -> float:
        """Larger side of the drawing, roughly: curves count with few places."""
        return size_of(self.pieces(math.inf)[0])

    def pieces(self, tolerance: float) -> tuple[list[Piece], float]:
        """All lines, and the largest distance of arcs from the curves that they stand for."""
        found: list[Piece] = []
        worst = 0.0
        for number, shape in self._shapes:
            tag = type(shape).__name__.lower()
            label = f'{tag} id="{shape.id}"' if shape.id else f"{tag}, the drawing's shape number {number}"
            for places, bulges, deviation in self._chains(abs(self._package.Path(shape)), tolerance):
                worst = max(worst, deviation)
                upwards = [(x - self._box[0], self._box[3] - (y - self._box[1])) for x, y in places]
                found.append(Piece(label, shape.id or "", upwards, [-bulge for bulge in bulges]))
        return found, worst

    def _chains(self, path: Any, tolerance: float) -> list[tuple[list[Place], list[float], float]]:
        """The connected parts of a path, with y downwards as the drawing has it."""
        chains: list[tuple[list[Place], list[float], float]] = []
        places: list[Place] = []
        bulges: list[float] = []
        worst = 0.0
        for segment in [*path, None]:
            if segment is None or isinstance(segment, self._package.Move):
                if bulges:
                    chains.append((places, bulges, worst))
                places, bulges, worst = [], [], 0.0
            elif segment.start is not None and segment.end is not None:
                more, bends, deviation = self._line(segment, tolerance)
                lengths = [math.dist(a, b) for a, b in zip(more, more[1:])]
                # The line that closes a circle is as long as rounding makes it.
                closes = isinstance(segment, self._package.Close)
                least = 1e-9 * max((math.dist(places[0], place) for place in places), default=0.0) if closes else 0.0
                for k, length in enumerate(lengths):
                    if length > least:
                        places = [*places, more[k + 1]] if places else [more[k], more[k + 1]]
                        bulges.append(bends[k])
                worst = max(worst, deviation)
                if closes and places:
                    places[-1] = places[0]
        return chains

    def _line(self, segment: Any, tolerance: float) -> tuple[list[Place], list[float], float]:
        """Places, bulges and the distance from the curve of one segment of a path."""
        start, end = flat(segment.start), flat(segment.end)
        if isinstance(segment, self._package.Arc):
            return elliptic(segment, tolerance)
        if isinstance(segment, (self._package.CubicBezier, self._package.QuadraticBezier)):
            names = ("start", "control1", "control2", "end") if hasattr(segment, "control1") else ("start", "control", "end")
            control = [complex(*flat(getattr(segment, name))) for name in names]
            places, bulges, deviation = arcs_of(bezier(control), [0.0, 1.0], tolerance)
            return [start, *places[1:-1], end], bulges, deviation
        return [start, end], [0.0], 0.0


def elliptic(segment: Any, tolerance: float) -> tuple[list[Place], list[float], float]:
    """An arc of a circle as it is, of an ellipse by arcs of circles."""
    centre, start, end = flat(segment.center), flat(segment.start), flat(segment.end)
    major, minor = (np.subtract(flat(point), centre) for point in (segment.prx, segment.pry))
    axes = np.column_stack([major, minor])
    # The arc is centre + major cos t + minor sin t; svgelements gives its sweep as seen, t may turn the other way.
    first, last = (math.atan2(*np.linalg.solve(axes, np.subtract(place, centre))[::-1]) for place in (start, end))
    sense = math.copysign(1.0, segment.sweep) * math.copysign(1.0, np.linalg.det(axes))
    turn = sense * ((sense * (last - first)) % math.tau or math.tau)
    long, short = np.linalg.svd(axes, compute_uv=False)
    if long - short <= 1e-9 * long:
        angle = math.atan2(start[1] - centre[1], start[0] - centre[0])
        places, bulges = circular_arc(centre, float(long), angle, angle + math.copysign(turn, segment.sweep))
        deviation = 0.0
    else:
        quarters = max(1, math.ceil(abs(turn) / (math.pi / 2) - 1e-9))
        curve = elliptic_arc(centre, (float(major[0]), float(major[1])), (float(minor[0]), float(minor[1])), first, first + turn)
        places, bulges, deviation = arcs_of(curve, [k / quarters for k in range(quarters + 1)], tolerance)
    return [flat(segment.start), *places[1:-1], flat(segment.end)], bulges, deviation


def page_of(root: Any) -> tuple[tuple[float, str], tuple[float, str], tuple[float, float, float, float]]:
    """Width and height of the page with their units, and its view box."""
    lengths = []
    for name in ("width", "height"):
        found = LENGTH.fullmatch(root.get(name, ""))
        lengths.append((float(found[1]), found[2]) if found else (0.0, ""))
    given = root.get("viewBox")
    if given:
        x, y, width, height = (float(number) for number in re.split(r"[\s,]+", given.strip()))
    else:
        x, y, width, height = 0.0, 0.0, lengths[0][0] or 100.0, lengths[1][0] or 100.0
        # Coordinates are pixels without a view box, 96 of them an inch.
        for k, (number, unit) in enumerate(lengths):
            if unit in METRES:
                size = number * METRES[unit] / (0.0254 / 96)
                width, height = (size, height) if k == 0 else (width, size)
    if not (width > 0 and height > 0):
        raise ValueError(f"its page is {width:g} by {height:g}")
    return lengths[0], lengths[1], (x, y, width, height)


def flat(point: Any) -> Place:
    """A place of a drawing."""
    return float(point.x), float(point.y)


def visible(shape: Any) -> bool:
    """Whether a shape is shown."""
    values = getattr(shape, "values", {})
    return values.get("display") != "none" and values.get("visibility") != "hidden"
