"""What steps, bonds and evaluations report."""

from __future__ import annotations

import dataclasses
import enum
from typing import Any, NamedTuple, Optional

import numpy as np
import numpy.typing as npt

from ._library import ffi, members
from .tables import table


class Named(enum.IntEnum):
    """A number with a name, by which it is printed."""

    def __str__(self) -> str:
        return self.name

    def __format__(self, form: str) -> str:
        return format(int(self) if form[-1:] in tuple("bcdeEfFgGnoxX%") else self.name, form)


class StopReason(Named):
    """Why a step ended."""

    LOAD_FACTOR = 1  #: the load factor asked for was reached
    EVENT = 2  #: one event happened
    SEPARATED = 3  #: the body is separated
    NO_FURTHER_EVENT = 4  #: no bond can break however far the load goes
    NO_ADMISSIBLE_LOAD = 5  #: on the equilibrium path: constant loads stretch bonds too far at every load factor
    NO_EQUILIBRIUM = 6  #: in increments: what breaks at the end of the next one leaves no equilibrium
    REQUESTED = 7  #: the end of the step was asked for, by request_stop() or Ctrl-C; the events before are kept
    CRACK_STOPPED = 8  #: a crack has come to an interface or to the border of its region, where it cannot go on


class BondState(enum.IntEnum):
    """State of a bond."""

    INTACT = 0
    BROKEN = 1
    CUT = 2  #: by an initial crack


class TipEnd(enum.IntEnum):
    """End of a crack."""

    START = 1  #: its first point
    END = 2


class TipState(enum.IntEnum):
    """What became of an end of a crack."""

    GROWS = 0  #: it is a tip
    AT_EDGE = 1  #: of the outer boundary
    AT_HOLE = 2
    AT_CRACK = 3
    AT_INTERFACE = 4  #: of another material, or the end of its region
    SEPARATED = 5  #: what lay ahead of it has come apart


class TipMethod(enum.IntEnum):
    """What the values of a tip come from."""

    ELEMENTS = 1  #: boundary elements on the crack
    CONTOURS = 2  #: rings around the tip in a peridynamic region
    STRESS = 3  #: the stress ahead of a crack that grows as a line, where no ring fits


class LoadRule(enum.IntEnum):
    """What the load factors at which a tip grows come from."""

    UNKNOWN = 0  #: nothing is known of them
    FACTORS = 1  #: its stress intensity factors
    FIT = 2  #: factors fitted to the stress ahead of a line in a lattice, corrected by the energy of its past steps
    ENERGY = 3  #: the energy of trial steps of a line, where that fit does not hold


class SingularityKind(enum.IntEnum):
    """Why stress is unbounded at a place."""

    CORNER = 1  #: of the boundary of one material, or where what supports hold changes
    INTERFACE = 2  #: where materials meet
    CRACK = 3  #: tip, kink or branch of a crack in a BEM region
    POINT = 4  #: held or loaded


@dataclasses.dataclass(frozen=True)
class Singularity:
    """A place where the stress of the elastic body is unbounded: it grows as r to the power of exponent - 1."""

    kind: SingularityKind
    region: int  #: id of a region there
    x: float  #: place [m]
    y: float
    exponent: float  #: of the displacement beside it; 1/2 at crack tips, 0 at points under a force
    oscillation: float  #: imaginary part of the exponent


