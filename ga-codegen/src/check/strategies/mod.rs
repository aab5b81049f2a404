//! Random elements of 3D projective geometric algebra, those at which formulas fail among them; of the plane in [`pga2d`].
//!
//! Generic over the coefficients: `motors::<f32>()`, `motors::<f64>()`, `motors::<Fraction>()`. Values shrink to few blades
//! with simple coefficients, such as the rotor `0.6 + 0.8 e12`. Lengths are mostly below ten, sometimes up to 1e8. What a
//! type promises, unit norm and Pluecker's and Study's relations, holds up to rounding.
//!
//! Of exact coefficients it holds exactly: their unit vectors and angles are rational points on a sphere and a circle,
//! and their denominators are small, lengths at most 1e5 and the smallest half-angles 0.06, so that formulas of degree
//! four in motors fit 128 bits. Whole numbers hold few units.
//!
//! ```
//! use ga_codegen::check::{Check, Fraction, strategies};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! // A motor and its negative are the same motion.
//! let check = Check::<f64>::new(strategies::PGA3D, "m >> p + 0 * n")?;
//! let check = check.inputs(["m", "n"], strategies::antipodal_motors()).input("p", strategies::points());
//! check.assert(|[_, n, p]| n.sandwich(p));
//!
//! // The reverse of a motor is its inverse, without any rounding.
//! let check = Check::<Fraction>::new(strategies::PGA3D, "m * ~m")?.input("m", strategies::motors());
//! check.assert(|[_]| [("1", Fraction::ONE)]);
//! # Ok(())
//! # }
//! ```

mod numbers;
mod pairs;
pub mod pga2d;

use proptest::prelude::*;

use crate::algebra::Signature;
use crate::check::Coefficient;
use crate::reference::Multivector;
use numbers::{
    digits, huge_lengths, lengths, simple, small_lengths, turns, turns_near_half_turn, turns_near_identity,
    unit_vectors,
};

/// The signature of everything here but in [`pga2d`].
pub const PGA3D: Signature = Signature::new(3, 0, 1);

fn element<T: Coefficient, const N: usize>(words: [&str; N], coefficients: [T; N]) -> Multivector<T> {
    Multivector::from_blades(PGA3D, words.into_iter().zip(coefficients)).expect("invariant: words of 3D PGA")
}

fn vectors<T: Coefficient>() -> impl Strategy<Value = [T; 3]> + Clone {
    [lengths(), lengths(), lengths()]
}

fn rotor<T: Coefficient>([s, a, b, c]: [T; 4]) -> Multivector<T> {
    element(["1", "e23", "e31", "e12"], [s, a, b, c])
}

/// Rotors of the half-angles with these cosines and sines, about any axis through the origin.
fn rotors_by<T: Coefficient>(
    turns: impl Strategy<Value = [T; 2]> + Clone,
) -> impl Strategy<Value = Multivector<T>> + Clone {
    (turns, unit_vectors()).prop_map(|([cos, sin], [x, y, z]): (_, [T; 3])| {
        let sin = || -sin.clone();
        rotor([cos, sin() * x, sin() * y, sin() * z])
    })
}

fn simple_rotors<T: Coefficient>() -> impl Strategy<Value = Multivector<T>> + Clone {
    let choices = [
        [10, 0, 0, 0],
        [6, 0, 0, 8],
        [6, 0, 8, 0],
        [6, 8, 0, 0],
        [0, 0, 0, 10],
        [0, 0, 10, 0],
        [0, 10, 0, 0],
        [5, 5, 5, 5],
        [5, -1, 7, 5],
    ];
    simple(&choices, 10).prop_map(rotor)
}

/// Rotors: simple ones, of any angle up to a whole turn, near the identity and near half a turn.
pub fn rotors<T: Coefficient>() -> impl Strategy<Value = Multivector<T>> + Clone {
    prop_oneof![
        2 => simple_rotors(),
        3 => rotors_by(turns()),
        1 => rotors_near_identity(),
        1 => rotors_near_half_turn(),
    ]
}

/// Rotors of half-angles from 1e-18 to 0.01; exact ones from 0.06 to 0.2.
pub fn rotors_near_identity<T: Coefficient>() -> impl Strategy<Value = Multivector<T>> + Clone {
    rotors_by(turns_near_identity())
}

/// Rotors that lack or exceed half a turn by a half-angle as small; in floating point the least round to exactly none.
pub fn rotors_near_half_turn<T: Coefficient>() -> impl Strategy<Value = Multivector<T>> + Clone {
    rotors_by(turns_near_half_turn())
}

