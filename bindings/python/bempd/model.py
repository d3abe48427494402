"""A scene and its state."""

from __future__ import annotations

import contextlib
import logging
import os
from types import TracebackType
from typing import Any, Iterator, Mapping, NoReturn, Optional, Type, Union

import numpy as np
import numpy.typing as npt

from . import _arguments as arguments
from ._arguments import real_array
from ._edges import Edges
from ._ensemble_worker import model_options
from ._fatigue import Fatigue
from ._handle import Handle
from ._load_cases import LoadCases
from ._help import complete
from ._library import check, ffi, invoke, lib, new_struct
from ._results import Results
from ._names import Quantity, Until
from ._scene import Scene
from ._sketch import Sketch
from .callbacks import (Log, PhaseProgress, Progress, callable_or_none, log_callback, phase_callback,
                        progress_callback)
from .errors import ArgumentError
from .options import Options, OptionValue
from .reports import StepReport, step_report
from .state import State

UNTIL = {"values": lib.BEMPD_UNTIL_VALUES, "event": lib.BEMPD_UNTIL_EVENT, "separated": lib.BEMPD_UNTIL_SEPARATED}


class Model(Scene, Edges, Results, Fatigue, LoadCases):
    """Cracks in a two-dimensional elastic body: build it, step, ask, close.

    One thread at a time, except request_cancel(); other threads run on while the library works. Used in a `with`
    statement it is closed at the end; otherwise when nothing refers to it any more.

    >>> import bempd
    >>> with bempd.Model(options={"stepping.control": "path"}) as model:
    ...     glass = model.add_material(young_modulus=3e9, poisson_ratio=1 / 3, fracture_energy=300)
    ...     plate = model.add_pd_region(glass, bempd.rectangle(0, 0, 0.02, 0.02), spacing=0.001)
    ...     crack = model.add_crack([(0.0095, 0), (0.0095, 0.0055)])
    ...     bottom = model.fix_edge(plate, 4)
    ...     pulled = model.prescribe_edge(plate, 2, "x", 1e-6)
    ...     report = model.run_to_separation(1e4)
    >>> report.stop_reason
    <StopReason.SEPARATED: 3>
    """

    def __init__(self, *, options: Optional[Mapping[str, OptionValue]] = None, progress: Optional[Progress] = None,
                 log: Optional[Log] = "warnings") -> None:
        self._handle: Optional[Handle] = Handle()
        self._sketch = Sketch()
        self._fields = {}
        self._fields_generation = 0
        self._progress: Optional[Progress] = None
        self._phase_progress: Optional[PhaseProgress] = None
        self._log: Optional[Log] = None
        self.progress = progress
        self.phase_progress = None
        self.log = log
        self.options.update(model_options.get())
        self.options.update(options or {})

    def __repr__(self) -> str:
        if self.closed:
            return "<bempd.Model: closed>"
        broken = self.statistics().broken_bonds
        bonds = f", {broken} bonds broken" if broken else ""
        return f"<bempd.Model: {self._sketch.words()}; load factor {self.load_factor:.6g}{bonds}>"

    def _repr_html_(self) -> str:
        """The scene as it was described, for notebooks; nothing is prepared for it."""
        return self._sketch.page(repr(self))

    def __reduce_ex__(self, protocol: object) -> NoReturn:
        raise TypeError("a bempd.Model cannot be pickled or copied: it is the library's memory; pickle what save() makes, a "
                        "bempd.State, build the model again where it is needed and restore() the state")

    def close(self) -> None:
        """Give the model back; asking for anything afterwards is an OrderError. Arrays of view_field() stay good."""
        self._handle = None
        self._fields.clear()

    @property
    def closed(self) -> bool:
        """Whether close() was called."""
        return self._handle is None

    def __enter__(self) -> Model:
        return self

    def __exit__(self, kind: Optional[Type[BaseException]], error: Optional[BaseException],
                 traceback: Optional[TracebackType]) -> None:
        self.close()

    @property
    def options(self) -> Options:
        """Options by name: `model.options["threads"] = 2`; describe() tells what they mean."""
        return Options(self._open)

    @property
    def progress(self) -> Optional[Progress]:
        """Function called as f(load_factor, events, broken_bonds) after every event, or None.

        An exception cancels the step, which returns to its start, and is raised again. KeyboardInterrupt (Ctrl-C), with a
        function or without, ends the step and is raised with its events kept; a long event at hand is given up; a second
        Ctrl-C in the same call ends the process (where somebody types at the interpreter it cancels the call), and one before the
        first event cancels. If the function has methods start(load_factor, goal) and finish(), they are called around every run,
        and a method phase() as `phase_progress`; progress_bar() makes such a one.
        """
        return self._progress

    @progress.setter
    def progress(self, function: Optional[Progress]) -> None:
        handle = self._open()
        callback = progress_callback(handle.interrupts, callable_or_none("progress", function))
        handle.call("bempd_set_progress", callback, ffi.NULL)
        handle.progress, self._progress = callback, function
        handle.interrupts.follower = getattr(function, "phase", None)

    @property
    def phase_progress(self) -> Optional[PhaseProgress]:
        """Function called as f(phase, share, seconds, expected) inside long parts of calls, ten times a second at most,
        or None: what is done, the share of it, the seconds so far and those expected in all. An exception cancels the
        call and is raised again.
        """
        return self._phase_progress

    @phase_progress.setter
    def phase_progress(self, function: Optional[PhaseProgress]) -> None:
        handle = self._open()
        callback = phase_callback(handle.interrupts, callable_or_none("phase_progress", function))
        handle.call("bempd_set_phase_progress", callback, ffi.NULL)
        handle.phases, self._phase_progress = callback, function

    @property
    def log(self) -> Optional[Log]:
        """Where the library's log goes; `model.log = ...` and Model(log=...) choose it.

        "warnings", the default: warnings become Python's, of the class bempd.Warning; the rest is dropped. A
        logging.Logger, or a function called as f(level, message), receives all of it: level 1 warning, 2 information, 3
        detail. None: nothing is told.

        >>> import bempd
        >>> messages = []
        >>> model = bempd.Model(log=lambda level, message: messages.append(message))
        >>> glass = model.add_material(young_modulus=3e9, poisson_ratio=1 / 3)
        >>> plate = model.add_bem_region(glass, bempd.rectangle(0, 0, 2, 1), element_length=0.25)
        >>> held = model.fix_edge(plate, 4)
        >>> model.prepare()
        >>> messages[0].split(":")[0]
        'prepared'
        """
        return self._log

    @log.setter
    def log(self, log: Optional[Log]) -> None:
        handle = self._open()
        callback = ffi.NULL
        if log is not None:
            if isinstance(log, str) and log != "warnings":
                raise ArgumentError(f"log is {log!r}; give \"warnings\", a logging.Logger, a function of level and message, or None")
            if not isinstance(log, (logging.Logger, str)):
                callable_or_none("log", log)
            callback = log_callback(handle.raised, handle.pointer, log)
        self._set_log(callback)
        handle.log, self._log = callback, log

    def request_cancel(self) -> None:
        """Ask the step that runs in another thread to stop: it returns to its start and raises CancelledError."""
        check(invoke("bempd_request_cancel", self._open().pointer))

    def request_stop(self) -> None:
        """Ask the step that runs in another thread, or calls back, to end with the events that it has done: its report has
        StopReason.REQUESTED, and what it has done is kept."""
        check(invoke("bempd_request_stop", self._open().pointer))

    def prepare(self) -> None:
        """Check the scene and build its operators; nothing can be added afterwards. The first step does it if you do
        not."""
        with self._followed(None):
            self._open().call("bempd_prepare")

    def step(self, load_factor: float) -> StepReport:
        """Move the load factor, breaking what reaches its critical load on the way."""
        return self._run("bempd_step", load_factor, goal=load_factor)

    def step_to_next_event(self, load_factor_limit: float) -> StepReport:
        """Go to the next event, one batch of bonds, and perform it; no further than the limit."""
        return self._run("bempd_step_to_next_event", load_factor_limit)

    def run_to_separation(self, load_factor_limit: float) -> StepReport:
        """Go on until the body is separated, no bond can break any more, or the limit is reached."""
        return self._run("bempd_run_to_separation", load_factor_limit)

    def step_to_values(self, load_factor: float, *, until: Until = "values") -> StepReport:
        """Go from the values with which the last step ended to those that loads and supports have now, on a straight
        line, while the load factor goes to the one given: the time of a host, say.

        `until` is "values" (whatever breaks on the way), "event" (one event) or "separated". A step that ended on the way
        is gone on with by the same call.

        >>> import bempd
        >>> model = bempd.Model()
        >>> glass = model.add_material(young_modulus=3e9, poisson_ratio=1 / 3)
        >>> plate = model.add_bem_region(glass, bempd.rectangle(0, 0, 2, 1), element_length=0.25)
        >>> support = model.fix_edge(plate, 4)
        >>> load = model.add_traction(plate, 2, "x", constant=0)
        >>> for time in (0.5, 1.0):
        ...     model.set_load_values(load, constant=3e6 * time)
        ...     report = model.step_to_values(time)
        >>> round(model.reaction(support)[0])
        -3000000
        """
        goal = arguments.choice("step_to_values: until", until, UNTIL)
        return self._run("bempd_step_to_values", load_factor, goal, goal=load_factor if until == "values" else None)

    def run_program(self, times: npt.ArrayLike, factors: Optional[npt.ArrayLike] = None, *,
                    supports: Optional[Mapping[int, npt.ArrayLike]] = None,
                    loads: Optional[Mapping[int, npt.ArrayLike]] = None, until: Until = "values") -> StepReport:
        """Go through a table of factors by time: loads that rise, rest, turn round, change their sign or go in cycles.

        Either `factors` are those of all supports and loads, or `supports` and `loads` give some of them factors of their
        own, by id; what has none then takes the time as its factor. The value at a time is the constant part and the factor
        times the proportional one, straight between times. While it runs the load factor is the time.

        >>> import bempd
        >>> model = bempd.Model()
        >>> steel = model.add_material(young_modulus=2e11, poisson_ratio=1 / 3)
        >>> bar = model.add_bem_region(steel, bempd.rectangle(0, 0, 2, 1), element_length=0.25)
        >>> held = model.fix_edge(bar, 4)
        >>> pull = model.add_traction(bar, 2, "x", proportional=3e6)
        >>> report = model.run_program([1, 2, 3], [1, -1, 0])
        >>> bool(abs(report.work) < 1e-9 * max(model.history()["work"]))
        True
        """
        at = real_array("run_program: times", times)
        if at.ndim != 1:
            raise ArgumentError(f"run_program: times has the shape {at.shape}; give a row of numbers")
        given = [(kind, key, values) for kind, named in ((lib.BEMPD_COLUMN_SUPPORT, supports), (lib.BEMPD_COLUMN_LOAD, loads))
                 for key, values in (named or {}).items()]
        if (factors is None) == (not given):
            raise ArgumentError("run_program: give factors for all supports and loads, or supports and loads with factors of "
                                "their own")
        of_columns = [values for _, _, values in given] if factors is None else [factors]
        columns = [real_array("run_program: factors", values) for values in of_columns]
        for column in columns:
            if column.shape != at.shape:
                raise ArgumentError(f"run_program: factors have the shape {column.shape} and times {at.shape}; give a factor "
                                    "for each time")
        kinds = ffi.new("int32_t[]", [kind for kind, _, _ in given]) if given else ffi.NULL
        ids = ffi.new("int32_t[]", [arguments.whole("run_program: id", key) for _, key, _ in given]) if given else ffi.NULL
        table = np.ascontiguousarray(np.column_stack(columns) if at.size else np.empty((0, 1)))
        goal = arguments.choice("run_program: until", until, UNTIL)
        return self._run("bempd_run_program", at.size, arguments.doubles(at), len(given), kinds, ids,
                         arguments.doubles(table), goal, goal=float(at[-1]) if at.size and until == "values" else None)

    def save(self, *, values: bool = False) -> State:
        """The state of a prepared model, to come back to or to keep; with `values` it contains those of loads and
        supports, which restore() then brings back.

        >>> import bempd
        >>> model = bempd.Model()
        >>> glass = model.add_material(young_modulus=3e9, poisson_ratio=1 / 3)
        >>> plate = model.add_bem_region(glass, bempd.rectangle(0, 0, 2, 1), element_length=0.25)
        >>> support = model.fix_edge(plate, 4)
        >>> load = model.add_traction(plate, 2, "x", 3e6)
        >>> model.prepare()
        >>> start = model.save()
        >>> report = model.step(2)
        >>> model.restore(start)
        >>> model.load_factor
        0.0
        """
        saved = ffi.new("bempd_state **")
        if values:
            self._open().call("bempd_state_save_with", lib.BEMPD_STATE_BODY_AND_VALUES, saved)
        else:
            self._open().call("bempd_state_save", saved)
        return State(saved[0])

    def restore(self, state: State) -> None:
        """Come back to a saved state; loads and supports keep their present values unless it was saved with theirs."""
        if not isinstance(state, State):
            kind = type(state).__name__
            raise ArgumentError(f"restore: state is a {kind}; give what save() or State.from_bytes() made")
        self._open().call("bempd_state_restore", state.pointer, changes=True)

    def checkpoint(self, path: Union[str, "os.PathLike[str]"]) -> None:
        """Write the state with the values of loads and supports to a file, for resume(): whole or not at all.

        >>> import bempd, tempfile
        >>> model = bempd.Model()
        >>> glass = model.add_material(young_modulus=3e9, poisson_ratio=1 / 3)
        >>> plate = model.add_bem_region(glass, bempd.rectangle(0, 0, 2, 1), element_length=0.5)
        >>> support, load = model.fix_edge(plate, 4), model.add_traction(plate, 2, "x", 3e6)
        >>> report = model.step(2)
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     model.checkpoint(folder + "/plate.state")
        ...     report = model.step(5)
        ...     model.resume(folder + "/plate.state")
        >>> model.load_factor
        2.0
        """
        self.save(values=True).write(path)

    def resume(self, path: Union[str, "os.PathLike[str]"]) -> None:
        """Go on from what checkpoint() wrote, in a model that was built in the same way; functions that gave values are
        not in the file, and act as they do here."""
        self.restore(State.read(path))

    def plot(self, quantity: Quantity = "damage", **options: Any) -> Any:
        """Draw the body with matplotlib; see bempd.plot.draw() for quantities and options. Returns the axes."""
        from . import plot

        return plot.draw(self, quantity, **options)

    def _run(self, name: str, *given: Any, goal: Optional[float] = None) -> StepReport:
        report = new_struct("bempd_step_report", "bempd_step_report_init")
        with self._followed(goal):
            self._open().call(name, *given, report, changes=True)
        return step_report(report)

    @contextlib.contextmanager
    def _followed(self, goal: Optional[float]) -> Iterator[None]:
        """Tells a progress function that wants to know it where a run begins and ends."""
        start, finish = (getattr(self._progress, part, None) for part in ("start", "finish"))
        if start is not None:
            start(self.load_factor, goal)
        try:
            yield
        finally:
            if finish is not None:
                finish()

    def _set_log(self, callback: Any) -> None:
        self._open().call("bempd_set_log", callback, ffi.NULL)


complete(Model)
complete(State)
