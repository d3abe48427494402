"""Snapshots as ParaView has them: read by VTK, whose readers are ParaView's, and held against closed forms.

The interpreter needs Debian's python3-vtk9; without it the test is skipped."""

import pathlib
import sys
import tempfile
import xml.etree.ElementTree as xml

try:
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkFiltersCore import vtkConnectivityFilter
    from vtkmodules.vtkFiltersGeneral import vtkWarpVector
    from vtkmodules.vtkFiltersVerdict import vtkMeshQuality
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
except ImportError as missing:
    print(f"skipped, as VTK is not there (Debian: python3-vtk9): {missing}")
    sys.exit(77)

import numpy as np
from bempd import Model, rectangle


def read(path):
    """One file by ParaView's reader of it."""
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def series(collection):
    """Times with their parts by name."""
    found = {}
    for entry in xml.parse(collection).getroot().iter("DataSet"):
        found.setdefault(float(entry.get("timestep")), {})[entry.get("name")] = read(collection.parent / entry.get("file"))
    return found


def values(data, name):
    return vtk_to_numpy(data.GetArray(name))


def points(grid):
    return vtk_to_numpy(grid.GetPoints().GetData())


def warped(grid, magnification):
    warp = vtkWarpVector()
    warp.SetInputData(grid)
    warp.SetInputArrayToProcess(0, 0, 0, 0, "displacement")
    warp.SetScaleFactor(magnification)
    warp.Update()
    return warp.GetOutput()


def count_parts(grid):
    parts = vtkConnectivityFilter()
    parts.SetInputData(grid)
    parts.SetExtractionModeToAllRegions()
    parts.Update()
    return parts.GetNumberOfExtractedRegions()


def areas(grid):
    quality = vtkMeshQuality()
    quality.SetInputData(grid)
    quality.SetTriangleQualityMeasureToArea()
    quality.SetQuadQualityMeasureToArea()
    quality.Update()
    return values(quality.GetOutput().GetCellData(), "Quality")


def test_uniform_tension_in_all_parts(folder):
    # Plane strain under tension t along x: across the plane nu t.
    t, young, nu = 2e6, 5e9, 0.25
    model = Model()
    rock = model.add_material(young_modulus=young, poisson_ratio=nu, plane="strain")
    left = model.add_bem_region(rock, rectangle(0, 0, 1, 1), element_length=0.5)
    model.add_pd_region(rock, rectangle(1, 0, 2, 1), spacing=0.125, horizon_ratio=3)
    right = model.add_bem_region(rock, rectangle(2, 0, 3, 1), element_length=0.5)
    model.fix_edge(left, 4, "x")
    model.fix_point((0, 0), "y")
    model.add_traction(right, 2, "x", t)
    model.step(1)
    model.write_snapshot(folder / "tension")
    ((time, parts),) = series(folder / "tension.pvd").items()
    assert time == 1 and list(parts) == ["lattice", "boundary", "inside", "cracks"], (time, list(parts))
    strain = (1 - nu**2) * t / young
    for name in ("lattice", "boundary", "inside"):
        data = parts[name].GetPointData()
        expected = np.tile([t, 0, 0, 0, 0, 0, 0, 0, nu * t], (parts[name].GetNumberOfPoints(), 1))
        np.testing.assert_allclose(values(data, "stress"), expected, atol=1e-8 * t)
        np.testing.assert_allclose(values(data, "principal_stress_1"), t, rtol=1e-8)
        np.testing.assert_allclose(values(data, "principal_stress_2"), 0, atol=1e-8 * t)
        np.testing.assert_allclose(values(data, "displacement")[:, 0], strain * points(parts[name])[:, 0],
                                   atol=1e-9 * strain)
    assert abs(areas(parts["inside"]).sum() - 2) < 1e-9 and parts["cracks"].GetNumberOfCells() == 0


def strip_with_cracks():
    model = Model()
    acrylic = model.add_material(young_modulus=3e9, poisson_ratio=1 / 3, thickness=0.005, fracture_energy=300)
    left = model.add_bem_region(acrylic, rectangle(0, 0, 0.02, 0.02), element_length=0.005)
    model.add_pd_region(acrylic, rectangle(0.02, 0, 0.04, 0.02), spacing=0.001, horizon_ratio=3)
    right = model.add_bem_region(acrylic, rectangle(0.04, 0, 0.06, 0.02), element_length=0.005)
    model.add_crack([(0.0295, 0), (0.0295, 0.0045)])
    model.add_crack([(0.009, 0.008), (0.011, 0.012)])
    model.fix_edge(left, 4)
    model.prescribe_edge(right, 2, "x", 1e-6)
    return model


