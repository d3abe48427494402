"""Pictures of fracture runs from the files that bempd_write_snapshot() and bempd_write_history() leave.

Expected in one folder:
    NAME.pvd                  series of snapshots; the time of a snapshot is its load factor
    NAME_NNNN_lattice.vtu     quads with point data "displacement" and "damage"
    NAME_NNNN_boundary.vtu    quadratic edges with point data "displacement" and cell data "region"
    history_NAME.csv          columns "load_factor", "total_broken_bonds", "reaction_x_1", "reaction_y_1", ...
Lengths are in metres, forces in newtons. Needs numpy, matplotlib and meshio.
"""

import csv
import dataclasses
import itertools
import pathlib
import xml.etree.ElementTree as xml

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import meshio
import numpy as np
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.patches import PathPatch
from matplotlib.path import Path

STYLE = {
    "font.family": "DejaVu Sans",
    "font.size": 9,
    "axes.titlesize": 9.5,
    "axes.labelsize": 9,
    "axes.linewidth": 0.7,
    "xtick.direction": "in",
    "ytick.direction": "in",
    "xtick.labelsize": 8,
    "ytick.labelsize": 8,
    "legend.frameon": False,
}
BODY_FACE, BODY_EDGE, CURVE, MARK = "#e3e5e8", "#7d838c", "#1f4e79", "#b3261e"
DAMAGE_COLOURS = "YlOrRd"


@dataclasses.dataclass
class Snapshot:
    """The files of one load factor; meshes are read when asked for."""

    load_factor: float
    files: dict  # part ("lattice", "boundary") -> path

    def mesh(self, part):
        if part not in self.files:
            return None
        try:
            return meshio.read(self.files[part])
        except IndexError:  # what meshio makes of a file without cells, such as that of cracks while there are none
            return None

    def damage(self):
        mesh = self.mesh("lattice")
        return np.zeros(0) if mesh is None else mesh.point_data["damage"]


def read_series(collection):
    """Snapshots of a .pvd file in the order in which they were written."""
    collection = pathlib.Path(collection)
    snapshots = {}
    for entry in xml.parse(collection).getroot().iter("DataSet"):
        # NAME_NNNN_part.vtu: several snapshots of a cascade share one load factor, so the number tells them apart.
        stem, part = pathlib.Path(entry.get("file")).stem.rsplit("_", 1)
        snapshot = snapshots.setdefault(stem, Snapshot(float(entry.get("timestep")), {}))
        snapshot.files[part] = collection.parent / entry.get("file")
    return list(snapshots.values())


