"""What was said of a scene, as words and as a drawing that needs neither matplotlib nor a prepared model."""

from __future__ import annotations

import dataclasses
import html
import math
from typing import Iterable, Optional, Sequence, Union

from .errors import ArgumentError

Place = tuple[float, float]
FACES = {"BEM": "#e3e5e8", "PD": "#fff1c9"}
EDGE, CRACK, HELD, LOADED = "#7d838c", "#b3261e", "#1f4e79", "#c05a00"
WIDTH = 420  # pixels
MOST_NUMBERED = 24  # edges of a region whose numbers are shown


@dataclasses.dataclass(frozen=True)
class Arc:
    """A circular edge."""

    centre: Place
    counter_clockwise: bool

    def between(self, start: Place, end: Place) -> list[Place]:
        """Places on the way, without the end."""
        radius = math.dist(self.centre, start)
        first, last = (math.atan2(p[1] - self.centre[1], p[0] - self.centre[0]) for p in (start, end))
        turn = (last - first) % math.tau or math.tau
        if not self.counter_clockwise:
            turn -= math.tau
        steps = max(2, math.ceil(abs(turn) / 0.1))
        angles = [first + turn * k / steps for k in range(steps)]
        return [(self.centre[0] + radius * math.cos(a), self.centre[1] + radius * math.sin(a)) for a in angles]


def arc_through(start: Place, between: Place, end: Place) -> Optional[Arc]:
    """The circle through three places; none if they lie on a line."""
    bx, by, cx, cy = between[0] - start[0], between[1] - start[1], end[0] - start[0], end[1] - start[1]
    area = 2 * (bx * cy - by * cx)
    if area == 0:
        return None
    b, c = bx * bx + by * by, cx * cx + cy * cy
    return Arc((start[0] + (cy * b - by * c) / area, start[1] + (bx * c - cx * b) / area), area > 0)


def arc_of_bulge(start: Place, end: Place, bulge: float) -> Arc:
    """The arc of which the bulge is the tangent of a quarter of the angle that it turns."""
    along = (1 - bulge * bulge) / (4 * bulge)
    dx, dy = end[0] - start[0], end[1] - start[1]
    return Arc(((start[0] + end[0]) / 2 - along * dy, (start[1] + end[1]) / 2 + along * dx), bulge > 0)


#: Sides of the box around a region: which coordinate, and whether it is the larger one.
SIDES = {"left": (0, 0), "right": (0, 1), "bottom": (1, 0), "top": (1, 1)}


