"""The library's warnings are Python's warnings unless the host takes the log itself."""

import logging
import pathlib
import subprocess
import sys
import warnings

import bempd
import pytest
from bempd import rectangle


def loose_model(**options):
    """A crack cuts off a part that no support holds: the library warns of it in prepare()."""
    model = bempd.Model(**options)
    glass = model.add_material(young_modulus=1, poisson_ratio=1 / 3)
    plate = model.add_pd_region(glass, rectangle(0, 0, 8, 4), spacing=1, horizon_ratio=2)
    model.add_crack([(4.5, 0), (4.5, 4)])
    model.fix_edge(plate, 4)
    return model, plate


def test_warnings_are_told_at_the_line_of_the_host():
    model, _ = loose_model()
    assert model.log == "warnings"
    with pytest.warns(bempd.Warning, match="parts can move freely") as seen:
        model.step(1)
    assert len({str(one.message) for one in seen}) == len(seen) == 2, "each is told once"
    assert all(one.filename == __file__ and issubclass(one.category, UserWarning) for one in seen)


def test_the_rest_of_the_log_is_no_warning():
    model = bempd.Model()
    glass = model.add_material(young_modulus=1, poisson_ratio=1 / 3)
    model.fix_edge(model.add_pd_region(glass, rectangle(0, 0, 8, 4), spacing=1, horizon_ratio=2), 4)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        model.step(1)


@pytest.mark.parametrize("way", ["none at first", "none later", "filter"])
def test_a_host_turns_them_off(way):
    with warnings.catch_warnings(record=True) as seen:
        warnings.simplefilter("always")
        if way == "filter":
            warnings.simplefilter("ignore", bempd.Warning)
        model, _ = loose_model(**({"log": None} if way == "none at first" else {}))
        if way == "none later":
            model.log = None
        model.step(1)
    assert not seen


def test_a_host_with_its_own_log_is_told_once(caplog):
    said = []
    with warnings.catch_warnings(record=True) as seen:
        warnings.simplefilter("always")
        loose_model(log=lambda level, message: said.append((level, message)))[0].step(1)
        loose_model(log=logging.getLogger("bempd"))[0].step(1)
    assert not seen
    told = [message for level, message in said if level == 1]
    assert len(told) == len(set(told)) == 2
    assert [record.message for record in caplog.records if record.levelno == logging.WARNING] == told


def test_warnings_as_errors_come_out_of_the_call():
    model, _ = loose_model()
    with warnings.catch_warnings():
        warnings.simplefilter("error", bempd.Warning)
        with pytest.raises(bempd.Warning, match="parts can move freely"):
            model.step(1)


def test_parts_of_a_body_that_is_torn_in_two_are_no_warning():
    said = []
    model = bempd.Model(log=lambda level, message: said.append((level, message)))
    glass = model.add_material(young_modulus=3e9, poisson_ratio=1 / 3, fracture_energy=300)
    strip = model.add_body(glass, rectangle(0, 0, 0.06, 0.02))
    model.add_crack([(0.0295, 0), (0.0295, 0.0045)])
    model.fix_edge(strip, 4)
    model.prescribe_edge(strip, 2, "x", 1e-6)
    assert model.run_to_separation(1e4).separated
    assert [level for level, message in said if "parts can move freely" in message] == [2]
    assert not [message for level, message in said if level == 1]


def test_a_wrong_log_is_refused_and_python_s_own_class_stays():
    with pytest.raises(bempd.ArgumentError, match="log is 'loud'; give \"warnings\""):
        bempd.Model(log="loud")
    names = {}
    exec("from bempd import *", names)
    assert "Warning" not in names


def test_a_program_shows_a_warning_on_stderr_once():
    code = ("import test_warnings\n"
            "for _ in range(3):\n"
            "    test_warnings.loose_model()[0].step(1)\n")
    shown = subprocess.run([sys.executable, "-c", code], cwd=pathlib.Path(__file__).parent, capture_output=True,
                           text=True, check=True)
    assert shown.stdout == "" and shown.stderr.count("Warning: parts can move freely") == 1


def test_scenes_of_boundary_elements_warn_while_they_are_prepared():
    """A gap between two regions is told once, and a step's error keeps its name."""
    model = bempd.Model()
    glass = model.add_material(young_modulus=1, poisson_ratio=1 / 3, fracture_energy=1e-4)
    left = model.add_bem_region(glass, rectangle(0, 0, 4, 4), 1.0)
    with pytest.raises(bempd.UnsolvableError, match="^step: "):
        model.step(1)
    right = model.add_bem_region(glass, rectangle(4.001, 0, 8, 4), 1.0)
    model.fix_edge(left, 4)
    model.fix_edge(right, 2)
    model.add_crack([(1, 2), (2, 2)])
    with pytest.warns(bempd.Warning) as seen:
        model.step(1)
    assert len(seen) == 1 and "0.001" in str(seen[0].message) and seen[0].filename == __file__
    assert model.log == "warnings"


def test_a_step_inside_a_call_is_refused_under_its_own_name():
    model = bempd.Model()
    plate = model.add_bem_region(model.add_material(young_modulus=1, poisson_ratio=1 / 3), rectangle(0, 0, 4, 4), 1.0)
    model.add_crack([(1, 2), (2, 2)])
    model.fix_edge(plate, 4)
    with pytest.raises(bempd.OrderError, match="^step: the model is in another call"):
        model.add_traction_function(plate, 2, lambda x, y: model.step(1))
        model.prepare()
