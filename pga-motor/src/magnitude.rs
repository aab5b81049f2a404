//! Lengths whose squares may leave the range of the numbers.

use crate::Real;

/// The largest magnitude among the coefficients; `None` where it is zero or one of them is infinite or NaN.
pub(crate) fn largest<T: Real, const N: usize>(coefficients: [T; N]) -> Option<T> {
    let larger = |a: T, b: T| if b > a { b } else { a };
    let largest = coefficients.iter().fold(T::ZERO, |largest, coefficient| larger(largest, coefficient.abs()));
    let usable = largest > T::ZERO && coefficients.iter().all(|coefficient| coefficient.is_finite());
    usable.then_some(largest)
}

/// The square root of a squared norm, by way of coefficients near 1 where the squares overflow or underflow.
///
/// A squared norm above about `MIN / EPSILON^2` is as good as exact arithmetic makes it: what underflowed in it is too
/// small to matter. Multiplying by `EPSILON^2` tells.
pub(crate) fn norm<T: Real, const N: usize>(coefficients: [T; N], squared: impl Fn([T; N]) -> T) -> T {
    let plain = squared(coefficients);
    if plain.is_finite() && plain * (T::EPSILON * T::EPSILON) > T::ZERO {
        return plain.sqrt();
    }
    match largest(coefficients) {
        Some(largest) => squared(coefficients.map(|coefficient| coefficient / largest)).sqrt() * largest,
        None => plain.sqrt(),
    }
}
