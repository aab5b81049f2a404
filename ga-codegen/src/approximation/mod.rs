//! Polynomials in place of the functions of one argument that exp and log are made of, for code without roots,
//! divisions, branches and library calls.
//!
//! The closed forms of exp and log (`factor`) need five functions besides sums and products. Written in the right
//! argument, each is a power series with rational coefficients, so a polynomial comes near it:
//! - exp of a line with half-angle l, in A = l^2: cos l, sin l / l, and (cos l - sin l / l) / A;
//! - log of a unit motor with scalar part s, in x = 1 - s: acos s / sqrt(1 - s^2), and its derivative.
//!
//! [`Function::series`] is what a polynomial is judged by; [`approximation`] is the polynomial for a [`Precision`].
//! `tables` is computed by `ga-codegen fit`; its error bounds hold for the exact values of the rounded coefficients.
//! What rounding adds when the polynomial is evaluated is printed by that command.

#[rustfmt::skip]
mod tables;

use crate::symbolic::{Overflow, Rational};

/// A function that exp or log is made of, in the argument where it is a power series with rational coefficients.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Function {
    /// cos √A = 1 - A/2 + A^2/24 - ...
    CosRoot,
    /// sin √A / √A = 1 - A/6 + A^2/120 - ...
    SincRoot,
    /// (cos √A - sin √A / √A) / A = -1/3 + A/30 - ..., twice the derivative of [`Self::SincRoot`].
    SincSlope,
    /// acos s / √(1 - s^2) at s = 1 - x: an angle over its sine, 1 + x/3 + 2 x^2/15 + ...
    AngleRatio,
    /// (1 - s k) / (1 - s^2) at s = 1 - x, where k is [`Self::AngleRatio`]: the derivative of k by x,
    /// 1/3 + 4 x/15 + ...
    AngleSlope,
}

impl Function {
    /// All of them.
    pub const ALL: [Self; 5] = [Self::CosRoot, Self::SincRoot, Self::SincSlope, Self::AngleRatio, Self::AngleSlope];

    /// Its name, in lower case.
    pub const fn name(self) -> &'static str {
        match self {
            Self::CosRoot => "cos_root",
            Self::SincRoot => "sinc_root",
            Self::SincSlope => "sinc_slope",
            Self::AngleRatio => "angle_ratio",
            Self::AngleSlope => "angle_slope",
        }
    }

    /// What it is, as a formula.
    pub const fn formula(self) -> &'static str {
        match self {
            Self::CosRoot => "cos √A",
            Self::SincRoot => "sin √A / √A",
            Self::SincSlope => "(cos √A - sin √A / √A) / A",
            Self::AngleRatio => "acos s / √(1 - s²), s = 1 - x",
            Self::AngleSlope => "(1 - s acos s / √(1 - s²)) / (1 - s²), s = 1 - x",
        }
    }

    /// What the argument is called in [`Self::formula`].
    pub const fn variable(self) -> &'static str {
        match self {
            Self::CosRoot | Self::SincRoot | Self::SincSlope => "A",
            Self::AngleRatio | Self::AngleSlope => "x",
        }
    }

    /// The least and the greatest argument for which it is approximated.
    ///
    /// Half-angles to π/2, which are turns to π, end at A = 2.4674; a unit motor of the sign with s >= 0 has x in
    /// [0, 1], and one that has drifted may have s a little above 1.
    pub const fn interval(self) -> (f64, f64) {
        match self {
            Self::CosRoot | Self::SincRoot | Self::SincSlope => (0.0, 2.5),
            Self::AngleRatio | Self::AngleSlope => (-1.0 / 1024.0, 1.0),
        }
    }

    /// The `n`-th coefficient of its power series.
    ///
    /// # Errors
    /// [`Overflow`], from some n between 10 and 100 on.
    pub fn series(self, n: u32) -> Result<Rational, Overflow> {
        (1..=n).try_fold(self.constant()?, |coefficient, n| coefficient.checked_mul(self.ratio(n)?))
    }

    fn constant(self) -> Result<Rational, Overflow> {
        match self {
            Self::CosRoot | Self::SincRoot | Self::AngleRatio => Ok(Rational::ONE),
            Self::SincSlope => Rational::new(-1, 3),
            Self::AngleSlope => Rational::new(1, 3),
        }
    }

    /// The `n`-th coefficient of its power series over the one before; `n` is not 0.
    ///
    /// All five series are hypergeometric, so this is a quotient of polynomials in n. That of [`Self::AngleRatio`]
    /// follows from (2x - x^2) k' = 1 - (1 - x) k.
    ///
    /// # Errors
    /// [`Overflow`], where `n` is 0.
    pub fn ratio(self, n: u32) -> Result<Rational, Overflow> {
        let n = i128::from(n);
        match self {
            Self::CosRoot => Rational::new(-1, (2 * n - 1) * 2 * n),
            Self::SincRoot => Rational::new(-1, 2 * n * (2 * n + 1)),
            Self::SincSlope => Rational::new(-1, 2 * n * (2 * n + 3)),
            Self::AngleRatio => Rational::new(n, 2 * n + 1),
            Self::AngleSlope => Rational::new((n + 1) * (n + 1), n * (2 * n + 3)),
        }
    }
}