class Region:
    """Loops of vertices; edges are numbered through all of them from 1."""

    def __init__(self, kind: str, loop: Sequence[Place], material: int) -> None:
        self.kind, self.material = kind, material
        self.heated = False  # by a load, so that strain is not stress alone
        self.loops = [list(loop)]
        self.arcs: dict[int, Arc] = {}
        self.names: dict[int, str] = {}  # of edges

    @property
    def edge_count(self) -> int:
        """Number of edges of all loops."""
        return sum(map(len, self.loops))

    def named(self, name: str) -> list[int]:
        """Edges of a name, in their order."""
        return sorted(edge for edge, word in self.names.items() if word == name)

    def box(self) -> tuple[Place, Place]:
        """Lower left and upper right corner of the box around the region."""
        xs, ys = zip(*(place for loop in self.outlines() for place in loop))
        return (min(xs), min(ys)), (max(xs), max(ys))

    def size(self) -> float:
        """Larger side of the box around the region."""
        low, high = self.box()
        return max(high[0] - low[0], high[1] - low[1])

    def on_side(self, side: str) -> list[int]:
        """Edges that lie wholly on a side of the box, by its word."""
        axis, end = SIDES[side]
        at, close = self.box()[end][axis], 1e-6 * self.size()
        return [edge for edge in range(1, self.edge_count + 1) if all(abs(place[axis] - at) <= close for place in self.way(edge))]

    def ends(self, edge: int) -> Optional[tuple[Place, Place]]:
        """Start and end of an edge; none if there is no such edge."""
        before = edge - 1
        for loop in self.loops:
            if 0 <= before < len(loop):
                return loop[before], loop[(before + 1) % len(loop)]
            before -= len(loop)
        return None

    def bend(self, first: int, bulges: Optional[Iterable[float]]) -> None:
        """Make arcs of a loop's edges, of which the first one is given."""
        for edge, bulge in enumerate(() if bulges is None else bulges, first):
            ends = self.ends(edge)
            if ends is not None and bulge != 0:
                self.arcs[edge] = arc_of_bulge(*ends, float(bulge))

    def way(self, edge: int) -> list[Place]:
        """Places along an edge, with its end."""
        ends = self.ends(edge)
        if ends is None:
            return []
        return [*(self.arcs[edge].between(*ends) if edge in self.arcs else [ends[0]]), ends[1]]

    def middle(self, edge: int) -> Place:
        """The middle of an edge."""
        way = self.way(edge)
        a, b = way[(len(way) - 1) // 2], way[len(way) // 2]
        return (a[0] + b[0]) / 2, (a[1] + b[1]) / 2

    def outlines(self) -> list[list[Place]]:
        """Loops as polygons."""
        shown, first = [], 1
        for loop in self.loops:
            shown.append([place for edge in range(first, first + len(loop)) for place in self.way(edge)[:-1]])
            first += len(loop)
        return shown


@dataclasses.dataclass(frozen=True)
class Mark:
    """A support or load: on an edge, at a point, or on a crack."""

    region: int = 0
    edge: int = 0
    point: Optional[Place] = None
    crack: int = 0
    component: Optional[str] = None  #: that is prescribed; None if only held
    proportional: Optional[float] = None  #: [m] per unit of the load factor, where that is one number
    does: str = ""  #: what it does there, in words


class Sketch:
    """A scene as it was described."""

    def __init__(self) -> None:
        self.materials: dict[int, tuple[str, float]] = {}  # plane and Poisson's ratio
        self.regions: dict[int, Region] = {}
        self.cracks: dict[int, list[Place]] = {}
        self.supports: dict[int, Mark] = {}
        self.loads: dict[int, Mark] = {}
        self.names: dict[tuple[str, int], str] = {}  # of regions, supports and loads, by what it is and its number

    def edge(self, caller: str, region: int, edge: Union[int, str]) -> int:
        """The number of an edge that is given by its number or its name."""
        if not isinstance(edge, str):
            return edge
        found = self.regions[region].named(edge) if region in self.regions else []
        if not found and edge in SIDES and region in self.regions:
            found = self.regions[region].on_side(edge)
        if len(found) == 1:
            return found[0]
        if found:
            raise ArgumentError(f"{caller}: {edge!r} is the name of {len(found)} edges of region {region}: "
                                f"{', '.join(map(str, found))}; call it for each of them")
        names = sorted(set(self.regions[region].names.values())) if region in self.regions else []
        known = f"its edges are named {', '.join(map(repr, names))}" if names else "its edges have no names; name_edge() gives one, and left, right, bottom, top are edges there"
        raise ArgumentError(f"{caller}: no edge of region {region} has the name {edge!r}; {known}")

    def called(self, what: str, number: int) -> str:
        """Region 2 ("middle"): what it is, its number and, if it has one, its name."""
        name = self.names.get((what, number))
        return f"{what} {number}" + (f' ("{name}")' if name else "")

    def across_plane(self, region: int) -> float:
        """Stress across the plane over the sum of those in the plane; NaN where heat adds to it."""
        sketched = self.regions[region]
        plane, poisson_ratio = self.materials[sketched.material]
        return 0.0 if plane == "stress" else math.nan if sketched.heated else poisson_ratio

    def add_circle(self, region: int, centre: Place, radius: float, *, material: int = 0) -> None:
        """Four quarter circles, as a region of its own if it has a material, else as a hole of a region."""
        hole = material == 0
        sides = [(1, 0), (0, -1), (-1, 0), (0, 1)] if hole else [(1, 0), (0, 1), (-1, 0), (0, -1)]
        loop = [(centre[0] + radius * x, centre[1] + radius * y) for x, y in sides]
        if hole:
            self.regions[region].loops.append(loop)
        else:
            self.regions[region] = Region("BEM", loop, material)
        last = sum(map(len, self.regions[region].loops))
        self.regions[region].arcs.update({edge: Arc(centre, not hole) for edge in range(last - 3, last + 1)})

    def words(self) -> str:
        """What there is, counted."""
        kinds = [region.kind for region in self.regions.values()]
        detail = ", ".join(f"{kinds.count(kind)} {kind}" for kind in FACES if kind in kinds)
        parts = [counted(len(self.materials), "material"), counted(len(kinds), "region") + (f" ({detail})" if kinds else ""),
                 counted(len(self.cracks), "crack"), counted(len(self.supports), "support"), counted(len(self.loads), "load")]
        return ", ".join(parts)

    def svg(self) -> str:
        """The scene as a picture; empty if there is no region."""
        places = [place for region in self.regions.values() for loop in region.outlines() for place in loop]
        if not places:
            return ""
        (left, right), (low, high) = ((min(axis), max(axis)) for axis in zip(*places))
        scale = (WIDTH - 40) / max(right - left, high - low, 1e-300)
        height = max(60, math.ceil(scale * (high - low)) + 40)

        def path(line: Sequence[Place], close: bool = False) -> str:
            at = [f"{20 + scale * (x - left):.1f} {height - 20 - scale * (y - low):.1f}" for x, y in line]
            return "M" + "L".join(at) + ("Z" if close else "")

        def written(place: Place, words: str, colour: str, size: int = 10) -> str:
            x, y = path([place])[1:].split()
            return (f'<text x="{x}" y="{y}" font-size="{size}" text-anchor="middle" dominant-baseline="middle" paint-order="stroke" '
                    f'stroke="white" stroke-width="3" fill="{colour}">{html.escape(words)}</text>')

        drawn, labels = [], []
        for number, region in self.regions.items():
            outline = " ".join(path(loop, close=True) for loop in region.outlines())
            drawn.append(f'<path d="{outline}" fill="{FACES[region.kind]}" fill-rule="evenodd" stroke="{EDGE}">'
                         f"<title>{html.escape(self.called('region', number))} ({region.kind})</title></path>")
            labels += [written(region.middle(edge), region.names.get(edge, str(edge)), EDGE)
                       for edge in range(1, region.edge_count + 1) if region.edge_count <= MOST_NUMBERED]
        for crack, line in self.cracks.items():
            drawn.append(f'<path d="{path(line)}" fill="none" stroke="{CRACK}" stroke-width="2"><title>crack {crack}</title></path>')
        for what, marks, colour in (("load", self.loads, LOADED), ("support", self.supports, HELD)):
            for number, mark in marks.items():
                title = f"<title>{html.escape(f'{self.called(what, number)}: {mark.does}')}</title>"
                if mark.point is not None:
                    x, y = path([mark.point])[1:].split()
                    drawn.append(f'<circle cx="{x}" cy="{y}" r="4" fill="{colour}">{title}</circle>')
                elif mark.region in self.regions:
                    way = self.regions[mark.region].way(mark.edge)
                    if way:
                        drawn.append(f'<path d="{path(way)}" fill="none" stroke="{colour}" stroke-width="4">{title}</path>')
        size = f"{right - left:g} x {high - low:g}, from ({left:g}, {low:g}) to ({right:g}, {high:g})"
        labels.append(f'<text x="{WIDTH / 2:.0f}" y="{height - 5}" font-size="10" text-anchor="middle" fill="{EDGE}">{size}</text>')
        return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{height}" role="img">{"".join(drawn)}'
                f'{"".join(labels)}</svg>')

    def place_of(self, mark: Mark) -> str:
        """Where a support or load is, in words."""
        if mark.point is not None:
            return f"point ({mark.point[0]:g}, {mark.point[1]:g})"
        if mark.crack:
            return f"crack {mark.crack}"
        if not mark.edge:
            return self.called("region", mark.region)
        name = self.regions[mark.region].names.get(mark.edge) if mark.region in self.regions else None
        return f"edge {mark.edge}" + (f' ("{name}")' if name else "") + f" of {self.called('region', mark.region)}"

    def marks(self) -> list[tuple[str, str, str]]:
        """What each support and load is, where it is and what it does."""
        return [(self.called(what, number), self.place_of(mark), mark.does)
                for what, marks in (("support", self.supports), ("load", self.loads)) for number, mark in sorted(marks.items())]

    def page(self, sentence: str) -> str:
        """The picture above its sentence and a table of supports and loads, for notebooks."""
        keys = "".join(f'<span style="color:{colour}">&#9632;</span> {word} ' for word, colour in (
            ("held or moved", HELD), ("loaded", LOADED), ("crack", CRACK)))
        rows = "".join("<tr>" + "".join(f"<td>{html.escape(cell)}</td>" for cell in row) + "</tr>" for row in self.marks())
        table = f"<table>{rows}</table>" if rows else ""
        return f"<div>{self.svg()}<div>{html.escape(sentence)}</div><div><small>{keys}</small></div>{table}</div>"


def counted(number: int, word: str) -> str:
    """One crack, two cracks."""
    return f"{number} {word}" + ("" if number == 1 else "s")