/// Translators, of lengths mostly below ten.
pub fn translators<T: Coefficient>() -> impl Strategy<Value = Multivector<T>> + Clone {
    vectors().prop_map(translator)
}

fn translator<T: Coefficient>([x, y, z]: [T; 3]) -> Multivector<T> {
    element(["1", "e01", "e02", "e03"], [T::from(1), x, y, z])
}

/// Turns, then translates.
fn motor<T: Coefficient>((translator, rotor): (Multivector<T>, Multivector<T>)) -> Multivector<T> {
    translator.geometric(&rotor)
}

/// Motors: simple ones, any, and all the kinds that have a function of their own.
pub fn motors<T: Coefficient>() -> impl Strategy<Value = Multivector<T>> + Clone {
    let simple = ([digits(), digits(), digits()].prop_map(translator), simple_rotors()).prop_map(motor);
    prop_oneof![
        2 => simple,
        3 => (translators(), rotors()).prop_map(motor),
        1 => motors_near_identity(),
        1 => motors_near_half_turn(),
        1 => motors_with_tiny_turn_and_huge_step(),
    ]
}

/// Motors near the identity, their translations from 1e-18 to 0.01; exact ones from 0.01 to 0.09.
pub fn motors_near_identity<T: Coefficient>() -> impl Strategy<Value = Multivector<T>> + Clone {
    let steps = [small_lengths(), small_lengths(), small_lengths()];
    (steps.prop_map(translator), rotors_near_identity()).prop_map(motor)
}

/// Motors near half a turn with any translation.
pub fn motors_near_half_turn<T: Coefficient>() -> impl Strategy<Value = Multivector<T>> + Clone {
    (translators(), rotors_near_half_turn()).prop_map(motor)
}

/// Motors of the turns near the identity and translations from 1e4 to 1e8; exact ones to 1e5.
pub fn motors_with_tiny_turn_and_huge_step<T: Coefficient>() -> impl Strategy<Value = Multivector<T>> + Clone {
    let steps = [huge_lengths(), huge_lengths(), huge_lengths()];
    (steps.prop_map(translator), rotors_near_identity()).prop_map(motor)
}

/// A motor and its negative, which is the same motion.
pub fn antipodal_motors<T: Coefficient>() -> impl Strategy<Value = [Multivector<T>; 2]> + Clone {
    pairs::antipodal(motors())
}

/// Two motors: any, equal, antipodal, and nearly equal or antipodal.
pub fn motor_pairs<T: Coefficient>() -> impl Strategy<Value = [Multivector<T>; 2]> + Clone {
    pairs::pairs(motors(), motors_near_identity())
}

/// Unit lines: along an axis, and off the origin.
pub fn lines<T: Coefficient>() -> impl Strategy<Value = Multivector<T>> + Clone {
    (unit_vectors(), vectors()).prop_map(|(direction, point): ([T; 3], [T; 3])| {
        let minor =
            |i: usize, j: usize| point[i].clone() * direction[j].clone() - point[j].clone() * direction[i].clone();
        let moment = [minor(1, 2), minor(2, 0), minor(0, 1)];
        element(["e23", "e31", "e12"], direction).add(&element(["e01", "e02", "e03"], moment))
    })
}

/// Unit planes.
pub fn planes<T: Coefficient>() -> impl Strategy<Value = Multivector<T>> + Clone {
    (unit_vectors(), lengths()).prop_map(|([a, b, c], d)| element(["e1", "e2", "e3", "e0"], [a, b, c, d]))
}

/// Points of weight 1.
pub fn points<T: Coefficient>() -> impl Strategy<Value = Multivector<T>> + Clone {
    vectors().prop_map(|[x, y, z]| element(["e123", "e032", "e013", "e021"], [T::from(1), x, y, z]))
}

/// Unit directions: ideal points.
pub fn directions<T: Coefficient>() -> impl Strategy<Value = Multivector<T>> + Clone {
    unit_vectors().prop_map(|vector| element(["e032", "e013", "e021"], vector))
}

/// Any bivectors: screws, lines at infinity, 0: what generates a motion.
pub fn bivectors<T: Coefficient>() -> impl Strategy<Value = Multivector<T>> + Clone {
    let small = [small_lengths(), small_lengths(), small_lengths()];
    let directions = prop_oneof![4 => vectors(), 1 => Just([0; 3].map(T::from)), 1 => small];
    (directions, vectors()).prop_map(|(direction, moment)| {
        element(["e23", "e31", "e12"], direction).add(&element(["e01", "e02", "e03"], moment))
    })
}
