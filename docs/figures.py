#!/usr/bin/env python3
"""Draws the figures of the pages first_path, tutorial, import, theory and coupling, most of them from runs of the library, and prints their
numbers.

    docs/figures.py [FOLDER] [NAME...]     (docs and all figures by default; NAME: scenes, import, layout, bonds, toughness, coupling)

The library is found as the Python package finds it (BEMPD_LIBRARY)."""

from __future__ import annotations

import pathlib
import sys
import tempfile

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "bindings/python"))

import bempd  # noqa: E402
from bempd import Model, rectangle  # noqa: E402

# Cracks of the figures grow bond by bond.
BONDS = {"crack.rule": "bond"}
BLUE, RED, ORANGE, GREY = "#1f4e79", "#b3261e", "#c05a00", "#7d838c"
STYLE = {"font.size": 10, "axes.linewidth": 0.7, "xtick.direction": "in", "ytick.direction": "in", "legend.frameon": False,
         "figure.dpi": 100, "savefig.dpi": 160, "axes.grid": True, "grid.color": "#dddddd", "grid.linewidth": 0.5,
         "axes.axisbelow": True}


# --------------------------------------------------------------------------- Scenes of the tutorials

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
    figure.savefig(folder / "first_path_scene.png", dpi=120)
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
    for x, text in ((10, "left: boundary elements"), (30, "middle: lattice"), (50, "right: boundary elements")):
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
    figure.savefig(folder / "tutorial_scene.png", dpi=110)
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
    figure.savefig(folder / "coupling_scene.png", dpi=120)
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
    region = model.add_bem_region(steel, bracket, element_length=0.015)
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
    draw_coupling_scene(folder)


# --------------------------------------------------------------------------- Theory: bonds

def draw_bonds(folder: pathlib.Path) -> None:
    """The bonds of three points, as thick as they are stiff."""
    model = Model()
    material = model.add_material(young_modulus=1, poisson_ratio=1 / 3, fracture_energy=1)
    lattice = model.add_pd_region(material, rectangle(0, 0, 26, 12), spacing=1, horizon_ratio=4)
    crack = np.array([(19.5, 12.0), (19.5, 5.5)])
    model.add_crack(crack)
    model.fix_edge(lattice, 1)
    model.prepare()
    points, bonds = model.field(lattice, "position"), model.bonds(lattice)
    figure, axes = plt.subplots(figsize=(7.5, 5.0), layout="constrained")
    axes.plot(*points.T, ".", color=GREY, markersize=3, zorder=2)
    for place, colour, text in (((5, 6), BLUE, "inside"), ((13, 0), ORANGE, "at a face"), ((21, 7), RED, "beside a crack")):
        centre = int(np.argmin(np.hypot(*(points - place).T)))
        own = (bonds.points == centre).any(axis=1)
        for state, style, width in ((0, "-", 1.4), (2, ":", 0.8)):
            lines = points[bonds.points[own & (bonds.states == state)]]
            axes.add_collection(LineCollection(list(lines), colors=colour, linewidths=width, linestyles=style, zorder=3))
        axes.plot(*points[centre], "o", color=colour, markersize=7, zorder=4)
        circle = plt.Circle(place, 4, fill=False, color=colour, linewidth=0.8, linestyle="--", clip_on=True)
        axes.add_patch(circle)
        axes.annotate(f"{text}: {int((own & (bonds.states == 0)).sum())} bonds", place, (place[0], -5.2), color=colour,
                      ha="center", annotation_clip=False)
        print(f"bonds of a point {text}: {int((own & (bonds.states == 0)).sum())} left of {int(own.sum())}")
    axes.plot(*crack.T, color="black", linewidth=2.5, zorder=5)
    axes.add_patch(plt.Rectangle((0, 0), 26, 12, fill=False, color="black", linewidth=1))
    axes.set(xlim=(-0.6, 26.6), ylim=(-5.6, 12.6), aspect="equal")
    axes.axis("off")
    figure.savefig(folder / "theory_bonds.png")
    plt.close(figure)


# --------------------------------------------------------------------------- Theory: toughness of the lattice

def centre_cracked(horizon_ratio: int, shift: float = 0.0) -> Model:
    """A crack of 80 spacings in a plate of boundary elements ten times as wide, in a lattice; stress 1 a load factor."""
    model = Model(options=BONDS)
    material = model.add_material(young_modulus=1, poisson_ratio=1 / 3, fracture_energy=1)
    half, margin = 40, 3 * horizon_ratio
    right, top = half + margin + 20, margin + 8
    low, high, far = rectangle(-400, -400, 400, -top), rectangle(-400, top, 400, 400), 20.0
    model.add_bem_region(material, low, element_length=far)
    upper = model.add_bem_region(material, high, element_length=far)
    model.add_bem_region(material, rectangle(-400, -top, -right, top), element_length=far)
    model.add_bem_region(material, rectangle(right, -top, 400, top), element_length=far)
    model.add_pd_region(material, rectangle(-right, -top, right, top), spacing=1, horizon_ratio=horizon_ratio)
    model.add_crack([(-half - 0.5 + shift, 0.5), (half + 0.5 - shift, 0.5)])
    for region in (1, upper):
        model.add_traction(region, 1 if region == 1 else 3, "y", -1.0 if region == 1 else 1.0)
    model.fix_point((-400, -400), "x")
    model.fix_point((-400, -400), "y")
    model.fix_point((400, -400), "y")
    return model


