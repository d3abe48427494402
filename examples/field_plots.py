"""Pictures of displacement fields from the tables that the examples write.

Expected in one folder:
    line_CASE_SCHEME.csv      columns "x", "u1", "u2" along the centre line
    grid_NAME.csv             columns "x", "y", "u1", "u2" on a grid, row by row
and of runs with cracks the snapshots.
Lengths are in metres. Needs numpy and matplotlib.
"""

import pathlib

import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.ticker import MaxNLocator
from plotting import MARK, STYLE, engineering, plt, read_history

SCHEME_STYLE = {"symmetric": "-", "paper": "--"}
CASE_COLOURS = ["#1f4e79", "#c05a00", "#3a7d44", "#6a4c93", "#8a8a8a"]
FIELD_COLOURS = "viridis"


def read_line(table):
    return read_history(table)


def read_grid(table):
    """x and y of the columns and rows, and u1 and u2 as arrays [row][column]."""
    columns = read_history(table)
    x, y = np.unique(columns["x"]), np.unique(columns["y"])
    shape = (len(y), len(x))
    if columns["x"].size != x.size * y.size:
        raise SystemExit(f"{table} is not a grid")
    return {"x": x, "y": y, "u1": columns["u1"].reshape(shape), "u2": columns["u2"].reshape(shape)}


def written_lines(folder):
    """(case, scheme, columns) of every line in the folder, the symmetric scheme first."""
    lines = []
    for table in pathlib.Path(folder).glob("line_*.csv"):
        case, scheme = table.stem.removeprefix("line_").rsplit("_", 1)
        lines.append((case, scheme, read_line(table)))
    return sorted(lines, key=lambda line: (line[1] != "symmetric", line[0]))


def draw_lines(axes, lines, component, factor):
    cases = sorted({case for case, _, _ in lines})
    for case, scheme, columns in lines:
        axes.plot(columns["x"], factor * columns[component], SCHEME_STYLE.get(scheme, ":"),
                  color=CASE_COLOURS[cases.index(case) % len(CASE_COLOURS)], linewidth=1.1, label=f"case {case}, {scheme}")


def line_figure(folder, name, component, references):
    """Displacement along the centre line and its difference from the first reference, written to FOLDER/NAME.png.

    references: label -> function of x.
    """
    folder = pathlib.Path(folder)
    lines = written_lines(folder)
    if not lines:
        raise SystemExit(f"{folder} has no line_*.csv; run the example first")
    x = np.linspace(0, lines[0][2]["x"].max(), 201)
    label, reference = next(iter(references.items()))
    scale = np.abs(reference(x)).max()
    factor, unit = engineering(scale, "m")
    with plt.rc_context(STYLE):
        figure, (left, right, key) = plt.subplots(1, 3, figsize=(9.5, 3.4), layout="constrained",
                                                  gridspec_kw={"width_ratios": [1, 1, 0.38]})
        draw_lines(left, lines, component, factor)
        for (text, function), dashes in zip(references.items(), ((1, 1), (4, 1.5, 1, 1.5))):
            left.plot(x, factor * function(x), color=MARK, linewidth=1.0, dashes=dashes, label=text)
        left.set_ylabel(f"{component} [{unit}]")
        left.set_title(f"{component} along the centre line")
        differences = [(case, scheme, {"x": columns["x"], component: columns[component] - reference(columns["x"])})
                       for case, scheme, columns in lines]
        draw_lines(right, differences, component, 100 / scale)
        right.axhline(0, color=MARK, linewidth=0.8)
        right.set_ylabel(f"difference over largest {component} [%]")
        right.set_title(f"Difference from {label}")
        for axes in (left, right):
            axes.set_xlabel("x [m]")
            axes.grid(color="#dddddd", linewidth=0.5)
            axes.set_axisbelow(True)
        handles, labels = left.get_legend_handles_labels()
        key.legend(handles, labels, loc="center left", fontsize=7.5, borderaxespad=0)
        key.axis("off")
        target = folder / f"{name}.png"
        figure.savefig(target, dpi=200)
        plt.close(figure)
    return target


def add_bar(axes, mapped, label):
    """A colour bar as high as the axes, so that panels of a row are of one height."""
    place = axes.inset_axes([1.03, 0, 0.03, 1])
    bar = axes.figure.colorbar(mapped, cax=place, label=label, ticks=MaxNLocator(5))
    bar.outline.set_linewidth(0.5)


