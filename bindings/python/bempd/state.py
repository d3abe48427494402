"""Saved states."""

from __future__ import annotations

import os
from typing import Any, Union

from ._arguments import file_name
from ._library import call, ffi, lib
from .errors import ArgumentError


class State:
    """State of a run, made by Model.save(); can be pickled and written as bytes.

    It fits the model that was saved and every model built in the same way.
    """

    def __init__(self, pointer: Any) -> None:
        self.pointer = ffi.gc(pointer, lib.bempd_state_free)

    def to_bytes(self) -> bytes:
        """Bytes with magic, version, byte order and checksum."""
        needed = ffi.new("int64_t *")
        call("bempd_state_to_bytes", self.pointer, 0, ffi.NULL, needed)
        buffer = ffi.new("uint8_t[]", needed[0])
        call("bempd_state_to_bytes", self.pointer, needed[0], buffer, ffi.NULL)
        return bytes(ffi.buffer(buffer))

    @classmethod
    def from_bytes(cls, data: bytes) -> State:
        """The state that was written; damaged bytes are an ArgumentError."""
        try:
            size = memoryview(data).nbytes
            buffer = ffi.from_buffer("uint8_t[]", data)
        except (TypeError, ValueError, BufferError):
            kind = type(data).__name__
            raise ArgumentError(f"State.from_bytes: data is a {kind}; give what to_bytes() made") from None
        created = ffi.new("bempd_state **")
        call("bempd_state_from_bytes", size, buffer, created)
        return cls(created[0])

    def write(self, path: Union[str, "os.PathLike[str]"]) -> None:
        """Write it to a file, which is there as a whole or not at all; a state before it stays until then."""
        call("bempd_state_write", self.pointer, file_name("State.write: path", path))

    @classmethod
    def read(cls, path: Union[str, "os.PathLike[str]"]) -> State:
        """The state that write() wrote."""
        created = ffi.new("bempd_state **")
        call("bempd_state_read", file_name("State.read: path", path), created)
        return cls(created[0])

    def __reduce__(self) -> tuple[Any, tuple[bytes]]:
        return (State.from_bytes, (self.to_bytes(),))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, State) and self.to_bytes() == other.to_bytes()

    def __hash__(self) -> int:
        return hash(self.to_bytes())
