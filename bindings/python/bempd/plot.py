"""Pictures of models with matplotlib, which only this module needs.

Labels assume SI units. Figures are matplotlib's: change or save them as you like.

>>> import bempd, bempd.plot, matplotlib
>>> matplotlib.use("Agg")
>>> model = bempd.Model()
>>> glass = model.add_material(young_modulus=3e9, poisson_ratio=1 / 3)
>>> plate = model.add_bem_region(glass, bempd.rectangle(0, 0, 0.2, 0.1), element_length=0.025)
>>> support = model.fix_edge(plate, 4)
>>> load = model.add_traction(plate, 2, "y", 1e5)
>>> report = model.step(1)
>>> axes = bempd.plot.draw(model, "stress xx", magnification=20)
>>> axes.get_title()
'Stress xx, load factor 1, displacements x 20'
"""

from __future__ import annotations

import os
import pathlib
import shutil
import subprocess
import tempfile
from typing import Any, Literal, Optional, Union

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from PIL import Image

from . import _arguments as arguments
from ._bodies import Body, Drawable, bodies
from ._drawing import COLOURS, CURVE, MARK, QUANTITIES, SHORT, Limits, colour_scale, draw_cracks, engineering, paint
from ._drawing import add_colour_bar, round_magnification
from ._names import Component, Quantity
from ._results import read_history
from .errors import ArgumentError, FileError, OrderError

STYLE = {
    "font.size": 9,
    "axes.titlesize": 9.5,
    "axes.labelsize": 9,
    "axes.linewidth": 0.7,
    "xtick.direction": "in",
    "ytick.direction": "in",
    "xtick.labelsize": 8,
    "ytick.labelsize": 8,
    "legend.frameon": False,
    "figure.dpi": 120,
    "savefig.dpi": 200,
}
Magnification = Union[float, Literal["auto"]]


def chosen_quantity(name: str, quantity: Any) -> Any:
    """A quantity by its name or a short word for it, in capitals or not, with spaces or underscores."""
    if isinstance(quantity, str):
        plain = {name.lower(): full for name, full in [*((each, each) for each in QUANTITIES), *SHORT.items()]}
        quantity = plain.get(quantity.lower().replace("_", " "), quantity)
    arguments.choice(f"{name}: quantity", quantity, dict.fromkeys(QUANTITIES))
    return quantity


def draw(model: Drawable, quantity: Quantity = "damage", *, axes: Any = None, magnification: Magnification = 0.0,
         limits: Optional[Limits] = None, cracks: bool = True, colour_bar: bool = True, resolution: int = 20) -> Any:
    """Draw the body at the present load factor; returns matplotlib's axes.

    quantity       "outline", "lattice" (cells and nodes), "damage", "displacement" (magnitude), "displacement x" and
                   "y", "stress xx", "yy", "xy", "principal" (largest in the plane), "smallest principal", "shear" (largest in
                   the plane), "von Mises" (with the stress across the plane in plane strain); "stress" may be left out.
    axes           where to draw; a figure of its own if not given.
    magnification  of the displacements in the deformed shape; 0 for the undeformed one, "auto" for a round number.
    limits         of the colours, in SI units; else from the values, without the outermost percent of stresses.
    cracks         whether to draw lines along broken bonds, in the undeformed shape.
    resolution     places across a boundary-element region at which its interior is evaluated.
    """
    quantity = chosen_quantity("draw", quantity)
    if arguments.whole("draw: resolution", resolution) < 1:
        raise ArgumentError(f"draw: resolution is {resolution}; it must be at least 1")
    found = bodies(model, resolution)
    if not found:
        raise OrderError("draw: the scene has no region; add one first")
    if axes is None:
        with plt.rc_context(STYLE):
            axes = plt.subplots(figsize=figure_size(found, quantity), layout="constrained")[1]
    return draw_bodies(found, model.load_factor, quantity, axes, magnification=magnification, limits=limits, cracks=cracks,
                       colour_bar=colour_bar)[0]


