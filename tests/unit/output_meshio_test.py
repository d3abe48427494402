"""Reads the files of output_samples with readers that know nothing of the writers."""

import csv
import math
import pathlib
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as xml

try:
    import meshio
    import numpy as np
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)


def check_vtu(folder):
    mesh = meshio.read(folder / "all \u00fc.vtu")
    points = np.array([[0.1 * (i % 3), math.pi * (i // 3), 0] for i in range(9)])
    np.testing.assert_array_equal(mesh.points, points)
    found = [(block.type, block.data.tolist()) for block in mesh.cells]
    assert found == [
        ("vertex", [[4]]),
        ("line", [[0, 1], [1, 2]]),
        ("line3", [[6, 8, 7]]),
        ("quad", [[0, 1, 4, 3]]),
    ], found
    count = np.arange(9)
    damage = np.where(count == 5, np.nan, count / 3)
    np.testing.assert_array_equal(mesh.point_data["damage"], damage)
    vector = np.column_stack([count + 0.25, -1.0 * count, 0 * count])
    np.testing.assert_array_equal(mesh.point_data["displacement"], vector)
    triple = np.column_stack([1e-300 * count, np.full(9, 1e300), np.where(count == 2, -np.inf, 0.5)])
    np.testing.assert_array_equal(mesh.point_data["stress"], triple)
    assert mesh.point_data["id"].dtype == np.int32
    np.testing.assert_array_equal(mesh.point_data["id"], count - 4)
    np.testing.assert_array_equal(np.concatenate(mesh.cell_data["region"]), [1, 2, 3, 4, 5])
    assert {name: values.tolist() for name, values in mesh.field_data.items()} == {"load_factor": [0.25], "snapshot": [3]}
    named = np.concatenate(mesh.cell_data['a < b & "c" \u00e4'])
    np.testing.assert_array_equal(named, np.tile([0.125, 0.125, 0], (5, 1)))


def check_tables(folder):
    entries = [dict(entry.attrib) for entry in xml.parse(folder / "series.pvd").getroot().iter("DataSet")]
    assert [(float(e["timestep"]), e["part"], e["file"]) for e in entries] == [
        (0, "0", "a_0000_plate.vtu"),
        (0, "1", "a_0000_box.vtu"),
        (0.1, "0", "b & c.vtu"),
    ], entries
    with open(folder / "table.csv", newline="", encoding="utf-8") as file:
        rows = list(csv.reader(file))
    assert rows[0] == ["step", "load [N]", "note"], rows
    assert [float(row[1]) for row in rows[1:]] == [0.1, -1 / 3], rows
    assert rows[2][2] == 'a "quoted", longer\nnote', rows


with tempfile.TemporaryDirectory() as name:
    subprocess.run([sys.argv[1], name], check=True)
    check_vtu(pathlib.Path(name))
    check_tables(pathlib.Path(name))
    left = sorted(path.name for path in pathlib.Path(name).iterdir())
    assert left == ["all \u00fc.vtu", "empty.vtu", "series.pvd", "table.csv"], left
print("read back by meshio", meshio.__version__)
