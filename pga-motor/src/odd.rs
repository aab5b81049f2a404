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
        let squared = |[e1, e2, e3, e123]: [T; 4]| kernels::odd_norm_squared(Self { e1, e2, e3, e123, ..Self::ZERO });
        magnitude::norm([self.e1, self.e2, self.e3, self.e123], squared)
    }

    /// The norm of the ideal part (e0, e032, e013, e021).
    #[inline]
    pub fn ideal_norm(self) -> T {
        let squared = |[e0, e032, e013, e021]: [T; 4]| {
            kernels::odd_ideal_norm_squared(Self { e0, e032, e013, e021, ..Self::ZERO })
        };
        magnitude::norm([self.e0, self.e032, self.e013, self.e021], squared)
    }

    /// The element whose product with this one, on either side, is 1: ~m over m ~m.
    ///
    /// `None` where the norm, that of the Euclidean part, is 0, or something is not finite.
    pub fn inverse(self) -> Option<Self> {
        let largest = magnitude::largest([self.e1, self.e2, self.e3, self.e123])?;
        let scaled = self / largest;
        let squared = kernels::odd_norm_squared(scaled);
        let inverse = kernels::odd_adjugate(scaled) / (squared * squared) / largest;
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
