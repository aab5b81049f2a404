//! Strategies of proptest for the types of this crate, the values at which formulas fail among them. Those of the plane
//! are in [`pga2d::strategies`](crate::pga2d::strategies).
//!
//! Generic over the precision: `motors::<f32>()`, `motors::<f64>()`. Values shrink to simple ones. Lengths are mostly
//! below ten, sometimes up to 1e8, or to 1e4 for formats as coarse as `f32`. What a type promises holds up to rounding.
//!
//! ```
//! use pga_motor::strategies::{motors, points};
//! use proptest::prelude::*;
//!
//! proptest!(|(motor in motors::<f64>(), point in points())| {
//!     let there_and_back = motor.inverse().transform_point(motor.transform_point(point));
//!     let scale = 1.0 + motor.translator().vector().norm() + point.distance_to_point(pga_motor::Point::ORIGIN);
//!     // A few roundings of numbers of this scale.
//!     prop_assert!(there_and_back.distance_to_point(point) < 1e-14 * scale);
//! });
//! ```

use crate::{Direction, Line, Motor, Plane, Point, Real, Rotor, Translator, UnitLine, UnitPlane};
use core::f64::consts::PI;
use core::fmt::Debug;
use core::ops::{Mul, Neg, Range};
use proptest::prelude::*;
use proptest::sample::select;

/// The greatest power of ten of a length.
pub(crate) fn greatest_exponent<T: Real>() -> f64 {
    if T::EPSILON.to_f64() < 1e-10 { 8.0 } else { 4.0 }
}

/// The powers of ten of what is near 0.
pub(crate) fn small_exponents() -> Range<f64> {
    -18.0..-2.0
}

pub(crate) fn signed_powers(exponents: Range<f64>) -> impl Strategy<Value = f64> + Clone {
    (exponents, select(vec![1.0, -1.0])).prop_map(|(exponent, sign)| sign * 10_f64.powf(exponent))
}

/// A whole number, any up to ten, or one of any magnitude.
pub(crate) fn lengths<T: Real + Debug>() -> impl Strategy<Value = T> + Clone {
    let greatest = greatest_exponent::<T>();
    let lengths = prop_oneof![
        4 => (-9..=9).prop_map(f64::from),
        3 => -10.0..10.0,
        1 => signed_powers(-greatest..greatest),
    ];
    lengths.prop_map(T::from_f64)
}

/// Any angle up to a turn and a bit, both ways, those with simple sines first.
pub(crate) fn angles() -> impl Strategy<Value = f64> + Clone {
    prop_oneof![1 => select(vec![0.0, PI / 2.0, PI, -PI / 2.0, 2.0 * PI]), 3 => -7.0..7.0]
}

/// Angles from 1e-18 to 0.01, both ways.
pub(crate) fn angles_near_identity() -> impl Strategy<Value = f64> + Clone {
    signed_powers(small_exponents())
}

/// Angles that lack or exceed half a turn by as little.
pub(crate) fn angles_near_half_turn() -> impl Strategy<Value = f64> + Clone {
    angles_near_identity().prop_map(|distance| PI + distance)
}

/// A motor and its negative.
pub(crate) fn antipodal<M: Copy + Debug + Neg<Output = M>>(
    motors: impl Strategy<Value = M> + Clone,
) -> impl Strategy<Value = (M, M)> + Clone {
    motors.prop_map(|motor| (motor, -motor))
}

/// Two motors: any, equal, antipodal, and by a step from equal or antipodal.
pub(crate) fn pairs<M: Copy + Debug + Neg<Output = M> + Mul<Output = M>>(
    motors: impl Strategy<Value = M> + Clone,
    steps: impl Strategy<Value = M> + Clone,
) -> impl Strategy<Value = (M, M)> + Clone {
    prop_oneof![
        3 => (motors.clone(), motors.clone()),
        1 => motors.clone().prop_map(|motor| (motor, motor)),
        1 => antipodal(motors.clone()),
        1 => (motors, steps, any::<bool>())
            .prop_map(|(motor, step, negative)| (motor, if negative { -(motor * step) } else { motor * step })),
    ]
}

