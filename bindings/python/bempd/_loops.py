"""Closed outlines of bodies, and how lines and arcs of a drawing are joined to outlines."""

from __future__ import annotations

import dataclasses
import math
from typing import Iterable, Optional, Sequence, Union

import numpy as np
import numpy.typing as npt

from ._sketch import Place, arc_of_bulge
from .errors import ArgumentError

FloatArray = npt.NDArray[np.float64]

#: Metres of a unit of length.
UNITS = {"m": 1.0, "dm": 0.1, "cm": 1e-2, "mm": 1e-3, "um": 1e-6, "micrometre": 1e-6, "nm": 1e-9, "km": 1e3, "in": 0.0254,
         "inch": 0.0254, "ft": 0.3048, "foot": 0.3048, "yd": 0.9144, "mil": 0.0254e-3}
Unit = Union[str, float]


def metres(caller: str, unit: Unit) -> float:
    """The factor by which lengths of a drawing become metres."""
    if isinstance(unit, str):
        if unit not in UNITS:
            raise ArgumentError(f"{caller}: unit is {unit!r}; give one of {', '.join(map(repr, UNITS))}, or a number: the "
                                "metres of one unit of the drawing")
        return UNITS[unit]
    if isinstance(unit, bool) or not isinstance(unit, (int, float)) or not math.isfinite(unit) or unit <= 0:
        raise ArgumentError(f"{caller}: unit is {unit!r}; give a name such as 'mm', or the metres of one unit of the drawing")
    return float(unit)


@dataclasses.dataclass(frozen=True)
class Piece:
    """A line of a drawing: a chain of straight lines and arcs."""

    entity: str  #: what the drawing calls it, for messages
    name: str  #: of the edges that it becomes; empty if it has none
    places: list[Place]  #: n + 1 of them, of which the last is the first where the piece is closed
    bulges: list[float]  #: n, of the way from each place to the next

    def reversed(self) -> Piece:
        """The same line from its end to its start."""
        return Piece(self.entity, self.name, self.places[::-1], [-bulge for bulge in self.bulges[::-1]])


@dataclasses.dataclass(frozen=True)
class Loop:
    """A closed outline; edge k goes from vertex k to the next one."""

    vertices: FloatArray  #: shape (n, 2) [m]
    bulges: FloatArray  #: shape (n,): the tangent of a quarter of the angle that each edge turns, 0 for straight edges
    names: tuple[str, ...]  #: n names of edges; empty where an edge has none
    entities: tuple[str, ...]  #: n entities of the drawing that the edges come from

    def ways(self) -> list[list[Place]]:
        """Places along each edge, with its end."""
        corners = [(float(x), float(y)) for x, y in self.vertices]
        return [way(start, end, float(bulge)) for start, end, bulge in zip(corners, corners[1:] + corners[:1], self.bulges)]

    def polygon(self) -> FloatArray:
        """The outline as a polygon with short sides along its arcs."""
        return np.array([place for one in self.ways() for place in one[:-1]])

    def reversed(self) -> Loop:
        """The same outline, traversed the other way."""
        order = np.arange(len(self.bulges) - 2, -2, -1)
        return Loop(self.vertices[::-1].copy(), -self.bulges[order], tuple(self.names[k] for k in order),
                    tuple(self.entities[k] for k in order))

    def turned(self, counter_clockwise: bool) -> Loop:
        """The outline in one of the two orientations."""
        return self if (area(self.polygon()) > 0) == counter_clockwise else self.reversed()

    def scaled(self, factor: float) -> Loop:
        """The outline with its lengths multiplied."""
        return dataclasses.replace(self, vertices=factor * self.vertices)


