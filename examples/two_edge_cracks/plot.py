"""Draws the damage around the growing cracks, the load curve and the displacements of this example's runs.

usage: /usr/bin/python3 examples/two_edge_cracks/plot.py [FOLDER] [RUN...]
"""

import argparse
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import field_plots
import plotting

parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
parser.add_argument("folder", nargs="?", default="out/two_edge_cracks", help="where the run wrote its files")
parser.add_argument("runs", nargs="*", help="names of runs, such as events_symmetric (default: all)")
options = parser.parse_args()
runs = options.runs or plotting.written_runs(options.folder)

for run in runs:
    picture = plotting.fracture_figure(
        options.folder,
        run,
        load=0.1e6,
        load_label="traction",
        load_unit="Pa",
        # At the end nothing resists the load any more, so displacements would hide the paths.
        magnification=0,
    )
    print(f"wrote {picture}")
panels = [(f"{run.replace('_', ', ')}, first break", run) for run in runs]
picture = field_plots.contour_figure(options.folder, "fields", panels, length_unit=1e-3, length_name="mm")
if picture:
    print(f"wrote {picture}")
