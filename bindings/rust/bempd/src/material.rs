use bempd_sys as sys;

use crate::Plane;

/// An isotropic elastic material that breaks at a critical bond stretch.
///
/// Peridynamic regions take Poisson's ratios from -0.2 to 0.49. Without critical stretch and fracture energy the material
/// does not break; give one of them, not both.
///
/// ```
/// use bempd::{Material, Plane};
/// let acrylic = Material::new(3e9, 1.0 / 3.0).thickness(0.005).fracture_energy(300.0);
/// let rock = Material::new(50e9, 0.25).plane(Plane::Strain).critical_stretch(1e-4);
/// # let mut model = bempd::Model::new()?;
/// # model.add_material(&acrylic)?;
/// # bempd::Model::new()?.add_material(&rock)?;
/// # Ok::<(), bempd::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    young_modulus: f64,
    poisson_ratio: f64,
    thickness: Option<f64>,
    critical_stretch: Option<f64>,
    fracture_energy: Option<f64>,
    thermal_expansion: Option<f64>,
    plane: Option<Plane>,
}

impl Material {
    /// Young's modulus [Pa], > 0, and Poisson's ratio [-], between -1 and 1/2; thickness 1, plane stress, unbreakable.
    pub fn new(young_modulus: f64, poisson_ratio: f64) -> Material {
        Material {
            young_modulus,
            poisson_ratio,
            thickness: None,
            critical_stretch: None,
            fracture_energy: None,
            thermal_expansion: None,
            plane: None,
        }
    }

    /// Sets the thickness [m], > 0.
    pub fn thickness(self, thickness: f64) -> Material {
        Material { thickness: Some(thickness), ..self }
    }

    /// Sets the critical bond stretch [-], > 0.
    pub fn critical_stretch(self, critical_stretch: f64) -> Material {
        Material { critical_stretch: Some(critical_stretch), ..self }
    }

    /// Sets the fracture energy [J/m^2], > 0, from which the critical stretch follows.
    pub fn fracture_energy(self, fracture_energy: f64) -> Material {
        Material { fracture_energy: Some(fracture_energy), ..self }
    }

    /// Linear thermal expansion [1/K].
    pub fn thermal_expansion(self, thermal_expansion: f64) -> Material {
        Material { thermal_expansion: Some(thermal_expansion), ..self }
    }

    /// Sets plane stress or plane strain; the same for all materials of a model.
    pub fn plane(self, plane: Plane) -> Material {
        Material { plane: Some(plane), ..self }
    }

    /// Leaves the library's defaults where nothing was given.
    pub(crate) fn write_to(&self, raw: &mut sys::bempd_material) {
        raw.young_modulus = self.young_modulus;
        raw.poisson_ratio = self.poisson_ratio;
        raw.thickness = self.thickness.unwrap_or(raw.thickness);
        raw.critical_stretch = self.critical_stretch.unwrap_or(raw.critical_stretch);
        raw.fracture_energy = self.fracture_energy.unwrap_or(raw.fracture_energy);
        raw.thermal_expansion = self.thermal_expansion.unwrap_or(raw.thermal_expansion);
        raw.plane = self.plane.map_or(raw.plane, |plane| plane as i32);
    }
}
