"""What is added arrives, in whatever form it was given."""

import bempd
import numpy as np
import pytest
from bempd import rectangle
from conftest import make_plate


def tip(model, plate):
    model.step(1)
    return model.evaluate([(2, 0.5)]).displacement[0]


def test_the_plate_stretches_as_hooke_says(plate):
    plate.model.add_traction(plate.plate, 2, "x", 2e8)
    ux, uy = tip(plate.model, plate.plate)
    assert ux == pytest.approx(2e8 / 2e11 * 2, rel=1e-10)
    assert uy == pytest.approx(-0.3 * 2e8 / 2e11 * 0.5, rel=1e-9)
    assert plate.model.reaction(plate.held[0])[0] == pytest.approx(-2e8, rel=1e-9)


def test_pressure_pulls_where_it_is_negative_and_supports_have_moments(plate):
    with pytest.raises(bempd.ArgumentError, match="add_pressure: "):
        plate.model.add_pressure(plate.plate, 2, [1, float("nan")])
    plate.model.add_pressure(plate.plate, 2, -2e8)
    assert tip(plate.model, plate.plate)[0] == pytest.approx(2e8 / 2e11 * 2, rel=1e-10)
    force = plate.model.reaction(plate.held[0])[0]
    assert plate.model.reaction_moment(plate.held[0]) == pytest.approx(-0.5 * force, rel=1e-9)
    assert plate.model.reaction_moment(plate.held[0], (7, 0.5)) == pytest.approx(0, abs=1e-6 * abs(force))
    with pytest.raises(bempd.ArgumentError, match="reaction_moment: about"):
        plate.model.reaction_moment(plate.held[0], (1, 2, 3))


def test_edges_that_share_a_corner_have_what_their_supports_have():
    model = bempd.Model()
    material = model.add_material(young_modulus=1, poisson_ratio=0.3)
    region = model.add_bem_region(material, rectangle(0, 0, 2, 1), 0.25)
    supports = [model.fix_edge(region, edge) for edge in (1, 4)]
    model.add_traction(region, 3, "y", -1)
    model.step(1)
    edges = [model.edge_reaction(region, edge, (0.5, 0.2)) for edge in (1, 4)]
    assert sum(edge.force for edge in edges) == pytest.approx(sum(map(model.reaction, supports)), abs=1e-12)
    assert sum(edge.force[1] for edge in edges) == pytest.approx(2, rel=1e-9)
    assert sum(edge.moment for edge in edges) == pytest.approx(
        sum(model.reaction_moment(support, (0.5, 0.2)) for support in supports), abs=1e-12)
    with pytest.raises(bempd.ArgumentError, match="edge_reaction: no support holds edge 2"):
        model.edge_reaction(region, 2)


def test_an_interface_has_two_sides_and_singular_ends():
    model = bempd.Model()
    soft, stiff = (model.add_material(young_modulus=modulus, poisson_ratio=0.3) for modulus in (1, 3))
    lower = model.add_bem_region(soft, rectangle(0, 0, 2, 1), 0.25)
    upper = model.add_bem_region(stiff, rectangle(0, 1, 2, 2), 0.25)
    for region in (lower, upper):
        model.fix_edge(region, 4, "x")
        model.prescribe_edge(region, 2, "x", 2)
    model.fix_point((0, 0), "y")
    model.step(1)
    assert model.evaluate_in(lower, [(1, 1)]).stress[0, 0] == pytest.approx(1, abs=1e-7)
    assert model.evaluate_in(upper, [(1, 1)], face="right").stress[0, 0] == pytest.approx(3, abs=1e-7)
    assert model.evaluate_in(upper, [(1, 1)], stress=False).stress is None
    with pytest.raises(bempd.ArgumentError, match="outside region 2"):
        model.evaluate_in(upper, [(1, 0.5)])
    with pytest.raises(bempd.ArgumentError, match="evaluate_in: face"):
        model.evaluate_in(upper, [(1, 1)], face="top")
    places = {(place.x, place.y): place for place in model.singularities()}
    assert places[(0, 0)].kind == bempd.SingularityKind.POINT
    orders = model.field(lower, "stress_order")
    assert orders.shape == (model.node_count(lower),) and orders.max() == 1


