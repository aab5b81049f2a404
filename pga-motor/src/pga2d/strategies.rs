//! Strategies of proptest for the types of the plane, as [`crate::strategies`] for those of space.
//!
//! ```
//! use pga_motor::pga2d::strategies::{motors, points};
//! use proptest::prelude::*;
//!
//! proptest!(|(motor in motors::<f64>(), point in points())| {
//!     let there_and_back = motor.inverse().transform_point(motor.transform_point(point));
//!     let scale = 1.0 + motor.translator().vector().norm() + point.distance_to_point(pga_motor::pga2d::Point::ORIGIN);
//!     // A few roundings of numbers of this scale.
//!     prop_assert!(there_and_back.distance_to_point(point) < 1e-14 * scale);
//! });
//! ```

use super::{Bivector, Direction, Line, Motor, Point, Rotor, Translator, UnitLine};
use crate::Real;
use crate::strategies::{
    angles, angles_near_half_turn, angles_near_identity, greatest_exponent, lengths, signed_powers, small_exponents,
};
use core::fmt::Debug;
use core::ops::Range;
use proptest::prelude::*;
use proptest::sample::select;

/// Directions of length 1: the axes first.
pub fn unit_directions<T: Real + Debug + 'static>() -> impl Strategy<Value = Direction<T>> + Clone {
    let vectors = prop_oneof![1 => select(vec![[1.0, 0.0], [0.0, 1.0]]), 3 => [-1.0..1.0, -1.0..1.0]];
    vectors.prop_filter_map("a direction of length 0", |vector| {
        let [x, y] = vector.map(T::from_f64);
        Direction::new(x, y).normalize()
    })
}

/// Directions of any length, 0 among them.
pub fn directions<T: Real + Debug + 'static>() -> impl Strategy<Value = Direction<T>> + Clone {
    [lengths(), lengths()].prop_map(|[x, y]| Direction::new(x, y))
}

/// Points.
pub fn points<T: Real + Debug + 'static>() -> impl Strategy<Value = Point<T>> + Clone {
    [lengths(), lengths()].prop_map(|[x, y]| Point::new(x, y))
}

/// Lines with a normal of length 1.
pub fn unit_lines<T: Real + Debug + 'static>() -> impl Strategy<Value = UnitLine<T>> + Clone {
    (unit_directions(), lengths()).prop_map(|(normal, c)| UnitLine::new(normal.x, normal.y, c))
}

/// Lines with a normal of any length, 0 among them.
pub fn lines<T: Real + Debug + 'static>() -> impl Strategy<Value = Line<T>> + Clone {
    (directions(), lengths()).prop_map(|(normal, c)| Line::new(normal.x, normal.y, c))
}

/// Any bivectors: points of any weight, ideal points, and 0.
pub fn bivectors<T: Real + Debug + 'static>() -> impl Strategy<Value = Bivector<T>> + Clone {
    let weights = prop_oneof![4 => lengths(), 1 => Just(T::ZERO)];
    (weights, directions()).prop_map(|(weight, d)| Bivector::new(weight, d.y, d.x))
}

/// Rotors of these angles.
fn rotors_by<T: Real + Debug + 'static>(
    angles: impl Strategy<Value = f64> + Clone,
) -> impl Strategy<Value = Rotor<T>> + Clone {
    angles.prop_map(|angle| Rotor::from_angle(T::from_f64(angle)))
}

/// Rotors: of any angle, near the identity and near half a turn, and their negatives.
pub fn rotors<T: Real + Debug + 'static>() -> impl Strategy<Value = Rotor<T>> + Clone {
    prop_oneof![3 => rotors_by(angles()), 1 => rotors_near_identity(), 1 => rotors_near_half_turn()]
}

/// Rotors of angles from 1e-18 to 0.01.
pub fn rotors_near_identity<T: Real + Debug + 'static>() -> impl Strategy<Value = Rotor<T>> + Clone {
    rotors_by(angles_near_identity())
}

/// Rotors that lack or exceed half a turn by an angle from 1e-18, which rounds to none, to 0.01.
pub fn rotors_near_half_turn<T: Real + Debug + 'static>() -> impl Strategy<Value = Rotor<T>> + Clone {
    rotors_by(angles_near_half_turn())
}

/// Translators.
pub fn translators<T: Real + Debug + 'static>() -> impl Strategy<Value = Translator<T>> + Clone {
    directions().prop_map(Translator::from_vector)
}

/// Translators whose coordinates have magnitudes of these powers of ten.
fn translators_of<T: Real + Debug + 'static>(exponents: Range<f64>) -> impl Strategy<Value = Translator<T>> + Clone {
    [signed_powers(exponents.clone()), signed_powers(exponents)].prop_map(|vector| {
        let [x, y] = vector.map(T::from_f64);
        Translator::from_vector(Direction::new(x, y))
    })
}

/// Turns, then translates.
fn motor<T: Real>((translator, rotor): (Translator<T>, Rotor<T>)) -> Motor<T> {
    translator * rotor
}

/// Motors: any, and all the kinds that have a function of their own.
pub fn motors<T: Real + Debug + 'static>() -> impl Strategy<Value = Motor<T>> + Clone {
    prop_oneof![
        3 => (translators(), rotors()).prop_map(motor),
        1 => motors_near_identity(),
        1 => motors_near_half_turn(),
        1 => motors_with_tiny_turn_and_huge_step(),
    ]
}

/// Motors of angles and translations from 1e-18 to 0.01.
pub fn motors_near_identity<T: Real + Debug + 'static>() -> impl Strategy<Value = Motor<T>> + Clone {
    (translators_of(small_exponents()), rotors_near_identity()).prop_map(motor)
}

/// Motors near half a turn with any translation.
pub fn motors_near_half_turn<T: Real + Debug + 'static>() -> impl Strategy<Value = Motor<T>> + Clone {
    (translators(), rotors_near_half_turn()).prop_map(motor)
}

/// Motors of angles from 1e-18 to 0.01 and translations of the largest lengths.
pub fn motors_with_tiny_turn_and_huge_step<T: Real + Debug + 'static>() -> impl Strategy<Value = Motor<T>> + Clone {
    let greatest = greatest_exponent::<T>();
    (translators_of(greatest / 2.0..greatest), rotors_near_identity()).prop_map(motor)
}

/// A motor and its negative, which is the same motion.
pub fn antipodal_motors<T: Real + Debug + 'static>() -> impl Strategy<Value = (Motor<T>, Motor<T>)> + Clone {
    crate::strategies::antipodal(motors())
}

/// Two motors: any, equal, antipodal, and nearly equal or antipodal.
pub fn motor_pairs<T: Real + Debug + 'static>() -> impl Strategy<Value = (Motor<T>, Motor<T>)> + Clone {
    crate::strategies::pairs(motors(), motors_near_identity())
}
