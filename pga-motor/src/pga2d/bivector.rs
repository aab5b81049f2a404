//! Bivectors: points of any weight, and generators of motions.

use super::{Bivector, Line, Motor, Point, kernels};
use crate::scalar::{Precision, precision};
use crate::{LengthMismatch, Real, Scalar, slices};

impl<T: Scalar> Bivector<T> {
    /// ~b: the negative, as of all bivectors.
    #[inline]
    pub fn reverse(self) -> Self {
        kernels::bivector_reverse(self)
    }

    /// The right complement, a line: X ^ X.dual() is e012 for every basis blade X.
    #[inline]
    pub fn dual(self) -> Line<T> {
        kernels::bivector_dual(self)
    }

    /// The inverse of [`Line::dual`].
    #[inline]
    pub fn undual(self) -> Line<T> {
        kernels::bivector_undual(self)
    }
}

impl<T: Real> Bivector<T> {
    /// The magnitude of the weight e12; 0 for directions.
    #[inline]
    pub fn norm(self) -> T {
        self.e12.abs()
    }

    /// The norm of the ideal part (e01, e20): for a point the weight times its distance from the origin.
    #[inline]
    pub fn ideal_norm(self) -> T {
        self.dual().norm()
    }

    /// The bivector with a weight of 1 or -1; `None` where the weight is 0 or the result not finite.
    pub(super) fn over_norm(self) -> Option<Self> {
        let unit = self / self.norm();
        unit.is_finite().then_some(unit)
    }

    /// The point at (e20, e01) / e12; `None` at infinity: for weight 0 and where the quotients are not finite.
    ///
    /// ```
    /// use pga_motor::pga2d::f64::{Line, Point};
    ///
    /// let (upright, level) = (Line::new(1.0, 0.0, -2.0), Line::new(0.0, 2.0, -6.0));
    /// assert_eq!((upright ^ level).to_point(), Some(Point::new(2.0, 3.0)));
    /// assert_eq!((level ^ level).to_point(), None);
    /// ```
    pub fn to_point(self) -> Option<Point<T>> {
        let point = Point::new(self.e20 / self.e12, self.e01 / self.e12);
        point.is_finite().then_some(point)
    }

    /// The motion that the bivector generates: the sum of b^n / n!.
    ///
    /// The turn by angle t about the point p, counter-clockwise, is the exponential of -t/2 p; the translation by
    /// (x, y) that of -(x e01 - y e20)/2. [`Motor::about`] takes the angle itself. NaN in gives NaN out, and an
    /// infinite coefficient NaN or infinity.
    #[inline]
    pub fn exp(self) -> Motor<T> {
        kernels::bivector_exp(self)
    }

    /// Writes the motion that each bivector generates into the place with the same index: [`Self::exp`] of many.
    ///
    /// For turns by at most half a turn by polynomials that the compiler makes vector code of; so results may differ from
    /// those of [`Self::exp`] in the last digits. Where the angle is greater, or NaN, it is done one by one.
    ///
    /// # Errors
    /// Slices of different lengths; then nothing is written.
    pub fn exp_slice(bivectors: &[Self], motors: &mut [Motor<T>]) -> Result<(), LengthMismatch> {
        match precision::<T>() {
            Precision::Single => slices::map_quickly(
                bivectors,
                motors,
                kernels::bivector_exp_f32,
                kernels::bivector_exp_f32_holds,
                Self::exp,
            ),
            Precision::Double => slices::map_quickly(
                bivectors,
                motors,
                kernels::bivector_exp_f64,
                kernels::bivector_exp_f64_holds,
                Self::exp,
            ),
            Precision::Finer => slices::map(bivectors, motors, Self::exp),
        }
    }
}