def test_constant_and_proportional_parts(plate):
    load = plate.model.add_traction(plate.plate, 2, "x", 1e8, constant=[1e8, 1e8, 1e8])
    assert tip(plate.model, plate.plate)[0] == pytest.approx(2e-3, rel=1e-9)
    plate.model.set_load_values(load, [2e8, 2e8, 2e8])
    plate.model.step(1)
    assert plate.model.evaluate([(2, 0.5)]).displacement[0, 0] == pytest.approx(2e-3, rel=1e-9)
    with pytest.raises(bempd.ArgumentError, match="set_load_values: "):
        plate.model.set_load_values(load, [1, 2])


def test_a_support_gets_new_values():
    scene = make_plate()
    pulled = scene.model.prescribe_edge(scene.plate, 2, "x", constant=1e-3)
    scene.model.step(0)
    assert scene.model.reaction(pulled)[0] == pytest.approx(1e8, rel=1e-9)
    scene.model.set_support_values(pulled, constant=3e-3)
    scene.model.step(0)
    assert scene.model.reaction(pulled)[0] == pytest.approx(3e8, rel=1e-9)


def test_functions_are_the_same_as_values():
    by_values, by_function, by_pairs = make_plate(), make_plate(), make_plate()
    by_values.model.add_traction(by_values.plate, 2, "y", [0, 1e7])
    by_function.model.add_traction_function(by_function.plate, 2, lambda x, y: (0, 1e7 * y))
    by_pairs.model.add_traction_function(by_pairs.plate, 2, lambda x, y: ((0, 1e7 * y), (0, 0)))
    expected = tip(by_values.model, by_values.plate)
    for scene in (by_function, by_pairs):
        np.testing.assert_allclose(tip(scene.model, scene.plate), expected, rtol=1e-12)


def test_displacements_by_function_and_at_points():
    scene = make_plate()
    scene.model.prescribe_edge_function(scene.plate, 2, lambda x, y: np.array([1e-3, 0]), "x", part=(0, 1))
    ux, _ = tip(scene.model, scene.plate)
    assert ux == pytest.approx(1e-3, rel=1e-9)
    other = make_plate()
    point = other.model.prescribe_point((2, 1), "x", 1e-3)
    other.model.add_point_force((2, 0), "y", 5.0, constant=1.0)
    other.model.step(1)
    assert other.model.evaluate([(2, 1)]).displacement[0, 0] == pytest.approx(1e-3)
    assert other.model.reaction(other.held[1])[1] == pytest.approx(-6, rel=1e-6)
    assert other.model.reaction(point)[0] == pytest.approx(-other.model.reaction(other.held[0])[0], rel=1e-6)


VERTICES = [(0, 0), (2, 0), (2, 1), (0, 1)]


@pytest.mark.parametrize("vertices", [
    VERTICES,
    tuple(VERTICES),
    np.array(VERTICES, dtype=np.int8),
    np.array(VERTICES, dtype=np.float32),
    np.array(VERTICES, dtype=">f8"),
    np.array(VERTICES, dtype=np.longdouble),
    np.asfortranarray(np.array(VERTICES, dtype=float)),
    np.repeat(np.array(VERTICES, dtype=float), 2, axis=0)[::2],
    np.array(VERTICES[::-1], dtype=float)[::-1],
    memoryview(np.array(VERTICES, dtype=float)),
], ids=["list", "tuple", "int8", "float32", "big endian", "long double", "Fortran order", "strided", "reversed",
        "memoryview"])
def test_arrays_of_any_type_and_order_mean_the_same(vertices):
    model = bempd.Model()
    region = model.add_bem_region(model.add_material(young_modulus=1, poisson_ratio=0), vertices, 0.5)
    model.fix_edge(region, 4)
    corners = model.field(region, "position")[model.elements(region)[:, 0]]
    for vertex in VERTICES:
        assert (corners == vertex).all(axis=1).any()


