//! Random elements of 3D projective geometric algebra, those at which formulas fail among them.
//!
//! Values shrink to few blades with simple coefficients, such as the rotor `0.6 + 0.8 e12`. Lengths are mostly below
//! ten, sometimes up to 1e8. What a type promises, unit norm and Pluecker's and Study's relations, holds up to
//! rounding.
//!
//! ```
//! use ga_codegen::check::{Check, strategies};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! // A motor and its negative are the same motion.
//! let check = Check::new(strategies::PGA3D, "m >> p")?;
//! let check = check.inputs(["m", "n"], strategies::antipodal_motors()).input("p", strategies::points());
//! let error = check.run(|[_, n, p]| n.sandwich(p)).expect_err("`n` is no name of the definition");
//! assert_eq!(error.to_string(), "expected an input of the definition (`m`, `p`), found `n`");
//!
//! let check = Check::new(strategies::PGA3D, "m >> p + 0 * n")?;
//! let check = check.inputs(["m", "n"], strategies::antipodal_motors()).input("p", strategies::points());
//! check.assert(|[_, n, p]| n.sandwich(p));
//! # Ok(())
//! # }
//! ```

use std::f64::consts::{FRAC_PI_2, PI};

use proptest::prelude::*;
use proptest::sample::select;

use crate::algebra::Signature;
use crate::reference::Multivector;

/// The signature of everything here.
pub const PGA3D: Signature = Signature::new(3, 0, 1);

/// What the strategies give.
type Element = Multivector<f64>;

fn element<const N: usize>(words: [&str; N], coefficients: [f64; N]) -> Element {
    Multivector::from_blades(PGA3D, words.into_iter().zip(coefficients)).expect("invariant: words of 3D PGA")
}

/// A whole number, any up to ten, or one of any magnitude up to 1e8.
fn lengths() -> impl Strategy<Value = f64> + Clone {
    prop_oneof![
        4 => (-9..=9).prop_map(f64::from),
        3 => -10.0..10.0,
        1 => signed_powers(-8.0..8.0),
    ]
}

fn signed_powers(exponents: std::ops::Range<f64>) -> impl Strategy<Value = f64> + Clone {
    (exponents, select(vec![1.0, -1.0])).prop_map(|(exponent, sign)| sign * 10_f64.powf(exponent))
}

fn vectors() -> impl Strategy<Value = [f64; 3]> + Clone {
    [lengths(), lengths(), lengths()]
}

/// Of length 1: those with short decimals first, to which others shrink.
fn unit_vectors() -> impl Strategy<Value = [f64; 3]> + Clone {
    let simple =
        vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.6, 0.8, 0.0], [0.0, 0.6, -0.8], [0.48, 0.6, 0.64]];
    let any = [-1.0..1.0, -1.0..1.0, -1.0..1.0].prop_filter("not 0", |&[x, y, z]| x * x + y * y + z * z > 1e-6);
    prop_oneof![
        2 => select(simple),
        3 => any.prop_map(|[x, y, z]: [f64; 3]| {
            let norm = (x * x + y * y + z * z).sqrt();
            [x / norm, y / norm, z / norm]
        }),
    ]
}

fn rotor([s, a, b, c]: [f64; 4]) -> Element {
    element(["1", "e23", "e31", "e12"], [s, a, b, c])
}

/// Rotors of these half-angles about any axis through the origin.
fn rotors_by(half_angles: impl Strategy<Value = f64> + Clone) -> impl Strategy<Value = Element> + Clone {
    (half_angles, unit_vectors()).prop_map(|(half_angle, [x, y, z])| {
        let (sin, cos) = half_angle.sin_cos();
        rotor([cos, -sin * x, -sin * y, -sin * z])
    })
}

fn simple_rotors() -> impl Strategy<Value = Element> + Clone {
    let simple = vec![
        [1.0, 0.0, 0.0, 0.0],
        [0.6, 0.0, 0.0, 0.8],
        [0.6, 0.0, 0.8, 0.0],
        [0.6, 0.8, 0.0, 0.0],
        [0.0, 0.0, 0.0, 1.0],
        [0.0, 0.0, 1.0, 0.0],
        [0.0, 1.0, 0.0, 0.0],
        [0.5, 0.5, 0.5, 0.5],
        [0.5, -0.1, 0.7, 0.5],
    ];
    select(simple).prop_map(rotor)
}

/// Rotors: simple ones, of any angle up to a whole turn, near the identity and near half a turn.
pub fn rotors() -> impl Strategy<Value = Multivector<f64>> + Clone {
    prop_oneof![
        2 => simple_rotors(),
        3 => rotors_by(-PI..PI),
        1 => rotors_near_identity(),
        1 => rotors_near_half_turn(),
    ]
}

