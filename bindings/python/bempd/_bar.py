"""The progress bar: one line that follows a run, from its first second on."""

from __future__ import annotations

import sys
import threading
import time
from typing import Optional, TextIO

# Seconds after which a run that writes to a file or a log is told of for the first time, and then again and again.
FIRST_LINE, NEXT_LINES = 1.0, 10.0
# Seconds of a part of a call from which on it is shown in place of the events before it.
WORTH_SAYING = 1.0


def _time(seconds: float) -> str:
    """Seconds as people say them."""
    if seconds < 100:
        return f"{seconds:.1f} s" if seconds < 10 else f"{seconds:.0f} s"
    minutes = seconds / 60
    return f"{minutes:.0f} min" if minutes < 100 else f"{minutes / 60:.1f} h"


class ProgressBar:
    """One line on stderr that follows a run; made by progress_bar()."""

    def __init__(self, stream: Optional[TextIO] = None, interval: float = 0.1) -> None:
        self._stream = stream
        self._interval = interval
        self._start, self._goal = 0.0, None  # type: float, Optional[float]
        self._began = self._shown = time.monotonic()
        self._load_factor, self._events, self._bonds, self._first_event = 0.0, 0, 0, -1
        self._phase = ""
        self._phase_share = self._phase_expected = self._phase_began = 0.0
        self._width = 0  # of the line on the terminal
        self._lock = threading.Lock()
        self._ended: Optional[threading.Event] = None  # of the run that is followed

    def start(self, load_factor: float, goal: Optional[float]) -> None:
        """A run begins at a load factor; `goal` is where it will end, if that is known."""
        self._start, self._goal, self._load_factor = load_factor, goal, load_factor
        self._began = self._shown = time.monotonic()
        self._first_event, self._phase, self._width = -1, "", 0
        if not self._is_live():
            self._shown += FIRST_LINE - NEXT_LINES
        self._ended = threading.Event()
        # The line goes on while the library computes without a word.
        threading.Thread(target=self._follow, args=(self._ended,), name="bempd progress", daemon=True).start()

    def __call__(self, load_factor: float, events: int, broken_bonds: int) -> None:
        with self._lock:
            if self._first_event < 0:
                self._first_event = events - 1
            self._load_factor, self._events, self._bonds, self._phase = load_factor, events, broken_bonds, ""
            self._show(self._interval)

    def phase(self, name: str, share: float, seconds: float, expected: float) -> None:
        """A long part of a call is this far."""
        if self._ended is None:
            return
        with self._lock:
            if self._first_event >= 0 and max(seconds, expected) < WORTH_SAYING:
                return
            self._phase, self._phase_share, self._phase_expected = name, share, expected
            self._phase_began = time.monotonic() - seconds
            self._show(self._interval)

    def finish(self) -> None:
        """The run has ended: leave its last line."""
        if self._ended is not None:
            self._ended.set()
        self._ended = None
        with self._lock:
            self._phase = ""
            if self._first_event >= 0:
                self._write(self._line(ended=True), last=True)
            elif self._width > 0:
                self._write("", last=False)
            self._first_event, self._width = -1, 0

    def _follow(self, ended: threading.Event) -> None:
        while not ended.wait(1.0):
            with self._lock:
                if not ended.is_set():
                    self._show(1.0)

    def _line(self, ended: bool = False) -> str:
        seconds = time.monotonic() - self._began
        if self._phase:
            return self._line_of_phase()
        if self._first_event < 0:
            return f"load factor {self._load_factor:.6g} [{_time(seconds)}]"
        share = self._share()
        bar = "" if share is None else self._drawn(share)
        to_go = f", {_time(seconds * (1 - share) / share)} to go" if share is not None and not ended and 0 < share < 1 else ""
        done = self._events - self._first_event
        rate = f", {done / seconds:.0f} events/s" if done >= seconds > 0 else ""
        return (f"{bar}load factor {self._load_factor:.6g}, {self._events} events, {self._bonds} bonds "
                f"[{_time(seconds)}{to_go}{rate}]")

    def _line_of_phase(self) -> str:
        spent = time.monotonic() - self._phase_began
        # What is known is the share at the last word; it is carried on to now.
        share = min(spent / self._phase_expected, 0.99) if self._phase_expected > 0 else self._phase_share
        to_go = f", {_time(max(self._phase_expected - spent, 0.0))} to go" if self._phase_expected > 0 else ""
        return f"{self._drawn(share)}{self._phase} [{_time(spent)}{to_go}]"

    def _share(self) -> Optional[float]:
        if self._goal is None or self._goal == self._start:
            return None
        return min(max((self._load_factor - self._start) / (self._goal - self._start), 0.0), 1.0)

    @staticmethod
    def _drawn(share: float) -> str:
        full = int(round(24 * share))
        return f"{100 * share:3.0f}% |{'█' * full}{' ' * (24 - full)}| "

    def _show(self, interval: float) -> None:
        now = time.monotonic()
        if now - self._shown < (interval if self._is_live() else NEXT_LINES) - 1e-3:
            return
        self._shown = now
        self._write(self._line(), last=not self._is_live())

    def _out(self) -> TextIO:
        # Looked up late: a host may replace sys.stderr.
        return self._stream if self._stream is not None else sys.stderr

    def _is_live(self) -> bool:
        """Whether the line can be renewed: on a terminal and in a notebook."""
        out = self._out()
        return out.isatty() or type(out).__module__.startswith("ipykernel.")

    def _write(self, line: str, last: bool) -> None:
        out = self._out()
        if self._is_live():
            # Notebooks know no escape sequences; spaces cover what was longer before.
            out.write("\r" + line.ljust(self._width) + ("\n" if last else ("" if line else "\r")))
            self._width = 0 if last else len(line)
        else:
            out.write(line + "\n")
        out.flush()


def progress_bar(stream: Optional[TextIO] = None) -> ProgressBar:
    """A progress function that shows one line on stderr: `model.progress = bempd.progress_bar()`.

    It says which part of the call runs (preparing, factorization, events), its share and the time to go. On a terminal and in
    a notebook the line is renewed ten times a second. In a file or a log a line is written after a second, then every ten
    seconds, and at the end of each run.
    """
    return ProgressBar(stream)
