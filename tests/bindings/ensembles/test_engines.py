"""Ensembles on processes, MPI and Dask: the same digits from all of them, through kills and changes of the executor."""

import importlib.util
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

import bempd
import pytest
import study

STUDY = pathlib.Path(study.__file__)
MPI = ["mpirun", "-np", "3", "--oversubscribe", sys.executable, "-m", "mpi4py.futures"]
# Dask tells on stderr of folders that a killed cluster left, so it has one of its own here.
DASK_FOLDER = tempfile.TemporaryDirectory()
# Open MPI refuses to run as root otherwise, and looks for ssh where it starts nothing on other machines.
ENVIRONMENT = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMPI_MCA_plm_rsh_agent": "false",
               "OMPI_MCA_rmaps_base_oversubscribe": "1", "OMPI_MCA_btl": "self,vader", "OMPI_MCA_hwloc_base_binding_policy": "none",
               "DASK_TEMPORARY_DIRECTORY": DASK_FOLDER.name}


def started(command, *arguments):
    return subprocess.Popen([*command, str(STUDY), *map(str, arguments)], env=ENVIRONMENT, stderr=subprocess.PIPE, text=True,
                            start_new_session=True)


def finished(command, *arguments):
    process = started(command, *arguments)
    _, said = process.communicate(timeout=120)
    assert process.returncode == 0, said
    return said


def rows_of(path):
    lines = path.read_text().split("\n")[:-1] if path.exists() else []
    return [json.loads(line) for line in lines[1:]]


def is_alive(process):
    try:
        return pathlib.Path(f"/proc/{process}/stat").read_text().rsplit(")", 1)[1].split()[0] != "Z"
    except OSError:
        return False


def wait_for(happened, seconds=60):
    end = time.monotonic() + seconds
    while not happened():
        assert time.monotonic() < end
        time.sleep(0.02)


def test_needed_packages_are_here():
    for module, package in (("mpi4py", "python3-mpi4py"), ("distributed", "python3-distributed")):
        assert importlib.util.find_spec(module), f"install Debian's package {package}"


def test_a_killed_run_goes_on_with_mpi_and_ends_with_dask_in_the_same_digits(tmp_path):
    path = tmp_path / "plates.jsonl"
    first = started([sys.executable], "processes", 400, path)
    wait_for(lambda: len(rows_of(path)) >= 4)
    os.kill(first.pid, signal.SIGKILL)
    first.communicate()
    kept = rows_of(path)
    workers = {row["values"]["process"] for row in kept if "values" in row}
    wait_for(lambda: not any(map(is_alive, workers)), 10)
    with open(path, "a") as file:
        file.write('{"case": 399, "values": {"stre')  # what a kill within a line leaves

    count = max(row["case"] for row in kept) + 1
    finished(MPI, "mpi", count + 8, path)
    by_mpi = rows_of(path)
    assert by_mpi[: len(kept)] == kept and sorted(row["case"] for row in by_mpi) == list(range(count + 8))
    assert workers.isdisjoint(row["values"]["process"] for row in by_mpi[len(kept):] if "values" in row)

    said = finished([sys.executable], "dask", count + 16, path)
    assert f"{count + 16} of {count + 16} cases, 1 with an error" in said and said.startswith("100%")
    rows = rows_of(path)
    assert rows[: len(by_mpi)] == by_mpi and sorted(row["case"] for row in rows) == list(range(count + 16))
    for row in rows:
        if row["case"] == study.SEED_OF_ERROR:
            assert row["error"] == "ValueError: this seed has no plate" and "study.py" in row["traceback"]
        elif row["case"] < 3 or row["case"] >= count - 1:
            expected = study.plate(row["case"], pid=False)
            assert {name: row["values"][name] for name in expected} == expected
            assert row["values"]["threads"] == 1


def test_a_process_that_ends_is_one_row():
    found = bempd.ensemble(study.ends_its_process, 5, workers=2, quiet=True)
    assert [row["case"] for row in found.errors] == [1] and "was killed" in found.errors[0]["error"]
    assert found.values()[[0, 2, 3, 4]].tolist() == [0, 2, 3, 4]


def test_a_script_that_processes_cannot_import_is_told(tmp_path):
    script = tmp_path / "unguarded.py"
    script.write_text("import bempd, math\nbempd.ensemble(math.sqrt, 3, workers=1)\n")
    run = subprocess.run([sys.executable, str(script)], env=ENVIRONMENT, capture_output=True, text=True, timeout=60)
    assert 'put the call under `if __name__ == "__main__":`' in run.stderr


def test_mpi_without_ranks_is_told():
    run = subprocess.run([sys.executable, str(STUDY), "mpi", "3", os.devnull], env=ENVIRONMENT, capture_output=True, text=True,
                         timeout=60)
    assert "mpirun -np 4 python3 -m mpi4py.futures SCRIPT" in run.stderr


@pytest.mark.parametrize("executor, module, package", [("mpi", "mpi4py.futures", "python3-mpi4py"),
                                                       ("dask", "distributed", "python3-distributed")])
def test_a_missing_module_is_told_with_its_package(monkeypatch, executor, module, package):
    monkeypatch.setitem(sys.modules, module, None)
    with pytest.raises(bempd.ArgumentError, match=f"Debian's package {package}"):
        bempd.ensemble(study.plate, 3, executor=executor, quiet=True)
