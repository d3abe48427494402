"""What a model says of itself: in words, as a picture, to help(), to type checkers; and that it is not pickled."""

import copy
import inspect
import pickle
import re
import typing

import bempd
import pytest
from bempd import _names, _scene, rectangle
from bempd._help import function_behind


def test_repr_says_what_is_in_it(strip):
    assert repr(bempd.Model()) == "<bempd.Model: 0 materials, 0 regions, 0 cracks, 0 supports, 0 loads; load factor 0>"
    assert repr(strip.model) == ("<bempd.Model: 1 material, 3 regions (2 BEM, 1 PD), 1 crack, 2 supports, 0 loads; "
                                 "load factor 0>")
    report = strip.model.run_to_separation(1e4)
    assert repr(strip.model).endswith(f"load factor {report.load_factor:.6g}, {report.total_broken_bonds} bonds broken>")
    strip.model.close()
    assert repr(strip.model) == "<bempd.Model: closed>"


def test_html_has_the_picture_of_the_scene():
    model = bempd.Model()
    glass = model.add_material(young_modulus=3e9, poisson_ratio=1 / 3)
    plate = model.add_bem_region(glass, rectangle(0, 0, 4, 2), element_length=1)
    model.add_circular_hole(plate, (2, 1), 0.5)
    model.set_edge_arc(plate, 2, (4.5, 1))
    disc = model.add_bem_disc(glass, (8, 1), 1, 0.5)
    model.add_crack([(0.5, 1), (1, 1)])
    held, load = model.fix_edge(plate, 4), model.add_traction(plate, 2, "x", 1)
    model.fix_point((8, 2))
    page = model._repr_html_()
    assert page.count("<svg") == 1 and page.count("fill-rule") == 2
    for title in (f"region {plate} (BEM)", f"region {disc} (BEM)", "crack 1", f"support {held}: x and y held",
                  f"load {load}: traction along x"):
        assert f"<title>{title}</title>" in page
    # Edges have their numbers, the scene its size, and a table tells where supports and loads are and what they do.
    assert [f">{edge}</text>" in page for edge in range(1, 9)] == [True] * 8
    assert re.search(r">9 x 2, from \(0, 0\) to \(9, 2\)</text>", page)
    for row in (("support 1", "edge 4 of region 1", "x and y held"), ("support 2", "point (8, 2)", "x and y held"),
                ("load 1", "edge 2 of region 1", "traction along x")):
        assert "<tr>" + "".join(f"<td>{cell}</td>" for cell in row) + "</tr>" in page
    # The hole is a second loop, of many pieces; nothing was prepared.
    outline = re.search(r'd="([^"]*)" fill="#e3e5e8"', page)[1]
    assert outline.count("Z") == 2 and outline.count("L") > 60
    model.remove_load(load)
    model.add_hole(plate, [(0.2, 0.2), (0.2, 0.4), (0.4, 0.4), (0.4, 0.2)])
    assert f"<title>load {load}:" not in model._repr_html_()
    model.name_edge(plate, 4, "clamp")
    assert ">clamp</text>" in model._repr_html_() and "edge 4 (&quot;clamp&quot;) of region 1" in model._repr_html_()
    assert "<svg" not in bempd.Model()._repr_html_()


def test_pickling_is_refused_with_a_way_out(strip):
    for attempt in (pickle.dumps, copy.copy, copy.deepcopy):
        with pytest.raises(TypeError, match="cannot be pickled or copied.*save().*bempd.State"):
            attempt(strip.model)
    strip.model.prepare()
    assert pickle.loads(pickle.dumps(strip.model.save())) == strip.model.save()


@pytest.mark.parametrize("alias, words", [
    ("Component", _scene.ONE_COMPONENT), ("Components", _scene.COMPONENTS), ("Plane", _scene.PLANES),
    ("Turn", _scene.TURNS), ("FaceComponent", _scene.FACE_COMPONENTS)])
def test_names_are_those_of_the_arguments(alias, words):
    assert set(typing.get_args(getattr(_names, alias))) == set(words)