def draw_bodies(found: list[Body], load_factor: float, quantity: Quantity, axes: Any, *, magnification: Magnification = 0.0,
                limits: Optional[Limits] = None, cracks: bool = True, colour_bar: bool = True) -> tuple[Any, float]:
    """As draw(), of bodies whose values are known; also the factor from metres to the axes' unit."""
    if magnification == "auto":
        magnification = round_magnification(found)
    magnification = arguments.real("draw: magnification", magnification)
    factor, unit = engineering(max(float(np.abs(body.points).max()) for body in found), "m")
    colours = colour_scale(found, quantity, limits)
    mapped = paint(axes, found, colours, magnification, factor, mesh=quantity == "lattice")
    if cracks and magnification == 0:
        draw_cracks(axes, found, factor, "black" if colours else MARK)
    axes.set_aspect("equal")
    axes.use_sticky_edges = False
    axes.autoscale_view()
    axes.margins(0.04)
    axes.set_xlabel(f"x [{unit}]")
    axes.set_ylabel(f"y [{unit}]")
    deformed = f", displacements x {magnification:g}" if magnification else ""
    axes.set_title(f"{quantity[0].upper()}{quantity[1:]}, load factor {load_factor:.6g}{deformed}")
    if colour_bar and mapped is not None and colours is not None:
        add_colour_bar(axes, mapped, f"{quantity} [{colours.unit}]")
    return axes, factor


def figure_size(found: list[Body], quantity: str) -> tuple[float, float]:
    """Inches that give the body about its own shape."""
    extent = np.ptp(np.concatenate([body.points for body in found]), axis=0)
    width, height = 5.2 * extent / extent.max()
    bar = 1.0 if quantity in COLOURS else 0.0
    return max(float(width) + 0.9 + bar, 3.2), max(float(height) + 0.8, 1.9)


def load_displacement(model: Drawable, support: int, component: Optional[Component] = None, *,
                      displacement: Optional[float] = None, axes: Any = None, label: str = "imposed displacement") -> Any:
    """Draw the force [N] of a support against its displacement [m] over the whole history; returns matplotlib's axes.

    Every event has two points, just before and after it, so that the curve has its peak: the first break is marked before
    its event, the end of growth after.

    component     "x" or "y"; if not given the one that the support prescribes, or of one that only holds the one with the
                  larger force.
    displacement  of the support [m] per unit of the load factor; if not given what the support prescribed at each line of
                  the history. A support that moves by no single number has its force drawn over the load factor.

    Raises ArgumentError for a support that is not there, OrderError before
    the first step.
    """
    arguments.whole("load_displacement: support", support)
    mark = model._sketch.supports.get(support)
    if mark is None:
        raise ArgumentError(f"load_displacement: support is {support}; there is no support with this id")
    if component is not None:
        arguments.choice("load_displacement: component", component, {"x": 1, "y": 2})
    with tempfile.TemporaryDirectory() as folder:
        table = pathlib.Path(folder) / "history.csv"
        model.write_history(table)
        history = read_history(table)
    if not history.size:
        raise OrderError("load_displacement: there is no history yet; step first")
    chosen: str = component or mark.component or max("xy", key=lambda c: float(np.abs(history[f"reaction_{c}_{support}"]).max()))
    moved = history[f"displacement_{chosen}_{support}"] if mark.proportional is not None else np.zeros(len(history))
    if displacement is not None:
        imposed = history["load_factor"] * displacement
    else:
        is_moved = np.isfinite(moved).all() and bool(moved.any())
        imposed = moved if is_moved else history["load_factor"]
        displacement = 1.0 if is_moved else None
    imposed, force, before, after = load_curve(history, imposed, history[f"reaction_before_{chosen}_{support}"],
                                               history[f"reaction_{chosen}_{support}"])
    force = force * np.sign(force[np.argmax(np.abs(force))])
    to_length, length_unit = (1.0, "-") if displacement is None else engineering(float(np.abs(imposed).max()), "m")
    to_force, force_unit = engineering(float(np.abs(force).max()), "N")
    force[np.abs(force) < 1e-9 * np.abs(force).max()] = 0  # rounding of a body in two
    x, y = to_length * imposed, to_force * force
    if axes is None:
        with plt.rc_context(STYLE):
            axes = plt.subplots(figsize=(4.6, 3.2), layout="constrained")[1]
    axes.plot(x, y, color=CURVE, linewidth=1.3, zorder=2)
    broken = history["total_broken_bonds"]
    if broken[-1] > 0:
        at = "" if displacement is None else f" {length_unit}"
        marks = (("first break", "o", before[np.argmax(broken > 0)]), ("end of growth", "s", after[np.argmax(broken >= broken[-1])]))
        for text, marker, row in marks:
            axes.plot(x[row], y[row], marker, color=MARK, markersize=5, zorder=3, clip_on=False,
                      label=f"{text}: {x[row]:.4g}{at}, {y[row]:.3g} {force_unit}")
        axes.legend(loc="best", handletextpad=0.3)
    axes.set_xlabel("load factor [-]" if displacement is None else f"{label} [{length_unit}]")
    axes.set_ylabel(f"force [{force_unit}]")
    axes.set_ylim(top=1.12 * float(y.max()))
    axes.grid(color="#dddddd", linewidth=0.5)
    axes.set_axisbelow(True)
    return axes


