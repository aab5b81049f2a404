//! Elements of the odd part of the algebra, and multiples of the pseudoscalar.

use super::{EvenMultivector, OddMultivector, Pseudoscalar, kernels};
use crate::{Real, Scalar, magnitude};

impl<T: Scalar> OddMultivector<T> {
    /// ~m: the pseudoscalar part changes its sign.
    #[inline]
    pub fn reverse(self) -> Self {
        kernels::odd_reverse(self)
    }

    /// The right complement: X ^ X.dual() is e012 for every basis blade X.
    #[inline]
    pub fn dual(self) -> EvenMultivector<T> {
        kernels::odd_dual(self)
    }

    /// The inverse of [`EvenMultivector::dual`].
    #[inline]
    pub fn undual(self) -> EvenMultivector<T> {
        kernels::odd_undual(self)
    }
}

impl<T: Real> OddMultivector<T> {
    /// The norm of the Euclidean part (e1, e2).
    #[inline]
    pub fn norm(self) -> T {
        T::norm([self.e1, self.e2])
    }

    /// The norm of the ideal part (e0, e012).
    #[inline]
    pub fn ideal_norm(self) -> T {
        T::norm([self.e0, self.e012])
    }

    /// The element whose product with this one, on either side, is 1: ~m over the square of the norm.
    ///
    /// `None` where the norm, that of the Euclidean part, is 0, or something is not finite.
    pub fn inverse(self) -> Option<Self> {
        let scale = magnitude::scale([self.e1, self.e2])?;
        let scaled = self * scale;
        let inverse = scaled.reverse() / kernels::odd_norm_squared(scaled) * scale;
        inverse.is_finite().then_some(inverse)
    }
}

impl<T: Scalar> Pseudoscalar<T> {
    /// The right complement, a number: that of e012 is 1.
    #[inline]
    pub fn dual(self) -> T {
        kernels::pseudoscalar_dual(self)
    }

    /// The inverse of the right complement, a number: that of e012 is 1.
    #[inline]
    pub fn undual(self) -> T {
        kernels::pseudoscalar_undual(self)
    }
}
