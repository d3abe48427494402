"""One large body on several processes: MUMPS factorizes it over MPI (the library libbempd_mpi, and mpi4py).

    from mpi4py import MPI
    import bempd.mpi

    if MPI.COMM_WORLD.rank == 0:
        model = ...
        with bempd.mpi.attached(model, MPI.COMM_WORLD):
            model.run_to_separation()
    else:
        bempd.mpi.serve(MPI.COMM_WORLD)

Rank 0 has the model; the other ranks hold shares of its factor and work when rank 0 needs them.
"""

from __future__ import annotations

import contextlib
import os
import pathlib
import sys
from typing import TYPE_CHECKING, Any, Iterator

import cffi

from ._library import ffi, library_path, lib, string
from ._words import in_python
from .errors import error_of

if TYPE_CHECKING:
    from .model import Model

SONAME = "libbempd_mpi.0.dylib" if sys.platform == "darwin" else "libbempd_mpi.so.0"

_ffi: Any = cffi.FFI()
_ffi.include(ffi)
_ffi.cdef("""
bempd_status bempd_mpi_attach_handle(bempd_model *model, int32_t comm);
bempd_status bempd_mpi_serve_handle(int32_t comm);
bempd_status bempd_mpi_detach(bempd_model *model);
const char *bempd_mpi_last_error(void);
const char *bempd_mpi_build_info(void);
""")


def _candidates() -> Iterator[str]:
    if "BEMPD_MPI_LIBRARY" in os.environ:
        yield os.environ["BEMPD_MPI_LIBRARY"]
        return
    beside = pathlib.Path(library_path).parent
    for file in (beside / SONAME, beside.parent / "mpi" / SONAME):  # installed; in a build tree
        if file.is_file():
            yield str(file)
    yield SONAME


def _open() -> Any:
    import mpi4py.MPI  # first, because it opens MPI for others to see  # noqa: F401

    problems = []
    for file in _candidates():
        try:
            return _ffi.dlopen(file, _ffi.RTLD_NOW | _ffi.RTLD_LOCAL | _ffi.RTLD_NODELETE)
        except OSError as problem:
            problems.append(f"  {problem}")
    raise ImportError("the library libbempd_mpi was not found; install the package libbempd-mpi0, or build it with "
                      "-D BEMPD_MPI=ON and set BEMPD_MPI_LIBRARY to its file. Looked at:\n" + "\n".join(problems))


_lib = _open()


def _invoke(name: str, *arguments: Any) -> int:
    return int(getattr(_lib, name)(*arguments))


def _check(status: int, model: Any = None) -> None:
    if status != lib.BEMPD_OK:
        raise error_of(string(lib.bempd_status_name(status)), in_python(string(_lib.bempd_mpi_last_error())))


def attach(model: Model, comm: Any) -> None:
    """Let MUMPS factorize the whole body of a model on all ranks of a communicator of mpi4py: on rank 0, before the first
    step or result, while the other ranks serve(). If it fails, they return as well."""
    model._open().call("bempd_mpi_attach_handle", comm.py2f(), invoke=_invoke, check=_check)


def detach(model: Model) -> None:
    """Take MUMPS away from a model, on rank 0; the other ranks return from serve(). The model can go on by itself."""
    model._open().call("bempd_mpi_detach", changes=True, invoke=_invoke, check=_check)


@contextlib.contextmanager
def attached(model: Model, comm: Any) -> Iterator[Model]:
    """attach() for the length of a `with` block."""
    attach(model, comm)
    try:
        yield model
    finally:
        if not model.closed:  # close() has detached it
            detach(model)


def serve(comm: Any) -> None:
    """Work for rank 0, on all other ranks, until it detaches or closes its model."""
    _check(_invoke("bempd_mpi_serve_handle", comm.py2f()))


def build_info() -> str:
    """Version and licence of the MUMPS in use."""
    return string(_lib.bempd_mpi_build_info())