@dataclasses.dataclass(frozen=True)
class CrackTip:
    """The tip of a crack; bempd_crack_tip in the C header says how its values are found and how good they are."""

    crack: int  #: id
    end: TipEnd
    x: float  #: place [m]
    y: float
    direction_x: float  #: unit vector in which the crack would go straight on
    direction_y: float
    stress_intensity_1: float  #: K_I [Pa m^(1/2)]; negative if the faces overlap
    stress_intensity_2: float  #: K_II, positive if the left side moves forward
    energy_release_rate: float  #: [J/m^2]
    t_stress: float  #: stress along the crack beside the singular one [Pa]
    error: float  #: estimate for the stress intensity factors
    kink_angle: float  #: by which the tip turns if it grows at the present loads, counter-clockwise [rad]
    critical_load_factor: float  #: at which the tip grows while the load factor rises; the largest number if never
    method: TipMethod
    contours: int  #: rings that the values come from; a tip in a PD region that has 0 has NaN for what they tell
    grown: bool  #: whether bonds have broken since so that the tip is not the described end any more
    branched: bool  #: whether other ways lead on from the crack, too
    contour_radius: float  #: of the largest ring [m]
    felt_ahead: float  #: how far ahead of its place the tip is felt [m]
    critical_load_factor_down: float  #: at which it grows while the load factor falls; minus the largest number if never
    critical_kink_angle: float  #: by which it turns at critical_load_factor, counter-clockwise [rad]
    straight_load_factor: float  #: at which G of growth straight on is the fracture energy; one under shear grows earlier
    load_rule: LoadRule  #: what the critical load factors come from
    closed: bool  #: whether its faces press on each other (tips in lattices)
    load_error: float  #: estimate of the relative error of critical_load_factor
    valid_radius: float  #: to the nearest edge, other material, other crack, bend or other end: nearer the factors hold [m]


class TipRecord(NamedTuple):
    """A tip as it was."""

    event: int  #: number of the event, or 0 for the end of a step
    total_broken_bonds: int  #: by then
    load_factor: float
    tip: CrackTip


class NextEvent(enum.IntEnum):
    """What happens next."""

    NOTHING = 0  #: however far the load factor goes
    BOND = 1  #: a bond breaks, or a crack begins there
    TIP = 2  #: a crack grows


@dataclasses.dataclass(frozen=True)
class Explanation:
    """What breaks or grows next, and what holds the rest back."""

    next: NextEvent
    region: int  #: of the bond; 0 for a tip or nothing
    crack: int  #: that grows; 0 for a bond or nothing
    end: Optional[TipEnd]  #: of the crack
    x: float  #: place of the tip, or middle of the bond [m]
    y: float
    load_factor: float  #: at which it happens
    ratio: float  #: at present: stretch over critical stretch, or equivalent K_I over toughness
    text: str  #: sentences

    def __str__(self) -> str:
        return self.text


class ErrorSource(enum.IntEnum):
    """Where errors come from."""

    BOUNDARY = 1
    LATTICE = 2
    PATCH = 3
    MODEL = 4


class PartKind(Named):
    """What a part of the model is made of."""

    ELEMENTS = 1
    LATTICE = 2


class PartReason(Named):
    """Why a part of the model is there."""

    GIVEN = 1  #: the host has added it with its elements or its lattice
    BODY = 2  #: elements of a body, which the library has chosen
    CRACK = 3  #: set_crack_treatment() asks for a lattice around a crack of the body


@dataclasses.dataclass(frozen=True)
class Part:
    """Part of the model: a region, or a lattice patch that was cut out of a body."""

    kind: PartKind
    reason: PartReason
    body: int  #: id of the region that was added
    region: int  #: id for bonds, points and fields
    crack: int  #: for which a patch was laid, or 0
    horizon_ratio: int
    spacing: float  #: [m]
    boundary_elements: int
    material_points: int
    growth_load_factor: float  #: at which a patch's cracks first grow; NaN of other parts
    element_growth_load_factor: float  #: the same by boundary elements
    outline: tuple[npt.NDArray[np.float64], ...] = ()  #: loops, shape (n, 2) each

    def __str__(self) -> str:
        if self.kind == PartKind.ELEMENTS:
            return f"region {self.region}: {self.boundary_elements} boundary elements"
        words = f"region {self.region}: lattice of {self.material_points} points, spacing {self.spacing:.3g}"
        return words + (f", for crack {self.crack} of body {self.body}" if self.crack else "")


