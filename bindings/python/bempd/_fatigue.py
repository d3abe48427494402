"""The part of a Model in which cracks grow by cycles of the loads."""

from __future__ import annotations

import warnings
from typing import Any, Callable, Mapping, Optional, Sequence, Union

import numpy as np
import numpy.typing as npt

from . import _arguments as arguments
from ._handle import Handle
from ._library import call, ffi, lib, new_struct
from .errors import ArgumentError
from .fatigue import FatigueLife, FatigueStop
from .reports import Growth, TipEnd, rows, values_of

KINDS = {
    "paris": lib.BEMPD_RATE_PARIS,
    "forman": lib.BEMPD_RATE_FORMAN,
    "nasgro": lib.BEMPD_RATE_NASGRO,
    "sustained": lib.BEMPD_RATE_SUSTAINED,
}
RETARDATIONS = {"wheeler": lib.BEMPD_RETARDATION_WHEELER, "willenborg": lib.BEMPD_RETARDATION_WILLENBORG}
#: Called as f(crack, end, equivalent, ratio, stress_intensity_1, stress_intensity_2, t_stress, length, x, y); gives the growth
#: in a cycle [m], or the fracture energy that the tip meets [J/m^2]. An exception ends the call, which leaves the model as
#: it was, and is raised again.
GrowthFunction = Callable[[int, int, float, float, float, float, float, float, float, float], float]
#: Load factors of blocks: a number or a row of them; or combinations of load cases, {case: factor}, one or several.
Loads = Union[npt.ArrayLike, Mapping[int, float], Sequence[Mapping[int, float]]]


