//! Rigid motions.

use crate::kernels::Matrix;
use crate::scalar::{Precision, precision};
use crate::{
    Direction, EvenMultivector, LengthMismatch, Line, Motor, Plane, Point, ProjectivePoint, Real, Rotor, Scalar,
    Translator, UnitLine, UnitPlane, kernels, slices,
};
use core::ops::Shr;

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

    /// The right complement: X ^ X.dual() is e0123 for every basis blade X.
    #[inline]
    pub fn dual(self) -> EvenMultivector<T> {
        EvenMultivector::from(self).dual()
    }

    /// The inverse of [`EvenMultivector::dual`].
    #[inline]
    pub fn undual(self) -> EvenMultivector<T> {
        EvenMultivector::from(self).undual()
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
}

/// Many things at once. What the motor determines is worked out once, as a matrix, so from the second item on this is
/// faster than one by one; results may differ from those in the last digits.
///
/// ```
/// use pga_motor::f64::{Direction, Motor, Point, Translator};
///
/// let motor = Motor::from(Translator::from_vector(Direction::X));
/// let mut points = [Point::ORIGIN, Point::new(0.0, 2.0, 0.0)];
/// motor.transform_points_in_place(&mut points);
/// assert_eq!(points, [Point::new(1.0, 0.0, 0.0), Point::new(1.0, 2.0, 0.0)]);
/// ```
impl<T: Scalar> Motor<T> {
    /// The matrix by which the motion acts on points.
    #[inline]
    pub fn to_matrix(self) -> Matrix<T> {
        kernels::motor_to_matrix(self)
    }

    /// Writes where the motion carries each point into the place with the same index.
    ///
    /// # Errors
    /// Slices of different lengths; then nothing is written.
    pub fn transform_points(self, points: &[Point<T>], results: &mut [Point<T>]) -> Result<(), LengthMismatch> {
        let matrix = kernels::motor_to_matrix(self);
        slices::map(points, results, |point| kernels::matrix_apply_point(matrix, point))
    }

    /// Moves each point.
    pub fn transform_points_in_place(self, points: &mut [Point<T>]) {
        let matrix = kernels::motor_to_matrix(self);
        slices::map_in_place(points, |point| kernels::matrix_apply_point(matrix, point));
    }

    /// Writes where the motion carries each direction into the place with the same index.
    ///
    /// # Errors
    /// Slices of different lengths; then nothing is written.
    pub fn transform_directions(
        self,
        directions: &[Direction<T>],
        results: &mut [Direction<T>],
    ) -> Result<(), LengthMismatch> {
        let matrix = kernels::motor_to_direction_matrix(self);
        slices::map(directions, results, |direction| kernels::matrix_apply_direction(matrix, direction))
    }

    /// Turns each direction.
    pub fn transform_directions_in_place(self, directions: &mut [Direction<T>]) {
        let matrix = kernels::motor_to_direction_matrix(self);
        slices::map_in_place(directions, |direction| kernels::matrix_apply_direction(matrix, direction));
    }

    /// Writes where the motion carries each line or screw into the place with the same index.
    ///
    /// # Errors
    /// Slices of different lengths; then nothing is written.
    pub fn transform_lines(self, lines: &[Line<T>], results: &mut [Line<T>]) -> Result<(), LengthMismatch> {
        let matrix = kernels::motor_to_line_matrix(self);
        slices::map(lines, results, |line| kernels::matrix_apply_line(matrix, line))
    }

    /// Moves each line or screw.
    pub fn transform_lines_in_place(self, lines: &mut [Line<T>]) {
        let matrix = kernels::motor_to_line_matrix(self);
        slices::map_in_place(lines, |line| kernels::matrix_apply_line(matrix, line));
    }

    /// Writes where the motion carries each plane into the place with the same index.
    ///
    /// # Errors
    /// Slices of different lengths; then nothing is written.
    pub fn transform_planes(self, planes: &[Plane<T>], results: &mut [Plane<T>]) -> Result<(), LengthMismatch> {
        let matrix = kernels::motor_to_plane_matrix(self);
        slices::map(planes, results, |plane| kernels::matrix_apply_plane(matrix, plane))
    }

    /// Moves each plane.
    pub fn transform_planes_in_place(self, planes: &mut [Plane<T>]) {
        let matrix = kernels::motor_to_plane_matrix(self);
        slices::map_in_place(planes, |plane| kernels::matrix_apply_plane(matrix, plane));
    }
}

impl<T: Scalar> Matrix<T> {
    /// The columns of the 4 x 4 matrix that acts on column vectors (x, y, z, 1): where the axes' directions and the
    /// origin go. The same layout as in glam, OpenGL and glTF.
    #[inline]
    pub fn to_columns(self) -> [[T; 4]; 4] {
        [
            [self.x_x, self.y_x, self.z_x, T::ZERO],
            [self.x_y, self.y_y, self.z_y, T::ZERO],
            [self.x_z, self.y_z, self.z_z, T::ZERO],
            [self.x_1, self.y_1, self.z_1, T::ONE],
        ]
    }

