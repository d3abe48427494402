"""How far results depend on the fineness of a scene: values at several spacings, observed order, extrapolation, error."""

from __future__ import annotations

import dataclasses
import html
import math
import sys
import time
from typing import Callable, Iterator, Mapping, Optional, Sequence, TextIO, Union

from .errors import ArgumentError
from .reports import StepReport

#: What a scene gives at one fineness: a number, numbers by name, or the report of a step.
Answer = Union[float, Mapping[str, float], StepReport]

#: Values of a report that are compared if a scene returns one.
OF_REPORT = ("load_factor", "peak_resistance", "stored_energy", "released_energy")
# Factors of safety of Roache, Perspective: a method for uniform reporting of grid refinement studies, J. Fluids Eng. 116
# (1994) 405-413: an order that was observed deserves more trust than one that was assumed.
OBSERVED, ASSUMED = 1.25, 3.0
HIGHEST = 2.0  # order on which an error estimate relies at most
ROUNDING = 1e-12  # relative difference below which two values are the same


@dataclasses.dataclass(frozen=True)
class Convergence:
    """One value at several spacings, coarse to fine."""

    name: str
    spacings: tuple[float, ...]
    values: tuple[float, ...]
    order: float  #: p in value + C spacing^p, of the last three spacings; NaN if they show none
    extrapolated: float  #: to spacing 0; NaN where it is not known
    error: float  #: estimate for the value at the finest spacing, in its unit
    note: str  #: what to think of the order; empty if it was observed

    @property
    def relative_error(self) -> float:
        """The error over the value at the finest spacing; NaN if that is 0."""
        return self.error / abs(self.values[-1]) if self.values[-1] else math.nan


class ConvergenceTable(Mapping[str, Convergence]):
    """What converge() returns: a Convergence for each value by name, and all of them as a table."""

    def __init__(self, spacings: Sequence[float], rows: Mapping[str, Convergence], seconds: Sequence[float]) -> None:
        self.spacings, self.seconds = tuple(spacings), tuple(seconds)
        self._rows = dict(rows)

    def __getitem__(self, name: str) -> Convergence:
        return self._rows[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._rows)

    def __len__(self) -> int:
        return len(self._rows)

    @property
    def only(self) -> Convergence:
        """The one value, where there is only one."""
        if len(self._rows) != 1:
            raise ArgumentError(f"converge: there are {len(self._rows)} values; take one by name: {', '.join(self._rows)}")
        return next(iter(self._rows.values()))

    @property
    def values_by_spacing(self) -> tuple[float, ...]:
        """Values at the spacings, where there is only one kind."""
        return self.only.values

    @property
    def order(self) -> float:
        """Observed order, where there is only one value."""
        return self.only.order

    @property
    def extrapolated(self) -> float:
        """Value at spacing 0, where there is only one value."""
        return self.only.extrapolated

    @property
    def error(self) -> float:
        """Estimated error at the finest spacing, where there is only one value."""
        return self.only.error

    def lines(self) -> list[list[str]]:
        """Rows of the table, the heading first."""
        all_values = list(self._rows.values())
        table = [["spacing", *self._rows, "seconds"]]
        table += [[f"{spacing:g}", *(f"{one.values[k]:.6g}" for one in all_values), f"{self.seconds[k]:.1f}"]
                  for k, spacing in enumerate(self.spacings)]
        table.append(["order", *(shown(one.order, ".2f") for one in all_values), ""])
        table.append(["extrapolated", *(shown(one.extrapolated, ".6g") for one in all_values), ""])
        table.append([f"error at {self.spacings[-1]:g}", *(error_in_words(one) for one in all_values), ""])
        return table

    def notes(self) -> list[str]:
        """What to think of values whose order was not observed."""
        return [f"{one.name}: {one.note}" for one in self._rows.values() if one.note]

    def __str__(self) -> str:
        table = self.lines()
        widths = [max(len(row[k]) for row in table) for k in range(len(table[0]))]
        rows = ["  ".join([row[0].ljust(widths[0])] + [cell.rjust(width) for cell, width in zip(row[1:], widths[1:])]).rstrip()
                for row in table]
        return "\n".join(rows + self.notes())

    __repr__ = __str__

    def _repr_html_(self) -> str:
        head, *rows = [[html.escape(cell) for cell in row] for row in self.lines()]
        body = "".join("<tr><th>" + "</th><td>".join([row[0], "</td><td>".join(row[1:])]) + "</td></tr>" for row in rows)
        notes = "".join(f"<p>{html.escape(note)}</p>" for note in self.notes())
        return f"<table><tr><th>{'</th><th>'.join(head)}</th></tr>{body}</table>{notes}"


