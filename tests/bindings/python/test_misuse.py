"""Wrong values, wrong order: the right exception, with the library's sentence."""

import math

import bempd
import numpy as np
import pytest
from bempd import rectangle


def test_an_argument_error_has_the_library_s_sentence(plate):
    with pytest.raises(bempd.ArgumentError, match="^add_bem_region: .*7") as caught:
        plate.model.add_bem_region(7, rectangle(0, 0, 1, 1), 0.5)
    assert isinstance(caught.value, ValueError) and isinstance(caught.value, bempd.Error)
    assert caught.value.status == "BEMPD_ERROR_ARGUMENT"


def test_spacing_that_does_not_divide_is_explained(plate):
    soft = plate.model.add_material(young_modulus=1, poisson_ratio=1 / 3)
    with pytest.raises(bempd.ArgumentError, match="add_pd_region: .*0.03"):
        plate.model.add_pd_region(soft, rectangle(5, 0, 5.2, 0.2), spacing=0.03)


def test_adding_to_a_prepared_model_is_out_of_order(plate):
    plate.model.prepare()
    with pytest.raises(bempd.OrderError, match="fix_edge: ") as caught:
        plate.model.fix_edge(plate.plate, 2)
    assert isinstance(caught.value, RuntimeError)


def test_a_body_without_supports_is_unsolvable():
    model = bempd.Model()
    model.add_bem_region(model.add_material(young_modulus=1, poisson_ratio=0.3), rectangle(0, 0, 1, 1), 0.5)
    with pytest.raises(bempd.UnsolvableError, match="step: ") as caught:
        model.step(1)
    assert isinstance(caught.value, ArithmeticError)
    model.fix_edge(1, 4)  # the model is as it was before
    model.step(1)


def test_a_limit_on_events_is_a_convergence_error(strip):
    strip.model.options["stepping.max_events"] = 2
    with pytest.raises(bempd.ConvergenceError, match="run_to_separation: "):
        strip.model.run_to_separation(1e4)
    assert strip.model.load_factor == 0


def test_a_file_that_cannot_be_written_is_an_os_error(strip, tmp_path):
    with pytest.raises(OSError, match="write_history: ") as caught:
        strip.model.write_history(tmp_path / "missing" / "history.csv")
    assert isinstance(caught.value, bempd.FileError)
    with pytest.raises(bempd.FileError, match="write_snapshot: "):
        strip.model.write_snapshot(tmp_path / "missing" / "name")


@pytest.mark.parametrize("points, words", [
    ([1.0, 2.0, 3.0], r"add_crack: points has the shape \(3,\).*\(n, 2\)"),
    (np.zeros((4, 3)), r"shape \(4, 3\)"),
    (np.zeros((2, 2, 2)), r"shape \(2, 2, 2\)"),
    ([], r"shape \(0,\)"),
    ([[0, 0], [1]], "rows of different lengths"),
    ([[0, 0], [1, 1j]], "dtype complex128"),
    ([["a", "b"], ["c", "d"]], "dtype <U1"),
    ([[None, 0], [1, 1]], "dtype object"),
    (np.zeros((2, 2), dtype=bool), "dtype bool"),
    (np.zeros((2, 2), dtype="datetime64[s]"), "dtype datetime64"),
    (np.ma.masked_equal([[0.0, 1.0], [2.0, 3.0]], 1), "masked"),
    (None, "dtype object"),
])
def test_what_is_no_array_of_points_is_refused(strip, points, words):
    with pytest.raises(bempd.ArgumentError, match=words):
        strip.model.add_crack(points)


# What the library refuses is listed in tests/capi/misuse_*.c: here, that such numbers arrive there and its sentence here.
@pytest.mark.parametrize("bad", [math.nan, -math.inf])
def test_numbers_that_are_not_finite_are_refused_by_the_library(plate, bad):
    model = plate.model
    with pytest.raises(bempd.ArgumentError, match="add_crack: .*finite"):
        model.add_crack([(0.1, bad), (1, 1)])
    with pytest.raises(bempd.ArgumentError, match="add_traction: .*finite"):
        model.add_traction(plate.plate, 2, "x", [1, bad])
    with pytest.raises(bempd.ArgumentError, match="step: .*finite"):
        model.step(bad)


