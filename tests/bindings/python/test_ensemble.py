"""Ensembles in this process: cases, rows, files, tables and what is refused. Other engines: ../ensembles."""

import concurrent.futures
import functools
import io
import json
import math
import random

import bempd
import numpy as np
import pytest

serially = functools.partial(bempd.ensemble, executor="serial", quiet=True)


def shape(a, b=2.0):
    if a == 3:
        raise ValueError("three")
    return {"area": a * b, "name": f"{a}", "list": np.arange(2), "unknown": math.nan, "never": math.inf}


def test_rows_come_in_the_order_of_cases_with_errors_among_them():
    found = serially(shape, [{"a": 5}, {"a": 3}, {"b": 1.5, "a": 1}])
    assert [row["case"] for row in found] == [{"a": 5}, {"a": 3}, {"b": 1.5, "a": 1}] and len(found[1:]) == 2
    assert found.values("area").tolist()[::2] == [10, 1.5] and math.isnan(found.values("area")[1])
    assert found[0]["values"]["list"] == [0, 1]
    assert found.errors[0]["error"] == "ValueError: three" and "raise ValueError" in found.errors[0]["traceback"]
    assert str(found).splitlines()[0] == "3 cases, 1 with an error" and "area" in found._repr_html_()
    with pytest.raises(bempd.ArgumentError, match="no value 'volume'; there are area, name"):
        found.values("volume")


def test_a_file_keeps_all_digits_and_is_gone_on_with(tmp_path):
    path, third = tmp_path / "deep" / "results.jsonl", 1 / 3
    serially(math.sqrt, [third], results=path)
    calls = []

    def sqrt(x):
        calls.append(x)
        return math.sqrt(x)

    sqrt.__qualname__ = "sqrt"
    found = serially(sqrt, [2.0, third], results=path)
    assert calls == [2.0] and found.values().tolist() == [math.sqrt(2.0), math.sqrt(third)]
    assert bempd.read_ensemble(path).values().tolist() == [math.sqrt(third), math.sqrt(2.0)]
    for line in path.read_text().splitlines():
        json.loads(line, parse_constant=pytest.fail)  # no NaN or Infinity, which JSON does not have


def test_what_is_not_known_or_infinite_comes_back(tmp_path):
    path = tmp_path / "results.jsonl"
    for _ in range(2):
        found = serially(shape, [{"a": 1}], results=path)
        assert math.isnan(found.values("unknown")[0]) and found.values("never")[0] == math.inf


def test_errors_stay_or_are_run_again(tmp_path):
    path, broken = tmp_path / "results.jsonl", [True]

    def once(seed):
        if broken[0]:
            raise RuntimeError("disk full")
        return seed

    serially(once, 2, results=path)
    broken[0] = False
    assert len(serially(once, 2, results=path).errors) == 2
    assert serially(once, 2, results=path, retry_errors=True).values().tolist() == [0, 1]
    assert not bempd.read_ensemble(path).errors


def test_a_table_of_all_columns_is_written(tmp_path):
    found = serially(shape, [{"a": 1}, {"a": 3}], table=tmp_path / "table.csv")
    lines = (tmp_path / "table.csv").read_text().splitlines()
    assert lines[0] == "a,area,name,list,unknown,never,seconds,error" and lines[1].startswith('1,2.0,1,"[0, 1]",nan,inf,')
    assert lines[2].startswith("3,,,,,,") and lines[2].endswith("ValueError: three")
    pandas = pytest.importorskip("pandas") if importable("pandas") else None
    if pandas is not None:
        assert found.frame()["area"][0] == 2
    else:
        with pytest.raises(bempd.ArgumentError, match="python3-pandas"):
            found.frame()


def importable(module):
    try:
        __import__(module)
    except ImportError:
        return False
    return True


def test_models_have_one_thread_while_a_case_runs():
    def threads(given):
        return bempd.Model(options={"threads": given} if given else None).options["threads"]

    assert serially(threads, [0, 3]).values().tolist() == [1, 3]
    assert bempd.Model().options["threads"] == 0


def test_any_executor_serves():
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        assert bempd.ensemble(math.sqrt, [4.0, 9.0], executor=pool, quiet=True).values().tolist() == [2, 3]


def test_progress_is_told():
    told = io.StringIO()
    bempd.ensemble(shape, [{"a": 1}, {"a": 3}], executor="serial", file=told)
    assert told.getvalue().startswith("100% |") and "2 of 2 cases, 1 with an error [" in told.getvalue()


def test_an_interrupt_ends_the_run_and_keeps_what_was_done(tmp_path):
    def interrupted(seed):
        if seed == 2:
            raise KeyboardInterrupt
        return seed

    with pytest.raises(KeyboardInterrupt):
        serially(interrupted, 4, results=tmp_path / "results.jsonl")
    assert bempd.read_ensemble(tmp_path / "results.jsonl").values().tolist() == [0, 1]


@pytest.mark.parametrize("arguments, message", [
    (dict(function=3), "give a function"),
    (dict(cases="all"), "give how many"),
    (dict(cases=-1), "give how many"),
    (dict(cases=True), "give how many"),
    (dict(cases=[1, 2, 1]), "cases 0 and 2 are the same"),
    (dict(cases=[{"a": 1, "b": 2}, {"b": 2, "a": 1}]), "are the same"),
    (dict(cases=[random.Random(1)]), "given by its seed"),
    (dict(cases=[np.random.default_rng(1)]), "given by its seed"),
    (dict(workers=0), "workers is 0"),
    (dict(executor="cluster"), "executor is 'cluster'; give 'processes'"),
    (dict(executor="processes", function=lambda seed: seed), "cannot be sent to other processes"),
])
def test_misuse_is_told(arguments, message):
    with pytest.raises(bempd.ArgumentError, match=message):
        bempd.ensemble(**{"function": math.sqrt, "cases": 2, "quiet": True, "executor": "serial", **arguments})


@pytest.mark.parametrize("text", ["not ours\n", "not ours", "7\n8"])
def test_files_of_others_are_refused(tmp_path, text):
    path = tmp_path / "results.jsonl"
    serially(math.sqrt, 2, results=path)
    with pytest.raises(bempd.ArgumentError, match="has results of sqrt, not of exp"):
        serially(math.exp, 2, results=path)
    other = tmp_path / "notes.txt"
    other.write_text(text)
    with pytest.raises(bempd.ArgumentError, match="line 1 of .*notes.txt is not one of an ensemble"):
        serially(math.sqrt, 2, results=other)
    assert other.read_text() == text
    with pytest.raises(bempd.FileError, match="cannot be read"):
        bempd.read_ensemble(tmp_path / "nothing.jsonl")



def test_two_runs_do_not_write_one_file(tmp_path):
    path = tmp_path / "results.jsonl"
    found = serially(lambda seed: serially(math.sqrt, 3, results=path), 1, results=path)
    assert "another run writes" in found.errors[0]["error"] and len(bempd.read_ensemble(path)) == 1
