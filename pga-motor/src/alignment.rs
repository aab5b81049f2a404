//! Sums of many motors, each with the sign that brings it near the others: what blending in space and in the plane have in
//! common.

use crate::Real;
use core::ops::Neg;

/// The sum of motors, given as their coefficients, with weights whose magnitudes add up to 1 and whose sum is positive,
/// each motor with the sign that brings it nearer to the heaviest, whose sign the sum has. Up to that, the signs of the
/// inputs do not matter.
///
/// `None` where there is nothing finite to add, or the weights add up to 0 to rounding. The sum itself may cancel; what
/// is not longer than [`rounding`] has.
pub(crate) fn aligned_sum<T, M, const N: usize>(
    inputs: impl Iterator<Item = (M, T)> + Clone,
    scalar_product: impl Fn(M, M) -> T,
) -> Option<[T; N]>
where
    T: Real,
    M: Copy + Neg<Output = M> + Into<[T; N]>,
{
    let finite = |motor: M| motor.into().iter().all(|coefficient| coefficient.is_finite());
    if !inputs.clone().all(|(motor, weight)| weight.is_finite() && finite(motor)) {
        return None;
    }
    let larger = |a: T, b: T| if b > a { b } else { a };
    let largest = inputs.clone().fold(T::ZERO, |largest, (_, weight)| larger(largest, weight.abs()));
    if largest == T::ZERO {
        return None;
    }
    let sum = |term: fn(T) -> T| inputs.clone().fold(T::ZERO, |sum, (_, weight)| sum + term(weight / largest));
    let (total, magnitudes) = (sum(|weight| weight), sum(|weight| weight.abs()));
    if total.abs() <= magnitudes * rounding(inputs.clone().count()) {
        return None;
    }
    let scale = if total < T::ZERO { -magnitudes } else { magnitudes };
    let weighted = inputs.map(|(motor, weight)| (motor, weight / largest / scale));
    let heaviest = heaviest(weighted.clone())?;
    let reference = canonical(heaviest);
    let mut sum = [T::ZERO; N];
    for (motor, weight) in weighted {
        let coefficients: [T; N] = aligned(motor, scalar_product(reference, motor)).into();
        sum.iter_mut().zip(coefficients).for_each(|(sum, coefficient)| *sum = *sum + coefficient * weight);
    }
    Some(if is_canonical(heaviest) { sum } else { sum.map(|coefficient| -coefficient) })
}

/// How long the sum of `count` terms, whose lengths add up to 1, may be although the exact sum is 0.
///
/// With u = EPSILON / 2, each term of length w is off by u w for each of four roundings: of the motor itself, of the
/// two quotients that make its weight, of the product. The sums add at most (count - 1) u. Together (count + 3) u,
/// which is at most (count + 1) EPSILON.
pub(crate) fn rounding<T: Real>(count: usize) -> T {
    T::EPSILON * T::from_f64(count as f64 + 1.0)
}

/// The input of greatest weight. Equal weights are told apart by the coefficients of the motor in its canonical sign,
/// of two equal motions the one in its canonical sign is taken: the order of the inputs does not matter.
fn heaviest<T, M, const N: usize>(inputs: impl Iterator<Item = (M, T)>) -> Option<M>
where
    T: Real,
    M: Copy + Neg<Output = M> + Into<[T; N]>,
{
    let rank = |(motor, weight): (M, T)| (weight, canonical(motor).into(), is_canonical(motor));
    inputs.reduce(|best, next| if rank(next) > rank(best) { next } else { best }).map(|(motor, _)| motor)
}

/// The motor or its negative, whichever is nearer to the reference; between the two the one in its canonical sign.
fn aligned<T, M, const N: usize>(motor: M, product_with_reference: T) -> M
where
    T: Real,
    M: Copy + Neg<Output = M> + Into<[T; N]>,
{
    if product_with_reference == T::ZERO {
        canonical(motor)
    } else if product_with_reference < T::ZERO {
        -motor
    } else {
        motor
    }
}

/// The motor or its negative: the one whose first coefficient other than 0 is positive.
fn canonical<T, M, const N: usize>(motor: M) -> M
where
    T: Real,
    M: Copy + Neg<Output = M> + Into<[T; N]>,
{
    if is_canonical(motor) { motor } else { -motor }
}

fn is_canonical<T: Real, const N: usize>(motor: impl Into<[T; N]>) -> bool {
    let first = motor.into().into_iter().find(|coefficient| *coefficient != T::ZERO);
    first.is_none_or(|coefficient| coefficient > T::ZERO)
}
