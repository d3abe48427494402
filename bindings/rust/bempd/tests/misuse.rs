//! Misuse gives the right variant with the library's sentence, and changes nothing.

mod common;

use bempd::{Component, Field, LoadId, Material, MaterialId, Model, Plane, RegionId, State, SupportId, Values};
use common::{block, brittle, plate, rectangle, Block};

#[test]
fn wrong_materials_are_refused() {
    let mut model = Model::new().unwrap();
    assert_fails!(model.add_material(&Material::new(f64::NAN, 0.3)), Argument, "bempd_add_material: ");
    assert_fails!(model.add_material(&Material::new(1.0, 0.6)), Argument, "0.6");
    assert_fails!(model.add_material(&Material::new(1.0, 0.3).thickness(0.0)), Argument, "thickness");
    let both = brittle().fracture_energy(1.0);
    assert_fails!(model.add_material(&both), Argument, "bempd_add_material: ");
    model.add_material(&brittle()).unwrap();
    assert_fails!(model.add_material(&brittle().plane(Plane::Strain)), Argument, "plane");
}

#[test]
fn wrong_regions_are_refused() {
    let mut model = Model::new().unwrap();
    let material = model.add_material(&brittle()).unwrap();
    let square = rectangle(0.0, 0.0, 1.0, 1.0);
    let not_a_number = [[0.0, 0.0], [f64::NAN, 0.0], [1.0, 1.0]];
    assert_fails!(model.add_bem_region(MaterialId(7), &square, 0.5), Argument, "7");
    assert_fails!(model.add_bem_region(material, &[], 0.5), Argument, "bempd_add_bem_region: ");
    assert_fails!(model.add_bem_region(material, &not_a_number, 0.5), Argument, "nan");
    assert_fails!(model.add_bem_region(material, &square, f64::NAN), Argument, "nan");
    assert_fails!(model.add_pd_region(material, &square, 0.3, 3), Argument, "0.3");
    assert_fails!(model.add_pd_region(material, &square, 0.25, 9), Argument, "9");
    assert_fails!(model.add_crack(&[]), Argument, "bempd_add_crack: ");
    assert_fails!(model.add_hole(RegionId(1), &square), Argument, "bempd_add_hole: ");
    assert_fails!(model.set_edge_mesh(RegionId(1), 1, 0.5, 1.0), Argument, "bempd_set_edge_mesh: ");
    assert_fails!(model.set_toughness_at(RegionId(1), &[[0.0, 0.0]], &[1.0]), Argument, "bempd_set_toughness_at: ");
    assert_fails!(model.set_toughness_at(RegionId(1), &[[0.0, 0.0]], &[]), Argument, "0 values for 1 places");
    assert_eq!(model.region_count().unwrap(), 0);
}

#[test]
fn wrong_conditions_are_refused() {
    let Block { mut model, region, .. } = block();
    let one = Values::proportional(&[1.0]);
    assert_fails!(model.fix_edge(region, 5, Component::X), Argument, "5");
    assert_fails!(model.prescribe_edge(region, 2, 0.5..0.5, Component::X, one), Argument, "bempd_prescribe_edge: ");
    assert_fails!(model.prescribe_edge(region, 2, .., Component::Both, one), Argument, "component is 3");
    assert_fails!(model.prescribe_edge(region, 2, f64::NAN.., Component::X, one), Argument, "nan");
    assert_fails!(model.add_traction(region, 2, .., Component::X, Values::constant(&[])), Argument, "value_count is 0");
    assert_fails!(model.add_traction(region, 2, .., Component::X, Values::constant(&[f64::NAN])), Argument, "nan");
    let unequal = Values::both(&[1.0, 2.0], &[1.0]);
    assert_fails!(model.add_traction(region, 2, .., Component::X, unequal), Argument, "2 constant and 1 proportional");
    assert_fails!(model.set_load_values(LoadId(1), one), Argument, "bempd_set_load_values: ");
    assert_fails!(model.set_support_values(SupportId(9), one), Argument, "bempd_set_support_values: ");
    assert_fails!(model.add_point_force([f64::INFINITY, 0.0], Component::X, 0.0, 1.0), Argument, "inf");
}