def draw_toughness(folder: pathlib.Path) -> None:
    """First break and largest load of growth on the path, over Griffith's load of the crack as long as it then is."""
    ratios, first, largest = [3, 4, 5, 6], [], []
    for ratio in ratios:
        model = centre_cracked(ratio)
        model.options["stepping.control"] = "path"
        report = model.step_to_next_event(1e6)
        first.append(report.load_factor * np.sqrt(np.pi * 40.5))
        while report.total_broken_bonds < 14 * ratio * ratio:
            report = model.step_to_next_event(1e6)
        history = model.history()
        loads = history["critical_load_factor"][history["event"] > 0]
        largest.append(loads.max() * np.sqrt(np.pi * 40.5))
        print(f"horizon ratio {ratio}: first break at {first[-1]:.3f}, largest load {largest[-1]:.3f} of Griffith's")
    with plt.rc_context(STYLE):
        figure, axes = plt.subplots(figsize=(5.6, 3.6), layout="constrained")
        axes.plot(ratios, first, "o-", color=BLUE, label="first break")
        axes.plot(ratios, largest, "s-", color=ORANGE, label="largest load of growth")
        axes.axhline(1, color="black", linewidth=0.8)
        axes.text(6, 1.01, "Griffith", ha="right")
        axes.set(xlabel="horizon over spacing", ylabel="load over Griffith's load", xticks=ratios, ylim=(0.8, 1.45))
        axes.legend()
        figure.savefig(folder / "theory_toughness.png")
        plt.close(figure)


# --------------------------------------------------------------------------- Tutorial: layout

def add_acrylic(model: Model) -> int:
    return model.add_material(young_modulus=3e9, poisson_ratio=1 / 3, thickness=0.005, fracture_energy=300)


def in_boundary_elements(tip: float) -> float:
    """Load factor at which the crack grows in a strip of boundary elements alone."""
    model = Model()
    body = model.add_bem_region(add_acrylic(model), rectangle(0, 0, 0.06, 0.02), element_length=0.002)
    model.add_crack([(0.0305, 0), (0.0305, tip)])
    model.fix_edge(body, 4)
    model.prescribe_edge(body, 2, "x", 1e-6)
    model.step(1)
    return model.tips()[0].critical_load_factor


def strip(options: dict[str, str], spacing: float = 0.001, tip: float = 0.0045, margin: float = 0.01) -> tuple[Model, int]:
    """The strip of the tutorial; the lattice reaches `margin` to both sides of the crack."""
    model = Model(options=options)
    acrylic = add_acrylic(model)
    low, high = 0.03 - margin, 0.03 + margin
    left = model.add_bem_region(acrylic, rectangle(0, 0, low, 0.02), element_length=0.005)
    model.add_pd_region(acrylic, rectangle(low, 0, high, 0.02), spacing=spacing, horizon_ratio=4)
    right = model.add_bem_region(acrylic, rectangle(high, 0, 0.06, 0.02), element_length=0.005)
    model.add_crack([(0.0305, 0), (0.0305, tip)])
    model.fix_edge(left, 4)
    return model, model.prescribe_edge(right, 2, "x", 1e-6)


def first_break(model: Model) -> float:
    return model.step_to_next_event(1e6).load_factor


def print_layout(_: pathlib.Path) -> None:
    """How the first break depends on where the lattice ends and on where the tip lies."""
    for name, options in (("as lines", {}), ("bond by bond", BONDS)):
        reference = first_break(strip(options, margin=0.024)[0])
        for horizons in (1, 2, 3):
            found = first_break(strip(options, margin=0.004 * horizons)[0])
            print(f"{name}, lattice {horizons} horizon(s) to either side: first break off by {found / reference - 1:+.1e}")
        between = first_break(strip(options)[0])
        for tip, text in ((0.004999, "just before a row"), (0.005001, "just behind a row")):
            off = first_break(strip(options, tip=tip)[0]) / between - 1
            print(f"{name}, tip {text} instead of half way between two: first break {off:+.1%}")
    longer = in_boundary_elements(0.005) / in_boundary_elements(0.0045) - 1
    print(f"boundary elements, crack half a spacing longer: {longer:+.1%}")