def converge(build: Callable[[float], Answer], spacings: Sequence[float], *, order: Optional[float] = None,
             file: Optional[TextIO] = None, quiet: bool = False) -> ConvergenceTable:
    """Run a scene at two or more spacings and print how its results depend on them.

    build     called as build(spacing): it builds the scene, runs it, and returns a number, numbers by name, or the report
              of a step. The spacing is whatever it makes of it: lattice spacing, element length, length of growth steps.
    spacings  two or more, in any order; each at most 0.9 of the next coarser one. Three show the order that results have.
    order     that is assumed where only two spacings are given; 1 if not given.
    quiet     nothing is printed; else the table goes to `file`, or to the screen.

    The order is that of the last three spacings. The extrapolated value is Richardson's. The error estimate is Roache's: the
    distance from the extrapolated value times 1.25, or times 3 where the order was assumed, and with an order of 2 at most.

    >>> import bempd
    >>> def stress_intensity(spacing):
    ...     model = bempd.Model()
    ...     glass = model.add_material(young_modulus=70e9, poisson_ratio=0.2)
    ...     plate = model.add_bem_region(glass, bempd.rectangle(-1, -3, 1, 3), element_length=spacing)
    ...     crack = model.add_crack([(-0.5, 0), (0.5, 0)])
    ...     held = model.fix_point((-1, -3)), model.fix_point((1, -3), "y")
    ...     loads = model.add_traction(plate, 3, "y", 1e6), model.add_traction(plate, 1, "y", -1e6)
    ...     report = model.step(1)
    ...     return {"K_I": model.tips()[0].stress_intensity_1}
    >>> table = bempd.converge(stress_intensity, [1.0, 0.5], quiet=True)
    >>> table["K_I"].relative_error < 0.05, table["K_I"].note
    (True, 'order 1 is assumed; a third spacing would show it')
    """
    ordered = checked_spacings(spacings)
    if order is not None and not (isinstance(order, (int, float)) and math.isfinite(order) and order > 0):
        raise ArgumentError(f"converge: order is {order!r}; it must be a number above 0")
    if not callable(build):
        raise ArgumentError(f"converge: build is {build!r}; give a function of the spacing")
    answers: list[dict[str, float]] = []
    seconds: list[float] = []
    for spacing in ordered:
        began = time.perf_counter()
        answers.append(numbers_of(build(spacing), spacing))
        seconds.append(time.perf_counter() - began)
        if set(answers[-1]) != set(answers[0]):
            raise ArgumentError(f"converge: build({spacing:g}) returned {', '.join(answers[-1])}, and before "
                                f"{', '.join(answers[0])}; return the same names at every spacing")
    rows = {name: convergence_of(name, ordered, [answer[name] for answer in answers], order) for name in answers[0]}
    table = ConvergenceTable(ordered, rows, seconds)
    if not quiet:
        print(table, file=file or sys.stdout)
    return table


def checked_spacings(spacings: Sequence[float]) -> list[float]:
    """Spacings from coarse to fine."""
    try:
        ordered = sorted((float(spacing) for spacing in spacings), reverse=True)
    except (TypeError, ValueError):
        raise ArgumentError(f"converge: spacings are {spacings!r}; give two or more lengths") from None
    if len(ordered) < 2 or not all(math.isfinite(one) and one > 0 for one in ordered):
        raise ArgumentError(f"converge: spacings are {spacings!r}; give two or more lengths above 0")
    for coarse, fine in zip(ordered, ordered[1:]):
        if fine > 0.9 * coarse:
            raise ArgumentError(f"converge: spacings {coarse:g} and {fine:g} are too near each other to show an order; give "
                                f"each at most 0.9 of the next coarser one, better a half")
    return ordered


