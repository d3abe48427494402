"""Finds and opens the shared library; turns statuses into exceptions."""

from __future__ import annotations

import os
import pathlib
import re
import sys
from typing import Any, Iterator

import cffi

from ._cdef import CDEF
from ._words import in_python
from .errors import ArgumentError, error_of

# The binary interface that this package was written for; the library's file name carries it.
SONAME = "libbempd.0.dylib" if sys.platform == "darwin" else "libbempd.so.0"

ffi: Any = cffi.FFI()
ffi.cdef(CDEF)

KINDS = {"int32_t": "a whole number of at most 31 bits", "int64_t": "a whole number of at most 63 bits"}

# What each function calls its arguments, for messages.
ARGUMENT_NAMES: dict[str, list[str]] = {
    name: re.findall(r"(\w+)\s*(?:,|$)", arguments)
    for name, arguments in re.findall(r"\b(bempd_\w+)\(([^()]*)\);", CDEF)
}


def candidates() -> Iterator[tuple[str, str]]:
    """(why, file) of the places where the library may be, in the order in which they are tried."""
    package = pathlib.Path(__file__).resolve().parent
    yield "beside the module", str(package / SONAME)
    source_tree = package.parents[2]
    if (source_tree / "include" / "bempd.h").is_file():
        builds = source_tree.glob("build/*/src/capi/" + SONAME)
        for file in sorted(builds, key=lambda file: file.stat().st_mtime, reverse=True):
            yield "build tree", str(file)
    yield "system", SONAME


def opened(file: str, is_path: bool = True) -> Any:
    """The library in a file; ImportError says why it is none that fits this package."""
    if is_path and not os.path.isfile(file):
        raise ImportError("no such file")
    try:
        # Never unloaded: objects that are alive when the interpreter ends free themselves after modules are gone.
        library = ffi.dlopen(file, ffi.RTLD_NOW | ffi.RTLD_LOCAL | ffi.RTLD_NODELETE)
    except OSError as problem:
        raise ImportError(str(problem)) from None
    missing = [name for name in ARGUMENT_NAMES if not hasattr(library, name)]
    if missing:
        own = hasattr(library, "bempd_version_string")
        found = f"version {string(library.bempd_version_string())} of bempd" if own else "another library"
        raise ImportError(f"another version, it has no {missing[0]}: it is {found}")
    return library


def open_library() -> tuple[Any, str]:
    """The library and the file it came from; ImportError says where it was looked for.

    What BEMPD_LIBRARY names is taken or an error: never another one in its place."""
    wanted = os.environ.get("BEMPD_LIBRARY")
    if wanted:
        try:
            return opened(wanted), wanted
        except ImportError as problem:
            raise ImportError(
                f"the environment variable BEMPD_LIBRARY names {wanted}, which does not fit this package: {problem}. "
                f"Set it to the {SONAME} that was built with this package, or unset it, and the library is looked for "
                "beside the module, in the build tree and among the system's") from None
    looked: list[str] = []
    for why, file in candidates():
        try:
            return opened(file, is_path=why != "system"), file
        except ImportError as problem:
            looked.append(f"{file} ({why}): {problem}")
    raise ImportError(
        "the shared library of bempd was not found; build it and set BEMPD_LIBRARY to its file. Looked at:\n  "
        + "\n  ".join(looked)
    )


def string(pointer: Any) -> str:
    """A string that the library hands out."""
    return str(ffi.string(pointer).decode("utf-8", "replace"))


lib, library_path = open_library()


def invoke(name: str, *arguments: Any) -> int:
    """Call a function; arguments that do not convert are named in the error."""
    function = getattr(lib, name)
    try:
        return int(function(*arguments))
    except (TypeError, OverflowError) as problem:
        for wanted, argument_name, value in zip(ffi.typeof(function).args, ARGUMENT_NAMES[name], arguments):
            if wanted.kind == "primitive" and not _converts(wanted, value):
                kind = KINDS.get(wanted.cname, "a number")
                raise ArgumentError(in_python(f"{name}: {argument_name} is {value!r}; it must be {kind}")) from None
        raise ArgumentError(in_python(f"{name}: {problem}")) from None


def _converts(wanted: Any, value: Any) -> bool:
    if value is None:  # means no initial value in ffi.new()
        return False
    try:
        ffi.new(ffi.getctype(wanted, "*"), value)
    except (TypeError, OverflowError):
        return False
    return True


def check(status: int, model: Any = None) -> None:
    """Raise the exception that belongs to a status."""
    if status != lib.BEMPD_OK:
        sentence = string(lib.bempd_last_error(ffi.NULL if model is None else model))
        raise error_of(string(lib.bempd_status_name(status)), sentence)


def call(name: str, *arguments: Any) -> None:
    """Call a function that has no model."""
    check(invoke(name, *arguments))


def new_struct(name: str, initialize: str) -> Any:
    """A struct filled by its _init function."""
    struct = ffi.new(f"{name} *")
    call(initialize, struct, ffi.sizeof(name))
    return struct


def members(name: str) -> list[tuple[str, Any]]:
    """Names and types of the members of a struct that say something to a user."""
    return [(key, field.type) for key, field in ffi.typeof(name).fields if key not in ("struct_size", "reserved")]


def version() -> str:
    """Version of the library as "major.minor.patch"."""
    return string(lib.bempd_version_string())


def build_info() -> str:
    """One line on how the library was built."""
    return string(lib.bempd_build_info())
