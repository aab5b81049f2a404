//! Elements of the even subalgebra that need not be motors.

use crate::{EvenMultivector, Motor, Real, Scalar, kernels, magnitude};

impl<T: Scalar> EvenMultivector<T> {
    /// ~m: the bivector part changes its sign.
    #[inline]
    pub fn reverse(self) -> Self {
        kernels::even_reverse(self)
    }

    /// The right complement: X ^ X.dual() is e0123 for every basis blade X.
    #[inline]
    pub fn dual(self) -> Self {
        kernels::even_dual(self)
    }

    /// The inverse of [`Self::dual`].
    #[inline]
    pub fn undual(self) -> Self {
        kernels::even_undual(self)
    }
}

impl<T: Real> EvenMultivector<T> {
    /// The norm of the Euclidean part (s, e23, e31, e12).
    #[inline]
    pub fn norm(self) -> T {
        let squared = |[s, e23, e31, e12]: [T; 4]| kernels::even_norm_squared(Self { s, e23, e31, e12, ..Self::ZERO });
        magnitude::norm([self.s, self.e23, self.e31, self.e12], squared)
    }

    /// The norm of the ideal part (e01, e02, e03, e0123): for a motor half the distance by which it moves the origin.
    #[inline]
    pub fn ideal_norm(self) -> T {
        let squared = |[e01, e02, e03, e0123]: [T; 4]| {
            kernels::even_ideal_norm_squared(Self { e01, e02, e03, e0123, ..Self::ZERO })
        };
        magnitude::norm([self.e01, self.e02, self.e03, self.e0123], squared)
    }

    /// Whether this is a motor: both relations of [`Motor`] hold to an absolute `tolerance`. False for NaN.
    #[inline]
    pub fn is_unit(self, tolerance: T) -> bool {
        Motor::from(self.to_array()).is_unit(tolerance)
    }
}
