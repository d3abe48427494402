"""Draws the pictures of this example's runs.

usage: /usr/bin/python3 examples/two_edge_cracks/plot.py [FOLDER] [RUN...]
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import crack_plots

crack_plots.draw(
    "two_edge_cracks",
    load=0.1e6,
    load_label="traction",
    load_unit="Pa",
    # The shape is not deformed: nothing resists the load in the end, so displacements would hide the paths.
    magnification=0,
)
