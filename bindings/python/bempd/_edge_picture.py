"""Edges, cracks and held or loaded points with their names as a file for ParaView."""

from __future__ import annotations

import dataclasses
import os
from typing import Optional, Sequence, Union

from ._sketch import Mark, Place, Sketch
from .errors import FileError


@dataclasses.dataclass(frozen=True)
class Part:
    """A point or a line of the file."""

    way: Sequence[Place]
    region: int = 0
    edge: int = 0
    crack: int = 0
    name: str = ""  # of the edge
    region_name: str = ""
    conditions: str = ""  # supports and loads


def write_edges(sketch: Sketch, prefix: Union[str, "os.PathLike[str]"]) -> None:
    """Write PREFIX_edges.vtp: a line for each edge of a scene with its region, number and names, a line for each crack, and a
    point for each place that is held or loaded. Without names there is no file."""
    if not sketch.names and not any(region.names for region in sketch.regions.values()):
        return
    places = sorted({mark.point for marks in (sketch.supports, sketch.loads) for mark in marks.values() if mark.point is not None})
    points = [Part([place], conditions=_conditions(sketch, point=place)) for place in places]
    lines = [Part(region.way(edge), number, edge, name=region.names.get(edge, ""), region_name=sketch.names.get(("region", number), ""),
                  conditions=_conditions(sketch, region=number, edge=edge))
             for number, region in sketch.regions.items() for edge in range(1, region.edge_count + 1)]
    lines += [Part(way, crack=crack, conditions=_conditions(sketch, crack=crack)) for crack, way in sketch.cracks.items()]
    path = os.fsdecode(prefix) + "_edges.vtp"
    try:
        with open(path, "w", encoding="utf-8") as file:
            file.write(_text(points, lines))
    except OSError as problem:
        raise FileError(f"write_snapshot: {path} cannot be written: {problem}") from None


def _conditions(sketch: Sketch, *, point: Optional[Place] = None, region: int = 0, edge: int = 0, crack: int = 0) -> str:
    """Supports and loads at a place, with their names; a load on a whole region is on each of its edges."""

    def is_there(mark: Mark) -> bool:
        if point is not None:
            return mark.point == point
        return mark.crack == crack if crack else mark.region == region and mark.edge in (0, edge)

    return ", ".join(sketch.called(what, number) for what, marks in (("support", sketch.supports), ("load", sketch.loads))
                     for number, mark in sorted(marks.items()) if is_there(mark))


def _text(points: list[Part], lines: list[Part]) -> str:
    parts = points + lines  # the order of the cells in such a file: points first
    places = " ".join(f"{x!r} {y!r} 0" for part in parts for x, y in part.way)
    count, first = sum(len(part.way) for part in parts), len(points)
    ends = [sum(len(part.way) for part in lines[: k + 1]) for k in range(len(lines))]

    def integers(name: str, values: Sequence[int]) -> str:
        return f'<DataArray type="Int32" Name="{name}" format="ascii">{" ".join(map(str, values))}</DataArray>'

    # VTK's strings in text are the codes of their bytes, each string with a zero at its end.
    def strings(name: str, values: list[str]) -> str:
        codes = " ".join(str(code) for value in values for code in value.encode("utf-8") + b"\0")
        return f'<DataArray type="String" Name="{name}" format="ascii">{codes}</DataArray>'

    return ('<?xml version="1.0"?>\n<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian"><PolyData>\n'
            f'<Piece NumberOfPoints="{count}" NumberOfVerts="{first}" NumberOfLines="{len(lines)}">\n'
            f'<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">{places}</DataArray></Points>\n'
            f'<Verts>{integers("connectivity", range(first))}{integers("offsets", range(1, first + 1))}</Verts>\n'
            f'<Lines>{integers("connectivity", range(first, count))}{integers("offsets", ends)}</Lines>\n'
            f'<CellData>{integers("region", [part.region for part in parts])}{integers("edge", [part.edge for part in parts])}'
            f'{integers("crack", [part.crack for part in parts])}{strings("name", [part.name for part in parts])}'
            f'{strings("region name", [part.region_name for part in parts])}'
            f'{strings("supports and loads", [part.conditions for part in parts])}</CellData>\n'
            '</Piece></PolyData></VTKFile>\n')
