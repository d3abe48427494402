use bempd::{Block, Component, FatigueOptions, GrowthRate, Material, Model, RateLaw, Values};

// A sheet of aluminium, 120 x 240 mm, with a crack of 8 mm under a spectrum of two blocks.
fn main() -> bempd::Result<()> {
    let mut model = Model::new()?;
    let aluminium = model.add_material(&Material::new(72e9, 0.33))?;
    let corners = [[-0.06, -0.12], [0.06, -0.12], [0.06, 0.12], [-0.06, 0.12]];
    let sheet = model.add_bem_region(aluminium, &corners, 0.03)?;
    let crack = model.add_crack(&[[-0.004, 0.0], [0.004, 0.0]])?;
    model.fix_point([-0.06, -0.12], Component::Both)?;
    model.fix_point([0.06, -0.12], Component::Y)?;
    model.add_traction(sheet, 3, .., Component::Y, Values::proportional(&[80e6]))?; // 80 MPa at load factor 1
    model.add_traction(sheet, 1, .., Component::Y, Values::proportional(&[-80e6]))?;

    let rate = GrowthRate::paris(2e-11, 3.0, 1e6) // in MPa m^(1/2) and m
        .law(RateLaw::Paris { walker: 0.6 })
        .critical_intensity(35.0);
    model.set_growth_rate(aluminium, &rate)?;
    let spectrum =
        [Block { high: 1.0, low: 0.1, cycles: 10.0 }, Block { high: 0.7, low: 0.2, cycles: 500.0 }];
    let life = model.grow_fatigue(&spectrum, &FatigueOptions::default())?;
    let length = model.crack_length(crack)?;
    println!("breaks after {:.0} cycles, at a length of {:.1} mm", life.cycles, 1e3 * length);
    Ok(())
}