def test_holes_edges_and_meshes():
    model = bempd.Model(options={"bem.grading": "none"})
    region = model.add_bem_region(model.add_material(young_modulus=1, poisson_ratio=0, plane="strain"),
                                  rectangle(0, 0, 3, 3), 1.0)
    assert model.region_count == 1 and model.edge_count(region) == 4
    assert model.add_hole(region, [(1, 1), (1, 2), (2, 2), (2, 1)]) == 5
    assert model.edge_count(region) == 8
    model.set_edge_mesh(region, 1, 0.5, grading=1.5)
    model.fix_edge(region, 4)
    assert len(model.elements(region)) == 3 * 3 + 6 + 4
    assert model.elements(region).shape[1] == 3 and model.node_count(region) == len(model.field(region, "position"))


def test_options_are_a_mapping(plate):
    options = plate.model.options
    assert options["tips.record"] == 0 and isinstance(options["tips.record"], int)
    options["tips.record"] = 3
    options.update({"critical_stretch": "printed", "crack.tie_share": 0})
    assert plate.model.options["tips.record"] == 3 and options["critical_stretch"] == "printed"
    del options["critical_stretch"]
    assert options["critical_stretch"] == "exact"
    assert set(options) == set(bempd.describe_options()) and len(options) == len(list(options))
    info = options.describe("crack.tie_share")
    assert (info.default, info.minimum, info.maximum, info.choices, info.unit) == (0, 0, 1e9, (), "-")
    assert options.describe("critical_stretch").choices == ("exact", "running", "printed") and info.summary
    assert bempd.Model(options={"threads": 1}).options["threads"] == 1


def test_wrong_options_are_explained(plate):
    options = plate.model.options
    for use in (lambda: options["tips.recrod"], lambda: options.describe("tips.recrod")):
        with pytest.raises(KeyError, match="^options: .*'tips.recrod'; near names are tips.record"):
            use()
    with pytest.raises(bempd.UnknownOptionError):
        options["tips.recrod"] = 3
    assert "tips.recrod" not in options and options.get("tips.recrod", 7) == 7
    with pytest.raises(bempd.ArgumentError, match="options: option crack.exponent is 101") as caught:
        options["crack.exponent"] = 101
    assert not isinstance(caught.value, KeyError)
    with pytest.raises(bempd.ArgumentError, match="must be one of: symmetric"):
        options["scheme"] = "fast"
    with pytest.raises(bempd.ArgumentError, match="takes a word"):
        options["scheme"] = 3
    with pytest.raises(bempd.ArgumentError, match="option threads is None"):
        options["threads"] = None


def test_curved_edges():
    model = bempd.Model()
    material = model.add_material(young_modulus=1, poisson_ratio=0.3)
    region = model.add_bem_region(material, rectangle(-2, -2, 2, 2), 1.0)
    assert model.add_circular_hole(region, (0, 0), 1) == 5
    assert model.edge_count(region) == 8
    model.set_edge_arc(region, 3, (0, 2.5))
    model.fix_edge(region, 1)
    corners = model.field(region, "position")
    assert np.hypot(*corners.T).min() == pytest.approx(1, abs=1e-14)
    assert corners[:, 1].max() == pytest.approx(2.5, abs=1e-14)
    with pytest.raises(bempd.ArgumentError, match="set_edge_arc"):
        bempd.Model().set_edge_arc(1, 1, (0, 0))

    about = bempd.Model()
    material = about.add_material(young_modulus=1, poisson_ratio=0.3)
    disc = about.add_bem_disc(material, (1, 2), 0.5, 0.2)
    square = about.add_bem_region(material, rectangle(3, 0, 4, 1), 0.25)
    about.set_edge_arc_about(square, 2, (4, 0.5), 0.5, "counter-clockwise")
    with pytest.raises(bempd.ArgumentError, match="begins 0.5 and ends 0.5 from the centre"):
        about.set_edge_arc_about(square, 2, (4, 0.5), 0.6, "clockwise")
    with pytest.raises(bempd.ArgumentError, match="set_edge_arc_about: turn"):
        about.set_edge_arc_about(square, 2, (4, 0.5), 0.5, "left")
    about.fix_edge(disc, 1)
    about.fix_edge(square, 4)
    # A spiral whose edges have chords that cross.
    spiral = [(6, 0), (8, 0), (6, 1), (8, 1)]
    with pytest.raises(bempd.ArgumentError, match="add_bem_region: edges 2 and 4 of the outline cross.*bulges"):
        about.add_bem_region(material, spiral, 0.2)
    with pytest.raises(bempd.ArgumentError, match=r"add_bem_region: bulges has the shape \(3,\); give one number for each"):
        about.add_bem_region(material, spiral, 0.2, bulges=[0, 1, 0])
    turned = about.add_bem_region(material, spiral, 0.2, bulges=[0, np.tan(3 * np.pi / 8), 0, 0])
    edge = about.add_hole(turned, [(7.2, 2), (7.5, 2), (7.8, 2)], bulges=[0, 0, -1])
    about.fix_edge(turned, 1)
    on_edges = about.field(turned, "position")
    assert edge == 5 and np.hypot(*(on_edges - (7.5, 1.5)).T).max() == pytest.approx(np.hypot(1.5, 1.5))
    assert np.hypot(*(about.field(disc, "position") - (1, 2)).T) == pytest.approx(0.5, abs=1e-14)
    assert about.field(square, "position")[:, 0].max() == pytest.approx(4.5, abs=1e-14)

    rounded = bempd.Model()
    corners = [(np.cos(t), np.sin(t)) for t in np.linspace(0, 2 * np.pi, 8, endpoint=False)]
    disk = rounded.add_bem_region(rounded.add_material(young_modulus=1, poisson_ratio=0.3), corners, 0.5)
    rounded.set_edges_smooth(disk, 1, 8)
    rounded.fix_edge(disk, 1)
    assert np.hypot(*rounded.field(disk, "position").T) == pytest.approx(1, abs=1e-12)


