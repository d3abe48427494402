"""Boundary-element regions as triangles that cracks part: the outline with its mouths, and both faces of every crack."""

from __future__ import annotations

import dataclasses
from typing import Any, Protocol

import numpy as np
import numpy.typing as npt
from matplotlib.path import Path
from matplotlib.tri import Triangulation

from ._names import Face
from .errors import ArgumentError
from .reports import PathVertex, PointValues

FloatArray = npt.NDArray[np.float64]
IntArray = npt.NDArray[np.int32]


class Cracked(Protocol):
    """What faces of cracks are asked of."""

    def crack_count(self) -> int: ...

    def crack_path(self, crack: int) -> list[PathVertex]: ...

    def evaluate_in(self, region: int, points: npt.ArrayLike, *, face: Face = "left", stress: bool = True) -> PointValues: ...


@dataclasses.dataclass
class Rim:
    """Places along the boundary."""

    shape: FloatArray  #: shape (places, nodes): weights of the nodes
    loops: list[IntArray]  #: closed; at a mouth of a crack two places lie at one position, one behind the other
    lines: list[IntArray]  #: what is drawn: loops, or parts of them between mouths
    mouths: list[tuple[int, int]]  #: places before and behind each mouth, the body on the left


@dataclasses.dataclass
class Run:
    """A part of a crack inside a region, with places along it."""

    points: FloatArray  #: shape (n, 2)
    known: npt.NDArray[np.bool_]  #: shape (n,): places where both faces have values; not at tips and kinks


@dataclasses.dataclass
class Mesh:
    """Triangles of a region; the places of the rim come first."""

    points: FloatArray
    values: FloatArray  #: shape (n, 5): displacement and stress
    triangles: IntArray
    faces: list[IntArray]  #: lines along faces of cracks
    cracks: FloatArray  #: shape (k, 2, 2): segments of cracks


def rim_of(nodes: FloatArray, elements: IntArray, step: float) -> Rim:
    """Chains of elements joined to loops: by their nodes, and where a crack has its mouth by the place of the nodes there."""
    weights: list[FloatArray] = []
    breaks = [k for k in range(len(elements)) if k == 0 or elements[k, 0] != elements[k - 1, 2]]
    chains = [elements[a:b] for a, b in zip(breaks, [*breaks[1:], len(elements)])]
    places = [chain_places(nodes, chain, step, weights) for chain in chains]
    begins = {int(chain[0, 0]): k for k, chain in enumerate(chains)}
    after, mouths = {}, []
    for k, chain in enumerate(chains):
        end = int(chain[-1, 2])
        if end in begins:
            after[k] = begins[end]
            continue
        weights.append(one_node(len(nodes), end))
        places[k].append(len(weights) - 1)
        free = [other for other, start in enumerate(int(one[0, 0]) for one in chains)
                if np.hypot(*(nodes[start] - nodes[end])) <= 1e-9 * step and start != end]
        if free:
            after[k] = free[0]
            mouths.append((places[k][-1], places[free[0]][0]))
    loops, lines, left = [], [], set(range(len(chains)))
    while left:
        here = min(left)
        loop: list[int] = []
        parts: list[list[int]] = [[]]
        while here in left:
            left.discard(here)
            loop += places[here]
            parts[-1] += places[here]
            if any(before == places[here][-1] for before, _ in mouths):
                parts.append([])
            here = after.get(here, here)
        if len(parts) > 1:
            parts = [*parts[1:-1], parts[-1] + parts[0]]  # the first part goes on from the last one
        else:
            parts[0].append(parts[0][0])
        loops.append(np.array(loop, dtype=np.int32))
        lines += [np.array(part, dtype=np.int32) for part in parts if part]
    return Rim(np.array(weights), loops, lines, mouths)


def chain_places(nodes: FloatArray, chain: IntArray, step: float, weights: list[FloatArray]) -> list[int]:
    """Add places along a chain of elements, without its end."""
    added = []
    for start, middle, end in chain:
        parts = max(2, int(np.ceil(np.linalg.norm(nodes[end] - nodes[start]) / step)))
        for t in np.arange(parts) / parts:
            row = np.zeros(len(nodes))
            row[[start, middle, end]] = (1 - t) * (1 - 2 * t), 4 * t * (1 - t), t * (2 * t - 1)
            added.append(len(weights))
            weights.append(row)
    return added


def one_node(count: int, node: int) -> FloatArray:
    """Weights of a place that is a node."""
    row = np.zeros(count)
    row[node] = 1
    return row