def triangles_of(mesh):
    """Cells of a lattice or of an inside as triangles."""
    halves = [mesh.cells_dict["quad"][:, corners] for corners in ([0, 1, 2], [0, 2, 3])] if "quad" in mesh.cells_dict else []
    return np.concatenate([*halves, *([mesh.cells_dict["triangle"]] if "triangle" in mesh.cells_dict else [])])


def draw_cracked(axes, snapshot, component, length_unit):
    """Contours that end at cracks: cells are split there, and those of the two sides have no point in common."""
    meshes = [snapshot.mesh(part) for part in ("inside", "lattice") if part in snapshot.files]
    values = [mesh.point_data["displacement"][:, component] for mesh in meshes]
    factor, unit = engineering(max(np.abs(of_part).max() for of_part in values), "m")
    low, high = (factor * edge(edge(of_part) for of_part in values) for edge in (min, max))
    levels = MaxNLocator(14).tick_values(low, high)
    for mesh, of_part in zip(meshes, values):
        x, y = mesh.points[:, 0] / length_unit, mesh.points[:, 1] / length_unit
        filled = axes.tricontourf(x, y, triangles_of(mesh), factor * of_part, levels=levels, cmap=FIELD_COLOURS)
        axes.tricontour(x, y, triangles_of(mesh), factor * of_part, levels=levels, colors="white", linewidths=0.3)
    cracks = snapshot.mesh("cracks")
    if cracks is not None and "line3" in cracks.cells_dict:
        lines = cracks.points[cracks.cells_dict["line3"][:, :2], :2] / length_unit
        axes.add_collection(LineCollection(list(lines), colors="black", linewidths=1.2, capstyle="round"))
    axes.set_aspect("equal")
    return filled, f"u{component + 1} [{unit}]"


def cracked_figure(folder, name, panels, *, length_unit=1.0, length_name="m"):
    """u1 and u2 of every panel (title, snapshot), a row each, written to FOLDER/NAME.png."""
    panels = [(title, snapshot) for title, snapshot in panels if snapshot is not None]
    if not panels:
        return None
    with plt.rc_context(STYLE):
        figure, rows = plt.subplots(len(panels), 2, figsize=(9, 3.9 * len(panels)), squeeze=False, layout="constrained",
                                    sharex=True, sharey=True)
        for (title, snapshot), row in zip(panels, rows):
            for component, axes in enumerate(row):
                add_bar(axes, *draw_cracked(axes, snapshot, component, length_unit))
                axes.set_title(title)
            row[0].set_ylabel(f"y [{length_name}]")
        for axes in rows[-1]:
            axes.set_xlabel(f"x [{length_name}]")
        target = pathlib.Path(folder) / f"{name}.png"
        figure.savefig(target, dpi=160)
        plt.close(figure)
    return target


def draw_contours(axes, grid, component, length_unit):
    factor, unit = engineering(np.abs(grid[component]).max(), "m")
    values = factor * grid[component]
    x, y = grid["x"] / length_unit, grid["y"] / length_unit
    filled = axes.contourf(x, y, values, levels=14, cmap=FIELD_COLOURS)
    axes.contour(x, y, values, levels=filled.levels, colors="white", linewidths=0.3)
    axes.set_aspect("equal")
    return filled, f"{component} [{unit}]"


def contour_figure(folder, name, panels, *, length_unit=1.0, length_name="m"):
    """u1 and u2 of every panel (title, NAME of the grid), a row each, written to FOLDER/NAME.png; those that were not
    run are left out."""
    folder = pathlib.Path(folder)
    found = [(title, folder / f"grid_{grid}.csv") for title, grid in panels]
    found = [(title, read_grid(table)) for title, table in found if table.exists()]
    if not found:
        return None
    first = found[0][1]
    height = 0.45 + 4.0 * np.ptp(first["y"]) / np.ptp(first["x"])
    with plt.rc_context(STYLE):
        figure, rows = plt.subplots(len(found), 2, figsize=(10, height * len(found) + 0.3), squeeze=False,
                                    layout="constrained", sharex=True, sharey=True)
        for (title, grid), row in zip(found, rows):
            for axes, component in zip(row, ("u1", "u2")):
                filled, label = draw_contours(axes, grid, component, length_unit)
                add_bar(axes, filled, label)
                axes.set_title(title)
            row[0].set_ylabel(f"y [{length_name}]")
        for axes in rows[-1]:
            axes.set_xlabel(f"x [{length_name}]")
        target = folder / f"{name}.png"
        figure.savefig(target, dpi=160)
        plt.close(figure)
    return target
