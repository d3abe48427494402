"""Headings of files of columns: with the names of supports when they are written, without them when they are read."""

from __future__ import annotations

import csv
import os
import re
from typing import Any, Union

import numpy as np
import numpy.typing as npt

from ._sketch import Sketch
from .errors import FileError

Path = Union[str, "os.PathLike[str]"]
_OF_SUPPORT = re.compile(r"(?:reaction|reaction_before|displacement)_[xy]_(\d+)")
_NAME = re.compile(r" \(.*\)$", re.DOTALL)


def name_columns(sketch: Sketch, path: Path) -> None:
    """Put the names of supports into the heading of a history: reaction_x_1 becomes "reaction_x_1 (clamp)". Without names the file
    stays as it is."""
    names = {number: name for (what, number), name in sketch.names.items() if what == "support"}
    if not names:
        return
    try:
        with open(path, encoding="utf-8", newline="") as file:
            heading, rest = file.readline().rstrip("\n").split(","), file.read()
        beside = f"{os.fsdecode(path)}.named"
        with open(beside, "w", encoding="utf-8", newline="") as file:
            csv.writer(file, lineterminator="\n").writerow([_named(column, names) for column in heading])
            file.write(rest)
        os.replace(beside, path)
    except OSError as problem:
        raise FileError(f"write_history: {os.fsdecode(path)} cannot be written: {problem}") from None


def _named(column: str, names: dict[int, str]) -> str:
    found = _OF_SUPPORT.fullmatch(column)
    name = names.get(int(found[1])) if found else None
    return f"{column} ({name})" if name else column


def read_columns(path: Path) -> npt.NDArray[Any]:
    """A file of columns as a structured array; names of supports are left out of the names of columns."""
    with open(path, encoding="utf-8", newline="") as file:
        heading = next(csv.reader(file))
        values = np.genfromtxt(file, delimiter=",", names=[_NAME.sub("", column) for column in heading], dtype=np.float64)
    return np.atleast_1d(values)
