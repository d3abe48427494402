"""Edges as hosts see them: nodes and forces, values at nodes and places, states with the values of loads and supports."""

import bempd
import numpy as np
import pytest
from conftest import make_plate, make_strip


def test_forces_sum_to_the_reaction_and_do_the_work(strip):
    model = strip.model
    work, last = 0.0, {}
    for step in range(1, 4):
        report = model.step(10 * step)
        for region, edge in ((strip.left, 4), (strip.right, 2)):
            nodes, forces = model.edge_nodes(region, edge).nodes, model.edge_forces(region, edge)
            moved = model.field(region, "displacement")[nodes]
            before, from_where = last.get(region, (np.zeros_like(forces), np.zeros_like(moved)))
            work += 0.5 * np.sum((before + forces) * (moved - from_where))
            last[region] = forces, moved
    assert report.total_events == 0
    assert work == pytest.approx(report.work, rel=1e-11)
    reaction = model.reaction(strip.pulled)
    np.testing.assert_allclose(last[strip.right][0].sum(axis=0), reaction, atol=1e-12 * abs(reaction).max())


def test_forces_on_both_sides_of_an_interface_balance(strip):
    model = strip.model
    model.run_to_separation(60)
    one, other = model.edge_forces(strip.left, 2), model.edge_forces(strip.middle, 4)
    np.testing.assert_allclose(one, -other[::-1], atol=1e-10 * abs(one).max())
    np.testing.assert_allclose(one.sum(axis=0), -model.reaction(strip.held), atol=1e-10 * abs(one).sum())


@pytest.mark.parametrize("pressed", ["crack", "torn edge"])
def test_interfaces_balance_where_loads_come_and_go(pressed):
    """A fluid in a crack beside the interface pushes its nodes; a piece that is torn off has lost its load."""
    model = bempd.Model()
    glass = model.add_material(young_modulus=1000, poisson_ratio=1 / 4, fracture_energy=1)
    left = model.add_bem_region(glass, bempd.rectangle(0, 0, 10, 8), element_length=2)
    strip = model.add_pd_region(glass, bempd.rectangle(10, 0, 20, 8), spacing=1, horizon_ratio=3)
    held = model.fix_edge(left, 4)
    if pressed == "crack":
        crack = model.add_crack([(10.5, 0), (10.5, 5.5)])
        model.add_crack_pressure(crack, 0.5)
        model.fix_edge(strip, 2)
    else:
        model.remove_support(held)
        model.fix_edge(strip, 2)
        model.add_crack([(10.5, 0), (10.5, 8)])
        model.add_traction(left, 3, "x", 0.1)
    report = model.step(1)
    one, other = model.edge_forces(left, 2), model.edge_forces(strip, 4)
    np.testing.assert_allclose(one, -other[::-1], atol=1e-12)
    if pressed == "crack":
        np.testing.assert_allclose(one.sum(axis=0), -model.reaction(held), atol=1e-12)
        assert abs(one).max() > 0.1
    else:
        assert report.fragments == 1 and abs(one).max() < 1e-12


def test_interfaces_balance_where_a_step_has_stopped_on_its_way():
    """Loads are those of the way there, not those that the host has set for its end."""
    strip = make_strip()
    model = strip.model
    load = model.add_traction(strip.middle, 3, "y", constant=0)
    model.set_load_values(load, constant=-2e5)
    model.set_support_values(strip.pulled, constant=2e-4)
    report = model.step_to_values(1.0, until="event")
    assert report.stop_reason == bempd.StopReason.EVENT and 0.1 < report.load_factor < 0.9
    scale = abs(model.reaction(strip.pulled)[0])
    total = 0.005 * 0.02 * -2e5 * report.load_factor
    for region, own, other in ((strip.left, 2, 4), (strip.right, 4, 2)):
        one, middle = model.edge_forces(region, own), model.edge_forces(strip.middle, other)
        np.testing.assert_allclose(one, -middle[::-1], atol=1e-11 * scale)
        total += middle.sum(axis=0)[1]
    assert abs(total) < 1e-11 * scale


