use std::ops::{Bound, RangeBounds};

use crate::raw::EdgePart;
use crate::{Component, CrackId, FaceComponent, LoadId, Model, RegionId, Result, SupportId};

/// Values along a part of an edge: `constant + load_factor * proportional`, each 0 where not given. One value is
/// uniform, two are linear from start to end, n are values at n equally spaced places with linear ones between.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Values<'a> {
    pub(crate) constant: Option<&'a [f64]>,
    pub(crate) proportional: Option<&'a [f64]>,
}

impl<'a> Values<'a> {
    /// Values that do not depend on the load factor.
    pub fn constant(values: &'a [f64]) -> Values<'a> {
        Values { constant: Some(values), proportional: None }
    }

    /// Values per unit of the load factor.
    pub fn proportional(values: &'a [f64]) -> Values<'a> {
        Values { constant: None, proportional: Some(values) }
    }

    /// Values with a constant and a proportional part of the same length.
    pub fn both(constant: &'a [f64], proportional: &'a [f64]) -> Values<'a> {
        Values { constant: Some(constant), proportional: Some(proportional) }
    }
}

/// What a boundary function gives at a place, in x and y: `constant + load_factor * proportional`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BoundaryValue {
    /// The constant part.
    pub constant: [f64; 2],
    /// The part multiplied by the load factor.
    pub proportional: [f64; 2],
}

/// A part given as fractions of the edge, such as `..` or `0.2..0.5`.
pub(crate) fn edge_part(region: RegionId, edge: i32, part: impl RangeBounds<f64>) -> EdgePart {
    let number = |bound: Bound<&f64>, open: f64| match bound {
        Bound::Included(&value) | Bound::Excluded(&value) => value,
        Bound::Unbounded => open,
    };
    EdgePart { region: region.0, edge, from: number(part.start_bound(), 0.0), to: number(part.end_bound(), 1.0) }
}

/// # Supports and loads
///
/// A part of an edge is a range of fractions of it: `..` for the whole edge, `0.2..0.5` for a part. Boundary functions
/// are asked while the call that receives them runs and when the model is prepared; `None` makes the call fail with
/// [`Error::Cancelled`](crate::Error::Cancelled).
impl Model {
    /// Fixes a whole edge: displacement 0.
    pub fn fix_edge(&mut self, region: RegionId, edge: i32, component: Component) -> Result<SupportId> {
        self.handle.fix_edge(region.0, edge, component as i32).map(SupportId)
    }

    /// Fixes the node or material point at a place [m]. Boundary elements put a node at a place on their boundary.
    pub fn fix_point(&mut self, place: [f64; 2], component: Component) -> Result<SupportId> {
        self.handle.fix_point(place, component as i32).map(SupportId)
    }

    /// Prescribes the displacement of an edge or a part of it [m], along x or y.
    pub fn prescribe_edge(
        &mut self,
        region: RegionId,
        edge: i32,
        part: impl RangeBounds<f64>,
        component: Component,
        values: Values<'_>,
    ) -> Result<SupportId> {
        self.handle.prescribe_edge(edge_part(region, edge, part), component as i32, &values).map(SupportId)
    }

    /// Prescribes the displacement of a part of an edge by a function of the position `x, y` [m].
    ///
    /// ```
    /// use bempd::{BoundaryValue, Component};
    /// # let mut model = bempd::Model::new()?;
    /// # let steel = model.add_material(&bempd::Material::new(210e9, 0.3))?;
    /// # let beam = model.add_bem_region(steel, &[[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [0.0, 1.0]], 0.5)?;
    /// # model.fix_edge(beam, 4, Component::Both)?;
    /// model.prescribe_edge_function(beam, 2, .., Component::X, |_, y| {
    ///     Some(BoundaryValue { proportional: [1e-3 * (y - 0.5), 0.0], ..Default::default() })
    /// })?;
    /// # model.step(1.0)?;
    /// # Ok::<(), bempd::Error>(())
    /// ```
    pub fn prescribe_edge_function(
        &mut self,
        region: RegionId,
        edge: i32,
        part: impl RangeBounds<f64>,
        component: Component,
        function: impl FnMut(f64, f64) -> Option<BoundaryValue> + Send + 'static,
    ) -> Result<SupportId> {
        let part = edge_part(region, edge, part);
        self.handle.prescribe_edge_function(part, component as i32, Box::new(function)).map(SupportId)
    }

    /// Prescribes the displacement of the node or material point at a place [m], along x or y.
    pub fn prescribe_point(
        &mut self,
        place: [f64; 2],
        component: Component,
        constant: f64,
        proportional: f64,
    ) -> Result<SupportId> {
        self.handle.prescribe_point(place, component as i32, constant, proportional).map(SupportId)
    }