@dataclasses.dataclass(frozen=True)
class Outline:
    """The outline of a body with its holes, as add_bem_region() and add_pd_region() take it in place of vertices.

    >>> import bempd
    >>> square = bempd.outline.Outline.of_vertices(bempd.rectangle(0, 0, 2, 1), names=["bottom", "right", "top", "left"])
    >>> model = bempd.Model()
    >>> glass = model.add_material(young_modulus=3e9, poisson_ratio=1 / 3)
    >>> plate = model.add_bem_region(glass, square, element_length=0.25)
    >>> model.edge_named(plate, "right")
    2
    """

    outer: Loop  #: counter-clockwise
    holes: tuple[Loop, ...] = ()  #: clockwise
    deviation: float = 0.0  #: largest distance between the outline and the drawing [m]
    source: str = ""  #: file and body

    @staticmethod
    def of_vertices(vertices: npt.ArrayLike, *, bulges: Optional[npt.ArrayLike] = None,
                    names: Optional[Sequence[str]] = None) -> Outline:
        """An outline without a drawing."""
        corners = np.asarray(vertices, dtype=np.float64)
        if corners.ndim != 2 or corners.shape[1] != 2 or len(corners) < 2:
            raise ArgumentError(f"Outline.of_vertices: vertices have the shape {corners.shape}; give n points as (n, 2)")
        bends = np.zeros(len(corners)) if bulges is None else np.asarray(bulges, dtype=np.float64)
        words = tuple(names) if names is not None else ("",) * len(corners)
        if bends.shape != (len(corners),) or len(words) != len(corners):
            raise ArgumentError(f"Outline.of_vertices: there are {len(corners)} edges, {len(bends)} bulges and {len(words)} "
                                "names; give one of each for every edge")
        return Outline(Loop(corners, bends, words, ("",) * len(corners)))

    @property
    def vertices(self) -> FloatArray:
        """Vertices of the outer loop [m]."""
        return self.outer.vertices

    @property
    def bulges(self) -> FloatArray:
        """Bulges of the outer loop."""
        return self.outer.bulges

    @property
    def loops(self) -> tuple[Loop, ...]:
        """The outer loop and the holes, in the order in which a region numbers their edges."""
        return (self.outer, *self.holes)

    @property
    def names(self) -> tuple[str, ...]:
        """Names of all edges; edge k of a region has names[k - 1]."""
        return tuple(name for loop in self.loops for name in loop.names)

    def scaled(self, factor: float) -> Outline:
        """The outline with its lengths multiplied, such as 1000 for millimetres."""
        return Outline(self.outer.scaled(factor), tuple(hole.scaled(factor) for hole in self.holes),
                       factor * self.deviation, self.source)

    def __repr__(self) -> str:
        low, high = self.outer.polygon().min(axis=0), self.outer.polygon().max(axis=0)
        named = sorted(set(filter(None, self.names)))
        words = f"; edges named {', '.join(named)}" if named else ""
        return (f"<Outline: {len(self.names)} edges, {len(self.holes)} holes, x {low[0]:g} .. {high[0]:g}, "
                f"y {low[1]:g} .. {high[1]:g}{words}>")


def way(start: Place, end: Place, bulge: float) -> list[Place]:
    """Places along a straight line or an arc, with its end."""
    return [*(arc_of_bulge(start, end, bulge).between(start, end) if bulge else [start]), end]


def area(polygon: FloatArray) -> float:
    """Area of a polygon, negative if it is traversed clockwise."""
    x, y = (polygon - polygon[0]).T
    return float(0.5 * (np.dot(x, np.roll(y, -1)) - np.dot(np.roll(x, -1), y)))


def size_of(pieces: Iterable[Piece]) -> float:
    """Larger side of the box around all pieces."""
    places = np.array([place for piece in pieces for place in piece.places])
    return float(np.ptp(places, axis=0).max()) if len(places) else 0.0


def closed_loops(caller: str, pieces: list[Piece], gap: float) -> tuple[list[Loop], float]:
    """Loops of which the pieces consist, and the largest distance of ends that were joined: `gap` at most."""
    loops = [loop_of([piece]) for piece in pieces if math.dist(piece.places[0], piece.places[-1]) <= gap and len(piece.bulges) > 1]
    left = [piece for piece in pieces if math.dist(piece.places[0], piece.places[-1]) > gap]
    joints = joined_ends(left, gap)
    check_joints(caller, left, joints)
    moved = max((math.dist(left[k].places[side], left[joint[0][0]].places[joint[0][1]]) for joint in joints for k, side in joint),
                default=0.0)
    while left:
        chain = [left.pop(0)]
        while math.dist(chain[-1].places[-1], chain[0].places[0]) > gap:
            here = chain[-1].places[-1]
            if not left:
                raise ArgumentError(f"{caller}: gap is {gap:g}, which joins more than two ends near ({here[0]:g}, {here[1]:g}); "
                                    "give a smaller one")
            found = min(range(len(left)), key=lambda k: min(math.dist(here, left[k].places[0]), math.dist(here, left[k].places[-1])))
            piece = left.pop(found)
            chain.append(piece if math.dist(here, piece.places[0]) <= math.dist(here, piece.places[-1]) else piece.reversed())
        loops.append(loop_of(chain))
    return loops, moved