    /// Where the motion carries a point.
    #[inline]
    pub fn transform_point(self, point: Point<T>) -> Point<T> {
        kernels::matrix_apply_point(self, point)
    }
}

/// Screws, the exponential's inverse.
impl<T: Real> Motor<T> {
    /// Whether the promises of the type, unit norm and the Study quadric, hold to an absolute `tolerance`. False for NaN.
    #[inline]
    pub fn is_unit(self, tolerance: T) -> bool {
        self.satisfies_relations(tolerance)
    }

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
    /// turns the other way and slides the same way, so it is -log m where nothing slides. The logarithm of the turn by
    /// angle t about the unit line l is -t/2 l; of the translation by (x, y, z) it is -(x e01 + y e02 + z e03)/2.
    /// Rotations keep their digits however small they are. NaN in gives NaN out, and so do infinite coefficients of the
    /// rotation; an infinite translation stays infinite or becomes NaN.
    ///
    /// ```
    /// use pga_motor::f64::{Direction, Line, Motor, Translator};
    ///
    /// let translator = Translator::from_vector(Direction::new(2.0, 4.0, 6.0));
    /// assert_eq!(Motor::from(translator).log(), Line::new(0.0, 0.0, 0.0, -1.0, -2.0, -3.0));
    /// ```
    #[inline]
    pub fn log(self) -> Line<T> {
        kernels::motor_log(self.short_way())
    }

    /// Writes the logarithm of each motor into the place with the same index: [`Self::log`] of many.
    ///
    /// By polynomials in the scalar part, which the compiler makes vector code of; so results may differ from those of
    /// [`Self::log`] in the last digits, and by as much as a motor is off unit norm: [`Self::renormalize`] what has gathered
    /// rounding errors. Where the scalar part is above 1.0009 or NaN it is done one by one.
    ///
    /// # Errors
    /// Slices of different lengths; then nothing is written.
    ///
    /// ```
    /// use pga_motor::f32::{Line, Motor, Rotor};
    ///
    /// let motors = [Motor::IDENTITY, Rotor::about_x(2.0).into()];
    /// let mut logs = [Line::ZERO; 2];
    /// Motor::log_slice(&motors, &mut logs)?;
    /// assert_eq!(logs[0], Line::ZERO);
    /// assert!((logs[1] - motors[1].log()).norm() < 4.0 * f32::EPSILON);
    /// # Ok::<(), pga_motor::LengthMismatch>(())
    /// ```
    pub fn log_slice(motors: &[Self], lines: &mut [Line<T>]) -> Result<(), LengthMismatch> {
        match precision::<T>() {
            Precision::Single => slices::map_quickly(
                motors,
                lines,
                |motor: Self| kernels::motor_log_f32(motor.short_way()),
                |motor: Self| kernels::motor_log_f32_holds(motor.short_way()),
                Self::log,
            ),
            Precision::Double => slices::map_quickly(
                motors,
                lines,
                |motor: Self| kernels::motor_log_f64(motor.short_way()),
                |motor: Self| kernels::motor_log_f64_holds(motor.short_way()),
                Self::log,
            ),
            Precision::Finer => slices::map(motors, lines, Self::log),
        }
    }

    /// The generator of the motor itself, by at most a whole turn: exp(m.log_double_cover()) is m and not -m.
    ///
    /// The same as [`Self::log`] where the scalar part is not negative; otherwise the motion the long way round, between half a
    /// turn and a whole one. The nearer m is to -1 or to the negative of a translator, the longer the moment of the axis
    /// can be.
    ///
    /// `None` where there is no generator or no one axis: for -1, and for the negative of a translator, whose scalar part is
    /// negative while nothing turns; and where the axis is so far away that its moment is beyond the range of the numbers.
    ///
    /// Near -1 exp magnifies what pi is rounded by with that moment, so there its result is less exact than the generator is. For
    /// half the motion see [`Self::sqrt_double_cover`].
    ///
    /// ```
    /// use pga_motor::f64::{Motor, Rotor};
    ///
    /// let long_way = -Motor::from(Rotor::about_z(1.0));
    /// let generator = long_way.log_double_cover().unwrap();
    /// assert!((generator.norm() - (std::f64::consts::PI - 0.5)).abs() < 1e-15);
    /// assert!((generator.exp() - long_way).norm() < 1e-15);
    /// assert_eq!((-Motor::IDENTITY).log_double_cover(), None);
    /// ```
    pub fn log_double_cover(self) -> Option<Line<T>> {
        let Some(axis) = self.long_way_axis()? else { return Some(self.log()) };
        Some((-self).log() + Line::from(axis) * T::PI)
    }

    /// The motion half way: sqrt(m) sqrt(m) is m or -m, which are the same motion. The short way, and defined for every
    /// motor; the same for m and -m, but on the tie of exactly half a turn, where sqrt(-m) turns the other way.
    ///
    /// ```
    /// use pga_motor::f64::{Motor, Rotor};
    ///
    /// let root = Motor::from(Rotor::about_z(3.0)).sqrt();
    /// assert!((root - Motor::from(Rotor::about_z(1.5))).norm() < 1e-15);
    /// ```
    #[inline]
    pub fn sqrt(self) -> Self {
        kernels::motor_sqrt(self.short_way())
    }