def test_what_is_removed_leaves_no_trace(plate):
    model = plate.model
    spare = model.add_bem_region(1, rectangle(10, 0, 12, 1), 0.5)
    support = model.fix_edge(spare, 4)
    load = model.add_traction(plate.plate, 2, "y", 1e9)
    model.add_traction(plate.plate, 2, "x", 2e8)
    with pytest.raises(bempd.ArgumentError, match="remove_region: .*support"):
        model.remove_region(spare)
    model.remove_support(support)
    model.remove_region(spare)
    model.remove_load(load)
    assert model.region_ids == [plate.plate]
    with pytest.raises(bempd.ArgumentError, match="remove_crack: .*does not exist"):
        model.remove_crack(1)
    assert tip(model, plate.plate)[0] == pytest.approx(2e8 / 2e11 * 2, rel=1e-10)
    with pytest.raises(bempd.OrderError):
        model.remove_support(plate.held[0])


@pytest.mark.parametrize("plane, share", [("stress", 1.0), ("strain", 1 - 0.3**2)])
def test_a_toughness_is_a_fracture_energy(plane, share):
    def load_of_growth(**resistance):
        model = bempd.Model()
        steel = model.add_material(young_modulus=210e9, poisson_ratio=0.3, plane=plane, **resistance)
        body = model.add_body(steel, rectangle(0, 0, 0.1, 0.04))
        model.add_crack([(0.05, 0), (0.05, 0.01)])
        model.fix_edge(body, "left")
        model.prescribe_edge(body, "right", "x", 1e-6)
        model.step(1)
        return model.tips()[0].critical_load_factor

    assert load_of_growth(toughness=46e6) == pytest.approx(load_of_growth(fracture_energy=46e6**2 * share / 210e9), rel=1e-12)
    with pytest.raises(bempd.ArgumentError, match="both given"):
        load_of_growth(toughness=46e6, fracture_energy=1e4)
    with pytest.raises(bempd.ArgumentError, match="K_IC must be positive"):
        load_of_growth(toughness=0)
    with pytest.raises(bempd.ArgumentError, match="young_modulus"):
        bempd.Model().add_material(young_modulus=0, poisson_ratio=0.3, toughness=46e6)


def test_reasons_are_printed_by_name():
    assert f"{bempd.StopReason.SEPARATED}" == str(bempd.StopReason.SEPARATED) == "SEPARATED"
    assert f"{bempd.StopReason.SEPARATED:d} {bempd.StopReason.SEPARATED:>10}" == "3  SEPARATED" and bempd.StopReason.SEPARATED == 3
