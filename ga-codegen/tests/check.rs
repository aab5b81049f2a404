//! The checks of other people's code find what is wrong with it, and say so in few blades.

use ga_codegen::algebra::Signature;
use ga_codegen::check::strategies::{self, PGA3D, motors, planes, points, rotors};
use ga_codegen::check::{Check, CheckError, Tolerance};
use ga_codegen::reference::Multivector;
use proptest::prelude::*;

type Element = Multivector<f64>;

/// The sandwich of a point by hand, with signs of two of its terms to get wrong and a factor to leave one out.
fn transform(m: &Element, p: &Element, [cross, turn]: [f64; 2], slide: f64) -> [(&'static str, f64); 4] {
    let [s, a, b, c] = ["1", "e23", "e31", "e12"].map(|word| m.coefficient(word));
    let [d, e, f, h] = ["e01", "e02", "e03", "e0123"].map(|word| m.coefficient(word));
    let [x, y, z] = ["e032", "e013", "e021"].map(|word| p.coefficient(word));
    let across = [d + b * z * cross - c * y, e + c * x - a * z, f + a * y - b * x];
    let half_x = s * across[0] + a * h * slide - b * across[2] * turn + c * across[1];
    let half_y = s * across[1] + b * h * slide - c * across[0] + a * across[2];
    let half_z = s * across[2] + c * h * slide - a * across[1] + b * across[0];
    [("e123", 1.0), ("e032", x - 2.0 * half_x), ("e013", y - 2.0 * half_y), ("e021", z - 2.0 * half_z)]
}

fn sandwich() -> Check<f64> {
    Check::new(PGA3D, "m >> p").expect("a definition").input("m", motors()).input("p", points())
}

fn message<T: std::fmt::Display>(result: Result<(), T>) -> String {
    result.err().expect("an error").to_string()
}

#[test]
fn a_right_implementation_passes() {
    sandwich().cases(2000).assert(|[m, p]| m.geometric(p).geometric(&m.reverse()));
    sandwich().cases(2000).assert(|[m, p]| transform(m, p, [1.0, 1.0], 1.0));
}

#[test]
fn a_wrong_sign_is_found_and_shown_in_few_blades() {
    println!("{}", message(sandwich().run(|[m, p]| transform(m, p, [1.0, -1.0], 1.0))));
    println!("{}", message(sandwich().run(|[m, p]| transform(m, p, [-1.0, 1.0], 1.0))));
}

#[test]
fn a_missing_term_is_found() {
    println!("{}", message(sandwich().run(|[m, p]| transform(m, p, [1.0, 1.0], 0.0))));
}
