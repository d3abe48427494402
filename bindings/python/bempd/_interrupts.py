"""Ctrl-C while the library works: Python itself hears it only when the library returns or calls back."""

from __future__ import annotations

import os
import signal
import sys
import threading
from types import TracebackType
from typing import Any, Optional, Type

from ._library import lib

# Seconds after which a run that has not ended yet says that it has heard.
_WORD_AFTER = 1.0


def is_interactive() -> bool:
    """Whether somebody types at this interpreter, who would lose more than the call with the process."""
    return hasattr(sys, "ps1") or "ipykernel" in sys.modules or bool(sys.flags.interactive)


class Ear:
    """A thread that the system tells of signals while the main thread is in the library. There is one a process.

    The first Ctrl-C asks the call to end: with the events that it has done if there was one, else as it was before. A second
    one in the same call ends the process, or cancels the call where somebody types at the interpreter."""

    def __init__(self) -> None:
        self._pipe: Optional[tuple[int, int]] = None
        self._interrupts: Any = None  # of the call that runs
        self._times = 0
        self._before = -1  # file descriptor that was told of signals before
        self._lock = threading.Lock()
        self._ended = threading.Event()

    def _ready(self) -> bool:
        """Whether Ctrl-C is Python's own KeyboardInterrupt, and this thread the one that hears it."""
        if threading.current_thread() is not threading.main_thread():
            return False
        if self._interrupts is not None:
            if self._interrupts.is_running():
                return False  # this call is made by a callback of the other one
            self.end()  # KeyboardInterrupt came between that call and its end()
        if signal.getsignal(signal.SIGINT) is not signal.default_int_handler:
            return False
        if self._pipe is None:
            self._pipe = os.pipe()
            os.set_blocking(self._pipe[1], False)
            threading.Thread(target=self._listen, args=(self._pipe[0],), name="bempd Ctrl-C", daemon=True).start()
        return True

    def begin(self, interrupts: Any) -> bool:
        """A call begins; says whether end() is due."""
        if not self._ready() or self._pipe is None:
            return False
        try:
            self._before = signal.set_wakeup_fd(self._pipe[1], warn_on_full_buffer=False)
        except ValueError:  # a thread of another interpreter
            return False
        self._ended.clear()
        with self._lock:
            self._interrupts, self._times = interrupts, 0
        return True

    def end(self) -> None:
        """The call has returned."""
        with self._lock:
            self._interrupts = None
        self._ended.set()
        signal.set_wakeup_fd(self._before, warn_on_full_buffer=False)

    def forget(self) -> None:
        """In a forked process there is no thread that listens."""
        self.__init__()  # type: ignore[misc]

    def _listen(self, pipe: int) -> None:
        while True:
            numbers = os.read(pipe, 64)
            if self._before >= 0:
                try:
                    os.write(self._before, numbers)
                except OSError:
                    pass
            for number in numbers:
                if number == signal.SIGINT:
                    self._heard()

    def _heard(self) -> None:
        with self._lock:
            interrupts = self._interrupts
            if interrupts is None or not interrupts.is_running():
                return
            self._times += 1
            if self._times == 1 and interrupts.events_told:
                lib.bempd_request_stop(interrupts.model)
                threading.Thread(target=self._say, name="bempd Ctrl-C heard", daemon=True).start()
            elif self._times == 1 or is_interactive():
                lib.bempd_request_cancel(interrupts.model)
            else:
                sys.stderr.write("\nbempd: ended by a second Ctrl-C\n")
                sys.stderr.flush()
                sys.stdout.flush()
                os._exit(128 + signal.SIGINT)

    def _say(self) -> None:
        if not self._ended.wait(_WORD_AFTER):
            again = "cancels the call" if is_interactive() else "ends the process"
            sys.stderr.write(f"\nbempd: Ctrl-C: the call ends, what it has done is kept; once more {again}\n")
            sys.stderr.flush()


_EAR = Ear()
if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_EAR.forget)


class Heard:
    """With this around a call Ctrl-C is heard while it runs."""

    def __init__(self, interrupts: Any) -> None:
        self._interrupts = interrupts
        self._is_begun = False

    def __enter__(self) -> None:
        self._is_begun = _EAR.begin(self._interrupts)

    def __exit__(self, kind: Optional[Type[BaseException]], error: Optional[BaseException],
                 traceback: Optional[TracebackType]) -> None:
        if self._is_begun:
            _EAR.end()
