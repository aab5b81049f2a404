//! The same for the plane: random elements of 2D projective geometric algebra.
//!
//! The line a x + b y + c = 0 is `a e1 + b e2 + c e0`, the point (x, y) is `e12 + x e20 + y e01`.
//!
//! ```
//! use ga_codegen::check::{Check, Fraction, strategies::pga2d};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! // The foot of the perpendicular from a point on a line, exactly.
//! let check = Check::<Fraction>::new(pga2d::PGA2D, "-((l | p) * l)")?;
//! check.input("l", pga2d::lines()).input("p", pga2d::points()).assert(|[l, p]| {
//!     let [a, b, c] = ["e1", "e2", "e0"].map(|word| l.coefficient(word));
//!     let [x, y] = ["e20", "e01"].map(|word| p.coefficient(word));
//!     let distance = a * x + b * y + c;
//!     [("e12", Fraction::ONE), ("e20", x - distance * a), ("e01", y - distance * b)]
//! });
//! # Ok(())
//! # }
//! ```

use proptest::prelude::*;

use super::numbers::{
    digits, huge_lengths, lengths, plane_unit_vectors, simple, small_lengths, turns, turns_near_half_turn,
    turns_near_identity,
};
use super::pairs;
use crate::algebra::Signature;
use crate::check::Coefficient;
use crate::reference::Multivector;

/// The signature of everything here.
pub const PGA2D: Signature = Signature::new(2, 0, 1);

fn element<T: Coefficient, const N: usize>(words: [&str; N], coefficients: [T; N]) -> Multivector<T> {
    Multivector::from_blades(PGA2D, words.into_iter().zip(coefficients)).expect("invariant: words of 2D PGA")
}

/// Of the cosine and sine of the half-angle.
fn rotor<T: Coefficient>([cos, sin]: [T; 2]) -> Multivector<T> {
    element(["1", "e12"], [cos, -sin])
}

fn simple_rotors<T: Coefficient>() -> impl Strategy<Value = Multivector<T>> + Clone {
    simple(&[[10, 0], [6, -8], [0, -10], [8, 6]], 10).prop_map(rotor)
}

/// Rotors: simple ones, of any angle up to a whole turn, near the identity and near half a turn.
pub fn rotors<T: Coefficient>() -> impl Strategy<Value = Multivector<T>> + Clone {
    prop_oneof![
        2 => simple_rotors(),
        3 => turns().prop_map(rotor),
        1 => rotors_near_identity(),
        1 => rotors_near_half_turn(),
    ]
}

/// Rotors of half-angles from 1e-18 to 0.01; exact ones from 0.06 to 0.2.
pub fn rotors_near_identity<T: Coefficient>() -> impl Strategy<Value = Multivector<T>> + Clone {
    turns_near_identity().prop_map(rotor)
}

/// Rotors that lack or exceed half a turn by a half-angle as small.
pub fn rotors_near_half_turn<T: Coefficient>() -> impl Strategy<Value = Multivector<T>> + Clone {
    turns_near_half_turn().prop_map(rotor)
}

/// Translators, of lengths mostly below ten.
pub fn translators<T: Coefficient>() -> impl Strategy<Value = Multivector<T>> + Clone {
    [lengths(), lengths()].prop_map(translator)
}

fn translator<T: Coefficient>([x, y]: [T; 2]) -> Multivector<T> {
    element(["1", "e01", "e20"], [T::from(1), x, y])
}

/// Turns, then translates.
fn motor<T: Coefficient>((translator, rotor): (Multivector<T>, Multivector<T>)) -> Multivector<T> {
    translator.geometric(&rotor)
}

/// Motors: simple ones, any, and all the kinds that have a function of their own.
pub fn motors<T: Coefficient>() -> impl Strategy<Value = Multivector<T>> + Clone {
    let simple = ([digits(), digits()].prop_map(translator), simple_rotors()).prop_map(motor);
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
    ([small_lengths(), small_lengths()].prop_map(translator), rotors_near_identity()).prop_map(motor)
}

/// Motors near half a turn with any translation.
pub fn motors_near_half_turn<T: Coefficient>() -> impl Strategy<Value = Multivector<T>> + Clone {
    (translators(), rotors_near_half_turn()).prop_map(motor)
}

/// Motors of the turns near the identity and translations from 1e4 to 1e8; exact ones to 1e5.
pub fn motors_with_tiny_turn_and_huge_step<T: Coefficient>() -> impl Strategy<Value = Multivector<T>> + Clone {
    ([huge_lengths(), huge_lengths()].prop_map(translator), rotors_near_identity()).prop_map(motor)
}

/// A motor and its negative, which is the same motion.
pub fn antipodal_motors<T: Coefficient>() -> impl Strategy<Value = [Multivector<T>; 2]> + Clone {
    pairs::antipodal(motors())
}

/// Two motors: any, equal, antipodal, and nearly equal or antipodal.
pub fn motor_pairs<T: Coefficient>() -> impl Strategy<Value = [Multivector<T>; 2]> + Clone {
    pairs::pairs(motors(), motors_near_identity())
}

/// Unit lines.
pub fn lines<T: Coefficient>() -> impl Strategy<Value = Multivector<T>> + Clone {
    (plane_unit_vectors(), lengths()).prop_map(|([a, b], c)| element(["e1", "e2", "e0"], [a, b, c]))
}

/// Points of weight 1.
pub fn points<T: Coefficient>() -> impl Strategy<Value = Multivector<T>> + Clone {
    [lengths(), lengths()].prop_map(|[x, y]| element(["e12", "e20", "e01"], [T::from(1), x, y]))
}

/// Unit directions: ideal points.
pub fn directions<T: Coefficient>() -> impl Strategy<Value = Multivector<T>> + Clone {
    plane_unit_vectors().prop_map(|vector| element(["e20", "e01"], vector))
}

/// Any bivectors, 0 and ideal ones among them: what generates a motion.
pub fn bivectors<T: Coefficient>() -> impl Strategy<Value = Multivector<T>> + Clone {
    let weights = prop_oneof![4 => lengths(), 1 => Just(T::from(0)), 1 => small_lengths()];
    (weights, [lengths(), lengths()]).prop_map(|(weight, [x, y])| element(["e12", "e20", "e01"], [weight, x, y]))
}
