#!/usr/bin/env python3
"""Draws docs/paraview.png: a run's series of snapshots read, warped and coloured as ParaView does it, off screen.

    xvfb-run -a docs/paraview_picture.py [PICTURE]     (Debian: python3-vtk9 xvfb xauth)

The library is found as the Python package finds it (BEMPD_LIBRARY)."""

from __future__ import annotations

import pathlib
import sys
import tempfile
import xml.etree.ElementTree as xml

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "bindings/python"))

import numpy as np  # noqa: E402
import vtkmodules.vtkInteractionStyle  # noqa: E402, F401
import vtkmodules.vtkRenderingFreeType  # noqa: E402, F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: E402, F401
from matplotlib import colormaps  # noqa: E402
from vtkmodules.vtkCommonCore import vtkLookupTable  # noqa: E402
from vtkmodules.vtkFiltersGeneral import vtkWarpVector  # noqa: E402
from vtkmodules.vtkIOImage import vtkPNGWriter  # noqa: E402
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader  # noqa: E402
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor  # noqa: E402
from vtkmodules.vtkRenderingCore import (vtkActor, vtkDataSetMapper, vtkRenderer, vtkRenderWindow,  # noqa: E402
                                         vtkWindowToImageFilter)

from bempd import Model, rectangle  # noqa: E402

MAGNIFICATION, LARGEST = 20, 30e6  # Pa


def run(prefix: pathlib.Path) -> None:
    """A strip with a crack that runs, a hole and two cracks that stand still."""
    model = Model(options={"crack.rule": "bond"})
    acrylic = model.add_material(young_modulus=3e9, poisson_ratio=1 / 3, thickness=0.005, fracture_energy=300)
    left = model.add_bem_region(acrylic, rectangle(0, 0, 0.02, 0.02), element_length=0.005)
    model.add_pd_region(acrylic, rectangle(0.02, 0, 0.04, 0.02), spacing=0.0005, horizon_ratio=4)
    right = model.add_bem_region(acrylic, rectangle(0.04, 0, 0.06, 0.02), element_length=0.005)
    model.add_circular_hole(right, (0.05, 0.008), 0.003)
    model.add_crack([(0.02975, 0), (0.02975, 0.00425)])
    model.add_crack([(0.008, 0.0135), (0.0105, 0.016)])
    model.fix_edge(left, 4)
    model.prescribe_edge(right, 2, "x", 1e-6)
    model.options["snapshots.inside"] = 24
    model.step_to_next_event(1e4)
    model.write_snapshot(prefix)
    while model.statistics().broken_bonds < 420:
        model.step_to_next_event(1e4)
    model.write_snapshot(prefix)


def grids(collection: pathlib.Path):
    """Parts of the last moment."""
    entries = list(xml.parse(collection).getroot().iter("DataSet"))
    last = max(float(entry.get("timestep")) for entry in entries)
    for entry in entries:
        if float(entry.get("timestep")) == last:
            reader = vtkXMLUnstructuredGridReader()
            reader.SetFileName(str(collection.parent / entry.get("file")))
            yield entry.get("name"), reader


def colours(largest: float) -> vtkLookupTable:
    table = vtkLookupTable()
    table.SetNumberOfTableValues(256)
    for k, colour in enumerate(colormaps["viridis"](np.linspace(0, 1, 256))):
        table.SetTableValue(k, *colour)
    table.SetRange(0, largest)
    return table


def actor(name: str, reader: vtkXMLUnstructuredGridReader, table: vtkLookupTable) -> vtkActor:
    warp = vtkWarpVector()
    warp.SetInputConnection(reader.GetOutputPort())
    warp.SetInputArrayToProcess(0, 0, 0, 0, "displacement")
    warp.SetScaleFactor(MAGNIFICATION)
    mapper = vtkDataSetMapper()
    mapper.SetInputConnection(warp.GetOutputPort())
    mapper.SetLookupTable(table)
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray("principal_stress_1")
    mapper.UseLookupTableScalarRangeOn()
    mapper.SetScalarVisibility(name in ("lattice", "inside"))
    shown = vtkActor()
    shown.SetMapper(mapper)
    shown.GetProperty().SetLighting(False)
    if name in ("boundary", "cracks"):
        shown.GetProperty().SetColor(0.15, 0.15, 0.2)
        shown.GetProperty().SetLineWidth(1.5)
    return shown


def main() -> None:
    target = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ROOT / "docs/paraview.png")
    renderer, table = vtkRenderer(), colours(LARGEST)
    renderer.SetBackground(1, 1, 1)
    with tempfile.TemporaryDirectory() as folder:
        run(pathlib.Path(folder) / "strip")
        for name, reader in grids(pathlib.Path(folder) / "strip.pvd"):
            reader.Update()
            if name != "cracks":
                renderer.AddActor(actor(name, reader, table))
    bar = vtkScalarBarActor()
    bar.SetLookupTable(colours(LARGEST / 1e6))
    bar.SetTitle("larger principal stress [MPa]\n")
    bar.SetOrientationToHorizontal()
    bar.SetNumberOfLabels(4)
    bar.SetLabelFormat("%.0f")
    bar.SetUnconstrainedFontSize(True)
    bar.SetPosition(0.25, 0.02)
    bar.SetPosition2(0.5, 0.14)
    for words in (bar.GetTitleTextProperty(), bar.GetLabelTextProperty()):
        words.SetColor(0, 0, 0)
        words.SetFontSize(16)
        words.SetItalic(False)
        words.SetBold(False)
        words.SetShadow(False)
    renderer.AddViewProp(bar)
    renderer.ResetCamera()
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetParallelScale(0.0155)
    x, y, z = camera.GetFocalPoint()
    camera.SetFocalPoint(x, y - 0.003, z)
    camera.SetPosition(x, y - 0.003, camera.GetPosition()[2])
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(8)
    window.SetSize(1300, 560)
    window.AddRenderer(renderer)
    window.Render()
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetFileName(str(target))
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()
    print(f"wrote {target}")


if __name__ == "__main__":
    main()
