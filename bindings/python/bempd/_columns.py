"""Files of columns, whose headings may have names of supports: reaction_x_1 (clamp)."""

from __future__ import annotations

import csv
import os
import re
from typing import Any, Union

import numpy as np
import numpy.typing as npt

Path = Union[str, "os.PathLike[str]"]
_NAME = re.compile(r" \(.*\)$", re.DOTALL)


def read_columns(path: Path) -> npt.NDArray[Any]:
    """A file of columns as a structured array; names of supports are left out of the names of columns."""
    with open(path, encoding="utf-8", newline="") as file:
        heading = next(csv.reader(file))
        values = np.genfromtxt(file, delimiter=",", names=[_NAME.sub("", column) for column in heading], dtype=np.float64)
    return np.atleast_1d(values)
