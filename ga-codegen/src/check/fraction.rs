//! Exact rational coefficients.

use std::fmt;
use std::ops::{Add, Div, Mul, Neg, Sub};

use super::Coefficient;
use crate::symbolic::{Overflow, Rational};

/// An exact rational number, of which checks without any tolerance are made.
///
/// Numerator and denominator have 128 bits. That is enough for formulas of degree four in the motors that the
/// [`strategies`](super::strategies) give.
///
/// ```
/// use ga_codegen::check::Fraction;
///
/// let cos = Fraction::new(3, 5).expect("a denominator other than 0");
/// let sin = Fraction::new(8, 10).expect("a denominator other than 0");
/// assert_eq!(cos * cos + sin * sin, Fraction::from(1));
/// assert_eq!(sin.to_string(), "4/5");
/// assert_eq!(Fraction::new(1, 0), None);
/// ```
///
/// # Panics
/// Its operators, where a result does not fit, in any build; a division by 0.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Fraction(Rational);

impl Fraction {
    /// 0
    pub const ZERO: Self = Self(Rational::ZERO);
    /// 1
    pub const ONE: Self = Self(Rational::ONE);

    /// `numerator / denominator`; `None` for the denominator 0, or where one of the two is -2^127.
    pub fn new(numerator: i128, denominator: i128) -> Option<Self> {
        Rational::new(numerator, denominator).ok().map(Self)
    }

    /// The numerator in lowest terms, which carries the sign.
    pub const fn numerator(self) -> i128 {
        self.0.numerator()
    }

    /// The denominator in lowest terms, positive.
    pub const fn denominator(self) -> i128 {
        self.0.denominator()
    }
}

#[track_caller]
fn fitting<T>(result: Result<T, Overflow>) -> T {
    result.unwrap_or_else(|error| panic!("{error}"))
}

impl Add for Fraction {
    type Output = Self;

    #[track_caller]
    fn add(self, other: Self) -> Self {
        Self(fitting(self.0.checked_add(other.0)))
    }
}

impl Sub for Fraction {
    type Output = Self;

    #[track_caller]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Fraction {
    type Output = Self;

    #[track_caller]
    fn mul(self, other: Self) -> Self {
        Self(fitting(self.0.checked_mul(other.0)))
    }
}

impl Div for Fraction {
    type Output = Self;

    #[track_caller]
    fn div(self, other: Self) -> Self {
        match fitting(self.0.checked_div(other.0)) {
            Some(quotient) => Self(quotient),
            None => panic!("expected a divisor other than 0, found 0"),
        }
    }
}

impl Neg for Fraction {
    type Output = Self;

    fn neg(self) -> Self {
        Self(self.0.neg())
    }
}

impl From<i8> for Fraction {
    fn from(value: i8) -> Self {
        Self(Rational::integer(value.into()))
    }
}

/// As it is written, `-3/5`.
impl fmt::Debug for Fraction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl fmt::Display for Fraction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl Coefficient for Fraction {
    fn from_ratio(numerator: i128, denominator: i128) -> Option<Self> {
        Self::new(numerator, denominator)
    }
}
