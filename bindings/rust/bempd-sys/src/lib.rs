//! The C interface of `bempd` as declared in `bempd.h`, one to one. Use the crate `bempd` instead unless you need what
//! it does not have.
//!
//! The build script finds the shared library by the environment variable `BEMPD_LIB_DIR`, else by `pkg-config`, else in
//! the build tree of the repository that holds this crate. It passes the folder on as `DEP_BEMPD_LIB_DIR` to the build
//! scripts of packages that depend on this one, so that they can put it into the run path of their programs.
#![allow(non_camel_case_types, rustdoc::all)]

mod bindings;
pub use bindings::*;
