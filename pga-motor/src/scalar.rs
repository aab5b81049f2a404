//! The numbers that motors are made of.
//!
//! Polynomial kernels need a ring, [`Scalar`]; norms, angles, exp and log need [`Real`]. Both are implemented for `f32`
//! and `f64`; `Real` with the feature `std` or `libm`. Anything else that is a ring can be run through the same compiled
//! kernels: exact rationals, polynomials, intervals, dual numbers.

use core::ops::{Add, Div, Mul, Neg, Sub};

pub use crate::four::Four;
#[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
use crate::instructions::sse2;

/// A commutative ring of `Copy` values.
pub trait Scalar:
    Copy + PartialEq + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Neg<Output = Self>
{
    /// Four of them side by side; [`Array4`] does for any type.
    type Four: Four<Self>;
    /// 0
    const ZERO: Self;
    /// 1
    const ONE: Self;
    /// The number `numerator / denominator`, as exact as the type can hold it; `denominator` is not 0.
    fn from_ratio(numerator: i32, denominator: i32) -> Self;
    /// `self * factor + term`, as quick as can be: `f32` and `f64` round twice, [`Fused`] once. Of an `f32` that is no type parameter
    /// `x.mul_add` is the standard library's, which always rounds once.
    #[inline]
    fn mul_add(self, factor: Self, term: Self) -> Self {
        self * factor + term
    }
    /// `self * factor + term` rounded once, where the type can do that: `f32` and `f64` with the feature `std`. A call of a function
    /// of the C library, and slow, in code that is not compiled for machines with an instruction for it.
    #[inline]
    fn fused_mul_add(self, factor: Self, term: Self) -> Self {
        self.mul_add(factor, term)
    }
}

/// Four numbers in an array, whatever they are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Array4<S>(pub [S; 4]);

impl<S: Scalar> Four<S> for Array4<S> {
    const IS_FAST: bool = false;
    #[inline]
    fn new(lanes: [S; 4]) -> Self {
        Self(lanes)
    }
    #[inline]
    fn to_array(self) -> [S; 4] {
        self.0
    }
    #[inline]
    fn shuffle<const MASK: i32>(self) -> Self {
        Self([0, 2, 4, 6].map(|place| self.0[(MASK >> place & 3) as usize]))
    }
    #[inline]
    fn negate<const MASK: i32>(self) -> Self {
        let [a, b, c, d] = self.0;
        let lane = |place: i32, x: S| if MASK >> place & 1 == 1 { -x } else { x };
        Self([lane(0, a), lane(1, b), lane(2, c), lane(3, d)])
    }
}

macro_rules! implement_lanewise {
    ($($name:ident $method:ident $symbol:tt),*) => {
        $(impl<S: Scalar> $name for Array4<S> {
            type Output = Self;
            #[inline]
            fn $method(self, other: Self) -> Self {
                let ([a, b, c, d], [e, f, g, h]) = (self.0, other.0);
                Self([a $symbol e, b $symbol f, c $symbol g, d $symbol h])
            }
        })*
    };
}

implement_lanewise!(Add add +, Sub sub -, Mul mul *);

/// Real numbers, in floating point or better.
pub trait Real: Scalar + PartialOrd + Div<Output = Self> {
    /// The distance from 1 to the next larger number.
    const EPSILON: Self;
    /// The ratio of a circle's circumference to its diameter.
    const PI: Self;
    /// The nearest number.
    fn from_f64(value: f64) -> Self;
    /// The nearest `f64`.
    fn to_f64(self) -> f64;
    /// The square root; NaN for negative numbers.
    fn sqrt(self) -> Self;
    /// Sine and cosine of an angle in radians.
    fn sin_cos(self) -> (Self, Self);
    /// The angle of the point (x, self) in radians, in [-pi, pi].
    fn atan2(self, x: Self) -> Self;
    /// The absolute value.
    fn abs(self) -> Self;
    /// Whether the number is neither infinite nor NaN.
    fn is_finite(self) -> bool;
    /// The greatest power of two that is not above the magnitude of a finite number; for 0 and subnormal numbers the
    /// least normal one. Dividing by it is exact and leads to a number near 1 or, from a subnormal one, to a normal one.
    fn power_of_two(self) -> Self;

    /// `self / denominator`, and `limit` where the denominator is 0 and this number finite: a quotient with a removable
    /// singularity. NaN stays NaN.
    #[inline]
    fn quotient(self, denominator: Self, limit: Self) -> Self {
        if denominator == Self::ZERO && self.is_finite() { limit } else { self / denominator }
    }

