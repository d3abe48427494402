"""Draws u1 along the centre line and the displacement fields of this example's runs.

usage: /usr/bin/python3 examples/tension/plot.py [FOLDER]
"""

import argparse
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import field_plots

parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
parser.add_argument("folder", nargs="?", default="out/tension", help="where the run wrote its files")
folder = parser.parse_args().folder

traction, young_modulus = 5.25e6, 100e9
pictures = [
    field_plots.line_figure(folder, "centre_line", "u1", {"PL/EA": lambda x: traction * x / young_modulus}),
    field_plots.contour_figure(folder, "fields", [
        (f"case {case}, {scheme}", f"{case}_{scheme}") for case in (2, 4) for scheme in ("symmetric", "paper")]),
]
for picture in filter(None, pictures):
    print(f"wrote {picture}")
