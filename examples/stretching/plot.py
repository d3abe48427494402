"""Draws u1 along the centre line and the displacement fields of this example's runs.

usage: /usr/bin/python3 examples/stretching/plot.py [FOLDER]
"""

import argparse
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import field_plots

parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
parser.add_argument("folder", nargs="?", default="out/stretching", help="where the run wrote its files")
folder = parser.parse_args().folder

pictures = [
    field_plots.line_figure(folder, "centre_line", "u1", {"the linear field": lambda x: 2 * x - 1}),
    field_plots.contour_figure(folder, "fields", [
        (f"case {case}, {scheme}", f"{case}_{scheme}") for case in (1, 3) for scheme in ("symmetric", "paper")]),
]
for picture in filter(None, pictures):
    print(f"wrote {picture}")
