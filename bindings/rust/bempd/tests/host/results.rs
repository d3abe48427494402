//! Results: views, copies, bonds, elements, places, history, statistics, options, files.

use crate::common::{plate, rectangle};
use bempd::{
    BondState, Component, Elements, Error, Face, Field, Material, Model, OptionKind, SingularityKind, StopReason, Turn,
    Values,
};

#[test]
fn views_are_the_librarys_numbers() {
    let mut plate = plate();
    plate.model.step(0.01).unwrap();
    for (region, field, components) in [
        (plate.left, Field::Position, 2),
        (plate.left, Field::Traction, 2),
        (plate.strip, Field::Displacement, 2),
        (plate.strip, Field::Stress, 3),
        (plate.strip, Field::Damage, 1),
        (plate.strip, Field::BondStretch, 1),
    ] {
        let view = plate.model.view(region, field).unwrap();
        let again = plate.model.view(region, field).unwrap();
        let mut copy = vec![f64::NAN; view.values().len()];
        plate.model.copy_field(region, field, &mut copy).unwrap();
        assert_eq!(plate.model.field_size(region, field).unwrap(), (view.len(), components));
        assert_eq!(view.components(), components);
        assert_eq!(view.values(), copy);
        assert_eq!(view.values().as_ptr(), again.values().as_ptr(), "{field:?} was copied");
        assert_eq!(view.generation(), plate.model.generation().unwrap());
        assert!(!view.is_empty());
    }
}

#[test]
fn views_have_entries_of_their_own_size_only() {
    let plate = plate();
    let view = plate.model.view(plate.strip, Field::Position).unwrap();
    let places = view.entries::<2>().unwrap();
    assert_eq!(places.len(), plate.model.node_count(plate.strip).unwrap());
    assert!(places.iter().all(|[x, y]| (10.0..=19.0).contains(x) && (0.0..=8.0).contains(y)));
    assert_eq!(places[3], [view.values()[6], view.values()[7]]);
    assert!(view.entries::<3>().is_none() && view.entries::<0>().is_none());
}

#[test]
fn several_views_live_while_other_results_are_asked_for() {
    let plate = plate();
    let positions = plate.model.view(plate.left, Field::Position).unwrap();
    let before = positions.values().to_vec();
    let displacement = plate.model.view(plate.left, Field::Displacement).unwrap();
    plate.model.statistics().unwrap();
    plate.model.bonds(plate.strip).unwrap();
    plate.model.view(plate.right, Field::Stress).unwrap();
    plate.model.evaluate(&[[5.0, 4.0]]).unwrap();
    assert_eq!(positions.generation(), displacement.generation());
    assert_eq!(plate.model.generation().unwrap(), positions.generation());
    assert_eq!(positions.values(), before);
}

#[test]
fn the_generation_changes_with_the_model() {
    let mut plate = plate();
    let first = plate.model.view(plate.left, Field::Displacement).unwrap().generation();
    plate.model.step(0.01).unwrap();
    let second = plate.model.view(plate.left, Field::Displacement).unwrap().generation();
    plate.model.set_load_values(plate.force, Values::constant(&[1e-3])).unwrap();
    assert!(first < second && second < plate.model.generation().unwrap());
}

