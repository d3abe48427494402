use std::ptr;

use bempd_sys as sys;

use super::callbacks::BoundaryFunction;
use super::Handle;
use crate::{Error, Result, Values};

/// Part of an edge.
#[derive(Clone, Copy)]
pub(crate) struct EdgePart {
    pub(crate) region: i32,
    pub(crate) edge: i32,
    pub(crate) from: f64,
    pub(crate) to: f64,
}

/// Count and addresses of values that have been checked to be equally many.
struct Arrays {
    count: i64,
    constant: *const f64,
    proportional: *const f64,
}

impl Arrays {
    fn of(values: &Values<'_>) -> Result<Arrays> {
        let address = |part: Option<&[f64]>| part.map_or(ptr::null(), |part| part.as_ptr());
        let count = match (values.constant, values.proportional) {
            (Some(constant), Some(proportional)) if constant.len() != proportional.len() => {
                return Err(Error::Argument(format!(
                    "there are {} constant and {} proportional values; give as many of one as of the other",
                    constant.len(),
                    proportional.len()
                )))
            }
            (Some(part), _) | (None, Some(part)) => part.len(),
            (None, None) => 0,
        };
        Ok(Arrays {
            count: count as i64,
            constant: address(values.constant),
            proportional: address(values.proportional),
        })
    }
}

// SAFETY, for every call of this file: `call` and `output` give a valid model and place for the result, arrays are given
// with their own length, and boundary functions are kept as long as the model.
impl Handle {
    pub(crate) fn fix_edge(&mut self, region: i32, edge: i32, component: i32) -> Result<i32> {
        self.output(|model, support| unsafe { sys::bempd_fix_edge(model, region, edge, component, support) })
    }

    pub(crate) fn fix_point(&mut self, place: [f64; 2], component: i32) -> Result<i32> {
        let [x, y] = place;
        self.output(|model, support| unsafe { sys::bempd_fix_point(model, x, y, component, support) })
    }

    pub(crate) fn prescribe_edge(&mut self, part: EdgePart, component: i32, values: &Values<'_>) -> Result<i32> {
        let EdgePart { region, edge, from, to } = part;
        let Arrays { count, constant, proportional } = Arrays::of(values)?;
        self.output(|model, support| unsafe {
            sys::bempd_prescribe_edge(model, region, edge, from, to, component, count, constant, proportional, support)
        })
    }

    pub(crate) fn prescribe_edge_function(
        &mut self,
        part: EdgePart,
        component: i32,
        function: BoundaryFunction,
    ) -> Result<i32> {
        let EdgePart { region, edge, from, to } = part;
        self.with_boundary_function(function, |model, function, user, support| unsafe {
            sys::bempd_prescribe_edge_function(model, region, edge, from, to, component, function, user, support)
        })
    }

    pub(crate) fn prescribe_point(
        &mut self,
        place: [f64; 2],
        component: i32,
        constant: f64,
        proportional: f64,
    ) -> Result<i32> {
        let [x, y] = place;
        self.output(|model, support| unsafe {
            sys::bempd_prescribe_point(model, x, y, component, constant, proportional, support)
        })
    }

    pub(crate) fn add_traction(&mut self, part: EdgePart, component: i32, values: &Values<'_>) -> Result<i32> {
        let EdgePart { region, edge, from, to } = part;
        let Arrays { count, constant, proportional } = Arrays::of(values)?;
        self.output(|model, load| unsafe {
            sys::bempd_add_traction(model, region, edge, from, to, component, count, constant, proportional, load)
        })
    }

    pub(crate) fn add_pressure(&mut self, part: EdgePart, values: &Values<'_>) -> Result<i32> {
        let EdgePart { region, edge, from, to } = part;
        let Arrays { count, constant, proportional } = Arrays::of(values)?;
        self.output(|model, load| unsafe {
            sys::bempd_add_pressure(model, region, edge, from, to, count, constant, proportional, load)
        })
    }

    pub(crate) fn add_traction_function(&mut self, part: EdgePart, function: BoundaryFunction) -> Result<i32> {
        let EdgePart { region, edge, from, to } = part;
        self.with_boundary_function(function, |model, function, user, load| unsafe {
            sys::bempd_add_traction_function(model, region, edge, from, to, function, user, load)
        })
    }

    pub(crate) fn add_crack_traction(&mut self, crack: i32, component: i32, values: &Values<'_>) -> Result<i32> {
        let Arrays { count, constant, proportional } = Arrays::of(values)?;
        self.output(|model, load| unsafe {
            sys::bempd_add_crack_traction(model, crack, component, count, constant, proportional, load)
        })
    }

    pub(crate) fn add_point_force(
        &mut self,
        place: [f64; 2],
        component: i32,
        constant: f64,
        proportional: f64,
    ) -> Result<i32> {
        let [x, y] = place;
        self.output(|model, load| unsafe {
            sys::bempd_add_point_force(model, x, y, component, constant, proportional, load)
        })
    }

    pub(crate) fn add_crack_pressure(&mut self, crack: i32, constant: f64, proportional: f64) -> Result<i32> {
        self.output(|model, load| unsafe { sys::bempd_add_crack_pressure(model, crack, constant, proportional, load) })
    }

    pub(crate) fn add_body_force(
        &mut self,
        region: i32,
        component: i32,
        constant: f64,
        proportional: f64,
    ) -> Result<i32> {
        self.output(|model, load| unsafe {
            sys::bempd_add_body_force(model, region, component, constant, proportional, load)
        })
    }

    pub(crate) fn add_rotation(
        &mut self,
        region: i32,
        axis: [f64; 2],
        constant: f64,
        proportional: f64,
    ) -> Result<i32> {
        let [x, y] = axis;
        self.output(|model, load| unsafe { sys::bempd_add_rotation(model, region, x, y, constant, proportional, load) })
    }

    pub(crate) fn add_temperature_function(&mut self, region: i32, function: BoundaryFunction) -> Result<i32> {
        self.with_boundary_function(function, |model, function, user, load| unsafe {
            sys::bempd_add_temperature_function(model, region, function, user, load)
        })
    }

    pub(crate) fn add_temperature(&mut self, region: i32, constant: f64, proportional: f64) -> Result<i32> {
        self.output(|model, load| unsafe { sys::bempd_add_temperature(model, region, constant, proportional, load) })
    }

    pub(crate) fn set_load_values(&mut self, load: i32, values: &Values<'_>) -> Result<()> {
        let Arrays { count, constant, proportional } = Arrays::of(values)?;
        self.call(|model| unsafe { sys::bempd_set_load_values(model, load, count, constant, proportional) })
    }

    pub(crate) fn set_support_values(&mut self, support: i32, values: &Values<'_>) -> Result<()> {
        let Arrays { count, constant, proportional } = Arrays::of(values)?;
        self.call(|model| unsafe { sys::bempd_set_support_values(model, support, count, constant, proportional) })
    }
    pub(crate) fn remove_support(&mut self, support: i32) -> Result<()> {
        self.call(|model| unsafe { sys::bempd_remove_support(model, support) })
    }

    pub(crate) fn remove_load(&mut self, load: i32) -> Result<()> {
        self.call(|model| unsafe { sys::bempd_remove_load(model, load) })
    }
}
