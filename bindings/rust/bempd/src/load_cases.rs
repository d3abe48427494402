use crate::{CrackTip, LoadCaseId, LoadId, Model, PointValues, RegionId, Result, SupportId};

impl Model {
    /// Adds a load case: loads and moved supports that act together, with their values at the load factor 1.
    ///
    /// ```
    /// use bempd::{Component, FaceComponent, Material, Model, Values};
    ///
    /// # fn main() -> bempd::Result<()> {
    /// let mut model = Model::new()?;
    /// let glass = model.add_material(&Material::new(1.0, 0.3))?;
    /// model.add_bem_region(glass, &[[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]], 0.5)?;
    /// let crack = model.add_crack(&[[-0.3, 0.0], [0.3, 0.0]])?;
    /// model.fix_point([-1.0, -1.0], Component::Both)?;
    /// let held = model.fix_point([1.0, -1.0], Component::Y)?;
    /// let inside = model.add_crack_traction(crack, FaceComponent::Pressure, Values::proportional(&[1.0]))?;
    /// model.add_load_case(&[inside], &[])?;
    /// let (once, twice) = (model.combined_tips(&[1.0])?, model.combined_tips(&[2.0])?);
    /// assert!((twice[0].stress_intensity_1 / once[0].stress_intensity_1 - 2.0).abs() < 1e-9);
    /// assert_eq!(model.pressed_faces(&[2.0])?, 0);
    /// assert!(model.combined_reaction(&[1.0], held)?[1].abs() < 1e-9);
    /// assert!(model.combined_values(&[1.0], &[[0.0, 0.5]])?.displacement[0][1] > 0.0);
    /// # Ok(())
    /// # }
    /// ```
    pub fn add_load_case(&mut self, loads: &[LoadId], supports: &[SupportId]) -> Result<LoadCaseId> {
        let loads: Vec<i32> = loads.iter().map(|load| load.0).collect();
        let supports: Vec<i32> = supports.iter().map(|support| support.0).collect();
        self.handle.add_load_case(&loads, &supports).map(LoadCaseId)
    }

    /// Number of load cases.
    pub fn load_case_count(&self) -> Result<usize> {
        self.handle.load_case_count().map(|count| count as usize)
    }

    /// Tips under a combination: each case, in the order of their ids, times its factor. Their critical load factors say
    /// by how much the whole combination may be multiplied.
    pub fn combined_tips(&self, factors: &[f64]) -> Result<Vec<CrackTip>> {
        (0..self.handle.load_case_tip_count(factors)?)
            .map(|index| Ok(CrackTip::from_raw(&self.handle.load_case_tip(factors, index)?)))
            .collect()
    }

    /// Force that a support exerts on the body under a combination [N].
    pub fn combined_reaction(&self, factors: &[f64], support: SupportId) -> Result<[f64; 2]> {
        self.handle.load_case_reaction(factors, support.0)
    }

    /// Displacement and stress at places under a combination.
    pub fn combined_values(&self, factors: &[f64], places: &[[f64; 2]]) -> Result<PointValues> {
        let (displacement, stress) = self.handle.load_case_evaluate(factors, places)?;
        Ok(PointValues { displacement, stress, regions: vec![RegionId(0); places.len()] })
    }

    /// Number of places at which faces of cracks press on each other under a combination; 0 where results add up.
    pub fn pressed_faces(&self, factors: &[f64]) -> Result<usize> {
        self.handle.load_case_pressed_faces(factors).map(|count| count as usize)
    }
}