/// Directions of length 1: the axes first.
pub fn unit_directions<T: Real + Debug + 'static>() -> impl Strategy<Value = Direction<T>> + Clone {
    let axes = select(vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
    let any = [-1.0..1.0, -1.0..1.0, -1.0..1.0];
    let vectors = prop_oneof![1 => axes, 3 => any];
    vectors.prop_filter_map("a direction of length 0", |vector| {
        let [x, y, z] = vector.map(T::from_f64);
        Direction::new(x, y, z).normalize()
    })
}

/// Directions of any length, 0 among them.
pub fn directions<T: Real + Debug + 'static>() -> impl Strategy<Value = Direction<T>> + Clone {
    [lengths(), lengths(), lengths()].prop_map(|[x, y, z]| Direction::new(x, y, z))
}

/// Points.
pub fn points<T: Real + Debug + 'static>() -> impl Strategy<Value = Point<T>> + Clone {
    [lengths(), lengths(), lengths()].prop_map(|[x, y, z]| Point::new(x, y, z))
}

/// Planes with a normal of length 1.
pub fn unit_planes<T: Real + Debug + 'static>() -> impl Strategy<Value = UnitPlane<T>> + Clone {
    (unit_directions(), lengths()).prop_map(|(normal, d)| UnitPlane::new(normal.x, normal.y, normal.z, d))
}

/// Planes with a normal of any length, 0 among them.
pub fn planes<T: Real + Debug + 'static>() -> impl Strategy<Value = Plane<T>> + Clone {
    (directions(), lengths()).prop_map(|(normal, d)| Plane::new(normal.x, normal.y, normal.z, d))
}

/// Lines with a direction of length 1, anywhere.
pub fn unit_lines<T: Real + Debug + 'static>() -> impl Strategy<Value = UnitLine<T>> + Clone {
    (unit_directions(), points::<T>()).prop_map(|(d, p)| {
        UnitLine::new(d.x, d.y, d.z, p.y * d.z - p.z * d.y, p.z * d.x - p.x * d.z, p.x * d.y - p.y * d.x)
    })
}

/// Any bivectors: lines, lines at infinity, screws, and 0.
pub fn lines<T: Real + Debug + 'static>() -> impl Strategy<Value = Line<T>> + Clone {
    let screws = [lengths(), lengths(), lengths(), lengths(), lengths(), lengths()];
    prop_oneof![
        unit_lines().prop_map(Line::from),
        directions().prop_map(|d: Direction<T>| Line::new(T::ZERO, T::ZERO, T::ZERO, d.x, d.y, d.z)),
        screws.prop_map(|[a, b, c, d, e, f]| Line::new(a, b, c, d, e, f)),
    ]
}

/// Rotors of these angles about any axis.
fn rotors_by<T: Real + Debug + 'static>(
    angles: impl Strategy<Value = f64> + Clone,
) -> impl Strategy<Value = Rotor<T>> + Clone {
    (unit_directions(), angles)
        .prop_filter_map("an axis of length 0", |(axis, angle)| Rotor::from_axis_angle(axis, T::from_f64(angle)))
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
    let power = || signed_powers(exponents.clone());
    [power(), power(), power()].prop_map(|vector| {
        let [x, y, z] = vector.map(T::from_f64);
        Translator::from_vector(Direction::new(x, y, z))
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
    antipodal(motors())
}

/// Two motors: any, equal, antipodal, and nearly equal or antipodal.
pub fn motor_pairs<T: Real + Debug + 'static>() -> impl Strategy<Value = (Motor<T>, Motor<T>)> + Clone {
    pairs(motors(), motors_near_identity())
}
