"""Exceptions, one for each kind of failure; the message is the library's own sentence."""

from __future__ import annotations

from ._words import in_python


class Error(Exception):
    """Base of all errors of this package; `status` is the name of the library's status."""

    status = "BEMPD_ERROR_INTERNAL"

    def __str__(self) -> str:
        # KeyError, a base of one of the classes below, would show the sentence in quotes.
        return Exception.__str__(self)


class ArgumentError(Error, ValueError):
    """A value is wrong; correct it and call again."""

    status = "BEMPD_ERROR_ARGUMENT"


class UnknownOptionError(ArgumentError, KeyError):
    """There is no option of this name; the message lists the near ones."""


class OrderError(Error, RuntimeError):
    """Called too early or too late in the order of a run."""

    status = "BEMPD_ERROR_ORDER"


class UnsolvableError(Error, ArithmeticError):
    """The scene has no unique equilibrium: a mechanism, or a singular operator."""

    status = "BEMPD_ERROR_UNSOLVABLE"


class ConvergenceError(Error, ArithmeticError):
    """An iteration or the limit on events ended before the goal."""

    status = "BEMPD_ERROR_CONVERGENCE"


class CancelledError(Error, RuntimeError):
    """A callback or Model.request_cancel() asked to stop; the model is back at the start of the step."""

    status = "BEMPD_ERROR_CANCELLED"


class OutOfMemoryError(Error, MemoryError):
    """Not enough memory; use fewer elements or a coarser lattice."""

    status = "BEMPD_ERROR_MEMORY"


class FileError(Error, OSError):
    """A file could not be written."""

    status = "BEMPD_ERROR_IO"


class InternalError(Error, RuntimeError):
    """A defect of the library; please report it. The model can only be closed now."""


class Warning(UserWarning):  # its name is bempd.Warning, beside bempd.Error
    """What the library warns of: a result that may be less good than it looks, or a part that was held or dropped.

    Python's own `warnings` module decides what becomes of it: `warnings.simplefilter("ignore", bempd.Warning)` silences all
    models, "error" makes exceptions of warnings. `model.log` of one model takes its place: a logger, a function, or None.
    """


_BY_STATUS: dict[str, type[Error]] = {
    kind.status: kind
    for kind in (ArgumentError, OrderError, UnsolvableError, ConvergenceError, CancelledError, OutOfMemoryError,
                 FileError)
}


def error_of(status: str, sentence: str) -> Error:
    """The exception for the name of a status."""
    return _BY_STATUS.get(status, InternalError)(in_python(sentence) or status)
