"""Outlines of bodies from drawings (DXF, SVG) and meshes (Gmsh, Abaqus and what else meshio reads).

A reader returns an Outline, which add_bem_region() and add_pd_region() take in place of vertices, holes and names of edges
with it. Lengths are metres. Straight lines, circles and arcs are taken as they are; splines, ellipses and Bezier curves
become circular arcs that keep the tangent, no further from the curve than `tolerance`.

>>> import bempd, pathlib, tempfile
>>> drawing = '<svg xmlns="http://www.w3.org/2000/svg" width="40mm" height="20mm" viewBox="0 0 40 20">' \\
...           '<rect id="plate" width="40" height="20"/><circle cx="20" cy="10" r="4"/></svg>'
>>> file = pathlib.Path(tempfile.mkdtemp()) / "plate.svg"
>>> _ = file.write_text(drawing)
>>> outline = bempd.outline.from_svg(file)  # doctest: +SKIP
>>> outline                                 # doctest: +SKIP
<Outline: 8 edges, 1 holes, x 0 .. 0.04, y 0 .. 0.02; edges named plate>

Each reader needs one package, which is only imported there: ezdxf, svgelements or meshio.
"""

from __future__ import annotations

import importlib
import os
import pathlib
from typing import Any, Optional, Sequence, Union

from . import _dxf, _meshes, _svg
from ._loops import Loop, Outline, Piece, Unit, bodies_of, check_crossings, chosen_body, closed_loops, metres, size_of
from .errors import ArgumentError, FileError

__all__ = ["Loop", "Outline", "from_dxf", "from_mesh", "from_svg"]

File = Union[str, "os.PathLike[str]"]
Layers = Union[str, Sequence[str], None]

#: Shares of the drawing's size that are used where the caller gives nothing.
USUAL_TOLERANCE, USUAL_GAP = 1e-4, 1e-6


def from_dxf(path: File, *, unit: Optional[Unit] = None, layer: Layers = None, body: Optional[int] = None,
             tolerance: Optional[float] = None, gap: Optional[float] = None) -> Outline:
    """The outline in the model space of a DXF drawing. Layers name the edges, but for layer 0.

    unit       of the drawing: "mm", or the metres of one unit. The drawing's own ($INSUNITS) if it has one.
    layer      name or names of the layers that are read; all if not given.
    body       number of the body, from 1, where the drawing has several separate outlines; the largest is 1.
    tolerance  largest distance [m] of arcs from splines and ellipses; 1e-4 of the drawing's size if not given.
    gap        ends of lines [m] that are no further apart are joined; 1e-6 of the drawing's size if not given.

    Needs ezdxf (Debian: python3-ezdxf). Lines, polylines with bulges, arcs, circles, ellipses, splines and blocks are read;
    texts, dimensions, hatches and points are passed over.
    """
    package, file = needed("from_dxf", "ezdxf"), existing("from_dxf", path)
    drawing = _dxf.Drawing(package, file, names_of("from_dxf", layer))
    factor = metres("from_dxf", unit) if unit is not None else drawing.metres()
    size = drawing.size()
    limit = checked("from_dxf: tolerance", tolerance, USUAL_TOLERANCE * size * factor) / factor
    pieces, deviation = drawing.pieces(limit)
    return finished("from_dxf", file, pieces, deviation, factor, gap, body, drawing.layers())


def from_svg(path: File, *, unit: Optional[Unit] = None, layer: Layers = None, body: Optional[int] = None,
             tolerance: Optional[float] = None, gap: Optional[float] = None) -> Outline:
    """The outline in an SVG drawing, with y upwards from the lower edge of the page. Ids of shapes name the edges.

    unit  of the drawing: "mm", or the metres of one unit of its coordinates. If it is not given, width and height of the
          page have to have a unit, such as width="100mm".
    layer ids of the shapes that are read; all if not given.

    The rest is as for from_dxf(). Needs svgelements (Debian: python3-svgelements).
    """
    package, file = needed("from_svg", "svgelements"), existing("from_svg", path)
    drawing = _svg.Drawing(package, file, names_of("from_svg", layer))
    factor = metres("from_svg", unit) if unit is not None else drawing.metres()
    limit = checked("from_svg: tolerance", tolerance, USUAL_TOLERANCE * drawing.size() * factor) / factor
    pieces, deviation = drawing.pieces(limit)
    return finished("from_svg", file, pieces, deviation, factor, gap, body, drawing.ids())


