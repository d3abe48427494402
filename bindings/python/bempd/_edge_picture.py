"""Edges with their names as a file for ParaView."""

from __future__ import annotations

import os
from typing import Union

from ._sketch import Sketch
from .errors import FileError


def write_edges(sketch: Sketch, prefix: Union[str, "os.PathLike[str]"]) -> None:
    """Write PREFIX_edges.vtp: a line for each edge of a scene, with its region, number and names. Without names there is no
    file."""
    if not sketch.names and not any(region.names for region in sketch.regions.values()):
        return
    rows = [(number, edge, region.names.get(edge, ""), region.way(edge))
            for number, region in sketch.regions.items() for edge in range(1, region.edge_count + 1)]
    points = " ".join(f"{x!r} {y!r} 0" for *_, way in rows for x, y in way)
    counts = [len(way) for *_, way in rows]
    ends = [sum(counts[: k + 1]) for k in range(len(counts))]
    # VTK's strings in text are the codes of their bytes, each string with a zero at its end.
    def strings(name: str, values: list[str]) -> str:
        codes = " ".join(str(code) for value in values for code in value.encode("utf-8") + b"\0")
        return f'<DataArray type="String" Name="{name}" format="ascii">{codes}</DataArray>'

    held = [", ".join(sketch.called(what, number) for what, marks in (("support", sketch.supports), ("load", sketch.loads))
                      for number, mark in sorted(marks.items()) if (mark.region, mark.edge) == row[:2]) for row in rows]

    def integers(name: str, values: list[int]) -> str:
        return f'<DataArray type="Int32" Name="{name}" format="ascii">{" ".join(map(str, values))}</DataArray>'

    text = ('<?xml version="1.0"?>\n<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian"><PolyData>\n'
            f'<Piece NumberOfPoints="{sum(counts)}" NumberOfLines="{len(rows)}">\n'
            f'<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">{points}</DataArray></Points>\n'
            f'<Lines>{integers("connectivity", list(range(sum(counts))))}{integers("offsets", ends)}</Lines>\n'
            f'<CellData>{integers("region", [row[0] for row in rows])}{integers("edge", [row[1] for row in rows])}'
            f'{strings("name", [row[2] for row in rows])}'
            f'{strings("region name", [sketch.names.get(("region", row[0]), "") for row in rows])}'
            f'{strings("supports and loads", held)}</CellData>\n'
            '</Piece></PolyData></VTKFile>\n')
    path = os.fsdecode(prefix) + "_edges.vtp"
    try:
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
    except OSError as problem:
        raise FileError(f"write_snapshot: {path} cannot be written: {problem}") from None
