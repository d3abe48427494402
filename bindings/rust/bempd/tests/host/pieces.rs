//! What a torn body consists of.

use crate::common::{brittle, plate, rectangle};
use bempd::{Component, Model, Values};

#[test]
fn a_torn_plate_is_in_pieces() {
    let mut plate = plate();
    assert_eq!(plate.model.piece_count().unwrap(), 1);
    assert!(plate.model.are_connected(plate.pulled_left, plate.pulled_right).unwrap());
    let report = plate.model.run_to_separation(1000.0).unwrap();
    assert!(report.separated && !report.hanging && report.resistance < 1e-6 * report.peak_resistance);
    assert!(plate.model.piece_count().unwrap() >= 2);
    assert!(!plate.model.are_connected(plate.pulled_left, plate.pulled_right).unwrap());
    let left = plate.model.support_piece(plate.pulled_left).unwrap();
    assert!(plate.model.node_pieces(plate.left).unwrap().iter().all(|piece| Some(*piece) == left));
    assert_eq!(plate.model.load_piece(plate.force).unwrap(), plate.model.support_piece(plate.pulled_right).unwrap());
    assert_eq!(plate.model.piece(left.unwrap()).unwrap().supports, 2);
}

#[test]
fn a_loose_piece_moves_as_its_edge_does() {
    let mut model = Model::new().unwrap();
    let material = model.add_material(&brittle()).unwrap();
    let block = model.add_pd_region(material, &rectangle(0.0, 0.0, 8.0, 4.0), 1.0, 2).unwrap();
    model.add_crack(&[[4.5, 0.0], [4.5, 4.0]]).unwrap();
    model.fix_edge(block, 4, Component::Both).unwrap();
    model.prescribe_edge(block, 2, .., Component::X, Values::constant(&[0.01, 0.05])).unwrap();
    let both = model.add_traction(block, 1, .., Component::Y, Values::constant(&[0.0])).unwrap();
    assert_eq!(model.load_piece(both).unwrap(), None);
    let piece = model.piece(2).unwrap();
    assert_eq!((piece.nodes, piece.supports, piece.loads, piece.free_motions), (20, 1, 1, 1));
    assert!((piece.rotation + 0.01).abs() < 1e-12 && piece.deviation < 1e-12);
    assert_fails!(model.piece(3), Argument, "piece 3");
}
