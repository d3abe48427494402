//! Edges as hosts that couple see them: their nodes, the forces on them, and values given there.

use std::ops::RangeBounds;

use crate::conditions::edge_part;
use crate::{LoadId, Model, RegionId, Result, SupportId};

/// A node on an edge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EdgeNode {
    /// Index into the fields of the region's nodes.
    pub node: usize,
    /// Place of the node, as a fraction of the edge [-].
    pub fraction: f64,
    /// Integral of its shape function along the edge [m].
    pub weight: f64,
}

/// The place on an edge nearest to a given one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EdgePlace {
    /// Nearest place on the edge, as a fraction of it [-].
    pub fraction: f64,
    /// Distance of the given place from it [m].
    pub distance: f64,
}

/// Values with x and y for each node or place: a constant part, one that is multiplied by the load factor, or both.
#[derive(Clone, Copy, Debug, Default)]
pub struct NodalValues<'a> {
    /// Constant part; none for 0.
    pub constant: Option<&'a [[f64; 2]]>,
    /// Part multiplied by the load factor; none for 0.
    pub proportional: Option<&'a [[f64; 2]]>,
}

impl<'a> NodalValues<'a> {
    /// Values that do not follow the load factor.
    pub fn constant(values: &'a [[f64; 2]]) -> Self {
        NodalValues { constant: Some(values), proportional: None }
    }

    /// Values multiplied by the load factor.
    pub fn proportional(values: &'a [[f64; 2]]) -> Self {
        NodalValues { constant: None, proportional: Some(values) }
    }
}

/// # Edges, for hosts that couple
impl Model {
    /// Adds forces [N] on the nodes of a part of an edge: 0 until [`Model::set_load_nodal_values`] gives each its own.
    pub fn add_edge_forces(&mut self, region: RegionId, edge: i32, part: impl RangeBounds<f64>) -> Result<LoadId> {
        self.handle.add_edge_forces(edge_part(region, edge, part)).map(LoadId)
    }

    /// Gives every node that a support on an edge holds its displacement [m]: those of [`Model::edge_nodes`], in that
    /// order.
    pub fn set_support_nodal_values(&mut self, support: SupportId, values: NodalValues<'_>) -> Result<()> {
        self.handle.set_support_nodal_values(support.0, &values)
    }

    /// Gives a load on an edge its values at the nodes there: forces [N] as they are, or tractions [Pa].
    pub fn set_load_nodal_values(&mut self, load: LoadId, values: NodalValues<'_>) -> Result<()> {
        self.handle.set_load_nodal_values(load.0, &values)
    }

    /// Gives a support new displacements [m] at places along its part of an edge, ascending fractions of it, linear
    /// between them; also one that was given by a function.
    pub fn set_support_values_at(
        &mut self,
        support: SupportId,
        fractions: &[f64],
        values: NodalValues<'_>,
    ) -> Result<()> {
        self.handle.set_support_values_at(support.0, fractions, &values)
    }

    /// Gives a load along an edge or a crack new values at places; as [`Model::set_support_values_at`].
    pub fn set_load_values_at(&mut self, load: LoadId, fractions: &[f64], values: NodalValues<'_>) -> Result<()> {
        self.handle.set_load_values_at(load.0, fractions, &values)
    }

    /// The nearest places on an edge, such as for the nodes of another program's mesh.
    pub fn fractions_on_edge(&self, region: RegionId, edge: i32, places: &[[f64; 2]]) -> Result<Vec<EdgePlace>> {
        self.handle.fractions_on_edge(region.0, edge, places)
    }

    /// Nodes on an edge from its start to its end.
    pub fn edge_nodes(&self, region: RegionId, edge: i32) -> Result<Vec<EdgeNode>> {
        self.handle.edge_nodes(region.0, edge)
    }

    /// Elements or lattice cells with a side on an edge, from its start to its end: indices into [`Model::elements`].
    pub fn edge_elements(&self, region: RegionId, edge: i32) -> Result<Vec<usize>> {
        Ok(self.handle.edge_elements(region.0, edge)?.into_iter().map(|element| element as usize).collect())
    }

    /// Forces [N] that supports and neighbours exert on a region at the nodes of an edge: they do the work that is
    /// booked, and sum to the reaction to rounding.
    pub fn edge_forces(&self, region: RegionId, edge: i32) -> Result<Vec<[f64; 2]>> {
        self.handle.edge_forces(region.0, edge)
    }
}