@dataclasses.dataclass(frozen=True)
class BodyPlan:
    """What preparing a scene with bodies takes, and the errors that it will have, relative to the largest of their kind."""

    boundary_elements: int
    unknowns: int
    material_points: int
    bonds: int
    memory: float  #: [B]
    seconds: float  #: of preparing with this mesh and of the first solution
    seconds_spent: float  #: on other meshes
    error_wanted: float
    displacement_error: float
    reaction_error: float
    intensity_error: float  #: of stress intensity factors
    growth_load_error: float
    growth_load_factor: float  #: at which a crack first grows
    growth_crack: int  #: that grows then, or 0
    growth_end: Optional[TipEnd]
    meets_wish: bool
    is_solved: bool  #: else extrapolated from coarser meshes
    parts: tuple[Part, ...] = ()  #: regions, and lattice patches of bodies

    def __str__(self) -> str:
        worst = max(self.displacement_error, self.reaction_error, self.intensity_error)
        return (f"{self.boundary_elements} boundary elements, {self.unknowns} unknowns, {self.memory / 1e6:.3g} MB, "
                f"{self.seconds:.2g} s; largest error {100 * worst:.2g} % for {100 * self.error_wanted:.2g} % wanted")

    def plot(self, axes: Any = None) -> Any:
        """Draw the parts: elements, and lattices with their spacing and why they are there; returns the axes of matplotlib."""
        if axes is None:
            import matplotlib.pyplot as plt

            axes = plt.subplots(figsize=(5.6, 4.2), layout="constrained")[1]
        from matplotlib.patches import PathPatch
        from matplotlib.path import Path

        for part in self.parts:
            path = Path.make_compound_path(*(Path(np.vstack([loop, loop[:1]]), closed=True) for loop in part.outline))
            is_lattice = part.kind == PartKind.LATTICE
            axes.add_patch(PathPatch(path, facecolor="#ccbb44" if is_lattice else "#bbccee", edgecolor="#222222",
                                     linewidth=0.8, label=str(part)))
        axes.autoscale_view()
        axes.set_aspect("equal")
        axes.set_title(str(self).replace("; ", "\n"), fontsize=8)
        axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.08), fontsize=7)
        return axes

    def plot_errors(self, axes: Any = None) -> Any:
        """Draw the errors beside the one wanted, with the size of the mesh as title; returns the axes of matplotlib."""
        if axes is None:
            import matplotlib.pyplot as plt

            axes = plt.subplots(figsize=(5.6, 2.6), layout="constrained")[1]
        errors = {"displacements": self.displacement_error, "reactions": self.reaction_error,
                  "stress intensity factors": self.intensity_error, "load of first growth": self.growth_load_error}
        least = 1e-3 * self.error_wanted  # below that a bar has no length
        axes.barh(list(errors), [max(error, least) for error in errors.values()], left=0, height=0.6, color="#4477aa")
        axes.axvline(self.error_wanted, color="#cc3311", label="error.wanted")
        axes.set(xscale="log", xlim=(least, 10 * max(self.error_wanted, *errors.values())), xlabel="relative error")
        axes.invert_yaxis()
        axes.set_title(f"{self.boundary_elements} elements, {self.memory / 1e6:.3g} MB, {self.seconds:.2g} s", fontsize=10)
        axes.legend(loc="lower right", fontsize=8)
        return axes


@dataclasses.dataclass(frozen=True)
class Errors:
    """Errors of results by source, relative to the largest of their kind; sources are never added."""

    wanted: float
    displacement: float  #: from boundary elements, as the next three
    reaction: float
    stress_intensity: float
    growth_load: float
    lattice: float  #: NaN where it is not estimated
    patch: float
    model: float  #: by the growth criterion
    dominating: ErrorSource
    halving_seconds: float  #: that half as long elements would take
    halving_memory: float  #: [B]

    @property
    def largest(self) -> float:
        """Largest error of displacements, reactions and stress intensity factors from boundary elements."""
        return max(self.displacement, self.reaction, self.stress_intensity)


@dataclasses.dataclass(frozen=True)
class RunErrors:
    """Errors of a run in which cracks have grown, by source; sources are never added. NaN where they were not estimated."""

    expected_seconds: float  #: that the estimate takes, roughly
    seconds: float  #: that it took; 0 if it was not made
    first_growth: float  #: of its load factor, relative, from boundary elements
    peak: float  #: of the peak resistance, relative, from elements and lengths of extensions
    path: float  #: of the paths of cracks, likewise [m]
    lattice_first_growth: float  #: from lattice patches in place of elements, as the next two
    lattice_peak: float
    lattice_path: float  #: [m]
    path_crack: int  #: with the largest of the errors of paths, or 0
    is_made: bool  #: False: it would take longer than allowed


