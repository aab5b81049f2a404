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
    /// The element whose product with this one, on either side, is 1: ~m over m ~m.
    ///
    /// `None` where the norm, that of the Euclidean part, is 0, or something is not finite.
    ///
    /// ```
    /// use pga_motor::f64::EvenMultivector;
    ///
    /// let even = EvenMultivector::new(1.0, 1.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0);
    /// let inverse = EvenMultivector::new(0.5, -0.5, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0);
    /// assert_eq!(even.inverse(), Some(inverse));
    /// assert_eq!(even * inverse, EvenMultivector::IDENTITY);
    /// assert_eq!(EvenMultivector::new(0.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0).inverse(), None);
    /// ```
    pub fn inverse(self) -> Option<Self> {
        let largest = magnitude::largest([self.s, self.e23, self.e31, self.e12])?;
        let scaled = self / largest;
        let squared = kernels::even_norm_squared(scaled);
        let inverse = kernels::even_adjugate(scaled) / (squared * squared) / largest;
        inverse.is_finite().then_some(inverse)
    }

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
        Motor::from(self.to_array()).satisfies_relations(tolerance)
    }
}