/// A format of floating-point numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Precision {
    /// 24 bits.
    F32,
    /// 53 bits.
    F64,
}

impl Precision {
    /// Both.
    pub const ALL: [Self; 2] = [Self::F32, Self::F64];

    /// Its name in Rust.
    pub const fn name(self) -> &'static str {
        match self {
            Self::F32 => "f32",
            Self::F64 => "f64",
        }
    }

    /// The unit roundoff u, half the distance from 1 to the next number: the relative error of one rounding is at most
    /// this.
    pub const fn unit_roundoff(self) -> f64 {
        match self {
            Self::F32 => f32::EPSILON as f64 / 2.0,
            Self::F64 => f64::EPSILON / 2.0,
        }
    }
}

/// A polynomial near a [`Function`] on its interval.
///
/// At 0 it is the number of its precision that is nearest to the function: exactly 1 where the function is, so exp and
/// log of a translation are exact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Approximation {
    /// The coefficients, that of the constant first; for [`Precision::F32`] every one is an f32.
    pub coefficients: &'static [f64],
    /// No value of the polynomial, computed exactly, is farther than this from the function.
    pub error: f64,
}

impl Approximation {
    /// The greatest power of the argument.
    pub const fn degree(&self) -> usize {
        self.coefficients.len() - 1
    }
}

/// The polynomial near `function` with coefficients in `precision`: of the least degree whose error is at most a
/// quarter of the unit roundoff times the greatest value of the function, where that is above 1.
///
/// ```
/// use ga_codegen::approximation::{Function, Precision, approximation};
/// let cosine = approximation(Function::CosRoot, Precision::F64);
/// let horner = |a: f64| cosine.coefficients.iter().rev().fold(0.0, |sum, coefficient| sum * a + coefficient);
/// assert_eq!(horner(0.0), 1.0);
/// assert!((horner(0.25) - 0.5_f64.cos()).abs() < 1e-15);
/// ```
pub const fn approximation(function: Function, precision: Precision) -> &'static Approximation {
    match (function, precision) {
        (Function::CosRoot, Precision::F32) => &tables::COS_ROOT_F32,
        (Function::CosRoot, Precision::F64) => &tables::COS_ROOT_F64,
        (Function::SincRoot, Precision::F32) => &tables::SINC_ROOT_F32,
        (Function::SincRoot, Precision::F64) => &tables::SINC_ROOT_F64,
        (Function::SincSlope, Precision::F32) => &tables::SINC_SLOPE_F32,
        (Function::SincSlope, Precision::F64) => &tables::SINC_SLOPE_F64,
        (Function::AngleRatio, Precision::F32) => &tables::ANGLE_RATIO_F32,
        (Function::AngleRatio, Precision::F64) => &tables::ANGLE_RATIO_F64,
        (Function::AngleSlope, Precision::F32) => &tables::ANGLE_SLOPE_F32,
        (Function::AngleSlope, Precision::F64) => &tables::ANGLE_SLOPE_F64,
    }
}
