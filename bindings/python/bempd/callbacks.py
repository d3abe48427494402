"""Python functions that the library calls: progress, log, values on boundaries."""

from __future__ import annotations

import logging
import pathlib
import sys
import warnings
from typing import Any, Callable, List, Literal, Optional, Tuple, Union

import numpy as np

from ._library import ffi, lib, string
from ._words import in_python
from .errors import ArgumentError, Warning

Pair = Tuple[float, float]
#: Called as f(load_factor, events, broken_bonds) after every event; an exception cancels the step and is raised again.
Progress = Callable[[float, int, int], object]
#: Called as f(phase, share, seconds, expected) inside long parts of calls: what is done, the share of it, the seconds so
#: far and those expected in all, 0 if nothing is known yet; an exception cancels the call and is raised again.
PhaseProgress = Callable[[str, float, float, float], object]
#: A logger; a function called as f(level, message): level 1 warning, 2 information, 3 detail; or "warnings", by which
#: warnings go to Python's module of this name and the rest is dropped.
Log = Union[logging.Logger, Callable[[int, str], object], Literal["warnings"]]
#: Called as f(x, y); gives (ux, uy), multiplied by the load factor, or a pair of pairs (constant, proportional).
BoundaryFunction = Callable[[float, float], Union[Pair, Tuple[Pair, Pair]]]

_LEVELS = {1: logging.WARNING, 2: logging.INFO, 3: logging.DEBUG}


_PACKAGE = str(pathlib.Path(__file__).resolve().parent)


def warn(level: int, message: str) -> None:
    """Hand a warning of the library to Python's warnings, as one of the line outside this package that made the call."""
    if level != 1:
        return
    frame = sys._getframe(1)
    while frame.f_back is not None and str(pathlib.Path(frame.f_code.co_filename).parent) == _PACKAGE:
        frame = frame.f_back
    warnings.warn_explicit(message, Warning, frame.f_code.co_filename, frame.f_lineno, frame.f_globals.get("__name__", "__main__"),
                           frame.f_globals.setdefault("__warningregistry__", {}))


def _keeper(raised: List[BaseException]) -> Callable[[Any, BaseException, Any], None]:
    """Keeps what a callback raises until the library has returned."""
    return lambda kind, error, traceback: raised.append(error)


def callable_or_none(name: str, function: Any) -> Any:
    """The function, if it is one."""
    if function is not None and not callable(function):
        raise ArgumentError(f"{name} is {function!r}; give a function or None")
    return function


class Interrupts:
    """What becomes of exceptions in progress functions. Ctrl-C ends a step that has done something after its present
    event and keeps that; pressed again, or before the first event, it cancels the call, as other exceptions do."""

    def __init__(self, raised: List[BaseException], model: Any) -> None:
        self._raised = raised
        self.model = model
        self.events_told = False  # in the present call
        self.is_running: Callable[[], bool] = lambda: False  # whether the model is in a call
        self.follower: Optional[PhaseProgress] = None  # that shows phases beside the user's own function

    def __call__(self, kind: Any, error: BaseException, traceback: Any) -> Optional[int]:
        again = any(isinstance(before, KeyboardInterrupt) for before in self._raised)
        self._raised.append(error)
        if not isinstance(error, KeyboardInterrupt) or again or not self.events_told:
            return None  # the call is cancelled
        lib.bempd_request_stop(self.model)
        return 0


def progress_callback(interrupts: Interrupts, progress: Optional[Progress]) -> Any:
    """What the library calls after every event. It is set even without a function of the user: it gives the interpreter
    a chance to raise KeyboardInterrupt."""

    def told(load_factor: float, events: int, broken_bonds: int, _: Any) -> int:
        interrupts.events_told = True
        if progress is not None:
            progress(load_factor, events, broken_bonds)
        return 0

    return ffi.callback("bempd_progress_function", told, error=1, onerror=interrupts)


def phase_callback(interrupts: Interrupts, progress: Optional[PhaseProgress]) -> Any:
    """The same inside long parts of calls."""

    def told(phase: Any, share: float, seconds: float, expected: float, _: Any) -> int:
        for each in (progress, interrupts.follower):
            if each is not None:
                each(string(phase), share, seconds, expected)
        return 0

    return ffi.callback("bempd_phase_function", told, error=1, onerror=interrupts)


def log_callback(raised: List[BaseException], model: Any, log: Log) -> Any:
    """What the library calls with a line of its log."""
    if isinstance(log, logging.Logger):
        logger = log
        write: Callable[[int, str], object] = lambda level, message: logger.log(_LEVELS[level], "%s", message)
    else:
        write = warn if isinstance(log, str) else log

    def told(level: int, message: Any, _: Any) -> None:
        write(level, in_python(string(message)))

    keep = _keeper(raised)

    def failed(kind: Any, error: BaseException, traceback: Any) -> None:
        keep(kind, error, traceback)
        lib.bempd_request_cancel(model)  # a log function has no result that could do it

    return ffi.callback("bempd_log_function", told, onerror=failed)


def boundary_callback(raised: List[BaseException], function: BoundaryFunction) -> Any:
    """What the library calls for values on a boundary."""
    if not callable(function):
        raise ArgumentError(f"function is {function!r}; give a function of x and y")

    def asked(x: float, y: float, constant: Any, proportional: Any, _: Any) -> int:
        value = np.asarray(function(x, y), dtype=np.float64)
        if value.shape == (2,):
            proportional[0], proportional[1] = value
        elif value.shape == (2, 2):
            (constant[0], constant[1]), (proportional[0], proportional[1]) = value
        else:
            raise ArgumentError(f"the function of the boundary gave shape {value.shape} at ({x:g}, {y:g}); "
                                "give (x, y), or a pair of them: constant and proportional")
        return 0

    return ffi.callback("bempd_boundary_function", asked, error=1, onerror=_keeper(raised))
