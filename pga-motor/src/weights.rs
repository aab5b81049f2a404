//! Weights for sums of two: what the interpolations in space and in the plane have in common.

use crate::Real;
use core::ops::{Add, Mul, Sub};

/// How to add two motors up: the nearer end times one weight, and the difference to the other end times another. So an
/// end is exact, and equal ends stay put however far t is outside \[0, 1\].
#[derive(Clone, Copy)]
pub(crate) struct Weights<T> {
    /// What the nearer end is multiplied by: the sum of the two motors' weights.
    pub(crate) near: T,
    /// What the other end minus the nearer one is multiplied by: the other motor's weight.
    pub(crate) step: T,
}

/// t counted from the nearer end.
fn from_nearer_end<T: Real>(t: T) -> T {
    if t > T::from_ratio(1, 2) { T::ONE - t } else { t }
}

/// The sum of two elements of a linear type with weights for t.
#[inline]
pub(crate) fn mix<T, V>(a: V, b: V, t: T, weights: Weights<T>) -> V
where
    T: Real,
    V: Copy + Add<Output = V> + Sub<Output = V> + Mul<T, Output = V>,
{
    let (near, far) = if t > T::from_ratio(1, 2) { (b, a) } else { (a, b) };
    near * weights.near + (far - near) * weights.step
}

/// Whether t is between the ends.
#[inline]
pub(crate) fn is_between<T: Real>(t: T) -> bool {
    t >= T::ZERO && t <= T::ONE
}

/// Weights for the straight line.
#[inline]
pub(crate) fn chord<T: Real>(t: T) -> Weights<T> {
    Weights { near: T::ONE, step: from_nearer_end(t) }
}

/// Weights for the great arc, run through at constant speed (Shoemake 1985): sin((1 - t) h)/sin h and sin(t h)/sin h, whose sum is
/// cos((1/2 - t) h)/cos(h/2). Sines are divided by their angles, so that small angles need no case of their own.
pub(crate) fn great_arc<T: Real>(sine: T, cosine: T, t: T) -> Weights<T> {
    let (angle, t) = (sine.atan2(cosine.abs()), from_nearer_end(t));
    let half = T::from_ratio(1, 2);
    let cosine = |angle: T| angle.sin_cos().1;
    Weights { near: cosine((half - t) * angle) / cosine(half * angle), step: t * (sinc(t * angle) / sinc(angle)) }
}

fn sinc<T: Real>(angle: T) -> T {
    let (sine, _) = angle.sin_cos();
    sine.quotient(angle, T::ONE)
}

#[cfg(test)]
mod tests {
    use super::*;
    use core::f64::consts::{FRAC_1_SQRT_2, PI};

    #[test]
    fn the_ends_are_between_themselves() {
        for t in [0.0, 5e-324, 0.5, 1.0] {
            assert!(is_between(t), "{t}");
        }
        for t in [-5e-324, -1.0, 1.0 + f64::EPSILON, 2.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert!(!is_between(t), "{t}");
        }
    }

    #[test]
    fn chords_are_straight_lines_from_the_nearer_end() {
        for (t, expected) in [(-2.0, -7.0), (0.0, 3.0), (0.25, 4.25), (0.5, 5.5), (0.75, 6.75), (1.0, 8.0), (2.0, 13.0)]
        {
            assert_eq!(mix(3.0, 8.0, t, chord(t)), expected, "{t}");
        }
        // Both ends are met however different their sizes.
        for (a, b) in [(1e300, 1.0), (1.0, 1e300)] {
            assert_eq!((mix(a, b, 0.0, chord(0.0)), mix(a, b, 1.0, chord(1.0))), (a, b));
        }
    }

    /// From the point (1, 0) of the unit circle to (cos h, sin h) at the angle t h; EPSILON for the sines and the sum.
    #[test]
    fn great_arcs_turn_evenly() {
        for h in [1e-9, 0.3, 1.0, PI / 2.0] {
            for t in [-1.0, 0.0, 0.2, 0.5, 0.8, 1.0, 2.0] {
                let (sine, cosine) = h.sin_cos();
                let weights = great_arc(sine, cosine, t);
                let found = [mix(1.0, cosine, t, weights), mix(0.0, sine, t, weights)];
                let expected = [(t * h).cos(), (t * h).sin()];
                let off = [found[0] - expected[0], found[1] - expected[1]].map(f64::abs);
                assert!(off.iter().all(|off| *off <= 8.0 * f64::EPSILON), "{h} {t}: {found:?}");
            }
        }
        // In the middle of a right angle, with the sign of the cosine not counted: the nearer of two opposite ends.
        let middle = great_arc(1.0, -0.0, 0.5);
        assert!((mix(1.0, 0.0, 0.5, middle) - FRAC_1_SQRT_2).abs() <= f64::EPSILON);
        let (sine, cosine) = 1_f64.sin_cos();
        let [one, other] = [great_arc(sine, cosine, 0.3), great_arc(sine, -cosine, 0.3)];
        assert_eq!((one.near, one.step), (other.near, other.step));
        // Equal ends stay where they are.
        let still = great_arc(0.0, 1.0, 0.25);
        assert_eq!((still.near, still.step), (1.0, 0.25));
    }
}
