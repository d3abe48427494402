"""The scenes of the tutorials as pictures, and the body from a drawing; docs/figures.py draws them.

Scenes are in millimetres."""

from __future__ import annotations

import pathlib
import tempfile

import bempd
import matplotlib.pyplot as plt
import numpy as np
from bempd import Model

BLUE, RED, ORANGE, GREY = "#1f4e79", "#b3261e", "#c05a00", "#7d838c"
STYLE = {"font.size": 10, "axes.linewidth": 0.7, "xtick.direction": "in", "ytick.direction": "in", "legend.frameon": False,
         "figure.dpi": 100, "savefig.dpi": 160, "axes.grid": True, "grid.color": "#dddddd", "grid.linewidth": 0.5,
         "axes.axisbelow": True}
BODY, LATTICE = "#e3e5e8", "#fff3c4"


def arrow(axes, start, end, text, colour=ORANGE, **place) -> None:
    axes.annotate("", end, start, arrowprops={"arrowstyle": "-|>", "color": colour, "linewidth": 1.4})
    axes.text(*place.pop("at"), text, color=colour, fontsize=9, **place)


def dimension(axes, start, end, text, **place) -> None:
    """A length with arrows at both ends."""
    axes.annotate("", end, start, arrowprops={"arrowstyle": "<->", "color": "black", "linewidth": 0.8, "shrinkA": 0, "shrinkB": 0})
    axes.text(*place.pop("at"), text, fontsize=9, **place)


def clamp(axes, start, end, outward) -> None:
    """Hatches along an edge that is held."""
    (x, y), (u, v) = start, end
    corners = [(x, y), (u, v), (u + outward[0], v + outward[1]), (x + outward[0], y + outward[1])]
    axes.add_patch(plt.Polygon(corners, facecolor="none", edgecolor=GREY, hatch="////", linewidth=0))
    axes.plot([x, u], [y, v], color=BLUE, linewidth=2.5)


def draw_plate_scene(folder: pathlib.Path) -> None:
    """The plate of docs/first_path.md, in millimetres."""
    figure, axes = plt.subplots(figsize=(4.4, 4.2), layout="constrained")
    axes.add_patch(plt.Rectangle((0, 0), 100, 100, facecolor=BODY, edgecolor=GREY))
    axes.add_patch(plt.Circle((50, 64), 12, facecolor="white", edgecolor=GREY))
    axes.plot([0, 20], [40, 40], color=RED, linewidth=2.5)
    axes.text(1, 34, "crack, 20 mm", color=RED, fontsize=9)
    axes.text(50, 64, "hole", ha="center", va="center", fontsize=9)
    clamp(axes, (0, 0), (100, 0), (0, -4))
    axes.plot([0, 100], [100, 100], color=BLUE, linewidth=2.5)
    axes.text(50, 3, "edge 1: held", ha="center", color=BLUE, fontsize=9)
    axes.text(50, 93, "edge 3: x held, y prescribed", ha="center", color=BLUE, fontsize=9)
    for x in (8, 92):
        axes.annotate("", (x, 112), (x, 101), arrowprops={"arrowstyle": "-|>", "color": ORANGE, "linewidth": 1.6})
    axes.text(50, 106, "1e-6 m per unit of load factor", ha="center", color=ORANGE, fontsize=9)
    axes.text(102, 50, "edge 2", va="center", rotation=90, fontsize=9, color=GREY)
    dimension(axes, (0, -9), (100, -9), "100 mm", at=(50, -10), ha="center", va="top")
    axes.set(xlim=(-4, 110), ylim=(-18, 114), aspect="equal")
    axes.axis("off")
    figure.savefig(folder / "first_path_scene.png", dpi=120, bbox_inches="tight", pad_inches=0.05)
    plt.close(figure)


