"""The part of a Model that hosts couple through: nodes of edges, forces on them, and values given there."""

from __future__ import annotations

from typing import Optional, Sequence

import numpy as np
import numpy.typing as npt

from . import _arguments as arguments
from ._arguments import FloatArray
from ._handle import Handle
from ._library import ffi
from ._names import Edge
from ._sketch import Mark, Sketch
from .reports import EdgeNodes, EdgePlaces


class Edges:
    """Edges as other programs see them. Values at nodes and places have the shape (n, 2): x and y of each.

    >>> import bempd
    >>> model = bempd.Model()
    >>> glass = model.add_material(young_modulus=3e9, poisson_ratio=1 / 3, thickness=0.01)
    >>> plate = model.add_bem_region(glass, bempd.rectangle(0, 0, 2, 1), element_length=0.5)
    >>> held, driven = model.fix_edge(plate, 4), model.prescribe_edge(plate, 2, "x", 0)
    >>> edge = model.edge_nodes(plate, 2)
    >>> model.set_support_nodal_values(driven, constant=[(2e-6, 0)] * len(edge.nodes))
    >>> report = model.step(1)
    >>> float(abs(model.edge_forces(plate, 2).sum(axis=0) - model.reaction(driven)).max()) < 1e-9
    True
    """

    _sketch: Sketch

    def _open(self) -> Handle:
        raise NotImplementedError

    def add_edge_forces(self, region: int, edge: Edge, *, part: Sequence[float] = (0.0, 1.0)) -> int:
        """Add forces [N] on the nodes of an edge or a part of it: 0 until set_load_nodal_values() gives each its own."""
        edge = self._sketch.edge("add_edge_forces", region, edge)
        added = ffi.new("int32_t *")
        self._open().call("bempd_add_edge_forces", region, edge, *arguments.fraction_pair("add_edge_forces: part", part),
                          added)
        self._sketch.loads[int(added[0])] = Mark(region, edge, does="forces on the nodes")
        return int(added[0])

    def set_support_nodal_values(self, support: int, proportional: Optional[npt.ArrayLike] = None, *,
                                 constant: Optional[npt.ArrayLike] = None) -> None:
        """Give every node that a support on an edge holds its displacement [m]: those of edge_nodes(), in that order."""
        count, *values = arguments.pair_values("set_support_nodal_values", constant, proportional)
        self._open().call("bempd_set_support_nodal_values", support, count, *values, changes=True)

    def set_load_nodal_values(self, load: int, proportional: Optional[npt.ArrayLike] = None, *,
                              constant: Optional[npt.ArrayLike] = None) -> None:
        """Give a load on an edge its values at the nodes there: forces [N] as they are, or tractions [Pa]."""
        count, *values = arguments.pair_values("set_load_nodal_values", constant, proportional)
        self._open().call("bempd_set_load_nodal_values", load, count, *values, changes=True)

    def set_support_values_at(self, support: int, fractions: npt.ArrayLike, proportional: Optional[npt.ArrayLike] = None,
                              *, constant: Optional[npt.ArrayLike] = None) -> None:
        """Give a support new displacements [m] at places along its part of an edge, ascending fractions of it, linear
        between them; also one that was given by a function."""
        places, count, *values = arguments.values_at("set_support_values_at", fractions, constant, proportional)
        self._open().call("bempd_set_support_values_at", support, count, places, *values, changes=True)

    def set_load_values_at(self, load: int, fractions: npt.ArrayLike, proportional: Optional[npt.ArrayLike] = None, *,
                           constant: Optional[npt.ArrayLike] = None) -> None:
        """Give a load along an edge or a crack new values at places; as set_support_values_at()."""
        places, count, *values = arguments.values_at("set_load_values_at", fractions, constant, proportional)
        self._open().call("bempd_set_load_values_at", load, count, places, *values, changes=True)

    def fractions_on_edge(self, region: int, edge: Edge, points: npt.ArrayLike) -> EdgePlaces:
        """The nearest places on an edge, such as for the nodes of another program's mesh."""
        edge = self._sketch.edge("fractions_on_edge", region, edge)
        places = arguments.point_array("fractions_on_edge: points", points)
        found = EdgePlaces(np.empty(len(places)), np.empty(len(places)))
        self._open().call("bempd_fractions_on_edge", region, edge, len(places), arguments.doubles(places),
                          *map(arguments.doubles, found))
        return found

    def edge_nodes(self, region: int, edge: Edge) -> EdgeNodes:
        """Nodes on an edge from its start to its end, with their weights; prepares the model."""
        edge = self._sketch.edge("edge_nodes", region, edge)
        count = self._edge_size(region, edge)[0]
        found = EdgeNodes(np.empty(count, dtype=np.int32), np.empty(count), np.empty(count))
        self._open().call("bempd_copy_edge_nodes", region, edge, count, ffi.from_buffer("int32_t[]", found.nodes),
                          arguments.doubles(found.fractions), arguments.doubles(found.weights))
        return found

    def edge_elements(self, region: int, edge: Edge) -> npt.NDArray[np.int32]:
        """Elements or lattice cells with a side on an edge, from its start to its end: rows of elements()."""
        edge = self._sketch.edge("edge_elements", region, edge)
        count = self._edge_size(region, edge)[1]
        found = np.empty(count, dtype=np.int32)
        self._open().call("bempd_copy_edge_elements", region, edge, count, ffi.from_buffer("int32_t[]", found))
        return found

    def edge_forces(self, region: int, edge: Edge) -> FloatArray:
        """Forces [N] that supports and neighbours exert on a region at the nodes of an edge: they do the work that is
        booked, and sum to the reaction to rounding. Shape (n, 2), as edge_nodes() has the nodes."""
        edge = self._sketch.edge("edge_forces", region, edge)
        count = self._edge_size(region, edge)[0]
        forces = np.empty((count, 2))
        self._open().call("bempd_copy_edge_forces", region, edge, count, arguments.doubles(forces))
        return forces

    def _edge_size(self, region: int, edge: int) -> tuple[int, int]:
        nodes, elements = ffi.new("int64_t *"), ffi.new("int64_t *")
        self._open().call("bempd_edge_size", region, edge, nodes, elements)
        return int(nodes[0]), int(elements[0])
