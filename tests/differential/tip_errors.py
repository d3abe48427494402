"""Errors that tips tell in regions that are cut into subdomains, against true ones: those of elements 2.5 times as short, on
sheets of cracked_subdomains.py with 10 or 16 elements on each hole.

    tip_errors.py [--first SEED] [--count N] [--verbose]

Prints how many tips tell at least the true error; exits with 1 if that is less than 19 of 20 of them."""

from __future__ import annotations

import argparse
import math
import statistics
import sys
import warnings

import bempd

import cracked_subdomains

FINER, SHARE = 2.5, 0.95


class Sized(bempd.Model):
    """A model whose elements are shorter, or longer, than is asked."""

    finer = 1.0

    def add_bem_region(self, material, outline, element_length):  # type: ignore[no-untyped-def,override]
        return super().add_bem_region(material, outline, element_length / self.finer)

    def set_edge_mesh(self, region, edge, element_length):  # type: ignore[no-untyped-def,override]
        super().set_edge_mesh(region, edge, element_length / self.finer)


def tips(seed: int, most: int, finer: float) -> tuple[int, list[bempd.Tip]]:
    Sized.finer = finer
    model, _, _ = cracked_subdomains.build(seed, most)
    model.step(0.001)
    return model.statistics().subdomains, model.tips()


def ratios(seed: int, verbose: bool) -> list[float]:
    """Of told to true errors, of tips that are open."""
    finer = 0.6 if seed % 2 else 1.0
    subdomains, told = tips(seed, 50, finer)
    if subdomains == 0:
        return []
    _, true = tips(seed, 200, FINER * finer)
    found = []
    for one, other in zip(told, true):
        off = math.hypot(one.stress_intensity_1 - other.stress_intensity_1, one.stress_intensity_2 - other.stress_intensity_2)
        if off > 0:
            found.append(one.error / off)
            if verbose:
                size = math.hypot(other.stress_intensity_1, other.stress_intensity_2)
                print(f"sheet {seed}: told {one.error / size:.1e}, true {off / size:.1e}, ratio {found[-1]:.2f}")
    return found


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--count", type=int, default=4)
    parser.add_argument("--verbose", action="store_true")
    arguments = parser.parse_args()
    warnings.simplefilter("ignore")
    bempd.Model = Sized  # type: ignore[misc]
    all_ratios = [ratio for seed in range(arguments.first, arguments.first + arguments.count)
                  for ratio in ratios(seed, arguments.verbose)]
    honest = sum(ratio >= 1 for ratio in all_ratios)
    print(f"{honest} of {len(all_ratios)} tips tell at least the true error; told over true is {min(all_ratios):.2f} to "
          f"{max(all_ratios):.0f}, {statistics.median(all_ratios):.1f} in the middle")
    return int(honest < SHARE * len(all_ratios) or not all_ratios)


if __name__ == "__main__":
    sys.exit(main())
