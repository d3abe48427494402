"""The boundary of a finite element mesh, read by meshio."""

from __future__ import annotations

import contextlib
import io
import math
import pathlib
from typing import Any, Optional

import numpy as np
import numpy.typing as npt

from ._curves import distances_from_arc, distances_from_line
from ._loops import Loop, loop_of, Piece
from ._sketch import arc_through
from .errors import ArgumentError, FileError

FloatArray = npt.NDArray[np.float64]

#: Nodes along the sides of plane cells, corner, middle nodes if there are any, next corner.
SIDES = {"triangle": ((0, 1), (1, 2), (2, 0)), "quad": ((0, 1), (1, 2), (2, 3), (3, 0)),
         "triangle6": ((0, 3, 1), (1, 4, 2), (2, 5, 0)), "quad8": ((0, 4, 1), (1, 5, 2), (2, 6, 3), (3, 7, 0)),
         "quad9": ((0, 4, 1), (1, 5, 2), (2, 6, 3), (3, 7, 0))}
QUARTER = math.tan(math.pi / 8)  # bulge of a quarter of a circle, the longest arc that is made of sides
CORNER = math.radians(40)  # turns of the boundary by more are corners


class Sides:
    """Sides of the boundary: rows of nodes, and the name of each."""

    def __init__(self, places: FloatArray, rows: list[tuple[int, ...]], names: dict[frozenset[int], str], file: str) -> None:
        self.places, self.rows, self.names, self.file = places, rows, names, file

    def size(self) -> float:
        """Larger side of the box around the boundary."""
        return float(np.ptp(self.places[sorted({node for row in self.rows for node in row})], axis=0).max())

    def loops(self, tolerance: float) -> tuple[list[Loop], float]:
        """Outlines of straight edges and arcs, and the largest distance of a node from them."""
        found, worst = [], 0.0
        for chain in self._chains():
            nodes = [node for row in chain for node in row[:-1]]
            names = [self.names.get(frozenset((row[0], row[-1])), "") for row in chain for _ in row[:-1]]
            loop, deviation = self._edges(nodes, names, tolerance)
            found.append(loop)
            worst = max(worst, deviation)
        return found, worst

    def _chains(self) -> list[list[tuple[int, ...]]]:
        """Closed chains of sides."""
        after: dict[int, tuple[int, ...]] = {}
        for row in self.rows:
            if row[0] in after:
                x, y = self.places[row[0]]
                raise ArgumentError(f"from_mesh: {self.file}: the boundary touches itself at node {row[0] + 1}, ({x:g}, {y:g}); choose "
                                    "a body that does not, with part=")
            after[row[0]] = row
        chains = []
        while after:
            start = next(iter(after))
            chain = [after.pop(start)]
            while chain[-1][-1] != start:
                chain.append(after.pop(chain[-1][-1]))
            chains.append(chain)
        return chains

    def _edges(self, nodes: list[int], names: list[str], tolerance: float) -> tuple[Loop, float]:
        """Edges of one loop: its nodes are joined to runs on a line or a circle."""
        count, size = len(nodes), self.size()
        points = self.places[nodes]
        ahead = np.roll(points, -1, axis=0) - points
        turns = np.abs(np.angle(np.exp(1j * (np.arctan2(*ahead.T[::-1]) - np.roll(np.arctan2(*ahead.T[::-1]), 1)))))
        corner = (turns > CORNER) | np.array([names[k] != names[k - 1] for k in range(count)])
        first = int(np.argmax(corner)) if corner.any() else longest_line(points, 1e-6 * size)
        order = [(first + k) % count for k in range(count)] + [first]
        pieces, worst, at = [], 0.0, 0
        while at < count:
            last = next((k for k in range(at + 1, count) if corner[order[k]]), count)
            end, bulge, deviation = run_of(points[order], at, last, 1e-6 * size, tolerance)
            start_node, end_node = nodes[order[at]], nodes[order[end]]
            label = f"the side of nodes {start_node + 1} and {end_node + 1}"
            a, b = points[order[at]], points[order[end]]
            pieces.append(Piece(label, names[order[at]], [(float(a[0]), float(a[1])), (float(b[0]), float(b[1]))], [bulge]))
            worst, at = max(worst, deviation), end
        return loop_of(pieces), worst


