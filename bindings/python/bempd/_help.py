"""Units, shapes and errors for help(): what the library's manual says of the function behind each method, in Python's words."""

from __future__ import annotations

import inspect
import re
import textwrap
from typing import Any

from ._cdef import DOCS
from ._words import NAMES, in_python, name_of

RAISES = "Raises a bempd.Error whose text says what came and what is needed; the model is then as it was before."

#: Methods whose names would lead to another function, or to a struct.
BEHIND = {"history": "bempd_get_history_entry", "statistics": "bempd_get_statistics", "piece": "bempd_get_piece"}
#: Parameters here that are called otherwise, or are two numbers, in C.
IN_C = {"point": "x", "centre": "x", "about": "x", "axis": "x", "part": "from", "name": "field", "until": "until",
        "function": "function", "support": "support", "times": "times"}
TEXT_OF = {"point": "(x, y) of the place [m]", "centre": "(x, y) of the centre [m]", "about": "(x, y) of the place [m]",
           "axis": "(x, y) of the place about which the region turns [m]", "part": "start and end as fractions of the edge [-]",
           "name": "name of a field", "edge": "number of an edge, or its name", "bulges": "one number for each edge, 0 for straight ones",
           "function": "called as f(x, y)", "rising": "whether the load factor rises"}
#: Methods whose own words say all: the manual's are of handles.
ALONE = {"close"}
#: What a sentence of the C manual says of pointers, counts and structs, and its Python form.
REPLACED = (
    (re.compile(r"; (?:may be )?NULL(?: when capacity is 0| if not wanted)?(?=[;.,\s)]|$)(?! for)"), ""),
    (re.compile(r"\bNULL for "), "None for "),
    (re.compile(r"\bNULL\b"), "None"),
    (re.compile(r"\bshape \[\w+\]\[(\d+)\]"), r"shape (n, \1)"),
    (re.compile(r"(?<=, )\[\w+\]\[(\d+)\]"), r"(n, \1)"),
    (re.compile(r"\bshape \[(\d+)\]"), r"shape (\1,)"),
    (re.compile(r"\bshape \[\w+\]"), "shape (n,)"),
    (re.compile(r" ?Fill it with [\w.]+(?:\(\))?\."), ""),
    (re.compile(r"; free it with [^.;]*"), ""),
    (re.compile(r"\bvertex_count\b"), "number of vertices"),
)


def function_behind(owner: str, method: str) -> str:
    """The C function that a method stands for; empty if there is none."""
    if owner == "Model" and method in BEHIND:
        return BEHIND[method]
    if owner == "Model" and f"bempd_{method}" in DOCS and f"bempd_{method}" not in NAMES:
        return f"bempd_{method}"
    behind = [name for name in DOCS if name_of(name) == f"{owner}.{method}" and not name.endswith(("_init", "_count"))]
    return max(behind, key=lambda name: len(DOCS[name])) if behind else ""


def complete(kind: type) -> None:
    """Add to the documentation of public methods and properties."""
    for name, member in inspect.getmembers(kind):
        function = "" if name.startswith("_") else function_behind(kind.__name__, name)
        target: Any = member.fget if isinstance(member, property) else member
        if not function or name in ALONE or not (inspect.isfunction(target) or isinstance(member, property)):
            continue
        if not isinstance(member, property):
            target.__doc__ = "\n\n".join([inspect.cleandoc(target.__doc__ or ""), *manual(target, DOCS[function]), RAISES])


def manual(method: Any, document: str) -> list[str]:
    """Paragraphs of the manual that tell a method's user something."""
    text, parameters = parsed(document)
    paragraphs = [pythonic(paragraph) for paragraph in text]
    if paragraphs and method.__doc__:
        # A short first sentence says what the method's own first sentence says.
        first, stop, rest = paragraphs[0].replace("\n", " ").partition(". ")
        short = len(first) < 100
        paragraphs[0] = (textwrap.fill(rest, 100) if stop else "") if short else paragraphs[0]
    signature = inspect.signature(method)
    given = []
    for name in signature.parameters:
        found = parameters.get(IN_C.get(name, name), ("", ""))
        words = TEXT_OF.get(name, pythonic(found[1]) if found[0].startswith("in") else "")
        if name != "self" and words:
            given.append((name, words))
    if given:
        width = max(len(name) for name, _ in given) + 2
        paragraphs.append("\n".join(["Arguments:", *(line for name, words in given for line in textwrap.wrap(
            words, 100, initial_indent="    " + name.ljust(width), subsequent_indent=" " * (4 + width)))]))
    result = returned(signature.return_annotation, parameters)
    return [*filter(None, paragraphs), *([result] if result else [])]


def parsed(document: str) -> tuple[list[str], dict[str, tuple[str, str]]]:
    """Paragraphs of a document, and (direction, words) of its parameters; what it returns has the name `return`."""
    text: list[str] = []
    parameters: dict[str, tuple[str, str]] = {}
    for paragraph in document.split("\n\n"):
        rows = re.split(r"\n(?! )", paragraph)
        if re.match(r"\w+ \[[a-z,]+\]: |return: |since: ", rows[0]):
            for row in rows:
                found = re.match(r"(\w+)(?: \[([a-z,]+)\])?: (.*)", " ".join(row.split()))
                if found:
                    parameters[found[1]] = (found[2] or "", found[3])
        else:
            text.append(paragraph)
    return text, parameters


def pythonic(sentence: str) -> str:
    """Words of the C manual as they are meant here."""
    sentence = in_python(sentence)
    for pattern, words in REPLACED:
        sentence = pattern.sub(words, sentence)
    return sentence.strip()


def returned(annotation: Any, parameters: dict[str, tuple[str, str]]) -> str:
    """What a method returns, with shapes and units."""
    kind = annotation if isinstance(annotation, str) else getattr(annotation, "__name__", "")
    outs = [pythonic(words) for direction, words in parameters.values() if direction == "out"]
    told = [f"{name}: {pythonic(words)}" for name, (direction, words) in parameters.items()
            if direction == "out" and "shape" in words and name != "buffer"]
    status = re.sub(r"^status(; )?", "", pythonic(parameters.get("return", ("", ""))[1]))
    lines = []
    if kind not in ("None", ""):
        lines.append(f"    {kind}" + (f": {outs[0]}" if len(outs) == 1 and not told else ""))
    if kind not in ("None", ""):
        lines += [line for words in told for line in textwrap.wrap(words, 100, initial_indent="    ", subsequent_indent="      ")]
    heads = ["Returns:", *lines] if lines else []
    return "\n".join(heads + ([("" if not heads else "\n") + status[0].upper() + status[1:] + "."] if status else []))
