//! What the crate promises its hosts. The files are modules of one program, which compiles in half of the time of eight.

#[macro_use]
mod common;
mod callbacks;
mod edges;
mod misuse;
mod new_values;
mod pieces;
mod results;
mod state;
mod threads;