@dataclasses.dataclass(frozen=True)
class Growth:
    """What growth of cracks by a length did."""

    tips: int  #: that have grown
    ended: int  #: of them at an edge, a hole or another crack
    load_factor: float  #: at which they did
    length: float  #: sum of their ways [m]
    released_energy: float  #: by the body [J]

    def _repr_html_(self) -> str:
        return table(self)._repr_html_()


@dataclasses.dataclass(frozen=True)
class CrackExtension:
    """What one tip did when cracks grew."""

    event: int  #: of the history that it was part of
    crack: int  #: id
    end: TipEnd
    ended: bool  #: at an edge, a hole or another crack
    count: int  #: extensions of this end up to this one
    x: float  #: where it came to [m]
    y: float
    angle: float  #: by which it turned, counter-clockwise [rad]
    length: float  #: of its way [m]
    crack_length: float  #: of the whole crack after it [m]
    load_factor: float  #: at which it grew
    energy_release_rate_before: float  #: when it set out in the new direction [J/m^2]
    energy_release_rate_after: float  #: when it had arrived; 0 if it has ended
    released_energy: float  #: mean of both times way and thickness, or what the others leave [J]
    from_x: float  #: where it began [m]
    from_y: float
    stress_intensity_1: float  #: K_I of the tip as it grew; NaN where a crack began [Pa m^(1/2)]
    stress_intensity_2: float  #: K_II
    resistance: float  #: fracture energy where it began [J/m^2]
    state: TipState  #: what became of the end
    surface_energy: float  #: part of the released energy that the new area took; the rest becomes motion [J]


@dataclasses.dataclass(frozen=True)
class PathVertex:
    """A vertex of a crack's path; what is not known of one that was described, or where the crack began, is NaN."""

    event: int  #: at which the crack grew to here; 0: it was described
    end: Optional[TipEnd]  #: that grew; None if none did
    x: float  #: place [m]
    y: float
    load_factor: float  #: at which it grew to here
    stress_intensity_1: float  #: K_I of the tip just before [Pa m^(1/2)]
    stress_intensity_2: float  #: K_II
    energy_release_rate: float  #: in the direction to here, just before [J/m^2]
    resistance: float  #: fracture energy that was met on the way to here [J/m^2]


@dataclasses.dataclass(frozen=True)
class StepReport:
    """What a step did."""

    stop_reason: StopReason
    separated: bool  #: whether the load path is cut
    events: int  #: in this step: batches of bonds broken at one load factor
    broken_bonds: int  #: in this step
    total_events: int  #: since the beginning
    total_broken_bonds: int  #: since the beginning, without those cut by initial cracks
    fragments: int  #: pieces come free of all supports, or loaded ones that swing on a hinge
    load_factor: float  #: reached
    stored_energy: float  #: elastic energy at the end [J]
    released_energy: float  #: by breaking bonds since the beginning [J]
    work: float  #: of loads and supports since the beginning [J]
    energy_balance_error: float  #: |work - stored - released| over the largest work so far
    residual: float  #: largest unbalanced force over the largest internal force
    seconds_total: float  #: wall time of this step
    seconds_solve: float
    seconds_update: float
    seconds_search: float
    bond_energy: float  #: of the released energy what bonds take at their critical stretch; the rest would be motion [J]
    unstable_event: int  #: first event of this step at which equilibrium was lost; 0 if each was in equilibrium
    resistance: float  #: force that the body bore after the last event, the pull in a tensile test [N]
    peak_resistance: float  #: the largest that it bore in equilibrium [N]
    hanging: bool  #: separated, but some bonds still connect what carried the load
    closed_places: int  #: at which faces of cracks in lattices press on each other at the end, about one a spacing
    face_switches: int  #: how often such places have closed or opened in this step
    ties: int  #: tips and places of new cracks that would have grown in this step as soon as those that did

    def _repr_html_(self) -> str:
        return table(self)._repr_html_()


