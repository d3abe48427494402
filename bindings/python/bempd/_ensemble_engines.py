"""Where the cases of an ensemble run: all engines are executors of concurrent.futures."""

from __future__ import annotations

import collections
import concurrent.futures
import contextlib
import importlib
import multiprocessing
import os
import pickle
from concurrent.futures import Executor, Future
from typing import Any, Callable, Iterator, Optional, Sequence, Tuple

from ._ensemble_worker import ENVIRONMENT, Plain, probe, run_case, start_worker
from .errors import ArgumentError, Error

Outcome = Tuple[int, "dict[str, Plain]"]  # number of a case and what it gave
ENDED = "WorkerEnded: the process that ran this case has ended: it was killed, had too little memory, or crashed"
UNGUARDED = ('ensemble: worker processes do not start. They import the script that calls ensemble(): put the call under '
             '`if __name__ == "__main__":`, and the function outside, at the top level of the script or of a module')


class Engine:
    """An executor, and the number of cases that it is given ahead."""

    restarts = False  # whether it goes on after one of its processes has ended
    own_processes = True

    def __init__(self, executor: Executor, window: int) -> None:
        self.executor, self.window = executor, max(1, window)

    def submit(self, function: Callable[..., Any], case: Any) -> "Future[dict[str, Plain]]":
        return self.executor.submit(run_case, function, case, self.own_processes)

    def restart(self) -> None:
        """A new executor in place of one that is broken."""

    def close(self, interrupted: bool) -> None:
        """Nothing runs on afterwards."""
        self.executor.shutdown(wait=not interrupted, cancel_futures=True)


class Processes(Engine):
    """A pool of processes on this machine. They start afresh, as a copy of a process with threads may hang."""

    restarts = True

    def __init__(self, workers: Optional[int], function: Callable[..., Any]) -> None:
        picklable(function)
        self._workers = workers or cores()
        super().__init__(self._pool(), 2 * self._workers)
        try:
            with environment():
                self.executor.submit(probe, function).result()
        except concurrent.futures.BrokenExecutor:
            raise ArgumentError(UNGUARDED) from None

    def _pool(self) -> Executor:
        return concurrent.futures.ProcessPoolExecutor(self._workers, multiprocessing.get_context("spawn"), start_worker)

    def submit(self, function: Callable[..., Any], case: Any) -> "Future[dict[str, Plain]]":
        with environment():  # processes start at the first of these
            return super().submit(function, case)

    def restart(self) -> None:
        self.executor.shutdown(wait=True, cancel_futures=True)
        self.executor = self._pool()

    def close(self, interrupted: bool) -> None:
        if interrupted:
            for process in list((getattr(self.executor, "_processes", None) or {}).values()):
                process.terminate()
        super().close(interrupted)


class Here(Executor):
    """Runs a case when it is submitted, in this process: for debuggers and for one case."""

    def submit(self, function: Callable[..., Any], /, *given: Any, **named: Any) -> "Future[Any]":
        done: "Future[Any]" = Future()
        done.set_result(function(*given, **named))
        return done


class Serial(Engine):
    own_processes = False

    def __init__(self) -> None:
        super().__init__(Here(), 1)


class Given(Engine):
    """An executor that the caller made and closes."""

    own_processes = False

    def __init__(self, executor: Executor, workers: Optional[int]) -> None:
        super().__init__(executor, 2 * (workers or 512))

    def close(self, interrupted: bool) -> None:
        pass


class Ranks(Engine):
    """Processes of MPI: rank 0 hands out cases, the others run them."""

    def __init__(self, function: Callable[..., Any]) -> None:
        picklable(function)
        futures = module("mpi4py.futures", "mpi4py", "python3-mpi4py")
        size = importlib.import_module("mpi4py.MPI").COMM_WORLD.Get_size()
        core = getattr(futures, "_lib", None) or getattr(futures, "_core", None)
        if size < 2 or getattr(core, "SharedPool", True) is None:
            raise ArgumentError("ensemble: executor is 'mpi' and there are no ranks that wait for cases; start the script by "
                                "mpirun -np 4 python3 -m mpi4py.futures SCRIPT, with one rank more than cases at a time")
        super().__init__(futures.MPIPoolExecutor(), 2 * (size - 1))