def loop_of(chain: Sequence[Piece]) -> Loop:
    """The loop of pieces that follow each other; each piece begins where the one before ends."""
    vertices = [place for piece in chain for place in piece.places[:-1]]
    loop = Loop(np.array(vertices), np.array([bulge for piece in chain for bulge in piece.bulges]),
                tuple(piece.name for piece in chain for _ in piece.bulges),
                tuple(piece.entity for piece in chain for _ in piece.bulges))
    # Regions have three vertices at least; a circle of two arcs has not.
    return loop if len(vertices) > 2 else halved(loop)


def halved(loop: Loop) -> Loop:
    """The same outline with every edge divided at its middle."""
    ends = np.roll(loop.vertices, -1, axis=0)
    chords = ends - loop.vertices
    # A positive bulge lies on the right of the chord.
    middles = 0.5 * (loop.vertices + ends) + 0.5 * loop.bulges[:, None] * np.stack([chords[:, 1], -chords[:, 0]], axis=1)
    return Loop(np.stack([loop.vertices, middles], axis=1).reshape(-1, 2), np.repeat(np.tan(np.arctan(loop.bulges) / 2), 2),
                tuple(name for name in loop.names for _ in range(2)), tuple(entity for entity in loop.entities for _ in range(2)))


def joined_ends(pieces: list[Piece], gap: float) -> list[list[tuple[int, int]]]:
    """Groups of ends (piece, 0 or -1) that lie at one place."""
    ends = [(k, side) for k in range(len(pieces)) for side in (0, -1)]
    places = np.array([pieces[k].places[side] for k, side in ends]).reshape(-1, 2)
    group = -np.ones(len(ends), dtype=int)
    for first in range(len(ends)):
        if group[first] < 0:
            near = (group < 0) & (np.hypot(*(places - places[first]).T) <= gap)
            group[near] = first
    return [[ends[k] for k in np.flatnonzero(group == number)] for number in np.unique(group)]


def check_joints(caller: str, pieces: list[Piece], joints: list[list[tuple[int, int]]]) -> None:
    """Two ends meet at every place, or an error names those that do not."""
    lone = [joint[0] for joint in joints if len(joint) == 1]
    for piece, side in lone:
        x, y = pieces[piece].places[side]
        others = [(math.dist((x, y), pieces[k].places[s]), k) for k, s in lone if (k, s) != (piece, side)]
        distance, nearest = min(others, default=(math.inf, piece))
        cure = (f"the nearest open end, of {pieces[nearest].entity}, is {distance:.3g} away: close the outline in the drawing, or "
                f"join the two with gap={1.1 * distance:.2g}" if others else "close the outline in the drawing")
        raise ArgumentError(f"{caller}: the outline is open: {pieces[piece].entity} ends at ({x:g}, {y:g}), where nothing goes "
                            f"on; {cure}")
    for joint in joints:
        if len(joint) > 2:
            x, y = pieces[joint[0][0]].places[joint[0][1]]
            named = " and ".join(pieces[k].entity for k, _ in joint)
            raise ArgumentError(f"{caller}: {len(joint)} lines meet at ({x:g}, {y:g}): {named}; an outline has two there, so "
                                "remove lines that lie on each other, or choose those of the outline with layer=")


def check_crossings(caller: str, loops: Sequence[Loop]) -> None:
    """No edge crosses or runs along another one; an error names the two."""
    starts, ends, owners = [], [], []
    for k, loop in enumerate(loops):
        for edge, places in enumerate(loop.ways()):
            starts += places[:-1]
            ends += places[1:]
            owners += [(k, edge)] * (len(places) - 1)
    a, b = np.array(starts), np.array(ends)
    size = float(np.ptp(a, axis=0).max())
    low, high = np.minimum(a, b), np.maximum(a, b)
    for row in range(len(a) - 1):
        near = row + 1 + np.flatnonzero((low[row + 1:] <= high[row]).all(axis=1) & (high[row + 1:] >= low[row]).all(axis=1))
        for other in near:
            where = meeting(a[row], b[row], a[other], b[other], 1e-9 * size)
            if where is None or are_neighbours(loops, owners[row], owners[other], row, other, where, a, b, 1e-7 * size):
                continue
            (one, edge), (two, last) = owners[row], owners[other]
            names = f"{loops[one].entities[edge]} and {loops[two].entities[last]}"
            raise ArgumentError(f"{caller}: the outline crosses itself: {names} meet at ({where[0]:g}, {where[1]:g}), where "
                                "neither ends; trim them there, or choose the lines of the outline with layer=")