@dataclasses.dataclass(frozen=True)
class Piece:
    """A piece of the body: what intact bonds, interfaces and BEM regions join."""

    nodes: int  #: material points and boundary nodes
    supports: int  #: that hold it
    loads: int  #: that act on it
    free_motions: int  #: independent rigid motions that supports leave it
    x: float  #: mean of the places of its nodes [m]
    y: float
    move_x: float  #: the rigid motion nearest to that of its nodes: displacement there [m]
    move_y: float
    rotation: float  #: counter-clockwise [rad]
    deviation: float  #: largest difference of a node's displacement from this motion [m]

    def _repr_html_(self) -> str:
        return table(self)._repr_html_()


@dataclasses.dataclass(frozen=True)
class Statistics:
    """Sizes, counters and times since the model was created."""

    boundary_nodes: int
    boundary_elements: int
    material_points: int
    bonds: int
    cut_bonds: int
    broken_bonds: int
    sparse_unknowns: int
    factor_nonzeros: int
    kernel_evaluations: int
    dense_factorizations: int
    sparse_factorizations: int
    factor_updates: int
    solves: int
    solver_iterations: int
    seconds_boundary: float
    seconds_lattice: float
    seconds_assembly: float
    seconds_factorization: float
    seconds_solve: float
    seconds_update: float
    seconds_search: float
    reciprocal_condition: float  #: crude, of the worst equations solved so far; 1 if nothing was solved
    subdomains: int  #: into which large BEM regions without cracks are cut; 0 if all are whole
    cut_nodes: int  #: on the cuts between subdomains

    def _repr_html_(self) -> str:
        return table(self)._repr_html_()


class Bonds(NamedTuple):
    """Bonds of a peridynamic region."""

    points: npt.NDArray[np.int32]  #: shape (bonds, 2): indices of material points
    states: npt.NDArray[np.int32]  #: shape (bonds,): each a BondState


class PointValues(NamedTuple):
    """Values at places in the body."""

    displacement: npt.NDArray[np.float64]  #: shape (n, 2) [m]
    stress: Optional[npt.NDArray[np.float64]]  #: shape (n, 3): xx, yy, xy [Pa]; None if not asked for
    region: npt.NDArray[np.int32]  #: shape (n,): the region that holds each place


class PointErrors(NamedTuple):
    """Errors of values at places in the body; NaN where they are not known."""

    displacement: npt.NDArray[np.float64]  #: shape (n,) [m]
    stress: npt.NDArray[np.float64]  #: shape (n,): a bound of those of principal stresses [Pa]


class EdgeReaction(NamedTuple):
    """What supports exert on the body through one edge."""

    force: npt.NDArray[np.float64]  #: shape (2,) [N]
    moment: float  #: positive counter-clockwise [N m]


class SupportHistory(NamedTuple):
    """What a support did, line by line of the history."""

    displacement: npt.NDArray[np.float64]  #: shape (n, 2), the mean over its nodes; NaN where it leaves them free [m]
    force: npt.NDArray[np.float64]  #: shape (n, 2), that it exerts on the body [N]
    force_before: npt.NDArray[np.float64]  #: shape (n, 2), the same just before the line's event [N]


class EdgeNodes(NamedTuple):
    """Nodes along an edge, from its start to its end."""

    nodes: npt.NDArray[np.int32]  #: shape (n,): indices into the fields of the region's nodes
    fractions: npt.NDArray[np.float64]  #: shape (n,): where they lie, as fractions of the edge
    weights: npt.NDArray[np.float64]  #: shape (n,): integrals of their shape functions along the edge [m]


class EdgePlaces(NamedTuple):
    """Places on an edge nearest to given ones."""

    fractions: npt.NDArray[np.float64]  #: shape (n,): of the edge
    distances: npt.NDArray[np.float64]  #: shape (n,): of the given places from it [m]


class CrackOpening(NamedTuple):
    """Displacement of a crack's left face less that of its right one."""

    normal: npt.NDArray[np.float64]  #: shape (n,): negative where faces overlap [m]
    tangential: npt.NDArray[np.float64]  #: shape (n,): along the crack [m]


