//! Planes.

use crate::{Direction, Line, Plane, Point, ProjectivePoint, Real, Scalar, UnitLine, UnitPlane, kernels, magnitude};

impl<T: Scalar> Plane<T> {
    /// ~p: the plane itself, as with every vector.
    #[inline]
    pub fn reverse(self) -> Self {
        kernels::plane_reverse(self)
    }

    /// The normal (e1, e2, e3), as long as the plane's norm.
    #[inline]
    pub fn normal(self) -> Direction<T> {
        kernels::plane_normal(self)
    }

    /// The right complement, a point of weight e0: X ^ X.dual() is e0123 for every basis blade X.
    #[inline]
    pub fn dual(self) -> ProjectivePoint<T> {
        kernels::plane_dual(self)
    }

    /// The inverse of [`ProjectivePoint::dual`].
    #[inline]
    pub fn undual(self) -> ProjectivePoint<T> {
        kernels::plane_undual(self)
    }

    /// The parallel plane through a point.
    #[inline]
    pub fn project_onto_point(self, point: Point<T>) -> Self {
        kernels::plane_project_onto_point(self, point)
    }

    /// The plane through a line that is closest to parallel to this one; 0 where the line is perpendicular to it.
    #[inline]
    pub fn project_onto_line(self, line: UnitLine<T>) -> Self {
        kernels::plane_project_onto_line(self, line)
    }
}

impl<T: Real> Plane<T> {
    /// The plane whose product with this one is 1: p over the square of its norm.
    ///
    /// `None` where the norm is 0 (the plane at infinity), or something is not finite.
    ///
    /// ```
    /// use pga_motor::f64::Plane;
    ///
    /// assert_eq!(Plane::new(0.0, 2.0, 0.0, 3.0).inverse(), Some(Plane::new(0.0, 0.5, 0.0, 0.75)));
    /// assert_eq!(Plane::new(0.0, 0.0, 0.0, 3.0).inverse(), None);
    /// ```
    pub fn inverse(self) -> Option<Self> {
        let scale = magnitude::scale(self.normal().to_array())?;
        let scaled = self * scale;
        let inverse = scaled / kernels::plane_norm_squared(scaled) * scale;
        inverse.is_finite().then_some(inverse)
    }

    /// Whether this is a unit plane: the relation of [`UnitPlane`] holds to an absolute `tolerance`. False for NaN.
    #[inline]
    pub fn is_unit(self, tolerance: T) -> bool {
        UnitPlane::from(self.to_array()).satisfies_relations(tolerance)
    }

    /// The length of the normal (e1, e2, e3).
    #[inline]
    pub fn norm(self) -> T {
        T::norm([self.e1, self.e2, self.e3])
    }

    /// The magnitude of e0: the norm times the distance from the origin.
    #[inline]
    pub fn ideal_norm(self) -> T {
        self.e0.abs()
    }

    /// The same plane with a normal of length 1; `None` where the normal is 0 (the plane at infinity) or something is
    /// not finite.
    ///
    /// ```
    /// use pga_motor::f64::{Plane, UnitPlane};
    ///
    /// assert_eq!(Plane::new(0.0, 3.0, 4.0, 10.0).normalize(), Some(UnitPlane::new(0.0, 0.6, 0.8, 2.0)));
    /// assert_eq!(Plane::new(0.0, 0.0, 0.0, 10.0).normalize(), None);
    /// ```
    pub fn normalize(self) -> Option<UnitPlane<T>> {
        let scaled = self * magnitude::scale(self.normal().to_array())?;
        let unit = scaled / kernels::plane_norm_squared(scaled).sqrt();
        unit.is_finite().then(|| unit.to_array().into())
    }
}

/// Mirrors and projections.
impl<T: Scalar> UnitPlane<T> {
    /// The normal (e1, e2, e3), of length 1.
    #[inline]
    pub fn normal(self) -> Direction<T> {
        kernels::plane_normal(self.into())
    }

    /// ~p: the plane itself, as with every vector.
    #[inline]
    pub fn reverse(self) -> Self {
        kernels::unit_plane_reverse(self)
    }

    /// The plane whose product with this one is 1: the plane itself, as a second reflection undoes the first.
    #[inline]
    pub fn inverse(self) -> Self {
        self.reverse()
    }

    /// The right complement, a point of weight e0: X ^ X.dual() is e0123 for every basis blade X.
    #[inline]
    pub fn dual(self) -> ProjectivePoint<T> {
        Plane::from(self).dual()
    }

    /// The inverse of [`ProjectivePoint::dual`].
    #[inline]
    pub fn undual(self) -> ProjectivePoint<T> {
        Plane::from(self).undual()
    }

    /// The parallel plane through a point.
    #[inline]
    pub fn project_onto_point(self, point: Point<T>) -> Self {
        kernels::unit_plane_project_onto_point(self, point)
    }

    /// The plane through a line that is closest to parallel to this one; of length the cosine of the angle between the
    /// two, so 0 where the line is perpendicular to this plane.
    #[inline]
    pub fn project_onto_line(self, line: UnitLine<T>) -> Plane<T> {
        kernels::plane_project_onto_line(self.into(), line)
    }

    /// The mirror image of a point.
    #[inline]
    pub fn reflect_point(self, point: Point<T>) -> Point<T> {
        kernels::plane_reflect_point(self, point)
    }

    /// The mirror image of a direction.
    #[inline]
    pub fn reflect_direction(self, direction: Direction<T>) -> Direction<T> {
        kernels::plane_reflect_direction(self, direction)
    }

