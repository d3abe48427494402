"""Draws the pictures of this example's runs.

usage: /usr/bin/python3 examples/mixed_mode_crack/plot.py [FOLDER] [RUN...]
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import crack_plots

crack_plots.draw(
    "mixed_mode_crack",
    load=2e-8,
    load_label="displacement of each end",
    reaction="reaction_x_2",
    critical_stretch=8e-4,
)
