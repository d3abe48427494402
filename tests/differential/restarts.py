"""Saving reads and nothing else, and restored runs go on to the last bit: bodies with windows and without, faces of cracks
that meet, boundary elements, other Poisson's ratios, heat, lines, growing cracks, and supports that get new values.

    restarts.py [--scene NAME ... | --short] [--verbose]

Each scene runs never saved, with a state saved after every call, and from the bytes of some of these states, in models of
their own and in the one that was saved. All must end in the same state bytes. Prints one line for every scene; exits with 1 if one does
not."""

from __future__ import annotations

import argparse
import os
import sys
from typing import Callable, Optional

import bempd

os.environ["BEMPD_TEST_HOOKS"] = "1"  # options whose names begin with test.

Build = Callable[[], bempd.Model]
Call = Callable[[bempd.Model], object]

RESTARTS = 2  # from states spread evenly over the calls


def torn_plate(cells: int = 16, ratio: float = 1 / 3, cracks: tuple = (((0, 8.3), (5.2, 8.3)),),
               **options: object) -> bempd.Model:
    """Of unit cells, held below and pulled upwards above: support 2 moves."""
    model = bempd.Model(options={"threads": 1, **{name.replace("__", "."): value for name, value in options.items()}})
    material = model.add_material(young_modulus=1, poisson_ratio=ratio, critical_stretch=1e-3)
    plate = model.add_pd_region(material, bempd.rectangle(0, 0, cells, cells), 1, 3)
    for crack in cracks:
        model.add_crack(crack)
    model.fix_edge(plate, 1)
    model.prescribe_edge(plate, 3, "y", 1e-3 * cells)
    return model


def pulled_plate(**options: object) -> bempd.Model:
    """Held at both sides, with a crack inside: faces meet in its wake, which windows follow, from event 324 on."""
    model = bempd.Model(options={"threads": 1, **options})
    material = model.add_material(young_modulus=1, poisson_ratio=1 / 3, critical_stretch=1e-3)
    plate = model.add_pd_region(material, bempd.rectangle(0, 0, 39, 39), 1, 4)
    model.add_crack([(19.5, 15.500001), (19.5, 23.499999)])
    for edge, pull in ((4, -1.0), (2, 1.0)):
        model.prescribe_edge(plate, edge, "x", pull)
        model.prescribe_edge(plate, edge, "y", 0.0)
    return model


def coupled_strip(**options: object) -> bempd.Model:
    model = bempd.Model(options={"threads": 1, **{name.replace("__", "."): value for name, value in options.items()}})
    material = model.add_material(young_modulus=1, poisson_ratio=1 / 3, critical_stretch=1e-3)
    left = model.add_bem_region(material, bempd.rectangle(0, 0, 10, 12), 2)
    model.add_pd_region(material, bempd.rectangle(10, 0, 22, 12), 1, 3)
    right = model.add_bem_region(material, bempd.rectangle(22, 0, 32, 12), 2)
    model.add_crack([(16.4, 0), (16.4, 4.4)])
    model.fix_edge(left, 4)
    model.prescribe_edge(right, 2, "x", 32e-3)
    return model


def heated_bar(**options: object) -> bempd.Model:
    model = bempd.Model(options={"threads": 1, **options})
    material = model.add_material(young_modulus=1, poisson_ratio=1 / 3, critical_stretch=1e-3, thermal_expansion=1e-3)
    bar = model.add_pd_region(material, bempd.rectangle(0, 0, 24, 10), 1, 3)
    model.add_crack([(12.4, 0), (12.4, 3.3)])
    for edge in (2, 4):
        model.fix_edge(bar, edge, "x")
    model.fix_point((0, 0), "y")
    model.add_temperature(bar, -1.0)
    return model


def boundary_crack(points: tuple = ((0, 10), (3, 10.4)), **options: object) -> bempd.Model:
    model = bempd.Model(options={"threads": 1, **{name.replace("__", "."): value for name, value in options.items()}})
    material = model.add_material(young_modulus=1, poisson_ratio=0.3, fracture_energy=1e-6)
    plate = model.add_bem_region(material, bempd.rectangle(0, 0, 10, 20), 2)
    model.add_crack(points)
    model.fix_edge(plate, 1)
    model.prescribe_edge(plate, 3, "y", 1e-2)
    return model


