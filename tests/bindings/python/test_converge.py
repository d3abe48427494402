"""Values at several spacings: order, extrapolation and error against closed forms, and a scene."""

import io
import math

import bempd
import pytest
from bempd import rectangle
from conftest import make_strip


@pytest.mark.parametrize("order", [0.5, 1, 2, 3.7])
@pytest.mark.parametrize("spacings", [[0.4, 0.2, 0.1], [0.3, 0.2, 0.15]])
def test_the_order_and_limit_of_a_power_are_found(order, spacings):
    found = bempd.converge(lambda h: 7 - 2 * h**order, spacings, quiet=True)
    assert found.order == pytest.approx(order, rel=1e-6) and found.extrapolated == pytest.approx(7, rel=1e-9)
    assert found.error >= 1.2 * abs(7 - found.only.values[-1])


def test_the_table_says_it_all(capsys):
    found = bempd.converge(lambda h: {"force [N]": 100 + 50 * h**2, "K": 3.0}, [0.1, 0.4, 0.2])
    printed = capsys.readouterr().out
    assert printed == str(found) + "\n"
    lines = printed.splitlines()
    assert lines[0].split() == ["spacing", "force", "[N]", "K", "seconds"]
    assert [line.split()[:2] for line in lines[1:4]] == [["0.4", "108"], ["0.2", "102"], ["0.1", "100.5"]]
    assert lines[4].split() == ["order", "2.00", "-"] and lines[5].split() == ["extrapolated", "100", "3"]
    assert lines[6].startswith("error at 0.1") and "0.62 %" in lines[6]
    assert lines[7] == "K: the last two values agree to rounding"
    assert "<table>" in found._repr_html_() and "force [N]" in found._repr_html_()
    other = io.StringIO()
    bempd.converge(lambda h: h, [2, 1], file=other)
    assert "order 1 is assumed; a third spacing would show it" in other.getvalue()


def test_two_spacings_take_an_order_and_are_trusted_less():
    two = bempd.converge(lambda h: 1 + h**2, [0.2, 0.1], order=2, quiet=True)
    three = bempd.converge(lambda h: 1 + h**2, [0.4, 0.2, 0.1], quiet=True)
    assert math.isnan(two.order) and two.extrapolated == pytest.approx(1) and two.error == pytest.approx(3 * 0.01)
    assert three.error == pytest.approx(1.25 * 0.01)


@pytest.mark.parametrize("values, words", [((1.0, 2.0, 1.5), "go up and down"), ((1.0, 2.0, 4.0), "do not come nearer")])
def test_what_shows_no_order_is_not_extrapolated(values, words):
    found = bempd.converge(lambda h: values[(4.0, 2.0, 1.0).index(h)], [4, 2, 1], quiet=True)
    assert math.isnan(found.order) and math.isnan(found.extrapolated) and words in found.only.note
    assert found.error == pytest.approx(max(values) - min(values))


def test_a_scene_is_run_at_each_spacing():
    def build(spacing):
        return make_strip(spacing).model.run_to_separation(1e4)

    found = bempd.converge(build, [0.004, 0.002], quiet=True)
    assert set(found) == {"load_factor", "peak_resistance", "stored_energy", "released_energy"}
    assert found["peak_resistance"].relative_error > 0 and found.seconds[1] > 0
    with pytest.raises(bempd.ArgumentError, match="there are 4 values; take one by name: load_factor"):
        found.order


def test_the_value_of_a_finer_scene_lies_within_the_error():
    """The energy of a bracket with a re-entrant corner; its value at a spacing four times finer stands for the limit."""
    def build(length):
        model = bempd.Model()
        steel = model.add_material(young_modulus=2e11, poisson_ratio=0.3)
        bar = model.add_bem_region(steel, [(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)], element_length=length)
        model.fix_edge(bar, 1)
        model.add_traction(bar, 5, "x", 1e6)
        return model.step(1).stored_energy

    coarse = bempd.converge(build, [0.5, 0.25, 0.125], quiet=True)
    fine = build(0.03125)
    assert abs(fine - coarse.only.values[-1]) <= coarse.error and abs(fine - coarse.extrapolated) < abs(fine - coarse.only.values[-1])


@pytest.mark.parametrize("build, spacings, words", [
    (lambda h: h, [1], "two or more lengths above 0"), (lambda h: h, [1, -1], "above 0"), (lambda h: h, 3, "two or more"),
    (lambda h: h, [1, 0.95], "too near each other"), (lambda h: math.nan, [2, 1], r"build\(2\) returned nan for 'value'"),
    (lambda h: "a", [2, 1], "returned str for 'value'"), (lambda h: None, [2, 1], "returned NoneType"),
    (lambda h: {}, [2, 1], "returned no number"), (lambda h: {str(h): 1.0}, [2, 1], "the same names at every spacing"),
    (3, [2, 1], "build is 3"), (lambda h: bempd.Model(), [2, 1], "returned Model for 'value'"),
])
def test_what_cannot_be_compared_is_refused(build, spacings, words):
    with pytest.raises(bempd.ArgumentError, match=words):
        bempd.converge(build, spacings, quiet=True)


def test_an_order_is_a_number_above_0():
    with pytest.raises(bempd.ArgumentError, match="order is 0"):
        bempd.converge(lambda h: h, [2, 1], order=0)
