"""The part of a Model that answers questions: fields, bonds, reactions, history, files."""

from __future__ import annotations

import math
import os
from typing import Any, Optional, Sequence, Union

import numpy as np
import numpy.typing as npt

from . import _arguments as arguments
from ._arguments import FloatArray
from ._columns import read_columns
from ._handle import Handle
from ._names import Edge, Face, FieldName
from ._library import call, ffi, lib, new_struct, string
from ._sketch import Sketch
from ._words import in_python
from .errors import ArgumentError
from .tables import Rows
from .reports import (
    BodyPlan,
    Bonds,
    CrackExtension,
    CrackOpening,
    CrackTip,
    EdgeReaction,
    Errors,
    Explanation,
    Growth,
    Part,
    PathVertex,
    Piece,
    PointErrors,
    PointValues,
    RunErrors,
    Singularity,
    Statistics,
    SupportHistory,
    TipEnd,
    TipRecord,
    body_plan,
    crack_extension,
    crack_tip,
    error_sources,
    explained,
    model_part,
    path_vertex,
    rows,
    run_errors,
    singularity,
    values_of,
)

FIELDS = {
    "position": lib.BEMPD_POSITION,
    "displacement": lib.BEMPD_DISPLACEMENT,
    "stress": lib.BEMPD_STRESS,
    "damage": lib.BEMPD_DAMAGE,
    "traction": lib.BEMPD_TRACTION,
    "bond_stretch": lib.BEMPD_BOND_STRETCH,
    "element_stress": lib.BEMPD_ELEMENT_STRESS,
    "stress_order": lib.BEMPD_STRESS_ORDER,
}
FACES = {"left": lib.BEMPD_FACE_LEFT, "right": lib.BEMPD_FACE_RIGHT}
IntArray = npt.NDArray[np.int32]


