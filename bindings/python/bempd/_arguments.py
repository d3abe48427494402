"""Converts what a user gives into what the library takes; refuses what cannot be meant."""

from __future__ import annotations

import operator
import os
from typing import Any, Optional, Sequence, TypeVar, Union

import numpy as np
import numpy.typing as npt

from ._library import ffi
from .errors import ArgumentError

FloatArray = npt.NDArray[np.float64]
Value = TypeVar("Value")


def real_array(name: str, value: npt.ArrayLike) -> FloatArray:
    """Any array of real numbers as contiguous doubles; copied if it is not that already."""
    try:
        array = np.asarray(value)
    except ValueError:
        raise ArgumentError(f"{name} has rows of different lengths; give an array of numbers") from None
    if array.dtype.kind not in "iuf":
        raise ArgumentError(f"{name} has the dtype {array.dtype}; give real numbers")
    if isinstance(value, np.ma.MaskedArray) and np.any(value.mask):
        raise ArgumentError(f"{name} has masked entries; give numbers only")
    return np.asarray(array, dtype=np.float64, order="C")


def point_array(name: str, value: npt.ArrayLike) -> FloatArray:
    """Points as an array of shape (n, 2)."""
    array = real_array(name, value)
    if array.ndim != 2 or array.shape[1] != 2:
        raise ArgumentError(f"{name} has the shape {array.shape}; give n points as an array of shape (n, 2)")
    return array


def pairs(array: FloatArray) -> list[tuple[float, float]]:
    """Points as pairs of Python's numbers."""
    return [(float(x), float(y)) for x, y in array]


def one_number(values: Optional[npt.ArrayLike]) -> Optional[float]:
    """The number that all values are; None if they differ, 0 if there are none."""
    if values is None:
        return 0.0
    array = np.asarray(values, dtype=np.float64).ravel()
    return float(array[0]) if array.size and (array == array[0]).all() else None


def bulge_array(name: str, value: Optional[npt.ArrayLike], edges: int) -> Optional[FloatArray]:
    """One number for each edge of a loop, or none at all."""
    if value is None:
        return None
    array = real_array(name, value)
    if array.shape != (edges,):
        raise ArgumentError(f"{name} has the shape {array.shape}; give one number for each of the {edges} edges")
    return array


def doubles(array: Optional[FloatArray]) -> Any:
    """Pointer to the numbers of an array, which must live through the call; NULL for None."""
    return ffi.NULL if array is None else ffi.from_buffer("double[]", array)


def real(name: str, value: Any) -> float:
    """A real number."""
    if isinstance(value, (str, bytes)):
        raise ArgumentError(f"{name} is {value!r}; it must be a number")
    try:
        return float(value)
    except (TypeError, ValueError, OverflowError):
        raise ArgumentError(f"{name} is {value!r}; it must be a number") from None


def whole(name: str, value: Any) -> int:
    """A whole number."""
    try:
        return operator.index(value)
    except TypeError:
        raise ArgumentError(f"{name} is {value!r}; it must be a whole number") from None


def samples(name: str, constant: Optional[npt.ArrayLike],
            proportional: Optional[npt.ArrayLike]) -> tuple[int, Any, Any]:
    """(count, constant, proportional) of values along an edge; a single number stands for all of them."""
    given = [None if part is None else np.atleast_1d(real_array(f"{name}: {what}", part))
             for what, part in (("constant", constant), ("proportional", proportional))]
    counts = {part.size for part in given if part is not None}
    if not counts:
        raise ArgumentError(f"{name}: no value is given; give proportional, constant or both")
    count = max(counts)
    if not counts <= {1, count} or 0 in counts or any(part is not None and part.ndim != 1 for part in given):
        shapes = " and ".join(str(part.shape) for part in given if part is not None)
        raise ArgumentError(f"{name}: values have the shape {shapes}; "
                            "give a number, or the same number of values for both")
    # Arrays that own their numbers: the pointers made of them keep them alive.
    filled = [None if part is None else np.ascontiguousarray(np.broadcast_to(part, count)) for part in given]
    return count, doubles(filled[0]), doubles(filled[1])


