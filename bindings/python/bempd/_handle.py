"""The library's model with what must live as long as it does."""

from __future__ import annotations

import threading
from typing import Any, Callable

from ._interrupts import Heard
from ._library import call, check, ffi, invoke, lib
from ._words import name_of
from .callbacks import Interrupts
from .errors import OrderError


class Handle:
    """Owner of a model of the library.

    Freed when nothing refers to it any more: neither a Model, nor an array that looks at the library's memory, nor a
    call that runs in another thread.
    """

    def __init__(self) -> None:
        created = ffi.new("bempd_model **")
        call("bempd_model_create", created)
        self.pointer = ffi.gc(created[0], lib.bempd_model_free)
        self.callbacks: list[Any] = []  # of supports and loads; the library may call them until it is freed
        self.progress: Any = None  # the callbacks in use
        self.phases: Any = None
        self.log: Any = None
        self.raised: list[BaseException] = []  # by callbacks during the present call
        self.interrupts = Interrupts(self.raised, self.pointer)
        self._lock = threading.Lock()
        self.interrupts.is_running = self._lock.locked
        self._views: set[object] = set()

    def call(self, name: str, *arguments: Any, changes: bool = False, invoke: Callable[..., int] = invoke,
             check: Callable[..., None] = check) -> None:
        """Call a function on the model; `changes` marks those after which field views would be stale. `invoke` and `check`
        are those of another library for its functions."""
        short = name_of(name).replace("Model.", "")
        if not self._lock.acquire(blocking=False):
            raise OrderError(f"{short}: the model is in another call; "
                             "from a callback or another thread only request_cancel() is allowed")
        try:
            if changes and self._views:
                raise OrderError(f"{short}: {len(self._views)} array(s) made by view_field() still look at the model's "
                                 "fields; drop them before the model changes, or use field()")
            self.raised.clear()
            self.interrupts.events_told = False
            with Heard(self.interrupts):
                status = invoke(name, self.pointer, *arguments)
            if self.raised:
                raise self.raised.pop(0)
            check(status, self.pointer)
        finally:
            self._lock.release()

    def view(self, name: str, region: int, field: int) -> tuple[memoryview, int, int]:
        """The library's memory of a field, read-only, as (bytes, count, components); in use until it is dropped."""
        values, count = ffi.new("const double **"), ffi.new("int64_t *")
        components, generation = ffi.new("int32_t *"), ffi.new("int64_t *")
        ticket = object()
        # The ticket is added before the call, so that no other thread changes the model between the call and the
        # ticket.
        self._views.add(ticket)
        try:
            self.call(name, region, field, values, count, components, generation)
        except BaseException:
            self._views.discard(ticket)
            raise
        memory = ffi.gc(values[0], lambda _: self._views.discard(ticket))
        bytes_of = ffi.buffer(memory, count[0] * components[0] * ffi.sizeof("double"))
        return memoryview(bytes_of).toreadonly(), count[0], components[0]
