//! Random numbers: lengths, unit vectors and half-angles, in floating point or exactly.
//!
//! Exact unit vectors and angles are rational points on a sphere and on a circle, by stereographic projection of whole
//! numbers. Their denominators are small, so that formulas of degree four in motors fit 128 bits.

use std::f64::consts::{FRAC_PI_2, PI};
use std::ops::Range;

use proptest::prelude::*;
use proptest::sample::select;

use crate::check::Coefficient;

/// Why a value is left out: whole numbers cannot hold a half.
const UNHELD: &str = "a number that the coefficients cannot hold";

/// Numbers over a common denominator.
type Ratios<const N: usize> = ([i128; N], i128);

fn is_floating_point<T: Coefficient>() -> bool {
    T::from_f64(0.0).is_some()
}

fn collected<T, const N: usize>(values: impl Iterator<Item = Option<T>>) -> Option<[T; N]> {
    values.collect::<Option<Vec<T>>>()?.try_into().ok()
}

fn held<T: Coefficient, const N: usize>((numerators, denominator): Ratios<N>) -> Option<[T; N]> {
    collected(numerators.into_iter().map(|numerator| T::from_ratio(numerator, denominator)))
}

fn floats<T: Coefficient, const N: usize>(
    values: impl Strategy<Value = [f64; N]> + Clone + 'static,
) -> BoxedStrategy<[T; N]> {
    values.prop_filter_map(UNHELD, |values| collected(values.into_iter().map(T::from_f64))).boxed()
}

fn ratios<T: Coefficient, const N: usize>(
    values: impl Strategy<Value = Ratios<N>> + Clone + 'static,
) -> BoxedStrategy<[T; N]> {
    values.prop_filter_map(UNHELD, held).boxed()
}

fn single<T: Coefficient>(values: BoxedStrategy<[T; 1]>) -> BoxedStrategy<T> {
    values.prop_map(|[value]| value).boxed()
}

/// Those of the choices that the coefficients can hold, over a common denominator. One at least must be whole.
pub(super) fn simple<T: Coefficient, const N: usize>(
    choices: &[[i128; N]],
    denominator: i128,
) -> impl Strategy<Value = [T; N]> + Clone + use<T, N> {
    select(choices.iter().filter_map(|&choice| held((choice, denominator))).collect::<Vec<[T; N]>>())
}

/// A whole number of one digit.
pub(super) fn digits<T: Coefficient>() -> impl Strategy<Value = T> + Clone {
    (-9..=9_i32).prop_map(|digit| T::from(digit as i8))
}

fn signed_powers(exponents: Range<f64>) -> impl Strategy<Value = f64> + Clone {
    (exponents, select(vec![1.0, -1.0])).prop_map(|(exponent, sign)| sign * 10_f64.powf(exponent))
}

/// A whole number, any up to ten, or one of any magnitude: up to 1e8; of exact numbers any up to sixty, or up to 1e5.
pub(super) fn lengths<T: Coefficient>() -> BoxedStrategy<T> {
    single(if is_floating_point::<T>() {
        let lengths = prop_oneof![
            4 => (-9..=9).prop_map(f64::from),
            3 => -10.0..10.0,
            1 => signed_powers(-8.0..8.0),
        ];
        floats(lengths.prop_map(|length| [length]))
    } else {
        ratios(prop_oneof![
            4 => (-9..=9_i128).prop_map(|length| ([length], 1)),
            3 => (-60..=60_i128, select(vec![1, 2, 3, 4, 6])).prop_map(|(numerator, denominator)| ([numerator], denominator)),
            1 => (0..6_u32, select(vec![1, -1])).prop_map(|(exponent, sign)| ([sign * 10_i128.pow(exponent)], 1)),
        ])
    })
}

/// From 1e-18 to 0.01, of exact numbers from 0.01 to 0.09, and their negatives.
pub(super) fn small_lengths<T: Coefficient>() -> BoxedStrategy<T> {
    single(if is_floating_point::<T>() {
        floats(signed_powers(-18.0..-2.0).prop_map(|value| [value]))
    } else {
        ratios((1..=9_i128, select(vec![1, -1])).prop_map(|(hundredths, sign)| ([sign * hundredths], 100)))
    })
}

