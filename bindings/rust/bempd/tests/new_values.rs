//! New values of loads and supports, as a host that couples gives them.

mod common;

use bempd::{StopReason, Until, Values};
use common::{plate, Plate};

const GOAL: f64 = 1.2;

fn pull(plate: &mut Plate, load_factor: f64) {
    let (small, large) = (0.002 * load_factor, 0.02 * load_factor);
    plate.model.set_support_values(plate.pulled_left, Values::constant(&[-small, -large])).unwrap();
    plate.model.set_support_values(plate.pulled_right, Values::constant(&[large, small])).unwrap();
}

fn events(plate: &Plate) -> Vec<(i64, f64)> {
    let lines = plate.model.history().unwrap();
    lines.iter().filter(|line| line.event > 0).map(|line| (line.total_broken_bonds, line.load_factor)).collect()
}

#[test]
fn steps_to_values_break_what_one_proportional_load_breaks() {
    let mut expected = plate();
    expected.model.step(GOAL).unwrap();
    let mut host = plate();
    for part in 1..=3 {
        let time = GOAL * f64::from(part) / 3.0;
        pull(&mut host, time);
        let report = host.model.step_to_values(time, Until::Values).unwrap();
        assert_eq!(report.stop_reason, StopReason::LoadFactor);
    }
    let (expected, found) = (events(&expected), events(&host));
    assert!(expected.len() > 3 && expected.len() == found.len());
    for (one, other) in expected.iter().zip(&found) {
        assert_eq!(one.0, other.0);
        assert!((one.1 - other.1).abs() < 1e-9 * GOAL);
    }
}

#[test]
fn a_way_stops_at_an_event_and_goes_on() {
    let mut host = plate();
    pull(&mut host, GOAL);
    let report = host.model.step_to_values(GOAL, Until::Event).unwrap();
    assert_eq!((report.stop_reason, report.events), (StopReason::Event, 1));
    let report = host.model.step_to_values(GOAL, Until::Separated).unwrap();
    assert_eq!(report.stop_reason, StopReason::LoadFactor);
    assert_fails!(host.model.step_to_values(GOAL, Until::Values), Argument, "already");
}