# --------------------------------------------------------------------------- Coupling

class Specimen:
    """A cracked strip that stands at an elongation [um]; trials start there."""

    def __init__(self, elongation: float) -> None:
        self.model, self.pulled = strip(BONDS, tip=0.0105)
        self.model.step(elongation)
        self.elongation, self.force = elongation, self.reaction()
        self.start = self.model.save()

    def reaction(self) -> float:
        return float(self.model.reaction(self.pulled)[0])

    def force_at(self, elongation: float) -> float:
        """What a host gets that gives the displacement."""
        self.model.restore(self.start)
        self.model.step(elongation)
        return self.reaction()

    def elongation_at(self, force: float) -> float:
        """What a host gets that gives the traction: the first elongation at which the specimen bears the force."""
        if force <= self.force:
            return self.elongation * force / self.force
        self.model.restore(self.start)
        for elongation in np.arange(self.elongation, 200, 0.25):
            if self.model.step(float(elongation)).separated:
                break
            if self.reaction() >= force:
                return float(elongation)
        return np.inf


def by_traction(specimen: Specimen, crosshead: float, stiffness: float) -> list[tuple[float, float]]:
    """Fixed point of a host that gives the traction, with the relaxation that is best for the elastic specimen."""
    relaxation = 1 / (1 + stiffness * specimen.elongation / specimen.force)
    force, found = specimen.force, []
    for _ in range(20):
        elongation = specimen.elongation_at(force)
        found.append((elongation, force))
        missing = stiffness * (crosshead - elongation) - force
        if not np.isfinite(elongation) or abs(missing) < 1:
            break
        force += relaxation * missing
    return found


def by_displacement(specimen: Specimen, crosshead: float, stiffness: float) -> list[tuple[float, float]]:
    """Bisection of a host that gives the displacement: the specimen's force falls short of the machine's, or exceeds it."""
    low, high, found = specimen.elongation, crosshead, []
    for _ in range(20):
        elongation = 0.5 * (low + high)
        force = specimen.force_at(elongation)
        found.append((elongation, force))
        if high - low < 0.05:
            break
        low, high = (elongation, high) if force < stiffness * (crosshead - elongation) else (low, elongation)
    return found


def draw_coupling(folder: pathlib.Path) -> None:
    curve = Specimen(1.0)
    elongations = np.arange(1.0, 150.0, 0.5)
    forces = []
    for elongation in elongations:
        curve.model.step(float(elongation))
        forces.append(curve.reaction())
    stiffness = 15.0  # N/um
    with plt.rc_context(STYLE):
        figure, panels = plt.subplots(1, 2, figsize=(9, 3.8), layout="constrained", sharey=True)
        for axes, start, ahead, title in zip(panels, (60.0, 126.0), (20.0, 3.0), ("before bonds break", "while bonds break")):
            specimen = Specimen(start)
            crosshead = start + specimen.force / stiffness + ahead
            traction, displacement = (way(specimen, crosshead, stiffness) for way in (by_traction, by_displacement))
            axes.plot(elongations, forces, color=GREY, linewidth=1.5, label="specimen, elongated steadily")
            axes.plot([start, crosshead], [stiffness * (crosshead - start), 0], color="black", linewidth=0.8, label="machine")
            axes.plot(start, specimen.force, "*", color="black", markersize=11, label="where the step begins")
            kept = np.array([pair for pair in traction if np.isfinite(pair[0])])
            axes.plot(*kept.T, "o", color=RED, markersize=6, fillstyle="none", label="trials, traction given")
            axes.plot(*np.array(displacement).T, "s", color=BLUE, markersize=4, label="trials, displacement given")
            torn = not np.isfinite(traction[-1][0])
            if torn:
                axes.annotate("", (150, traction[-1][1]), kept[-1], arrowprops={"arrowstyle": "->", "color": RED})
                axes.text(5, 350, "a little more force:\nno equilibrium ahead, torn in two", color=RED, va="top")
            axes.set(title=title, xlabel="elongation [\u00b5m]", ylim=(0, 400))
            print(f"{title}: by traction {len(traction)} trials, {'torn in two' if torn else 'converged'}; by displacement "
                  f"{len(displacement)} trials, {displacement[-1][0]:.2f} um, {displacement[-1][1]:.1f} N")
        panels[0].set_ylabel("force [N]")
        panels[0].legend(fontsize=8, loc="upper left")
        figure.savefig(folder / "coupling_drive.png")
        plt.close(figure)


FIGURES = {"scenes": draw_scenes, "import": draw_import, "layout": print_layout, "bonds": draw_bonds, "toughness": draw_toughness, "coupling": draw_coupling}

if __name__ == "__main__":
    target = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ROOT / "docs")
    for chosen in sys.argv[2:] or FIGURES:
        FIGURES[chosen](target)
