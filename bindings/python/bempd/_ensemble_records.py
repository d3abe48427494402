"""Results of an ensemble in a file: a line of JSON for each case, written as soon as the case has ended."""

from __future__ import annotations

import json
import math
import os
import pathlib
import warnings
from typing import Any, Mapping, Optional, TextIO, Union

from ._ensemble_worker import Plain
from .errors import ArgumentError, FileError, Warning

Path = Union[str, "os.PathLike[str]"]


def encoded(value: Plain) -> str:
    """JSON that every reader takes: NaN is null, an infinite number is one that is too large for a double.

    >>> encoded({"load": float("inf"), "stress": float("nan"), "bonds": [1, 2.5]})
    '{"load": 1e999, "stress": null, "bonds": [1, 2.5]}'
    """
    if isinstance(value, float) and not math.isfinite(value):
        return "null" if math.isnan(value) else ("1e999" if value > 0 else "-1e999")
    if isinstance(value, list):
        return "[" + ", ".join(encoded(one) for one in value) + "]"
    if isinstance(value, dict):
        return "{" + ", ".join(f"{json.dumps(name)}: {encoded(one)}" for name, one in value.items()) + "}"
    return json.dumps(value)


def key_of(case: Plain) -> str:
    """What two cases have in common that are the same: keyword arguments may come in any order."""
    return encoded(dict(sorted(case.items()))) if isinstance(case, dict) else encoded(case)


class ResultsFile:
    """The file of one ensemble: what it holds already, and a line more for each result. One run at a time writes it."""

    def __init__(self, path: Path, name: str, version: str) -> None:
        self.path = pathlib.Path(path)
        try:
            self.path.parent.mkdir(parents=True, exist_ok=True)
            self._stream: TextIO = open(self.path, "a+", encoding="utf-8", newline="\n")
        except OSError as problem:
            raise FileError(f"ensemble: results cannot be written to {self.path}: {problem.strerror}") from None
        try:
            self._lock()
            self.rows = self._begin(name, version)
        except BaseException:
            self._stream.close()
            raise

    def _begin(self, name: str, version: str) -> dict[str, dict[str, Any]]:
        self._stream.seek(0)
        text = self._stream.read()
        # A run that was killed while it wrote leaves a last line that is not whole.
        whole = text[: text.rfind("\n") + 1]
        if not whole and text.startswith('{"ensemble": '[: len(text)]):
            if text:
                self._stream.truncate(0)
            self._write(encoded({"ensemble": name, "bempd": version}))
            return {}
        head, rows = parsed(whole or text, self.path)
        if head["ensemble"] != name:
            raise ArgumentError(f"ensemble: {self.path} has results of {head['ensemble']}, not of {name}; give another file")
        if head.get("bempd") != version:
            warnings.warn(f"{self.path} was begun by version {head.get('bempd')} of bempd, and goes on with {version}", Warning,
                          stacklevel=4)
        self._stream.truncate(len(whole.encode("utf-8")))
        return rows

    def _lock(self) -> None:
        try:
            import fcntl
        except ImportError:
            return
        try:
            fcntl.flock(self._stream.fileno(), fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise ArgumentError(f"ensemble: another run writes {self.path} now; wait for its end, or give another file") from None
        except OSError:
            pass  # a file system without locks

    def _write(self, line: str) -> None:
        try:
            self._stream.write(line + "\n")
            self._stream.flush()
        except OSError as problem:
            raise FileError(f"ensemble: a result cannot be written to {self.path}: {problem.strerror}") from None

    def add(self, row: Mapping[str, Plain]) -> None:
        """One more result, which is in the file when this returns."""
        self._write(encoded(dict(row)))

    def close(self) -> None:
        self._stream.close()


def parsed(text: str, path: pathlib.Path) -> tuple[dict[str, Any], dict[str, dict[str, Any]]]:
    """Heading and rows by case; of several rows of a case the last."""
    head: Optional[dict[str, Any]] = None
    rows: dict[str, dict[str, Any]] = {}
    for number, line in enumerate(text.splitlines(), start=1):
        try:
            entry = json.loads(line)
            if head is None:
                head = {"ensemble": entry["ensemble"], **entry}
            elif "ensemble" not in entry:
                rows[key_of(entry["case"])] = {"case": entry["case"], **entry}
        except (ValueError, TypeError, KeyError):
            raise ArgumentError(f"ensemble: line {number} of {path} is not one of an ensemble; give another file") from None
    if head is None:
        raise ArgumentError(f"ensemble: {path} is empty; give a file that an ensemble has written")
    return head, rows


def read_rows(path: Path) -> dict[str, dict[str, Any]]:
    """Rows of a file by case; a last line that is not whole does not count."""
    try:
        text = pathlib.Path(path).read_text(encoding="utf-8")
    except OSError as problem:
        raise FileError(f"read_ensemble: {path} cannot be read: {problem.strerror}") from None
    return parsed(text[: text.rfind("\n") + 1], pathlib.Path(path))[1]
