"""Reports and lists of tips, extensions and places as tables, for the screen and for notebooks."""

from __future__ import annotations

import dataclasses
import enum
import html
import math
from typing import Any, Callable, Iterable, List, Optional, Sequence, TypeVar, Union

from .errors import ArgumentError

Row = TypeVar("Row")

#: Columns of lists that have many members, with their headings; other classes show all members.
COLUMNS: dict[str, dict[str, str]] = {
    "CrackTip": {"crack": "crack", "end": "end", "x": "x [m]", "y": "y [m]", "stress_intensity_1": "K_I [Pa m^1/2]",
                 "stress_intensity_2": "K_II [Pa m^1/2]", "energy_release_rate": "G [J/m^2]", "error": "error of K",
                 "critical_load_factor": "grows at", "kink_angle": "turns by [rad]", "method": "method"},
    "CrackExtension": {"event": "event", "crack": "crack", "end": "end", "x": "x [m]", "y": "y [m]", "angle": "turned by [rad]",
                       "length": "length [m]", "load_factor": "load factor", "energy_release_rate_before": "G before [J/m^2]",
                       "energy_release_rate_after": "G after [J/m^2]", "state": "state"},
}
#: Numbers that stand for "never".
NEVER = 1e300


class Rows(List[Row]):
    """A list that notebooks show as a table; `str(bempd.table(rows))` is the table as text. `called` gives a region, a support or a
    load its name: "region 1", or "region 1 ("pane")"."""

    def __init__(self, entries: Iterable[Row] = (), *, called: Optional[Callable[[str, int], str]] = None) -> None:
        super().__init__(entries)
        self.called = called

    def _repr_html_(self) -> str:
        return table(self)._repr_html_() if self else "<p>none</p>"


class Table:
    """Cells with a heading: printed in columns, shown by notebooks as a table."""

    def __init__(self, heading: Sequence[str], rows: Sequence[Sequence[str]]) -> None:
        self.heading, self.rows = list(heading), [list(row) for row in rows]

    def __str__(self) -> str:
        every = [self.heading, *self.rows]
        widths = [max(len(row[k]) for row in every) for k in range(len(self.heading))]
        return "\n".join("  ".join(cell.ljust(width) for cell, width in zip(row, widths)).rstrip() for row in every)

    __repr__ = __str__

    def _repr_html_(self) -> str:
        def line(cells: Iterable[str], tag: str) -> str:
            return "<tr>" + "".join(f"<{tag}>{html.escape(cell)}</{tag}>" for cell in cells) + "</tr>"

        return "<table>" + line(self.heading, "th") + "".join(line(row, "td") for row in self.rows) + "</table>"


def table(what: Union[Any, Sequence[Any]], columns: Optional[Sequence[str]] = None) -> Table:
    """A table of a report, of a list such as tips(), extensions(), singularities() or crack_path() return, or of a model.

    A single report has a line for each value. A list has a line for each entry; `columns` chooses members by name. Regions,
    supports and loads with a name have it beside their number. The table of a model has its supports and loads: where they are,
    what they do and, of supports once a step was made, the force that they exert.

    >>> import bempd
    >>> model = bempd.Model()
    >>> glass = model.add_material(young_modulus=70e9, poisson_ratio=0.2)
    >>> plate = model.add_bem_region(glass, bempd.rectangle(-1, -3, 1, 3), element_length=0.25)
    >>> crack = model.add_crack([(-0.5, 0), (0.5, 0)])
    >>> support = model.fix_point((-1, -3)), model.fix_point((1, -3), "y")
    >>> loads = model.add_traction(plate, 3, "y", 1e6), model.add_traction(plate, 1, "y", -1e6)
    >>> report = model.step(1)
    >>> print(bempd.table(model.tips(), ["crack", "end", "x", "y", "method"]))
    crack  end    x [m]  y [m]  method
    1      START  -0.5   0      ELEMENTS
    1      END    0.5    0      ELEMENTS
    """
    if dataclasses.is_dataclass(what) and not isinstance(what, type):
        names = chosen(type(what), columns)
        return Table(["value", type(what).__name__], [[name.replace("_", " "), shown(getattr(what, name))] for name in names])
    conditions = getattr(what, "_conditions", None)  # of a Model
    if conditions is not None:
        return Table(["what", "where", "does", "force x [N]", "force y [N]"], [[shown(cell) for cell in row] for row in conditions()])
    called = getattr(what, "called", None)
    rows = [flat(row) for row in what]
    if not rows:
        return Table(["none"], [])
    names = chosen(type(rows[0]), columns)
    headings = COLUMNS.get(type(rows[0]).__name__, {})
    return Table([headings.get(name, name.replace("_", " ")) for name in names],
                 [[known_as(name, getattr(row, name), called) for name in names] for row in rows])


def flat(row: Any) -> Any:
    """An entry of a list; of a recorded tip the tip."""
    if dataclasses.is_dataclass(row):
        return row
    tip = getattr(row, "tip", None)
    if dataclasses.is_dataclass(tip):
        return tip
    raise ArgumentError(f"table: the list has a {type(row).__name__}; give a report, or a list of tips, extensions and the like")


def chosen(kind: Any, columns: Optional[Sequence[str]]) -> list[str]:
    """Names of the members that are shown."""
    known = [field.name for field in dataclasses.fields(kind)]
    if columns is None:
        return list(COLUMNS.get(kind.__name__, known))
    for name in columns:
        if name not in known:
            raise ArgumentError(f"table: {kind.__name__} has no {name!r}; it has {', '.join(known)}")
    return list(columns)


def known_as(name: str, value: Any, called: Optional[Callable[[str, int], str]]) -> str:
    """A member of an entry as a short text, a region, support or load with its name."""
    if called is not None and name in ("region", "support", "load"):
        return called(name, value).removeprefix(f"{name} ")
    return shown(value)


def shown(value: Any) -> str:
    """A value as a short text."""
    if isinstance(value, enum.Enum):
        return value.name
    if isinstance(value, bool) or value is None:
        return {True: "yes", False: "no", None: "-"}[value]
    if isinstance(value, float):
        if math.isnan(value):
            return "-"
        return "never" if abs(value) > NEVER else f"{value:.6g}"
    return str(value)