def draw_strip_scene(folder: pathlib.Path) -> None:
    """The strip of the tutorial in millimetres: regions and crack; beside it spacing and horizon around the tip."""
    figure, (axes, near) = plt.subplots(1, 2, figsize=(9.4, 3.1), width_ratios=[1.9, 1], layout="constrained")
    for low, high, colour in ((0, 20, BODY), (20, 40, LATTICE), (40, 60, BODY)):
        axes.add_patch(plt.Rectangle((low, 0), high - low, 20, facecolor=colour, edgecolor=GREY))
    for low, high in ((0, 20), (40, 60)):
        places = np.arange(low, high + 1, 5)
        for x, y in [*((x, y) for x in places for y in (0, 20)), *((x, y) for x in (low, high) for y in (5, 10, 15))]:
            axes.plot(x, y, "|" if y in (0, 20) else "_", color=BLUE, markersize=7)
    rows, columns = np.meshgrid(np.arange(0, 21), np.arange(20, 41))
    axes.plot(columns.ravel(), rows.ravel(), ".", color=GREY, markersize=1.6)
    axes.plot([29.5, 29.5], [0, 4.5], color=RED, linewidth=2.5)
    for x, text in ((10, "boundary elements"), (30, "lattice"), (50, "boundary elements")):
        axes.text(x, 13, text, ha="center", fontsize=9, bbox={"facecolor": "white", "alpha": 0.8, "linewidth": 0, "pad": 1})
    clamp(axes, (0, 0), (0, 20), (-1.5, 0))
    axes.text(0.8, 8, "edge 4:\nheld", color=BLUE, fontsize=9)
    axes.plot([60, 60], [0, 20], color=BLUE, linewidth=2.5)
    axes.text(59.2, 8, "edge 2:\nprescribed", color=BLUE, fontsize=9, ha="right")
    for y in (4, 16):
        axes.annotate("", (65.5, y), (60.5, y), arrowprops={"arrowstyle": "-|>", "color": ORANGE, "linewidth": 1.6})
    axes.text(61, 10, "1e-6 m\nper unit", color=ORANGE, fontsize=9, va="center")
    axes.annotate("crack", (29.5, 2.5), (24.5, 5.5), color=RED, fontsize=9, arrowprops={"arrowstyle": "-", "color": RED, "linewidth": 0.8})
    for low, high in ((0, 20), (20, 40), (40, 60)):
        dimension(axes, (low, -1.8), (high, -1.8), "20 mm", at=((low + high) / 2, -2.3), ha="center", va="top")
    axes.add_patch(plt.Rectangle((24, 0), 11, 9.7, fill=False, edgecolor="black", linestyle="--", linewidth=0.8))
    axes.set(xlim=(-2, 69), ylim=(-6, 22), aspect="equal")

    rows, columns = np.meshgrid(np.arange(0, 10), np.arange(24, 36))
    places = np.column_stack([columns.ravel(), rows.ravel()])
    near.plot(*places.T, ".", color=GREY, markersize=4)
    near.plot([29.5, 29.5], [0, 4.5], color=RED, linewidth=3)
    centre = np.array([31, 5])
    for place in places[np.hypot(*(places - centre).T) <= 4 + 1e-9]:
        # Bonds across the initial crack are cut.
        crosses = place[0] < 29.5 and centre[1] + (29.5 - centre[0]) / (place[0] - centre[0]) * (place[1] - centre[1]) < 4.5
        if not crosses:
            near.plot(*np.column_stack([centre, place]), color=BLUE, linewidth=0.6, zorder=1)
    near.plot(*centre, "o", color=BLUE, markersize=6)
    near.add_patch(plt.Circle(centre, 4, fill=False, color=BLUE, linestyle="--", linewidth=0.9))
    arrow(near, centre, centre + (4 * np.cos(0.6), 4 * np.sin(0.6)), "horizon:\n4 spacings", BLUE, at=(35.6, 8.2), va="center")
    dimension(near, (25, 9.6), (26, 9.6), "spacing: 1 mm", at=(25.5, 9.9), ha="center", va="bottom")
    near.annotate("tip half way\nbetween two rows", (29.5, 4.5), (36, 1.2), color=RED, fontsize=9,
                  arrowprops={"arrowstyle": "-", "color": RED, "linewidth": 0.8})
    near.set(xlim=(23.5, 41), ylim=(-0.5, 11), aspect="equal")
    for one in (axes, near):
        one.axis("off")
    figure.savefig(folder / "tutorial_scene.png", dpi=110, bbox_inches="tight", pad_inches=0.05)
    plt.close(figure)


