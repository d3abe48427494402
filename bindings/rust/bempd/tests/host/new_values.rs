//! New values of loads and supports, as a host that couples gives them.

use crate::common::{brittle, plate, rectangle, Plate};
use bempd::{Component, Model, ProgramColumn, StopReason, Until, Values};

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

#[test]
fn a_program_loads_unloads_and_goes_on() {
    let mut expected = plate();
    let one_way = expected.model.step(GOAL).unwrap();
    let mut host = plate();
    let (times, factors) = ([1.0, 2.0, 3.0], [0.5 * GOAL, 0.0, GOAL]);
    let report = host.model.run_program(&times, &[], &factors, Until::Values).unwrap();
    assert_eq!((report.stop_reason, report.broken_bonds), (StopReason::LoadFactor, one_way.broken_bonds));
    assert!(report.load_factor == 3.0 && report.energy_balance_error < 1e-9);
    assert_fails!(host.model.run_program(&times, &[], &factors, Until::Values), Argument, "already");
    assert_fails!(host.model.run_program(&times, &[], &factors[1..], Until::Values), Argument, "2 factors");
}

#[test]
fn columns_of_a_program_are_of_supports() {
    let mut host = plate();
    let columns = [ProgramColumn::Support(host.pulled_left), ProgramColumn::Support(host.pulled_right)];
    let report = host.model.run_program(&[1.0], &columns, &[0.02, 0.02], Until::Event).unwrap();
    assert_eq!((report.stop_reason, report.events), (StopReason::LoadFactor, 0));
    let force = host.model.reaction(host.pulled_right).unwrap();
    let mut expected = plate();
    expected.model.step(0.02).unwrap();
    let wanted = expected.model.reaction(expected.pulled_right).unwrap();
    assert!((force[0] - wanted[0]).abs() < 1e-9 * wanted[0].abs());
}

#[test]
fn a_pressure_acts_along_the_cut_that_it_is_in() {
    let mut model = Model::new().unwrap();
    let solid = model.add_material(&brittle()).unwrap();
    let body = model.add_pd_region(solid, &rectangle(0.0, 0.0, 8.0, 10.0), 1.0, 3).unwrap();
    let crack = model.add_crack(&[[0.0, 5.5], [8.0, 5.5]]).unwrap();
    model.add_crack_pressure(crack, 0.0, 0.1).unwrap();
    let top = model.fix_edge(body, 3, Component::Both).unwrap();
    model.fix_edge(body, 1, Component::Both).unwrap();
    model.step(1.0).unwrap();
    assert!((model.reaction(top).unwrap()[1] + 0.8).abs() < 1e-9);
}

#[test]
fn a_region_turns_about_an_axis() {
    let mut model = Model::new().unwrap();
    let solid = model.add_material(&brittle()).unwrap();
    let body = model.add_bem_region(solid, &rectangle(1.0, 0.0, 9.0, 10.0), 2.0).unwrap();
    model.add_rotation(body, [1.0, 0.0], 0.0, 0.5).unwrap();
    let bottom = model.fix_edge(body, 1, Component::Both).unwrap();
    model.step(1.0).unwrap();
    let force = model.reaction(bottom).unwrap();
    assert!((force[0] + 160.0).abs() < 1e-6 && (force[1] + 200.0).abs() < 1e-6);
}
