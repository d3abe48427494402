"""Shapes and values of a model's regions as triangles, outlines and crack lines, ready to be drawn."""

from __future__ import annotations

import dataclasses
import itertools
import os
from typing import Any, Protocol, Union

import numpy as np
import numpy.typing as npt
from matplotlib.path import Path
from matplotlib.tri import Triangulation

from ._names import FieldName
from ._sketch import Sketch
from .reports import Bonds, BondState, PointValues

FloatArray = npt.NDArray[np.float64]
IntArray = npt.NDArray[np.int32]


class Drawable(Protocol):
    """What pictures need of a model, so that models can import pictures and not the other way round too."""

    @property
    def region_ids(self) -> list[int]: ...

    @property
    def load_factor(self) -> float: ...

    @property
    def _sketch(self) -> Sketch: ...

    def elements(self, region: int) -> IntArray: ...

    def field(self, region: int, name: FieldName) -> FloatArray: ...

    def bonds(self, region: int) -> Bonds: ...

    def evaluate(self, points: npt.ArrayLike, *, stress: bool = True) -> PointValues: ...

    def write_history(self, path: Union[str, "os.PathLike[str]"]) -> None: ...


@dataclasses.dataclass
class Body:
    """A region in its undeformed shape with the values at its points."""

    points: FloatArray  #: shape (n, 2)
    displacement: FloatArray  #: shape (n, 2)
    stress: FloatArray  #: shape (n, 3)
    damage: FloatArray  #: shape (n,); zero in BEM regions
    triangles: IntArray  #: shape (m, 3)
    outline: list[IntArray]  #: closed loops of points of a BEM region; empty for a lattice
    nodes: IntArray  #: those of the points that are nodes
    cells: IntArray  #: shape (c, 4): lattice cells, and triangles with their last corner twice; empty in BEM regions
    cut: npt.NDArray[np.bool_]  #: shape (c,): cells that a crack cuts
    crack: FloatArray  #: shape (k, 2, 2): segments of the crack

    @property
    def is_lattice(self) -> bool:
        """Whether the region is a peridynamic one."""
        return len(self.cells) > 0

    def shown(self, magnification: float) -> FloatArray:
        """The points in the deformed shape."""
        return self.points + magnification * self.displacement


def bodies(model: Drawable, resolution: int) -> list[Body]:
    """All regions; `resolution` is the number of places across a BEM region at which its interior is evaluated."""
    made = []
    for region in model.region_ids:
        elements = model.elements(region)
        make = lattice_body if elements.shape[1] == 4 else boundary_body
        made.append(make(model, region, elements, resolution))
    return made


def lattice_body(model: Drawable, region: int, cells: IntArray, resolution: int) -> Body:
    """A peridynamic region."""
    points = model.field(region, "position")
    bonds = model.bonds(region)
    parted = pair_keys(bonds.points[bonds.states != BondState.INTACT], len(points))
    pairs = list(itertools.combinations(range(4), 2))
    broken = np.stack([np.isin(pair_keys(cells[:, pair], len(points)), parted) for pair in pairs], axis=1)
    cut = broken.any(axis=1)
    sides = [pairs.index(side) for side in ((0, 1), (1, 2), (2, 3), (0, 3))]
    return Body(points, model.field(region, "displacement"), model.field(region, "stress"),
                model.field(region, "damage"), halves(cells), [], np.arange(len(points), dtype=np.int32), cells, cut,
                crack_segments(points, cells, broken[:, sides]))


def pair_keys(pairs: IntArray, count: int) -> npt.NDArray[np.int64]:
    """One number for each unordered pair of indices."""
    ordered = np.sort(pairs.astype(np.int64), axis=1)
    return ordered[:, 0] * count + ordered[:, 1]


def free_sides(cells: IntArray) -> IntArray:
    """Pairs of points of the sides that belong to one cell only."""
    sides = np.sort(np.concatenate([cells[:, [k, (k + 1) % 4]] for k in range(4)]), axis=1)
    sides = sides[sides[:, 0] != sides[:, 1]]
    unique, count = np.unique(sides, axis=0, return_counts=True)
    outer: IntArray = unique[count == 1]
    return outer


def halves(cells: IntArray) -> IntArray:
    """Two triangles for each cell; one for a cell whose last two corners are the same."""
    squares = cells[cells[:, 2] != cells[:, 3]]
    return np.concatenate([cells[:, [0, 1, 2]], squares[:, [0, 2, 3]]])


def crack_segments(points: FloatArray, cells: IntArray, broken: npt.NDArray[np.bool_]) -> FloatArray:
    """Lines through cells between the midpoints of broken sides; `broken` has a column for each side.

    Strains are small, so where a crack steps sideways between two rows of the lattice it leaves the bond along the step
    unstretched and whole: there two neighbours have one broken side each, and the line goes from one to the other.
    """
    middles = np.stack([(points[cells[:, k]] + points[cells[:, (k + 1) % 4]]) / 2 for k in range(4)], axis=1)
    count = broken.sum(axis=1)
    through = middles[count == 2][broken[count == 2]].reshape(-1, 2, 2)
    ends = np.flatnonzero(count == 1)
    # The shared side is next to the broken one; across the opposite side lies another stretch of the crack.
    steps = ends[neighbours(cells[ends], broken[ends] | np.roll(broken[ends], 2, axis=1), len(points))]
    across = middles[steps][broken[steps]].reshape(-1, 2, 2)
    # Branches meet in the cell's centre where three or four sides are broken; a tip inside a cell is in its centre.
    lone = (count > 2) | ((count == 1) & ~np.isin(np.arange(len(cells)), steps))
    cell, side = np.nonzero(broken & lone[:, None])
    return np.concatenate([through, across, np.stack([middles[cell, side], points[cells[cell]].mean(axis=1)], axis=1)])