def pair_values(name: str, constant: Optional[npt.ArrayLike],
                proportional: Optional[npt.ArrayLike]) -> tuple[int, Any, Any]:
    """(count, constant, proportional) of values with two components each."""
    given = [None if part is None else point_array(f"{name}: {what}", part)
             for what, part in (("constant", constant), ("proportional", proportional))]
    counts = {len(part) for part in given if part is not None}
    if len(counts) != 1:
        shapes = " and ".join(str(part.shape) for part in given if part is not None) or "none"
        raise ArgumentError(f"{name}: values have the shape {shapes}; give proportional, constant or both, of one shape")
    return counts.pop(), doubles(given[0]), doubles(given[1])


def values_at(name: str, fractions: npt.ArrayLike, constant: Optional[npt.ArrayLike],
              proportional: Optional[npt.ArrayLike]) -> tuple[Any, int, Any, Any]:
    """(fractions, count, constant, proportional) of values at places along an edge."""
    places = real_array(f"{name}: fractions", fractions)
    count, *values = pair_values(name, constant, proportional)
    if places.shape != (count,):
        raise ArgumentError(f"{name}: fractions have the shape {places.shape} and there are values for {count} places; "
                            "give a fraction for each pair of values")
    return doubles(places), count, values[0], values[1]


def place(name: str, point: Sequence[float]) -> tuple[float, float]:
    """The coordinates of one point."""
    array = real_array(name, point)
    if array.shape != (2,):
        raise ArgumentError(f"{name} has the shape {array.shape}; give a pair (x, y)")
    return float(array[0]), float(array[1])


def interval(name: str, value: Any) -> tuple[float, float]:
    """A coordinate as an interval of one value, or the two ends of an interval."""
    array = real_array(name, value)
    if array.shape == () and np.isfinite(array):
        return float(array), float(array)
    if array.shape != (2,) or not array[0] <= array[1]:
        raise ArgumentError(f"{name} is {value!r}; give a number, or a pair (low, high)")
    return float(array[0]), float(array[1])


def fraction_pair(name: str, part: Sequence[float]) -> tuple[float, float]:
    """Start and end of a part of an edge."""
    array = real_array(name, part)
    if array.shape != (2,):
        raise ArgumentError(f"{name} has the shape {array.shape}; give a pair (start, end) of fractions of the edge")
    return float(array[0]), float(array[1])


def text(name: str, value: Any) -> bytes:
    """A word as the library reads it."""
    if not isinstance(value, str):
        raise ArgumentError(f"{name} is {value!r}; it must be a string")
    return _terminated(name, value.encode("utf-8", "surrogatepass"))


def file_name(name: str, value: Union[str, "os.PathLike[str]"]) -> bytes:
    """A path as the library reads it."""
    try:
        return _terminated(name, os.fsencode(value))
    except TypeError:
        raise ArgumentError(f"{name} is {value!r}; it must be a path") from None


def word(name: str, value: Any) -> bytes:
    """A text that is not empty, as the library reads it."""
    if not isinstance(value, str) or not value:
        raise ArgumentError(f"{name} is {value!r}; it must be a word")
    return _terminated(name, value.encode("utf-8"))


def _terminated(name: str, value: bytes) -> bytes:
    if b"\0" in value:
        raise ArgumentError(f"{name} contains a zero byte; remove it")
    return value


def choice(name: str, value: Any, choices: dict[str, Value]) -> Value:
    """The entry of one of a few words."""
    if not isinstance(value, str) or value not in choices:
        raise ArgumentError(f"{name} is {value!r}; it must be one of {', '.join(repr(word) for word in choices)}")
    return choices[value]