class Fatigue:
    """Growth of cracks in BEM regions by cycles, and by given lengths."""

    _handle: Optional[Handle]

    def _open(self) -> Handle:
        raise NotImplementedError

    def set_growth_rate(self, material: int, law: Union[str, GrowthFunction] = "paris", *, coefficient: float = 0.0,
                        exponent: float = 0.0, unit_intensity: float = 1.0, threshold: float = 0.0,
                        critical_intensity: float = 0.0, walker: float = 1.0, p: float = 0.0, q: float = 0.0,
                        closure_alpha: float = 1.0, closure_stress: float = 0.0, retardation: Optional[str] = None,
                        yield_strength: float = 0.0, zone_constraint: float = 0.0, wheeler_exponent: float = 0.0,
                        shutoff_ratio: float = 0.0, flow_stress: float = 0.0) -> None:
        """Say how far a crack in a material grows in a cycle: da/dN = C dK^m by default.

        `law` is "paris" (with `walker` for the effect of R), "forman", "nasgro", "sustained" (growth in time), or a
        function. Factors are over `unit_intensity`: with 1e6 coefficients are those of tables in MPa m^(1/2) and m.

        `retardation` after overloads is "wheeler" (with `wheeler_exponent`) or "willenborg" (with `shutoff_ratio`); both take
        a `yield_strength` [Pa]. With a `flow_stress` [Pa] growth ends where the net section of a tip yields as a whole.
        """
        handle = self._open()
        struct = new_struct("bempd_growth_rate", "bempd_growth_rate_init")
        numbers = dict(coefficient=coefficient, exponent=exponent, unit_intensity=unit_intensity, threshold=threshold,
                       critical_intensity=critical_intensity, walker=walker, p=p, q=q, closure_alpha=closure_alpha,
                       closure_stress=closure_stress, yield_strength=yield_strength, zone_constraint=zone_constraint,
                       wheeler_exponent=wheeler_exponent, shutoff_ratio=shutoff_ratio, flow_stress=flow_stress)
        for name, value in numbers.items():
            setattr(struct, name, arguments.real(f"set_growth_rate: {name}", value))
        if callable(law):
            struct.kind, struct.function = lib.BEMPD_RATE_HOST, _growth_callback(handle, law)
        elif law in KINDS:
            struct.kind = KINDS[law]
        else:
            raise ArgumentError(f"set_growth_rate: law is {law!r}; give one of {', '.join(KINDS)}, or a function")
        if retardation is not None:
            if retardation not in RETARDATIONS:
                raise ArgumentError(f"set_growth_rate: retardation is {retardation!r}; give one of {', '.join(RETARDATIONS)}, or None")
            struct.retardation = RETARDATIONS[retardation]
        handle.call("bempd_set_growth_rate", material, struct)

    def set_resistance_function(self, material: int, function: GrowthFunction) -> None:
        """Let a function give the fracture energy [J/m^2] that a tip in a material meets, in place of its number.

        >>> import bempd
        >>> model = bempd.Model()
        >>> glass = model.add_material(young_modulus=70e9, poisson_ratio=0.2, fracture_energy=8)
        >>> plate = model.add_bem_region(glass, bempd.rectangle(-1, -1, 1, 1), element_length=0.5)
        >>> crack = model.add_crack([(-0.2, 0), (0.2, 0)])
        >>> support = model.fix_edge(plate, 1), model.prescribe_edge(plate, 3, "y", 1e-5)
        >>> def resistance(crack, end, equivalent, ratio, k1, k2, t_stress, grown, x, y):
        ...     return 8 * (1 + 10 * grown)
        >>> model.set_resistance_function(glass, resistance)
        >>> report = model.step(1e3)
        """
        handle = self._open()
        callback = _growth_callback(handle, function)
        handle.call("bempd_set_resistance_function", material, callback, ffi.NULL)

    def grow_fatigue(self, high: Loads = 1.0, low: Loads = 0.0, cycles: Optional[npt.ArrayLike] = None, *,
                     first_cycle: float = 0.0, most_cycles: Optional[float] = None, most_length: Optional[float] = None,
                     most_steps: int = 1000, tolerance: float = 1e-3, largest_step: float = 0.25,
                     detectable: Optional[float] = None, inspections: int = 2) -> FatigueLife:
        """Let cracks grow by cycles of the loads, and count the cycles.

        A block is a number of `cycles` between the load factors `high` and `low`; several blocks follow each other and are
        repeated. One block without cycles is a constant amplitude. The model is at the highest load factor afterwards,
        with the longer cracks. With a `detectable` length [m] the life has an interval of so many `inspections`; a warning
        tells if the crack never has that length.

        `high` and `low` may also be combinations of load cases: `{case: factor}` for each block (see add_load_case()).

        >>> import bempd
        >>> model = bempd.Model()
        >>> steel = model.add_material(young_modulus=210e9, poisson_ratio=0.3)
        >>> plate = model.add_bem_region(steel, bempd.rectangle(-0.1, -0.3, 0.1, 0.3), element_length=0.05)
        >>> crack = model.add_crack([(-0.005, 0), (0.005, 0)])
        >>> support = model.fix_point((-0.1, -0.3)), model.fix_point((0.1, -0.3), "y")
        >>> loads = model.add_traction(plate, 3, "y", 100e6), model.add_traction(plate, 1, "y", -100e6)
        >>> model.set_growth_rate(steel, coefficient=1e-11, exponent=3, unit_intensity=1e6)
        >>> life = model.grow_fatigue(high=1, low=0, most_length=0.05, detectable=0.02)
        >>> print(f"{life.cycles:.3g} cycles, {life.stop_reason.name}, an inspection every {life.interval:.2g} cycles")
        2.73e+05 cycles, LENGTH, an inspection every 6.3e+04 cycles
        """
        by_cases = _are_cases(high) or _are_cases(low)
        rows_of = self._case_rows if by_cases else lambda values: np.atleast_1d(np.asarray(values, dtype=np.float64))
        tops, bottoms, counts = _blocks(rows_of(high), rows_of(low), cycles)
        for name, value in (("most_cycles", most_cycles), ("most_length", most_length)):
            if value is not None and not value > 0:
                raise ArgumentError(f"grow_fatigue: {name} is {value}; it must be > 0")
        if not inspections >= 1:
            raise ArgumentError(f"grow_fatigue: inspections is {inspections}; give at least 1")
        if detectable is not None and not 0 < detectable < np.inf:
            raise ArgumentError(f"grow_fatigue: detectable is {detectable}; it must be a length > 0")
        if detectable is not None and most_length is not None and detectable > most_length:
            raise ArgumentError(f"grow_fatigue: no crack has the detectable length {detectable:g} when growth ends at {most_length:g}")
        if tops.ndim != (2 if by_cases else 1):
            raise ArgumentError(f"grow_fatigue: high and low have shape {tops.shape}; give a number or a row for each")
        options = new_struct("bempd_fatigue", "bempd_fatigue_init")
        options.first_cycle, options.most_cycles = first_cycle, most_cycles or 0.0
        options.most_length, options.most_steps = most_length or 0.0, most_steps
        options.tolerance, options.largest_step = tolerance, largest_step
        report = new_struct("bempd_fatigue_report", "bempd_fatigue_report_init")
        name, sizes = ("bempd_grow_fatigue_cases", tops.shape) if by_cases else ("bempd_grow_fatigue", (len(tops),))
        self._open().call(name, *sizes, arguments.doubles(tops), arguments.doubles(bottoms),
                          ffi.NULL if counts is None else arguments.doubles(counts), options, report, changes=True)
        life = FatigueLife(stop_reason=FatigueStop(report.stop_reason), crack=report.crack,
                           end=TipEnd(report.end) if report.end else None, steps=report.steps, cycles=report.cycles,
                           growth=report.growth, error=report.error, table=self._fatigue_table())
        if detectable is None:
            return life
        try:
            return life.inspected(detectable, inspections=inspections)
        except ArgumentError as error:  # the cracks have grown: their life is not lost for an interval
            warnings.warn(f"{error}; the life has no interval of inspections", stacklevel=2)
            return life

    def _case_rows(self, combinations: Any) -> npt.NDArray[np.float64]:
        """Factors of all load cases, a row for each combination."""
        if isinstance(combinations, Mapping):
            combinations = [combinations]
        if not _are_cases(combinations):
            raise ArgumentError("grow_fatigue: high and low must both be load factors, or both combinations of load cases")
        count = ffi.new("int32_t *")
        self._open().call("bempd_load_case_count", count)
        table = np.zeros((len(combinations), count[0]))
        for row, combination in zip(table, combinations):
            for case, factor in combination.items():
                if not 1 <= case <= count[0]:
                    raise ArgumentError(f"grow_fatigue: load case {case} does not exist; there are {count[0]}, from 1 on")
                row[case - 1] = arguments.real("grow_fatigue: factor", factor)
        return table

    def _fatigue_table(self) -> npt.NDArray[Any]:
        count = ffi.new("int64_t *")
        self._open().call("bempd_fatigue_record_count", count)
        records = ffi.new("bempd_fatigue_record[]", max(count[0], 1))
        for index in range(count[0]):
            call("bempd_fatigue_record_init", records + index, ffi.sizeof("bempd_fatigue_record"))
            self._open().call("bempd_get_fatigue_record", index, records + index)
        return rows(records, "bempd_fatigue_record")[:count[0]]

    def extend_cracks(self, lengths: Mapping[tuple[int, Union[TipEnd, int]], float]) -> Growth:
        """Let tips of BEM regions grow by lengths [m], whatever their load: `{(crack, bempd.TipEnd.END): 0.001}`."""
        count = len(lengths)
        cracks = ffi.new("int32_t[]", [crack for crack, _ in lengths])
        ends = ffi.new("int32_t[]", [int(end) for _, end in lengths])
        growths = ffi.new("double[]", [arguments.real("extend_cracks: length", length) for length in lengths.values()])
        struct = new_struct("bempd_growth", "bempd_growth_init")
        self._open().call("bempd_extend_cracks", count, cracks, ends, growths, struct, changes=True)
        return Growth(**values_of(struct, "bempd_growth", Growth))