    /// Adds a traction [Pa], along x or y, on a part of an edge that is not an interface.
    pub fn add_traction(
        &mut self,
        region: RegionId,
        edge: i32,
        part: impl RangeBounds<f64>,
        component: Component,
        values: Values<'_>,
    ) -> Result<LoadId> {
        self.handle.add_traction(edge_part(region, edge, part), component as i32, &values).map(LoadId)
    }

    /// Presses [Pa] on a part of an edge that is not an interface, against its outward normal.
    pub fn add_pressure(
        &mut self,
        region: RegionId,
        edge: i32,
        part: impl RangeBounds<f64>,
        values: Values<'_>,
    ) -> Result<LoadId> {
        self.handle.add_pressure(edge_part(region, edge, part), &values).map(LoadId)
    }

    /// Adds a traction [Pa], both components, given by a function of the position `x, y` [m].
    pub fn add_traction_function(
        &mut self,
        region: RegionId,
        edge: i32,
        part: impl RangeBounds<f64>,
        function: impl FnMut(f64, f64) -> Option<BoundaryValue> + Send + 'static,
    ) -> Result<LoadId> {
        self.handle.add_traction_function(edge_part(region, edge, part), Box::new(function)).map(LoadId)
    }

    /// Adds a traction [Pa] on both faces of a crack in a boundary element region; values run along the crack.
    pub fn add_crack_traction(
        &mut self,
        crack: CrackId,
        component: FaceComponent,
        values: Values<'_>,
    ) -> Result<LoadId> {
        self.handle.add_crack_traction(crack.0, component as i32, &values).map(LoadId)
    }

    /// Adds a force [N], along x or y, on the node or material point at a place [m].
    pub fn add_point_force(
        &mut self,
        place: [f64; 2],
        component: Component,
        constant: f64,
        proportional: f64,
    ) -> Result<LoadId> {
        self.handle.add_point_force(place, component as i32, constant, proportional).map(LoadId)
    }

    /// Adds a uniform pressure [Pa] in a crack, which follows wherever it grows, in either kind of region.
    pub fn add_crack_pressure(&mut self, crack: CrackId, constant: f64, proportional: f64) -> Result<LoadId> {
        self.handle.add_crack_pressure(crack.0, constant, proportional).map(LoadId)
    }

    /// Adds a force per volume [N/m^3], along x or y, on a whole region, such as its weight.
    pub fn add_body_force(
        &mut self,
        region: RegionId,
        component: Component,
        constant: f64,
        proportional: f64,
    ) -> Result<LoadId> {
        self.handle.add_body_force(region.0, component as i32, constant, proportional).map(LoadId)
    }

    /// Lets a region turn about an axis [m]: density times angular velocity squared [N/m^4].
    pub fn add_rotation(
        &mut self,
        region: RegionId,
        axis: [f64; 2],
        constant: f64,
        proportional: f64,
    ) -> Result<LoadId> {
        self.handle.add_rotation(region.0, axis, constant, proportional).map(LoadId)
    }

    /// Changes the temperature [K] of a region by a function of the position `x, y` [m]: the first numbers of what it
    /// gives count. In a boundary element region it has to be linear.
    pub fn add_temperature_function(
        &mut self,
        region: RegionId,
        function: impl FnMut(f64, f64) -> Option<BoundaryValue> + Send + 'static,
    ) -> Result<LoadId> {
        self.handle.add_temperature_function(region.0, Box::new(function)).map(LoadId)
    }

    /// Changes the temperature [K] of a whole region.
    pub fn add_temperature(&mut self, region: RegionId, constant: f64, proportional: f64) -> Result<LoadId> {
        self.handle.add_temperature(region.0, constant, proportional).map(LoadId)
    }

    /// Gives a traction or point force that was not given by a function new values, as many as it was made with, at any
    /// time. The new load acts from the next step on: that step begins by finding equilibrium at the present load factor.
    pub fn set_load_values(&mut self, load: LoadId, values: Values<'_>) -> Result<()> {
        self.handle.set_load_values(load.0, &values)
    }

    /// Gives a support that was not given by a function new displacements [m]; as [`Model::set_load_values`], with one
    /// value for a fixed edge or point.
    pub fn set_support_values(&mut self, support: SupportId, values: Values<'_>) -> Result<()> {
        self.handle.set_support_values(support.0, &values)
    }
    /// Removes a support before the model is prepared; other ids stay.
    pub fn remove_support(&mut self, support: SupportId) -> Result<()> {
        self.handle.remove_support(support.0)
    }

    /// Removes a load before the model is prepared; other ids stay.
    pub fn remove_load(&mut self, load: LoadId) -> Result<()> {
        self.handle.remove_load(load.0)
    }
}
