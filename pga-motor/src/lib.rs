//! Rigid motions as motors of projective geometric algebra.
#![cfg_attr(not(any(feature = "std", test)), no_std)]
#![deny(unsafe_code)]

mod algebra;
mod even;
#[cfg(feature = "glam")]
pub mod interop;
mod line;
mod magnitude;
mod motor;
mod odd;
pub mod pga2d;
mod plane;
mod point;
mod precision;
mod rotor;
pub mod scalar;
mod translator;

pub use algebra::*;
pub use motor::LengthMismatch;
pub use scalar::{Real, Scalar};

/// The types in single precision: `pga_motor::f32::Motor` is `pga_motor::Motor<f32>`. Those of the plane are in
/// [`pga2d::f32`](crate::pga2d::f32).
pub mod f32 {
    crate::precision::aliases! {
        f32: Motor EvenMultivector Rotor Translator Line UnitLine Plane UnitPlane Point Direction ProjectivePoint
        OddMultivector Pseudoscalar
    }
}

/// The types in double precision: `pga_motor::f64::Motor` is `pga_motor::Motor<f64>`. Those of the plane are in
/// [`pga2d::f64`](crate::pga2d::f64).
pub mod f64 {
    crate::precision::aliases! {
        f64: Motor EvenMultivector Rotor Translator Line UnitLine Plane UnitPlane Point Direction ProjectivePoint
        OddMultivector Pseudoscalar
    }
}