def load_curve(history: Any, imposed: Any, before: Any, after: Any) -> tuple[Any, Any, list[int], list[int]]:
    """Points of a curve from zero through all lines of a history, with the state before each event where that was in
    equilibrium: places, forces, and by lines the numbers of the points before and after.

    Where bonds are stretched beyond what they bear when an event comes, as at the end of an increment, the body was in
    equilibrium last where they just reached that, on the straight line from the line before.
    """
    places, forces, points_before, points_after = [0.0], [0.0], [], []
    start = 0.0
    for line, entry in enumerate(history):
        end, critical = entry["load_factor"], entry["critical_load_factor"]
        share = 1.0 if entry["stretch_ratio"] <= 1 + 1e-9 else (critical - start) / (end - start) if end != start else 0.0
        if entry["event"] > 0 and 0 < share <= 1:
            places.append(places[-1] + share * (imposed[line] - places[-1]))
            forces.append(forces[-1] + share * (before[line] - forces[-1]))
        points_before.append(len(places) - 1)
        places.append(imposed[line])
        forces.append(after[line])
        points_after.append(len(places) - 1)
        start = end
    return np.array(places), np.array(forces), points_before, points_after


class Movie:
    """A film of a run, as GIF or, with the program ffmpeg, as MP4: add a frame whenever there is something to see.

    with bempd.plot.Movie("crack.gif", model, magnification=20) as movie:
        for load_factor in range(100, 200, 5):
            model.step(load_factor)
            movie.add_frame()

    Options are those of draw(). The file is drawn by close(), in one view that holds what moves in any frame (a loose
    piece up to half the body's size away) and with one scale of colours; damage goes from 0 to 1. The last frame stays for
    `hold` seconds before the film begins again. The ending of the path, .gif or .mp4, says what is written; others are refused,
    and so is .mp4 where ffmpeg (Debian: ffmpeg) is missing.
    """

    def __init__(self, path: Union[str, "os.PathLike[str]"], model: Drawable, quantity: Quantity = "damage", *,
                 frames_per_second: float = 10, hold: float = 2.0, **options: Any) -> None:
        quantity = chosen_quantity("Movie", quantity)
        self._path = os.fspath(path)
        self._write = writer_of(self._path)
        self._model, self._quantity, self._options = model, quantity, options
        if quantity == "damage":
            options.setdefault("limits", (0.0, 1.0))
        self._frames_per_second = arguments.real("Movie: frames_per_second", frames_per_second)
        if not 0.1 <= self._frames_per_second <= 100:
            raise ArgumentError(f"Movie: frames_per_second is {frames_per_second!r}; give 0.1 to 100")
        self._hold = arguments.real("Movie: hold", hold)
        self._frames: list[tuple[list[Body], float]] = []

    def add_frame(self) -> None:
        """Keep the model as it is now."""
        self._frames.append((bodies(self._model, int(self._options.get("resolution", 20))), self._model.load_factor))

    def close(self) -> None:
        """Write the file; without a frame there is none."""
        if not self._frames:
            return
        frames, self._frames = self._frames, []
        shown = [body for found, _ in frames for body in found]
        options = {name: value for name, value in self._options.items() if name not in ("axes", "resolution")}
        colours = colour_scale(shown, self._quantity, options.get("limits"))
        if colours is not None:
            options["limits"] = (colours.low, colours.high)
        if options.get("magnification") == "auto":
            options["magnification"] = round_magnification(shown)
        low, high = view_of(shown, float(options.get("magnification", 0.0)))
        # A figure of its own, so that the user's current one stays what it is.
        figure = Figure(figsize=figure_size(frames[0][0], self._quantity), layout="constrained")
        figure.set_dpi(110)
        canvas, pictures = FigureCanvasAgg(figure), []
        for found, load_factor in frames:
            figure.clear()
            with plt.rc_context(STYLE):
                axes, factor = draw_bodies(found, load_factor, self._quantity, figure.add_subplot(), **options)
            axes.set_xlim(factor * low[0], factor * high[0])
            axes.set_ylim(factor * low[1], factor * high[1])
            canvas.draw()
            pictures.append(Image.fromarray(np.asarray(canvas.buffer_rgba())).convert("RGB"))
        self._write(self._path, pictures, self._frames_per_second, self._hold)

    def __enter__(self) -> Movie:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()


