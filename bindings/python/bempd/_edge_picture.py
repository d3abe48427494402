"""Edges with their names as a file for ParaView."""

from __future__ import annotations

import os
from typing import Union

from ._sketch import Sketch
from .errors import FileError


def write_edges(sketch: Sketch, prefix: Union[str, "os.PathLike[str]"]) -> None:
    """Write PREFIX_edges.vtp: a line for each edge of a scene, with its region, number and name. Without names there is no
    file."""
    if not any(region.names for region in sketch.regions.values()):
        return
    rows = [(number, edge, region.names.get(edge, ""), region.way(edge))
            for number, region in sketch.regions.items() for edge in range(1, region.edge_count + 1)]
    points = " ".join(f"{x!r} {y!r} 0" for *_, way in rows for x, y in way)
    counts = [len(way) for *_, way in rows]
    ends = [sum(counts[: k + 1]) for k in range(len(counts))]
    # VTK's strings in text are the codes of their bytes, each string with a zero at its end.
    codes = " ".join(str(code) for _, _, name, _ in rows for code in name.encode("utf-8") + b"\0")

    def integers(name: str, values: list[int]) -> str:
        return f'<DataArray type="Int32" Name="{name}" format="ascii">{" ".join(map(str, values))}</DataArray>'

    text = ('<?xml version="1.0"?>\n<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian"><PolyData>\n'
            f'<Piece NumberOfPoints="{sum(counts)}" NumberOfLines="{len(rows)}">\n'
            f'<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">{points}</DataArray></Points>\n'
            f'<Lines>{integers("connectivity", list(range(sum(counts))))}{integers("offsets", ends)}</Lines>\n'
            f'<CellData>{integers("region", [row[0] for row in rows])}{integers("edge", [row[1] for row in rows])}'
            f'<DataArray type="String" Name="name" format="ascii">{codes}</DataArray></CellData>\n'
            '</Piece></PolyData></VTKFile>\n')
    path = os.fsdecode(prefix) + "_edges.vtp"
    try:
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
    except OSError as problem:
        raise FileError(f"write_snapshot: {path} cannot be written: {problem}") from None
