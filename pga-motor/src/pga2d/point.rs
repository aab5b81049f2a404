//! Points and directions.

use super::{Bivector, Direction, Line, Point, UnitLine, kernels};
use crate::{Real, Scalar, magnitude};

impl<T: Scalar> Point<T> {
    /// (0, 0)
    pub const ORIGIN: Self = Self::new(T::ZERO, T::ZERO);

    /// ~p: the point with weight -1, as all bivectors change their sign.
    #[inline]
    pub fn reverse(self) -> Bivector<T> {
        kernels::point_reverse(self)
    }

    /// The right complement, a line: X ^ X.dual() is e012 for every basis blade X.
    #[inline]
    pub fn dual(self) -> Line<T> {
        kernels::point_dual(self)
    }

    /// The inverse of [`Line::dual`].
    #[inline]
    pub fn undual(self) -> Line<T> {
        kernels::point_undual(self)
    }

    /// The foot of the perpendicular from the point on a line.
    #[inline]
    pub fn project_onto_line(self, line: UnitLine<T>) -> Self {
        kernels::point_project_onto_line(self, line)
    }
}

/// Distances, in the caller's unit of length.
impl<T: Real> Point<T> {
    /// The distance between two points.
    #[inline]
    pub fn distance_to_point(self, other: Self) -> T {
        (other - self).norm()
    }

    /// The distance from a line: a x + b y + c for the unit line a e1 + b e2 + c e0, so positive on the side to which
    /// the normal points, to the left of the way the line runs.
    #[inline]
    pub fn signed_distance_to_line(self, line: UnitLine<T>) -> T {
        line.signed_distance_to_point(self)
    }

    /// The distance from a line; never negative.
    #[inline]
    pub fn distance_to_line(self, line: UnitLine<T>) -> T {
        line.distance_to_point(self)
    }
}

impl<T: Scalar> Direction<T> {
    /// (1, 0)
    pub const X: Self = Self::new(T::ONE, T::ZERO);
    /// (0, 1)
    pub const Y: Self = Self::new(T::ZERO, T::ONE);

    /// ~d: the opposite direction, as all bivectors change their sign.
    #[inline]
    pub fn reverse(self) -> Self {
        kernels::direction_reverse(self)
    }

    /// The right complement, a line: X ^ X.dual() is e012 for every basis blade X.
    #[inline]
    pub fn dual(self) -> Line<T> {
        kernels::direction_dual(self)
    }

    /// The inverse of [`Line::dual`].
    #[inline]
    pub fn undual(self) -> Line<T> {
        kernels::direction_undual(self)
    }

    /// The cosine of the angle between two directions, times both norms.
    #[inline]
    pub fn dot(self, other: Self) -> T {
        kernels::direction_dot_direction(self, other)
    }

    /// The sine of the angle from this direction to the other, counter-clockwise, times both norms: X cross Y is 1.
    #[inline]
    pub fn cross(self, other: Self) -> T {
        kernels::direction_cross_direction(self, other)
    }
}

impl<T: Real> Direction<T> {
    /// Whether the square of the length is 1 to an absolute `tolerance`. False for NaN.
    #[inline]
    pub fn is_unit(self, tolerance: T) -> bool {
        (kernels::direction_norm_squared(self) - T::ONE).abs() <= tolerance
    }

    /// The length; it overflows or underflows only where the length itself does.
    #[inline]
    pub fn norm(self) -> T {
        T::norm(self.to_array())
    }

    /// The same direction with length 1; `None` for zero and for coefficients that are not finite.
    #[inline]
    pub fn normalize(self) -> Option<Self> {
        let scaled = self * magnitude::scale(self.to_array())?;
        Some(scaled / kernels::direction_norm_squared(scaled).sqrt())
    }

    /// The angle from this direction to the other in radians, in [-pi, pi], counter-clockwise.
    ///
    /// `None` where one of them is zero or not finite.
    ///
    /// ```
    /// use pga_motor::pga2d::f64::Direction;
    ///
    /// assert_eq!(Direction::X.angle_to(-Direction::Y), Some(-std::f64::consts::FRAC_PI_2));
    /// ```
    pub fn angle_to(self, other: Self) -> Option<T> {
        let (a, b) = (self.normalize()?, other.normalize()?);
        Some(a.cross(b).atan2(a.dot(b)))
    }
}
