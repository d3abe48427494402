"""Options by name, as a mapping."""

from __future__ import annotations

import dataclasses
from typing import Any, Callable, Iterator, MutableMapping, Union

from . import _arguments as arguments
from ._handle import Handle
from ._library import call, ffi, lib, new_struct, string
from ._words import in_python
from .errors import ArgumentError, UnknownOptionError

OptionValue = Union[int, float, str]


@dataclasses.dataclass(frozen=True)
class OptionInfo:
    """Description of one option."""

    name: str
    summary: str
    unit: str
    default: OptionValue
    choices: tuple[str, ...]  #: legal words, empty for a number and for any text
    whole_number: bool  #: whether only whole numbers are legal
    minimum: float  #: smallest legal number; 0 for a word
    maximum: float  #: largest legal number; 0 for a word


def describe_options() -> dict[str, OptionInfo]:
    """All options with their defaults and ranges.

    >>> import bempd
    >>> bempd.describe_options()["stepping.separation_share"].default
    0.02
    """
    count = ffi.new("int64_t *")
    call("bempd_option_count", count)
    return {info.name: info for info in map(_describe, range(count[0]))}


def _describe(index: int) -> OptionInfo:
    info = new_struct("bempd_option_info", "bempd_option_info_init")
    call("bempd_option_describe", index, info)
    default: OptionValue = info.default_value
    if info.kind == lib.BEMPD_OPTION_TEXT:
        default = string(info.default_text)
    elif info.whole_number:
        default = int(info.default_value)
    words = string(info.choices)
    return OptionInfo(string(info.name), in_python(string(info.summary)), string(info.unit), default,
                      tuple(words.split(" | ")) if words else (), bool(info.whole_number), info.minimum, info.maximum)


class Options(MutableMapping[str, OptionValue]):
    """The options of a model: read and set by name; `del` brings back the default.

    >>> import bempd
    >>> model = bempd.Model()
    >>> model.options["crack.tie_share"] = 0.01
    >>> model.options["scheme"]
    'symmetric'
    >>> model.options["tie_share"] = 0  # doctest: +ELLIPSIS
    Traceback (most recent call last):
    bempd.errors.UnknownOptionError: options: there is no option 'tie_share'; near names are ...
    """

    def __init__(self, handle: Callable[[], Handle]) -> None:
        self._handle = handle
        self._known = describe_options()

    def describe(self, name: str) -> OptionInfo:
        """Default, range, unit and meaning of an option."""
        if name not in self._known:
            self[name]  # raises with the near names
        return self._known[name]

    def __getitem__(self, name: str) -> OptionValue:
        key = arguments.text("option name", name)
        info = self._known.get(name)
        if info is not None and isinstance(info.default, str):
            return self._text(key)
        value = ffi.new("double *")
        self._call("bempd_get_option", name, key, value)
        return int(value[0]) if info is not None and info.whole_number else float(value[0])

    def __setitem__(self, name: str, value: OptionValue) -> None:
        key = arguments.text("option name", name)
        if isinstance(value, str):
            self._call("bempd_set_option_text", name, key, arguments.text(f"option {name}", value))
        else:
            self._call("bempd_set_option", name, key, arguments.real(f"option {name}", value))

    def __delitem__(self, name: str) -> None:
        self[name] = self.describe(name).default

    def __iter__(self) -> Iterator[str]:
        return iter(self._known)

    def __len__(self) -> int:
        return len(self._known)

    def __contains__(self, name: Any) -> bool:
        return name in self._known

    def __repr__(self) -> str:
        return f"Options({dict(self)!r})"

    def _text(self, key: bytes) -> str:
        needed = ffi.new("int64_t *")
        self._handle().call("bempd_get_option_text", key, ffi.NULL, 0, needed)
        buffer = ffi.new("char[]", needed[0])
        self._handle().call("bempd_get_option_text", key, buffer, needed[0], ffi.NULL)
        return string(buffer)

    def _call(self, function: str, name: str, *values: Any) -> None:
        try:
            self._handle().call(function, *values)
        except ArgumentError as problem:
            if name in self._known:
                raise
            raise UnknownOptionError(*problem.args) from None