#[test]
fn wrong_options_are_refused() {
    let mut model = Model::new().unwrap();
    assert_fails!(model.set_option("crack.exponents", 4.0), Argument, "crack.exponent");
    assert_fails!(model.set_option("crack.exponent", f64::NAN), Argument, "bempd_set_option: ");
    assert_fails!(model.set_option_text("scheme", "fast"), Argument, "symmetric");
    assert_fails!(model.set_option_text("sch\0eme", "symmetric"), Argument, "zero byte");
    assert_fails!(model.option("scheme"), Argument, "bempd_get_option: ");
    assert_fails!(model.option_text("none"), Argument, "bempd_get_option_text: ");
    assert_fails!(model.write_history(""), Argument, "empty");
}

#[test]
fn wrong_order_is_refused() {
    assert_fails!(Model::new().unwrap().prepare(), Order, "bempd_prepare: ");
    assert_fails!(Model::new().unwrap().save(), Order, "bempd_state_save: ");
    let Block { mut model, region, .. } = block();
    model.prepare().unwrap();
    assert_fails!(model.fix_edge(region, 2, Component::X), Order, "prepared");
}

#[test]
fn a_body_without_support_is_unsolvable() {
    let mut model = Model::new().unwrap();
    let material = model.add_material(&brittle()).unwrap();
    model.add_bem_region(material, &rectangle(0.0, 0.0, 1.0, 1.0), 0.5).unwrap();
    assert_fails!(model.step(1.0), Unsolvable, "region 1");
}

#[test]
fn a_limit_on_events_is_a_lack_of_convergence() {
    let mut plate = plate();
    plate.model.set_option("stepping.max_events", 1.0).unwrap();
    assert_fails!(plate.model.run_to_separation(1000.0), Convergence, "bempd_run_to_separation: ");
}

#[test]
fn a_missing_folder_is_an_input_output_error() {
    let Block { mut model, .. } = block();
    model.step(1.0).unwrap();
    assert_fails!(model.write_history("/no such folder/history.csv"), Io, "/no such folder");
    assert_fails!(model.write_snapshot("/no such folder/run"), Io, "/no such folder");
}

#[test]
fn wrong_questions_are_refused() {
    let mut plate = plate();
    assert_fails!(plate.model.step(f64::NAN), Argument, "bempd_step: load_factor is nan");
    assert_fails!(plate.model.view(RegionId(0), Field::Position), Argument, "bempd_view_field: ");
    assert_fails!(plate.model.view(plate.left, Field::Damage), Argument, "bempd_view_field: ");
    assert_fails!(plate.model.bonds(plate.left), Argument, "bempd_bond_count: ");
    assert_fails!(plate.model.copy_field(plate.left, Field::Position, &mut []), Argument, "capacity is 0");
    assert_fails!(plate.model.evaluate(&[[100.0, 0.0]]), Argument, "bempd_evaluate: ");
    assert_fails!(plate.model.evaluate(&[[f64::NAN, 0.0]]), Argument, "nan");
    assert_fails!(plate.model.history_entry(0), Argument, "index is 0");
    assert_fails!(plate.model.reaction(SupportId(99)), Argument, "99");
    assert_fails!(State::from_bytes(&[]), Argument, "bempd_state_from_bytes: ");
    assert_fails!(State::from_bytes(b"not a state, but long enough for a magic and so on"), Argument, "state");
}

#[test]
fn errors_are_errors_of_the_standard_library() {
    let error: Box<dyn std::error::Error + Send + Sync> = Model::new().unwrap().prepare().unwrap_err().into();
    assert!(error.to_string().starts_with("bempd_prepare: "));
}
