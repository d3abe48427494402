"""Python functions that the library calls: progress, log, values on boundaries."""

from __future__ import annotations

import logging
import pathlib
import sys
import time
import warnings
from typing import Any, Callable, List, Literal, Optional, TextIO, Tuple, Union

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
        self._model = model
        self.events_told = False  # in the present call

    def __call__(self, kind: Any, error: BaseException, traceback: Any) -> Optional[int]:
        again = any(isinstance(before, KeyboardInterrupt) for before in self._raised)
        self._raised.append(error)
        if not isinstance(error, KeyboardInterrupt) or again or not self.events_told:
            return None  # the call is cancelled
        lib.bempd_request_stop(self._model)
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
        if progress is not None:
            progress(string(phase), share, seconds, expected)
        return 0

    return ffi.callback("bempd_phase_function", told, error=1, onerror=interrupts)


def log_callback(raised: List[BaseException], model: Any, log: Log, with_names: Callable[[str], str]) -> Any:
    """What the library calls with a line of its log."""
    if isinstance(log, logging.Logger):
        logger = log
        write: Callable[[int, str], object] = lambda level, message: logger.log(_LEVELS[level], "%s", message)
    else:
        write = warn if isinstance(log, str) else log

    def told(level: int, message: Any, _: Any) -> None:
        write(level, with_names(in_python(string(message))))

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


class ProgressBar:
    """One line on stderr that follows a run; made by progress_bar()."""

    def __init__(self, stream: Optional[TextIO] = None, interval: float = 0.1) -> None:
        self._stream = stream
        self._interval = interval
        self._start, self._goal = 0.0, None  # type: float, Optional[float]
        self._began = self._shown = time.monotonic()
        self._events = self._first_events = 0
        self._line = ""

    def start(self, load_factor: float, goal: Optional[float]) -> None:
        """A run begins at a load factor; `goal` is where it will end, if that is known."""
        self._start, self._goal = load_factor, goal
        self._began, self._shown = time.monotonic(), 0.0
        self._first_events = -1
        self._line = ""

    def __call__(self, load_factor: float, events: int, broken_bonds: int) -> None:
        if self._first_events < 0:
            self._first_events = events - 1
        now = time.monotonic()
        seconds = now - self._began
        done = events - self._first_events
        rate = f", {done / seconds:.0f} events/s" if seconds > 0 else ""
        self._line = (f"{self._bar(load_factor)}load factor {load_factor:.6g}, "
                      f"{events} events, {broken_bonds} bonds [{seconds:.1f} s{rate}]")
        if now - self._shown >= self._interval and self._out().isatty():
            self._shown = now
            self._write("\r" + self._line + "\x1b[K")

    def finish(self) -> None:
        """The run has ended: leave its last line."""
        if self._line:
            self._write(("\r" + self._line + "\x1b[K\n") if self._out().isatty() else self._line + "\n")
            self._line = ""

    def _bar(self, load_factor: float) -> str:
        if self._goal is None or self._goal == self._start:
            return ""
        share = min(max((load_factor - self._start) / (self._goal - self._start), 0.0), 1.0)
        full = int(round(24 * share))
        return f"{100 * share:3.0f}% |{'█' * full}{' ' * (24 - full)}| "

    def _out(self) -> TextIO:
        # Looked up late: a host may replace sys.stderr.
        return self._stream if self._stream is not None else sys.stderr

    def _write(self, text: str) -> None:
        out = self._out()
        out.write(text)
        out.flush()


def progress_bar(stream: Optional[TextIO] = None) -> ProgressBar:
    """A progress function that shows one line on stderr: `model.progress = bempd.progress_bar()`.

    On a terminal the line is renewed ten times a second; elsewhere only the last one of each run is written.
    """
    return ProgressBar(stream)