/// Rotors of half-angles from 1e-18 to 0.01.
pub fn rotors_near_identity() -> impl Strategy<Value = Multivector<f64>> + Clone {
    rotors_by(signed_powers(-18.0..-2.0))
}

/// Rotors that lack or exceed half a turn by a half-angle from 1e-18, which rounds to exactly none, to 0.01.
pub fn rotors_near_half_turn() -> impl Strategy<Value = Multivector<f64>> + Clone {
    rotors_by(signed_powers(-18.0..-2.0).prop_map(|distance| FRAC_PI_2 + distance))
}

/// Translators, of lengths mostly below ten.
pub fn translators() -> impl Strategy<Value = Multivector<f64>> + Clone {
    vectors().prop_map(translator)
}

fn translator([x, y, z]: [f64; 3]) -> Element {
    element(["1", "e01", "e02", "e03"], [1.0, x, y, z])
}

/// Turns, then translates.
fn motor((translator, rotor): (Element, Element)) -> Element {
    translator.geometric(&rotor)
}

/// Motors: simple ones, any, and all the kinds that have a function of their own.
pub fn motors() -> impl Strategy<Value = Multivector<f64>> + Clone {
    let whole = || (-9..=9).prop_map(f64::from);
    let simple = ([whole(), whole(), whole()].prop_map(translator), simple_rotors()).prop_map(motor);
    prop_oneof![
        2 => simple,
        3 => (translators(), rotors()).prop_map(motor),
        1 => motors_near_identity(),
        1 => motors_near_half_turn(),
        1 => motors_with_tiny_turn_and_huge_step(),
    ]
}

/// Motors of half-angles and translations from 1e-18 to 0.01.
pub fn motors_near_identity() -> impl Strategy<Value = Multivector<f64>> + Clone {
    let small = || signed_powers(-18.0..-2.0);
    ([small(), small(), small()].prop_map(translator), rotors_near_identity()).prop_map(motor)
}

/// Motors near half a turn with any translation.
pub fn motors_near_half_turn() -> impl Strategy<Value = Multivector<f64>> + Clone {
    (translators(), rotors_near_half_turn()).prop_map(motor)
}

/// Motors of half-angles from 1e-18 to 0.01 and translations from 1e4 to 1e8.
pub fn motors_with_tiny_turn_and_huge_step() -> impl Strategy<Value = Multivector<f64>> + Clone {
    let huge = || signed_powers(4.0..8.0);
    ([huge(), huge(), huge()].prop_map(translator), rotors_near_identity()).prop_map(motor)
}

/// A motor and its negative, which is the same motion.
pub fn antipodal_motors() -> impl Strategy<Value = [Multivector<f64>; 2]> + Clone {
    motors().prop_map(|motor| [motor.clone(), motor.neg()])
}

/// Two motors: any, equal, antipodal, and nearly equal or antipodal.
pub fn motor_pairs() -> impl Strategy<Value = [Multivector<f64>; 2]> + Clone {
    prop_oneof![
        3 => [motors(), motors()],
        1 => motors().prop_map(|motor| [motor.clone(), motor]),
        1 => antipodal_motors(),
        1 => (motors(), motors_near_identity(), any::<bool>()).prop_map(|(motor, step, negative)| {
            let near = motor.geometric(&step);
            [motor, if negative { near.neg() } else { near }]
        }),
    ]
}

/// Unit lines: along an axis, and off the origin.
pub fn lines() -> impl Strategy<Value = Multivector<f64>> + Clone {
    (unit_vectors(), vectors()).prop_map(|([a, b, c], [x, y, z])| {
        let moment = [y * c - z * b, z * a - x * c, x * b - y * a];
        element(["e23", "e31", "e12", "e01", "e02", "e03"], [a, b, c, moment[0], moment[1], moment[2]])
    })
}

/// Unit planes.
pub fn planes() -> impl Strategy<Value = Multivector<f64>> + Clone {
    (unit_vectors(), lengths()).prop_map(|([a, b, c], d)| element(["e1", "e2", "e3", "e0"], [a, b, c, d]))
}

/// Points of weight 1.
pub fn points() -> impl Strategy<Value = Multivector<f64>> + Clone {
    vectors().prop_map(|[x, y, z]| element(["e123", "e032", "e013", "e021"], [1.0, x, y, z]))
}

/// Unit directions: ideal points.
pub fn directions() -> impl Strategy<Value = Multivector<f64>> + Clone {
    unit_vectors().prop_map(|vector| element(["e032", "e013", "e021"], vector))
}
