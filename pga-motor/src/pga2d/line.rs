//! Lines. The normal (e1, e2) is to the left of the way a line runs.

use super::{Bivector, Direction, Line, Point, UnitLine, kernels};
use crate::{Real, Scalar, magnitude};

impl<T: Scalar> Line<T> {
    /// ~l: the line itself, as with every vector.
    #[inline]
    pub fn reverse(self) -> Self {
        kernels::line_reverse(self)
    }

    /// The normal (e1, e2), as long as the line's norm.
    #[inline]
    pub fn normal(self) -> Direction<T> {
        kernels::line_normal(self)
    }

    /// Which way the line runs, as long as the line's norm; the normal is to its left.
    #[inline]
    pub fn direction(self) -> Direction<T> {
        kernels::line_direction(self)
    }

    /// The right complement, a point of weight e0: X ^ X.dual() is e012 for every basis blade X.
    #[inline]
    pub fn dual(self) -> Bivector<T> {
        kernels::line_dual(self)
    }

    /// The inverse of [`Bivector::dual`].
    #[inline]
    pub fn undual(self) -> Bivector<T> {
        kernels::line_undual(self)
    }

    /// The parallel line through a point.
    #[inline]
    pub fn project_onto_point(self, point: Point<T>) -> Self {
        kernels::line_project_onto_point(self, point)
    }
}

impl<T: Real> Line<T> {
    /// The line whose product with this one is 1: l over the square of its norm.
    ///
    /// `None` where the norm is 0 (the line at infinity), or something is not finite.
    pub fn inverse(self) -> Option<Self> {
        let scale = magnitude::scale(self.normal().to_array())?;
        let scaled = self * scale;
        let inverse = scaled / kernels::line_norm_squared(scaled) * scale;
        inverse.is_finite().then_some(inverse)
    }

    /// Whether this is a unit line: the relation of [`UnitLine`] holds to an absolute `tolerance`. False for NaN.
    #[inline]
    pub fn is_unit(self, tolerance: T) -> bool {
        UnitLine::from(self.to_array()).satisfies_relations(tolerance)
    }

    /// The length of the normal (e1, e2): of the join of two points their distance.
    #[inline]
    pub fn norm(self) -> T {
        T::norm([self.e1, self.e2])
    }

    /// The magnitude of e0: the norm times the distance from the origin.
    #[inline]
    pub fn ideal_norm(self) -> T {
        self.e0.abs()
    }

    /// The same line with a normal of length 1; `None` where the normal is 0 (the line at infinity) or something is not
    /// finite.
    pub fn normalize(self) -> Option<UnitLine<T>> {
        let scaled = self * magnitude::scale(self.normal().to_array())?;
        let unit = scaled / kernels::line_norm_squared(scaled).sqrt();
        unit.is_finite().then(|| unit.to_array().into())
    }
}

/// Mirrors.
impl<T: Scalar> UnitLine<T> {
    /// The normal (e1, e2), of length 1.
    #[inline]
    pub fn normal(self) -> Direction<T> {
        kernels::line_normal(self.into())
    }

    /// ~l: the line itself, as with every vector.
    #[inline]
    pub fn reverse(self) -> Self {
        kernels::unit_line_reverse(self)
    }

    /// The line whose product with this one is 1: the line itself, as a second reflection undoes the first.
    #[inline]
    pub fn inverse(self) -> Self {
        self.reverse()
    }

    /// The right complement, a point of weight e0: X ^ X.dual() is e012 for every basis blade X.
    #[inline]
    pub fn dual(self) -> Bivector<T> {
        Line::from(self).dual()
    }

    /// The inverse of [`Bivector::dual`].
    #[inline]
    pub fn undual(self) -> Bivector<T> {
        Line::from(self).undual()
    }

    /// Which way the line runs, of length 1; the normal is to its left.
    #[inline]
    pub fn direction(self) -> Direction<T> {
        kernels::line_direction(self.into())
    }

    /// The mirror image of a point.
    #[inline]
    pub fn reflect_point(self, point: Point<T>) -> Point<T> {
        kernels::line_reflect_point(self, point)
    }

    /// The mirror image of a direction.
    #[inline]
    pub fn reflect_direction(self, direction: Direction<T>) -> Direction<T> {
        kernels::line_reflect_direction(self, direction)
    }

    /// The mirror image of a line, its normal mirrored too: this line itself turns over. As left and right change
    /// places in a mirror, the image runs the opposite way to the images of the points on the line.
    #[inline]
    pub fn reflect_line(self, line: Line<T>) -> Line<T> {
        kernels::line_reflect_line(self, line)
    }

    /// The mirror image of a unit line, its normal mirrored too: this line itself turns over.
    #[inline]
    pub fn reflect_unit_line(self, line: UnitLine<T>) -> UnitLine<T> {
        kernels::line_reflect_unit_line(self, line)
    }
}

/// Constructors, distances in the caller's unit of length, angles in radians.
impl<T: Real> UnitLine<T> {
    /// Whether the promise of the type, a normal of length 1, holds to an absolute `tolerance`. False for NaN.
    #[inline]
    pub fn is_unit(self, tolerance: T) -> bool {
        self.satisfies_relations(tolerance)
    }

    /// The magnitude of e0: the distance from the origin.
    #[inline]
    pub fn ideal_norm(self) -> T {
        Line::from(self).ideal_norm()
    }

    /// The line through two points, directed from the first to the second; `None` where they coincide or are not
    /// finite.
    ///
    /// ```
    /// use pga_motor::pga2d::f64::{Direction, Point, UnitLine};
    ///
    /// let line = UnitLine::from_points(Point::new(0.0, 2.0), Point::new(5.0, 2.0)).unwrap();
    /// assert_eq!(line.direction(), Direction::X);
    /// assert_eq!(line.signed_distance_to_point(Point::new(7.0, 5.0)), 3.0);
    /// ```
    pub fn from_points(a: Point<T>, b: Point<T>) -> Option<Self> {
        Self::from_point_and_direction(a, b - a)
    }

    /// The line through a point; `None` where the direction is 0 or something is not finite.
    pub fn from_point_and_direction(point: Point<T>, direction: Direction<T>) -> Option<Self> {
        let line = kernels::point_join_unit_direction(point, direction.normalize()?);
        line.is_finite().then_some(line)
    }

    /// The distance of a point: a x + b y + c for a e1 + b e2 + c e0, so positive on the side to which the normal
    /// points, to the left of the way the line runs.
    #[inline]
    pub fn signed_distance_to_point(self, point: Point<T>) -> T {
        kernels::line_join_point(self.into(), point)
    }

    /// The distance of a point; never negative.
    #[inline]
    pub fn distance_to_point(self, point: Point<T>) -> T {
        self.signed_distance_to_point(point).abs()
    }

    /// The distance between two lines: 0 where they meet, the distance of one from the other where they are parallel,
    /// whichever way they run. Never negative.
    ///
    /// Lines that are parallel to rounding (the sine of the angle between them is at most 8 epsilon) count as parallel.
    pub fn distance_to_line(self, other: Self) -> T {
        let meet = kernels::line_meet_line(self.into(), other.into());
        if meet.norm() > T::EPSILON * T::from_ratio(8, 1) { T::ZERO } else { meet.ideal_norm() }
    }

    /// The angle by which the other line is turned from this one, in [-pi, pi], counter-clockwise.
    #[inline]
    pub fn angle_to_line(self, other: Self) -> T {
        let (a, b) = (self.into(), other.into());
        kernels::line_meet_line(a, b).e12.atan2(kernels::line_inner_line(a, b))
    }
}
