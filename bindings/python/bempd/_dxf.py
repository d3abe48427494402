"""Lines of a DXF drawing, read by ezdxf."""

from __future__ import annotations

import math
import pathlib
from typing import Any, Iterator, Optional

import numpy as np

from ._curves import FloatArray, arcs_of, circular_arc, elliptic_arc, full_circle
from ._loops import Piece, size_of
from ._sketch import Place
from .errors import ArgumentError, FileError

#: Metres of the units that $INSUNITS numbers; the source is the DXF reference of the format.
METRES = {1: 0.0254, 2: 0.3048, 3: 1609.344, 4: 1e-3, 5: 1e-2, 6: 1.0, 7: 1e3, 9: 0.0254e-3, 10: 0.9144, 11: 1e-10, 12: 1e-9,
          13: 1e-6, 14: 0.1}
CURVES = {"LINE", "ARC", "CIRCLE", "LWPOLYLINE", "POLYLINE", "ELLIPSE", "SPLINE"}


class Drawing:
    """The entities of a drawing's model space on some layers."""

    def __init__(self, ezdxf: Any, file: pathlib.Path, layers: Optional[set[str]]) -> None:
        try:
            self._document = ezdxf.readfile(str(file))
        except (OSError, ezdxf.DXFError, UnicodeDecodeError) as problem:
            raise FileError(f"from_dxf: {file} cannot be read as a DXF drawing: {problem}") from None
        self._file = file
        everything = list(entities_of(self._document.modelspace(), ""))
        self._layers = sorted({entity.dxf.layer for entity, _ in everything if entity.dxftype() in CURVES})
        unknown = sorted((layers or set()) - set(self._layers))
        if unknown:
            raise ArgumentError(f"from_dxf: {file.name} has no line, arc or curve on the layer {unknown[0]!r}; it has some on "
                                f"{', '.join(map(repr, self._layers)) or 'none'}")
        self._chosen = [(entity, inside) for entity, inside in everything
                        if entity.dxftype() in CURVES and (layers is None or entity.dxf.layer in layers)]

    def layers(self) -> list[str]:
        """Names of the layers that have lines."""
        return self._layers

    def metres(self) -> float:
        """Metres of the drawing's unit, as the drawing states it."""
        code = int(self._document.header.get("$INSUNITS", 0))
        if code not in METRES:
            raise ArgumentError(f"from_dxf: {self._file.name} does not say its unit ($INSUNITS is {code}); give unit='mm', or the "
                                "metres of one unit of the drawing")
        return METRES[code]

    def size(self) -> float:
        """Larger side of the drawing, roughly: curves count with few places."""
        return size_of(self.pieces(math.inf)[0])

    def pieces(self, tolerance: float) -> tuple[list[Piece], float]:
        """All lines, and the largest distance of arcs from the curves that they stand for."""
        found, worst = [], 0.0
        for entity, inside in self._chosen:
            label = f"{entity.dxftype()} {'#' + entity.dxf.handle if entity.dxf.handle else ''}".strip()
            label = f"{label} on layer {entity.dxf.layer}{inside}"
            places, bulges, deviation = line_of(entity, tolerance, label)
            worst = max(worst, deviation)
            name = "" if entity.dxf.layer == "0" else entity.dxf.layer
            lengths = [math.dist(a, b) for a, b in zip(places, places[1:])]
            kept = [k for k, length in enumerate(lengths) if length > 0]
            if kept:
                found.append(Piece(label, name, [places[k] for k in kept] + [places[kept[-1] + 1]], [bulges[k] for k in kept]))
        return found, worst


def entities_of(layout: Any, inside: str) -> Iterator[tuple[Any, str]]:
    """Entities with those of blocks, and words that tell the block."""
    for entity in layout:
        if entity.dxftype() == "INSERT":
            yield from entities_of(entity.virtual_entities(), f" in block {entity.dxf.name}")
        else:
            yield entity, inside


