use bempd_sys as sys;

use super::handle::filled;
use super::{points, Handle};
use crate::Result;

impl Handle {
    pub(crate) fn add_load_case(&mut self, loads: &[i32], supports: &[i32]) -> Result<i32> {
        let counts = (loads.len() as i64, supports.len() as i64);
        self.output(|model, case| unsafe {
            sys::bempd_load_case_add(model, counts.0, loads.as_ptr(), counts.1, supports.as_ptr(), case)
        })
    }

    pub(crate) fn load_case_count(&self) -> Result<i32> {
        self.output(|model, count| unsafe { sys::bempd_load_case_count(model, count) })
    }

    pub(crate) fn load_case_tip_count(&self, factors: &[f64]) -> Result<i64> {
        let cases = factors.len() as i64;
        self.output(|model, count| unsafe { sys::bempd_load_case_tip_count(model, cases, factors.as_ptr(), count) })
    }

    pub(crate) fn load_case_tip(&self, factors: &[f64], index: i64) -> Result<sys::bempd_crack_tip> {
        let mut tip = filled(sys::bempd_crack_tip_init)?;
        let cases = factors.len() as i64;
        self.call(|model| unsafe { sys::bempd_load_case_tip(model, cases, factors.as_ptr(), index, &mut tip) })?;
        Ok(tip)
    }

    pub(crate) fn load_case_reaction(&self, factors: &[f64], support: i32) -> Result<[f64; 2]> {
        let mut force = [0.0; 2];
        let (cases, output) = (factors.len() as i64, force.as_mut_ptr());
        self.call(|model| unsafe { sys::bempd_load_case_reaction(model, cases, factors.as_ptr(), support, output) })?;
        Ok(force)
    }

    pub(crate) fn load_case_evaluate(
        &self,
        factors: &[f64],
        places: &[[f64; 2]],
    ) -> Result<(Vec<[f64; 2]>, Vec<[f64; 3]>)> {
        let mut displacement = vec![[0.0; 2]; places.len()];
        let mut stress = vec![[0.0; 3]; places.len()];
        let (count, places) = points(places);
        let outputs = (displacement.as_mut_ptr().cast(), stress.as_mut_ptr().cast());
        let cases = factors.len() as i64;
        self.call(|model| unsafe {
            sys::bempd_load_case_evaluate(model, cases, factors.as_ptr(), count, places, outputs.0, outputs.1)
        })?;
        Ok((displacement, stress))
    }

    pub(crate) fn load_case_pressed_faces(&self, factors: &[f64]) -> Result<i64> {
        let cases = factors.len() as i64;
        self.output(|model, count| unsafe { sys::bempd_load_case_pressed_faces(model, cases, factors.as_ptr(), count) })
    }
}
