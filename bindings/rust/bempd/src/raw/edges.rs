use std::ptr;

use bempd_sys as sys;

use super::{points, EdgePart, Handle};
use crate::{EdgeNode, EdgePlace, Error, NodalValues, Result};

/// Count and addresses of pairs of values that have been checked to be equally many.
struct Pairs {
    count: i64,
    constant: *const f64,
    proportional: *const f64,
}

impl Pairs {
    fn of(values: &NodalValues<'_>) -> Result<Pairs> {
        let address = |part: Option<&[[f64; 2]]>| part.map_or(ptr::null(), |part| part.as_ptr().cast());
        let counts = [values.constant, values.proportional].map(|part| part.map(<[_]>::len));
        match counts {
            [Some(constant), Some(proportional)] if constant != proportional => Err(Error::Argument(format!(
                "there are {constant} constant and {proportional} proportional pairs of values; give as many of one as \
                 of the other"
            ))),
            _ => Ok(Pairs {
                count: counts.into_iter().flatten().next().unwrap_or(0) as i64,
                constant: address(values.constant),
                proportional: address(values.proportional),
            }),
        }
    }

    fn at(values: &NodalValues<'_>, fractions: &[f64]) -> Result<Pairs> {
        let pairs = Pairs::of(values)?;
        if pairs.count == fractions.len() as i64 {
            return Ok(pairs);
        }
        Err(Error::Argument(format!(
            "there are {} fractions and {} pairs of values; give as many of one as of the other",
            fractions.len(),
            pairs.count
        )))
    }
}

// SAFETY, for every call of this file: `call` and `output` give a valid model and place for the result, and arrays are
// given with their own length.
impl Handle {
    pub(crate) fn add_edge_forces(&mut self, part: EdgePart) -> Result<i32> {
        let EdgePart { region, edge, from, to } = part;
        self.output(|model, load| unsafe { sys::bempd_add_edge_forces(model, region, edge, from, to, load) })
    }

    pub(crate) fn set_support_nodal_values(&mut self, support: i32, values: &NodalValues<'_>) -> Result<()> {
        let Pairs { count, constant, proportional } = Pairs::of(values)?;
        self.call(|model| unsafe { sys::bempd_set_support_nodal_values(model, support, count, constant, proportional) })
    }

    pub(crate) fn set_load_nodal_values(&mut self, load: i32, values: &NodalValues<'_>) -> Result<()> {
        let Pairs { count, constant, proportional } = Pairs::of(values)?;
        self.call(|model| unsafe { sys::bempd_set_load_nodal_values(model, load, count, constant, proportional) })
    }

    pub(crate) fn set_support_values_at(
        &mut self,
        support: i32,
        fractions: &[f64],
        values: &NodalValues<'_>,
    ) -> Result<()> {
        let Pairs { count, constant, proportional } = Pairs::at(values, fractions)?;
        let places = fractions.as_ptr();
        self.call(|model| unsafe {
            sys::bempd_set_support_values_at(model, support, count, places, constant, proportional)
        })
    }

    pub(crate) fn set_load_values_at(&mut self, load: i32, fractions: &[f64], values: &NodalValues<'_>) -> Result<()> {
        let Pairs { count, constant, proportional } = Pairs::at(values, fractions)?;
        let places = fractions.as_ptr();
        self.call(|model| unsafe { sys::bempd_set_load_values_at(model, load, count, places, constant, proportional) })
    }

    pub(crate) fn fractions_on_edge(&self, region: i32, edge: i32, places: &[[f64; 2]]) -> Result<Vec<EdgePlace>> {
        let (count, places) = points(places);
        let (mut fractions, mut distances) = (vec![0.0; count as usize], vec![0.0; count as usize]);
        let outputs = (fractions.as_mut_ptr(), distances.as_mut_ptr());
        self.call(|model| unsafe {
            sys::bempd_fractions_on_edge(model, region, edge, count, places, outputs.0, outputs.1)
        })?;
        Ok(fractions.into_iter().zip(distances).map(|(fraction, distance)| EdgePlace { fraction, distance }).collect())
    }

    fn edge_size(&self, region: i32, edge: i32) -> Result<(i64, i64)> {
        let mut elements = 0;
        let nodes =
            self.output(|model, nodes| unsafe { sys::bempd_edge_size(model, region, edge, nodes, &mut elements) })?;
        Ok((nodes, elements))
    }

    pub(crate) fn edge_nodes(&self, region: i32, edge: i32) -> Result<Vec<EdgeNode>> {
        let (count, _) = self.edge_size(region, edge)?;
        let mut nodes = vec![0; count as usize];
        let (mut fractions, mut weights) = (vec![0.0; count as usize], vec![0.0; count as usize]);
        let outputs = (nodes.as_mut_ptr(), fractions.as_mut_ptr(), weights.as_mut_ptr());
        self.call(|model| unsafe {
            sys::bempd_copy_edge_nodes(model, region, edge, count, outputs.0, outputs.1, outputs.2)
        })?;
        let node = |i: usize| EdgeNode { node: nodes[i] as usize, fraction: fractions[i], weight: weights[i] };
        Ok((0..count as usize).map(node).collect())
    }

    pub(crate) fn edge_elements(&self, region: i32, edge: i32) -> Result<Vec<i32>> {
        let (_, count) = self.edge_size(region, edge)?;
        let mut elements = vec![0; count as usize];
        let output = elements.as_mut_ptr();
        self.call(|model| unsafe { sys::bempd_copy_edge_elements(model, region, edge, count, output) })?;
        Ok(elements)
    }

    pub(crate) fn edge_forces(&self, region: i32, edge: i32) -> Result<Vec<[f64; 2]>> {
        let (count, _) = self.edge_size(region, edge)?;
        let mut forces = vec![[0.0; 2]; count as usize];
        let output = forces.as_mut_ptr().cast();
        self.call(|model| unsafe { sys::bempd_copy_edge_forces(model, region, edge, count, output) })?;
        Ok(forces)
    }
}