def test_nodes_lie_in_order_with_their_weights(strip):
    model = strip.model
    for region, edge in ((strip.left, 3), (strip.middle, 1), (strip.right, 2)):
        found = model.edge_nodes(region, edge)
        assert found.fractions[0] == 0 and found.fractions[-1] == 1 and (np.diff(found.fractions) > 0).all()
        assert found.weights.sum() == pytest.approx(0.02, rel=1e-12)
        places = model.field(region, "position")[found.nodes]
        on_edge = model.fractions_on_edge(region, edge, places)
        np.testing.assert_allclose(on_edge.fractions, found.fractions, atol=1e-12)
        assert on_edge.distances.max() < 1e-15
        elements = model.elements(region)[model.edge_elements(region, edge)]
        assert set(found.nodes) <= set(elements.ravel()) and len(elements) >= (len(found.nodes) - 1) / 2


@pytest.mark.parametrize("kind", ["bem", "pd"])
def test_forces_on_round_edges_are_those_of_constant_stress(kind):
    """A disc that is blown up evenly: what acts through each quarter is the stress on the section between its ends."""
    model = bempd.Model()
    glass = model.add_material(young_modulus=3e9, poisson_ratio=1 / 3, thickness=0.01)
    if kind == "bem":
        disc = model.add_bem_disc(glass, (0, 0), 0.1, 0.02)
    else:
        disc = model.add_pd_region(glass, [(0.1, 0), (0, 0.1), (-0.1, 0), (0, -0.1)], spacing=0.01)
        for edge in range(1, 5):
            angle = np.pi / 4 * (2 * edge - 1)
            model.set_edge_arc(disc, edge, (0.1 * np.cos(angle), 0.1 * np.sin(angle)))
    supports = [model.fix_edge(disc, edge) for edge in range(1, 5)]
    position = model.copy_field(disc, "position")
    for edge in range(1, 5):
        nodes = model.edge_nodes(disc, edge)
        angles = np.pi / 2 * (edge - 1 + nodes.fractions)
        places = 0.1 * np.column_stack([np.cos(angles), np.sin(angles)])
        np.testing.assert_allclose(position[nodes.nodes], places, atol=1e-6 if kind == "bem" else 1e-3)
        assert nodes.weights.sum() == pytest.approx(0.05 * np.pi, rel=1e-9 if kind == "bem" else 2e-2)
    for edge, support in enumerate(supports, 1):
        model.set_support_nodal_values(support, constant=1e-4 * position[model.edge_nodes(disc, edge).nodes])
    model.step(1)
    stress = 3e9 / (1 - 1 / 3) * 1e-4
    for edge, direction in enumerate([(1, 1), (-1, 1), (-1, -1), (1, -1)], 1):
        total = model.edge_forces(disc, edge).sum(axis=0)
        np.testing.assert_allclose(total, stress * 0.01 * 0.1 * np.array(direction), rtol=1e-6 if kind == "bem" else 1e-9)
        np.testing.assert_allclose(total, model.edge_reaction(disc, edge).force, rtol=1e-12)


def test_values_at_nodes_and_places(strip):
    model = strip.model
    edge = model.edge_nodes(strip.right, 2)
    driven = 1e-5 * np.column_stack([1 + edge.fractions, np.zeros_like(edge.fractions)])
    model.set_support_nodal_values(strip.pulled, constant=driven)
    model.step(1)
    np.testing.assert_array_equal(model.field(strip.right, "displacement")[edge.nodes, 0], driven[:, 0])
    model.set_support_values_at(strip.pulled, [0, 1], constant=[(1e-5, 0), (2e-5, 0)])
    model.step_to_values(2)
    np.testing.assert_allclose(model.field(strip.right, "displacement")[edge.nodes, 0], driven[:, 0], rtol=1e-14)
    model.set_support_values(strip.pulled, 0.0)