def neighbours(cells: IntArray, left_out: npt.NDArray[np.bool_], count: int) -> npt.NDArray[np.int64]:
    """Pairs of cells that share a side which neither leaves out, shape (n, 2)."""
    keys = np.stack([pair_keys(cells[:, [k, (k + 1) % 4]], count) for k in range(4)], axis=1)
    keys = np.where(left_out, -1 - np.arange(keys.size).reshape(keys.shape), keys)
    _, group, times = np.unique(keys, return_inverse=True, return_counts=True)
    group = group.reshape(-1)
    shared = np.flatnonzero(times[group] == 2)
    return shared[np.argsort(group[shared], kind="stable")].reshape(-1, 2) // 4


def boundary_body(model: Drawable, region: int, elements: IntArray, resolution: int) -> Body:
    """A region of boundary elements, with values at places inside."""
    nodes = model.field(region, "position")
    step = float(np.ptp(nodes, axis=0).min()) / resolution
    outline, shape = boundary_places(nodes, elements, step)
    rim = shape @ nodes
    rim_values = shape @ np.hstack([model.field(region, "displacement"), model.field(region, "stress")])
    inner = interior_places(rim, outline, step)
    found = model.evaluate(inner) if len(inner) else None
    inner_values = np.empty((0, 5)) if found is None else np.hstack([found.displacement, np.asarray(found.stress)])
    points, values = np.vstack([rim, inner]), np.vstack([rim_values, inner_values])
    triangles = Triangulation(*points.T).triangles
    # Triangles that join boundary points only are left out if they lie in notches, in holes or along edges.
    corners = points[triangles]
    area = np.abs(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]))
    kept = inside(corners.mean(axis=1), rim, outline) & (area > 1e-9 * step**2)
    return Body(points, values[:, :2], values[:, 2:], np.zeros(len(points)), triangles[kept].astype(np.int32),
                [np.append(loop, loop[0]) for loop in outline], node_places(shape), np.empty((0, 4), dtype=np.int32),
                np.zeros(0, dtype=bool), np.empty((0, 2, 2)))


def boundary_places(nodes: FloatArray, elements: IntArray, step: float) -> tuple[list[IntArray], FloatArray]:
    """Loops of places on the boundary, and the weights of the nodes at each place."""
    weights: list[FloatArray] = []
    loops: list[list[int]] = []
    previous = -1
    for start, middle, end in elements:
        if start != previous:
            loops.append([])
        parts = max(2, int(np.ceil(np.linalg.norm(nodes[end] - nodes[start]) / step)))
        for t in np.arange(parts) / parts:
            row = np.zeros(len(nodes))
            row[[start, middle, end]] = (1 - t) * (1 - 2 * t), 4 * t * (1 - t), t * (2 * t - 1)
            loops[-1].append(len(weights))
            weights.append(row)
        previous = end
    return [np.array(loop, dtype=np.int32) for loop in loops], np.array(weights)


def node_places(weights: FloatArray) -> IntArray:
    """Places on the boundary that are nodes."""
    return np.flatnonzero(np.isclose(weights.max(axis=1), 1)).astype(np.int32)


def interior_places(rim: FloatArray, outline: list[IntArray], step: float) -> FloatArray:
    """Points of a grid inside, not closer to the boundary than half a step."""
    low, high = rim.min(axis=0), rim.max(axis=0)
    counts = np.ceil((high - low) / step).astype(int)
    axes = [low[k] + (high[k] - low[k]) * np.arange(1, counts[k]) / counts[k] for k in range(2)]
    grid = np.stack(np.meshgrid(*axes), axis=-1).reshape(-1, 2)
    grid = grid[inside(grid, rim, outline)]
    far = np.array([np.min(np.hypot(*(rim - place).T)) > 0.6 * step for place in grid], dtype=bool)
    kept: FloatArray = grid[far]
    return kept


def inside(places: FloatArray, rim: FloatArray, outline: list[IntArray]) -> npt.NDArray[np.bool_]:
    """Whether places lie inside an odd number of loops."""
    result = np.zeros(len(places), dtype=bool)
    for loop in outline:
        result ^= Path(rim[np.append(loop, loop[0])], closed=True).contains_points(places)
    return result


def quantity_values(body: Body, quantity: str) -> Any:
    """The values of a quantity at the points of a body."""
    xx, yy, xy = body.stress.T
    radius = np.hypot((xx - yy) / 2, xy)
    return {
        "damage": body.damage,
        "displacement": np.hypot(*body.displacement.T),
        "displacement x": body.displacement[:, 0],
        "displacement y": body.displacement[:, 1],
        "stress xx": xx,
        "stress yy": yy,
        "stress xy": xy,
        "stress principal": (xx + yy) / 2 + radius,
        "stress shear": radius,
    }[quantity]
