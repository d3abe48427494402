"""Draws u2 along the centre line and the displacement fields of this example's runs.

usage: /usr/bin/python3 examples/shear/plot.py [FOLDER]
"""

import argparse
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import field_plots

parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
parser.add_argument("folder", nargs="?", default="out/shear", help="where the run wrote its files")
folder = parser.parse_args().folder

force, length, height, young_modulus = 100e3, 1.0, 0.2, 100e9
bending_stiffness = young_modulus * height**3 / 12
shear_stiffness = 5 / 6 * young_modulus / (2 * (1 + 1 / 3)) * height


def euler_bernoulli(x):
    return -force * x**2 * (3 * length - x) / (6 * bending_stiffness)


def timoshenko(x):
    return euler_bernoulli(x) - force * x / shear_stiffness


pictures = [
    field_plots.line_figure(folder, "centre_line", "u2", {"Timoshenko": timoshenko, "Euler-Bernoulli": euler_bernoulli}),
    field_plots.contour_figure(folder, "fields", [
        (f"case {case}, {scheme}", f"{case}_{scheme}") for case in (2, 4) for scheme in ("symmetric", "paper")]),
]
for picture in filter(None, pictures):
    print(f"wrote {picture}")
