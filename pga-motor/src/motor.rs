//! Rigid motions.

use crate::{
    Direction, Line, Motor, Plane, Point, ProjectivePoint, Real, Rotor, Scalar, Translator, UnitLine, UnitPlane,
    kernels,
};
use core::fmt;
use core::ops::Shr;

/// Two slices that should be of the same length are not.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LengthMismatch {
    /// The number of points to transform.
    pub points: usize,
    /// The number of places for results.
    pub results: usize,
}

impl LengthMismatch {
    pub(crate) fn check<P, R>(points: &[P], results: &[R]) -> Result<(), Self> {
        let (points, results) = (points.len(), results.len());
        if points == results { Ok(()) } else { Err(Self { points, results }) }
    }
}

impl fmt::Display for LengthMismatch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "expected as many places for results as there are points, {}, found {}", self.points, self.results)
    }
}

impl core::error::Error for LengthMismatch {}

/// Motors from their parts, and back. `a * b` is the motion b followed by the motion a.
impl<T: Scalar> Motor<T> {
    /// The rotation followed by the translation: translator * rotor.
    #[inline]
    pub fn from_rotor_translator(rotor: Rotor<T>, translator: Translator<T>) -> Self {
        kernels::translator_mul_rotor(translator, rotor)
    }

    /// The rotation about the origin in this motion = translator * rotor: the Euclidean part.
    #[inline]
    pub fn rotor(self) -> Rotor<T> {
        kernels::motor_rotor(self)
    }

    /// The translation in this motion = translator * rotor: by the vector from the origin to where the origin goes.
    #[inline]
    pub fn translator(self) -> Translator<T> {
        kernels::motor_translator(self)
    }

    /// ~m: the motion back.
    #[inline]
    pub fn reverse(self) -> Self {
        kernels::motor_reverse(self)
    }

    /// The motion back. A motor is of unit norm, so this is the reverse.
    #[inline]
    pub fn inverse(self) -> Self {
        self.reverse()
    }
}

/// What a motion does to things: m x ~m.
///
/// ```
/// use pga_motor::f64::{Direction, Motor, Point, Rotor, Translator};
///
/// let rotor = Rotor::about_z(std::f64::consts::FRAC_PI_2);
/// let translator = Translator::from_vector(Direction::new(0.0, 0.0, 5.0));
/// let motor = Motor::from_rotor_translator(rotor, translator);
/// let moved = motor.transform_point(Point::new(1.0, 0.0, 0.0));
/// assert!(moved.distance_to_point(Point::new(0.0, 1.0, 5.0)) < 1e-15);
/// assert_eq!(motor.transform(Point::ORIGIN), Point::new(0.0, 0.0, 5.0));
/// ```
impl<T: Scalar> Motor<T> {
    /// m x ~m for anything that a motor can act on; the same as `m >> x`.
    #[inline]
    pub fn transform<X>(self, x: X) -> <Self as Shr<X>>::Output
    where
        Self: Shr<X>,
    {
        self >> x
    }

    /// Where the motion carries a point.
    #[inline]
    pub fn transform_point(self, point: Point<T>) -> Point<T> {
        kernels::motor_transform_point(self, point)
    }

    /// Where the motion carries the origin; cheaper than any other point.
    #[inline]
    pub fn transform_origin(self) -> Point<T> {
        kernels::motor_transform_origin(self)
    }

    /// Where the motion carries a projective point; its weight stays.
    #[inline]
    pub fn transform_projective_point(self, point: ProjectivePoint<T>) -> ProjectivePoint<T> {
        kernels::motor_transform_projective_point(self, point)
    }

    /// Where the motion carries a direction: it turns it.
    #[inline]
    pub fn transform_direction(self, direction: Direction<T>) -> Direction<T> {
        kernels::motor_transform_direction(self, direction)
    }

    /// Where the motion carries a line or a screw.
    #[inline]
    pub fn transform_line(self, line: Line<T>) -> Line<T> {
        kernels::motor_transform_line(self, line)
    }

