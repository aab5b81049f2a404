//! Rotations about the origin.

use super::{Direction, EvenMultivector, Line, Motor, OddMultivector, Point, Rotor, UnitLine, kernels};
use crate::{LengthMismatch, Real, Scalar, slices};
use core::ops::Shr;

impl<T: Real> Rotor<T> {
    /// Whether the promise of the type, unit norm, holds to an absolute `tolerance`. False for NaN.
    #[inline]
    pub fn is_unit(self, tolerance: T) -> bool {
        self.satisfies_relations(tolerance)
    }

    /// The turn by an angle in radians, counter-clockwise: cos(angle/2) - sin(angle/2) e12. NaN for an angle that is
    /// not finite.
    #[inline]
    pub fn from_angle(angle: T) -> Self {
        let (sin, cos) = (angle * T::from_ratio(1, 2)).sin_cos();
        Self::new(cos, -sin)
    }

    /// The angle of the turn the short way, in [-pi, pi] radians, counter-clockwise; r and -r have the same.
    #[inline]
    pub fn angle(self) -> T {
        let short = if self.s < T::ZERO { -self } else { self };
        let half = (-short.e12).atan2(short.s);
        half + half
    }
}

impl<T: Scalar> Rotor<T> {
    /// ~r: the opposite rotation.
    #[inline]
    pub fn reverse(self) -> Self {
        kernels::rotor_reverse(self)
    }

    /// The opposite rotation. A rotor is of unit norm, so this is the reverse.
    #[inline]
    pub fn inverse(self) -> Self {
        self.reverse()
    }

    /// The right complement: X ^ X.dual() is e012 for every basis blade X.
    #[inline]
    pub fn dual(self) -> OddMultivector<T> {
        EvenMultivector::from(self).dual()
    }

    /// The inverse of [`OddMultivector::dual`].
    #[inline]
    pub fn undual(self) -> OddMultivector<T> {
        EvenMultivector::from(self).undual()
    }

    /// r x ~r for anything that a rotor can act on; the same as `r >> x`.
    #[inline]
    pub fn transform<X>(self, x: X) -> <Self as Shr<X>>::Output
    where
        Self: Shr<X>,
    {
        self >> x
    }

    /// Where the rotation carries a point.
    #[inline]
    pub fn transform_point(self, point: Point<T>) -> Point<T> {
        kernels::rotor_transform_point(self, point)
    }

    /// Where the rotation carries a direction.
    #[inline]
    pub fn transform_direction(self, direction: Direction<T>) -> Direction<T> {
        kernels::rotor_transform_direction(self, direction)
    }

    /// Where the rotation carries a line.
    #[inline]
    pub fn transform_line(self, line: Line<T>) -> Line<T> {
        kernels::rotor_transform_line(self, line)
    }

    /// Where the rotation carries a unit line.
    #[inline]
    pub fn transform_unit_line(self, line: UnitLine<T>) -> UnitLine<T> {
        kernels::rotor_transform_unit_line(self, line)
    }

    /// The motion m about the place to which the rotation carries it.
    #[inline]
    pub fn transform_motor(self, motor: Motor<T>) -> Motor<T> {
        kernels::rotor_transform_motor(self, motor)
    }

    /// Writes where the rotation carries each point into the place with the same index.
    ///
    /// # Errors
    /// Slices of different lengths; then nothing is written.
    pub fn transform_points(self, points: &[Point<T>], results: &mut [Point<T>]) -> Result<(), LengthMismatch> {
        slices::map(points, results, |point| self.transform_point(point))
    }

    /// Moves each point.
    pub fn transform_points_in_place(self, points: &mut [Point<T>]) {
        slices::map_in_place(points, |point| self.transform_point(point));
    }
}
