//! The plane.

mod algebra;

pub use algebra::*;
