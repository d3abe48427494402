"""Hosts that look for their own mistakes have invalid operations, divisions by zero and overflows end the program. Random scenes
whose cracks grow as lines run through under such traps; so do loads that turn back, and tips in what does not break."""

from __future__ import annotations

import ctypes
import faulthandler
import os
import pathlib
import sys
from typing import Callable

import pytest

import bempd

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "differential"))
import random_scenes  # noqa: E402

# Values of the exceptions in <fenv.h> on these processors.
INVALID, DIVISION_BY_ZERO, OVERFLOW, ALL = 1, 4, 8, 63

pytestmark = pytest.mark.skipif(sys.platform != "linux" or os.uname().machine != "x86_64", reason="other traps")


def ends_well_under_traps(run: Callable[[], None]) -> bool:
    """In a process of its own, which a trap would end."""
    child = os.fork()
    if child == 0:
        faulthandler.disable()
        try:
            functions = ctypes.CDLL("libm.so.6")
            functions.feclearexcept(ALL)
            functions.feenableexcept(INVALID | DIVISION_BY_ZERO | OVERFLOW)
            run()
        finally:
            os._exit(0)
    return os.waitpid(child, 0)[1] == 0


def test_a_trap_is_noticed() -> None:
    assert not ends_well_under_traps(lambda: ctypes.CDLL("libm.so.6").feraiseexcept(DIVISION_BY_ZERO))


def random_scene(seed: int) -> None:
    random_scenes.LINES = True
    try:
        model, _, _ = random_scenes.build(seed, ("plain", "window")[seed % 2])
        for way in (1e9, -1e9):
            for _ in range(10):
                if model.step_to_next_event(way).stop_reason != bempd.StopReason.EVENT:
                    break
    except bempd.Error:
        pass


# A third of these scenes ended at a division by zero once.
@pytest.mark.parametrize("seed", [2, 6, 7, 8, 12, 13, 15, 16, 21, 23, 26, 28, 31, 32, *range(61, 73)])
def test_random_scenes_raise_no_floating_point_exception(seed: int) -> None:
    assert ends_well_under_traps(lambda: random_scene(seed))


def unloaded_tip() -> None:
    """Loads reach one of two cracks only, and none of them is proportional in the first step."""
    model = bempd.Model(options={"crack.rule": "line"})
    glass = model.add_material(young_modulus=1, poisson_ratio=1 / 3, critical_stretch=1e-3)
    loose = model.add_pd_region(glass, bempd.rectangle(20, 0, 30, 9), 1, 3)
    body = model.add_pd_region(glass, bempd.rectangle(0, 0, 12, 9), 1, 3)
    for x in (6.3, 25.3):
        model.add_crack([(x, 0), (x, 3.3)])
    for region in (loose, body):
        model.fix_edge(region, 4, "both")
    model.add_traction(body, 2, "x", 0, constant=1e-5)
    for target in (1.0, -1.0):
        model.step(target)


def test_tips_that_nothing_loads_raise_no_floating_point_exception() -> None:
    assert ends_well_under_traps(unloaded_tip)
