"""The part of a Model that combines load cases."""

from __future__ import annotations

import dataclasses
from typing import Any, Mapping, Optional, Sequence

import numpy as np
import numpy.typing as npt

from . import _arguments as arguments
from ._handle import Handle
from ._library import ffi, new_struct
from .errors import ArgumentError
from .reports import CrackTip, PointValues, crack_tip
from .tables import Rows


class LoadCases:
    """Load cases: loads that act together, and the body under any combination of them."""

    _handle: Optional[Handle]

    def _open(self) -> Handle:
        raise NotImplementedError

    def add_load_case(self, loads: Sequence[int] = (), supports: Sequence[int] = ()) -> int:
        """Add a load case of loads and moved supports, with their values at the load factor 1; returns its id.

        >>> import bempd
        >>> model = bempd.Model()
        >>> steel = model.add_material(young_modulus=210e9, poisson_ratio=0.3)
        >>> plate = model.add_bem_region(steel, bempd.rectangle(-1, -1, 1, 1), element_length=0.5)
        >>> crack = model.add_crack([(-0.2, 0), (0.2, 0)])
        >>> held = model.fix_point((-1, -1)), model.fix_point((1, -1), "y")
        >>> up, down = model.add_traction(plate, 3, "y", 1e6), model.add_traction(plate, 1, "y", -1e6)
        >>> inside = model.add_crack_traction(crack, "pressure", 1e6)
        >>> pull, pressure = model.add_load_case([up, down]), model.add_load_case([inside])
        >>> one, other, both = (model.combine(factors).tips[0].stress_intensity_1
        ...                     for factors in ({pull: 1}, {pressure: 1}, {pull: 2, pressure: -0.5}))
        >>> abs(2 * one - 0.5 * other - both) < 1e-9 * both
        True
        """
        case = ffi.new("int32_t *")
        self._open().call("bempd_load_case_add", len(loads), ffi.new("int32_t[]", list(loads)), len(supports),
                          ffi.new("int32_t[]", list(supports)), case)
        return int(case[0])

    def combine(self, factors: Mapping[int, float]) -> Combination:
        """The body under a combination, each case times a factor; the run of the model stays where it is.

        Faces of cracks close and open as they must under it. Results add up where `pressed_faces` is 0.
        """
        count = ffi.new("int32_t *")
        self._open().call("bempd_load_case_count", count)
        row = np.zeros(count[0])
        for case, factor in factors.items():
            if not 1 <= case <= count[0]:
                raise ArgumentError(f"combine: load case {case} does not exist; there are {count[0]}, from 1 on")
            row[case - 1] = arguments.real("combine: factor", factor)
        number = ffi.new("int64_t *")
        self._open().call("bempd_load_case_tip_count", len(row), arguments.doubles(row), number)
        tips: Rows[CrackTip] = Rows()
        for index in range(number[0]):
            struct = new_struct("bempd_crack_tip", "bempd_crack_tip_init")
            self._open().call("bempd_load_case_tip", len(row), arguments.doubles(row), index, struct)
            tips.append(crack_tip(struct))
        self._open().call("bempd_load_case_pressed_faces", len(row), arguments.doubles(row), number)
        return Combination(tips, int(number[0]), row, self)


@dataclasses.dataclass(frozen=True)
class Combination:
    """Results of the body under a combination of load cases, with its cracks as they are when asked for."""

    tips: list[CrackTip]  #: critical_load_factor: by how much the whole combination may be multiplied
    pressed_faces: int  #: places at which faces of cracks press on each other
    factors: npt.NDArray[np.float64]  #: of each load case, by id
    _model: Any = dataclasses.field(repr=False)

    def reaction(self, support: int) -> npt.NDArray[np.float64]:
        """Force [N] of a support on the body, shape (2,)."""
        force = np.empty(2)
        self._model._open().call("bempd_load_case_reaction", len(self.factors), arguments.doubles(self.factors), support,
                                 arguments.doubles(force))
        return force

    def evaluate(self, points: npt.ArrayLike, *, stress: bool = True) -> PointValues:
        """Displacement and stress at places in the body."""
        places = arguments.point_array("evaluate: points", points)
        displacement, tensor = np.empty((len(places), 2)), np.empty((len(places), 3)) if stress else None
        self._model._open().call("bempd_load_case_evaluate", len(self.factors), arguments.doubles(self.factors), len(places),
                                 arguments.doubles(places), arguments.doubles(displacement), arguments.doubles(tensor))
        return PointValues(displacement, tensor, np.zeros(len(places), dtype=np.int32))
