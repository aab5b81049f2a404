//! Numbers whose products are fused with sums.

use core::ops::{Add, Div, Mul, Neg, Sub};

use super::{Array4, Real, Scalar};

/// A number whose [`Scalar::mul_add`] rounds once, [`Scalar::fused_mul_add`] of what it is made of. For code that is compiled for
/// machines with an instruction for it, as batches are that run with AVX2 or AVX-512.
///
/// ```
/// use pga_motor::scalar::{Fused, Scalar};
///
/// let third = Fused(1.0_f64 / 3.0);
/// // What 1/3 * 3 is short of 1 is rounded away where the product is rounded by itself.
/// assert_eq!((1.0 / 3.0) * 3.0 - 1.0, 0.0);
/// # #[cfg(feature = "std")]
/// assert_eq!(third.mul_add(Fused(3.0), Fused(-1.0)), Fused(-f64::EPSILON / 4.0));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
#[repr(transparent)]
pub struct Fused<T>(pub T);

macro_rules! operators {
    ($($operator:ident $method:ident $bound:ident;)*) => { $(
        impl<T: $bound> $operator for Fused<T> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self($operator::$method(self.0, other.0))
            }
        }
    )* };
}

operators! {
    Add add Scalar;
    Sub sub Scalar;
    Mul mul Scalar;
    Div div Real;
}

impl<T: Scalar> Neg for Fused<T> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl<T: Scalar> Scalar for Fused<T> {
    type Four = Array4<Self>;
    const ZERO: Self = Self(T::ZERO);
    const ONE: Self = Self(T::ONE);
    #[inline(always)]
    fn from_ratio(numerator: i32, denominator: i32) -> Self {
        Self(T::from_ratio(numerator, denominator))
    }
    #[inline(always)]
    fn mul_add(self, factor: Self, term: Self) -> Self {
        Self(self.0.fused_mul_add(factor.0, term.0))
    }
}

impl<T: Real> Real for Fused<T> {
    const EPSILON: Self = Self(T::EPSILON);
    const PI: Self = Self(T::PI);
    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        Self(T::from_f64(value))
    }
    #[inline(always)]
    fn to_f64(self) -> f64 {
        self.0.to_f64()
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(self.0.sqrt())
    }
    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.0.sin_cos();
        (Self(sin), Self(cos))
    }
    #[inline(always)]
    fn atan2(self, x: Self) -> Self {
        Self(self.0.atan2(x.0))
    }
    #[inline(always)]
    fn abs(self) -> Self {
        Self(self.0.abs())
    }
    #[inline(always)]
    fn is_finite(self) -> bool {
        self.0.is_finite()
    }
    #[inline(always)]
    fn power_of_two(self) -> Self {
        Self(self.0.power_of_two())
    }
    #[inline(always)]
    fn quotient(self, denominator: Self, limit: Self) -> Self {
        Self(self.0.quotient(denominator.0, limit.0))
    }
    #[inline(always)]
    fn norm<const N: usize>(components: [Self; N]) -> Self {
        Self(T::norm(components.map(|component| component.0)))
    }
}