    /// Where the motion carries a unit line.
    #[inline]
    pub fn transform_unit_line(self, line: UnitLine<T>) -> UnitLine<T> {
        kernels::motor_transform_unit_line(self, line)
    }

    /// Where the motion carries a plane.
    #[inline]
    pub fn transform_plane(self, plane: Plane<T>) -> Plane<T> {
        kernels::motor_transform_plane(self, plane)
    }

    /// Where the motion carries a unit plane.
    #[inline]
    pub fn transform_unit_plane(self, plane: UnitPlane<T>) -> UnitPlane<T> {
        kernels::motor_transform_unit_plane(self, plane)
    }

    /// m x ~m: the motion x about the place to which m carries it. For one motion after another, multiply.
    #[inline]
    pub fn transform_motor(self, motor: Motor<T>) -> Motor<T> {
        kernels::motor_transform_motor(self, motor)
    }

    /// Writes where the motion carries each point into the place with the same index.
    ///
    /// # Errors
    /// Slices of different lengths; then nothing is written.
    pub fn transform_points(self, points: &[Point<T>], results: &mut [Point<T>]) -> Result<(), LengthMismatch> {
        LengthMismatch::check(points, results)?;
        for (result, point) in results.iter_mut().zip(points) {
            *result = self.transform_point(*point);
        }
        Ok(())
    }

    /// Moves each point.
    pub fn transform_points_in_place(self, points: &mut [Point<T>]) {
        for point in points {
            *point = self.transform_point(*point);
        }
    }
}

/// Screws, the exponential's inverse.
impl<T: Real> Motor<T> {
    /// The turn by `angle` about a line, right-handed, and the slide by `distance` along it; angle in radians, distance
    /// in the caller's unit of length. The line may be off the origin and of any length other than 0; of a screw the
    /// axis is taken, as [`Line::normalize`] does.
    ///
    /// For the unit line l this is (cos(angle/2) - sin(angle/2) l) (1 + distance/2 l e0123).
    ///
    /// `None` where the line has no direction (it is zero or at infinity) or something is not finite.
    ///
    /// ```
    /// use pga_motor::f64::{Direction, Motor, Point};
    ///
    /// // Half a turn about the upward line through (1, 0, 0), and three up.
    /// let axis = Point::new(1.0, 0.0, 0.0) & Direction::Z;
    /// let screw = Motor::from_screw(axis, std::f64::consts::PI, 3.0).unwrap();
    /// let moved = screw.transform_origin();
    /// assert!(moved.distance_to_point(Point::new(2.0, 0.0, 3.0)) < 1e-15);
    /// ```
    pub fn from_screw(axis: Line<T>, angle: T, distance: T) -> Option<Self> {
        let axis = axis.normalize()?;
        let half = T::from_ratio(1, 2);
        let (sin, cos) = (angle * half).sin_cos();
        let motor = kernels::unit_line_screw(axis, cos, sin, distance * half);
        motor.is_finite().then_some(motor)
    }

    /// The generator of the rigid motion by at most half a turn: exp(log m) is m or -m, which are the same motion.
    ///
    /// m and -m have the same logarithm, except where the scalar part is 0: on this tie, exactly half a turn, log(-m)
    /// is -log m. The logarithm of the turn by angle t about the unit line l is -t/2 l; of the translation by (x, y, z)
    /// it is -(x e01 + y e02 + z e03)/2. NaN in gives NaN out.
    ///
    /// ```
    /// use pga_motor::f64::{Direction, Line, Motor, Translator};
    ///
    /// let translator = Translator::from_vector(Direction::new(2.0, 4.0, 6.0));
    /// assert_eq!(Motor::from(translator).log(), Line::new(0.0, 0.0, 0.0, -1.0, -2.0, -3.0));
    /// ```
    #[inline]
    pub fn log(self) -> Line<T> {
        kernels::motor_log(if self.s < T::ZERO { -self } else { self })
    }
}
