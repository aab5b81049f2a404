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
        let scale = magnitude::scale([self.s, self.e23, self.e31, self.e12])?;
        let scaled = self * scale;
        let squared = kernels::even_norm_squared(scaled);
        let inverse = kernels::even_adjugate(scaled) / (squared * squared) * scale;
        inverse.is_finite().then_some(inverse)
    }

    /// The norm of the Euclidean part (s, e23, e31, e12).
    #[inline]
    pub fn norm(self) -> T {
        T::norm([self.s, self.e23, self.e31, self.e12])
    }

    /// The norm of the ideal part (e01, e02, e03, e0123): for a motor half the distance by which it moves the origin.
    #[inline]
    pub fn ideal_norm(self) -> T {
        T::norm([self.e01, self.e02, self.e03, self.e0123])
    }

    /// The motor of this direction: the element over the root of its norm m ~m. That norm is a Study number, a scalar and a
    /// pseudoscalar, so the result is on the Study quadric also where this element is not.
    ///
    /// Scaling by a power of two changes nothing, not a bit, as long as nothing underflows or overflows.
    ///
    /// `None` where the Euclidean part is 0, something is not finite, or the ideal part is so much larger than the Euclidean
    /// one that the result is not finite.
    ///
    /// ```
    /// use pga_motor::f64::{EvenMultivector, Motor};
    ///
    /// let even = EvenMultivector::new(2.0, 0.0, 0.0, 0.0, 6.0, 0.0, 0.0, 8.0);
    /// assert_eq!(even.normalize(), Some(Motor::new(1.0, 0.0, 0.0, 0.0, 3.0, 0.0, 0.0, 0.0)));
    /// assert_eq!(EvenMultivector::new(0.0, 0.0, 0.0, 0.0, 6.0, 0.0, 0.0, 8.0).normalize(), None);
    /// ```
    pub fn normalize(self) -> Option<Motor<T>> {
        let scale = magnitude::scale([self.s, self.e23, self.e31, self.e12])?;
        let motor = (self * scale).over_norm();
        motor.is_finite().then_some(motor)
    }

    /// The motor of this direction, where the caller knows that the square of the norm is in the range of the numbers and
    /// not 0.
    #[inline]
    pub(crate) fn over_norm(self) -> Motor<T> {
        kernels::even_normalize(self)
    }

    /// Whether this is a motor: both relations of [`Motor`] hold to an absolute `tolerance`. False for NaN.
    #[inline]
    pub fn is_unit(self, tolerance: T) -> bool {
        Motor::from(self.to_array()).satisfies_relations(tolerance)
    }
}
