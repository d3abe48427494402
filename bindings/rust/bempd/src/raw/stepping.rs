use bempd_sys as sys;

use super::handle::{filled, terminated, Handle};
use crate::Result;

// SAFETY, for every call of this file: `call` and `output` give a valid model and place for the result, strings end with
// a zero, and structs were filled by their `_init` function.
impl Handle {
    pub(crate) fn prepare(&mut self) -> Result<()> {
        self.call(|model| unsafe { sys::bempd_prepare(model) })
    }

    pub(crate) fn step(&mut self, load_factor: f64) -> Result<sys::bempd_step_report> {
        let mut report = filled(sys::bempd_step_report_init)?;
        self.call(|model| unsafe { sys::bempd_step(model, load_factor, &mut report) })?;
        Ok(report)
    }

    pub(crate) fn step_to_next_event(&mut self, limit: f64) -> Result<sys::bempd_step_report> {
        let mut report = filled(sys::bempd_step_report_init)?;
        self.call(|model| unsafe { sys::bempd_step_to_next_event(model, limit, &mut report) })?;
        Ok(report)
    }

    pub(crate) fn run_to_separation(&mut self, limit: f64) -> Result<sys::bempd_step_report> {
        let mut report = filled(sys::bempd_step_report_init)?;
        self.call(|model| unsafe { sys::bempd_run_to_separation(model, limit, &mut report) })?;
        Ok(report)
    }

    pub(crate) fn step_to_values(&mut self, load_factor: f64, until: i32) -> Result<sys::bempd_step_report> {
        let mut report = filled(sys::bempd_step_report_init)?;
        self.call(|model| unsafe { sys::bempd_step_to_values(model, load_factor, until, &mut report) })?;
        Ok(report)
    }

    pub(crate) fn run_program(
        &mut self,
        times: &[f64],
        kinds: &[i32],
        ids: &[i32],
        factors: &[f64],
        until: i32,
    ) -> Result<sys::bempd_step_report> {
        let mut report = filled(sys::bempd_step_report_init)?;
        let (rows, columns) = (times.len() as i64, ids.len() as i64);
        self.call(|model| unsafe {
            sys::bempd_run_program(
                model,
                rows,
                times.as_ptr(),
                columns,
                kinds.as_ptr(),
                ids.as_ptr(),
                factors.as_ptr(),
                until,
                &mut report,
            )
        })?;
        Ok(report)
    }

    pub(crate) fn set_option(&mut self, name: &str, value: f64) -> Result<()> {
        let name = terminated(name)?;
        self.call(|model| unsafe { sys::bempd_set_option(model, name.as_ptr(), value) })
    }

    pub(crate) fn get_option(&self, name: &str) -> Result<f64> {
        let name = terminated(name)?;
        self.output(|model, value| unsafe { sys::bempd_get_option(model, name.as_ptr(), value) })
    }

    pub(crate) fn set_option_text(&mut self, name: &str, value: &str) -> Result<()> {
        let (name, value) = (terminated(name)?, terminated(value)?);
        self.call(|model| unsafe { sys::bempd_set_option_text(model, name.as_ptr(), value.as_ptr()) })
    }

    pub(crate) fn get_option_text(&self, name: &str) -> Result<String> {
        let name = terminated(name)?;
        let needed = self.output(|model, needed| unsafe {
            sys::bempd_get_option_text(model, name.as_ptr(), std::ptr::null_mut(), 0, needed)
        })?;
        let mut buffer = vec![0u8; needed as usize];
        self.call(|model| unsafe {
            let start = buffer.as_mut_ptr().cast();
            sys::bempd_get_option_text(model, name.as_ptr(), start, needed, std::ptr::null_mut())
        })?;
        buffer.pop();
        Ok(String::from_utf8_lossy(&buffer).into_owned())
    }

    pub(crate) fn write_snapshot(&mut self, prefix: &str) -> Result<()> {
        let prefix = terminated(prefix)?;
        self.call(|model| unsafe { sys::bempd_write_snapshot(model, prefix.as_ptr()) })
    }

    pub(crate) fn write_history(&self, path: &str) -> Result<()> {
        let path = terminated(path)?;
        self.call(|model| unsafe { sys::bempd_write_history(model, path.as_ptr()) })
    }

    pub(crate) fn write_tips(&self, path: &str) -> Result<()> {
        let path = terminated(path)?;
        self.call(|model| unsafe { sys::bempd_write_tips(model, path.as_ptr()) })
    }
}