def draw_fatigue_scene(folder: pathlib.Path) -> None:
    """The plate of docs/fatigue.md in millimetres, and its load over the cycles."""
    figure, (axes, load) = plt.subplots(1, 2, figsize=(7.6, 3.6), width_ratios=[1, 1.3], layout="constrained")
    axes.add_patch(plt.Rectangle((-100, -300), 200, 600, facecolor=BODY, edgecolor=GREY))
    axes.plot([-5, 5], [0, 0], color=RED, linewidth=3)
    axes.annotate("crack,\n10 mm", (-3, 6), (-92, 60), color=RED, fontsize=9, arrowprops={"arrowstyle": "-", "color": RED, "linewidth": 0.8})
    for x in (-75, -25, 25, 75):
        for sign in (-1, 1):
            axes.annotate("", (x, sign * 370), (x, sign * 304), arrowprops={"arrowstyle": "-|>", "color": ORANGE, "linewidth": 1.4})
    axes.text(112, 338, "100 MPa per unit", color=ORANGE, fontsize=9, va="center")
    dimension(axes, (-100, -230), (100, -230), "200 mm", at=(0, -222), ha="center", va="bottom")
    dimension(axes, (118, -300), (118, 300), "600 mm", at=(126, 0), va="center")
    axes.set(xlim=(-110, 260), ylim=(-385, 385), aspect="equal")
    axes.axis("off")
    cycles = np.linspace(0, 4, 400)
    load.plot(cycles, 0.55 - 0.45 * np.cos(2 * np.pi * cycles), color=BLUE)
    load.axhline(1, color=GREY, linewidth=0.7, linestyle="--")
    load.axhline(0.1, color=GREY, linewidth=0.7, linestyle="--")
    load.text(4.05, 1.01, "high = 1", va="bottom", fontsize=9)
    load.text(4.05, 0.11, "low = 0.1", va="bottom", fontsize=9)
    load.set(xlim=(0, 5), ylim=(0, 1.15), xlabel="cycles", ylabel="load factor", xticks=range(5))
    load.grid(False)
    figure.savefig(folder / "fatigue_scene.png", dpi=110, bbox_inches="tight", pad_inches=0.05)
    plt.close(figure)


def draw_body_scene(folder: pathlib.Path) -> None:
    """The plate of docs/bodies.md in metres."""
    figure, axes = plt.subplots(figsize=(7.0, 2.6), layout="constrained")
    axes.add_patch(plt.Rectangle((0, 0), 3, 1, facecolor=BODY, edgecolor=GREY))
    axes.add_patch(plt.Circle((2, 0.5), 0.2, facecolor="white", edgecolor=GREY))
    axes.text(2, 0.5, "hole", ha="center", va="center", fontsize=9)
    axes.plot([1, 1.2], [0.35, 0.65], color=RED, linewidth=2.5)
    axes.text(1.2, 0.4, "crack", color=RED, fontsize=9)
    clamp(axes, (0, 0), (0, 1), (-0.06, 0))
    axes.text(0.04, 0.5, "edge 4: held", color=BLUE, fontsize=9, va="center")
    axes.plot([3, 3], [0, 1], color=BLUE, linewidth=2.5)
    axes.text(2.96, 0.9, "edge 2", color=BLUE, fontsize=9, ha="right", va="center")
    for y in (0.15, 0.5, 0.85):
        axes.annotate("", (3.25, y), (3.02, y), arrowprops={"arrowstyle": "-|>", "color": ORANGE, "linewidth": 1.6})
    axes.text(3.3, 0.5, "1 MPa\nper unit", color=ORANGE, fontsize=9, va="center")
    dimension(axes, (0, -0.09), (3, -0.09), "3 m", at=(1.5, -0.11), ha="center", va="top")
    axes.set(xlim=(-0.1, 3.75), ylim=(-0.3, 1.05), aspect="equal")
    axes.axis("off")
    figure.savefig(folder / "body_scene.png", dpi=110, bbox_inches="tight", pad_inches=0.05)
    plt.close(figure)


