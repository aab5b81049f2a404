//! Numbers of 256 bits: enough for systems of equations that lose half of them.

use dashu_float::FBig;
use dashu_float::ops::Abs;
use dashu_float::round::mode::HalfEven;
use ga_codegen::approximation::Precision;
use ga_codegen::symbolic::Rational;

/// A number of 256 bits; every operation rounds to the nearest.
pub(super) type Number = FBig<HalfEven, 2>;

const BITS: usize = 256;

fn widened(value: Number) -> Number {
    value.with_precision(BITS).value()
}

/// A finite number as it is.
pub(super) fn exact(value: f64) -> Number {
    widened(Number::try_from(value).expect("invariant: no number of a fit is NaN"))
}

/// A whole number as it is.
pub(super) fn whole(value: usize) -> Number {
    widened(Number::from(value))
}

/// The nearest to a rational.
pub(super) fn rational(value: Rational) -> Number {
    widened(Number::from(value.numerator())) / widened(Number::from(value.denominator()))
}

/// The nearest number of a precision.
pub(super) fn nearest(value: &Number, precision: Precision) -> f64 {
    match precision {
        Precision::F32 => f64::from(value.to_f32().value()),
        Precision::F64 => value.to_f64().value(),
    }
}

/// The absolute value.
pub(super) fn magnitude(value: Number) -> Number {
    value.abs()
}

/// The greatest of absolute values; 0 for none.
pub(super) fn greatest(values: impl Iterator<Item = Number>) -> Number {
    values.map(magnitude).fold(whole(0), Number::max)
}

/// The value of a polynomial, the coefficient of the constant first, by Horner's rule.
pub(super) fn horner(coefficients: &[Number], argument: &Number) -> Number {
    coefficients.iter().rev().fold(whole(0), |sum, coefficient| sum * argument + coefficient)
}

/// 1, x, x^2 and so on.
pub(super) fn powers(argument: &Number) -> impl Iterator<Item = Number> {
    std::iter::successors(Some(whole(1)), move |power| Some(power * argument))
}
