"""Draws what the machine did, from the table that the program prints.

usage: /usr/bin/python3 examples/host_loop/plot.py [FOLDER]
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import numpy as np
from plotting import CURVE, MARK, STYLE, plt

folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "out/host_loop")
rows = [line.split() for line in (folder / "printed.txt").read_text().splitlines()]
steps = np.array([[float(cell) for cell in row] for row in rows if len(row) == 10 and row[0].isdigit()])
crosshead, elongation, force, broken, cuts = (steps[:, column] for column in (3, 4, 6, 7, 9))
with plt.rc_context(STYLE):
    figure, (left, right) = plt.subplots(1, 2, figsize=(7.4, 3.1), layout="constrained")
    left.plot(elongation, force, "o-", color=CURVE, markersize=3, linewidth=1.1, label="accepted step")
    repeated = cuts > 0
    left.plot(elongation[repeated], force[repeated], "o", color=MARK, markersize=6, fillstyle="none",
              label="repeated with a smaller increment")
    left.set(xlabel="elongation of the specimen [\u00b5m]", ylabel="force on the grip [N]", title="Force and elongation")
    left.legend(loc="upper left", fontsize=7.5)
    left.set_ylim(top=1.35 * force.max())
    right.plot(crosshead, broken, "o-", color=CURVE, markersize=3, linewidth=1.1)
    right.set(xlabel="crosshead [\u00b5m]", ylabel="broken bonds", title="Crosshead and growth")
    for axes in (left, right):
        axes.grid(color="#dddddd", linewidth=0.5)
        axes.set_axisbelow(True)
    figure.savefig(folder / "host_loop.png", dpi=160)
print(f"wrote {folder / 'host_loop.png'}")
