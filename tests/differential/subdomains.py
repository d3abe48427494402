"""Random scenes of lattices and BEM regions whose regions are once whole and once cut into subdomains of a few elements.
Both must answer alike: stored energy and reactions of the elastic body, and the load of the first event.

    subdomains.py [--first SEED] [--count N] [--elements MOST]

Prints one line for every scene that differs and a summary; exits with 1 if any does."""

from __future__ import annotations

import argparse
import math
import sys
from typing import Optional

import bempd
import random_scenes

SMALL_LOAD, NO_ENERGY = 1e-3, 1e-20
ENERGY, FORCE, LOAD = 3e-3, 1e-2, 1e-2  # largest differences, of the energy, the largest force and the load


def answer(seed: int, most_elements: int) -> tuple[int, Optional[float], list[float], float]:
    """Subdomains, energy (None if bonds broke) and reactions, load factor of the next event (0: none up to 1e4)."""
    model, supports, _ = random_scenes.build(seed, "window")
    model.options["test.subdomain_elements"] = most_elements
    first = model.step(SMALL_LOAD)
    forces = [float(force) for support in range(1, supports + 1) for force in model.reaction(support)]
    subdomains = model.statistics().subdomains
    report = model.step_to_next_event(1e4)
    energy = None if first.events else first.stored_energy
    return subdomains, energy, forces, report.load_factor if report.events > 0 else 0.0


def difference(seed: int, most_elements: int) -> tuple[int, str]:
    """Number of subdomains, and in words what differs; scenes that bonds leave at once, or without loads, have no figures."""
    try:
        _, energy, forces, load = answer(seed, 10**9)
    except bempd.Error:
        return 0, ""
    if energy is None or energy < NO_ENERGY:
        return 0, ""
    subdomains, cut_energy, cut_forces, cut_load = answer(seed, most_elements)
    size = max(map(abs, forces), default=0.0)
    if cut_energy is None or abs(cut_energy - energy) > ENERGY * energy:
        return subdomains, f"energy {energy:.6g} whole, {cut_energy} cut"
    if math.dist(forces, cut_forces) > FORCE * size:
        return subdomains, f"reactions {forces} whole, {cut_forces} cut"
    if abs(cut_load - load) > LOAD * abs(load):
        return subdomains, f"first event at {load:.6g} whole, {cut_load:.6g} cut"
    return subdomains, ""


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("--first", type=int, default=1)
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--elements", type=int, default=16)
    arguments = parser.parse_args()
    found = cut = 0
    for seed in range(arguments.first, arguments.first + arguments.count):
        subdomains, sentence = difference(seed, arguments.elements)
        cut += subdomains > 0
        if sentence:
            found += 1
            print(f"scene {seed}, {subdomains} subdomains: {sentence}")
    print(f"{arguments.count} scenes, {cut} with subdomains: {found} differ")
    return 1 if found or cut == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