def longest_line(points: FloatArray, close: float) -> int:
    """Where the longest straight part of a smooth outline begins; 0 if there is none."""
    count = len(points)
    straight = [distances_from_line(points[[(k + step) % count for step in (-1, 0, 1)]]) <= close for k in range(count)]
    if all(straight) or not any(straight):
        return 0
    begin = next(k for k in range(count) if not straight[k - 1] and straight[k])
    best, length, here = begin, 0, 0
    for k in range(begin, begin + count):
        here = here + 1 if straight[k % count] else 0
        if here > length:
            best, length = k - here, here
    return best % count


def run_of(points: FloatArray, start: int, last: int, close: float, tolerance: float) -> tuple[int, float, float]:
    """The end of the longest edge that begins at a node, its bulge, and the distance of its nodes."""
    line = start + 1
    while line < last and distances_from_line(points[start:line + 2]) <= close:
        line += 1
    arc, bulge, deviation = line, 0.0, distances_from_line(points[start:line + 1])
    if line - start >= 3 or last - start < 3:
        return arc, bulge, deviation
    for end in range(start + 3, last + 1):
        fitted = arc_of(points[start:end + 1], tolerance)
        if fitted is None:
            break
        arc, (bulge, deviation) = end, fitted
    return arc, bulge, deviation


