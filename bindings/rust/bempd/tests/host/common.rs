//! Scenes that several tests use.
#![allow(dead_code)]

use bempd::{Component, Field, LoadId, Material, Model, RegionId, SupportId, Values};

pub fn rectangle(left: f64, bottom: f64, right: f64, top: f64) -> [[f64; 2]; 4] {
    [[left, bottom], [right, bottom], [right, top], [left, top]]
}

pub fn brittle() -> Material {
    Material::new(1000.0, 1.0 / 3.0).critical_stretch(1e-3)
}

/// One boundary element rectangle, 10 x 8, held at the left.
pub struct Block {
    pub model: Model,
    pub region: RegionId,
    pub support: SupportId,
}

pub fn block() -> Block {
    let mut model = Model::new().unwrap();
    let material = model.add_material(&brittle()).unwrap();
    let region = model.add_bem_region(material, &rectangle(0.0, 0.0, 10.0, 8.0), 2.0).unwrap();
    let support = model.fix_edge(region, 4, Component::Both).unwrap();
    Block { model, region, support }
}

/// Boundary elements 10 x 8, a lattice of 9 x 8 cells with an edge crack across four rows, boundary elements 10 x 8. The
/// ends are pulled apart, more at the bottom than at the top, so that the crack grows stably; the force is 0.
pub struct Plate {
    pub model: Model,
    pub left: RegionId,
    pub strip: RegionId,
    pub right: RegionId,
    pub pulled_left: SupportId,
    pub pulled_right: SupportId,
    pub force: LoadId,
}

pub fn plate() -> Plate {
    let mut model = Model::new().unwrap();
    model.set_option_text("crack.rule", "bond").unwrap();
    let material = model.add_material(&brittle()).unwrap();
    let left = model.add_bem_region(material, &rectangle(0.0, 0.0, 10.0, 8.0), 2.0).unwrap();
    let strip = model.add_pd_region(material, &rectangle(10.0, 0.0, 19.0, 8.0), 1.0, 3).unwrap();
    let right = model.add_bem_region(material, &rectangle(19.0, 0.0, 29.0, 8.0), 2.0).unwrap();
    model.add_crack(&[[14.5, 0.0], [14.5, 3.5]]).unwrap();
    let pull_left = Values::proportional(&[-0.002, -0.02]);
    let pulled_left = model.prescribe_edge(left, 4, .., Component::X, pull_left).unwrap();
    let pull_right = Values::proportional(&[0.02, 0.002]);
    let pulled_right = model.prescribe_edge(right, 2, .., Component::X, pull_right).unwrap();
    model.fix_point([0.0, 4.0], Component::Y).unwrap();
    let force = model.add_point_force([29.0, 4.0], Component::Y, 0.0, 0.0).unwrap();
    Plate { model, left, strip, right, pulled_left, pulled_right, force }
}

impl Plate {
    pub fn regions(&self) -> [RegionId; 3] {
        [self.left, self.strip, self.right]
    }

    /// The bits of all that a run changes.
    pub fn outcome(&self) -> Vec<u64> {
        let mut numbers = vec![self.model.load_factor().unwrap()];
        for region in self.regions() {
            numbers.extend(self.model.view(region, Field::Displacement).unwrap().values());
        }
        numbers.extend(self.model.view(self.strip, Field::Damage).unwrap().values());
        for support in [self.pulled_left, self.pulled_right] {
            numbers.extend(self.model.reaction(support).unwrap());
        }
        for line in self.model.history().unwrap() {
            numbers.extend([line.load_factor, line.released_energy, line.work, line.total_broken_bonds as f64]);
        }
        numbers.into_iter().map(f64::to_bits).collect()
    }
}

/// Asserts the variant of an error and a part of its sentence.
macro_rules! assert_fails {
    ($call:expr, $variant:ident, $words:expr) => {
        match $call {
            Err(bempd::Error::$variant(sentence)) => {
                assert!(sentence.contains($words), "\"{}\" does not contain \"{}\"", sentence, $words)
            }
            other => panic!("expected {}, got {:?}", stringify!($variant), other.map(|_| ())),
        }
    };
}