def test_forces_on_nodes_are_those_of_a_traction(plate):
    load = plate.model.add_edge_forces(plate.plate, 2)
    weights = plate.model.edge_nodes(plate.plate, 2).weights
    with pytest.raises(bempd.OrderError):
        plate.model.add_edge_forces(plate.plate, 3)
    plate.model.set_load_nodal_values(load, 1e6 * np.column_stack([weights, 0 * weights]))
    plate.model.step(1)
    other = make_plate()
    other.model.add_traction(other.plate, 2, "x", 1e6)
    other.model.step(1)
    expected = other.model.field(other.plate, "displacement")
    np.testing.assert_allclose(plate.model.field(plate.plate, "displacement"), expected, atol=1e-12 * abs(expected).max())
    plate.model.set_load_values_at(load, [0.0], constant=[(0, 0)])
    assert abs(plate.model.field(plate.plate, "displacement")).max() == 0


def test_states_contain_values_if_asked(strip):
    model = strip.model
    model.set_support_values(strip.pulled, constant=1e-5)
    model.step(1)
    force = model.reaction(strip.pulled)
    with_values, without = model.save(values=True), model.save()
    model.set_support_values(strip.pulled, constant=3e-5)
    for state, expected in ((without, 3 * force), (with_values, force),
                            (bempd.State.from_bytes(with_values.to_bytes()), force)):
        model.restore(state)
        np.testing.assert_allclose(model.reaction(strip.pulled), expected, atol=1e-9 * abs(force).max())


def test_a_checkpoint_is_a_file_to_resume_from(strip, tmp_path):
    model, file = strip.model, tmp_path / "strip.state"
    model.run_to_separation(60)
    model.set_support_values(strip.pulled, constant=1e-5)
    model.checkpoint(file)
    assert bempd.State.read(file) == model.save(values=True) and list(tmp_path.iterdir()) == [file]
    other = make_strip()
    other.model.resume(file)
    for one in (strip, other):
        one.model.step(80)
    assert other.model.history().tobytes() == model.history().tobytes()
    with pytest.raises(bempd.FileError, match="cannot read .*nothing.state"):
        model.resume(tmp_path / "nothing.state")
    with pytest.raises(bempd.FileError, match="no_such_folder"):
        model.checkpoint(tmp_path / "no_such_folder" / "a.state")
    file.write_bytes(file.read_bytes()[:100])
    with pytest.raises(bempd.ArgumentError, match="damaged|early"):
        model.resume(file)


def test_what_does_not_fit_is_refused():
    strip = make_strip()
    model = strip.model
    with pytest.raises(bempd.ArgumentError, match="3 nodes|nodes, and there are values for 1"):
        model.set_support_nodal_values(strip.pulled, constant=[(0, 0)])
    with pytest.raises(bempd.ArgumentError, match="set_support_values_at: fractions have the shape"):
        model.set_support_values_at(strip.pulled, [0, 1], constant=[(0, 0)])
    with pytest.raises(bempd.ArgumentError, match="values have the shape none"):
        model.set_support_values_at(strip.pulled, [0])
    with pytest.raises(bempd.ArgumentError, match="order along the part"):
        model.set_support_values_at(strip.pulled, [1, 0], constant=[(0, 0), (0, 0)])
    with pytest.raises(bempd.ArgumentError, match="neither held"):
        model.edge_forces(strip.middle, 1)
    with pytest.raises(bempd.ArgumentError, match="edge 9 does not exist"):
        model.edge_nodes(strip.middle, 9)


def test_sides_of_the_box_are_edges_where_nothing_has_their_name():
    model = bempd.Model()
    glass = model.add_material(young_modulus=3e9, poisson_ratio=1 / 3)
    bracket = model.add_bem_region(glass, [(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)], element_length=0.25)
    for side, edge in (("bottom", 1), ("right", 2), ("top", 5), ("left", 6)):
        held = model.fix_edge(bracket, side)
        assert model._sketch.supports[held].edge == edge
    model.name_edge(bracket, 3, "left")
    assert model._sketch.supports[model.fix_edge(bracket, "left", "x")].edge == 3
    disc = model.add_bem_disc(glass, (5, 0), 1, 0.5)
    with pytest.raises(bempd.ArgumentError, match="no edge of region 2 has the name 'left'"):
        model.fix_edge(disc, "left")
