//! Lines and screws.

use crate::scalar::{Precision, precision};
use crate::{
    Direction, LengthMismatch, Line, Motor, Point, Real, Scalar, UnitLine, UnitPlane, kernels, magnitude, slices,
};

impl<T: Scalar> Line<T> {
    /// Which way the line runs, as long as its norm: (e23, e31, e12).
    #[inline]
    pub fn direction(self) -> Direction<T> {
        kernels::line_direction(self)
    }

    /// ~l: the same line running the other way.
    #[inline]
    pub fn reverse(self) -> Self {
        kernels::line_reverse(self)
    }

    /// The right complement: X ^ X.dual() is e0123 for every basis blade X. Direction and moment change places.
    #[inline]
    pub fn dual(self) -> Self {
        kernels::line_dual(self)
    }

    /// The inverse of [`Self::dual`].
    #[inline]
    pub fn undual(self) -> Self {
        kernels::line_undual(self)
    }

    /// The shadow of the line on a plane, along the plane's normal; as long as the shadow of the direction is.
    #[inline]
    pub fn project_onto_plane(self, plane: UnitPlane<T>) -> Self {
        kernels::line_project_onto_plane(self, plane)
    }

    /// The parallel line through a point.
    #[inline]
    pub fn project_onto_point(self, point: Point<T>) -> Self {
        kernels::line_project_onto_point(self, point)
    }
}

impl<T: Real> Line<T> {
    /// The screw whose product with this one, on either side, is 1: ~l over l ~l. Of a line it is the line running the
    /// other way, over the square of the norm.
    ///
    /// `None` where the norm is 0 (a line at infinity), or something is not finite.
    ///
    /// ```
    /// use pga_motor::f64::Line;
    ///
    /// let line = Line::new(0.0, 0.0, 2.0, 4.0, 0.0, 0.0);
    /// assert_eq!(line.inverse(), Some(Line::new(0.0, 0.0, -0.5, -1.0, 0.0, 0.0)));
    /// assert_eq!(Line::new(0.0, 0.0, 0.0, 4.0, 0.0, 0.0).inverse(), None);
    /// ```
    pub fn inverse(self) -> Option<Self> {
        let scale = magnitude::scale(self.direction().to_array())?;
        let scaled = self * scale;
        let squared = kernels::line_norm_squared(scaled);
        let inverse = kernels::line_adjugate(scaled) / (squared * squared) * scale;
        inverse.is_finite().then_some(inverse)
    }

    /// Whether this is a unit line: both relations of [`UnitLine`] hold to an absolute `tolerance`. False for NaN.
    #[inline]
    pub fn is_unit(self, tolerance: T) -> bool {
        UnitLine::from(self.to_array()).satisfies_relations(tolerance)
    }

    /// The length of the direction (e23, e31, e12): of the join of two points their distance.
    #[inline]
    pub fn norm(self) -> T {
        T::norm([self.e23, self.e31, self.e12])
    }

    /// The length of the moment (e01, e02, e03): for a line its norm times its distance from the origin.
    #[inline]
    pub fn ideal_norm(self) -> T {
        T::norm([self.e01, self.e02, self.e03])
    }

    /// The axis: the line of length 1 about which the screw turns and along which it slides. Of a line, which turns
    /// only, that is the line itself with its direction made 1 long; of a screw, the moment loses what is parallel to
    /// the direction.
    ///
    /// `None` where there is no axis: the direction is 0 (a line at infinity, the generator of a translation), or
    /// something is not finite.
    ///
    /// ```
    /// use pga_motor::f64::{Line, UnitLine};
    ///
    /// let screw = Line::new(0.0, 0.0, 2.0, 0.0, 6.0, 5.0);
    /// assert_eq!(screw.normalize(), Some(UnitLine::new(0.0, 0.0, 1.0, 0.0, 3.0, 0.0)));
    /// assert_eq!(Line::new(0.0, 0.0, 0.0, 0.0, 6.0, 5.0).normalize(), None);
    /// ```
    pub fn normalize(self) -> Option<UnitLine<T>> {
        let scaled = self * magnitude::scale(self.direction().to_array())?;
        let axis = kernels::line_axis(scaled / kernels::line_norm_squared(scaled).sqrt());
        axis.is_finite().then_some(axis)
    }

