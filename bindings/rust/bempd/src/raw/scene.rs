use bempd_sys as sys;

use super::handle::{filled, terminated, Handle};
use super::points;
use crate::{Error, Material, Result};

// Address of numbers of which there is one for each edge.
fn of_edges(vertices: &[[f64; 2]], bulges: &[f64]) -> Result<*const f64> {
    if vertices.len() == bulges.len() {
        return Ok(bulges.as_ptr());
    }
    Err(Error::Argument(format!("there are {} bulges for {} edges; give one for each", bulges.len(), vertices.len())))
}

// SAFETY, for every call of this file: `call` and `output` give a valid model and place for the result, and arrays are
// given with their own length.
impl Handle {
    pub(crate) fn add_material(&mut self, material: &Material) -> Result<i32> {
        let mut raw = filled(sys::bempd_material_init)?;
        material.write_to(&mut raw);
        self.output(|model, id| unsafe { sys::bempd_add_material(model, &raw, id) })
    }

    pub(crate) fn add_body(&mut self, material: i32, vertices: &[[f64; 2]]) -> Result<i32> {
        let (count, vertices) = points(vertices);
        self.output(|model, body| unsafe { sys::bempd_add_body(model, material, count, vertices, body) })
    }

    pub(crate) fn add_body_with_arcs(&mut self, material: i32, vertices: &[[f64; 2]], bulges: &[f64]) -> Result<i32> {
        let bulges = of_edges(vertices, bulges)?;
        let (count, vertices) = points(vertices);
        self.output(|model, body| unsafe {
            sys::bempd_add_body_with_arcs(model, material, count, vertices, bulges, body)
        })
    }

    pub(crate) fn set_body_lattice(&mut self, body: i32, spacing: f64, horizon_ratio: i32) -> Result<()> {
        self.call(|model| unsafe { sys::bempd_set_body_lattice(model, body, spacing, horizon_ratio) })
    }

    pub(crate) fn set_crack_treatment(&mut self, crack: i32, treatment: i32) -> Result<()> {
        self.call(|model| unsafe { sys::bempd_set_crack_treatment(model, crack, treatment) })
    }

    pub(crate) fn add_bem_region(&mut self, material: i32, vertices: &[[f64; 2]], element_length: f64) -> Result<i32> {
        let (count, vertices) = points(vertices);
        self.output(|model, region| unsafe {
            sys::bempd_add_bem_region(model, material, count, vertices, element_length, region)
        })
    }

    pub(crate) fn add_bem_region_with_arcs(
        &mut self,
        material: i32,
        vertices: &[[f64; 2]],
        bulges: &[f64],
        element_length: f64,
    ) -> Result<i32> {
        let bulges = of_edges(vertices, bulges)?;
        let (count, vertices) = points(vertices);
        self.output(|model, region| unsafe {
            sys::bempd_add_bem_region_with_arcs(model, material, count, vertices, bulges, element_length, region)
        })
    }

    pub(crate) fn add_bem_disc(&mut self, material: i32, [x, y]: [f64; 2], radius: f64, length: f64) -> Result<i32> {
        self.output(|model, region| unsafe { sys::bempd_add_bem_disc(model, material, x, y, radius, length, region) })
    }

    pub(crate) fn add_pd_region(
        &mut self,
        material: i32,
        vertices: &[[f64; 2]],
        spacing: f64,
        horizon_ratio: i32,
    ) -> Result<i32> {
        let (count, vertices) = points(vertices);
        self.output(|model, region| unsafe {
            sys::bempd_add_pd_region(model, material, count, vertices, spacing, horizon_ratio, region)
        })
    }

    pub(crate) fn add_pd_region_with_arcs(
        &mut self,
        material: i32,
        vertices: &[[f64; 2]],
        bulges: &[f64],
        spacing: f64,
        horizon_ratio: i32,
    ) -> Result<i32> {
        let bulges = of_edges(vertices, bulges)?;
        let (count, vertices) = points(vertices);
        self.output(|model, region| unsafe {
            sys::bempd_add_pd_region_with_arcs(model, material, count, vertices, bulges, spacing, horizon_ratio, region)
        })
    }

    pub(crate) fn add_turned_pd_region(
        &mut self,
        material: i32,
        vertices: &[[f64; 2]],
        spacing: f64,
        horizon_ratio: i32,
        angle: f64,
    ) -> Result<i32> {
        let (count, vertices) = points(vertices);
        self.output(|model, region| unsafe {
            let straight = std::ptr::null();
            sys::bempd_add_turned_pd_region(
                model,
                material,
                count,
                vertices,
                straight,
                spacing,
                horizon_ratio,
                angle,
                region,
            )
        })
    }

    pub(crate) fn add_hole(&mut self, region: i32, vertices: &[[f64; 2]]) -> Result<i32> {
        let (count, vertices) = points(vertices);
        self.output(|model, first_edge| unsafe { sys::bempd_add_hole(model, region, count, vertices, first_edge) })
    }

    pub(crate) fn add_hole_with_arcs(&mut self, region: i32, vertices: &[[f64; 2]], bulges: &[f64]) -> Result<i32> {
        let bulges = of_edges(vertices, bulges)?;
        let (count, vertices) = points(vertices);
        self.output(|model, first_edge| unsafe {
            sys::bempd_add_hole_with_arcs(model, region, count, vertices, bulges, first_edge)
        })
    }