def writer_of(path: str) -> Any:
    """What writes pictures to a file of this ending; an error if there is none."""
    ending = pathlib.PurePath(path).suffix.lower()
    if ending == ".gif":
        return write_gif
    if ending != ".mp4":
        raise ArgumentError(f"Movie: {path} ends in {ending or 'nothing'}; a film is written as .gif or .mp4")
    if shutil.which("ffmpeg") is None:
        raise ArgumentError(f"Movie: {path} needs the program ffmpeg, which is not found; install it (Debian: apt install ffmpeg), or "
                            "write a .gif")
    return write_mp4


def write_gif(path: str, pictures: list[Any], frames_per_second: float, hold: float) -> None:
    """Write a film that begins again."""
    usual = round(1000 / frames_per_second)
    durations = [usual] * (len(pictures) - 1) + [max(usual, round(1000 * hold))]
    pictures[0].save(path, format="GIF", save_all=True, append_images=pictures[1:], duration=durations, loop=0)


def write_mp4(path: str, pictures: list[Any], frames_per_second: float, hold: float) -> None:
    """Write a film in H.264, which needs even numbers of dots; the last picture is repeated while it stays."""
    width, height = (size // 2 * 2 for size in pictures[0].size)
    repeated = pictures + [pictures[-1]] * max(0, round(hold * frames_per_second) - 1)
    command = ["ffmpeg", "-y", "-loglevel", "error", "-f", "rawvideo", "-pix_fmt", "rgb24", "-s", f"{width}x{height}",
               "-r", f"{frames_per_second:g}", "-i", "-", "-c:v", "libx264", "-pix_fmt", "yuv420p", "-movflags", "+faststart",
               "-f", "mp4", path if os.path.isabs(path) else os.path.join(".", path)]
    run = subprocess.run(command, input=b"".join(picture.crop((0, 0, width, height)).tobytes() for picture in repeated),
                         capture_output=True)
    if run.returncode != 0:
        raise FileError(f"Movie: ffmpeg could not write {path}: {run.stderr.decode(errors='replace').strip()}")


def view_of(found: list[Body], magnification: float) -> tuple[Any, Any]:
    """Lower left and upper right corner of a view [m] that holds all bodies as they are shown; of what flies away, half
    the body's size."""
    rest = np.concatenate([body.points for body in found])
    shown = np.concatenate([body.shown(magnification) for body in found])
    size = float(np.ptp(rest, axis=0).max())
    low = np.maximum(shown.min(axis=0), rest.min(axis=0) - 0.5 * size)
    high = np.minimum(shown.max(axis=0), rest.max(axis=0) + 0.5 * size)
    return low - 0.04 * size, high + 0.04 * size