    /// The motion that the screw generates: the sum of l^n / n!.
    ///
    /// The turn by angle t about the unit line l, counter-clockwise seen against its direction, is the exponential of
    /// -t/2 l; the translation by (x, y, z) that of -(x e01 + y e02 + z e03)/2. [`Motor::from_screw`] takes the angle
    /// itself. Any finite half-angle will do, and the result keeps the digits of the smallest. NaN in gives NaN out, and so does
    /// an infinite coefficient; an ideal part above about a quarter of the greatest number may overflow to either on the way.
    ///
    /// ```
    /// use pga_motor::f64::{Direction, Point};
    ///
    /// let axis = Point::new(1.0, 0.0, 0.0) & Direction::Z;
    /// let half_turn = (axis * (-std::f64::consts::PI / 2.0)).exp();
    /// assert!(half_turn.transform_origin().distance_to_point(Point::new(2.0, 0.0, 0.0)) < 1e-15);
    /// ```
    #[inline]
    pub fn exp(self) -> Motor<T> {
        kernels::line_exp(self)
    }

    /// Writes the motion that each screw generates into the place with the same index: [`Self::exp`] of many.
    ///
    /// For turns by at most half a turn, half-angles up to about pi/2, by polynomials that the compiler makes vector code of; so
    /// results may differ from those of [`Self::exp`] in the last digits. Where the angle is greater, or NaN, it is done one by
    /// one.
    ///
    /// # Errors
    /// Slices of different lengths; then nothing is written.
    ///
    /// ```
    /// use pga_motor::f32::{Line, Motor};
    ///
    /// let lines = [Line::new(0.0, 0.0, 0.5, 0.0, 0.0, 1.0), Line::new(0.0, 0.0, 0.0, 1.0, 2.0, 3.0)];
    /// let mut motors = [Motor::IDENTITY; 2];
    /// Line::exp_slice(&lines, &mut motors)?;
    /// assert!((motors[0] - lines[0].exp()).norm() < 2.0 * f32::EPSILON);
    /// assert_eq!(motors[1], lines[1].exp());
    /// # Ok::<(), pga_motor::LengthMismatch>(())
    /// ```
    pub fn exp_slice(lines: &[Self], motors: &mut [Motor<T>]) -> Result<(), LengthMismatch> {
        match precision::<T>() {
            Precision::Single => {
                slices::map_quickly(lines, motors, kernels::line_exp_f32, kernels::line_exp_f32_holds, Self::exp)
            }
            Precision::Double => {
                slices::map_quickly(lines, motors, kernels::line_exp_f64, kernels::line_exp_f64_holds, Self::exp)
            }
            Precision::Finer => slices::map(lines, motors, Self::exp),
        }
    }
}

impl<T: Scalar> UnitLine<T> {
    /// Which way the line runs; of length 1.
    #[inline]
    pub fn direction(self) -> Direction<T> {
        kernels::line_direction(self.into())
    }

    /// ~l: the same line running the other way.
    #[inline]
    pub fn reverse(self) -> Self {
        kernels::unit_line_reverse(self)
    }

    /// The line whose product with this one is 1. A unit line is of unit norm, so this is the reverse.
    #[inline]
    pub fn inverse(self) -> Self {
        self.reverse()
    }

    /// The right complement: X ^ X.dual() is e0123 for every basis blade X. Direction and moment change places.
    #[inline]
    pub fn dual(self) -> Line<T> {
        Line::from(self).dual()
    }

    /// The inverse of [`Line::dual`].
    #[inline]
    pub fn undual(self) -> Line<T> {
        Line::from(self).undual()
    }

    /// The shadow of the line on a plane, along the plane's normal; of length the cosine of the angle to the plane.
    #[inline]
    pub fn project_onto_plane(self, plane: UnitPlane<T>) -> Line<T> {
        kernels::line_project_onto_plane(self.into(), plane)
    }

    /// The parallel line through a point.
    #[inline]
    pub fn project_onto_point(self, point: Point<T>) -> Self {
        kernels::unit_line_project_onto_point(self, point)
    }
}

/// Constructors, distances in the caller's unit of length, angles in radians.
impl<T: Real> UnitLine<T> {
    /// Whether the promises of the type, a direction of length 1 and the Pluecker relation, hold to an absolute
    /// `tolerance`. False for NaN.
    #[inline]
    pub fn is_unit(self, tolerance: T) -> bool {
        self.satisfies_relations(tolerance)
    }

    /// The length of the moment (e01, e02, e03): the distance from the origin.
    #[inline]
    pub fn ideal_norm(self) -> T {
        Line::from(self).ideal_norm()
    }

