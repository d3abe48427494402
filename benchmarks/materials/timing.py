"""Processor seconds of runs that are compared with each other."""

from __future__ import annotations

import math
from typing import Callable, Hashable, TypeVar

Key = TypeVar("Key", bound=Hashable)
ROUNDS = 7


def least_in_turns(runs: dict[Key, Callable[[], float]]) -> dict[Key, float]:
    """The least seconds of each, of runs taken in turns: what else the machine does then meets all of them."""
    least = dict.fromkeys(runs, math.inf)
    for _ in range(ROUNDS):
        for key, run in runs.items():
            least[key] = min(least[key], run())
    return least