    /// The square root of the sum of the squares, though these may leave the range of the numbers.
    ///
    /// A sum of squares above about `MIN / EPSILON^2` is as good as exact arithmetic makes it: what underflowed in it is
    /// too small to matter. Multiplying by `EPSILON^2` tells. Otherwise the components are scaled by a power of two, which is
    /// exact. NaN where a component is NaN; infinite where one is infinite and none NaN.
    #[inline]
    fn norm<const N: usize>(components: [Self; N]) -> Self {
        let square_sum = |components: [Self; N]| components.into_iter().fold(Self::ZERO, |sum, c| sum + c * c);
        let plain = square_sum(components);
        if plain.is_finite() && plain * (Self::EPSILON * Self::EPSILON) > Self::ZERO {
            return plain.sqrt();
        }
        let larger = |a: Self, b: Self| if b > a { b } else { a };
        let largest = components.into_iter().fold(Self::ZERO, |largest, component| larger(largest, component.abs()));
        if !largest.is_finite() {
            return plain.sqrt();
        }
        let scale = largest.power_of_two();
        let inverse = Self::ONE / scale;
        square_sum(components.map(|component| component * inverse)).sqrt() * scale
    }
}

/// How fine a type is, for what differs between the formats of floating-point numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Precision {
    /// As `f32`, or coarser.
    Single,
    /// As `f64`, or between the two.
    Double,
    /// Finer than `f64`.
    Finer,
}

/// The precision of a type.
#[inline]
pub(crate) fn precision<T: Real>() -> Precision {
    let epsilon = T::EPSILON.to_f64();
    if epsilon >= f64::from(f32::EPSILON) {
        Precision::Single
    } else if epsilon >= f64::EPSILON {
        Precision::Double
    } else {
        Precision::Finer
    }
}

macro_rules! implement_scalar {
    ($float:ident, $four:ty) => {
        impl Scalar for $float {
            type Four = $four;
            const ZERO: Self = 0.0;
            const ONE: Self = 1.0;
            #[inline]
            fn from_ratio(numerator: i32, denominator: i32) -> Self {
                (f64::from(numerator) / f64::from(denominator)) as Self
            }
            #[cfg(feature = "std")]
            #[inline(always)]
            fn fused_mul_add(self, factor: Self, term: Self) -> Self {
                $float::mul_add(self, factor, term)
            }
        }
    };
}

#[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
implement_scalar!(f32, sse2::F32x4);
#[cfg(not(all(target_arch = "x86_64", target_feature = "sse2")))]
implement_scalar!(f32, Array4<f32>);
// Two registers for one value make no packed kernel faster.
implement_scalar!(f64, Array4<f64>);

#[cfg(feature = "std")]
macro_rules! implement_real {
    ($float:ident, $sqrt:ident, $sincos:ident, $atan2:ident) => {
        impl_real_with!($float, |x: $float| x.sqrt(), |x: $float| x.sin_cos(), |y: $float, x: $float| y.atan2(x));
    };
}

#[cfg(all(feature = "libm", not(feature = "std")))]
macro_rules! implement_real {
    ($float:ident, $sqrt:ident, $sincos:ident, $atan2:ident) => {
        impl_real_with!($float, libm::$sqrt, libm::$sincos, libm::$atan2);
    };
}

#[cfg(any(feature = "std", feature = "libm"))]
macro_rules! impl_real_with {
    ($float:ident, $sqrt:expr, $sin_cos:expr, $atan2:expr) => {
        impl Real for $float {
            const EPSILON: Self = $float::EPSILON;
            const PI: Self = core::$float::consts::PI;
            #[inline]
            fn from_f64(value: f64) -> Self {
                value as Self
            }
            #[inline]
            fn to_f64(self) -> f64 {
                f64::from(self)
            }
            #[inline]
            fn sqrt(self) -> Self {
                $sqrt(self)
            }
            #[inline]
            fn sin_cos(self) -> (Self, Self) {
                $sin_cos(self)
            }
            #[inline]
            fn atan2(self, x: Self) -> Self {
                $atan2(self, x)
            }
            #[inline]
            fn abs(self) -> Self {
                $float::abs(self)
            }
            #[inline]
            fn is_finite(self) -> bool {
                $float::is_finite(self)
            }
            #[inline]
            fn power_of_two(self) -> Self {
                let exponent = $float::from_bits(self.to_bits() & $float::INFINITY.to_bits());
                exponent.max($float::MIN_POSITIVE)
            }
        }
    };
}

#[cfg(any(feature = "std", feature = "libm"))]
mod implementations {
    use super::Real;
    implement_real!(f32, sqrtf, sincosf, atan2f);
    implement_real!(f64, sqrt, sincos, atan2);
}

mod fused;

pub use fused::Fused;

#[cfg(test)]
mod tests;