    /// The line through two points, directed from the first to the second; `None` where they coincide or are not
    /// finite.
    ///
    /// ```
    /// use pga_motor::f64::{Direction, Point, UnitLine};
    ///
    /// let line = UnitLine::from_points(Point::new(1.0, 0.0, 0.0), Point::new(1.0, 0.0, 7.0)).unwrap();
    /// assert_eq!(line.direction(), Direction::Z);
    /// assert_eq!(line.distance_to_point(Point::ORIGIN), 1.0);
    /// ```
    pub fn from_points(a: Point<T>, b: Point<T>) -> Option<Self> {
        Self::from_point_and_direction(a, b - a)
    }

    /// The line through a point; `None` where the direction is 0 or something is not finite.
    pub fn from_point_and_direction(point: Point<T>, direction: Direction<T>) -> Option<Self> {
        let line = kernels::point_join_unit_direction(point, direction.normalize()?);
        line.is_finite().then_some(line)
    }

    /// The distance of a point; never negative.
    #[inline]
    pub fn distance_to_point(self, point: Point<T>) -> T {
        kernels::line_join_point(self.into(), point).norm()
    }

    /// The smallest distance between points of the two lines: 0 where they meet, the length of the common perpendicular
    /// where they are skew, the distance of one from the other where they are parallel.
    ///
    /// Between skew and parallel the distance jumps, so lines whose directions agree, or are opposite, to rounding (the
    /// sine of the angle is at most 8 epsilon) count as parallel.
    ///
    /// ```
    /// use pga_motor::f64::{Direction, Point, UnitLine};
    ///
    /// let a = UnitLine::from_point_and_direction(Point::ORIGIN, Direction::X).unwrap();
    /// let skew = UnitLine::from_point_and_direction(Point::new(5.0, 6.0, 2.0), Direction::Y).unwrap();
    /// let parallel = UnitLine::from_point_and_direction(Point::new(7.0, 3.0, 4.0), -Direction::X).unwrap();
    /// assert_eq!(a.distance_to_line(skew), 2.0);
    /// assert_eq!(a.distance_to_line(parallel), 5.0);
    /// ```
    pub fn distance_to_line(self, other: Self) -> T {
        let (a, b) = (self.into(), other.into());
        let perpendicular = kernels::line_commutator_line(a, b);
        let sine = perpendicular.norm();
        if sine <= T::EPSILON * T::from_ratio(8, 1) {
            perpendicular.ideal_norm()
        } else {
            kernels::line_meet_line(a, b).e0123.abs() / sine
        }
    }

    /// The distance between a line and a plane: 0 where they meet, the distance of each point of the line where the two
    /// are parallel. Never negative.
    ///
    /// Lines that are parallel to rounding (the sine of the angle to the plane is at most 8 epsilon) count as parallel.
    ///
    /// ```
    /// use pga_motor::f64::{Direction, Point, UnitLine, UnitPlane};
    ///
    /// let ground = UnitPlane::from_point_and_normal(Point::ORIGIN, Direction::Z).unwrap();
    /// let at = |direction| UnitLine::from_point_and_direction(Point::new(5.0, 6.0, -2.0), direction).unwrap();
    /// assert_eq!(at(Direction::X).distance_to_plane(ground), 2.0);
    /// assert_eq!(at(Direction::new(1.0, 0.0, 0.1)).distance_to_plane(ground), 0.0);
    /// ```
    pub fn distance_to_plane(self, plane: UnitPlane<T>) -> T {
        let meet = kernels::plane_meet_line(plane.into(), self.into());
        if meet.norm() > T::EPSILON * T::from_ratio(8, 1) { T::ZERO } else { meet.ideal_norm() }
    }

    /// The angle between the directions of two lines, in [0, pi], wherever the lines are.
    pub fn angle_to_line(self, other: Self) -> T {
        let (a, b) = (self.into(), other.into());
        kernels::line_commutator_line(a, b).norm().atan2(-kernels::line_inner_line(a, b))
    }

    /// The angle by which the line rises from a plane, in [-pi/2, pi/2]; positive where it runs to the side to which
    /// the plane's normal points.
    #[inline]
    pub fn angle_to_plane(self, plane: UnitPlane<T>) -> T {
        let (line, plane) = (self.into(), plane.into());
        let sine = kernels::plane_meet_line(plane, line).e123;
        sine.atan2(kernels::plane_inner_line(plane, line).norm())
    }
}
