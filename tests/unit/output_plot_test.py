"""Runs the example's plot script on the files of output_crack_samples and checks what it chose to show."""

import pathlib
import subprocess
import sys
import tempfile

samples, examples = sys.argv[1], pathlib.Path(sys.argv[2])
sys.path.insert(0, str(examples))
try:
    import plotting
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    subprocess.run([samples, name], check=True)
    series = plotting.read_series(folder / "crack.pvd")
    assert len(series) == 21, len(series)
    stages = plotting.crack_stages(series, "Complete")
    assert [stage.title for stage in stages] == ["First damage", "Half way", "Complete"], stages
    assert [stage.snapshot.load_factor for stage in stages] == [284, 340, 403], stages

    last = stages[-1].snapshot.mesh("lattice")
    quads = last.cells_dict["quad"]
    cut = plotting.cut_cells(last.points, last.point_data["displacement"], quads, 8e-4)
    assert cut.sum() == 100, "one column of cells is cut over the whole height"
    loops = plotting.boundary_loops(stages[-1].snapshot.mesh("boundary"), 1)
    assert [region for region, _ in loops] == [1, 2], loops

    (folder / "history.csv").rename(folder / "history_crack.csv")
    assert plotting.written_runs(folder) == ["crack"]
    history = plotting.read_history(folder / "history_crack.csv")
    assert [history["load_factor"][row] for row in plotting.growth_rows(history)] == [281, 400]
    assert plotting.engineering(8.2e-6, "m")[1] == "\u00b5m" and plotting.engineering(2e4, "N") == (1e-3, "kN")

    titles = plotting.stage_titles(stages, [5.57, 6.301, 6.302], "um")
    assert titles == ["First damage, 5.57 um", "Half way, 6.3 um", "Complete, same load"], titles

    script = examples / "centre_crack" / "plot.py"
    subprocess.run([sys.executable, script, folder, "crack"], check=True)
    picture = (folder / "crack.png").read_bytes()
    assert picture[:8] == b"\x89PNG\r\n\x1a\n" and len(picture) > 20000, len(picture)