def numbers_of(answer: Answer, spacing: float) -> dict[str, float]:
    """Numbers by name."""
    if isinstance(answer, StepReport):
        return {name: float(getattr(answer, name)) for name in OF_REPORT}
    items = dict(answer) if isinstance(answer, Mapping) else {"value": answer}
    found: dict[str, float] = {}
    for name, value in items.items():
        try:
            found[str(name)] = float(value)
        except (TypeError, ValueError):
            raise ArgumentError(f"converge: build({spacing:g}) returned {type(value).__name__} for {name!r}; return a number, "
                                "numbers by name, or the report of a step") from None
        if not math.isfinite(found[str(name)]):
            raise ArgumentError(f"converge: build({spacing:g}) returned {value!r} for {name!r}; return finite numbers")
    if not found:
        raise ArgumentError(f"converge: build({spacing:g}) returned no number")
    return found


def convergence_of(name: str, spacings: Sequence[float], values: Sequence[float], order: Optional[float]) -> Convergence:
    """Order, extrapolation and error of one value."""
    coarse, fine = values[-2:]
    change = abs(fine - coarse)
    if change <= ROUNDING * max(abs(value) for value in values):
        return Convergence(name, tuple(spacings), tuple(values), math.nan, fine, change, "the last two values agree to rounding")
    seen, note = math.nan, ""
    if len(values) > 2:
        seen, note = observed_order(spacings[-3:], values[-3:])
        if math.isnan(seen):
            spread = max(values[-3:]) - min(values[-3:])
            return Convergence(name, tuple(spacings), tuple(values), seen, math.nan, spread, note)
    else:
        note = f"order {1 if order is None else order:g} is assumed; a third spacing would show it"
    used = seen if len(values) > 2 else (1.0 if order is None else float(order))
    ahead = spacings[-1] ** used / (spacings[-2] ** used - spacings[-1] ** used)
    trusted = min(used, HIGHEST)
    reach = spacings[-1] ** trusted / (spacings[-2] ** trusted - spacings[-1] ** trusted)
    safety = OBSERVED if len(values) > 2 else ASSUMED
    return Convergence(name, tuple(spacings), tuple(values), seen, fine + (fine - coarse) * ahead, safety * change * reach, note)


def observed_order(spacings: Sequence[float], values: Sequence[float]) -> tuple[float, str]:
    """The p for which value + C spacing^p fits three values, and what to think of it; NaN if there is none."""
    first, second = values[0] - values[1], values[1] - values[2]
    if first * second < 0:
        return math.nan, "the values go up and down, so that no order is seen; the error is their spread"
    ratio = abs(first / second)

    def excess(p: float) -> float:
        # Scaled by the middle spacing, so that no power leaves the range of numbers.
        a, b = spacings[0] / spacings[1], spacings[2] / spacings[1]
        return float((a**p - 1) / (1 - b**p) - ratio)

    low, high = 0.05, 12.0
    if excess(low) > 0:
        return math.nan, "the values do not come nearer to each other, so that no limit is seen; the error is their spread"
    if excess(high) < 0:
        return high, f"the last change is so small that the order is above {high:g}: use coarser spacings to see it"
    for _ in range(80):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if excess(middle) < 0 else (low, middle)
    note = "the order is below 0.5: the extrapolated value is uncertain, use finer spacings" if low < 0.5 else ""
    return low, note


def shown(value: float, form: str) -> str:
    """A number, or a stroke where there is none."""
    return "-" if math.isnan(value) else format(value, form)


def error_in_words(one: Convergence) -> str:
    """An error as a share of the value where that is not 0."""
    return f"{one.error:.2g}" if math.isnan(one.relative_error) else f"{100 * one.relative_error:.2g} %"