def are_neighbours(loops: Sequence[Loop], first: tuple[int, int], second: tuple[int, int], row: int, other: int,
                   where: FloatArray, a: FloatArray, b: FloatArray, close: float) -> bool:
    """Whether two short sides follow each other in one loop and meet at their common end only."""
    if first[0] != second[0]:
        return False
    shared = [p for p in (a[row], b[row]) for q in (a[other], b[other]) if np.hypot(*(p - q)) <= close]
    return any(float(np.hypot(*(where - place))) <= close for place in shared)


def meeting(a: FloatArray, b: FloatArray, c: FloatArray, d: FloatArray, close: float) -> Optional[FloatArray]:
    """The place where two straight lines meet; the middle of a common part; None if they do not."""
    u, v, w = b - a, d - c, c - a
    cross = u[0] * v[1] - u[1] * v[0]
    lengths = float(np.hypot(*u) * np.hypot(*v))
    if lengths == 0:
        return None
    if abs(cross) > 1e-12 * lengths:
        s, t = (w[0] * v[1] - w[1] * v[0]) / cross, (w[0] * u[1] - w[1] * u[0]) / cross
        over = close / min(float(np.hypot(*u)), float(np.hypot(*v)))
        if not (-over <= s <= 1 + over and -over <= t <= 1 + over):
            return None
        place: FloatArray = a + s * u
        return place
    if abs(w[0] * u[1] - w[1] * u[0]) > close * float(np.hypot(*u)):
        return None
    along = sorted((float(np.dot(p - a, u) / np.dot(u, u)), k) for k, p in enumerate((a, b, c, d)))
    (_, first), (inner, _), (outer, _), _ = along
    if first < 2 and along[1][1] < 2 and inner < outer - 1e-9 or first >= 2 and along[1][1] >= 2 and inner < outer - 1e-9:
        return None
    middle: FloatArray = a + 0.5 * (inner + outer) * u
    return middle


def bodies_of(loops: list[Loop], source: str, deviation: float) -> list[Outline]:
    """Bodies with their holes, the largest first: a loop in an odd number of others is a hole of the smallest of them."""
    polygons = [loop.polygon() for loop in loops]
    areas = [abs(area(polygon)) for polygon in polygons]
    around = [[k for k, polygon in enumerate(polygons) if k != one and areas[k] > areas[one] and contains(polygon, polygons[one])]
              for one in range(len(loops))]
    found = []
    for k in sorted(range(len(loops)), key=lambda k: -areas[k]):
        if len(around[k]) % 2 == 0:
            holes = [one for one in range(len(loops))
                     if len(around[one]) == len(around[k]) + 1 and k in around[one]]
            found.append(Outline(loops[k].turned(True), tuple(loops[one].turned(False) for one in holes), deviation, source))
    return found


def contains(polygon: FloatArray, inner: FloatArray) -> bool:
    """Whether the middle of the longest side of a polygon that crosses no other one lies inside that one."""
    sides = np.roll(inner, -1, axis=0) - inner
    longest = int(np.argmax(np.hypot(*sides.T)))
    x, y = inner[longest] + 0.5 * sides[longest]
    ax, ay = polygon.T
    bx, by = np.roll(polygon, -1, axis=0).T
    spans = (ay > y) != (by > y)
    with np.errstate(divide="ignore", invalid="ignore"):
        left = ax + (y - ay) * (bx - ax) / (by - ay)
    return bool(np.count_nonzero(spans & (left > x)) % 2)


def chosen_body(caller: str, bodies: list[Outline], body: Optional[int]) -> Outline:
    """One of the bodies of a drawing."""
    if body is None and len(bodies) == 1:
        return bodies[0]
    if body is None or isinstance(body, bool) or not isinstance(body, int) or not 1 <= body <= len(bodies):
        boxes = []
        for number, one in enumerate(bodies, 1):
            low, high = one.outer.polygon().min(axis=0), one.outer.polygon().max(axis=0)
            boxes.append(f"{number}: x {low[0]:g} .. {high[0]:g}, y {low[1]:g} .. {high[1]:g} [m]")
        asked = f"body is {body!r}, but" if body is not None else ""
        raise ArgumentError(f"{caller}: {asked + ' ' if asked else ''}the drawing has {len(bodies)} separate outlines ("
                            f"{'; '.join(boxes)}); choose one with body=1 .. {len(bodies)}, or its lines with layer=")
    return bodies[body - 1]