def arc_of(points: FloatArray, tolerance: float) -> Optional[tuple[float, float]]:
    """Bulge of the arc from the first to the last place that passes through all, and their distance from it."""
    a, b, c = (tuple(map(float, points[k])) for k in (0, len(points) // 2, -1))
    circle = arc_through((a[0], a[1]), (b[0], b[1]), (c[0], c[1]))
    if circle is None:
        return None
    radius = math.dist(circle.centre, a)
    chord = math.dist(a, c)
    side = (c[0] - a[0]) * (b[1] - a[1]) - (c[1] - a[1]) * (b[0] - a[0])
    height = radius - math.copysign(math.sqrt(max(0.0, radius**2 - chord**2 / 4)), (b[0] - a[0]) * (c[0] - b[0]) + (b[1] - a[1]) * (c[1] - b[1]))
    if chord == 0 or 2 * height > chord * QUARTER * (1 + 1e-6):
        return None  # more than a quarter of a circle
    bulge = math.copysign(2 * height / chord, -side)
    deviation = float(distances_from_arc(points, points[0], points[-1], bulge).max())
    steps = np.hypot(*np.diff(points, axis=0).T)
    # One long side says nothing of an arc.
    return (bulge, deviation) if deviation <= tolerance and steps.max() < 0.5 * chord else None


def boundary(meshio: Any, file: pathlib.Path, part: Optional[str]) -> Sides:
    """Sides that belong to one cell only."""
    try:
        # meshio writes what it thinks of a file to the terminal.
        with contextlib.redirect_stdout(io.StringIO()):
            mesh = meshio.read(str(file))
    except (OSError, KeyError, ValueError, IndexError, AssertionError, SystemExit, meshio.ReadError) as problem:
        raise FileError(f"from_mesh: {file} cannot be read as a mesh: {problem}") from None
    if mesh.points.shape[1] == 3 and np.ptp(mesh.points[:, 2]) > 1e-9 * max(1e-300, float(np.ptp(mesh.points[:, :2]))):
        raise ArgumentError(f"from_mesh: {file.name} is not plane: z goes from {mesh.points[:, 2].min():g} to "
                            f"{mesh.points[:, 2].max():g}")
    places = np.asarray(mesh.points[:, :2], dtype=np.float64)
    rows = outer_sides([row for cells in chosen_cells(mesh, file.name, part) for row in turned(cells, places)])
    return Sides(places, rows, names_of(mesh, rows), file.name)


def chosen_cells(mesh: Any, file: str, part: Optional[str]) -> list[tuple[str, Any]]:
    """Plane cells of the body by their kind."""
    blocks = [(block.type, np.asarray(block.data)) for block in mesh.cells]
    physical = mesh.cell_data.get("gmsh:physical")
    surfaces = {name: int(value[0]) for name, value in mesh.field_data.items() if int(value[1]) == 2}
    named = set(surfaces) | {name for name, sets in mesh.cell_sets.items() if not name.startswith("gmsh:") and
                             any(one is not None and len(one) and kind in SIDES for one, (kind, _) in zip(sets, blocks))}
    if part is not None and part not in named:
        raise ArgumentError(f"from_mesh: {file} has no physical surface or element set {part!r}; it has "
                            f"{', '.join(map(repr, sorted(named))) or 'none'}")
    found = []
    for k, (kind, data) in enumerate(blocks):
        if kind not in SIDES:
            continue
        if part in surfaces and physical is not None:
            data = data[np.asarray(physical[k]) == surfaces[part]]
        elif part is not None:
            members = mesh.cell_sets[part][k]
            data = data[np.asarray(members, dtype=np.int64)] if members is not None and len(members) else data[:0]
        if len(data):
            found.append((kind, data))
    if not found:
        kinds = ", ".join(sorted({kind for kind, _ in blocks})) or "none"
        raise ArgumentError(f"from_mesh: {file} has no triangle or quadrilateral; its cells are: {kinds}")
    return found


def turned(cells: tuple[str, Any], places: FloatArray) -> list[tuple[int, ...]]:
    """Sides of cells, counter-clockwise around each."""
    kind, data = cells
    found = []
    corners = places[data[:, : 4 if kind.startswith("quad") else 3]]
    x, y = np.moveaxis(corners, 2, 0)
    clockwise = (x * np.roll(y, -1, axis=1) - np.roll(x, -1, axis=1) * y).sum(axis=1) < 0
    for cell, backwards in zip(data, clockwise):
        for side in SIDES[kind]:
            row = tuple(int(cell[node]) for node in side)
            found.append(row[::-1] if backwards else row)
    return found


def outer_sides(rows: list[tuple[int, ...]]) -> list[tuple[int, ...]]:
    """Sides that occur once."""
    count: dict[frozenset[int], int] = {}
    for row in rows:
        key = frozenset((row[0], row[-1]))
        count[key] = count.get(key, 0) + 1
    return [row for row in rows if count[frozenset((row[0], row[-1]))] == 1]


def names_of(mesh: Any, rows: list[tuple[int, ...]]) -> dict[frozenset[int], str]:
    """Names of sides: of physical lines, else of sets of line elements, else of sets of nodes."""
    found: dict[frozenset[int], str] = {}
    sides = {frozenset((row[0], row[-1])) for row in rows}
    for name, members in sorted(mesh.point_sets.items(), key=lambda item: -len(item[1])):
        nodes = set(map(int, np.asarray(members).ravel()))
        # Small sets come last, so that a set of the whole boundary does not hide the names of its parts.
        found.update({side: name for side in sides if side <= nodes})
    lines = {int(value[0]): name for name, value in mesh.field_data.items() if int(value[1]) == 1}
    physical = mesh.cell_data.get("gmsh:physical")
    for k, block in enumerate(mesh.cells):
        if not block.type.startswith("line"):
            continue
        if physical is not None:
            for row, number in zip(block.data, physical[k]):
                if int(number) in lines:
                    found[frozenset((int(row[0]), int(row[1])))] = lines[int(number)]
        for name, sets in mesh.cell_sets.items():
            if not name.startswith("gmsh:") and sets[k] is not None:
                for element in np.asarray(sets[k], dtype=np.int64):
                    found[frozenset((int(block.data[element][0]), int(block.data[element][1])))] = name
    return found