def texts(data, name):
    """A text array, as ParaView shows it."""
    found = data.GetAbstractArray(name)
    return [found.GetValue(k) for k in range(found.GetNumberOfValues())]


def test_names_are_shown(folder):
    model = strip_with_cracks()
    model.name_region(1, "left block")
    model.name_edge(1, 4, "Klemme <1> \u00bd")
    model.name_support(1, "clamp")
    model.step(1)
    model.write_snapshot(folder / "named")
    ((_, parts),) = series(folder / "named.pvd").items()
    assert list(parts) == ["lattice", "boundary", "inside", "cracks", "edges"], list(parts)
    data, field = parts["edges"].GetCellData(), parts["lattice"].GetFieldData()
    count = 3 * 4 + 2  # edges and cracks
    assert parts["edges"].GetNumberOfCells() == count
    assert texts(data, "name") == ["", "", "", "Klemme <1> \u00bd"] + [""] * (count - 4)
    assert texts(data, "region name") == ["left block"] * 4 + [""] * (count - 4)
    assert texts(data, "supports and loads")[3] == 'support 1 ("clamp")'
    assert texts(data, "supports and loads")[9] == "support 2" and values(data, "crack").tolist()[-2:] == [1, 2]
    assert values(field, 'region 1 ("left block")')[0] == 1 and values(field, 'support 1 ("clamp")')[0] == 1


def test_torn_strip_opens(folder):
    model = strip_with_cracks()
    model.step(1)
    model.write_snapshot(folder / "torn")
    for _ in range(3):
        report = model.step_to_next_event(1e4)
        model.write_snapshot(folder / "torn")
    while not report.separated:
        report = model.step_to_next_event(1e4)
    model.write_snapshot(folder / "torn")
    moments = series(folder / "torn.pvd")
    # Events of unstable growth share one load factor.
    assert len(moments) == 5 and sorted(moments) == list(moments), list(moments)
    loads = [values(parts["lattice"].GetFieldData(), "load_factor")[0] for parts in moments.values()]
    assert loads[1] == loads[2] == loads[3] and loads[4] == report.load_factor, loads
    np.testing.assert_allclose(list(moments), loads, rtol=1e-8)
    assert [values(parts["cracks"].GetFieldData(), "snapshot")[0] for parts in moments.values()] == list(range(5))
    whole, torn = (list(moments.values())[k] for k in (0, -1))
    assert count_parts(whole["lattice"]) == 1 and count_parts(torn["lattice"]) >= 2
    # The strip is in two, 20 displacements wide open; what hung together across the gap would be stretched.
    magnification = 20
    gap = magnification * report.load_factor * 1e-6
    before, after = areas(torn["lattice"]), areas(warped(torn["lattice"], magnification))
    assert abs(before.sum() - 0.02**2) < 1e-12 and gap > 0.002
    assert after.max() < 1.1 * before.max(), (after.max(), before.max())
    lines = points(torn["cracks"])[values(torn["cracks"].GetPointData(), "opening")[:, 0] > 0.5 * gap / magnification]
    assert np.ptp(lines[:, 1]) > 0.019, "the line of the crack runs through the strip"


def test_inside_opens_along_a_crack(folder):
    model = strip_with_cracks()
    model.step(100)
    model.write_snapshot(folder / "open")
    (parts,) = series(folder / "open.pvd").values()
    inside, cracks = parts["inside"], parts["cracks"]
    assert abs(areas(inside).sum() - 2 * 0.02**2) < 1e-12
    # Points of both faces lie at the same places.
    places, jump = {}, 0.0
    for place, displacement in zip(points(inside), values(inside.GetPointData(), "displacement")):
        other = places.setdefault(tuple(place.round(12)), displacement)
        jump = max(jump, float(np.linalg.norm(displacement - other)))
    in_region = values(cracks.GetCellData(), "crack") == 2
    assert in_region.sum() > 4
    largest = np.linalg.norm(values(cracks.GetPointData(), "opening")[points(cracks)[:, 0] < 0.02], axis=1).max()
    assert 0.8 * largest < jump < 1.05 * largest, (jump, largest)


with tempfile.TemporaryDirectory() as name:
    for test in (test_uniform_tension_in_all_parts, test_names_are_shown, test_torn_strip_opens, test_inside_opens_along_a_crack):
        test(pathlib.Path(name))
        print("passed:", test.__name__)