def from_mesh(path: File, *, unit: Unit = 1.0, part: Optional[str] = None, body: Optional[int] = None,
              tolerance: Optional[float] = None) -> Outline:
    """The outline of a mesh of triangles and quadrilaterals, of first or second order, in the plane z = 0.

    Names of physical lines (Gmsh), and of sets of nodes that contain all nodes of a side (Abaqus), name the edges. Sides that
    lie on a line become one straight edge, those whose nodes lie on a circle to `tolerance` [m] become arcs. A node where the
    boundary turns by more than 40 degrees stays a corner.

    unit  of the coordinates: "mm", or metres; a mesh does not tell it, so that numbers are kept if it is not given.
    part  name of the physical surface or element set that is the body; the whole mesh if not given.
    body  as for from_dxf().

    Needs meshio (Debian: python3-meshio).
    """
    package, file = needed("from_mesh", "meshio"), existing("from_mesh", path)
    factor = metres("from_mesh", unit)
    sides = _meshes.boundary(package, file, part)
    limit = checked("from_mesh: tolerance", tolerance, USUAL_TOLERANCE * sides.size() * factor) / factor
    loops, deviation = sides.loops(limit)
    return chosen("from_mesh", file, loops, deviation, factor, body)


def needed(caller: str, package: str) -> Any:
    """An optional package."""
    try:
        return importlib.import_module(package)
    except ImportError as problem:
        raise ImportError(f"{caller}: the package {package} is needed and cannot be imported ({problem}); install it with "
                          f"apt install python3-{package}, or pip install {package}") from None


def existing(caller: str, path: File) -> pathlib.Path:
    """A file that can be read."""
    try:
        file = pathlib.Path(path)
    except TypeError:
        raise ArgumentError(f"{caller}: path is {path!r}; it must be a path") from None
    if not file.is_file():
        raise FileError(f"{caller}: there is no file {file}")
    return file


def names_of(caller: str, layer: Layers) -> Optional[set[str]]:
    """Names of layers as a set; None for all of them."""
    if layer is None:
        return None
    names = {layer} if isinstance(layer, str) else set(layer)
    if not names or not all(isinstance(name, str) for name in names):
        raise ArgumentError(f"{caller}: layer is {layer!r}; give a name or several names")
    return names


def checked(name: str, value: Optional[float], usual: float) -> float:
    """A length > 0, or the usual one."""
    if value is None:
        return usual
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not value > 0 or value == float("inf"):
        raise ArgumentError(f"{name} is {value!r}; it must be a length above 0")
    return float(value)


def finished(caller: str, file: pathlib.Path, pieces: list[Piece], deviation: float, factor: float, gap: Optional[float],
             body: Optional[int], names: list[str]) -> Outline:
    """The body that the lines of a drawing bound."""
    if not pieces:
        known = f"; it has {', '.join(names)}" if names else ""
        raise ArgumentError(f"{caller}: {file.name} has no line, arc or curve that was asked for{known}")
    limit = checked(f"{caller}: gap", gap, USUAL_GAP * size_of(pieces) * factor) / factor
    loops, moved = closed_loops(f"{caller}: {file.name}", pieces, limit)
    return chosen(caller, file, loops, max(deviation, moved), factor, body)


def chosen(caller: str, file: pathlib.Path, loops: list[Loop], deviation: float, factor: float, body: Optional[int]) -> Outline:
    """One body in metres."""
    where = f"{caller}: {file.name}"
    check_crossings(where, loops)
    bodies = bodies_of([loop.scaled(factor) for loop in loops], file.name, factor * deviation)
    return chosen_body(where, bodies, body)
