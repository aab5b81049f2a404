//! Floating-point numbers that carry a bound on their own error: running error analysis (Wilkinson 1963; Higham,
//! "Accuracy and Stability of Numerical Algorithms", 2nd ed., section 3.3).
//!
//! A [`Tracked`] stands for an unknown exact number x with |x - value| <= bound. An operation computes the value just as
//! `f64` does and propagates the bounds of its operands, then adds its own rounding error. With u = 2^-53 that error is at
//! most u |value| for the operations of IEEE 754; [`ROUNDING`] is 2 u, and the second u pays for the roundings in the
//! computation of the bound itself, which are less than 2^40 in number and so raise it by less than a factor of 1 + 2^-12.
//! Sine, cosine and arc tangent of the platform are taken to be within one unit in the last place, 2 u |value|, and get 4 u.
//! Underflow is not accounted for; the tests keep away from it.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// An `f64` with a bound on its distance from the exact number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Tracked {
    pub(crate) value: f64,
    pub(crate) bound: f64,
}

pub(crate) const ROUNDING: f64 = f64::EPSILON;

impl Tracked {
    /// A number that is exact.
    pub(crate) const fn new(value: f64) -> Self {
        Self { value, bound: 0.0 }
    }

    /// A rounded result: the propagated bound and the rounding of the operation itself.
    fn rounded(value: f64, propagated: f64) -> Self {
        Self { value, bound: propagated + ROUNDING * value.abs() }
    }

    /// |sqrt a - sqrt b| is at most sqrt |a - b|, and at most |a - b| / sqrt b.
    pub(crate) fn sqrt(self) -> Self {
        let value = self.value.sqrt();
        let propagated = if value == 0.0 { self.bound.sqrt() } else { self.bound.sqrt().min(self.bound / value) };
        Self::rounded(value, propagated)
    }

    /// The sine has slope at most 1; the cosine, at x, at most |x| and 1.
    pub(crate) fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.value.sin_cos();
        let slope = (self.value.abs() + self.bound).min(1.0);
        (
            Self { value: sin, bound: self.bound + 2.0 * ROUNDING * sin.abs() },
            Self { value: cos, bound: self.bound * slope + 2.0 * ROUNDING * cos.abs() },
        )
    }

    /// The gradient of the angle of (x, y) is (-y, x) / r^2, and r is nowhere less than its value minus both bounds.
    pub(crate) fn atan2(self, x: Self) -> Self {
        let value = self.value.atan2(x.value);
        let least = self.value.hypot(x.value) - self.bound - x.bound;
        let slopes = (x.value.abs() + x.bound) * self.bound + (self.value.abs() + self.bound) * x.bound;
        let propagated = match slopes {
            0.0 => 0.0,
            _ if least > 0.0 => slopes / (least * least),
            _ => f64::INFINITY,
        };
        Self { value, bound: propagated + 2.0 * ROUNDING * value.abs() }
    }

    /// With an exactly zero denominator the limit; otherwise a division.
    pub(crate) fn quotient(self, denominator: Self, limit: Self) -> Self {
        if denominator == Self::new(0.0) { limit } else { self / denominator }
    }

    /// A power of two is exact.
    pub(crate) fn power_of_two(self) -> Self {
        Self::new(pga_motor::Real::power_of_two(self.value))
    }

    pub(crate) fn abs(self) -> Self {
        Self { value: self.value.abs(), ..self }
    }
}

impl PartialOrd for Tracked {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        self.value.partial_cmp(&other.value)
    }
}

impl From<i8> for Tracked {
    fn from(value: i8) -> Self {
        Self::new(value.into())
    }
}

impl Add for Tracked {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::rounded(self.value + other.value, self.bound + other.bound)
    }
}

impl Sub for Tracked {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self::rounded(self.value - other.value, self.bound + other.bound)
    }
}

impl Mul for Tracked {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let propagated = self.value.abs() * other.bound + other.value.abs() * self.bound + self.bound * other.bound;
        Self::rounded(self.value * other.value, propagated)
    }
}

impl Div for Tracked {
    type Output = Self;
    /// |n/d - n'/d'| <= (|n - n'| + |n/d| |d - d'|) / |d'|, and |d'| is at least |d| minus its bound.
    fn div(self, other: Self) -> Self {
        let (value, least) = (self.value / other.value, other.value.abs() - other.bound);
        let propagated = if least > 0.0 { (self.bound + value.abs() * other.bound) / least } else { f64::INFINITY };
        Self::rounded(value, propagated)
    }
}

impl Neg for Tracked {
    type Output = Self;
    fn neg(self) -> Self {
        Self { value: -self.value, ..self }
    }
}

/// Implements the traits `Scalar` and `Real` of a module for [`Tracked`]; what is in braces is added to them.
macro_rules! tracked_scalar {
    ($first:ident $(::$module:ident)* { $($of_scalar:item)* } { $($more:item)* }) => {
        impl $first$(::$module)*::Scalar for $crate::tracked::Tracked {
            $($of_scalar)*
            const ZERO: Self = Self::new(0.0);
            const ONE: Self = Self::new(1.0);
            fn from_ratio(numerator: i32, denominator: i32) -> Self {
                Self::new(numerator.into()) / Self::new(denominator.into())
            }
        }

        impl $first$(::$module)*::Real for $crate::tracked::Tracked {
            $($more)*
            fn sqrt(self) -> Self {
                self.sqrt()
            }
            fn sin_cos(self) -> (Self, Self) {
                self.sin_cos()
            }
            fn atan2(self, x: Self) -> Self {
                self.atan2(x)
            }
            fn abs(self) -> Self {
                self.abs()
            }
            fn is_finite(self) -> bool {
                self.value.is_finite()
            }
            fn from_f64(value: f64) -> Self {
                Self::new(value)
            }
            fn power_of_two(self) -> Self {
                self.power_of_two()
            }
            fn quotient(self, denominator: Self, limit: Self) -> Self {
                self.quotient(denominator, limit)
            }
        }
    };
}
