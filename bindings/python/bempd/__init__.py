"""Cracks in two-dimensional elastic bodies: boundary elements coupled with bond-based peridynamics.

Any consistent set of units; comments show SI. Build a Model, step, ask:

>>> import bempd
>>> model = bempd.Model()
>>> acrylic = model.add_material(young_modulus=3e9, poisson_ratio=1 / 3, thickness=0.005, fracture_energy=300)
>>> strip = model.add_bem_region(acrylic, bempd.rectangle(0, 0, 0.06, 0.02), element_length=0.005)
>>> left = model.fix_edge(strip, 4)
>>> right = model.prescribe_edge(strip, 2, "x", 1e-6)
>>> report = model.step(10)
>>> print(f"{model.reaction(right)[0]:.0f} N")
50 N
"""

from . import outline, specimens
from ._ensemble import Ensemble, ensemble, read_ensemble
from ._library import build_info, library_path, version
from ._random import random_cracks, random_field, weibull_field
from ._results import read_history
from ._scene import rectangle
from ._bar import ProgressBar, progress_bar
from .convergence import Convergence, ConvergenceTable, converge
from .errors import (
    ArgumentError,
    CancelledError,
    ConvergenceError,
    Error,
    FileError,
    InternalError,
    OrderError,
    OutOfMemoryError,
    UnknownOptionError,
    UnsolvableError,
    Warning,
)
from .fatigue import FatigueLife, FatigueStop
from .model import Model
from .options import OptionInfo, Options, describe_options
from .reports import (
    BodyPlan,
    Bonds,
    BondState,
    CrackExtension,
    CrackOpening,
    CrackTip,
    EdgeNodes,
    EdgePlaces,
    EdgeReaction,
    ErrorSource,
    Errors,
    Explanation,
    Growth,
    LoadRule,
    NextEvent,
    Part,
    PartKind,
    PartReason,
    PathVertex,
    Piece,
    PointErrors,
    PointValues,
    RunErrors,
    Singularity,
    SingularityKind,
    Statistics,
    StepReport,
    StopReason,
    SupportHistory,
    TipEnd,
    TipMethod,
    TipRecord,
    TipState,
)
from .state import State
from .tables import Rows, Table, table

__version__ = version()

__all__ = [
    "ArgumentError", "BodyPlan", "BondState", "Bonds", "CancelledError", "Convergence", "ConvergenceError", "ConvergenceTable", "CrackExtension", "CrackOpening",
    "CrackTip", "EdgeNodes", "EdgePlaces", "EdgeReaction", "Ensemble", "Error", "ErrorSource", "Errors", "Explanation", "FatigueLife", "FatigueStop", "FileError", "Growth", "InternalError", "LoadRule", "Model", "NextEvent", "OptionInfo", "Options", "OrderError",
    "OutOfMemoryError", "Part", "PartKind", "PartReason", "PathVertex", "Piece", "PointErrors", "PointValues", "ProgressBar", "Rows", "RunErrors", "Singularity", "SingularityKind", "State", "Statistics",
    "StepReport", "StopReason", "SupportHistory", "Table", "TipEnd", "TipMethod", "TipRecord", "TipState", "UnknownOptionError", "UnsolvableError",
    "build_info", "converge", "describe_options", "ensemble", "library_path", "outline", "progress_bar", "random_cracks", "random_field", "read_ensemble", "read_history", "rectangle", "specimens", "table", "version", "weibull_field",
]