def mesh_of(model: Any, region: int, rim: Rim, nodes: FloatArray, values: FloatArray, step: float) -> Mesh:
    """Triangles of each piece of a region."""
    points, of_places = [rim.shape @ nodes], [rim.shape @ values]
    triangles: list[IntArray] = []
    faces: list[IntArray] = []
    edge = points[0]
    runs, segments = runs_of(model, edge, rim, step)
    for loops in parts_of(edge, rim.loops):
        inner_runs = [run for run in runs if inside(run.points[len(run.points) // 2][None], edge, loops)[0]]
        add_part(model, region, rim, loops, inner_runs, step, points, of_places, triangles, faces)
    joined = np.concatenate(triangles) if triangles else np.empty((0, 3), dtype=np.int32)
    return Mesh(np.vstack(points), np.vstack(of_places), joined, faces, segments)


def parts_of(edge: FloatArray, loops: list[IntArray]) -> list[list[IntArray]]:
    """Outer loops with their holes."""
    outer = [loop for loop in loops if area(edge[loop]) > 0]
    parts = [[loop] for loop in outer]
    for loop in loops:
        if area(edge[loop]) > 0:
            continue
        around = [part for part in parts if Path(edge[part[0]]).contains_point(edge[loop].mean(axis=0))]
        if around:
            min(around, key=lambda part: area(edge[part[0]])).append(loop)
    return parts


def area(polygon: FloatArray) -> float:
    """Area, negative if clockwise."""
    x, y = (polygon - polygon[0]).T
    return float(0.5 * (np.dot(x, np.roll(y, -1)) - np.dot(np.roll(x, -1), y)))


def inside(places: FloatArray, edge: FloatArray, loops: list[IntArray]) -> npt.NDArray[np.bool_]:
    """Whether places lie inside an odd number of loops."""
    result = np.zeros(len(places), dtype=bool)
    for loop in loops:
        result ^= Path(edge[np.append(loop, loop[0])], closed=True).contains_points(places)
    return result


def runs_of(model: Cracked, edge: FloatArray, rim: Rim, step: float) -> tuple[list[Run], FloatArray]:
    """Parts of cracks inside a region, and all segments of cracks in it or along cuts, which are boundary already."""
    found: list[Run] = []
    segments = []
    for crack in range(1, model.crack_count() + 1):
        path = np.array([(vertex.x, vertex.y) for vertex in model.crack_path(crack)]).reshape(-1, 2)
        current: list[FloatArray] = []
        for a, b in zip(path, path[1:]):
            middle = 0.5 * (a + b)
            on_cut = distance_to_rim(middle, edge, rim) <= 1e-6 * step
            within = bool(inside(middle[None], edge, rim.loops)[0]) and not on_cut
            if within or on_cut:
                segments.append((a, b))
            if within:
                current = [*(current or [a]), b]
            if not within and current:
                found.append(sampled(current, step))
                current = []
        if current:
            found.append(sampled(current, step))
    return found, np.array(segments, dtype=np.float64).reshape(-1, 2, 2)


def distance_to_rim(place: FloatArray, edge: FloatArray, rim: Rim) -> float:
    """Distance of a place from the outline."""
    best = np.inf
    for loop in rim.loops:
        a, b = edge[loop], edge[np.roll(loop, -1)]
        along = b - a
        length = np.maximum((along**2).sum(axis=1), 1e-300)
        t = np.clip(((place - a) * along).sum(axis=1) / length, 0, 1)
        best = min(best, float(np.hypot(*(a + t[:, None] * along - place).T).min()))
    return best


def sampled(path: list[FloatArray], step: float) -> Run:
    """Places along a path: its vertices, and others between them."""
    lengths = [float(np.hypot(*(b - a))) for a, b in zip(path, path[1:])]
    spacing = min(0.5 * step, sum(lengths) / 12)
    points, known = [path[0]], [False]
    for a, b, length in zip(path, path[1:], lengths):
        count = max(2, int(np.ceil(length / spacing)))
        points += [a + (b - a) * k / count for k in range(1, count + 1)]
        known += [True] * (count - 1) + [False]
    return Run(np.array(points), np.array(known))


def face_values(model: Cracked, region: int, run: Run, face: Face) -> FloatArray:
    """Displacement and stress along a face; at tips and kinks those of the neighbours."""
    values = np.full((len(run.points), 5), np.nan)
    for k in np.flatnonzero(run.known):
        # One place at a time: a place near another crack's tip may be refused.
        try:
            one = model.evaluate_in(region, run.points[k][None], face=face)
        except ArgumentError:
            continue
        values[k] = np.concatenate([one.displacement[0], np.asarray(one.stress)[0]])
    have = np.flatnonzero(~np.isnan(values[:, 0]))
    if not len(have):
        return np.zeros_like(values)
    at = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(run.points, axis=0).T))])
    return np.stack([np.interp(at, at[have], values[have, k]) for k in range(5)], axis=1)