    /// The mirror image of a plane, its normal mirrored too: this plane itself turns over.
    #[inline]
    pub fn reflect_plane(self, plane: Plane<T>) -> Plane<T> {
        kernels::plane_reflect_plane(self, plane)
    }

    /// The mirror image of a unit plane, its normal mirrored too: this plane itself turns over.
    #[inline]
    pub fn reflect_unit_plane(self, plane: UnitPlane<T>) -> UnitPlane<T> {
        kernels::plane_reflect_unit_plane(self, plane)
    }

    /// The mirror image of a line or a screw as the generator of a motion: its exponential is the mirror image of the
    /// motion. So an axis across the mirror keeps its direction, and one in it is reversed, as the turn about it is; a
    /// line as a way from point to point goes the opposite way.
    #[inline]
    pub fn reflect_line(self, line: Line<T>) -> Line<T> {
        kernels::plane_reflect_line(self, line)
    }

    /// The mirror image of a unit line as the axis of a turn; see [`Self::reflect_line`].
    #[inline]
    pub fn reflect_unit_line(self, line: UnitLine<T>) -> UnitLine<T> {
        kernels::plane_reflect_unit_line(self, line)
    }
}

/// Constructors, distances in the caller's unit of length, angles in radians.
impl<T: Real> UnitPlane<T> {
    /// Whether the promise of the type, a normal of length 1, holds to an absolute `tolerance`. False for NaN.
    #[inline]
    pub fn is_unit(self, tolerance: T) -> bool {
        self.satisfies_relations(tolerance)
    }

    /// The magnitude of e0: the distance from the origin.
    #[inline]
    pub fn ideal_norm(self) -> T {
        Plane::from(self).ideal_norm()
    }

    /// The plane through a point with a normal of any length other than 0; `None` where the normal is 0 or something is
    /// not finite.
    pub fn from_point_and_normal(point: Point<T>, normal: Direction<T>) -> Option<Self> {
        let normal = normal.normalize()?;
        let plane = Self::new(normal.x, normal.y, normal.z, T::ZERO).project_onto_point(point);
        plane.is_finite().then_some(plane)
    }

    /// The plane through three points, which run counter-clockwise seen from the side to which the normal points.
    ///
    /// `None` where they are collinear, so far as rounding lets that be seen: where the normal comes out as exactly 0;
    /// or where something is not finite.
    ///
    /// ```
    /// use pga_motor::f64::{Point, UnitPlane};
    ///
    /// let at = |x, y| Point::new(x, y, 2.0);
    /// let plane = UnitPlane::from_points(at(0.0, 0.0), at(4.0, 0.0), at(0.0, 4.0)).unwrap();
    /// assert_eq!(plane, UnitPlane::new(0.0, 0.0, 1.0, -2.0));
    /// assert_eq!(UnitPlane::from_points(at(0.0, 0.0), at(1.0, 1.0), at(2.0, 2.0)), None);
    /// ```
    pub fn from_points(a: Point<T>, b: Point<T>, c: Point<T>) -> Option<Self> {
        let (to_b, to_c) = ((b - a).normalize()?, (c - a).normalize()?);
        Self::from_point_and_normal(a, to_b.cross(to_c))
    }

    /// The distance of a point: a x + b y + c z + d for a e1 + b e2 + c e3 + d e0, so positive on the side to which the
    /// normal points.
    #[inline]
    pub fn signed_distance_to_point(self, point: Point<T>) -> T {
        kernels::plane_join_point(self.into(), point)
    }

    /// The distance of a point; never negative.
    #[inline]
    pub fn distance_to_point(self, point: Point<T>) -> T {
        self.signed_distance_to_point(point).abs()
    }

    /// The distance between the plane and a line: 0 where they meet; see [`UnitLine::distance_to_plane`].
    #[inline]
    pub fn distance_to_line(self, line: UnitLine<T>) -> T {
        line.distance_to_plane(self)
    }

    /// The distance between two planes: 0 where they meet, the distance of one from the other where they are parallel,
    /// whichever way their normals point. Never negative.
    ///
    /// Planes that are parallel to rounding (the sine of the angle between them is at most 8 epsilon) count as parallel.
    ///
    /// ```
    /// use pga_motor::f64::UnitPlane;
    ///
    /// let (floor, ceiling) = (UnitPlane::new(0.0, 0.0, 1.0, 0.0), UnitPlane::new(0.0, 0.0, -1.0, 2.5));
    /// assert_eq!(floor.distance_to_plane(ceiling), 2.5);
    /// assert_eq!(floor.distance_to_plane(UnitPlane::new(0.0, 0.6, 0.8, 7.0)), 0.0);
    /// ```
    pub fn distance_to_plane(self, other: Self) -> T {
        let meet = kernels::plane_meet_plane(self.into(), other.into());
        if meet.norm() > T::EPSILON * T::from_ratio(8, 1) { T::ZERO } else { meet.ideal_norm() }
    }

    /// The angle between the normals of two planes, in [0, pi].
    pub fn angle_to_plane(self, other: Self) -> T {
        let (a, b) = (self.into(), other.into());
        kernels::plane_meet_plane(a, b).norm().atan2(kernels::plane_inner_plane(a, b))
    }

    /// The angle by which a line rises from the plane, in [-pi/2, pi/2]; positive where it runs to the side to which
    /// the normal points.
    #[inline]
    pub fn angle_to_line(self, line: UnitLine<T>) -> T {
        line.angle_to_plane(self)
    }
}
