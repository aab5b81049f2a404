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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_largest_magnitude_is_that_of_any_sign_at_any_place() {
        assert_eq!(largest([3.0, -5.0, 2.0]), Some(5.0));
        assert_eq!(largest([-7.0, 5.0]), Some(7.0));
        assert_eq!(largest([0.0, f64::MIN_POSITIVE]), Some(f64::MIN_POSITIVE));
        assert_eq!(largest([f64::MAX]), Some(f64::MAX));
        for unusable in [0.0, -0.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert_eq!((largest([unusable]), scale([unusable])), (None, None));
        }
        assert_eq!((largest([1.0, f64::NAN]), largest([f64::INFINITY, 1.0])), (None, None));
    }

    #[test]
    fn scaling_brings_the_largest_to_one_or_just_above() {
        assert_eq!(scale([3.0, -5.0]), Some(0.25));
        for coefficients in [[1e-300, 3e-301], [-4e300, 1.0], [1.0, -1.5], [0.75, 0.0]] {
            let scale: f64 = scale(coefficients).unwrap();
            let scaled = largest(coefficients.map(|coefficient| coefficient * scale)).unwrap();
            assert!((1.0..2.0).contains(&scaled), "{coefficients:?} by {scale}");
            assert!(coefficients.iter().all(|coefficient| coefficient * scale / scale == *coefficient));
        }
    }
}
