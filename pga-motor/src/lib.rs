//! Rigid motions as motors of projective geometric algebra.
//!
//! A [`Motor`] is a rotation and a translation in one: eight numbers that compose by one product, act on points,
//! directions, lines and planes alike, and have a logarithm to interpolate along. Every operation is a kernel of
//! [`kernels`], generated from its definition in the algebra and proved equal to it; the methods of the types only give
//! the kernels names.
//!
//! ```
//! use pga_motor::f64::{Direction, Motor, Point, Rotor, Translator};
//! use std::f64::consts::FRAC_PI_2;
//!
//! let turn = Rotor::about_z(FRAC_PI_2);
//! let step = Translator::from_vector(Direction::new(2.0, 0.0, 0.0));
//! let motor = step * turn; // first turns, then steps
//! let moved = motor.transform_point(Point::new(1.0, 0.0, 0.0));
//! assert!(moved.distance_to_point(Point::new(2.0, 1.0, 0.0)) < 1e-15);
//!
//! // The same motion in thirds, along the screw that it is.
//! let third = (motor.log() * (1.0 / 3.0)).exp();
//! let thrice = third * third * third;
//! assert!((thrice - motor).norm() < 1e-15);
//! ```
//!
//! # Conventions
//!
//! - The algebra is Cl(3,0,1): e0 squares to 0, e1, e2 and e3 to 1. The plane a x + b y + c z + d = 0 is
//!   `a e1 + b e2 + c e3 + d e0`, the point (x, y, z) is `e123 + x e032 + y e013 + z e021`, a direction the same
//!   without e123. A line is a bivector; one off the Pluecker relation is a screw.
//! - A motor m carries X to m X ~m, written `m >> x` or `m.transform(x)`. `b * a` applies a first.
//! - Right-handed, counter-clockwise, column vectors, as in glam and glTF. Angles are in radians, lengths in the
//!   caller's unit. The rotor of angle t about the unit axis (x, y, z) is cos(t/2) - sin(t/2) (x e23 + y e31 + z e12);
//!   the translator by (x, y, z) is 1 - (x e01 + y e02 + z e03)/2.
//! - Operators: `*` geometric product, `^` meet, `&` join, `|` inner product, `>>` sandwich. A product that is 0 whatever
//!   its factors has no operator: `plane & plane`, `point ^ point`, `line ^ point`, `point | direction` and the like.
//! - Types are promises: a [`Motor`] is unit and an [`EvenMultivector`] need not be, likewise [`UnitLine`] and
//!   [`Line`], [`UnitPlane`] and [`Plane`]. What needs a unit takes a unit; `normalize` leads there and answers `None`
//!   where there is no way. `new` and the public fields leave the promise to the caller, and `is_unit` checks it.
//!
//! # Features
//!
//! `std` (default) or else `libm` provides square roots and trigonometry, [`Real`], for `f32` and `f64`; without either
//! the polynomial kernels remain. `glam` adds conversions to and from glam, `gltf` the reader of glTF files
//! `import::gltf`, `proptest` strategies for the types, `rayon` crowds on all cores.
#![cfg_attr(not(any(feature = "std", test)), no_std)]
#![deny(unsafe_code)]

extern crate alloc;

mod algebra;
mod alignment;
pub mod batch;
mod even;
mod four;
pub mod game;
pub mod gf3;
pub mod import;
mod instructions;
#[cfg(feature = "glam")]
pub mod interop;
mod interpolate;
mod line;
mod magnitude;
mod motor;
mod odd;
pub mod pga2d;
mod plane;
mod point;
mod precision;
mod products;
pub mod rigid;
mod rotor;
pub mod scalar;
mod screw;
pub mod skeleton;
mod slices;
#[cfg(feature = "proptest")]
pub mod strategies;
mod translator;
mod weights;

pub use algebra::*;
pub use interpolate::{ScrewPath, blend, interpolate_joint};
pub use kernels::{DirectionMatrix, LineMatrix, Matrix, PlaneMatrix};
pub use rigid::NotRigid;
pub use scalar::{Real, Scalar};
pub use screw::{MotionKind, Screw};
pub use slices::LengthMismatch;

/// The types in single precision: `pga_motor::f32::Motor` is `pga_motor::Motor<f32>`. Those of the plane are in
/// [`pga2d::f32`].
pub mod f32 {
    crate::precision::aliases! {
        f32: Motor EvenMultivector Rotor Translator Line UnitLine Plane UnitPlane Point Direction ProjectivePoint
        OddMultivector Pseudoscalar Matrix DirectionMatrix LineMatrix PlaneMatrix Screw ScrewPath
    }
    crate::precision::aliases! { f32 in skeleton: Aim Clip Joint Pose Poses Retarget RootMotion ScrewCache Skeleton SkeletonInstance TwoBone }
    crate::precision::aliases! { f32 in game: MotorGame }
}

/// The types in double precision: `pga_motor::f64::Motor` is `pga_motor::Motor<f64>`. Those of the plane are in
/// [`pga2d::f64`].
pub mod f64 {
    crate::precision::aliases! {
        f64: Motor EvenMultivector Rotor Translator Line UnitLine Plane UnitPlane Point Direction ProjectivePoint
        OddMultivector Pseudoscalar Matrix DirectionMatrix LineMatrix PlaneMatrix Screw ScrewPath
    }
    crate::precision::aliases! { f64 in skeleton: Aim Clip Joint Pose Poses Retarget RootMotion ScrewCache Skeleton SkeletonInstance TwoBone }
    crate::precision::aliases! { f64 in game: MotorGame }
}
