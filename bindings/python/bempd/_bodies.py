"""Shapes and values of a model's regions as triangles, outlines and crack lines, ready to be drawn."""

from __future__ import annotations

import dataclasses
import itertools
import os
from typing import Any, Protocol, Union

import numpy as np
import numpy.typing as npt
from ._faces import mesh_of, rim_of
from ._names import Face, FieldName
from ._sketch import Sketch
from .reports import Bonds, BondState, Part, PathVertex, PointValues

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

    def evaluate_in(self, region: int, points: npt.ArrayLike, *, face: Face = "left", stress: bool = True) -> PointValues: ...

    def parts(self) -> list[Part]: ...

    def crack_count(self) -> int: ...

    def crack_path(self, crack: int) -> list[PathVertex]: ...

    def write_history(self, path: Union[str, "os.PathLike[str]"]) -> None: ...


@dataclasses.dataclass
class Body:
    """A region in its undeformed shape with the values at its points."""

    points: FloatArray  #: shape (n, 2)
    displacement: FloatArray  #: shape (n, 2)
    stress: FloatArray  #: shape (n, 3)
    damage: FloatArray  #: shape (n,); zero in BEM regions
    triangles: IntArray  #: shape (m, 3)
    outline: list[IntArray]  #: lines of points along the boundary of a BEM region; empty for a lattice
    nodes: IntArray  #: those of the points that are nodes
    cells: IntArray  #: shape (c, 4): lattice cells, and triangles with their last corner twice; empty in BEM regions
    cut: npt.NDArray[np.bool_]  #: shape (c,): cells that a crack cuts
    crack: FloatArray  #: shape (k, 2, 2): segments of the crack
    across: float  #: stress across the plane over xx + yy: Poisson's ratio in plane strain, 0 in plane stress; NaN if not known
    faces: list[IntArray] = dataclasses.field(default_factory=list)  #: lines of points along faces of cracks of a BEM region

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


def owner_of(model: Drawable, region: int) -> int:
    """The region that was added: the region itself, or the body from which a patch was cut."""
    return region if region in model._sketch.regions else model.parts()[model.region_ids.index(region)].body


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
                crack_segments(points, cells, broken[:, sides]), model._sketch.across_plane(owner_of(model, region)))


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
    """A region of boundary elements, with values at places inside and on both faces of its cracks."""
    nodes = model.field(region, "position")
    step = float(np.ptp(nodes, axis=0).min()) / resolution
    rim = rim_of(nodes, elements, step)
    values = np.hstack([model.field(region, "displacement"), model.field(region, "stress")])
    mesh = mesh_of(model, region, rim, nodes, values, step)
    return Body(mesh.points, mesh.values[:, :2], mesh.values[:, 2:], np.zeros(len(mesh.points)), mesh.triangles, rim.lines,
                node_places(rim.shape), np.empty((0, 4), dtype=np.int32), np.zeros(0, dtype=bool), mesh.cracks, model._sketch.across_plane(region), mesh.faces)


def node_places(weights: FloatArray) -> IntArray:
    """Places on the boundary that are nodes."""
    return np.flatnonzero(np.isclose(weights.max(axis=1), 1)).astype(np.int32)


def von_mises(body: Body) -> FloatArray:
    """The equivalent stress, with the stress across the plane; NaN where that is not known."""
    xx, yy, xy = body.stress.T
    zz = body.across * (xx + yy)
    found: FloatArray = np.sqrt(0.5 * ((xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2) + 3 * xy**2)
    return found


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
        "stress smallest principal": (xx + yy) / 2 - radius,
        "stress shear": radius,
        "stress von Mises": von_mises(body),
    }[quantity]
