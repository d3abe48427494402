//! How misuse arrives in Rust: the variant and the library's sentence. tests/capi/misuse_*.c have the full list of what is refused.

use crate::common::{block, brittle, plate, rectangle, Block};
use bempd::{Component, Field, LoadId, Material, MaterialId, Model, State, Values};

#[test]
fn errors_of_the_library_arrive_with_its_sentence() {
    let mut model = Model::new().unwrap();
    assert_fails!(model.add_material(&Material::new(f64::NAN, 0.3)), Argument, "bempd_add_material: ");
    let material = model.add_material(&brittle()).unwrap();
    let square = rectangle(0.0, 0.0, 1.0, 1.0);
    assert_fails!(model.add_bem_region(MaterialId(7), &square, 0.5), Argument, "7");
    assert_fails!(model.add_pd_region(material, &square, 0.3, 3), Argument, "0.3");
    assert_eq!(model.region_count().unwrap(), 0);
}

#[test]
fn slices_of_unequal_lengths_and_empty_ones_are_refused() {
    let Block { mut model, region, .. } = block();
    assert_fails!(model.add_crack(&[]), Argument, "bempd_add_crack: ");
    assert_fails!(model.set_toughness_at(region, &[[0.0, 0.0]], &[]), Argument, "0 values for 1 places");
    assert_fails!(model.add_traction(region, 2, .., Component::X, Values::constant(&[])), Argument, "value_count is 0");
    let unequal = Values::both(&[1.0, 2.0], &[1.0]);
    assert_fails!(model.add_traction(region, 2, .., Component::X, unequal), Argument, "2 constant and 1 proportional");
}

#[test]
fn ranges_and_components_arrive_as_they_are() {
    let Block { mut model, region, .. } = block();
    let one = Values::proportional(&[1.0]);
    assert_fails!(model.prescribe_edge(region, 2, 0.5..0.5, Component::X, one), Argument, "bempd_prescribe_edge: ");
    assert_fails!(model.prescribe_edge(region, 2, f64::NAN.., Component::X, one), Argument, "nan");
    assert_fails!(model.prescribe_edge(region, 2, .., Component::Both, one), Argument, "component is 3");
    assert_fails!(model.set_load_values(LoadId(1), one), Argument, "bempd_set_load_values: ");
}

#[test]
fn texts_with_zero_bytes_are_refused() {
    let mut model = Model::new().unwrap();
    assert_fails!(model.set_option_text("sch\0eme", "symmetric"), Argument, "zero byte");
    assert_fails!(model.option_text("none"), Argument, "bempd_get_option_text: ");
}

#[test]
fn wrong_order_is_refused() {
    assert_fails!(Model::new().unwrap().prepare(), Order, "bempd_prepare: ");
    assert_fails!(Model::new().unwrap().save(), Order, "bempd_state_save: ");
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
fn places_for_results_that_do_not_fit_are_refused() {
    let plate = plate();
    assert_fails!(plate.model.copy_field(plate.left, Field::Position, &mut []), Argument, "capacity is 0");
    assert_fails!(plate.model.view(plate.left, Field::Damage), Argument, "bempd_view_field: ");
    assert_fails!(plate.model.history_entry(0), Argument, "index is 0");
    assert_fails!(State::from_bytes(&[]), Argument, "bempd_state_from_bytes: ");
}

#[test]
fn errors_are_errors_of_the_standard_library() {
    let error: Box<dyn std::error::Error + Send + Sync> = Model::new().unwrap().prepare().unwrap_err().into();
    assert!(error.to_string().starts_with("bempd_prepare: "));
}