    pub(crate) fn add_circular_hole(&mut self, region: i32, [x, y]: [f64; 2], radius: f64) -> Result<i32> {
        self.output(|model, first_edge| unsafe {
            sys::bempd_add_circular_hole(model, region, x, y, radius, first_edge)
        })
    }

    pub(crate) fn set_edge_arc(&mut self, region: i32, edge: i32, [x, y]: [f64; 2]) -> Result<()> {
        self.call(|model| unsafe { sys::bempd_set_edge_arc(model, region, edge, x, y) })
    }

    pub(crate) fn set_edge_arc_about(
        &mut self,
        region: i32,
        edge: i32,
        [x, y]: [f64; 2],
        radius: f64,
        turn: i32,
    ) -> Result<()> {
        self.call(|model| unsafe { sys::bempd_set_edge_arc_about(model, region, edge, x, y, radius, turn) })
    }

    pub(crate) fn set_edges_smooth(&mut self, region: i32, first_edge: i32, last_edge: i32) -> Result<()> {
        self.call(|model| unsafe { sys::bempd_set_edges_smooth(model, region, first_edge, last_edge) })
    }

    pub(crate) fn set_edge_mesh(&mut self, region: i32, edge: i32, element_length: f64, grading: f64) -> Result<()> {
        self.call(|model| unsafe { sys::bempd_set_edge_mesh(model, region, edge, element_length, grading) })
    }

    pub(crate) fn set_toughness_at(&mut self, region: i32, places: &[[f64; 2]], values: &[f64]) -> Result<()> {
        if places.len() != values.len() {
            return Err(Error::Argument(format!(
                "there are {} values for {} places; give one for each",
                values.len(),
                places.len()
            )));
        }
        let (count, places) = points(places);
        self.call(|model| unsafe { sys::bempd_set_toughness_at(model, region, count, places, values.as_ptr()) })
    }

    pub(crate) fn set_resistance_curve(&mut self, material: i32, extensions: &[f64], energies: &[f64]) -> Result<()> {
        let count = rows_of(extensions, energies)?;
        self.call(|model| unsafe {
            sys::bempd_set_resistance_curve(model, material, count, extensions.as_ptr(), energies.as_ptr())
        })
    }

    pub(crate) fn set_resistance_directions(&mut self, material: i32, angles: &[f64], energies: &[f64]) -> Result<()> {
        let count = rows_of(angles, energies)?;
        self.call(|model| unsafe {
            sys::bempd_set_resistance_directions(model, material, count, angles.as_ptr(), energies.as_ptr())
        })
    }

    pub(crate) fn add_crack(&mut self, line: &[[f64; 2]]) -> Result<i32> {
        let (count, line) = points(line);
        self.output(|model, crack| unsafe { sys::bempd_add_crack(model, count, line, crack) })
    }

    pub(crate) fn remove_region(&mut self, region: i32) -> Result<()> {
        self.call(|model| unsafe { sys::bempd_remove_region(model, region) })
    }

    pub(crate) fn remove_crack(&mut self, crack: i32) -> Result<()> {
        self.call(|model| unsafe { sys::bempd_remove_crack(model, crack) })
    }

    pub(crate) fn region_count(&self) -> Result<i32> {
        self.output(|model, count| unsafe { sys::bempd_region_count(model, count) })
    }

    pub(crate) fn edge_count(&self, region: i32) -> Result<i32> {
        self.output(|model, count| unsafe { sys::bempd_edge_count(model, region, count) })
    }

    pub(crate) fn name_region(&mut self, region: i32, name: &str) -> Result<()> {
        let name = terminated(name)?;
        self.call(|model| unsafe { sys::bempd_name_region(model, region, name.as_ptr()) })
    }

    pub(crate) fn name_edge(&mut self, region: i32, edge: i32, name: &str) -> Result<()> {
        let name = terminated(name)?;
        self.call(|model| unsafe { sys::bempd_name_edge(model, region, edge, name.as_ptr()) })
    }

    pub(crate) fn name_support(&mut self, support: i32, name: &str) -> Result<()> {
        let name = terminated(name)?;
        self.call(|model| unsafe { sys::bempd_name_support(model, support, name.as_ptr()) })
    }

    pub(crate) fn name_load(&mut self, load: i32, name: &str) -> Result<()> {
        let name = terminated(name)?;
        self.call(|model| unsafe { sys::bempd_name_load(model, load, name.as_ptr()) })
    }

    pub(crate) fn edge_named(&self, region: i32, name: &str) -> Result<i32> {
        let name = terminated(name)?;
        self.output(|model, edge| unsafe { sys::bempd_edge_named(model, region, name.as_ptr(), edge) })
    }
}

/// Number of rows of a table of fracture energies.
fn rows_of(places: &[f64], energies: &[f64]) -> Result<i64> {
    if places.len() != energies.len() {
        return Err(Error::Argument(format!(
            "there are {} energies for {} rows; give one for each",
            energies.len(),
            places.len()
        )));
    }
    Ok(places.len() as i64)
}
