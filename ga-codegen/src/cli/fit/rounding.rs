//! Polynomials whose coefficients are floating-point numbers.
//!
//! Coefficients rounded each for itself lose several bits of the polynomial. Rounded one after the other, the constant
//! first, with the ones to come moved to make up for what was lost, they lose next to nothing. This is the nearest
//! plane of L. Babai (On Lovász' lattice reduction and the nearest lattice point problem, Combinatorica 6, 1986) in the
//! lattice of the polynomials that can be written, as N. Brisebarre and S. Chevillard use it (Efficient polynomial
//! L∞-approximations, ARITH 18, 2007), but on the powers as they are, which turns out to be enough.

use super::linear::solve;
use super::number::{Number, exact, nearest, powers, whole};
use super::sample::Sample;
use ga_codegen::approximation::Precision;

/// A polynomial with coefficients in a precision near a given one, in the mean of squares over the samples.
pub(super) fn rounded(target: &[Number], constant: f64, precision: Precision, samples: &[Sample]) -> Vec<f64> {
    let moments = moments(samples, 2 * target.len());
    let mut rounded = vec![constant];
    while rounded.len() < target.len() {
        let next = refitted(target, &rounded, &moments);
        rounded.push(nearest(&next, precision));
    }
    rounded
}

/// The sums of the powers of the arguments.
fn moments(samples: &[Sample], count: usize) -> Vec<Number> {
    let mut moments = vec![whole(0); count];
    for sample in samples {
        for (moment, power) in moments.iter_mut().zip(powers(&sample.argument)) {
            *moment += power;
        }
    }
    moments
}

/// The first coefficient after the rounded ones, of the polynomial that begins with these and is nearest to the target.
fn refitted(target: &[Number], rounded: &[f64], moments: &[Number]) -> Number {
    let lost: Vec<Number> = rounded.iter().zip(target).map(|(rounded, target)| target - exact(*rounded)).collect();
    let free = rounded.len()..target.len();
    let row = |i: usize| {
        let missing = lost.iter().enumerate().fold(whole(0), |sum, (j, lost)| sum + &moments[i + j] * lost);
        free.clone().map(|j| moments[i + j].clone()).chain(std::iter::once(missing)).collect()
    };
    let moved = solve(free.clone().map(row).collect());
    &target[free.start] + &moved[0]
}