def read_history(table):
    """Columns of a .csv file as arrays."""
    with open(table, newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    if not rows:
        raise SystemExit(f"{table} has no rows")
    return {name: np.array([float(row[name]) for row in rows]) for name in rows[0]}


@dataclasses.dataclass
class Stage:
    title: str
    snapshot: Snapshot


def crack_stages(snapshots, end_title="End of growth", first_break=None):
    """First damage, half of the final damage, and the end of growth; fewer if these coincide.

    first_break: load factor of the first break, where known; else the first snapshot with more damage than the first.
    """
    if not snapshots:
        return []
    total = np.array([snapshot.damage().sum() for snapshot in snapshots])
    grown = total - total[0]
    if grown[-1] <= 0:
        return [Stage("No damage", snapshots[-1])]
    first = int(np.argmax(grown > 0))
    if first_break is not None:
        first = int(np.argmax([snapshot.load_factor >= first_break * (1 - 1e-9) for snapshot in snapshots]))
    last = int(np.argmax(grown >= grown[-1] * (1 - 1e-9)))
    half = first + int(np.argmin(np.abs(grown[first : last + 1] - 0.5 * (grown[first] + grown[last]))))
    titles = {}
    for index, title in ((half, "Half way"), (first, "First damage"), (last, end_title)):
        titles[index] = title
    return [Stage(titles[index], snapshots[index]) for index in sorted(titles)]


def round_magnification(snapshots, share=0.04):
    """1, 2 or 5 times a power of ten that shows all but the largest displacements as `share` of the body's size."""
    size, displacements = 0.0, [np.zeros(1)]
    for snapshot, part in itertools.product(snapshots, ("lattice", "boundary")):
        mesh = snapshot.mesh(part)
        if mesh is not None and len(mesh.points):
            size = max(size, np.linalg.norm(np.ptp(mesh.points, axis=0)))
            displacements.append(np.linalg.norm(mesh.point_data["displacement"], axis=1))
    # A loose fragment may fly far; it must not set the scale.
    typical = np.quantile(np.concatenate(displacements), 0.98)
    if not typical > 0 or not size > 0:
        return 1.0
    wanted = share * size / typical
    power = 10.0 ** np.floor(np.log10(wanted))
    return float(power * max(step for step in (1, 2, 5) if step * power <= wanted * (1 + 1e-9)))


def cut_cells(points, displacement, quads, critical_stretch):
    """Cells with a side or diagonal stretched beyond the critical stretch: the crack runs through them."""
    cut = np.zeros(len(quads), dtype=bool)
    for i, j in itertools.combinations(range(4), 2):
        before = (points[quads[:, j]] - points[quads[:, i]])[:, :2]
        after = before + (displacement[quads[:, j]] - displacement[quads[:, i]])[:, :2]
        length = np.linalg.norm(before, axis=1)
        cut |= np.linalg.norm(after, axis=1) > (1 + critical_stretch) * length
    return cut


def free_sides(quads):
    """Point pairs of the sides that belong to one cell only: the outline with the lips of the crack."""
    sides = np.sort(np.concatenate([quads[:, [k, (k + 1) % 4]] for k in range(4)]), axis=1)
    unique, count = np.unique(sides, axis=0, return_counts=True)
    return unique[count == 1]


def boundary_loops(mesh, magnification):
    """(region, corner points of the deformed closed loop) for every loop of the boundary elements."""
    shown = (mesh.points + magnification * mesh.point_data["displacement"])[:, :2]
    t = np.linspace(0, 1, 5)[:-1, None]
    loops, previous = [], None
    regions = mesh.cell_data.get("region", [np.zeros(len(block.data), int) for block in mesh.cells])
    for block, block_regions in zip(mesh.cells, regions):
        if block.type != "line3":
            continue
        for (start, end, middle), region in zip(block.data, block_regions):
            if start != previous:
                loops.append((int(region), []))
            arc = (1 - t) * (1 - 2 * t) * shown[start] + 4 * t * (1 - t) * shown[middle] + t * (2 * t - 1) * shown[end]
            loops[-1][1].append(arc)
            previous = end
    return [(region, np.concatenate(arcs)) for region, arcs in loops]


def draw_boundary(axes, mesh, magnification, length_unit):
    """Boundary-element regions as grey bodies in their deformed shape."""
    loops = boundary_loops(mesh, magnification)
    for region in sorted({region for region, _ in loops}):
        vertices, codes = [], []
        for corners in (corners for number, corners in loops if number == region):
            vertices.append(np.vstack([corners, corners[:1]]) / length_unit)
            codes += [Path.MOVETO] + [Path.LINETO] * (len(corners) - 1) + [Path.CLOSEPOLY]
        path = Path(np.vstack(vertices), codes)
        axes.add_patch(PathPatch(path, facecolor=BODY_FACE, edgecolor=BODY_EDGE, linewidth=0.8, zorder=1))
        axes.update_datalim(path.vertices)


def draw_damage(axes, mesh, magnification, length_unit, critical_stretch, largest_damage):
    """Cells of the lattice in their deformed shape, coloured by damage; those that the crack cuts are left out."""
    quads = mesh.cells_dict["quad"]
    displacement = mesh.point_data["displacement"]
    if critical_stretch is not None:
        quads = quads[~cut_cells(mesh.points, displacement, quads, critical_stretch)]
    shown = (mesh.points + magnification * displacement)[:, :2] / length_unit
    cells = PolyCollection(shown[quads], cmap=DAMAGE_COLOURS, edgecolors="face", linewidths=0.15, zorder=2)
    cells.set_array(mesh.point_data["damage"][quads].mean(axis=1))
    cells.set_clim(0, largest_damage)
    cells.set_rasterized(True)
    axes.add_collection(cells)
    axes.add_collection(LineCollection(shown[free_sides(quads)], colors=BODY_EDGE, linewidths=0.5, zorder=3))
    return cells


def draw_stage(axes, snapshot, magnification, length_unit, critical_stretch, largest_damage):
    """One deformed body; returns what a colour bar needs, or None without a lattice."""
    boundary, lattice = snapshot.mesh("boundary"), snapshot.mesh("lattice")
    cells = None
    if boundary is not None:
        draw_boundary(axes, boundary, magnification, length_unit)
    if lattice is not None:
        cells = draw_damage(axes, lattice, magnification, length_unit, critical_stretch, largest_damage)
    axes.set_aspect("equal")
    axes.autoscale_view()
    axes.margins(0.04)
    return cells


def engineering(largest, unit):
    """(factor, unit with prefix) that bring the numbers between 1 and 1000."""
    prefixes = {-9: "n", -6: "\u00b5", -3: "m", 0: "", 3: "k", 6: "M", 9: "G"}
    exponent = 0 if not largest > 0 else int(np.clip(3 * np.floor(np.log10(largest) / 3 + 1e-12), -9, 9))
    return 10.0**-exponent, prefixes[exponent] + unit


def growth_rows(history):
    """Rows of the first break and of the last one, or None if nothing broke."""
    broken = history["total_broken_bonds"]
    if not broken[-1] > 0:
        return None
    return int(np.argmax(broken > 0)), int(np.argmax(broken >= broken[-1]))


def is_separated(history, reaction):
    load = np.abs(history[reaction])
    return bool(load[-1] < 0.01 * load.max())


def load_curve(history, reaction):
    """Load factors and forces from zero through all rows, each event with the state just before it, where its bonds just
    reach what they bear; and which points are before and after the event of each row."""
    before = history.get(reaction.replace("reaction_", "reaction_before_", 1))
    points, rows = [(0.0, 0.0)], []
    for row, (load_factor, force) in enumerate(zip(history["load_factor"], history[reaction])):
        if before is not None and history["event"][row] > 0:
            (start, force_there), critical = points[-1], history["critical_load_factor"][row]
            in_balance = history["stretch_ratio"][row] <= 1 + 1e-9
            share = 1.0 if in_balance else (critical - start) / (load_factor - start) if load_factor != start else 0.0
            if 0 < share <= 1:
                points.append((start + share * (load_factor - start), force_there + share * (before[row] - force_there)))
        points.append((load_factor, force))
        rows.append((len(points) - 2 if before is not None and history["event"][row] > 0 else len(points) - 1, len(points) - 1))
    load_factors, forces = np.array(points).T
    return load_factors, forces, rows


def draw_load_displacement(axes, history, reaction, displacement, displacement_label):
    """Reaction of a plate of 1 m thickness against imposed displacement, with the first break and the end of growth."""
    load_factors, load, points = load_curve(history, reaction)
    imposed = displacement * load_factors
    load = load * np.sign(load[np.argmax(np.abs(load))])
    to_length, length_unit = engineering(np.abs(imposed).max(), "m")
    to_force, force_unit = engineering(np.abs(load).max(), "N/m")
    x, y = imposed * to_length, load * to_force
    axes.plot(x, y, color=CURVE, linewidth=1.3, zorder=2)
    rows = growth_rows(history)
    if rows:
        end = "complete" if is_separated(history, reaction) else "end of growth"
        for point, text, marker in ((points[rows[0]][0], "first break", "o"), (points[rows[1]][1], end, "s")):
            at = (x[point], y[point])
            axes.plot(*at, marker, color=MARK, markersize=5, zorder=3, clip_on=False,
                      label=f"{text}: {at[0]:.3g} {length_unit}, {0 if at[1] < 1e-6 * y.max() else at[1]:.3g} {force_unit}")
        axes.legend(loc="upper left", handletextpad=0.3, borderaxespad=0.3)
    axes.set_xlabel(f"{displacement_label} [{length_unit}]")
    axes.set_ylabel(f"reaction per thickness [{force_unit}]")
    axes.set_xlim(left=0)
    axes.set_ylim(bottom=min(0, y.min() * 1.05), top=y.max() * 1.25)
    axes.grid(color="#dddddd", linewidth=0.5)
    axes.set_axisbelow(True)


def draw_broken_bonds(axes, history, load, load_label, load_unit):
    """Broken bonds against the load, with the first break and the end of growth: under dead loads it shows where growth
    becomes unstable."""
    acting = load * history["load_factor"]
    factor, unit = engineering(np.abs(acting).max(), load_unit)
    broken = history["total_broken_bonds"]
    axes.plot(np.append(0, acting) * factor, np.append(0, broken), color=CURVE, linewidth=1.3, zorder=2)
    rows = growth_rows(history)
    for row, text, marker in zip(rows or (), ("first break", "end of growth"), "os"):
        axes.plot(acting[row] * factor, broken[row], marker, color=MARK, markersize=5, zorder=3, clip_on=False,
                  label=f"{text}: {acting[row] * factor:.3g} {unit}")
    axes.legend(loc="upper left", handletextpad=0.3, borderaxespad=0.3)
    axes.set_xlabel(f"{load_label} [{unit}]")
    axes.set_ylabel("broken bonds")
    axes.set_xlim(left=0)
    axes.set_ylim(bottom=0, top=broken.max() * 1.25)
    axes.grid(color="#dddddd", linewidth=0.5)
    axes.set_axisbelow(True)


def stage_titles(stages, loads, unit):
    """Each with its load; a load that is that of the stage before, as where growth is unstable, is not told twice."""
    titles, before = [], None
    for stage, load in zip(stages, loads):
        shown = f"{load:.3g} {unit}"
        titles.append(f"{stage.title}, same load" if shown == before else f"{stage.title}, {shown}")
        before = shown
    return titles


def fracture_figure(folder, name, *, load, load_label, load_unit="m", reaction=None, critical_stretch=None,
                    magnification=None, end_title=None, length_unit=1e-3, length_name="mm"):
    """Stages of the crack beside the load curve, written to FOLDER/NAME.png.

    load: imposed displacement [m], or traction [Pa] with load_unit="Pa", per unit of load factor;
    reaction: column of the history to show over it; None shows the broken bonds.
    """
    folder = pathlib.Path(folder)
    history = read_history(folder / f"history_{name}.csv")
    end_title = end_title or ("Complete" if reaction and is_separated(history, reaction) else "End of growth")
    rows = growth_rows(history)
    first_break = history["load_factor"][rows[0]] if rows else None
    stages = crack_stages(read_series(folder / f"{name}.pvd"), end_title, first_break)
    if not stages:
        raise SystemExit(f"{folder / name}.pvd lists no snapshots")
    if magnification is None:
        magnification = round_magnification([stage.snapshot for stage in stages])
    damage = max(stage.snapshot.damage().max(initial=0) for stage in stages)
    largest_damage = max(0.1, np.ceil(10 * damage - 1e-9) / 10)
    to_load, unit = engineering(load * max(stage.snapshot.load_factor for stage in stages), load_unit)
    with plt.rc_context(STYLE):
        figure = plt.figure(figsize=(2.35 * len(stages) + 4.6, 3.1), layout="constrained")
        left, right = figure.subfigures(1, 2, width_ratios=[2.35 * len(stages) + 0.8, 3.8])
        panels = left.subplots(1, len(stages), sharex=True, sharey=True, squeeze=False)[0]
        titles = stage_titles(stages, [load * stage.snapshot.load_factor * to_load for stage in stages], unit)
        for axes, stage, title in zip(panels, stages, titles):
            cells = draw_stage(axes, stage.snapshot, magnification, length_unit, critical_stretch, largest_damage)
            axes.set_title(title)
            axes.set_xlabel(f"x [{length_name}]")
        panels[0].set_ylabel(f"y [{length_name}]")
        if cells is not None:
            left.colorbar(cells, ax=panels, shrink=0.72, pad=0.015, label="damage [-]")
        shape = f"displacements magnified {magnification:g} times" if magnification > 0 else "undeformed shape"
        left.supxlabel(shape, fontsize=8, color="#444444")
        axes = right.subplots()
        if reaction:
            draw_load_displacement(axes, history, reaction, load, load_label)
            axes.set_title("Load and displacement")
        else:
            draw_broken_bonds(axes, history, load, load_label, load_unit)
            axes.set_title("Load and growth")
        target = folder / f"{name}.png"
        figure.savefig(target, dpi=200)
        plt.close(figure)
    return target


def first_break_snapshot(folder, run):
    """The snapshot at which bonds have just begun to break, or None; runs write theirs after the first event."""
    collection = pathlib.Path(folder) / f"{run}.pvd"
    snapshots = read_series(collection) if collection.exists() else []
    return snapshots[0] if snapshots else None


def written_runs(folder):
    """Names of the runs whose histories lie in the folder."""
    return sorted(table.stem.removeprefix("history_") for table in pathlib.Path(folder).glob("history_*.csv"))
