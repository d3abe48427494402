"""What growth by cycles has brought: the life of a part, its curves, when to look at it."""

from __future__ import annotations

import csv
import dataclasses
import os
from typing import Any, Optional, Union

import numpy as np
import numpy.typing as npt

from .errors import ArgumentError
from .reports import Named, TipEnd


ROUNDING = 1e-9


class FatigueStop(Named):
    """Why growth by cycles ended."""

    CYCLES = 1  #: the number of cycles asked for has passed
    CRITICAL = 2  #: a tip has reached its critical factor
    LENGTH = 3  #: a crack has the length asked for
    NONE_GROWS = 4  #: all tips are below their thresholds, or pressed together
    TIP_ENDED = 5  #: at an edge, a hole or another crack; a further call goes on with the others
    TIP_STOPPED = 6  #: where it cannot grow on, as at an interface
    STEPS = 7  #: the number of steps asked for was made
    REQUESTED = 8  #: by request_stop()
    NET_SECTION = 9  #: the net section of a tip yields as a whole


@dataclasses.dataclass(frozen=True)
class FatigueLife:
    """Growth of cracks by cycles. `table` has a row for each tip and step: cycles, length, range, ratio, rate ..."""

    stop_reason: FatigueStop
    crack: int  #: whose tip is the reason; 0: none
    end: Optional[TipEnd]
    steps: int
    cycles: float  #: that have passed, with those before
    growth: float  #: of all tips [m]
    error: float  #: estimate for the cycles, as a share of them; NaN if no tip led two steps
    table: npt.NDArray[Any] = dataclasses.field(repr=False, compare=False)
    interval: float = float("nan")  #: cycles between two inspections, where a detectable length was given

    def tip(self, crack: int, end: Union[TipEnd, int] = TipEnd.END) -> npt.NDArray[Any]:
        """The rows of one tip."""
        found: npt.NDArray[Any] = self.table[(self.table["crack"] == crack) & (self.table["end"] == int(end))]
        if len(found) == 0:
            raise ArgumentError(f"tip: crack {crack} has no tip at its {TipEnd(end).name.lower()} that grew by cycles")
        return found

    def cycles_at(self, length: float, crack: int = 1) -> float:
        """Cycles at which a crack has a length [m], between the steps by their rates; NaN beyond the table."""
        found = self.table[self.table["crack"] == crack]
        if len(found) == 0:
            raise ArgumentError(f"cycles_at: crack {crack} has no tip that grew by cycles")
        steps = np.unique(found["step"])
        lengths = np.array([found["length"][found["step"] == step][0] for step in steps])
        cycles = np.array([found["cycles"][found["step"] == step][0] for step in steps])
        rates = np.array([found["rate"][found["step"] == step].sum() for step in steps])
        if not lengths[0] * (1 - ROUNDING) <= length <= lengths[-1] * (1 + ROUNDING):
            return float("nan")
        length = min(max(length, lengths[0]), lengths[-1])
        k = int(np.searchsorted(lengths, length))  # first step with at least that length
        if lengths[k] == length:
            return float(cycles[k])
        whole = _passed(lengths[k - 1], lengths[k], rates[k - 1], rates[k], lengths[k])
        part = _passed(lengths[k - 1], lengths[k], rates[k - 1], rates[k], length)
        return float(cycles[k - 1] + (cycles[k] - cycles[k - 1]) * part / whole)

    def inspection_interval(self, detectable: float, crack: int = 1, *, inspections: int = 2) -> float:
        """Cycles between two inspections that find a crack from a length [m] on, so many times before the end."""
        if inspections < 1:
            raise ArgumentError(f"inspection_interval: inspections is {inspections}; give at least 1")
        found = self.cycles_at(detectable, crack)
        if np.isnan(found):
            raise ArgumentError(f"inspection_interval: crack {crack} never has the length {detectable:g} here")
        return (self.cycles - found) / inspections

    def inspected(self, detectable: float, *, inspections: int = 2) -> FatigueLife:
        """The same with the interval of inspections of the crack that ended the growth, or else of the longest one."""
        last = self.table[self.table["step"] == self.table["step"].max()]
        crack = self.crack or int(last["crack"][np.argmax(last["length"])])
        return dataclasses.replace(self, interval=self.inspection_interval(detectable, crack, inspections=inspections))

    def write_csv(self, path: Union[str, os.PathLike[str]]) -> None:
        """Write the table: N, a, K, dK, R, da/dN of each tip and step."""
        with open(path, "w", newline="", encoding="utf-8") as file:
            writer = csv.writer(file)
            writer.writerow(self.table.dtype.names or ())
            writer.writerows(tuple(row) for row in self.table.tolist())

    def plot(self, axes: Any = None) -> Any:
        """Draw a-N curves on the left, and da/dN over dK on the right; returns the pair of axes of matplotlib."""
        if axes is None:
            import matplotlib.pyplot as plt

            axes = plt.subplots(1, 2, figsize=(9, 3.6), layout="constrained")[1]
        growth, rates = axes
        for crack in np.unique(self.table["crack"]):
            found = self.table[self.table["crack"] == crack]
            _, first = np.unique(found["step"], return_index=True)
            growth.plot(found["cycles"][first], found["length"][first], "o-", markersize=3, label=f"crack {crack}")
            for end in np.unique(found["end"]):
                tip = found[(found["end"] == end) & (found["rate"] > 0)]
                rates.loglog(tip["range"], tip["rate"], "o", markersize=3, label=f"{crack}, {TipEnd(end).name.lower()}")
        growth.set(xlabel="cycles", ylabel="length of the crack [m]")
        rates.set(xlabel="range of the stress intensity factor [Pa m$^{1/2}$]", ylabel="growth in a cycle [m]")
        for each in axes:
            each.legend(frameon=False)
        return axes


def _passed(start: float, end: float, first: float, last: float, at: float) -> float:
    """Cycles from the start to a length, where the rate is a power of the length."""
    if not (first > 0 and last > 0):
        return at - start
    power = 1 - np.log(last / first) / np.log(end / start)
    if abs(power) < 1e-9:
        return float(start / first * np.log(at / start))
    return float(start / first * ((at / start) ** power - 1) / power)
