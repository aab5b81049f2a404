//! Rational numbers as a scalar: the compiled kernels run on them without rounding.

use num_rational::Ratio;
use num_traits::{CheckedAdd, CheckedDiv, CheckedMul, CheckedSub};
use std::fmt;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A rational number in arithmetic that panics where a result does not fit, in any build.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub(crate) struct Exact(Ratio<i128>);

const OVERFLOW: &str = "exact arithmetic overflowed i128: the samples are too large for this kernel";

impl Exact {
    pub(crate) const ZERO: Self = Self(Ratio::new_raw(0, 1));
    pub(crate) const ONE: Self = Self(Ratio::new_raw(1, 1));

    pub(crate) fn new(numerator: i128, denominator: i128) -> Self {
        Self(Ratio::new(numerator, denominator))
    }

    /// The nearest `f64` up to 3 units of rounding, u = 2^-53: one for each part and one for the division.
    pub(crate) fn to_f64(self) -> f64 {
        *self.0.numer() as f64 / *self.0.denom() as f64
    }
}

/// What a kernel that asks for more than a ring comes to here: no polynomial kernel may.
pub(crate) fn irrational() -> ! {
    panic!("a polynomial kernel called a function of real numbers")
}

impl fmt::Display for Exact {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl From<i8> for Exact {
    fn from(value: i8) -> Self {
        Self::new(value.into(), 1)
    }
}

impl Add for Exact {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self(self.0.checked_add(&other.0).expect(OVERFLOW))
    }
}

impl Sub for Exact {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self(self.0.checked_sub(&other.0).expect(OVERFLOW))
    }
}

impl Mul for Exact {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self(self.0.checked_mul(&other.0).expect(OVERFLOW))
    }
}

impl Div for Exact {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        Self(self.0.checked_div(&other.0).expect("no division by 0 and no overflow of i128"))
    }
}

impl Neg for Exact {
    type Output = Self;
    fn neg(self) -> Self {
        Self::ZERO - self
    }
}

/// Implements the traits `Scalar` and `Real` of a module for [`Exact`]; what is in braces is added to `Real`. The
/// functions of real numbers panic, so that a polynomial kernel that calls one does not go unnoticed.
macro_rules! exact_scalar {
    ($first:ident $(::$module:ident)* { $($more:item)* }) => {
        impl $first$(::$module)*::Scalar for $crate::exact::Exact {
            const ZERO: Self = Self::ZERO;
            const ONE: Self = Self::ONE;
            fn from_ratio(numerator: i32, denominator: i32) -> Self {
                Self::new(numerator.into(), denominator.into())
            }
        }

        impl $first$(::$module)*::Real for $crate::exact::Exact {
            $($more)*
            fn sqrt(self) -> Self {
                $crate::exact::irrational()
            }
            fn sin_cos(self) -> (Self, Self) {
                $crate::exact::irrational()
            }
            fn atan2(self, _: Self) -> Self {
                $crate::exact::irrational()
            }
            fn abs(self) -> Self {
                if self < Self::ZERO { -self } else { self }
            }
            fn is_finite(self) -> bool {
                true
            }
            fn from_f64(_: f64) -> Self {
                $crate::exact::irrational()
            }
            fn power_of_two(self) -> Self {
                $crate::exact::irrational()
            }
            fn quotient(self, _: Self, _: Self) -> Self {
                $crate::exact::irrational()
            }
        }
    };
}
