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
        let squared = |[e1, e2]: [T; 2]| kernels::odd_norm_squared(Self { e1, e2, ..Self::ZERO });
        magnitude::norm([self.e1, self.e2], squared)
    }

    /// The norm of the ideal part (e0, e012).
    #[inline]
    pub fn ideal_norm(self) -> T {
        let squared = |[e0, e012]: [T; 2]| kernels::odd_ideal_norm_squared(Self { e0, e012, ..Self::ZERO });
        magnitude::norm([self.e0, self.e012], squared)
    }

    /// The element whose product with this one, on either side, is 1: ~m over the square of the norm.
    ///
    /// `None` where the norm, that of the Euclidean part, is 0, or something is not finite.
    pub fn inverse(self) -> Option<Self> {
        let largest = magnitude::largest([self.e1, self.e2])?;
        let scaled = self / largest;
        let inverse = scaled.reverse() / kernels::odd_norm_squared(scaled) / largest;
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
