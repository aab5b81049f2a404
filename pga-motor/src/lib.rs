//! Rigid motions as motors of projective geometric algebra.
#![cfg_attr(not(any(feature = "std", test)), no_std)]
#![deny(unsafe_code)]

mod algebra;
pub mod pga2d;
pub mod scalar;

pub use algebra::*;
pub use scalar::{Real, Scalar};