@pytest.mark.parametrize("call, words", [
    (lambda m: m.fix_edge("left", 4), "fix_edge: region is 'left'"),
    (lambda m: m.fix_edge(1, 4.0), "fix_edge: edge is 4.0"),
    (lambda m: m.fix_edge(1, 2**40), "fix_edge: edge is 1099511627776; .*at most 31 bits"),
    (lambda m: m.step("far"), "step: load_factor is 'far'; it must be a number"),
    (lambda m: m.step(None), "step: load_factor is None"),
    (lambda m: m.step(1j), "step: load_factor is 1j"),
    (lambda m: m.add_material(young_modulus="steel", poisson_ratio=0.3), "add_material: young_modulus is 'steel'"),
    (lambda m: m.add_material(young_modulus=1, poisson_ratio=0.3, plane="shell"), "plane is 'shell'.*'strain'"),
    (lambda m: m.fix_edge(1, 4, "z"), "component is 'z'.*'x', 'y', 'both'"),
    (lambda m: m.prescribe_edge(1, 2, "both", 1), "prescribe_edge: component is 'both'; it must be one of 'x', 'y'"),
    (lambda m: m.prescribe_edge(1, 2, "x"), "prescribe_edge: no value is given"),
    (lambda m: m.prescribe_edge(1, 2, "x", [1, 2, 3], constant=[1, 2]), r"\(2,\) and \(3,\)"),
    (lambda m: m.prescribe_edge(1, 2, "x", []), r"shape \(0,\)"),
    (lambda m: m.prescribe_edge(1, 2, "x", 1, part=0.5), r"prescribe_edge: part has the shape \(\)"),
    (lambda m: m.fix_point((0, 0, 0)), r"fix_point: point has the shape \(3,\)"),
    (lambda m: m.add_traction_function(1, 2, 3.0), "function is 3.0"),
    (lambda m: m.field(1, "temperature"), "name is 'temperature'.*'position'"),
    (lambda m: m.field(9, "position"), "field: .*9"),
    (lambda m: m.field([1], "position"), r"region is \[1\]"),
    (lambda m: m.field(1, "damage"), "is a BEM region"),
    (lambda m: m.copy_field(1, "position", out=np.zeros(3)), "out must be a writable"),
    (lambda m: m.reaction(99), "reaction: .*99"),
    (lambda m: m.evaluate([(9.0, 9.0)]), "evaluate: .*outside"),
    (lambda m: m.restore(b"bytes"), "state is a bytes"),
    (lambda m: m.write_history(3.5), "path is 3.5"),
    (lambda m: m.write_history("a\0b"), "zero byte"),
    (lambda m: setattr(m, "progress", 3), "progress is 3"),
    (lambda m: setattr(m, "log", "file"), "log is 'file'"),
])
def test_wrong_arguments_are_named(plate, call, words):
    with pytest.raises(bempd.ArgumentError, match=words):
        call(plate.model)


def test_a_closed_model_answers_nothing(plate):
    plate.model.close()
    plate.model.close()
    assert plate.model.closed
    for call in (plate.model.prepare, plate.model.request_cancel, lambda: plate.model.load_factor,
                 lambda: plate.model.field(1, "position"), lambda: plate.model.options["scheme"], plate.model.save):
        with pytest.raises(bempd.OrderError, match="the model is closed"):
            call()


def test_every_status_has_its_exception():
    from bempd import errors
    from bempd._library import lib

    for name, kind, builtin in [("ARGUMENT", bempd.ArgumentError, ValueError),
                                ("ORDER", bempd.OrderError, RuntimeError),
                                ("UNSOLVABLE", bempd.UnsolvableError, ArithmeticError),
                                ("CONVERGENCE", bempd.ConvergenceError, ArithmeticError),
                                ("CANCELLED", bempd.CancelledError, RuntimeError),
                                ("MEMORY", bempd.OutOfMemoryError, MemoryError), ("IO", bempd.FileError, OSError),
                                ("INTERNAL", bempd.InternalError, RuntimeError)]:
        assert hasattr(lib, "BEMPD_ERROR_" + name)
        error = errors.error_of("BEMPD_ERROR_" + name, "a sentence")
        assert type(error) is kind and isinstance(error, builtin) and str(error) == "a sentence"
        assert error.status == "BEMPD_ERROR_" + name