def values_of(struct: Any, name: str, kind: type[Any]) -> dict[str, Any]:
    """Members of a struct by name, those that the kind of report has: the struct may have got more since."""
    known = {field.name for field in dataclasses.fields(kind)}
    return {key: getattr(struct, key) for key, _ in members(name) if key in known}


def step_report(struct: Any) -> StepReport:
    """The report as a value."""
    values = values_of(struct, "bempd_step_report", StepReport)
    values["stop_reason"] = StopReason(values["stop_reason"])
    values["separated"], values["hanging"] = bool(values["separated"]), bool(values["hanging"])
    return StepReport(**values)


def crack_tip(struct: Any) -> CrackTip:
    """A tip as a value."""
    values = values_of(struct, "bempd_crack_tip", CrackTip)
    values["end"], values["method"] = TipEnd(values["end"]), TipMethod(values["method"])
    values["grown"], values["branched"] = bool(values["grown"]), bool(values["branched"])
    values["load_rule"], values["closed"] = LoadRule(values["load_rule"]), bool(values["closed"])
    return CrackTip(**values)


def body_plan(struct: Any, parts: tuple[Part, ...]) -> BodyPlan:
    """A plan as a value."""
    values = values_of(struct, "bempd_body_plan", BodyPlan)
    values["growth_end"] = TipEnd(values["growth_end"]) if values["growth_end"] else None
    values["meets_wish"], values["is_solved"] = bool(values["meets_wish"]), bool(values["is_solved"])
    return BodyPlan(**values, parts=parts)


def model_part(struct: Any, outline: tuple[npt.NDArray[np.float64], ...]) -> Part:
    """A part as a value."""
    values = values_of(struct, "bempd_model_part", Part)
    values["kind"], values["reason"] = PartKind(values["kind"]), PartReason(values["reason"])
    return Part(**values, outline=outline)


def error_sources(struct: Any) -> Errors:
    """Errors as a value."""
    values = values_of(struct, "bempd_errors", Errors)
    values["dominating"] = ErrorSource(values["dominating"])
    return Errors(**values)


def run_errors(struct: Any) -> RunErrors:
    """Errors of a run as a value."""
    values = values_of(struct, "bempd_run_errors", RunErrors)
    values["is_made"] = bool(values["is_made"])
    return RunErrors(**values)


def explained(struct: Any, text: str) -> Explanation:
    """An explanation as a value."""
    values = values_of(struct, "bempd_explanation", Explanation)
    values["next"] = NextEvent(values["next"])
    values["end"] = TipEnd(values["end"]) if values["end"] else None
    return Explanation(**values, text=text)


def singularity(struct: Any) -> Singularity:
    """A singular place as a value."""
    values = values_of(struct, "bempd_singularity", Singularity)
    values["kind"] = SingularityKind(values["kind"])
    return Singularity(**values)


def crack_extension(struct: Any) -> CrackExtension:
    """An extension as a value."""
    values = values_of(struct, "bempd_crack_extension", CrackExtension)
    values["end"] = TipEnd(values["end"])
    values["ended"], values["state"] = bool(values["ended"]), TipState(values["state"])
    return CrackExtension(**values)


def path_vertex(struct: Any) -> PathVertex:
    """A vertex as a value."""
    values = values_of(struct, "bempd_path_vertex", PathVertex)
    values["end"] = TipEnd(values["end"]) if values["end"] else None
    return PathVertex(**values)


def rows(structs: Any, name: str) -> npt.NDArray[Any]:
    """An array of structs as a structured array of their telling members."""
    dtypes = {"int32_t": np.int32, "int64_t": np.int64, "double": np.float64}
    fields = dict(ffi.typeof(name).fields)
    whole = np.dtype({
        "names": list(fields),
        "formats": [dtypes[field.type.cname] for field in fields.values()],
        "offsets": [field.offset for field in fields.values()],
        "itemsize": ffi.sizeof(name),
    })
    kept = [key for key, _ in members(name)]
    table = np.frombuffer(ffi.buffer(structs), dtype=whole)
    copied = np.empty(len(table), dtype=[(key, whole[key]) for key in kept])
    for key in kept:
        copied[key] = table[key]
    return copied