def cracked_halves(**options: object) -> bempd.Model:
    """A crack in boundary elements below and one in a lattice above, which grow in turn."""
    model = bempd.Model(options={"threads": 1, **{name.replace("__", "."): value for name, value in options.items()}})
    material = model.add_material(young_modulus=1, poisson_ratio=1 / 3, fracture_energy=1e-6)
    below = model.add_bem_region(material, bempd.rectangle(0, 0, 16, 8), 2)
    above = model.add_pd_region(material, bempd.rectangle(0, 8, 16, 20), 1, 3)
    model.add_crack([(0, 4), (5, 4.2)])
    model.add_crack([(16, 14.5), (11.5, 14.5)])
    model.fix_edge(below, 1)
    model.prescribe_edge(above, 3, "y", 1e-2)
    return model


def events(count: int, limit: float = 1e9) -> list[Call]:
    return [lambda model: model.step_to_next_event(limit)] * count


def steps(*load_factors: float) -> list[Call]:
    return [lambda model, f=f: model.step(f) for f in load_factors]


def moved(*values: float) -> list[Call]:
    """By new values of a support, in steps of one."""
    calls: list[Call] = []
    for k, value in enumerate(values):
        calls.append(lambda model, value=value: model.set_support_values(2, 0.0, constant=value))
        calls.append(lambda model, k=k: model.step_to_values(k + 1.0))
    return calls


def reheated(*values: float) -> list[Call]:
    calls: list[Call] = []
    for k, value in enumerate(values):
        calls.append(lambda model, value=value: model.set_load_values(1, 0.0, constant=value))
        calls.append((lambda model, k=k: model.step_to_values(k + 1.0)) if k % 2 else (lambda model, k=k: model.step(1.0 * k)))
    return calls


SLANTED = (((4.2, 8.3), (15.7, 12.6)),)
SEVERAL = (((0, 12.3), (6.2, 12.3)), ((14.4, 7.2), (24, 9.1)), ((9.3, 17), (12.1, 19.4)))
pressed = steps(*(-0.3 * k for k in range(1, 5))) + steps(0.2) + events(15, 10)

SCENES: dict[str, tuple[Build, list[Call]]] = {
    "windows": (lambda: torn_plate(24), events(50) + [lambda model: model.run_to_separation(1e9)]),
    "windows in small steps": (torn_plate, steps(*(0.4 + 0.01 * k for k in range(40))) + events(5)),
    "windows and looks": (torn_plate, [call for event in events(25) for call in
                                       (event, lambda model: model.field(1, "displacement"))]),
    "windows around several cracks": (lambda: torn_plate(24, cracks=SEVERAL, test__window_length=6), events(40)),
    "one bond after the other": (lambda: torn_plate(crack__tie_share=0), events(40)),
    "whole body": (lambda: torn_plate(test__solver="plain"), events(20) + [lambda m: m.run_to_separation(1e9)]),
    "equilibrium path": (lambda: torn_plate(stepping__control="path"), events(50)),
    "increments": (lambda: torn_plate(paper__mode="paper", paper__increment=0.05),
                   steps(*(0.5 + 0.15 * k for k in range(8)))),
    "squares": (lambda: torn_plate(ratio=0.2), events(40)),
    "squares in the whole body": (lambda: torn_plate(ratio=0.1, test__solver="plain"), events(30)),
    "contact": (lambda: torn_plate(20, cracks=SLANTED), pressed),
    "contact in the whole body": (lambda: torn_plate(20, cracks=SLANTED, test__solver="plain"), pressed),
    "contact in windows": (pulled_plate, [lambda model: [model.step_to_next_event(1e9) for _ in range(318)]] + events(20)),
    "lines": (lambda: torn_plate(20, cracks=SLANTED, crack__rule="line"), events(20)),
    "lines in windows": (lambda: torn_plate(30, crack__rule="line"), [call for event in events(24) for call in
                                                                         (event, lambda m: m.field(1, "displacement"))]),
    "lines that begin": (lambda: torn_plate(20, cracks=(), crack__rule="line"), events(20)),
    "lines on the path": (lambda: torn_plate(24, ratio=0.2, crack__rule="line", stepping__control="path"), events(20)),
    "lines in the whole body": (lambda: torn_plate(crack__rule="line", test__solver="plain"), events(12)),
    "boundary elements": (coupled_strip, events(40)),
    "boundary elements, no windows": (lambda: coupled_strip(test__solver="plain"), steps(0.5, 1, 1.1) + events(30)),
    "new values": (torn_plate, moved(0.006, 0.012, 0.016, 0.018, 0.014, 0.02, 0.019, 0.026)),
    "new values of the whole body": (lambda: torn_plate(test__solver="plain"), moved(0.012, 0.016, 0.014, 0.02)),
    "heat": (heated_bar, reheated(-0.5, -0.9, -1.1, -0.6, -1.3, -1.4) + events(8)),
    "growing crack": (boundary_crack, [lambda model: model.grow_cracks(0.7)] * 4),
    "growing crack of which a tip is kept": (lambda: boundary_crack(((3, 9.7), (6, 10.4))), [
        lambda model: model.set_tip_frozen(1, bempd.TipEnd.START), *[lambda model: model.grow_cracks(0.7)] * 2,
        lambda model: model.set_tip_frozen(1, bempd.TipEnd.END), lambda model: model.set_tip_frozen(1, 1, False),
        lambda model: model.grow_cracks(0.7)]),
    "driven crack": (boundary_crack, steps(0.1) + events(6)),
    "driven crack on the path": (lambda: boundary_crack(((3, 9.7), (6, 10.4)), stepping__control="path"), events(6)),
    "driven crack beside a lattice": (cracked_halves, events(14)),
    "driven crack beside a lattice, on the path": (lambda: cracked_halves(stepping__control="path"), events(14)),
    "scheme paper": (lambda: torn_plate(scheme="paper"), events(20)),
}


