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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Rotor;
    use core::f64::consts::FRAC_1_SQRT_2;

    fn sum(inputs: &[(Rotor<f64>, f64)]) -> Option<[f64; 4]> {
        aligned_sum(inputs.iter().copied(), |a: Rotor<f64>, b| {
            a.s * b.s + a.e23 * b.e23 + a.e31 * b.e31 + a.e12 * b.e12
        })
    }

    const ONE: Rotor<f64> = Rotor::IDENTITY;
    const HALF_TURN_X: Rotor<f64> = Rotor { s: 0.0, e23: 1.0, e31: 0.0, e12: 0.0 };
    const HALF_TURN_Y: Rotor<f64> = Rotor { s: 0.0, e23: 0.0, e31: 1.0, e12: 0.0 };

    #[test]
    fn weights_become_proportions() {
        assert_eq!(sum(&[(ONE, 2.0), (HALF_TURN_X, 1.0), (HALF_TURN_Y, 1.0)]), Some([0.5, 0.25, 0.25, 0.0]));
        assert_eq!(sum(&[(ONE, -2.0), (HALF_TURN_X, -1.0), (HALF_TURN_Y, -1.0)]), Some([0.5, 0.25, 0.25, 0.0]));
        assert_eq!(sum(&[(ONE, 3.0), (HALF_TURN_X, -1.0)]), Some([0.75, -0.25, 0.0, 0.0]));
        assert_eq!(sum(&[(ONE, 1e300), (HALF_TURN_X, 1e300)]), Some([0.5, 0.5, 0.0, 0.0]));
    }

    #[test]
    fn the_sum_has_the_sign_of_the_heaviest_whatever_the_others() {
        let near = Rotor { s: FRAC_1_SQRT_2, e23: FRAC_1_SQRT_2, ..ONE };
        let expected = [0.75 + 0.25 * FRAC_1_SQRT_2, 0.25 * FRAC_1_SQRT_2, 0.0, 0.0];
        for other in [near, -near] {
            assert_eq!(sum(&[(ONE, 3.0), (other, 1.0)]), Some(expected));
            assert_eq!(sum(&[(other, 1.0), (-ONE, 3.0)]), Some(expected.map(|coefficient| -coefficient)));
        }
    }

    #[test]
    fn equal_weights_give_the_same_in_any_order() {
        let inputs = [(ONE, 1.0), (HALF_TURN_X, 1.0), (-HALF_TURN_Y, 1.0)];
        let [a, b, c] = inputs;
        let expected = sum(&inputs).unwrap().map(f64::abs);
        for order in [[a, b, c], [a, c, b], [b, a, c], [b, c, a], [c, a, b], [c, b, a]] {
            // The first coefficient decides which is last in the order of coefficients, so the identity has the sign.
            let found = sum(&order).unwrap();
            assert_eq!((found.map(f64::abs), found[0] > 0.0), (expected, true));
        }
        // Of two equal motions the one in its canonical sign is taken.
        assert_eq!(sum(&[(ONE, 1.0), (-ONE, 1.0)]), sum(&[(-ONE, 1.0), (ONE, 1.0)]));
        assert_eq!(sum(&[(ONE, 1.0), (-ONE, 1.0)]), Some([1.0, 0.0, 0.0, 0.0]));
    }

    #[test]
    fn what_is_not_finite_or_has_no_weight_has_no_sum() {
        assert_eq!(sum(&[]), None);
        assert_eq!(sum(&[(ONE, 0.0), (HALF_TURN_X, 0.0)]), None);
        assert_eq!(sum(&[(ONE, 1.0), (HALF_TURN_X, -1.0)]), None);
        for wrong in [f64::NAN, f64::INFINITY] {
            assert_eq!(sum(&[(ONE, wrong), (HALF_TURN_X, 1.0)]), None);
            assert_eq!(sum(&[(ONE, 1.0), (Rotor { e12: wrong, ..ONE }, 0.0)]), None);
        }
    }

    #[test]
    fn rounding_is_one_epsilon_for_each_term_and_one_more() {
        assert_eq!((rounding::<f64>(0), rounding::<f64>(7)), (f64::EPSILON, 8.0 * f64::EPSILON));
        assert_eq!(rounding::<f32>(1), 2.0 * f32::EPSILON);
    }
}