def draw_coupling_scene(folder: pathlib.Path) -> None:
    """A host and the specimen that the library computes for it, with what they exchange."""
    figure, axes = plt.subplots(figsize=(7.6, 2.6), layout="constrained")
    for low, high, colour in ((0, 20, BODY), (20, 40, LATTICE), (40, 60, BODY)):
        axes.add_patch(plt.Rectangle((low, 0), high - low, 20, facecolor=colour, edgecolor=GREY))
    axes.plot([30.5, 30.5], [0, 10.5], color=RED, linewidth=2.5)
    axes.text(31.5, 3, "crack", color=RED, fontsize=9)
    clamp(axes, (0, 0), (0, 20), (-2, 0))
    axes.plot([60, 60], [0, 20], color=BLUE, linewidth=3)
    axes.text(59, 10, "edge that\nboth share", color=BLUE, fontsize=9, ha="right", va="center")
    spring = np.linspace(84, 104, 13)
    axes.plot([82, *spring, 106], [10, *(10 + 2.5 * np.array([0, *([1, -1] * 5), 1, 0])), 10], color="black", linewidth=1.2)
    clamp(axes, (106, 3), (106, 17), (2, 0))
    axes.text(94, 18, "machine: spring, crosshead", ha="center", fontsize=9)
    arrow(axes, (80, 14), (61, 14), "displacement", ORANGE, at=(70.5, 15), ha="center")
    arrow(axes, (61, 6), (80, 6), "force", BLUE, at=(70.5, 2.5), ha="center")
    axes.text(30, 22, "bempd: the specimen that cracks", ha="center", fontsize=9.5, weight="bold")
    axes.text(94, 22, "host: time, other bodies", ha="center", fontsize=9.5, weight="bold")
    axes.set(xlim=(-3, 112), ylim=(-1, 25), aspect="equal")
    axes.axis("off")
    figure.savefig(folder / "coupling_scene.png", dpi=120, bbox_inches="tight", pad_inches=0.05)
    plt.close(figure)


def write_bracket(file: pathlib.Path) -> None:
    """A drawing in millimetres: an L of two arms with a round inner corner and a hole; two edges lie on layers of their own."""
    import ezdxf

    drawing = ezdxf.new()
    drawing.header["$INSUNITS"] = 4
    space, quarter = drawing.modelspace(), np.tan(np.pi / 8)
    space.add_lwpolyline([(30, 100, 0), (30, 42, quarter), (42, 30, 0), (100, 30, 0)], format="xyb")
    space.add_line((100, 30), (100, 0), {"layer": "load"})
    space.add_lwpolyline([(100, 0), (0, 0), (0, 100)])
    space.add_line((0, 100), (30, 100), {"layer": "clamp"})
    space.add_circle((70, 15), 6)
    drawing.saveas(file)


def draw_import(folder: pathlib.Path) -> None:
    """The bracket of docs/import.md: edges by name, and the crack from its inner corner."""
    with tempfile.TemporaryDirectory() as place:
        file = pathlib.Path(place) / "bracket.dxf"
        write_bracket(file)
        bracket = bempd.outline.from_dxf(file)
    print(f"import: {bracket}")
    model = Model(options={"stepping.control": "path"})
    steel = model.add_material(young_modulus=2.1e11, poisson_ratio=0.3, thickness=0.01, fracture_energy=2e4)
    region = model.add_body(steel, bracket)
    corner = 0.042 - 0.012 * np.sqrt(0.5)
    crack = model.add_crack([(corner, corner), (corner - 0.004, corner - 0.004)])
    model.fix_edge(region, "clamp")
    model.prescribe_edge(region, "load", "y", -1e-6)
    with plt.rc_context(STYLE):
        figure, (described, grown) = plt.subplots(1, 2, figsize=(8, 3.8), layout="constrained", sharey=True)
        model.plot("outline", axes=described)
        for name, colour, text, at in (("clamp", BLUE, "clamp: held", (15, 104)), ("load", ORANGE, "load", (104, 15))):
            corners = {"clamp": [(0, 100), (30, 100)], "load": [(100, 30), (100, 0)]}[name]
            described.plot(*zip(*corners), color=colour, linewidth=4, solid_capstyle="butt")
            described.text(*at, text, color=colour, ha="center" if name == "clamp" else "left", va="center", fontsize=9)
        described.set_title("bracket.dxf: edges by the names of their layers", fontsize=9)
        model.step(1)
        start = model.tips()[0].critical_load_factor
        model.run_to_separation(1e5)
        model.plot("outline", axes=grown)
        grown.set_title(f"crack path; growth begins at {start / 1000:.2f} mm", fontsize=9)
        for axes in (described, grown):
            axes.set(xlim=(-6, 122), ylim=(-6, 112))
        figure.savefig(folder / "import_bracket.png", dpi=110)
        plt.close(figure)
    print(f"import: growth at {start:.0f} micrometres, path ends at {model.crack_path(crack)[-1].x:.3f}, {model.crack_path(crack)[-1].y:.3f}")


def draw_scenes(folder: pathlib.Path) -> None:
    draw_plate_scene(folder)
    draw_strip_scene(folder)
    draw_fatigue_scene(folder)
    draw_body_scene(folder)
    draw_coupling_scene(folder)
