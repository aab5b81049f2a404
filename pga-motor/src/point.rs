//! Points, directions, and points of any weight.

use crate::{Direction, Plane, Point, ProjectivePoint, Real, Scalar, UnitLine, UnitPlane, kernels, magnitude};

impl<T: Scalar> Point<T> {
    /// (0, 0, 0)
    pub const ORIGIN: Self = Self::new(T::ZERO, T::ZERO, T::ZERO);

    /// ~p: the point with weight -1, as all trivectors change their sign.
    #[inline]
    pub fn reverse(self) -> ProjectivePoint<T> {
        kernels::point_reverse(self)
    }

    /// The right complement, a plane: X ^ X.dual() is e0123 for every basis blade X.
    #[inline]
    pub fn dual(self) -> Plane<T> {
        kernels::point_dual(self)
    }

    /// The inverse of [`Plane::dual`].
    #[inline]
    pub fn undual(self) -> Plane<T> {
        kernels::point_undual(self)
    }

    /// The foot of the perpendicular from the point on a plane.
    #[inline]
    pub fn project_onto_plane(self, plane: UnitPlane<T>) -> Self {
        kernels::point_project_onto_plane(self, plane)
    }

    /// The foot of the perpendicular from the point on a line.
    #[inline]
    pub fn project_onto_line(self, line: UnitLine<T>) -> Self {
        kernels::point_project_onto_line(self, line)
    }
}

/// Distances, in the caller's unit of length.
///
/// ```
/// use pga_motor::f64::{Direction, Point, UnitLine, UnitPlane};
///
/// let point = Point::new(3.0, 4.0, 5.0);
/// let ground = UnitPlane::from_point_and_normal(Point::new(0.0, 0.0, 1.0), Direction::Z).unwrap();
/// let upright = UnitLine::from_point_and_direction(Point::ORIGIN, Direction::Z).unwrap();
/// assert_eq!(point.signed_distance_to_plane(ground), 4.0);
/// assert_eq!(point.distance_to_line(upright), 5.0);
/// ```
impl<T: Real> Point<T> {
    /// The distance between two points.
    #[inline]
    pub fn distance_to_point(self, other: Self) -> T {
        (other - self).norm()
    }

    /// The distance from a plane: a x + b y + c z + d for the unit plane a e1 + b e2 + c e3 + d e0, so positive on the
    /// side to which the normal points.
    #[inline]
    pub fn signed_distance_to_plane(self, plane: UnitPlane<T>) -> T {
        plane.signed_distance_to_point(self)
    }

    /// The distance from a plane; never negative.
    #[inline]
    pub fn distance_to_plane(self, plane: UnitPlane<T>) -> T {
        plane.distance_to_point(self)
    }

    /// The distance from a line; never negative.
    #[inline]
    pub fn distance_to_line(self, line: UnitLine<T>) -> T {
        line.distance_to_point(self)
    }
}

impl<T: Scalar> Direction<T> {
    /// (1, 0, 0)
    pub const X: Self = Self::new(T::ONE, T::ZERO, T::ZERO);
    /// (0, 1, 0)
    pub const Y: Self = Self::new(T::ZERO, T::ONE, T::ZERO);
    /// (0, 0, 1)
    pub const Z: Self = Self::new(T::ZERO, T::ZERO, T::ONE);

    /// ~d: the opposite direction, as all trivectors change their sign.
    #[inline]
    pub fn reverse(self) -> Self {
        kernels::direction_reverse(self)
    }

    /// The right complement, a plane: X ^ X.dual() is e0123 for every basis blade X.
    #[inline]
    pub fn dual(self) -> Plane<T> {
        kernels::direction_dual(self)
    }

    /// The inverse of [`Plane::dual`].
    #[inline]
    pub fn undual(self) -> Plane<T> {
        kernels::direction_undual(self)
    }

    /// The cosine of the angle between two directions, times both norms.
    #[inline]
    pub fn dot(self, other: Self) -> T {
        kernels::direction_dot_direction(self, other)
    }

    /// The direction perpendicular to both, right-handed: X cross Y is Z. Its norm is the sine of the angle, times both
    /// norms.
    #[inline]
    pub fn cross(self, other: Self) -> Self {
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

    /// The angle between two directions in radians, in [0, pi], accurate for small angles and near pi.
    ///
    /// `None` where one of them is zero or not finite.
    ///
    /// ```
    /// use pga_motor::f64::Direction;
    ///
    /// let angle = Direction::X.angle_to(Direction::new(1.0, 1e-12, 0.0)).unwrap();
    /// assert!((angle - 1e-12).abs() < 1e-27);
    /// assert_eq!(Direction::X.angle_to(Direction::ZERO), None);
    /// ```
    pub fn angle_to(self, other: Self) -> Option<T> {
        let (a, b) = (self.normalize()?, other.normalize()?);
        Some(a.cross(b).norm().atan2(a.dot(b)))
    }
}

impl<T: Scalar> ProjectivePoint<T> {
    /// The same point with its weight reversed in sign, as all trivectors.
    #[inline]
    pub fn reverse(self) -> Self {
        kernels::projective_point_reverse(self)
    }

    /// The right complement, a plane: X ^ X.dual() is e0123 for every basis blade X.
    #[inline]
    pub fn dual(self) -> Plane<T> {
        kernels::projective_point_dual(self)
    }

    /// The inverse of [`Plane::dual`].
    #[inline]
    pub fn undual(self) -> Plane<T> {
        kernels::projective_point_undual(self)
    }
}

impl<T: Real> ProjectivePoint<T> {
    /// The magnitude of the weight; 0 for directions.
    #[inline]
    pub fn norm(self) -> T {
        T::norm([self.e123])
    }

    /// The norm of the ideal part (e032, e013, e021): for a point the weight times its distance from the origin.
    #[inline]
    pub fn ideal_norm(self) -> T {
        T::norm([self.e032, self.e013, self.e021])
    }

    /// The point at (e032, e013, e021) / e123; `None` at infinity: for weight 0 and where the quotients are not finite.
    ///
    /// ```
    /// use pga_motor::f64::{Line, Plane, Point};
    ///
    /// let meet = Plane::new(1.0, 0.0, 0.0, -2.0) ^ Plane::new(0.0, 1.0, 0.0, -3.0) ^ Plane::new(0.0, 0.0, 2.0, -8.0);
    /// assert_eq!(meet.to_point(), Some(Point::new(2.0, 3.0, 4.0)));
    ///
    /// let parallel = Plane::new(0.0, 0.0, 1.0, -1.0) ^ (Point::ORIGIN & Point::new(1.0, 0.0, 0.0));
    /// assert_eq!(parallel.to_point(), None);
    /// ```
    pub fn to_point(self) -> Option<Point<T>> {
        let point = Point::new(self.e032 / self.e123, self.e013 / self.e123, self.e021 / self.e123);
        point.is_finite().then_some(point)
    }
}
