use bempd::{Component, Material, Model, Values};

// A strip of acrylic glass, 60 x 20 mm, with a hole and an edge crack.
fn main() -> bempd::Result<()> {
    let outline = [[0.0, 0.0], [0.06, 0.0], [0.06, 0.02], [0.0, 0.02]];

    let mut model = Model::new()?;
    model.set_option("error.wanted", 0.01)?; // the elements follow from it
    let glass = Material::new(3e9, 1.0 / 3.0).thickness(0.005).fracture_energy(300.0);
    let glass = model.add_material(&glass)?;
    let strip = model.add_body(glass, &outline)?;
    model.add_circular_hole(strip, [0.034, 0.013], 0.003)?;
    model.add_crack(&[[0.03, 0.0], [0.03, 0.005]])?;
    model.fix_edge(strip, 4, Component::Both)?; // edge 4: the left end
    let pull = Values::proportional(&[1e-6]); // m per unit of load factor
    model.prescribe_edge(strip, 2, .., Component::X, pull)?; // the right end moves

    let end = model.run_to_separation(1e4)?;
    print!("growth at {:.1} micrometres, ", end.load_factor);
    println!("{:.0} N", end.peak_resistance);
    Ok(())
}
