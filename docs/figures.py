#!/usr/bin/env python3
"""Draws the figures of the pages first_path, tutorial, import, theory and coupling, most of them from runs of the library, and prints their
numbers.

    docs/figures.py [FOLDER] [NAME...]     (docs and all figures by default; NAME: scenes, import, layout, bonds, toughness, coupling)

The library is found as the Python package finds it (BEMPD_LIBRARY)."""

from __future__ import annotations

import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "bindings/python"))

from bempd import Model, rectangle  # noqa: E402
from scene_figures import BLUE, GREY, ORANGE, RED, STYLE, draw_import, draw_scenes  # noqa: E402

# Cracks of the figures grow bond by bond.
BONDS = {"crack.rule": "bond"}


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
        axes.text(3, 0.99, "Griffith", va="top")
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
        panels[0].legend(fontsize=8, loc="upper left", frameon=True, framealpha=1, edgecolor="none")
        figure.savefig(folder / "coupling_drive.png")
        plt.close(figure)


FIGURES = {"scenes": draw_scenes, "import": draw_import, "layout": print_layout, "bonds": draw_bonds, "toughness": draw_toughness, "coupling": draw_coupling}

if __name__ == "__main__":
    target = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ROOT / "docs")
    for chosen in sys.argv[2:] or FIGURES:
        FIGURES[chosen](target)
