//! Lengths whose squares may leave the range of the numbers.

use crate::Real;

/// The largest magnitude among the coefficients; `None` where it is zero or one of them is infinite or NaN.
pub(crate) fn largest<T: Real, const N: usize>(coefficients: [T; N]) -> Option<T> {
    let larger = |a: T, b: T| if b > a { b } else { a };
    let largest = coefficients.iter().fold(T::ZERO, |largest, coefficient| larger(largest, coefficient.abs()));
    let usable = largest > T::ZERO && coefficients.iter().all(|coefficient| coefficient.is_finite());
    usable.then_some(largest)
}

/// 1 over the power of two next below the largest magnitude, by which coefficients are brought near 1 without rounding;
/// `None` where they are all zero or one is infinite or NaN.
pub(crate) fn scale<T: Real, const N: usize>(coefficients: [T; N]) -> Option<T> {
    largest(coefficients).map(|largest| T::ONE / largest.power_of_two())
}