# Scenes that repeat another with the solver of the whole body, which "whole body" has, with other steps, or with more cracks.
REPEATED = {"windows around several cracks", "growing crack", "driven crack on the path",
            "windows in small steps", "windows and looks", "squares in the whole body", "contact in the whole body",
            "lines in the whole body", "boundary elements, no windows", "new values of the whole body"}


def refused(call: Call, model: bempd.Model) -> Optional[str]:
    try:
        call(model)
    except bempd.Error as error:
        return type(error).__name__
    return None


def check(build: Build, calls: list[Call]) -> Optional[str]:
    unsaved, saved = build(), build()
    for model in (unsaved, saved):
        model.prepare()
    states, failures = [], 0
    for number, call in enumerate(calls, 1):
        one, other = refused(call, unsaved), refused(call, saved)
        if one != other:
            return f"call {number}: {one}; saved {other}"
        if one:
            failures += 1
        states.append(saved.save(values=True).to_bytes())
    end = unsaved.save(values=True).to_bytes()
    if states[-1] != end:
        return "other state bytes where states were saved"
    for k in range(len(calls) - 2, -1, -max(1, len(calls) // RESTARTS)):
        for where, model in (("another model", build()), ("the model", saved)):
            model.restore(bempd.State.from_bytes(states[k]))
            if model.save(values=True).to_bytes() != states[k]:
                return f"call {k + 1}: restored into {where}, it has other state bytes"
            for call in calls[k + 1:]:
                refused(call, model)
            if model.save(values=True).to_bytes() != end:
                return f"other state bytes after a restart of {where} behind call {k + 1} of {len(calls)}"
    if not unsaved.history().size or failures > len(calls) // 2:
        return f"nothing has happened, or {failures} calls failed"
    return None


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--scene", nargs="*", default=list(SCENES))
    parser.add_argument("--short", action="store_true", help="without scenes that repeat others")
    parser.add_argument("--verbose", action="store_true")
    arguments = parser.parse_args()
    if arguments.short:
        arguments.scene = [name for name in SCENES if name not in REPEATED]
    failed = 0
    for name in arguments.scene:
        finding = check(*SCENES[name])
        failed += finding is not None
        if finding or arguments.verbose:
            print(f"{name}: {finding or 'holds'}", flush=True)
    print(f"{len(arguments.scene)} scenes, {sum(len(SCENES[name][1]) for name in arguments.scene)} calls, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