class Dask(Engine):
    """Workers of Dask: of a cluster of this machine's processes, or of a client that is connected to another."""

    def __init__(self, where: Any, workers: Optional[int]) -> None:
        distributed = module("distributed", "distributed", "python3-distributed")
        self._opened: list[Any] = []
        if where == "dask":
            with environment():
                cluster = distributed.LocalCluster(n_workers=workers or cores(), threads_per_worker=1, processes=True,
                                                   dashboard_address=None, host="127.0.0.1", silence_logs=40)
            self._opened = [distributed.Client(cluster), cluster]
        elif isinstance(where, str):
            self._opened = [distributed.Client(where)]
        client = self._opened[0] if self._opened else where
        # Equal arguments are computed once by a pure function; what an ensemble runs may read a file, or the time.
        super().__init__(client.get_executor(pure=False), 2 * max(1, sum(client.nthreads().values())))

    def close(self, interrupted: bool) -> None:
        self.executor.shutdown(wait=not interrupted)
        for one in self._opened:
            one.close()


def engine_for(executor: Any, workers: Optional[int], function: Callable[..., Any]) -> Engine:
    """The engine for a word, a Dask address or client, or any executor of concurrent.futures."""
    if isinstance(executor, Executor):
        return Given(executor, workers)
    if executor == "processes":
        return Processes(workers, function)
    if executor == "serial":
        return Serial()
    if executor == "mpi":
        return Ranks(function)
    if executor == "dask" or hasattr(executor, "get_executor") or (isinstance(executor, str) and "://" in executor):
        return Dask(executor, workers)
    raise ArgumentError(f"ensemble: executor is {executor!r}; give 'processes', 'serial', 'mpi', 'dask', the address of a Dask "
                        "scheduler such as 'tcp://host:8786', a Dask client, or an executor of concurrent.futures")


def outcomes(engine: Engine, function: Callable[..., Any], cases: Sequence[Tuple[int, Any]]) -> Iterator[Outcome]:
    """What the cases give, in the order in which they end."""
    waiting = collections.deque(cases)
    running: "dict[Future[dict[str, Plain]], Tuple[int, Any]]" = {}
    suspects: list[Tuple[int, Any]] = []
    while waiting or running:
        while waiting and len(running) < engine.window and not suspects:
            try:
                running[engine.submit(function, waiting[0][1])] = waiting[0]
            except concurrent.futures.BrokenExecutor:
                suspects.append(waiting[0])
            waiting.popleft()
        done, _ = concurrent.futures.wait(running, return_when=concurrent.futures.FIRST_COMPLETED)
        for future in done:
            number, case = running.pop(future)
            try:
                yield number, outcome_of(future)
            except concurrent.futures.BrokenExecutor:
                suspects.append((number, case))
        if suspects and not running:
            yield from alone(engine, function, suspects)
            suspects = []


def alone(engine: Engine, function: Callable[..., Any], suspects: Sequence[Tuple[int, Any]]) -> Iterator[Outcome]:
    """Cases that ran when a process ended, one after the other: the one that ends its process again has the error."""
    if not engine.restarts:
        raise Error("ensemble: the executor is broken, as one of its workers has ended; results so far are kept in the file, "
                    "and the same call goes on from there")
    engine.restart()
    for number, case in suspects:
        try:
            yield number, outcome_of(engine.submit(function, case))
        except concurrent.futures.BrokenExecutor:
            yield number, {"error": ENDED, "seconds": None}
            engine.restart()


def outcome_of(future: "Future[dict[str, Plain]]") -> dict[str, Plain]:
    """The result, or the error of an engine, such as that of Dask for a worker that was lost several times."""
    try:
        return future.result()
    except concurrent.futures.BrokenExecutor:
        raise
    except (Exception, concurrent.futures.CancelledError) as error:
        return {"error": f"{type(error).__name__}: {error}".strip(), "seconds": None}


def picklable(function: Callable[..., Any]) -> None:
    """Refuse a function that other processes cannot import."""
    try:
        pickle.dumps(function)
    except Exception as problem:
        raise ArgumentError(f"ensemble: the function cannot be sent to other processes ({problem}); define it at the top level of "
                            "a script or a module, or take executor='serial'") from None


def module(name: str, package: str, debian: str) -> Any:
    """A module that an engine needs, or an error with its packages."""
    try:
        return importlib.import_module(name)
    except ImportError as problem:
        raise ArgumentError(f"ensemble: this executor needs the module {package} ({problem}); install Debian's package {debian}, or "
                            f"pip install {package}, or take executor='processes'") from None


def cores() -> int:
    """Cores that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


@contextlib.contextmanager
def environment() -> Iterator[None]:
    """Processes that start here have one BLAS thread, which is read when their BLAS is loaded."""
    before = {name: os.environ.get(name) for name in ENVIRONMENT}
    os.environ.update(ENVIRONMENT)
    try:
        yield
    finally:
        for name, value in before.items():
            if value is None:
                os.environ.pop(name, None)
            else:
                os.environ[name] = value
