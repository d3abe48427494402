"""Draws the damage around the growing crack and the load-displacement curve of this example's run.

usage: /usr/bin/python3 examples/centre_crack/plot.py [FOLDER] [NAME]
"""

import argparse
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import plotting

parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
parser.add_argument("folder", nargs="?", default="out/centre_crack", help="where the run wrote its files")
parser.add_argument("name", nargs="?", default="centre_crack", help="name of the snapshots without number and ending")
parser.add_argument("--reaction", default="reaction_x_2", help="column of history.csv: pull at the right end")
parser.add_argument("--displacement", type=float, default=2e-8, help="displacement of an end per unit of load [m]")
parser.add_argument("--critical-stretch", type=float, default=8e-4, help="critical stretch of the bonds [-]")
parser.add_argument("--magnification", type=float, help="factor on displacements (default: chosen)")
options = parser.parse_args()

picture = plotting.fracture_figure(
    options.folder,
    options.name,
    reaction=options.reaction,
    displacement=options.displacement,
    displacement_label="displacement of each end",
    critical_stretch=options.critical_stretch,
    magnification=options.magnification,
)
print(f"wrote {picture}")
