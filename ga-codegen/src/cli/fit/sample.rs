//! The functions as numbers: their Taylor polynomials, and their values at Chebyshev points.

use super::number::{Number, exact, greatest, horner, magnitude, rational, whole};
use ga_codegen::approximation::Function;
use ga_codegen::symbolic::Overflow;

/// Terms of a series below this are left out: a hundred-millionth of the unit roundoff of f64.
const NEGLIGIBLE: f64 = f64::EPSILON / (1 << 27) as f64;

/// The Taylor polynomial of a function.
pub(super) struct Taylor {
    pub(super) function: Function,
    coefficients: Vec<Number>,
    /// A bound on what is left out, on the interval.
    rest: Number,
}

/// An argument and the value of a function there.
#[derive(Clone)]
pub(super) struct Sample {
    pub(super) argument: Number,
    pub(super) value: Number,
}

impl Taylor {
    pub(super) fn new(function: Function) -> Result<Self, Overflow> {
        let (low, high) = function.interval();
        let (farthest, negligible) = (exact(low.abs().max(high)), exact(NEGLIGIBLE));
        let (mut coefficients, mut coefficient, mut power) = (Vec::new(), rational(function.series(0)?), whole(1));
        loop {
            let term = magnitude(&coefficient * &power);
            if term < negligible {
                // From here on, every term is less than 0.51 of the one before.
                return Ok(Self { function, coefficients, rest: term * whole(3) });
            }
            coefficients.push(coefficient.clone());
            coefficient *= rational(function.ratio(coefficients.len() as u32)?);
            power *= &farthest;
        }
    }

    pub(super) fn value(&self, argument: &Number) -> Number {
        horner(&self.coefficients, argument)
    }

    /// The function at the `count + 1` extrema of the Chebyshev polynomial of degree `count` on the interval,
    /// ascending.
    pub(super) fn samples(&self, count: usize) -> Vec<Sample> {
        let (low, high) = self.function.interval();
        let (middle, half) = ((exact(low) + exact(high)) / whole(2), (exact(high) - exact(low)) / whole(2));
        let argument = |i: usize| &middle - &half * (whole(i) / whole(count)).cos_pi();
        let sample = |argument: Number| Sample { value: self.value(&argument), argument };
        (0..=count).map(argument).map(sample).collect()
    }

    /// A bound on the distance of a polynomial from the function anywhere on the interval, from its distance at the
    /// samples.
    ///
    /// A polynomial of degree N is nowhere greater than its greatest value at the extrema of the Chebyshev polynomial
    /// of degree M, times 1 / cos(πN / 2M) (H. Ehlich and K. Zeller, Schwankung von Polynomen zwischen Gitterpunkten,
    /// Math. Z. 86, 1964). The distance from the Taylor polynomial is such a polynomial.
    pub(super) fn distance(&self, polynomial: &[Number], samples: &[Sample]) -> Number {
        let degree = self.coefficients.len().max(polynomial.len()) - 1;
        let between = whole(1) / (whole(degree) / whole(2 * (samples.len() - 1))).cos_pi();
        (largest_error(polynomial, samples) + &self.rest) * between + &self.rest
    }
}

/// The distance of a polynomial from the function, with its sign, at every sample.
pub(super) fn errors(polynomial: &[Number], samples: &[Sample]) -> Vec<Number> {
    samples.iter().map(|sample| horner(polynomial, &sample.argument) - &sample.value).collect()
}

/// The greatest distance of a polynomial from the function at the samples.
pub(super) fn largest_error(polynomial: &[Number], samples: &[Sample]) -> Number {
    greatest(errors(polynomial, samples).into_iter())
}
