//! Saved states repeat a run to the last bit.

use crate::common::{block, plate};
use bempd::{State, Values};

#[test]
fn a_step_repeated_from_a_saved_state_is_bitwise_equal() {
    let mut plate = plate();
    plate.model.step_to_next_event(1000.0).unwrap();
    let state = plate.model.save().unwrap();
    let start = plate.outcome();
    plate.model.run_to_separation(1000.0).unwrap();
    let end = plate.outcome();
    assert_ne!(start, end);
    for _ in 0..2 {
        plate.model.restore(&state).unwrap();
        assert_eq!(plate.outcome(), start);
        plate.model.run_to_separation(1000.0).unwrap();
        assert_eq!(plate.outcome(), end);
    }
}

#[test]
fn bytes_carry_a_state_to_another_model() {
    let mut first = plate();
    first.model.step_to_next_event(1000.0).unwrap();
    let state = first.model.save().unwrap();
    let bytes = state.to_bytes().unwrap();
    first.model.restore(&state).unwrap();
    first.model.run_to_separation(1000.0).unwrap();

    let mut second = plate();
    let state = State::from_bytes(&bytes).unwrap();
    assert_eq!(state.to_bytes().unwrap(), bytes);
    second.model.restore(&state).unwrap();
    second.model.run_to_separation(1000.0).unwrap();
    assert_eq!(second.outcome(), first.outcome());
}

#[test]
fn a_state_outlives_its_model() {
    let mut first = plate();
    first.model.step_to_next_event(1000.0).unwrap();
    let outcome = first.outcome();
    let state = first.model.save().unwrap();
    drop(first);
    let mut second = plate();
    second.model.restore(&state).unwrap();
    assert_eq!(second.outcome(), outcome);
}

#[test]
fn loads_keep_their_present_values() {
    let mut plate = plate();
    plate.model.prepare().unwrap();
    let state = plate.model.save().unwrap();
    plate.model.set_load_values(plate.force, Values::constant(&[1e-2])).unwrap();
    plate.model.restore(&state).unwrap();
    plate.model.step(0.0).unwrap();
    let [_, y] = plate.model.evaluate_displacement(&[[29.0, 4.0]]).unwrap()[0];
    assert!(y > 0.0);
}

#[test]
fn damaged_bytes_and_other_scenes_are_refused() {
    let mut plate = plate();
    plate.model.prepare().unwrap();
    let state = plate.model.save().unwrap();
    let mut bytes = state.to_bytes().unwrap();
    let middle = bytes.len() / 2;
    bytes[middle] ^= 1;
    assert_fails!(State::from_bytes(&bytes), Argument, "bempd_state_from_bytes: ");
    assert_fails!(block().model.restore(&state), Argument, "another scene");
}
