//! Elements of the odd part of the algebra, and multiples of the pseudoscalar.

use crate::{OddMultivector, Pseudoscalar, Real, Scalar, kernels, magnitude};

impl<T: Scalar> OddMultivector<T> {
    /// The trivector part changes its sign.
    #[inline]
    pub fn reverse(self) -> Self {
        kernels::odd_reverse(self)
    }

    /// The right complement: X ^ X.dual() is e0123 for every basis blade X.
    #[inline]
    pub fn dual(self) -> Self {
        kernels::odd_dual(self)
    }

    /// The inverse of [`Self::dual`].
    #[inline]
    pub fn undual(self) -> Self {
        kernels::odd_undual(self)
    }
}

impl<T: Real> OddMultivector<T> {
    /// The norm of the Euclidean part (e1, e2, e3, e123).
    #[inline]
    pub fn norm(self) -> T {
        T::norm([self.e1, self.e2, self.e3, self.e123])
    }

    /// The norm of the ideal part (e0, e032, e013, e021).
    #[inline]
    pub fn ideal_norm(self) -> T {
        T::norm([self.e0, self.e032, self.e013, self.e021])
    }

    /// The element whose product with this one, on either side, is 1: ~m over m ~m.
    ///
    /// `None` where the norm, that of the Euclidean part, is 0, or something is not finite.
    pub fn inverse(self) -> Option<Self> {
        let scale = magnitude::scale([self.e1, self.e2, self.e3, self.e123])?;
        let scaled = self * scale;
        let squared = kernels::odd_norm_squared(scaled);
        let inverse = kernels::odd_adjugate(scaled) / (squared * squared) * scale;
        inverse.is_finite().then_some(inverse)
    }
}

impl<T: Scalar> Pseudoscalar<T> {
    /// The right complement, a number: that of e0123 is 1.
    #[inline]
    pub fn dual(self) -> T {
        kernels::pseudoscalar_dual(self)
    }

    /// The inverse of the right complement, a number: that of e0123 is 1.
    #[inline]
    pub fn undual(self) -> T {
        kernels::pseudoscalar_undual(self)
    }
}