def add_part(model: Any, region: int, rim: Rim, loops: list[IntArray], runs: list[Run], step: float, points: list[FloatArray],
             values: list[FloatArray], triangles: list[IntArray], faces: list[IntArray]) -> None:
    """Add the places and triangles of a piece with its holes."""
    edge = points[0]
    behind = {second for _, second in rim.mouths}
    used = [int(place) for loop in loops for place in loop if place not in behind]
    # Copies of places on the left and on the right of a crack, and the directions of the crack before and behind them.
    sides: dict[int, tuple[int, int, FloatArray, FloatArray]] = {}
    taken = edge[used]
    for run in runs:
        used += add_run(model, region, run, rim, points, values, sides, faces, taken, step)
        taken = np.vstack([taken, run.points])
    inner = grid_inside(edge, loops, taken, step)
    if len(inner):
        first = sum(map(len, points))
        found = model.evaluate(inner)
        points.append(inner)
        values.append(np.hstack([found.displacement, np.asarray(found.stress)]))
        used += range(first, first + len(inner))
    every = np.vstack(points)
    places = every[used]
    corners = Triangulation(*places.T).triangles
    centres = places[corners].mean(axis=1)
    first_side, second_side = places[corners[:, 1]] - places[corners[:, 0]], places[corners[:, 2]] - places[corners[:, 0]]
    size = np.abs(first_side[:, 0] * second_side[:, 1] - first_side[:, 1] * second_side[:, 0])
    # Triangles that join boundary points only are left out if they lie in notches, in holes or along edges.
    kept = inside(centres, edge, loops) & (size > 1e-9 * step**2)
    chosen = np.array(used, dtype=np.int32)[corners[kept]]
    for k, (row, centre) in enumerate(zip(chosen, centres[kept])):
        for j, place in enumerate(row):
            if int(place) in sides:
                left, right, before, after = sides[int(place)]
                chosen[k, j] = left if is_left(centre - every[place], before, after) else right
    triangles.append(chosen)


def add_run(model: Any, region: int, run: Run, rim: Rim, points: list[FloatArray], values: list[FloatArray],
            sides: dict[int, tuple[int, int, FloatArray, FloatArray]], faces: list[IntArray], taken: FloatArray,
            step: float) -> list[int]:
    """Add both faces of a part of a crack; returns the places that are to be joined by triangles."""
    count = len(run.points)
    first = sum(map(len, points))
    sides_of: tuple[Face, Face] = ("left", "right")
    by_face = {face: face_values(model, region, run, face) for face in sides_of}
    points += [run.points, run.points]
    directions = np.diff(run.points, axis=0)
    left, right = list(range(first, first + count)), list(range(first + count, first + 2 * count))
    added = []
    for k in range(count):
        before, after = directions[max(k - 1, 0)], directions[min(k, count - 2)]
        end = k in (0, count - 1)
        if end and (mouth := mouth_at(run.points[k], rim, points[0], step)) is not None:
            # The body is on the outline's left: a crack that begins at its mouth has the place before the mouth on its left.
            left[k], right[k] = mouth if k == 0 else mouth[::-1]
            sides[mouth[0]] = (left[k], right[k], before, after)
        elif np.hypot(*(taken - run.points[k]).T).min() <= 1e-9 * step:
            continue  # on the outline or on another crack, which have a place there
        elif end:
            right[k] = left[k]
            middle = 0.5 * (by_face["left"][k] + by_face["right"][k])
            middle[2:] = stress_ahead(model, run.points[k] + 0.6 * (after if k else -before), middle[2:])
            by_face["left"][k] = by_face["right"][k] = middle
            added.append(left[k])
        else:
            sides[left[k]] = (left[k], right[k], before, after)
            added.append(left[k])
    values += [by_face["left"], by_face["right"]]
    faces += [np.array(left, dtype=np.int32), np.array(right, dtype=np.int32)]
    return added


def stress_ahead(model: Any, place: FloatArray, otherwise: FloatArray) -> FloatArray:
    """Stress a little ahead of a tip, where it is unbounded; faces beside it bear none and would hide that."""
    try:
        found: FloatArray = np.asarray(model.evaluate(place[None]).stress)[0]
    except ArgumentError:
        return otherwise
    return found


def mouth_at(place: FloatArray, rim: Rim, edge: FloatArray, step: float) -> tuple[int, int] | None:
    """The places before and behind a mouth."""
    for before, behind in rim.mouths:
        if np.hypot(*(edge[before] - place)) <= 1e-6 * step:
            return before, behind
    return None


def is_left(way: FloatArray, before: FloatArray, after: FloatArray) -> bool:
    """Whether a way from a vertex leads to the left of a path that comes along `before` and goes on along `after`."""
    ahead, back = np.arctan2(after[1], after[0]), np.arctan2(-before[1], -before[0])
    sector = (back - ahead) % (2 * np.pi)
    return bool((np.arctan2(way[1], way[0]) - ahead) % (2 * np.pi) < sector)


def grid_inside(edge: FloatArray, loops: list[IntArray], taken: FloatArray, step: float) -> FloatArray:
    """Points of a grid inside, not closer to the outline and to cracks than half a step."""
    outer = edge[loops[0]]
    low, high = outer.min(axis=0), outer.max(axis=0)
    counts = np.maximum(np.ceil((high - low) / step), 1).astype(int)
    axes = [low[k] + (high[k] - low[k]) * np.arange(1, counts[k]) / counts[k] for k in range(2)]
    grid = np.stack(np.meshgrid(*axes), axis=-1).reshape(-1, 2)
    grid = grid[inside(grid, edge, loops)]
    far = np.array([np.min(np.hypot(*(taken - place).T)) > 0.6 * step for place in grid], dtype=bool)
    kept: FloatArray = grid[far]
    return kept
