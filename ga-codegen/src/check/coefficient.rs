//! Coefficients, and the same with a running error bound.

use std::fmt;
use std::ops::{Add, Mul, Neg, Sub};

use crate::reference::{Multivector, Number};

/// A coefficient that checks can be run on: `f32`, `f64`, `i64`, `i128`, [`Fraction`](super::Fraction), or an exact number
/// of your own.
///
/// The provided methods are those of an exact number.
pub trait Coefficient: Number + fmt::Debug + fmt::Display + 'static {
    /// Half the distance from 1 to the next larger number; 0 for an exact number.
    const UNIT_ROUNDOFF: f64 = 0.0;

    /// The least positive normal number; 0 for an exact number.
    const LEAST_NORMAL: f64 = 0.0;

    /// A quotient of whole numbers, if the type can hold it. The denominator is positive.
    fn from_ratio(numerator: i128, denominator: i128) -> Option<Self>;

    /// The absolute value, which tolerances are measured in; 0 for an exact number.
    fn magnitude(&self) -> f64 {
        0.0
    }

    /// The nearest number in floating point; `None` for exact numbers, and formats finer than `f64`.
    fn from_f64(_value: f64) -> Option<Self> {
        None
    }

    /// The same value as an `f64`; `None` where [`Coefficient::from_f64`] gives that.
    fn to_f64(&self) -> Option<f64> {
        None
    }
}

macro_rules! floats {
    ($($float:ident)*) => { $(
        impl Coefficient for $float {
            const UNIT_ROUNDOFF: f64 = $float::EPSILON as f64 / 2.0;
            const LEAST_NORMAL: f64 = $float::MIN_POSITIVE as f64;

            fn from_ratio(numerator: i128, denominator: i128) -> Option<Self> {
                Some(numerator as $float / denominator as $float)
            }

            fn magnitude(&self) -> f64 {
                f64::from(self.abs())
            }

            fn from_f64(value: f64) -> Option<Self> {
                Some(value as $float)
            }

            fn to_f64(&self) -> Option<f64> {
                Some(f64::from(*self))
            }
        }
    )* };
}

floats! { f32 f64 }

macro_rules! integers {
    ($($integer:ident)*) => { $(
        impl Coefficient for $integer {
            fn from_ratio(numerator: i128, denominator: i128) -> Option<Self> {
                (numerator % denominator == 0).then(|| numerator / denominator)?.try_into().ok()
            }
        }
    )* };
}

integers! { i64 i128 }

/// A coefficient of the reference as it is computed, with what bounds its error.
#[derive(Clone, Debug)]
pub(super) struct Running<T> {
    pub(super) value: T,
    /// The same expression on absolute values, every difference a sum.
    pub(super) size: f64,
    /// The most operations that a term of it has gone through.
    pub(super) depth: u32,
}

impl<T: Coefficient> Running<T> {
    /// A number that nothing was done to yet.
    pub(super) fn exact(value: T) -> Self {
        let size = value.magnitude();
        Self { value, size, depth: 0 }
    }

    /// A quotient, which is one operation old.
    pub(super) fn rounded(value: T) -> Self {
        Self { depth: 1, ..Self::exact(value) }
    }
}

impl<T: Coefficient> From<i8> for Running<T> {
    fn from(value: i8) -> Self {
        Self::exact(T::from(value))
    }
}

/// A sum whose terms cancel is not a 0 that nothing was done to: its size stays.
impl<T: Coefficient> PartialEq for Running<T> {
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value && self.size == other.size
    }
}

impl<T: Coefficient> Add for Running<T> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let depth = self.depth.max(other.depth) + 1;
        Self { value: self.value + other.value, size: self.size + other.size, depth }
    }
}

impl<T: Coefficient> Sub for Running<T> {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<T: Coefficient> Mul for Running<T> {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let depth = self.depth + other.depth + 1;
        Self { value: self.value * other.value, size: self.size * other.size, depth }
    }
}

impl<T: Coefficient> Neg for Running<T> {
    type Output = Self;

    fn neg(self) -> Self {
        Self { value: -self.value, ..self }
    }
}

/// A multivector whose coefficients are exact.
pub(super) fn running<T: Coefficient>(value: &Multivector<T>) -> Multivector<Running<T>> {
    map(value, Running::exact)
}

/// The values alone.
pub(super) fn values<T: Coefficient>(value: &Multivector<Running<T>>) -> Multivector<T> {
    map(value, |coefficient| coefficient.value)
}

/// The same blades with images of the coefficients.
pub(super) fn map<A: Number, B: Number>(value: &Multivector<A>, image: impl Fn(A) -> B) -> Multivector<B> {
    let blades = value.blades().into_iter().map(|(word, coefficient)| (word, image(coefficient)));
    Multivector::from_blades(value.signature(), blades).expect("invariant: words of a multivector of the signature")
}
