"""What an ensemble does where a case runs: in a worker process, on another machine, or here."""

from __future__ import annotations

import contextvars
import ctypes
import dataclasses
import enum
import math
import os
import threading
import time
import traceback
from typing import Any, Callable, Mapping, Optional, Union

import numpy as np

from .errors import ArgumentError

Plain = Union[None, bool, int, float, str, "list[Plain]", "dict[str, Plain]"]

#: Options that models take while a case runs, unless they are given others: a machine runs as many cases as it has cores.
ONE_THREAD: Mapping[str, float] = {"threads": 1}
model_options: contextvars.ContextVar[Mapping[str, float]] = contextvars.ContextVar("model_options", default={})

#: Settings of the environment with which worker processes start.
ENVIRONMENT = {name: "1" for name in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS", "BLIS_NUM_THREADS")}


def run_case(function: Callable[..., Any], case: Any, own_process: bool) -> dict[str, Plain]:
    """Values and seconds of one case, or the error that ended it. KeyboardInterrupt alone is raised."""
    if own_process:
        one_blas_thread()
    began = time.perf_counter()
    found: dict[str, Plain] = {}
    before = model_options.set(ONE_THREAD)
    try:
        answer = function(**case) if isinstance(case, Mapping) else function(case)
        found["values"] = values_of(answer)
    except KeyboardInterrupt:
        raise
    except BaseException as error:  # sys.exit() in one case does not end the others
        found["error"] = f"{type(error).__name__}: {error}".strip()
        found["traceback"] = "".join(traceback.format_exception(type(error), error, error.__traceback__))
    finally:
        model_options.reset(before)
    found["seconds"] = round(time.perf_counter() - began, 6)
    return found


def values_of(answer: Any) -> dict[str, Plain]:
    """Plain values by name: of a mapping, of a report, or of one value, which is then called "value"."""
    if dataclasses.is_dataclass(answer) and not isinstance(answer, type):
        answer = dataclasses.asdict(answer)
    items = dict(answer) if isinstance(answer, Mapping) else {"value": answer}
    return {str(name): plain(value, f"the value {str(name)!r}") for name, value in items.items()}


def plain(value: Any, what: str) -> Plain:
    """Return a value without classes of numpy and tuples; an ArgumentError names what JSON cannot keep."""
    if isinstance(value, enum.Enum):
        return value.name
    if isinstance(value, (np.generic, np.ndarray)):
        value = value.tolist()
    if value is None or isinstance(value, (bool, str)):
        return value
    if isinstance(value, int):
        return int(value)
    if isinstance(value, float):
        return float(value)
    if isinstance(value, (list, tuple)):
        return [plain(one, what) for one in value]
    if isinstance(value, Mapping):
        return {str(name): plain(one, what) for name, one in value.items()}
    raise ArgumentError(f"{what} is a {type(value).__name__}; it must be made of numbers, words, lists and mappings")


def number_or_nan(value: Any) -> float:
    """A number, with NaN for what is not known or is no number."""
    return float(value) if isinstance(value, (bool, int, float)) else math.nan


def start_worker() -> None:
    """First call in a process of a pool: it ends when the process that started it has ended, however that came about."""
    import multiprocessing
    from multiprocessing import connection

    parent = multiprocessing.parent_process()
    if parent is None:
        return
    sentinel = parent.sentinel

    def watch() -> None:
        connection.wait([sentinel])
        os._exit(1)

    threading.Thread(target=watch, daemon=True).start()


def probe(function: Callable[..., Any]) -> int:
    """Nothing: that it returns shows that workers start and find the function."""
    return 0 if callable(function) else 1


_blas_limited = False


def one_blas_thread() -> None:
    """Calls of numpy between those of the library have one BLAS thread too; the library sees to its own calls."""
    global _blas_limited
    if _blas_limited:
        return
    _blas_limited = True
    set_threads: Optional[Any] = None
    try:
        from ._library import library_path

        set_threads = getattr(ctypes.CDLL(library_path), "openblas_set_num_threads", None)
    except OSError:
        pass  # statically linked, or another BLAS: the environment says it
    if set_threads is not None:
        set_threads(1)