def _blocks(high: Any, low: Any, cycles: Optional[npt.ArrayLike]) -> tuple[Any, Any, Any]:
    """The loads and cycles of blocks, a row for each; a single one holds for all blocks."""
    try:
        tops, bottoms = (np.ascontiguousarray(values) for values in np.broadcast_arrays(high, low))
        counts = None if cycles is None else np.atleast_1d(np.asarray(cycles, dtype=np.float64))
        return tops, bottoms, None if counts is None else np.ascontiguousarray(np.broadcast_to(counts, tops.shape[:1]))
    except ValueError:
        numbers = ", ".join(f"{name} {np.atleast_1d(values).shape[0]}" for name, values in (("high", high), ("low", low), ("cycles", cycles))
                            if values is not None)
        raise ArgumentError(f"grow_fatigue: blocks differ in number: {numbers}; give one for each block, or a single one for all") from None


def _are_cases(loads: Any) -> bool:
    """Whether loads are combinations of load cases."""
    if isinstance(loads, Mapping):
        return True
    return isinstance(loads, Sequence) and len(loads) > 0 and all(isinstance(one, Mapping) for one in loads)


def _growth_callback(handle: Handle, function: GrowthFunction) -> Any:
    """What the library calls for the growth in a cycle or a fracture energy; it lives as long as the model."""

    def asked(crack: int, end: int, equivalent: float, ratio: float, first: float, second: float, t_stress: float, length: float,
              x: float, y: float, _: Any) -> float:
        return float(function(crack, end, equivalent, ratio, first, second, t_stress, length, x, y))

    def failed(kind: Any, error: BaseException, traceback: Any) -> None:
        handle.raised.append(error)

    callback = ffi.callback("bempd_growth_function", asked, error=float("nan"), onerror=failed)
    handle.callbacks.append(callback)
    return callback
