//! Pulls a square and checks its stress.

use bempd::{Component, Material, Model, Values};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut model = Model::new()?;
    let material = model.add_material(&Material::new(100.0, 0.25))?;
    let square = model.add_bem_region(material, &[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]], 0.25)?;
    model.fix_edge(square, 4, Component::X)?;
    model.fix_point([0.0, 0.0], Component::Y)?;
    model.add_traction(square, 2, .., Component::X, Values::proportional(&[2.0]))?;
    model.step(1.5)?;
    let stress = model.evaluate(&[[0.5, 0.5]])?.stress[0];
    if (stress[0] - 3.0).abs() > 1e-8 {
        return Err(format!("the stress is {stress:?}, not 3").into());
    }
    println!("bempd {}", bempd::version());
    Ok(())
}