def test_names_of_fields_quantities_faces_and_goals():
    from bempd import _drawing, _results, model

    assert set(typing.get_args(_names.FieldName)) == set(_results.FIELDS)
    assert set(typing.get_args(_names.Face)) == set(_results.FACES)
    assert set(typing.get_args(_names.Until)) == set(model.UNTIL)
    assert set(typing.get_args(_names.Quantity)) == {*_drawing.QUANTITIES, *_drawing.SHORT}


def documented():
    """Public classes and functions with their public methods, and the documentation of each."""
    for name, thing in inspect.getmembers(bempd):
        if name.startswith("_") or inspect.ismodule(thing) or not callable(thing):
            continue
        yield name, inspect.getdoc(thing) or ""
        for part, member in inspect.getmembers(thing) if inspect.isclass(thing) else ():
            if not part.startswith("_") and (inspect.isfunction(member) or isinstance(member, property)):
                yield f"{name}.{part}", inspect.getdoc(member) or ""


def test_help_has_units_shapes_and_errors():
    text = inspect.getdoc(bempd.Model.add_traction)
    assert "[Pa]" in text and "Arguments:\n    region " in text and "Raises a bempd.Error" in text
    assert "stress: shape (n, 3), xx, yy, xy [Pa]" in inspect.getdoc(bempd.Model.evaluate)
    assert "Where supports share a node's" in inspect.getdoc(bempd.Model.reaction)
    without = [name for name, text in documented() if not text]
    assert not without, without


def test_help_speaks_of_python():
    checked = 0
    for name, text in documented():
        assert not re.search(r"\bNULL\b|struct_size|\bcapacity\b|\bbuffer:|zero-terminated|free it with|exception\(|\[in\]|\[out\]|"
                             r"BEMPD_(?!LIBRARY)|shape \[", text), (name, text)
        for owner, part in re.findall(r"\b(Model|State)\.(\w+)", text):
            assert hasattr(getattr(bempd, owner), part), f"{name} speaks of {owner}.{part}, which does not exist"
            checked += 1
        for part in re.findall(r"\bbempd\.([A-Z]\w+)", text):
            assert hasattr(bempd, part), f"{name} speaks of bempd.{part}"
    assert checked > 40


# Places are pairs here, arrays bring their counts, and a callback comes before the component, which may be left out.
ALSO = {"point": "x", "centre": "x", "about": "x", "crack": "crack", "name": "field", "out": "values", "points": "points"}
LEFT_OUT = {"prescribe_edge_function"}


def test_arguments_come_in_the_order_of_c():
    from bempd._cdef import CDEF

    checked = 0
    for name, method in inspect.getmembers(bempd.Model, inspect.isfunction):
        function = "" if name.startswith("_") else function_behind("Model", name)
        declared = re.search(rf"{function}\((.*?)\);", CDEF, re.DOTALL) if function else None
        if not declared or name in LEFT_OUT:
            continue
        order = [re.search(r"(\w+)\s*$", part)[1] for part in declared[1].replace("\n", " ").split(",")]
        given = [ALSO.get(one.name, one.name) for one in inspect.signature(method).parameters.values()
                 if one.kind is one.POSITIONAL_OR_KEYWORD and one.name != "self"]
        places = [order.index(one) for one in given if one in order]
        assert places == sorted(places), (name, given, order)
        checked += 1
    assert checked > 40


def test_reports_and_tips_are_tables(strip):
    report = strip.model.step_to_next_event(1e4)
    text = str(bempd.table(report))
    assert re.search(r"^stop reason +EVENT$", text, re.MULTILINE) and re.search(r"^separated +no$", text, re.MULTILINE)
    assert "<td>broken bonds</td>" in report._repr_html_()
    tips = strip.model.tips()
    assert isinstance(tips, list) and tips and "<th>K_I [Pa m^1/2]</th>" in tips._repr_html_()
    assert str(bempd.table(tips)).splitlines()[0].split()[:3] == ["crack", "end", "x"]
    assert str(bempd.table(tips, ["crack", "x"])).splitlines()[1].split()[0] == "1"
    assert "none" in bempd.Model().extensions()._repr_html_() and str(bempd.table([])) == "none"
    with pytest.raises(bempd.ArgumentError, match="CrackTip has no 'K1'; it has crack, end"):
        bempd.table(tips, ["K1"])
    with pytest.raises(bempd.ArgumentError, match="the list has a int"):
        bempd.table([3])
