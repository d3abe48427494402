//! Edges as hosts see them: nodes and forces, values at nodes and places, states with values.

use crate::common::{block, plate};
use bempd::{Field, NodalValues, Until, Values};

fn sum(forces: &[[f64; 2]]) -> [f64; 2] {
    forces.iter().fold([0.0; 2], |sum, force| [sum[0] + force[0], sum[1] + force[1]])
}

#[test]
fn forces_sum_to_the_reaction_and_balance_across_interfaces() {
    let mut plate = plate();
    plate.model.step(1.2).unwrap();
    let reaction = plate.model.reaction(plate.pulled_right).unwrap();
    let pulled = sum(&plate.model.edge_forces(plate.right, 2).unwrap());
    assert!(reaction[0] > 0.1 && (pulled[0] - reaction[0]).abs() < 1e-12 * reaction[0]);
    let (one, other) =
        (plate.model.edge_forces(plate.strip, 2).unwrap(), plate.model.edge_forces(plate.right, 4).unwrap());
    assert_eq!(one.len(), other.len());
    for (force, opposite) in one.iter().zip(other.iter().rev()) {
        assert!((force[0] + opposite[0]).abs() < 1e-10 * reaction[0]);
    }
    assert!((sum(&other)[0] + reaction[0]).abs() < 1e-10 * reaction[0]);
    assert_fails!(plate.model.edge_forces(plate.strip, 1), Argument, "neither held");
}

#[test]
fn nodes_have_weights_and_values() {
    let mut plate = plate();
    let nodes = plate.model.edge_nodes(plate.right, 2).unwrap();
    let weight: f64 = nodes.iter().map(|node| node.weight).sum();
    assert!((weight - 8.0).abs() < 1e-12 && nodes[0].fraction == 0.0);
    assert!(!plate.model.edge_elements(plate.right, 2).unwrap().is_empty());
    let given: Vec<[f64; 2]> = nodes.iter().map(|node| [0.01 * (1.0 - node.fraction * node.fraction), 0.0]).collect();
    plate.model.set_support_nodal_values(plate.pulled_right, NodalValues::constant(&given)).unwrap();
    plate.model.step_to_values(0.1, Until::Values).unwrap();
    let field = plate.model.view(plate.right, Field::Displacement).unwrap();
    let moved = field.entries::<2>().unwrap();
    for (node, value) in nodes.iter().zip(&given) {
        assert_eq!(moved[node.node][0], value[0]);
    }
    let short = NodalValues::proportional(&given[1..]);
    assert_fails!(plate.model.set_support_nodal_values(plate.pulled_right, short), Argument, "nodes");
    assert_fails!(plate.model.set_support_values_at(plate.pulled_right, &[0.0], short), Argument, "fractions");
}

#[test]
fn values_at_places_and_forces_at_nodes_act() {
    let mut block = block();
    let load = block.model.add_edge_forces(block.region, 2, ..).unwrap();
    let places = block.model.fractions_on_edge(block.region, 2, &[[10.0, 2.0], [11.0, 6.0]]).unwrap();
    assert!((places[0].fraction - 0.25).abs() < 1e-14 && (places[1].distance - 1.0).abs() < 1e-14);
    let weights: Vec<[f64; 2]> =
        block.model.edge_nodes(block.region, 2).unwrap().iter().map(|node| [0.05 * node.weight, 0.0]).collect();
    block.model.set_load_nodal_values(load, NodalValues::constant(&weights)).unwrap();
    block.model.step(1.0).unwrap();
    let reaction = block.model.reaction(block.support).unwrap();
    assert!((reaction[0] + 0.05 * 8.0).abs() < 1e-10);
    block.model.set_load_values_at(load, &[0.5], NodalValues::constant(&[[0.0, 0.0]])).unwrap();
    assert!(block.model.reaction(block.support).unwrap()[0].abs() < 1e-12);
}

#[test]
fn states_contain_values_if_asked() {
    let mut plate = plate();
    plate.model.step(0.1).unwrap();
    let before = plate.model.reaction(plate.pulled_right).unwrap();
    let (with_values, without) = (plate.model.save_with_values().unwrap(), plate.model.save().unwrap());
    plate.model.set_support_values(plate.pulled_right, Values::constant(&[0.0, 0.0])).unwrap();
    plate.model.restore(&without).unwrap();
    assert!((plate.model.reaction(plate.pulled_right).unwrap()[0] - before[0]).abs() > 1e-3 * before[0]);
    let file = std::env::temp_dir().join(format!("bempd_edges_{}.state", std::process::id()));
    with_values.write(&file).unwrap();
    let read = bempd::State::read(&file).unwrap();
    std::fs::remove_file(&file).unwrap();
    assert_eq!(read.to_bytes().unwrap(), with_values.to_bytes().unwrap());
    assert_fails!(bempd::State::read(&file), Io, "cannot read");
    assert_fails!(with_values.write("no_such_folder/a.state"), Io, "no_such_folder");
    plate.model.restore(&read).unwrap();
    assert!((plate.model.reaction(plate.pulled_right).unwrap()[0] - before[0]).abs() < 1e-12 * before[0]);
}
