//! What a coefficient must be able to do.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// A coefficient: an element of a commutative ring. There is nothing to implement; whatever has the operations is a
/// `Number`: `f32`, `f64`, `i64`, or an exact rational.
///
/// Division is not among them, for no operation of this module but the norms needs more than a ring. That lets the
/// laws of the algebra be tested exactly, with integers.
pub trait Number:
    Clone + PartialEq + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Neg<Output = Self> + From<i8>
{
}

impl<T> Number for T where
    T: Clone + PartialEq + Add<Output = T> + Sub<Output = T> + Mul<Output = T> + Neg<Output = T> + From<i8>
{
}

/// A coefficient of which norms can be taken: `f32` and `f64`.
pub trait Real: Number + Div<Output = Self> {
    /// The absolute value.
    fn abs(self) -> Self;

    /// The square root of a value that is not negative.
    fn sqrt(self) -> Self;
}

impl Real for f32 {
    fn abs(self) -> Self {
        f32::abs(self)
    }

    fn sqrt(self) -> Self {
        f32::sqrt(self)
    }
}

impl Real for f64 {
    fn abs(self) -> Self {
        f64::abs(self)
    }

    fn sqrt(self) -> Self {
        f64::sqrt(self)
    }
}
