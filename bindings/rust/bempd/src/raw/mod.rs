//! The layer between safe Rust and the C interface: one short method a function, and all of the crate's `unsafe`.
#![allow(unsafe_code)]

mod callbacks;
mod cancel;
mod conditions;
mod edges;
mod handle;
mod library;
mod load_cases;
mod results;
mod scene;
mod state;
mod stepping;

pub(crate) use cancel::CancelTarget;
pub(crate) use conditions::EdgePart;
pub(crate) use handle::Handle;
pub(crate) use library::{build_info, options, version};
pub use results::View;
pub use state::State;

/// Count and address of an array of points as the C interface wants them.
fn points(points: &[[f64; 2]]) -> (i64, *const f64) {
    (points.len() as i64, points.as_ptr().cast())
}
