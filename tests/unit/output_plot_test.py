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

    # A strip that bears 2 N at its first event and 1 N after it, then 1.5 N and nothing; then one that is never in balance.
    table = {"event": [1, 2, 0], "load_factor": [1, 3, 4], "stretch_ratio": [1, 1, 0], "critical_load_factor": [1, 3, 4],
             "reaction_x_2": [1, 0, 0], "reaction_before_x_2": [2, 1.5, 0]}
    curve = plotting.load_curve({name: plotting.np.array(column, float) for name, column in table.items()}, "reaction_x_2")
    assert (list(curve[0]), list(curve[1]), curve[2]) == ([0, 1, 1, 3, 3, 4], [0, 2, 1, 1.5, 0, 0], [(1, 2), (3, 4), (5, 5)]), curve
    table.update(stretch_ratio=[2, 1.5, 0], critical_load_factor=[0.5, 0.8, 4], load_factor=[1, 1, 4])
    curve = plotting.load_curve({name: plotting.np.array(column, float) for name, column in table.items()}, "reaction_x_2")
    assert (list(curve[0]), list(curve[1])) == ([0, 0.5, 1, 1, 4], [0, 1, 1, 0, 0]), curve

    titles = plotting.stage_titles(stages, [5.57, 6.301, 6.302], "um")
    assert titles == ["First damage, 5.57 um", "Half way, 6.3 um", "Complete, same load"], titles

    script = examples / "centre_crack" / "plot.py"
    subprocess.run([sys.executable, script, folder, "crack"], check=True)
    picture = (folder / "crack.png").read_bytes()
    assert picture[:8] == b"\x89PNG\r\n\x1a\n" and len(picture) > 20000, len(picture)