/// From 1e4 to 1e8, of exact numbers to 1e5, and their negatives.
pub(super) fn huge_lengths<T: Coefficient>() -> BoxedStrategy<T> {
    single(if is_floating_point::<T>() {
        floats(signed_powers(4.0..8.0).prop_map(|value| [value]))
    } else {
        ratios((10_000..=100_000_i128, select(vec![1, -1])).prop_map(|(length, sign)| ([sign * length], 1)))
    })
}

/// Of length 1, in space: those with short decimals first, to which others shrink.
pub(super) fn unit_vectors<T: Coefficient>() -> BoxedStrategy<[T; 3]> {
    let choices = [[100, 0, 0], [0, 100, 0], [0, 0, 100], [60, 80, 0], [0, 60, -80], [48, 60, 64]];
    let any = if is_floating_point::<T>() {
        let any = [-1.0..1.0, -1.0..1.0, -1.0..1.0];
        let any = any.prop_filter("not 0", |&[x, y, z]: &[f64; 3]| x * x + y * y + z * z > 1e-6);
        floats(any.prop_map(|[x, y, z]| {
            let norm = (x * x + y * y + z * z).sqrt();
            [x / norm, y / norm, z / norm]
        }))
    } else {
        let any = [-2..=2_i128, -2..=2_i128, -2..=2_i128].prop_filter("not 0", |&any| any != [0, 0, 0]);
        ratios(any.prop_map(|[a, b, c]| ([2 * a * c, 2 * b * c, a * a + b * b - c * c], a * a + b * b + c * c)))
    };
    prop_oneof![2 => simple(&choices, 100), 3 => any].boxed()
}

/// Of length 1, in the plane: those with short decimals first.
pub(super) fn plane_unit_vectors<T: Coefficient>() -> BoxedStrategy<[T; 2]> {
    let choices = [[10, 0], [0, 10], [6, 8], [-8, 6]];
    prop_oneof![2 => simple(&choices, 10), 3 => turns()].boxed()
}

/// Cosine and sine of these half-angles.
fn turns_by<T: Coefficient>(half_angles: impl Strategy<Value = f64> + Clone + 'static) -> BoxedStrategy<[T; 2]> {
    floats(half_angles.prop_map(|half_angle| {
        let (sin, cos) = half_angle.sin_cos();
        [cos, sin]
    }))
}

/// Cosine and sine of twice the angle whose tangent is n / m.
fn turns_of<T: Coefficient>(
    tangents: impl Strategy<Value = (i128, i128)> + Clone + 'static,
    image: fn([i128; 2]) -> [i128; 2],
) -> BoxedStrategy<[T; 2]> {
    ratios(tangents.prop_map(move |(n, m)| (image([m * m - n * n, 2 * m * n]), m * m + n * n)))
}

fn small_tangents() -> impl Strategy<Value = (i128, i128)> + Clone {
    (select(vec![1, -1]), 10..=30_i128)
}

/// Cosine and sine of any half-angle.
pub(super) fn turns<T: Coefficient>() -> BoxedStrategy<[T; 2]> {
    if is_floating_point::<T>() { turns_by(-PI..PI) } else { turns_of((-6..=6_i128, 1..=6_i128), |turn| turn) }
}

/// Cosine and sine of half-angles from 1e-18 to 0.01, of exact numbers from 0.06 to 0.2.
pub(super) fn turns_near_identity<T: Coefficient>() -> BoxedStrategy<[T; 2]> {
    if is_floating_point::<T>() {
        turns_by(signed_powers(-18.0..-2.0))
    } else {
        turns_of(small_tangents(), |turn| turn)
    }
}

/// Cosine and sine of half-angles that differ as little from half a turn's.
pub(super) fn turns_near_half_turn<T: Coefficient>() -> BoxedStrategy<[T; 2]> {
    if is_floating_point::<T>() {
        turns_by(signed_powers(-18.0..-2.0).prop_map(|distance| FRAC_PI_2 + distance))
    } else {
        turns_of(small_tangents(), |[cos, sin]| [-sin, cos])
    }
}
