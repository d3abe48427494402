use bempd::{Component, Material, Model, Values};

fn main() -> bempd::Result<()> {
    // A strip 60 x 20 mm of acrylic glass: boundary elements at the ends, peridynamics where an edge crack will run.
    let left = [[0.0, 0.0], [0.02, 0.0], [0.02, 0.02], [0.0, 0.02]];
    let middle = [[0.02, 0.0], [0.04, 0.0], [0.04, 0.02], [0.02, 0.02]];
    let right = [[0.04, 0.0], [0.06, 0.0], [0.06, 0.02], [0.04, 0.02]];

    let mut model = Model::new()?;
    let acrylic = model.add_material(&Material::new(3e9, 1.0 / 3.0).thickness(0.005).fracture_energy(300.0))?;
    let left = model.add_bem_region(acrylic, &left, 0.005)?; // elements of 5 mm
    model.add_pd_region(acrylic, &middle, 0.001, 4)?; // spacing 1 mm, horizon 4 mm
    let right = model.add_bem_region(acrylic, &right, 0.005)?;
    model.add_crack(&[[0.0295, 0.0], [0.0295, 0.0045]])?;
    model.fix_edge(left, 4, Component::Both)?; // edge 4: the left end
    let pull = Values::proportional(&[1e-6]); // m per unit of load factor
    model.prescribe_edge(right, 2, .., Component::X, pull)?; // the right end moves

    let report = model.run_to_separation(1e4)?;
    println!(
        "in two at {:.2} micrometres: {} bonds in {} events, {:.4} J released",
        report.load_factor, report.total_broken_bonds, report.total_events, report.released_energy
    );
    Ok(())
}
