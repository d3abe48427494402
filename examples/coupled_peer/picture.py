"""The picture of the coupled run: the block's temperature beside the damaged specimen, the force, and the trials."""

from __future__ import annotations

import pathlib

import matplotlib

matplotlib.use("Agg")
import bempd.plot
import matplotlib.pyplot as plt
import numpy as np

CURVE, MARK, PALE = "#1f4e79", "#b3261e", "#7d838c"


def draw(folder: pathlib.Path, rows: list[dict], torn_at: dict, specimen, peer) -> pathlib.Path:
    block = peer.block
    figure = plt.figure(figsize=(9, 5.4), constrained_layout=True)
    grid = figure.add_gridspec(2, 2, height_ratios=[1.1, 1])
    body = figure.add_subplot(grid[0, :])
    bempd.plot.draw(specimen.model, "damage", axes=body, magnification=20, colour_bar=False)
    nx, ny = block.cells
    x = block.left + np.linspace(0, block.width, 2 * nx + 1)
    y = np.linspace(0, block.height, 2 * ny + 1)
    moved = peer.displacement_field(torn_at["temperature"], torn_at["forces"]).reshape(2, len(x), len(y))
    places = np.array(np.meshgrid(x, y, indexing="ij")) + 20 * moved
    temperature = torn_at["temperature"].reshape(len(x), len(y))
    shown = body.pcolormesh(*(1e3 * places), temperature, cmap="Blues_r", shading="gouraud")
    figure.colorbar(shown, ax=body, label="block [K]", shrink=0.8)
    body.set_xlim(-3, 1e3 * x[-1] + 3)
    body.set_aspect("equal")
    body.set_title(f"{torn_at['hours']:.2f} h: {torn_at['bonds']} bonds broken, displacements x 20")
    hours, force = [row["hours"] for row in rows], [row["force"] for row in rows]
    left, right = figure.add_subplot(grid[1, 0]), figure.add_subplot(grid[1, 1])
    left.plot([0, *hours], [0, *force], "o-", color=CURVE, markersize=3, linewidth=1)
    torn = [row for row in rows if row["torn"]]
    left.plot([row["hours"] for row in torn], [row["force"] for row in torn], "o", color=MARK, markersize=4,
              label="where no step is short enough")
    left.legend(frameon=False, fontsize=8, loc="upper left")
    left.set(xlabel="time [h]", ylabel="force between both programs [N]")
    right.bar(range(1, len(rows) + 1), [row["trials"] for row in rows],
              color=[MARK if row["torn"] else PALE for row in rows])
    right.set(xlabel="accepted step", ylabel="trials until both agree to 1e-9")
    path = folder / "coupled_peer.png"
    figure.savefig(path, dpi=160)
    return path
