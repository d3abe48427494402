//! Cracks in two-dimensional elastic bodies: boundary elements where the body is sound, bond-based peridynamics where
//! cracks run, coupled and solved quasi-statically.
//!
//! A run goes as follows: make a [`Model`]; add materials, regions, cracks, supports and loads; step; ask for results.
//!
//! ```
//! use bempd::{Component, Field, Material, Model, Values};
//!
//! # fn main() -> bempd::Result<()> {
//! let mut model = Model::new()?;
//! let steel = model.add_material(&Material::new(210e9, 0.3))?;
//! let plate = model.add_bem_region(steel, &[[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [0.0, 1.0]], 0.25)?;
//! model.fix_edge(plate, 4, Component::X)?;
//! model.fix_point([0.0, 0.0], Component::Y)?;
//! model.add_traction(plate, 2, .., Component::X, Values::proportional(&[1e6]))?;
//!
//! model.step(3.0)?;
//! let displacement = model.view(plate, Field::Displacement)?;
//! let largest = displacement.entries::<2>().unwrap().iter().map(|u| u[0]).fold(0.0, f64::max);
//! assert!((largest / (3e6 / 210e9 * 2.0) - 1.0).abs() < 1e-9);
//! # Ok(())
//! # }
//! ```
//!
//! **Units.** Any consistent set; the SI unit of each number stands in brackets, [-] marks a pure number. Forces and
//! energies are those of the whole thickness.
//!
//! **Load factor.** Every prescribed displacement, traction and force is `constant + load_factor * proportional`.
//! Stepping moves the load factor; it starts at 0.
//!
//! **Signs.** Stress is positive in tension; a traction is the force per area that acts on the body; loops of vertices
//! have the body on their left. Ids and numbers of edges start at 1, indices at 0.
//!
//! **Panics.** A panic inside a closure does not cross the library: the call is cancelled, the model returns to where it
//! was, and the panic goes on in the caller.
#![warn(missing_docs)]
#![deny(unsafe_code)]
// Units stand in brackets, which rustdoc takes for links.
#![allow(rustdoc::broken_intra_doc_links)]

mod cancel;
mod conditions;
mod edges;
mod error;
mod fatigue;
mod ids;
mod kinds;
mod load_cases;
mod material;
mod model;
mod options;
mod raw;
mod reports;
mod results;

pub use cancel::CancelToken;
pub use conditions::{BoundaryValue, Values};
pub use edges::{EdgeNode, EdgePlace, NodalValues};
pub use error::{Error, Result};
pub use fatigue::{Block, CaseBlock, FatigueOptions, GrowingTip, GrowthRate, RateLaw, Retardation};
pub use ids::{CrackId, LoadCaseId, LoadId, MaterialId, RegionId, SupportId};
pub use kinds::{
    BondState, Component, ErrorSource, Face, FaceComponent, Field, LoadRule, LogLevel, NextEvent, Plane, ProgramColumn,
    SingularityKind, StopReason, TipEnd, TipMethod, Treatment, Turn, Until,
};
pub use material::Material;
pub use model::Model;
pub use options::{options, OptionInfo, OptionKind};
pub use raw::{State, View};
pub use reports::{
    BodyPlan, CrackExtension, CrackTip, Errors, Explanation, FatigueRecord, FatigueReport, Growth, HistoryEntry,
    PathVertex, PhaseProgress, Piece, Progress, RunErrors, Singularity, Statistics, StepReport, TipRecord,
};
pub use results::{Bond, CrackOpening, EdgeReaction, Elements, HistorySupport, PointValues};

/// Version of the library as "major.minor.patch".
pub fn version() -> &'static str {
    raw::version()
}

/// One line on how the library was built: factorization backend, compiler, BLAS in use.
pub fn build_info() -> &'static str {
    raw::build_info()
}
