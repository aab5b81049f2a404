//! Minimax polynomials by the exchange of E. Remez (Sur un procédé convergent d'approximations successives pour
//! déterminer les polynômes d'approximation, C. R. Acad. Sci. Paris 198, 1934), on a grid.
//!
//! The polynomial of a degree that comes nearest to a function errs with one greatest size and alternating sign, at one
//! point more than it has coefficients (Chebyshev). So: guess these points, solve for the polynomial that alternates
//! there, go on with the points where it errs most, until the error at them is the greatest.

use super::linear::solve;
use super::number::{Number, greatest, magnitude, powers, whole};
use super::sample::{Sample, errors};
use std::iter::once;

/// Far more than any exchange takes.
const ROUNDS: usize = 100;

/// A polynomial and its greatest error at the samples.
pub(super) struct Minimax {
    pub(super) coefficients: Vec<Number>,
    pub(super) error: Number,
}

/// The polynomial of a degree that is nearest to the samples, which ascend, up to a thousandth of its error.
///
/// With a `constant`, the nearest one among those that have this value at 0, where there must be no sample.
pub(super) fn minimax(samples: &[Sample], degree: usize, constant: Option<&Number>) -> Minimax {
    let lowest = usize::from(constant.is_some());
    let unknowns = degree + 1 - lowest;
    let mut reference: Vec<usize> = (0..=unknowns).map(|i| (samples.len() - 1) * i / unknowns).collect();
    let mut found = Minimax { coefficients: Vec::new(), error: whole(0) };
    for _ in 0..ROUNDS {
        let (coefficients, level) = alternating(samples, &reference, degree, constant);
        let mut errors = errors(&coefficients, samples);
        found = Minimax { coefficients, error: greatest(errors.iter().cloned()) };
        for (error, sample) in errors.iter_mut().zip(samples) {
            *error *= side(&sample.argument, lowest);
        }
        let next = extrema(&errors, reference.len());
        if &found.error * whole(1000) <= level * whole(1001) || next.len() < reference.len() {
            break;
        }
        reference = next;
    }
    found
}

/// The polynomial whose errors at the points of reference are of one size and alternate, and that size.
fn alternating(
    samples: &[Sample],
    reference: &[usize],
    degree: usize,
    constant: Option<&Number>,
) -> (Vec<Number>, Number) {
    let lowest = usize::from(constant.is_some());
    let row = |(index, &point): (usize, &usize)| {
        let Sample { argument, value } = &samples[point];
        let powers = powers(argument).take(degree + 1).skip(lowest);
        let sign = if index % 2 == 0 { side(argument, lowest) } else { -side(argument, lowest) };
        powers.chain(once(sign)).chain(once(value - constant.unwrap_or(&whole(0)))).collect()
    };
    let mut solution = solve(reference.iter().enumerate().map(row).collect());
    let level = magnitude(solution.pop().unwrap_or_else(|| whole(0)));
    (constant.cloned().into_iter().chain(solution).collect(), level)
}

/// The sign of x^lowest. Errors alternate but for this: what is fitted to a function with a given constant is x times a
/// polynomial.
fn side(argument: &Number, lowest: usize) -> Number {
    if lowest == 1 && *argument < whole(0) { -whole(1) } else { whole(1) }
}

/// The points of the greatest errors between changes of sign; where there are too many, the lesser ends are dropped.
fn extrema(errors: &[Number], count: usize) -> Vec<usize> {
    let size = |index: usize| magnitude(errors[index].clone());
    let mut extrema: Vec<usize> = Vec::new();
    for (index, error) in errors.iter().enumerate() {
        match extrema.last_mut() {
            Some(last) if (errors[*last] < whole(0)) == (*error < whole(0)) => {
                if size(index) > size(*last) {
                    *last = index;
                }
            }
            _ => extrema.push(index),
        }
    }
    while extrema.len() > count {
        let lesser = if size(extrema[0]) < size(extrema[extrema.len() - 1]) { 0 } else { extrema.len() - 1 };
        extrema.remove(lesser);
    }
    extrema
}
