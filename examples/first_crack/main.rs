use bempd::{Component, Material, Model, Values};

// A strip of acrylic glass, 60 x 20 mm: boundary elements, a lattice around the crack,
// boundary elements.
fn main() -> bempd::Result<()> {
    let left = [[0.0, 0.0], [0.02, 0.0], [0.02, 0.02], [0.0, 0.02]];
    let middle = [[0.02, 0.0], [0.04, 0.0], [0.04, 0.02], [0.02, 0.02]];
    let right = [[0.04, 0.0], [0.06, 0.0], [0.06, 0.02], [0.04, 0.02]];

    let mut model = Model::new()?;
    let glass = Material::new(3e9, 1.0 / 3.0).thickness(0.005).fracture_energy(300.0);
    let glass = model.add_material(&glass)?;
    let left = model.add_bem_region(glass, &left, 0.005)?; // elements of 5 mm
    model.add_pd_region(glass, &middle, 0.001, 4)?; // spacing 1 mm, horizon 4 mm
    let right = model.add_bem_region(glass, &right, 0.005)?;
    model.add_crack(&[[0.0295, 0.0], [0.0295, 0.0045]])?;
    model.fix_edge(left, 4, Component::Both)?; // edge 4: the left end
    let pull = Values::proportional(&[1e-6]); // m per unit of load factor
    model.prescribe_edge(right, 2, .., Component::X, pull)?; // the right end moves

    let end = model.run_to_separation(1e4)?;
    print!("in two at {:.2} micrometres: ", end.load_factor);
    print!("{} bonds in {} events, ", end.total_broken_bonds, end.total_events);
    println!("{:.4} J released", end.released_energy);
    Ok(())
}
