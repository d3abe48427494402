"""Many runs of one function: random bodies, design studies, sets of parameters."""

from __future__ import annotations

import csv
import functools
import html
import io
import math
import statistics
import sys
import time
from typing import Any, Callable, Iterable, Iterator, Mapping, Optional, Sequence, TextIO, Union, overload

import numpy as np
import numpy.typing as npt

from ._ensemble_engines import Engine, engine_for, outcomes
from ._ensemble_records import Path, ResultsFile, key_of, read_rows
from ._ensemble_worker import Plain, number_or_nan, plain
from ._library import version
from .errors import ArgumentError, FileError

Row = Mapping[str, Any]


class Ensemble(Sequence[Row]):
    """What ensemble() returns: a row for each case, in the order of the cases.

    A row has "case", "seconds", and "values" (by name) or "error" and "traceback".
    """

    def __init__(self, rows: Iterable[Row]) -> None:
        self._rows = list(rows)

    @overload
    def __getitem__(self, index: int) -> Row: ...

    @overload
    def __getitem__(self, index: slice) -> Ensemble: ...

    def __getitem__(self, index: Union[int, slice]) -> Union[Row, Ensemble]:
        return Ensemble(self._rows[index]) if isinstance(index, slice) else self._rows[index]

    def __len__(self) -> int:
        return len(self._rows)

    @property
    def errors(self) -> Ensemble:
        """The rows of cases that ended with an error."""
        return Ensemble(row for row in self._rows if "error" in row)

    @property
    def names(self) -> list[str]:
        """Names of the values, in the order in which they appear."""
        return list(dict.fromkeys(name for row in self._rows for name in row.get("values", ())))

    def values(self, name: str = "value") -> npt.NDArray[np.float64]:
        """One value of all cases; NaN where it is not known, or where the case ended with an error."""
        if name not in self.names:
            raise ArgumentError(f"ensemble: there is no value {name!r}; there are {', '.join(self.names) or 'none'}")
        return np.array([number_or_nan(row.get("values", {}).get(name)) for row in self._rows])

    def flat(self) -> list[dict[str, Any]]:
        """Rows with a column for each argument, value, the seconds and the error."""
        return [flat_row(row) for row in self._rows]

    def frame(self) -> Any:
        """The table as a DataFrame of pandas, which has to be installed."""
        try:
            import pandas
        except ImportError as problem:
            raise ArgumentError(f"frame: pandas is missing ({problem}); install Debian's package python3-pandas, or write_csv()") from None
        return pandas.DataFrame(self.flat())

    def write_csv(self, path: Path) -> None:
        """Write the table; numbers have all their digits."""
        rows = self.flat()
        columns = list(dict.fromkeys(name for row in rows for name in row))
        columns.sort(key=("seconds", "error").__contains__)
        text = io.StringIO(newline="")
        writer = csv.DictWriter(text, columns, restval="", lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
        try:
            with open(path, "w", encoding="utf-8", newline="") as file:
                file.write(text.getvalue())
        except OSError as problem:
            raise FileError(f"write_csv: {path} cannot be written: {problem.strerror}") from None

    def lines(self) -> list[list[str]]:
        """Cells of the summary: number, mean, deviation and range of each value that is a number."""
        cells = [["value", "cases", "mean", "deviation", "least", "largest"]]
        for name in self.names:
            known = [value for value in self.values(name).tolist() if math.isfinite(value)]
            if known:
                spread = statistics.stdev(known) if len(known) > 1 else math.nan
                cells.append([name, str(len(known))] + [short(value) for value in (statistics.fmean(known), spread, min(known), max(known))])
        return cells

    def __str__(self) -> str:
        cells = self.lines()
        widths = [max(len(row[k]) for row in cells) for k in range(len(cells[0]))]
        text = [f"{len(self)} cases, {len(self.errors)} with an error"]
        if len(cells) > 1:
            text += ["  ".join([row[0].ljust(widths[0])] + [c.rjust(w) for c, w in zip(row[1:], widths[1:])]) for row in cells]
        return "\n".join(text)

    __repr__ = __str__

    def _repr_html_(self) -> str:
        rows = "".join("<tr><td>" + "</td><td>".join(map(html.escape, row)) + "</td></tr>" for row in self.lines())
        return f"<p>{len(self)} cases, {len(self.errors)} with an error</p><table>{rows}</table>"


def ensemble(function: Callable[..., Any], cases: Union[int, Iterable[Any]], *, executor: Any = "processes",
             workers: Optional[int] = None, results: Optional[Path] = None, table: Optional[Path] = None,
             retry_errors: bool = False, file: Optional[TextIO] = None, quiet: bool = False) -> Ensemble:
    """Run a function for many cases, on all cores or on several machines, and return a table.

    function      builds a model, runs it, and returns a number, values by name, or a report. It stands at the top level of a
                  script or a module, as worker processes import it.
    cases         a number n stands for 0 to n - 1, seeds for instance. Else a list: a mapping gives keyword arguments,
                  anything else is the only argument. Give seeds, not generators of random numbers.
    executor      "processes" (a pool on this machine), "serial" (here), "mpi" (mpirun -np N python3 -m mpi4py.futures
                  SCRIPT), "dask" (a cluster on this machine), the address of a Dask scheduler, a Dask client, or any
                  executor of concurrent.futures.
    workers       processes of a pool; all cores that this process may use if not given.
    results       file with a line of JSON for each case, written as soon as the case has ended. If it exists, only cases
                  that it lacks are run, with whatever executor.
    table         CSV file, written at the end.
    retry_errors  cases whose row in `results` is an error are run again.
    quiet         no progress bar; else it goes to `file`, or to stderr.

    An error in a case becomes a row and does not end the run, and neither does a process of the pool that is killed.
    While a case runs, its models have one thread each unless they are given the option "threads". Scripts call ensemble() under
    `if __name__ == "__main__":`.

    >>> import bempd, math
    >>> found = bempd.ensemble(math.sqrt, [4.0, 9.0, -1.0], executor="serial", quiet=True)
    >>> found.values()
    array([ 2.,  3., nan])
    >>> found.errors[0]["error"]
    'ValueError: math domain error'
    """
    if not callable(function):
        raise ArgumentError(f"ensemble: function is {function!r}; give a function of a case")
    given = case_list(cases)
    if workers is not None and (isinstance(workers, bool) or not isinstance(workers, int) or workers < 1):
        raise ArgumentError(f"ensemble: workers is {workers!r}; give a whole number from 1 on")
    keys = keys_of(given)
    book = None if results is None else ResultsFile(results, name_of(function), version())
    try:
        rows: dict[str, Row] = {} if book is None else {
            key: row for key, row in book.rows.items() if not (retry_errors and "error" in row)}
        left = [(number, case) for number, case in enumerate(given) if keys[number] not in rows]
        if left:
            bar = Bar(len(given), len(left), sum("error" in rows.get(key, ()) for key in keys), None if quiet else file or sys.stderr)
            run(engine_for(executor, workers, function), function, left, keys, given, rows, book, bar)
    finally:
        if book is not None:
            book.close()
    found = Ensemble(rows[key] for key in keys)
    if table is not None:
        found.write_csv(table)
    return found


def run(engine: Engine, function: Callable[..., Any], left: Sequence[tuple[int, Any]], keys: Sequence[str], cases: Sequence[Any],
        rows: dict[str, Row], book: Optional[ResultsFile], bar: Bar) -> None:
    """Run what is left, and keep each result as it comes."""
    finished = False
    try:
        bar.show()
        for number, outcome in outcomes(engine, function, left):
            row = {"case": plain(cases[number], "case"), **outcome}
            if book is not None:
                book.add(row)
            rows[keys[number]] = row
            bar.advance("error" in row)
        finished = True
    finally:
        bar.finish()
        engine.close(interrupted=not finished)


def read_ensemble(*paths: Path) -> Ensemble:
    """The table of what ensemble() has written to one file or several, such as those of an array of jobs.

    Of a case that is in several files the last row counts, but a row with values goes before one with an error.

    >>> import bempd, math, tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     for part in range(2):
    ...         found = bempd.ensemble(math.sqrt, [4.0, 9.0][part::2], executor="serial", quiet=True,
    ...                                results=f"{folder}/part{part}.jsonl")
    ...     bempd.read_ensemble(f"{folder}/part0.jsonl", f"{folder}/part1.jsonl").values().tolist()
    [2.0, 3.0]
    """
    if not paths:
        raise ArgumentError("read_ensemble: no file is given")
    rows: dict[str, Row] = {}
    for path in paths:
        for key, row in read_rows(path).items():
            if key not in rows or "error" not in row or "error" in rows[key]:
                rows[key] = row
    return Ensemble(rows.values())


class Bar:
    """One line that tells how many cases are done, and how long the rest takes."""

    def __init__(self, cases: int, left: int, errors: int, stream: Optional[TextIO]) -> None:
        self._cases, self._left, self._errors, self._stream = cases, left, errors, stream
        self._ran, self._began, self._shown = 0, time.monotonic(), 0.0

    def advance(self, is_error: bool) -> None:
        self._ran += 1
        self._errors += is_error
        self.show()

    def show(self) -> None:
        now = time.monotonic()
        if self._stream is not None and self._stream.isatty() and now - self._shown >= 0.1:
            self._shown = now
            self._stream.write("\r" + self.line() + "\x1b[K")
            self._stream.flush()

    def finish(self) -> None:
        if self._stream is not None:
            self._stream.write(("\r" + self.line() + "\x1b[K\n") if self._stream.isatty() else self.line() + "\n")
            self._stream.flush()

    def line(self) -> str:
        done, seconds = self._cases - self._left + self._ran, time.monotonic() - self._began
        full = int(24 * done / self._cases)
        errors = f", {self._errors} with an error" if self._errors else ""
        to_go = f", {in_words(seconds / self._ran * (self._left - self._ran))} to go" if 0 < self._ran < self._left else ""
        return (f"{100 * done / self._cases:3.0f}% |{'█' * full}{' ' * (24 - full)}| {done} of {self._cases} cases{errors} "
                f"[{in_words(seconds)}{to_go}]")


def in_words(seconds: float) -> str:
    """A time in the unit that fits.

    >>> [in_words(seconds) for seconds in (2.34, 200, 20000)]
    ['2.3 s', '3 min 20 s', '5 h 33 min']
    """
    if seconds < 60:
        return f"{seconds:.1f} s"
    minutes, rest = divmod(round(seconds), 60)
    return f"{minutes} min {rest} s" if minutes < 60 else f"{minutes // 60} h {minutes % 60} min"


def case_list(cases: Union[int, Iterable[Any]]) -> list[Any]:
    """The cases one by one."""
    if isinstance(cases, int) and not isinstance(cases, bool) and cases >= 0:
        return list(range(cases))
    if isinstance(cases, (str, bytes, Mapping)) or not isinstance(cases, Iterable):
        raise ArgumentError(f"ensemble: cases are {cases!r}; give how many there are, or a list of them")
    return list(cases)


def keys_of(cases: Sequence[Any]) -> list[str]:
    """A text for each case, the same in every run; a case that cannot be written is refused, and so is one that comes twice."""
    keys: list[str] = []
    seen: dict[str, int] = {}
    for number, case in enumerate(cases):
        try:
            keys.append(key_of(plain(case, "it")))
        except ArgumentError:
            raise ArgumentError(f"ensemble: case {number} is {case!r}; cases are made of numbers, words, lists and mappings, and a "
                                "generator of random numbers is given by its seed") from None
        if keys[-1] in seen:
            raise ArgumentError(f"ensemble: cases {seen[keys[-1]]} and {number} are the same, {keys[-1]}; they would give the same: "
                                "give each a seed of its own")
        seen[keys[-1]] = number
    return keys


def name_of(function: Callable[..., Any]) -> str:
    """What a results file is begun with, so that it is not gone on with by another function."""
    if isinstance(function, functools.partial):
        given = [repr(one) for one in function.args] + [f"{name}={value!r}" for name, value in sorted(function.keywords.items())]
        return f"{name_of(function.func)}({', '.join(given)})"
    return str(getattr(function, "__qualname__", type(function).__qualname__))


def flat_row(row: Row) -> dict[str, Any]:
    """A row with a column for each number or word."""
    case = row["case"]
    flat: dict[str, Any] = dict(case) if isinstance(case, Mapping) else {"case": case}
    for name, value in row.get("values", {}).items():
        flat[name if name not in flat else f"{name} of the result"] = value
    flat["seconds"], flat["error"] = row.get("seconds"), row.get("error", "")
    return flat


def short(value: float) -> str:
    """A number of a summary; a stroke where there is none."""
    return "-" if math.isnan(value) else f"{value:.6g}"
