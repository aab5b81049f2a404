//! Elements of the even subalgebra that need not be motors.

use super::{Bivector, EvenMultivector, Motor, OddMultivector, kernels};
use crate::{Real, Scalar, magnitude};

impl<T: Scalar> EvenMultivector<T> {
    /// ~m: the bivector part changes its sign.
    #[inline]
    pub fn reverse(self) -> Self {
        kernels::even_reverse(self)
    }

    /// The right complement: X ^ X.dual() is e012 for every basis blade X.
    #[inline]
    pub fn dual(self) -> OddMultivector<T> {
        kernels::even_dual(self)
    }

    /// The inverse of [`OddMultivector::dual`].
    #[inline]
    pub fn undual(self) -> OddMultivector<T> {
        kernels::even_undual(self)
    }

    /// The bivector part.
    #[inline]
    pub fn bivector(self) -> Bivector<T> {
        kernels::even_bivector(self)
    }
}

impl<T: Real> EvenMultivector<T> {
    /// The norm of the Euclidean part (s, e12).
    #[inline]
    pub fn norm(self) -> T {
        T::norm([self.s, self.e12])
    }

    /// The norm of the ideal part (e01, e20): for a motor half the distance by which it moves the origin.
    #[inline]
    pub fn ideal_norm(self) -> T {
        self.bivector().ideal_norm()
    }

    /// The element whose product with this one, on either side, is 1: ~m over the square of the norm.
    ///
    /// `None` where the norm, that of the Euclidean part, is 0, or something is not finite.
    pub fn inverse(self) -> Option<Self> {
        let scale = magnitude::scale([self.s, self.e12])?;
        let scaled = self * scale;
        let inverse = scaled.reverse() / kernels::even_norm_squared(scaled) * scale;
        inverse.is_finite().then_some(inverse)
    }

    /// Whether this is a motor: the relation of [`Motor`] holds to an absolute `tolerance`. False for NaN.
    #[inline]
    pub fn is_unit(self, tolerance: T) -> bool {
        Motor::from(self.to_array()).satisfies_relations(tolerance)
    }

    /// The motor that this is a multiple of. In the plane every even element with a Euclidean part is a multiple of
    /// one.
    ///
    /// Scaling by a power of two changes nothing, not a bit, as long as nothing underflows or overflows.
    ///
    /// `None` where the Euclidean part is 0, something is not finite, or the ideal part is so much larger than the Euclidean
    /// one that the result is not finite.
    ///
    /// ```
    /// use pga_motor::pga2d::f64::{EvenMultivector, Motor};
    ///
    /// let even = EvenMultivector::new(0.0, -2.0, 10.0, 6.0);
    /// assert_eq!(even.normalize(), Some(Motor::new(0.0, -1.0, 5.0, 3.0)));
    /// assert_eq!(EvenMultivector::new(0.0, 0.0, 10.0, 5.0).normalize(), None);
    /// ```
    pub fn normalize(self) -> Option<Motor<T>> {
        let motor = (self * magnitude::scale([self.s, self.e12])?).over_norm();
        motor.is_finite().then_some(motor)
    }

    /// The motor that this is a multiple of, where the caller knows that there is one and that the square of the norm is in
    /// the range of the numbers.
    #[inline]
    pub(super) fn over_norm(self) -> Motor<T> {
        kernels::even_normalize(self)
    }
}