#[test]
fn bonds_and_elements_are_those_of_the_regions() {
    let mut plate = plate();
    let report = plate.model.run_to_separation(1000.0).unwrap();
    let bonds = plate.model.bonds(plate.strip).unwrap();
    let count = |state| bonds.iter().filter(|bond| bond.state == state).count() as i64;
    let statistics = plate.model.statistics().unwrap();
    assert_eq!(bonds.len() as i64, statistics.bonds);
    assert_eq!(count(BondState::Broken), report.total_broken_bonds);
    assert_eq!(count(BondState::Cut), statistics.cut_bonds);
    assert!(count(BondState::Intact) > 0 && statistics.cut_bonds > 0);

    let points = plate.model.node_count(plate.strip).unwrap() as i32;
    assert!(bonds.iter().all(|bond| bond.points.iter().all(|point| (0..points).contains(point))));
    match plate.model.elements(plate.strip).unwrap() {
        Elements::Lattice(cells) => {
            assert_eq!(cells.len(), 9 * 8);
            assert!(cells.iter().flatten().all(|point| (0..points).contains(point)));
        }
        other => panic!("{other:?}"),
    }
    let nodes = plate.model.node_count(plate.left).unwrap() as i32;
    match plate.model.elements(plate.left).unwrap() {
        Elements::Boundary(elements) => {
            assert_eq!(elements.len(), plate.model.element_count(plate.left).unwrap());
            assert!(elements.iter().flatten().all(|node| (0..nodes).contains(node)));
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn pressure_pulls_where_it_is_negative_and_supports_have_moments() {
    let mut model = Model::new().unwrap();
    let material = model.add_material(&Material::new(100.0, 0.25)).unwrap();
    let region = model.add_bem_region(material, &rectangle(0.0, 0.0, 4.0, 2.0), 0.5).unwrap();
    let held = model.fix_edge(region, 4, Component::X).unwrap();
    model.fix_point([0.0, 0.0], Component::Y).unwrap();
    model.add_pressure(region, 2, .., Values::proportional(&[-3.0])).unwrap();
    model.step(1.0).unwrap();
    assert!((model.reaction(held).unwrap()[0] + 6.0).abs() < 1e-9);
    assert!((model.reaction_moment(held, [0.0, 0.0]).unwrap() - 6.0).abs() < 1e-9);
    assert!(model.reaction_moment(held, [5.0, 1.0]).unwrap().abs() < 1e-9);
}

#[test]
fn the_path_of_equilibrium_costs_what_bonds_take() {
    let mut held = crate::common::plate();
    let (lowest, highest) = held.model.admissible_load_factors().unwrap();
    assert!(lowest < 0.0 && highest > 0.0);
    let (next, words) = held.model.explain(true).unwrap();
    assert!(next.load_factor > 0.0 && next.ratio == 0.0 && words.contains("While the load factor rises"));
    let held = held.model.run_to_separation(1000.0).unwrap();
    let mut path = crate::common::plate();
    path.model.set_option_text("stepping.control", "path").unwrap();
    let path = path.model.run_to_separation(1000.0).unwrap();
    assert_eq!(path.unstable_event, 0);
    assert!(held.unstable_event > 0);
    assert!((path.released_energy / held.bond_energy - 1.0).abs() < 1e-9);
}

#[test]
fn edges_share_corners_sides_have_their_stress_and_corners_are_singular() {
    let mut model = Model::new().unwrap();
    let soft = model.add_material(&Material::new(1.0, 0.3)).unwrap();
    let stiff = model.add_material(&Material::new(3.0, 0.3)).unwrap();
    let lower = model.add_bem_region(soft, &rectangle(0.0, 0.0, 2.0, 1.0), 0.25).unwrap();
    let upper = model.add_bem_region(stiff, &rectangle(0.0, 1.0, 2.0, 2.0), 0.25).unwrap();
    let mut held = vec![model.fix_point([0.0, 0.0], Component::Y).unwrap()];
    for region in [lower, upper] {
        held.push(model.fix_edge(region, 4, Component::X).unwrap());
        held.push(model.prescribe_edge(region, 2, .., Component::X, Values::proportional(&[2.0])).unwrap());
    }
    model.step(1.0).unwrap();
    for (region, modulus) in [(lower, 1.0), (upper, 3.0)] {
        let there = model.evaluate_in(region, Face::Left, &[[1.0, 1.0]]).unwrap();
        assert!((there.stress[0][0] - modulus).abs() < 1e-7 && there.regions == [region]);
        let pull = model.edge_reaction(region, 2, [0.0, 0.0]).unwrap();
        assert!((pull.force[0] - modulus).abs() < 1e-7, "{pull:?}");
    }
    assert!(matches!(model.evaluate_in(upper, Face::Right, &[[1.0, 0.5]]), Err(Error::Argument(_))));
    assert!(matches!(model.edge_reaction(lower, 1, [0.0, 0.0]), Err(Error::Argument(_))));
    let singular = model.singularities().unwrap();
    assert!(singular.iter().any(|place| place.kind == SingularityKind::Point && (place.x, place.y) == (0.0, 0.0)));
    let mut orders = vec![0.0; model.node_count(lower).unwrap()];
    model.copy_field(lower, Field::StressOrder, &mut orders).unwrap();
    assert_eq!(orders.iter().copied().fold(0.0, f64::max), 1.0);
}

#[test]
fn arcs_are_given_by_centre_and_radius() {
    let mut model = Model::new().unwrap();
    let material = model.add_material(&Material::new(1.0, 0.3)).unwrap();
    let square = model.add_bem_region(material, &rectangle(0.0, 0.0, 1.0, 1.0), 0.25).unwrap();
    model.set_edge_arc_about(square, 2, [1.0, 0.5], 0.5, Turn::CounterClockwise).unwrap();
    assert!(model.set_edge_arc_about(square, 2, [1.0, 0.5], 0.6, Turn::Clockwise).is_err());
    let disc = model.add_bem_disc(material, [3.0, 0.0], 0.5, 0.2).unwrap();
    // A spiral whose edges have chords that cross.
    let spiral = [[6.0, 0.0], [8.0, 0.0], [6.0, 1.0], [8.0, 1.0]];
    let bulges = [0.0, (3.0 * std::f64::consts::PI / 8.0).tan(), 0.0, 0.0];
    assert!(model.add_bem_region(material, &spiral, 0.2).is_err());
    let error = model.add_bem_region_with_arcs(material, &spiral, &bulges[1..], 0.2).unwrap_err();
    assert!(error.to_string().contains("3 bulges for 4 edges"), "{error}");
    let turned = model.add_bem_region_with_arcs(material, &spiral, &bulges, 0.2).unwrap();
    let hole = [[6.8, 1.6], [7.1, 2.2], [7.4, 1.6]];
    assert_eq!(model.add_hole_with_arcs(turned, &hole, &[0.0, 0.0, 0.2]).unwrap(), 5);
    let square_with_arc = rectangle(10.0, 0.0, 18.0, 8.0);
    let of_bonds = model.add_material(&Material::new(1.0, 1.0 / 3.0)).unwrap();
    let lattice = model.add_pd_region_with_arcs(of_bonds, &square_with_arc, &[0.0, 0.4, 0.0, 0.0], 1.0, 3).unwrap();
    model.fix_edge(lattice, 4, Component::Both).unwrap();
    model.fix_edge(turned, 1, Component::Both).unwrap();
    model.fix_edge(square, 4, Component::Both).unwrap();
    model.fix_edge(disc, 1, Component::Both).unwrap();
    let view = model.view(disc, Field::Position).unwrap();
    assert!(view.values().chunks(2).all(|p| ((p[0] - 3.0).hypot(p[1]) - 0.5).abs() < 1e-14));
}

#[test]
fn places_have_displacement_stress_and_region() {
    let mut model = Model::new().unwrap();
    let material = model.add_material(&Material::new(100.0, 0.25)).unwrap();
    let region = model.add_bem_region(material, &rectangle(0.0, 0.0, 4.0, 2.0), 0.5).unwrap();
    model.fix_edge(region, 4, Component::X).unwrap();
    model.fix_point([0.0, 0.0], Component::Y).unwrap();
    let pull = Values::both(&[1.0], &[2.0]);
    let load = model.add_traction(region, 2, .., Component::X, pull).unwrap();
    model.step(2.0).unwrap();
    let at = model.evaluate(&[[3.0, 1.0], [1.0, 0.5]]).unwrap();
    assert_eq!(at.regions, [region, region]);
    for (displacement, expected) in at.displacement.iter().zip([[0.15, -0.0125], [0.05, -0.00625]]) {
        assert!((0..2).all(|i| (displacement[i] - expected[i]).abs() < 1e-10), "{displacement:?}");
    }
    for stress in &at.stress {
        assert!((0..3).all(|i| (stress[i] - [5.0, 0.0, 0.0][i]).abs() < 1e-8), "{stress:?}");
    }
    assert_eq!(model.evaluate_displacement(&[[3.0, 1.0]]).unwrap(), at.displacement[..1]);
    assert!(model.evaluate(&[]).unwrap().displacement.is_empty());

    model.set_load_values(load, Values::constant(&[10.0])).unwrap();
    model.step(2.0).unwrap();
    let stress = model.evaluate(&[[3.0, 1.0]]).unwrap().stress[0];
    assert!((stress[0] - 10.0).abs() < 1e-8, "{stress:?}");
}

#[test]
fn a_hole_continues_the_edges_and_meshes_are_chosen() {
    let mut model = Model::new().unwrap();
    model.set_option_text("bem.grading", "none").unwrap();
    let material = model.add_material(&Material::new(100.0, 0.25)).unwrap();
    let region = model.add_bem_region(material, &rectangle(0.0, 0.0, 4.0, 4.0), 1.0).unwrap();
    let hole = [[1.0, 1.0], [1.0, 3.0], [3.0, 3.0], [3.0, 1.0]];
    assert_eq!(model.add_hole(region, &hole).unwrap(), 5);
    assert_eq!(model.edge_count(region).unwrap(), 8);
    model.set_edge_mesh(region, 1, 0.5, 1.0).unwrap();
    model.fix_edge(region, 4, Component::Both).unwrap();
    assert_eq!(model.element_count(region).unwrap(), 8 + 3 * 4 + 4 * 2);
}

#[test]
fn messages_have_names() {
    let mut model = Model::new().unwrap();
    let material = model.add_material(&Material::new(100.0, 0.25)).unwrap();
    let region = model.add_bem_region(material, &rectangle(0.0, 0.0, 4.0, 4.0), 1.0).unwrap();
    let support = model.fix_edge(region, 4, Component::Both).unwrap();
    let load = model.add_point_force([4.0, 4.0], Component::X, 0.0, 1.0).unwrap();
    model.name_region(region, "pane").unwrap();
    model.name_edge(region, 2, "right").unwrap();
    model.name_support(support, "clamp").unwrap();
    model.name_load(load, "hook").unwrap();
    assert_eq!(model.edge_named(region, "right").unwrap(), 2);
    let error = model.edge_named(region, "left").unwrap_err();
    assert!(error.to_string().contains("region 1 (\"pane\")"), "{error}");
    assert!(model.name_region(region, "zero\0byte").is_err());
}

#[test]
fn supports_take_new_values() {
    let mut model = Model::new().unwrap();
    let material = model.add_material(&Material::new(100.0, 0.25)).unwrap();
    let region = model.add_bem_region(material, &rectangle(0.0, 0.0, 1.0, 1.0), 0.5).unwrap();
    model.fix_edge(region, 1, Component::Both).unwrap();
    let support = model.prescribe_point([1.0, 1.0], Component::X, 0.0, 0.1).unwrap();
    model.step(1.0).unwrap();
    assert!((model.evaluate_displacement(&[[1.0, 1.0]]).unwrap()[0][0] - 0.1).abs() < 1e-10);
    model.set_support_values(support, Values::constant(&[0.3])).unwrap();
    model.step(1.0).unwrap();
    assert!((model.evaluate_displacement(&[[1.0, 1.0]]).unwrap()[0][0] - 0.3).abs() < 1e-10);
}

#[test]
fn reports_and_history_tell_of_the_run() {
    let mut plate = plate();
    assert_eq!(plate.model.step(0.001).unwrap().stop_reason, StopReason::LoadFactor);
    let event = plate.model.step_to_next_event(1000.0).unwrap();
    assert_eq!((event.stop_reason, event.events), (StopReason::Event, 1));
    let report = plate.model.run_to_separation(1000.0).unwrap();
    assert_eq!(report.separated, report.stop_reason == StopReason::Separated);
    assert!(report.energy_balance_error < 1e-9 && report.residual < 1e-9);
    let history = plate.model.history().unwrap();
    assert_eq!(history.len(), plate.model.history_count().unwrap());
    assert_eq!(history.iter().filter(|line| line.event > 0).count() as i64, report.total_events);
    let last = history.last().unwrap();
    assert_eq!(last.total_broken_bonds, report.total_broken_bonds);
    assert_eq!(last.load_factor, plate.model.load_factor().unwrap());
}

#[test]
fn options_have_values_in_their_ranges() {
    let options = bempd::options().unwrap();
    assert!(options.iter().any(|option| option.name == "scheme"));
    for option in options {
        let mut model = Model::new().unwrap();
        assert!(!option.summary.is_empty() && !option.unit.is_empty());
        match option.kind {
            OptionKind::Number { default, minimum, maximum, .. } => {
                assert!((minimum..=maximum).contains(&default));
                assert_eq!(model.option(option.name).unwrap(), default);
                model.set_option(option.name, maximum).unwrap();
                assert_eq!(model.option(option.name).unwrap(), maximum);
            }
            OptionKind::Text { default, choices } => {
                assert!(choices.contains(&default));
                assert_eq!(model.option_text(option.name).unwrap(), default);
                let last = choices.last().unwrap();
                model.set_option_text(option.name, last).unwrap();
                assert_eq!(model.option_text(option.name).unwrap(), *last);
            }
        }
    }
}

#[test]
fn a_region_without_a_horizon_ratio_has_that_of_four_spacings_and_rows_that_turn() {
    let mut model = Model::new().unwrap();
    let material = model.add_material(&Material::new(100.0, 1.0 / 3.0)).unwrap();
    let region = model.add_pd_region(material, &rectangle(0.0, 0.0, 8.0, 8.0), 1.0, None).unwrap();
    let same = model.add_pd_region(material, &rectangle(20.0, 0.0, 28.0, 8.0), 1.0, 4).unwrap();
    let turned = model.add_turned_pd_region(material, &rectangle(40.0, 0.0, 48.0, 8.0), 1.0, 4, 0.3).unwrap();
    for region in [region, same, turned] {
        model.fix_edge(region, 1, Component::Both).unwrap();
    }
    assert_eq!(model.bond_count(region).unwrap(), model.bond_count(same).unwrap());
    assert_ne!(model.node_count(turned).unwrap(), model.node_count(same).unwrap());
    assert_eq!(model.stress_orders(&[[4.0, 4.0]]).unwrap(), [0.0]);
    assert!(model.evaluate_errors(&[[99.0, 99.0]]).is_err());
}

#[test]
fn files_are_written() {
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("files, written");
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    let mut plate = plate();
    plate.model.step(0.01).unwrap();
    plate.model.write_snapshot(folder.join("run")).unwrap();
    plate.model.write_history(folder.join("history.csv")).unwrap();
    for name in ["run.pvd", "run_0000_lattice.vtu", "run_0000_boundary.vtu", "history.csv"] {
        assert!(std::fs::metadata(folder.join(name)).unwrap().len() > 0, "{name}");
    }
    let mut restarted = crate::common::plate().model;
    restarted.step(0.01).unwrap();
    assert!(restarted.write_snapshot(folder.join("run")).unwrap_err().to_string().contains("of another run"));
    restarted.set_option_text("snapshots.existing", "continue").unwrap();
    restarted.write_snapshot(folder.join("run")).unwrap();
    assert!(folder.join("run_0001_lattice.vtu").exists());
}

#[test]
fn the_library_says_what_it_is() {
    assert_eq!(bempd::version(), env!("CARGO_PKG_VERSION"));
    assert!(bempd::build_info().starts_with(&format!("bempd {}", bempd::version())));
}

#[test]
fn what_is_removed_leaves_no_trace() {
    let mut model = Model::new().unwrap();
    let material = model.add_material(&Material::new(100.0, 0.25)).unwrap();
    let spare = model.add_bem_region(material, &rectangle(9.0, 0.0, 12.0, 2.0), 0.5).unwrap();
    let region = model.add_bem_region(material, &rectangle(0.0, 0.0, 4.0, 2.0), 0.5).unwrap();
    let support = model.fix_edge(spare, 4, Component::X).unwrap();
    assert!(matches!(model.remove_region(spare), Err(Error::Argument(_))));
    model.remove_support(support).unwrap();
    model.remove_region(spare).unwrap();
    let crack = model.add_crack(&[[1.0, 0.0], [1.0, 1.0]]).unwrap();
    model.remove_crack(crack).unwrap();
    model.fix_edge(region, 4, Component::X).unwrap();
    model.fix_point([0.0, 0.0], Component::Y).unwrap();
    let load = model.add_traction(region, 2, .., Component::Y, Values::both(&[1.0], &[2.0])).unwrap();
    model.remove_load(load).unwrap();
    model.add_traction(region, 2, .., Component::X, Values::constant(&[5.0])).unwrap();
    model.step(1.0).unwrap();
    let stress = model.evaluate(&[[3.0, 1.0]]).unwrap().stress[0];
    assert!((stress[0] - 5.0).abs() < 1e-8, "{stress:?}");
    assert!(matches!(model.remove_load(load), Err(Error::Order(_))));
}
