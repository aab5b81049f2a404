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