    /// The square root of the motor itself, with a scalar part that is not negative: its square is m and not -m. Where the
    /// scalar part of m is negative this is half of the long way round.
    ///
    /// `None` for -1, for the negative of a translator, and for an axis out of range, as for [`Self::log_double_cover`].
    pub fn sqrt_double_cover(self) -> Option<Self> {
        let Some(axis) = self.long_way_axis()? else { return Some(self.sqrt()) };
        // m = exp(L + pi U) with -m = exp(L) about the same unit axis U, and exp(pi/2 U) = U.
        Some((-self).sqrt() * axis)
    }

    /// The motion `exponent` times over, the short way: exp(exponent log m). `powf(0)` stays put, `powf(-1)` is the motion
    /// back, `powf(0.5)` the same as [`Self::sqrt`] up to rounding.
    #[inline]
    pub fn powf(self, exponent: T) -> Self {
        (self.log() * exponent).exp()
    }

    /// The motor without the rounding errors that many products leave in its norm and on the Study quadric: of unit norm to
    /// rounding. For what is no motor yet, [`EvenMultivector::normalize`] says whether there is one.
    ///
    /// ```
    /// use pga_motor::f32::{Motor, Rotor};
    ///
    /// let step = Motor::from(Rotor::about_z(0.1));
    /// let turned = (0..10_000).fold(Motor::IDENTITY, |turned, _| (step * turned).renormalize());
    /// assert!(turned.is_unit(2.0 * f32::EPSILON));
    /// ```
    #[inline]
    pub fn renormalize(self) -> Self {
        EvenMultivector::from(self).over_norm()
    }

    /// m or -m, whichever has a scalar part that is not negative: the motion by at most half a turn.
    #[inline(always)]
    pub(crate) fn short_way(self) -> Self {
        // Without a branch, for loops over many.
        let sign = if self.s < T::ZERO { -T::ONE } else { T::ONE };
        Self::from(self.to_array().map(|coefficient| coefficient * sign))
    }

    /// Where the scalar part is negative, the axis along which the bivector part runs; `Some(None)` where it is not, and
    /// `None` where there is no axis.
    fn long_way_axis(self) -> Option<Option<UnitLine<T>>> {
        if self.s < T::ZERO { kernels::motor_bivector(self).normalize().map(Some) } else { Some(None) }
    }
}

/// The motion that carries one thing to another.
impl<T: Real> Motor<T> {
    /// The translation that carries a point to another.
    #[inline]
    pub fn between_points(from: Point<T>, to: Point<T>) -> Self {
        kernels::motor_between_points(from, to).into()
    }

    /// The turn about their common line that carries a unit plane to another, normal to normal; for parallel planes the
    /// translation along their normal.
    ///
    /// Accurate up to planes that all but face each other. `None` for planes whose normals are exactly opposite: any axis in the
    /// plane would do; and where something is not finite.
    ///
    /// ```
    /// use pga_motor::f64::{Direction, Motor, Point, UnitPlane};
    ///
    /// let wall = UnitPlane::from_point_and_normal(Point::new(2.0, 0.0, 0.0), Direction::X).unwrap();
    /// let ground = UnitPlane::from_point_and_normal(Point::ORIGIN, Direction::Z).unwrap();
    /// let motor = Motor::between_planes(wall, ground).unwrap();
    /// let moved = motor.transform_unit_plane(wall);
    /// assert!((moved.e3 - 1.0).abs() < 1e-15 && moved.e0.abs() < 1e-15);
    /// assert_eq!(Motor::between_planes(wall, -wall), None);
    /// ```
    pub fn between_planes(from: UnitPlane<T>, to: UnitPlane<T>) -> Option<Self> {
        let motor = kernels::motor_between_planes(from, to);
        motor.is_finite().then_some(motor)
    }

    /// The screw about their common perpendicular that carries a unit line to another, direction to direction: a turn by
    /// the angle between them and a slide by their distance. For lines that meet a turn, for parallel ones a translation.
    ///
    /// Accurate up to lines that run in all but opposite directions. `None` for exactly opposite ones: any axis perpendicular to
    /// them would do; and where something is not finite.
    ///
    /// ```
    /// use pga_motor::f64::{Direction, Motor, Point, UnitLine};
    ///
    /// let line = |point, direction| UnitLine::from_point_and_direction(point, direction).unwrap();
    /// let (a, b) = (line(Point::ORIGIN, Direction::X), line(Point::new(0.0, 0.0, 5.0), Direction::Y));
    /// let motor = Motor::between_lines(a, b).unwrap();
    /// assert!((motor.transform_origin() - Point::new(0.0, 0.0, 5.0)).norm() < 1e-15);
    /// assert_eq!(Motor::between_lines(a, a.reverse()), None);
    /// ```
    pub fn between_lines(from: UnitLine<T>, to: UnitLine<T>) -> Option<Self> {
        let motor = kernels::motor_between_lines(from, to);
        motor.is_finite().then_some(motor)
    }
}
