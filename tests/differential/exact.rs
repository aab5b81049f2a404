//! Rational numbers as a scalar: the compiled kernels run on them without rounding.

use std::cmp::Ordering;
use std::fmt;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A rational number in lowest terms, the denominator positive, in arithmetic that panics where a result does not fit,
/// in any build.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Exact {
    numerator: i128,
    denominator: i128,
}

const OVERFLOW: &str = "exact arithmetic overflowed i128: the samples are too large for this kernel";

/// The greatest common divisor by Euclid, in half the width as soon as that holds both: most numbers here are small,
/// and wide divisions are what costs.
fn greatest_common_divisor(a: i128, b: i128) -> i128 {
    let (mut a, mut b) = (a.unsigned_abs(), b.unsigned_abs());
    while b != 0 {
        if let (Ok(mut narrow), Ok(mut other)) = (u64::try_from(a), u64::try_from(b)) {
            while other != 0 {
                (narrow, other) = (other, narrow % other);
            }
            return narrow.into();
        }
        (a, b) = (b, a % b);
    }
    a.try_into().expect(OVERFLOW)
}

impl Exact {
    pub(crate) const ZERO: Self = Self { numerator: 0, denominator: 1 };
    pub(crate) const ONE: Self = Self { numerator: 1, denominator: 1 };

    pub(crate) fn new(numerator: i128, denominator: i128) -> Self {
        assert!(denominator != 0, "no division by 0");
        let divisor = greatest_common_divisor(numerator, denominator) * denominator.signum();
        Self { numerator: numerator / divisor, denominator: denominator / divisor }
    }

    /// The product, what is common cancelled first.
    fn times(self, other: Self) -> Self {
        let first = greatest_common_divisor(self.numerator, other.denominator);
        let second = greatest_common_divisor(other.numerator, self.denominator);
        let product = |a: i128, b: i128| a.checked_mul(b).expect(OVERFLOW);
        Self {
            numerator: product(self.numerator / first, other.numerator / second),
            denominator: product(self.denominator / second, other.denominator / first),
        }
    }

    /// The nearest `f64` up to 3 units of rounding, u = 2^-53: one for each part and one for the division.
    pub(crate) fn to_f64(self) -> f64 {
        self.numerator as f64 / self.denominator as f64
    }
}

/// What a kernel that asks for more than a ring comes to here: no polynomial kernel may.
pub(crate) fn irrational() -> ! {
    panic!("a polynomial kernel called a function of real numbers")
}

impl fmt::Display for Exact {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.denominator {
            1 => self.numerator.fmt(f),
            _ => write!(f, "{}/{}", self.numerator, self.denominator),
        }
    }
}

impl PartialOrd for Exact {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some((*self - *other).numerator.cmp(&0))
    }
}

impl From<i8> for Exact {
    fn from(value: i8) -> Self {
        Self::new(value.into(), 1)
    }
}

impl Add for Exact {
    type Output = Self;
    /// n/d + m/e with the least common denominator; only what d and e share can still be cancelled (Knuth, The Art of
    /// Computer Programming, vol. 2, 4.5.1).
    fn add(self, other: Self) -> Self {
        let shared = greatest_common_divisor(self.denominator, other.denominator);
        let (own, others) = (self.denominator / shared, other.denominator / shared);
        let (left, right) = (self.numerator.checked_mul(others), other.numerator.checked_mul(own));
        let sum = left.and_then(|left| left.checked_add(right?)).expect(OVERFLOW);
        let common = greatest_common_divisor(sum, shared);
        let denominator = own.checked_mul(other.denominator / common).expect(OVERFLOW);
        Self { numerator: sum / common, denominator }
    }
}

impl Sub for Exact {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Exact {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        self.times(other)
    }
}

impl Div for Exact {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        self.times(Self::new(other.denominator, other.numerator))
    }
}

impl Neg for Exact {
    type Output = Self;
    fn neg(self) -> Self {
        Self { numerator: self.numerator.checked_neg().expect(OVERFLOW), ..self }
    }
}

/// Implements the traits `Scalar` and `Real` of a module for [`Exact`]; what is in braces is added to them. The
/// functions of real numbers panic, so that a polynomial kernel that calls one does not go unnoticed.
macro_rules! exact_scalar {
    ($first:ident $(::$module:ident)* { $($of_scalar:item)* } { $($more:item)* }) => {
        impl $first$(::$module)*::Scalar for $crate::exact::Exact {
            $($of_scalar)*
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
