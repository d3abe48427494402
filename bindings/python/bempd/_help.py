"""Units, shapes and errors for help(): what the library's manual says of the function behind each method."""

from __future__ import annotations

import inspect
from typing import Any

from ._cdef import DOCS
from ._words import NAMES, in_python, name_of

RAISES = "Raises a bempd.Error whose text says what came and what is needed; the model is then as it was before."


def function_behind(owner: str, method: str) -> str:
    """The C function that a method stands for; empty if there is none."""
    if owner == "Model" and f"bempd_{method}" in DOCS and f"bempd_{method}" not in NAMES:
        return f"bempd_{method}"
    behind = [name for name in DOCS if name_of(name) == f"{owner}.{method}" and not name.endswith(("_init", "_count"))]
    return max(behind, key=lambda name: len(DOCS[name])) if behind else ""


def complete(kind: type) -> None:
    """Add to the documentation of public methods and properties."""
    for name, member in inspect.getmembers(kind):
        function = "" if name.startswith("_") else function_behind(kind.__name__, name)
        target: Any = member.fget if isinstance(member, property) else member
        if not function or not (inspect.isfunction(target) or isinstance(member, property)):
            continue
        manual = "\n".join("    " + line if line else "" for line in in_python(DOCS[function]).split("\n"))
        text = f"{inspect.cleandoc(target.__doc__ or '')}\n\nThe manual of {function}(), arguments named as in C:\n\n{manual}\n\n{RAISES}"
        if not isinstance(member, property):
            target.__doc__ = text
