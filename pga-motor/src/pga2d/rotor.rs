//! Rotations about the origin.

use super::{Direction, Line, Point, Rotor, kernels};
use crate::{Real, Scalar};
use core::ops::Shr;

impl<T: Real> Rotor<T> {
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
}