def line_of(entity: Any, tolerance: float, label: str) -> tuple[list[Place], list[float], float]:
    """Places, bulges and the distance from the curve, in the drawing's coordinates."""
    kind = entity.dxftype()
    normal = entity.dxf.extrusion if entity.dxf.hasattr("extrusion") else (0.0, 0.0, 1.0)
    if abs(abs(normal[2]) - 1) > 1e-9:
        raise ArgumentError(f"from_dxf: {label} is not in the plane of the drawing; its normal is ({normal[0]:g}, {normal[1]:g}, "
                            f"{normal[2]:g})")
    # Mirrored entities look at the plane from behind: x has the other sign in their own coordinates.
    mirror = -1.0 if normal[2] < 0 else 1.0
    if kind == "LINE":
        return [flat(entity.dxf.start), flat(entity.dxf.end)], [0.0], 0.0
    if kind == "SPLINE":
        return spline(entity, tolerance)
    if kind == "ELLIPSE":
        return ellipse(entity, tolerance)
    if kind == "CIRCLE":
        places, bulges = full_circle(flat(entity.dxf.center), entity.dxf.radius)
    elif kind == "ARC":
        start, end = math.radians(entity.dxf.start_angle), math.radians(entity.dxf.end_angle)
        turn = (end - start) % math.tau or math.tau
        places, bulges = circular_arc(flat(entity.dxf.center), entity.dxf.radius, start, start + turn)
    else:
        places, bulges = polyline(entity, label)
    return [(mirror * x, y) for x, y in places], [mirror * bulge for bulge in bulges], 0.0


def flat(point: Any) -> Place:
    """A place without its height."""
    return float(point[0]), float(point[1])


def polyline(entity: Any, label: str) -> tuple[list[Place], list[float]]:
    """A polyline of either kind."""
    if entity.dxftype() == "LWPOLYLINE":
        rows, closed = [(row[0], row[1], row[2]) for row in entity.get_points("xyb")], entity.closed
    elif entity.is_2d_polyline or entity.is_3d_polyline:
        rows = [(*flat(vertex.dxf.location), vertex.dxf.bulge if entity.is_2d_polyline else 0.0) for vertex in entity.vertices]
        closed = entity.is_closed
    else:
        raise ArgumentError(f"from_dxf: {label} is a mesh; an outline consists of lines and curves")
    places, bulges = [(float(x), float(y)) for x, y, _ in rows], [float(bulge) for _, _, bulge in rows]
    return (places + places[:1], bulges) if closed else (places, bulges[:-1])


def ellipse(entity: Any, tolerance: float) -> tuple[list[Place], list[float], float]:
    """An ellipse or a part of one."""
    major = flat(entity.dxf.major_axis)
    minor = flat(entity.minor_axis)
    start, end = float(entity.dxf.start_param), float(entity.dxf.end_param)
    turn = (end - start) % math.tau or math.tau
    curve = elliptic_arc(flat(entity.dxf.center), major, minor, start, start + turn)
    quarters = max(1, math.ceil(turn / (math.pi / 2) - 1e-9))
    places, bulges, deviation = arcs_of(curve, [k / quarters for k in range(quarters + 1)], tolerance)
    return closed_exactly(places) if turn == math.tau else places, bulges, deviation


def spline(entity: Any, tolerance: float) -> tuple[list[Place], list[float], float]:
    """A spline; it may have corners at knots that are given as often as its degree."""
    tool = entity.construction_tool()
    knots = [float(knot) for knot in tool.knots()]
    degree = tool.order - 1
    first, last = knots[degree], knots[-degree - 1]
    corners = sorted({knot for knot in knots if first < knot < last and knots.count(knot) >= degree})
    spans = [first, *corners, last]

    def at(t: FloatArray) -> tuple[FloatArray, FloatArray]:
        rows = [tool.derivative(min(max(one, first), last), 1) for one in t]
        return (np.array([flat(row[0]) for row in rows]), np.array([flat(row[1]) for row in rows]))

    places: list[Place] = []
    bulges: list[float] = []
    worst = 0.0
    for start, end in zip(spans, spans[1:]):
        # The derivative beside a corner is that of its own side.
        hair = 1e-9 * (end - start)
        more, bends, deviation = arcs_of(at, breaks(start + hair, end - hair, knots), tolerance)
        places, bulges, worst = places + more[:-1], bulges + bends, max(worst, deviation)
    places.append(flat(tool.point(last)))
    return closed_exactly(places) if entity.closed else places, bulges, worst


def breaks(start: float, end: float, knots: list[float]) -> list[float]:
    """Parameters of a smooth part at which it is divided first, so that no bend between few samples is missed."""
    between = sorted({knot for knot in knots if start < knot < end})
    parts = between[3::4]
    return [start, *parts, end]


def closed_exactly(places: list[Place]) -> list[Place]:
    """The same places with the end at the start."""
    return [*places[:-1], places[0]]
