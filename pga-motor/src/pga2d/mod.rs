//! The plane: rigid motions as motors of Cl(2,0,1).
//!
//! The line a x + b y + c = 0 is `a e1 + b e2 + c e0`; its normal (a, b) is to the left of the way it runs. The point
//! (x, y) is `e12 + x e20 + y e01`. A motor m carries X to m X ~m, and `b * a` applies a first. The rotor of angle t,
//! counter-clockwise, is cos(t/2) - sin(t/2) e12; the translator by (x, y) is 1 - (x e01 - y e20)/2. The operators are
//! those of 3D; a product that is 0 whatever its factors, as `line & line` or `point ^ point`, has none.
//!
//! ```
//! use pga_motor::pga2d::f64::{Direction, Motor, Point, Rotor, Translator};
//!
//! let quarter_turn = Rotor::from_angle(std::f64::consts::FRAC_PI_2);
//! let two_right = Translator::from_vector(Direction::new(2.0, 0.0));
//! let motor = Motor::from_rotor_translator(quarter_turn, two_right);
//! let moved = motor.transform_point(Point::new(1.0, 0.0));
//! assert!(moved.distance_to_point(Point::new(2.0, 1.0)) < 1e-15);
//! ```

mod algebra;
mod bivector;
mod even;
mod interpolate;
mod kind;
mod line;
mod motor;
mod odd;
mod point;
mod products;
mod rigid;
mod rotor;
#[cfg(feature = "proptest")]
pub mod strategies;
mod translator;

pub use algebra::*;
pub use interpolate::{ScrewPath, blend, interpolate_joint};
pub use kind::MotionKind;

/// The types in single precision: `pga2d::f32::Motor` is `pga2d::Motor<f32>`.
pub mod f32 {
    crate::precision::aliases! {
        f32: Motor EvenMultivector Rotor Translator Bivector Line UnitLine Point Direction OddMultivector Pseudoscalar
        ScrewPath
    }
}

/// The types in double precision: `pga2d::f64::Motor` is `pga2d::Motor<f64>`.
pub mod f64 {
    crate::precision::aliases! {
        f64: Motor EvenMultivector Rotor Translator Bivector Line UnitLine Point Direction OddMultivector Pseudoscalar
        ScrewPath
    }
}
