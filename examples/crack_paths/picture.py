"""The picture of this example: ways of cracks beside known ones."""

from __future__ import annotations

import math
import pathlib

import cases
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.patches import Circle, Rectangle

BODY, EDGE, OURS, KNOWN = "#e3e5e8", "#7d838c", "#1f4e79", "#b3261e"


def body(axes, low, high, holes=()):
    axes.add_patch(Rectangle(low, high[0] - low[0], high[1] - low[1], facecolor=BODY, edgecolor=EDGE, linewidth=0.8))
    for centre, radius in holes:
        axes.add_patch(Circle(centre, radius, facecolor="white", edgecolor=EDGE, linewidth=0.8))
    axes.set_aspect("equal")
    axes.autoscale_view()
    axes.axis("off")


def line(axes, way, label=None):
    axes.plot(*zip(*way), color=OURS, linewidth=1.4, label=label)


def dots(axes, places, label):
    axes.plot(*zip(*places), "o", color=KNOWN, markersize=3, markerfacecolor="none", label=label)


def draw(drawn, folder: pathlib.Path) -> pathlib.Path:
    figure, axes = plt.subplots(3, 2, figsize=(10, 8.6))
    for ax, (name, (ways, known)) in zip(axes[0], drawn["two_holes"].items()):
        body(ax, (0, 0), (20, 10), (((3, 7), 2), ((17, 3), 2)))
        for crack in (1, 2):
            line(ax, ways[crack], "bempd" if crack == 1 else None)
            dots(ax, known[crack], "X-FEM (MSolve), steps of 1 mm" if crack == 1 else None)
        ax.set_title(f"Bouchard's plate: {name}", fontsize=9)
        ax.legend(fontsize=7, loc="lower left")
    ax = axes[1, 0]
    body(ax, (0, 0), (20, 8), [(hole, cases.HOLE_RADIUS) for hole in cases.HOLES])
    for (notch, offset), way in drawn["three_holes"].items():
        if offset in (5, 6):
            line(ax, way)
        else:
            ax.plot(*zip(*way), color=OURS, linewidth=0.8, linestyle=":")
    ax.set_title("notches 6 and 5 inches off the middle (dotted: 4.95 and 5.05)", fontsize=9)
    ax = axes[1, 1]
    body(ax, (0, 0), (140, 70), (((95, 35), 15),))
    line(ax, drawn["compressed_plate"]["way"], "bempd")
    dots(ax, drawn["compressed_plate"]["measured"], "experiment (Réthoré 2018)")
    ax.set_title("plate pressed together at its ends", fontsize=9)
    ax.legend(fontsize=7, loc="lower right")
    ax = axes[2, 0]
    body(ax, (0, -20), (40, 20))
    for way in drawn["edge_cracks"]["ways"]:
        line(ax, way)
    ax.set_title("edge cracks, 1 mm apart", fontsize=9)
    ax = axes[2, 1]
    body(ax, (-661, 0), (661, 306))
    line(ax, drawn["four_points"]["way"])
    for x, y, way in ((61, 306, -60), (-458, 306, -20), (-61, 0, 50), (458, 0, 20)):
        ax.annotate("", (x, y), (x, y - way), arrowprops={"arrowstyle": "->", "color": EDGE})
    ax.set_title("notched beam in four-point shear", fontsize=9)
    figure.tight_layout()
    path = folder / "crack_paths.png"
    figure.savefig(path, dpi=110)
    return path


def draw_experiment(drawn, folder: pathlib.Path) -> pathlib.Path:
    """The crack path of the pressed plate beside the photographs of the experiment, alone in a small picture."""
    figure, ax = plt.subplots(figsize=(5.6, 2.9))
    body(ax, (0, 0), (140, 70), (((95, 35), 15),))
    x, y = drawn["compressed_plate"]["measured"][0]
    mouth = math.dist((x, y), (95, 35))
    ax.plot([x, 95 + 15 / mouth * (x - 95)], [y, 35 + 15 / mouth * (y - 35)], color="black", linewidth=1.8, label="notch")
    line(ax, drawn["compressed_plate"]["way"], "bempd")
    dots(ax, drawn["compressed_plate"]["measured"], "experiment (Réthoré 2018)")
    for x, y, way in ((0, 35, 12), (140, 35, -12)):
        ax.annotate("", (x, y), (x - way, y), arrowprops={"arrowstyle": "-|>", "color": EDGE})
    ax.set_title("Crack path in a plate of acrylic glass, 140 x 70 mm, pressed at its ends", fontsize=8)
    ax.legend(fontsize=7, loc="upper left", bbox_to_anchor=(0.08, 0.95), frameon=False)
    figure.tight_layout()
    path = folder / "path_experiment.png"
    figure.savefig(path, dpi=120)
    plt.close(figure)
    return path