class Results:
    """What can be asked of a model. Asking prepares it if need be.

    Fields are "position", "displacement", "stress" (xx, yy, xy), "damage" (PD), "traction" (BEM, at the three nodes of
    every element), "element_stress" (BEM, there too), "bond_stretch" (PD) and "stress_order" (0 where stress is
    bounded). There are three ways to a field:

    field()       a read-only array that keeps the values of the moment; asked again before the model changes, the same
                  array. Yours for as long as you like, whatever becomes of the model.
    copy_field()  an array of your own, or your array filled again.
    view_field()  the library's own memory, nothing copied. The array, and every slice of it, keeps the library's model
                  alive, also after close(). The memory would move when the model changes, so while such an array lives,
                  calls that change the model (steps, restore, new values of loads and supports) raise OrderError.
    """

    _handle: Optional[Handle]
    _sketch: Sketch
    _fields: dict[tuple[int, int], FloatArray]
    _fields_generation: int

    def _open(self) -> Handle:
        raise NotImplementedError

    def _number(self, name: str, kind: str, *arguments_before: Any) -> Any:
        result = ffi.new(f"{kind} *")
        self._open().call(name, *arguments_before, result)
        return result[0]

    @property
    def load_factor(self) -> float:
        """Present load factor."""
        return float(self._number("bempd_load_factor", "double"))

    @property
    def generation(self) -> int:
        """Number that changes whenever fields may have changed."""
        return int(self._number("bempd_generation", "int64_t"))

    def node_count(self, region: int) -> int:
        """Number of boundary nodes or material points of a region."""
        return int(self._number("bempd_node_count", "int64_t", region))

    def elements(self, region: int) -> IntArray:
        """Nodes of the boundary elements (n, 3), start, mid, end, or of the lattice cells (n, 4), counter-clockwise."""
        count = int(self._number("bempd_element_count", "int64_t", region))
        # Rows have room for the four corners of a cell; an element has three nodes and leaves the end as it is.
        nodes = np.full((count, 4), -1, dtype=np.int32)
        self._open().call("bempd_copy_elements", region, nodes.size, ffi.from_buffer("int32_t[]", nodes))
        if count and nodes[-1, -1] < 0:
            return nodes.reshape(-1)[: 3 * count].reshape(count, 3).copy()
        return nodes

    def field(self, region: int, name: FieldName) -> FloatArray:
        """A field as a read-only array of shape (n, components), or (n,) where there is one component.

        >>> import bempd
        >>> model = bempd.Model()
        >>> glass = model.add_material(young_modulus=3e9, poisson_ratio=1 / 3)
        >>> plate = model.add_bem_region(glass, bempd.rectangle(0, 0, 2, 1), element_length=0.25)
        >>> support = model.fix_edge(plate, 4, "x"), model.fix_point((0, 0), "y")
        >>> load = model.add_traction(plate, 2, "x", 3e6)
        >>> before = model.field(plate, "displacement")
        >>> report = model.step(1)
        >>> print(f"{before[:, 0].max():.4f} {model.field(plate, 'displacement')[:, 0].max():.4f}")
        0.0000 0.0020
        """
        generation = self.generation
        if self._fields_generation != generation:
            self._fields, self._fields_generation = {}, generation
        key = (arguments.whole("field: region", region), arguments.choice("field: name", name, FIELDS))
        if key not in self._fields:
            values = self.copy_field(region, name)
            values.flags.writeable = False
            # Asking may have prepared the model, which is a change.
            self._fields_generation = self.generation
            self._fields[key] = values
        return self._fields[key]

    def copy_field(self, region: int, name: FieldName, out: Optional[FloatArray] = None) -> FloatArray:
        """A field as an array of your own; `out` is filled and returned if given."""
        number = arguments.choice("copy_field: name", name, FIELDS)
        count, components = ffi.new("int64_t *"), ffi.new("int32_t *")
        self._open().call("bempd_field_size", region, number, count, components)
        shape = (count[0],) if components[0] == 1 else (count[0], components[0])
        if out is None:
            out = np.empty(shape)
        elif (not isinstance(out, np.ndarray) or out.shape != shape or out.dtype != np.float64
              or not out.flags.c_contiguous or not out.flags.writeable):
            raise ArgumentError(f"copy_field: out must be a writable, contiguous array of float64 of the shape {shape}")
        self._open().call("bempd_copy_field", region, number, out.size, ffi.from_buffer("double[]", out))
        return out

    def view_field(self, region: int, name: FieldName) -> FloatArray:
        """The library's own memory of a field, read-only and without a copy; see Results for what that costs."""
        number = arguments.choice("view_field: name", name, FIELDS)
        memory, count, components = self._open().view("bempd_view_field", region, number)
        values = np.frombuffer(memory, dtype=np.float64)
        return values if components == 1 else values.reshape(count, components)

    def bonds(self, region: int) -> Bonds:
        """Ends and states of all bonds of a PD region, also of broken ones."""
        count = int(self._number("bempd_bond_count", "int64_t", region))
        points, states = np.empty((count, 2), dtype=np.int32), np.empty(count, dtype=np.int32)
        self._open().call("bempd_copy_bonds", region, count, ffi.from_buffer("int32_t[]", points),
                          ffi.from_buffer("int32_t[]", states))
        return Bonds(points, states)

    def reaction(self, support: int) -> FloatArray:
        """Force [N] that a support exerts on the body, shape (2,)."""
        force = np.empty(2)
        self._open().call("bempd_reaction", support, ffi.from_buffer("double[]", force))
        return force

    def admissible_load_factors(self) -> tuple[float, float]:
        """Lowest and highest load factor that the body bears with its present bonds; the lowest is above the highest
        where there is none, and both are at the ends of the range of numbers where nothing bounds them."""
        lowest, highest = ffi.new("double *"), ffi.new("double *")
        self._open().call("bempd_admissible_load_factors", lowest, highest)
        return float(lowest[0]), float(highest[0])

    def explain(self, rising: bool = True) -> Explanation:
        """What breaks or grows next while the load factor rises or falls, and what holds other tips back. Printed, it is
        sentences."""
        explanation = new_struct("bempd_explanation", "bempd_explanation_init")
        needed = ffi.new("int64_t *")
        self._open().call("bempd_explain", int(rising), explanation, ffi.NULL, 0, needed)
        buffer = ffi.new("char[]", needed[0])
        self._open().call("bempd_explain", int(rising), explanation, buffer, needed[0], ffi.NULL)
        return explained(explanation, in_python(string(buffer)))

    def _conditions(self) -> list[tuple[object, ...]]:
        """What bempd.table() shows of a model: supports and loads, and the forces of supports once something was solved."""
        counted = self.statistics()
        is_solved = counted.solves > 0 and counted.boundary_nodes + counted.material_points > 0
        forces = [tuple(map(float, self.reaction(number))) if is_solved else (None, None) for number in sorted(self._sketch.supports)]
        forces += [(None, None)] * len(self._sketch.loads)
        return [(*mark, *force) for mark, force in zip(self._sketch.marks(), forces)]

    def reaction_moment(self, support: int, about: Sequence[float] = (0.0, 0.0)) -> float:
        """Moment [N m] about a place of the forces of a support on the body, positive counter-clockwise."""
        return float(self._number("bempd_reaction_moment", "double", support,
                                  *arguments.place("reaction_moment: about", about)))

    def edge_reaction(self, region: int, edge: Edge, about: Sequence[float] = (0.0, 0.0)) -> EdgeReaction:
        """Force and moment about a place that supports exert through one edge; corners are shared among edges."""
        edge = self._sketch.edge("edge_reaction", region, edge)
        force, moment = np.empty(2), ffi.new("double *")
        self._open().call("bempd_edge_reaction", region, edge, *arguments.place("edge_reaction: about", about),
                          ffi.from_buffer("double[]", force), moment)
        return EdgeReaction(force, float(moment[0]))

    def evaluate(self, points: npt.ArrayLike, *, stress: bool = True) -> PointValues:
        """Displacement, stress and region at places in the body; without `stress` it is faster."""
        places = arguments.point_array("evaluate: points", points)
        count = len(places)
        displacement, regions = np.empty((count, 2)), np.empty(count, dtype=np.int32)
        tensor = np.empty((count, 3)) if stress else None
        self._open().call("bempd_evaluate", count, arguments.doubles(places), arguments.doubles(displacement),
                          arguments.doubles(tensor), ffi.from_buffer("int32_t[]", regions))
        return PointValues(displacement, tensor, regions)

    def evaluate_in(self, region: int, points: npt.ArrayLike, *, face: Face = "left",
                    stress: bool = True) -> PointValues:
        """As evaluate(), as one region has it: on its side of interfaces, and on the "left" or "right" face of cracks."""
        places = arguments.point_array("evaluate_in: points", points)
        count = len(places)
        displacement, tensor = np.empty((count, 2)), np.empty((count, 3)) if stress else None
        self._open().call("bempd_evaluate_in", region, arguments.choice("evaluate_in: face", face, FACES), count,
                          arguments.doubles(places), arguments.doubles(displacement), arguments.doubles(tensor))
        return PointValues(displacement, tensor, np.full(count, region, dtype=np.int32))

    @property
    def piece_count(self) -> int:
        """Number of pieces that the body consists of; a material point without any bond is one too."""
        return int(self._number("bempd_piece_count", "int64_t"))

    def piece(self, number: int) -> Piece:
        """A piece, from 1; the one with the most nodes is the first."""
        struct = new_struct("bempd_piece", "bempd_piece_init")
        self._open().call("bempd_get_piece", number, struct)
        return Piece(**values_of(struct, "bempd_piece", Piece))

    def node_pieces(self, region: int) -> npt.NDArray[np.int32]:
        """Numbers of the pieces of the nodes of a region, shape (nodes,)."""
        pieces = np.empty(self.node_count(region), dtype=np.int32)
        self._open().call("bempd_copy_node_pieces", region, len(pieces), ffi.from_buffer("int32_t[]", pieces))
        return pieces

    def support_piece(self, support: int) -> int:
        """Number of the piece that a support holds; 0 if it holds nodes of several."""
        return int(self._number("bempd_support_piece", "int32_t", support))

    def load_piece(self, load: int) -> int:
        """Number of the piece that a load acts on, also while it is 0; 0 if it acts on several."""
        return int(self._number("bempd_load_piece", "int32_t", load))

    def are_connected(self, support: int, other: int) -> bool:
        """Whether two supports still hold the same piece.

        >>> import bempd
        >>> model = bempd.Model()
        >>> glass = model.add_material(young_modulus=3e9, poisson_ratio=1 / 3)
        >>> plate = model.add_pd_region(glass, bempd.rectangle(0, 0, 8, 4), spacing=1, horizon_ratio=2)
        >>> cut = model.add_crack([(4.5, 0), (4.5, 4)])
        >>> left, right = model.fix_edge(plate, 4), model.fix_edge(plate, 2)
        >>> model.are_connected(left, right), model.piece_count
        (False, 2)
        """
        return bool(self._number("bempd_are_connected", "int32_t", support, other))

    def stress_orders(self, points: npt.ArrayLike) -> npt.NDArray[np.float64]:
        """How strongly stress grows at places, shape (points,): 0 where it is bounded, else p where it grows as r^-p with
        the distance r, and what evaluate() gives there depends on the elements."""
        places = arguments.point_array("stress_orders: points", points)
        orders = np.empty(len(places))
        self._open().call("bempd_stress_orders", len(places), arguments.doubles(places), arguments.doubles(orders))
        return orders

    def singularities(self) -> list[Singularity]:
        """Places where stress is unbounded, so that its number there depends on the elements.

        >>> import bempd
        >>> model = bempd.Model()
        >>> glass = model.add_material(young_modulus=3e9, poisson_ratio=1 / 3)
        >>> corner = [(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)]
        >>> bracket = model.add_bem_region(glass, corner, element_length=0.25)
        >>> support = model.fix_edge(bracket, 5, "y"), model.fix_point((0, 0), "x")
        >>> [(place.kind.name, place.x, place.y, round(place.exponent, 4)) for place in model.singularities()]
        [('CORNER', 1.0, 1.0, 0.5445), ('POINT', 0.0, 0.0, 0.0)]
        """
        count = int(self._number("bempd_singularity_count", "int64_t"))
        found: Rows[Singularity] = Rows(called=self._sketch.called)
        for index in range(count):
            struct = new_struct("bempd_singularity", "bempd_singularity_init")
            self._open().call("bempd_get_singularity", index, struct)
            found.append(singularity(struct))
        return found

    def tips(self) -> list[CrackTip]:
        """Tips of cracks with their stress intensity factors, those in BEM regions first, by crack.

        >>> import bempd
        >>> model = bempd.Model()
        >>> glass = model.add_material(young_modulus=70e9, poisson_ratio=0.2)
        >>> plate = model.add_bem_region(glass, bempd.rectangle(-1, -3, 1, 3), element_length=0.25)
        >>> crack = model.add_crack([(-0.5, 0), (0.5, 0)])
        >>> support = model.fix_point((-1, -3)), model.fix_point((1, -3), "y")
        >>> loads = model.add_traction(plate, 3, "y", 1e6), model.add_traction(plate, 1, "y", -1e6)
        >>> report = model.step(1)
        >>> [f"{tip.stress_intensity_1:.4g}" for tip in model.tips()]
        ['1.487e+06', '1.487e+06']
        """
        count = int(self._number("bempd_tip_count", "int64_t"))
        found: Rows[CrackTip] = Rows()
        for index in range(count):
            struct = new_struct("bempd_crack_tip", "bempd_crack_tip_init")
            self._open().call("bempd_tip", index, struct)
            found.append(crack_tip(struct))
        return found

    def tip_history(self) -> list[TipRecord]:
        """The tips that were recorded: at every n-th event and at the ends of steps with the option tips.record = n.

        >>> import bempd
        >>> model = bempd.Model()
        >>> model.options["tips.record"] = 1
        >>> glass = model.add_material(young_modulus=70e9, poisson_ratio=0.2)
        >>> plate = model.add_bem_region(glass, bempd.rectangle(-1, -3, 1, 3), element_length=0.25)
        >>> crack = model.add_crack([(-0.5, 0), (0.5, 0)])
        >>> support = model.fix_point((-1, -3)), model.fix_point((1, -3), "y")
        >>> loads = model.add_traction(plate, 3, "y", 1e6), model.add_traction(plate, 1, "y", -1e6)
        >>> report = model.step(1), model.step(2)
        >>> [(record.load_factor, f"{record.tip.stress_intensity_1:.4g}") for record in model.tip_history()[::2]]
        [(1.0, '1.487e+06'), (2.0, '2.975e+06')]
        """
        event, broken, factor = ffi.new("int64_t *"), ffi.new("int64_t *"), ffi.new("double *")
        records: Rows[TipRecord] = Rows()
        for index in range(int(self._number("bempd_tip_history_count", "int64_t"))):
            struct = new_struct("bempd_crack_tip", "bempd_crack_tip_init")
            self._open().call("bempd_get_tip_history", index, event, broken, factor, struct)
            records.append(TipRecord(event[0], broken[0], factor[0], crack_tip(struct)))
        return records

    def grow_cracks(self, length: float) -> Growth:
        """Let the tips of cracks in BEM regions that reach their fracture energy first grow by a length [m].

        The load factor is solved for and the model is there afterwards, with the longer cracks; the history goes on.
        The options named growth.* choose criterion, direction and which tips grow together.
        """
        struct = new_struct("bempd_growth", "bempd_growth_init")
        self._open().call("bempd_grow_cracks", arguments.real("grow_cracks: length", length), struct, changes=True)
        return Growth(**values_of(struct, "bempd_growth", Growth))

    def set_tip_frozen(self, crack: int, end: TipEnd | int, frozen: bool = True) -> None:
        """Keep the tip at an end of a crack from growing, or let it grow again."""
        self._open().call("bempd_set_tip_frozen", crack, int(end), int(frozen))

    def extensions(self) -> list[CrackExtension]:
        """What every tip did at every event, in order."""
        found: Rows[CrackExtension] = Rows()
        for index in range(int(self._number("bempd_extension_count", "int64_t"))):
            struct = new_struct("bempd_crack_extension", "bempd_crack_extension_init")
            self._open().call("bempd_extension", index, struct)
            found.append(crack_extension(struct))
        return found

    def crack_count(self) -> int:
        """Number of cracks: those that were described and, with the next ids, those that began in the run."""
        return int(self._number("bempd_crack_count", "int64_t"))

    def crack_length(self, crack: int = 0) -> float:
        """Length [m] of a crack's path with what it has grown by; without a crack that of all together."""
        length = ffi.new("double *")
        self._open().call("bempd_crack_length", crack, length)
        return float(length[0])

    def crack_path(self, crack: int) -> list[PathVertex]:
        """Vertices of a crack from its start to its end: the described points, and those to which it has grown.

        >>> import bempd
        >>> model = bempd.Model()
        >>> glass = model.add_material(young_modulus=70e9, poisson_ratio=0.2, fracture_energy=8)
        >>> plate = model.add_bem_region(glass, bempd.rectangle(-1, -3, 1, 3), element_length=0.25)
        >>> crack = model.add_crack([(-1, 0), (0, 0)])
        >>> support = model.fix_point((-1, -3)), model.fix_point((1, -3), "y")
        >>> loads = model.add_traction(plate, 3, "y", 1e6), model.add_traction(plate, 1, "y", -1e6)
        >>> growth = model.grow_cracks(0.1)
        >>> [(round(vertex.x, 6), vertex.event) for vertex in model.crack_path(crack)]
        [(-1.0, 0), (0.0, 0), (0.1, 1)]
        """
        count = ffi.new("int64_t *")
        self._open().call("bempd_crack_path_count", crack, count)
        found: Rows[PathVertex] = Rows()
        for index in range(int(count[0])):
            struct = new_struct("bempd_path_vertex", "bempd_path_vertex_init")
            self._open().call("bempd_crack_path", crack, index, struct)
            found.append(path_vertex(struct))
        return found

    def crack_opening(self, crack: int, fractions: npt.ArrayLike) -> CrackOpening:
        """Openings [m] of a crack at places given as fractions of its length; NaN where they are not known."""
        places = np.ascontiguousarray(np.atleast_1d(fractions), dtype=np.float64)
        if places.ndim != 1:
            raise ArgumentError(f"crack_opening: fractions has shape {places.shape}; give a row of numbers")
        normal, tangential = np.empty(len(places)), np.empty(len(places))
        self._open().call("bempd_crack_opening", crack, len(places), arguments.doubles(places),
                          arguments.doubles(normal), arguments.doubles(tangential))
        return CrackOpening(normal, tangential)

    def plan(self) -> BodyPlan:
        """Elements, unknowns, memory, time and errors of a scene with bodies, before anything expensive is solved.

        Of a prepared model it has what has come.
        """
        struct = new_struct("bempd_body_plan", "bempd_body_plan_init")
        self._open().call("bempd_plan", struct)
        return body_plan(struct, tuple(self.parts()))

    def parts(self) -> list[Part]:
        """Parts of the model: its regions, then the lattice patches of its bodies, each with its outline."""
        found: Rows[Part] = Rows()
        for index in range(int(self._number("bempd_part_count", "int64_t"))):
            struct = new_struct("bempd_model_part", "bempd_part_init")
            self._open().call("bempd_part", index, struct)
            found.append(model_part(struct, tuple(self._part_outline(index, loop) for loop in range(struct.loops))))
        return found

    def _part_outline(self, index: int, loop: int) -> FloatArray:
        count = ffi.new("int64_t *")
        self._open().call("bempd_part_outline", index, loop, 0, ffi.NULL, count)
        points = np.empty((int(count[0]), 2))
        self._open().call("bempd_part_outline", index, loop, len(points), arguments.doubles(points), count)
        return points

    def error_estimate(self) -> Errors:
        """Errors of the present results by source; it solves the scene with longer elements."""
        struct = new_struct("bempd_errors", "bempd_errors_init")
        self._open().call("bempd_error_estimate", struct)
        return error_sources(struct)

    def evaluate_errors(self, points: npt.ArrayLike) -> PointErrors:
        """Errors of the displacements and stresses that evaluate() gives at places."""
        places = arguments.point_array("evaluate_errors: points", points)
        displacement, tensor = np.empty(len(places)), np.empty(len(places))
        self._open().call("bempd_evaluate_errors", len(places), arguments.doubles(places), arguments.doubles(displacement),
                          arguments.doubles(tensor))
        return PointErrors(displacement, tensor)

    def run_error_estimate(self, seconds_allowed: float = math.inf) -> RunErrors:
        """Errors of peak, paths and first growth of the run so far, which is run again with longer elements and extensions.

        With `seconds_allowed` = 0 nothing is run, and `expected_seconds` says how long it would take.
        """
        struct = new_struct("bempd_run_errors", "bempd_run_errors_init")
        self._open().call("bempd_run_error_estimate", seconds_allowed, struct)
        return run_errors(struct)

    def statistics(self) -> Statistics:
        """Sizes, counters and times so far."""
        struct = new_struct("bempd_statistics", "bempd_statistics_init")
        self._open().call("bempd_get_statistics", struct)
        return Statistics(**values_of(struct, "bempd_statistics", Statistics))

    def history(self) -> npt.NDArray[Any]:
        """One row for every event and end of a step, as a structured array: `model.history()["load_factor"]`.

        `model.history().dtype.names` has its columns; `event` is 0 at the end of a step. support_history() has
        what supports did; write_history() writes both, read_history() reads them.
        """
        count = int(self._number("bempd_history_count", "int64_t"))
        entries = ffi.new("bempd_history_entry[]", max(count, 1))
        for index in range(count):
            call("bempd_history_entry_init", entries + index, ffi.sizeof("bempd_history_entry"))
            self._open().call("bempd_get_history_entry", index, entries + index)
        return rows(entries, "bempd_history_entry")[:count]

    def support_history(self, support: int) -> SupportHistory:
        """What a support did, a row for every line of history(): displacements and forces, shape (n, 2)."""
        count = int(self._number("bempd_history_count", "int64_t"))
        displacement, force, before = (np.empty((count, 2)) for _ in range(3))
        for line in range(count):
            self._open().call("bempd_get_history_support", line, support, ffi.from_buffer("double[]", displacement[line]),
                              ffi.from_buffer("double[]", force[line]), ffi.from_buffer("double[]", before[line]))
        return SupportHistory(displacement, force, before)

    def write_snapshot(self, prefix: Union[str, "os.PathLike[str]"]) -> None:
        """Write the present state for ParaView, which opens PREFIX.pvd, the series of all snapshots.

        The folder must exist. Files of another run with this prefix raise FileError, unless the option
        "snapshots.existing" is "continue" or "replace". If edges, regions, supports or loads have names, a part "edges" shows
        them: edges and cracks as lines, held and loaded points as points.
        """
        self._open().call("bempd_write_snapshot", arguments.file_name("write_snapshot: prefix", prefix))

    def write_history(self, path: Union[str, "os.PathLike[str]"]) -> None:
        """Write history() and support_history() of all supports as comma-separated values. Columns of a support have its number
        and, if it has one, its name: reaction_x_1 (clamp)."""
        self._open().call("bempd_write_history", arguments.file_name("write_history: path", path))

    def write_tips(self, path: Union[str, "os.PathLike[str]"]) -> None:
        """Write what tip_history() has as comma-separated values; read_history() reads them."""
        self._open().call("bempd_write_tips", arguments.file_name("write_tips: path", path))


def read_history(path: Union[str, "os.PathLike[str]"]) -> npt.NDArray[Any]:
    """What Model.write_history() wrote as a structured array, with columns reaction_x_1, reaction_y_1, ...; or what
    Model.write_tips() wrote."""
    return read_columns(path)
