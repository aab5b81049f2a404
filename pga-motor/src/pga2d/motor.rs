//! Rigid motions of the plane.

use super::{
    Bivector, Direction, EvenMultivector, Line, Motor, OddMultivector, Point, Rotor, Translator, UnitLine, kernels,
};
use crate::scalar::{Precision, precision};
use crate::{LengthMismatch, Real, Scalar, slices};
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
}

/// What a motion does to things: m x ~m.
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

    /// Where the motion carries a direction: it turns it.
    #[inline]
    pub fn transform_direction(self, direction: Direction<T>) -> Direction<T> {
        kernels::motor_transform_direction(self, direction)
    }

    /// Where the motion carries a bivector: a point of any weight.
    #[inline]
    pub fn transform_bivector(self, bivector: Bivector<T>) -> Bivector<T> {
        kernels::motor_transform_bivector(self, bivector)
    }

    /// Where the motion carries a line.
    #[inline]
    pub fn transform_line(self, line: Line<T>) -> Line<T> {
        kernels::motor_transform_line(self, line)
    }

    /// Where the motion carries a unit line.
    #[inline]
    pub fn transform_unit_line(self, line: UnitLine<T>) -> UnitLine<T> {
        kernels::motor_transform_unit_line(self, line)
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
        slices::map(points, results, |point| self.transform_point(point))
    }

    /// Moves each point.
    pub fn transform_points_in_place(self, points: &mut [Point<T>]) {
        slices::map_in_place(points, |point| self.transform_point(point));
    }
}

impl<T: Real> Motor<T> {
    /// Whether the promise of the type, unit norm, holds to an absolute `tolerance`. False for NaN.
    #[inline]
    pub fn is_unit(self, tolerance: T) -> bool {
        self.satisfies_relations(tolerance)
    }

    /// The turn about a point by an angle in radians, counter-clockwise: cos(angle/2) - sin(angle/2) p. NaN where
    /// something is not finite.
    ///
    /// ```
    /// use pga_motor::pga2d::f64::{Motor, Point};
    ///
    /// let half_turn = Motor::about(Point::new(1.0, 2.0), std::f64::consts::PI);
    /// assert!(half_turn.transform_origin().distance_to_point(Point::new(2.0, 4.0)) < 1e-15);
    /// ```
    #[inline]
    pub fn about(point: Point<T>, angle: T) -> Self {
        let (sin, cos) = (angle * T::from_ratio(1, 2)).sin_cos();
        kernels::point_turn(point, cos, sin)
    }

    /// The generator of the rigid motion by at most half a turn: exp(log m) is m or -m, which are the same motion.
    ///
    /// m and -m have the same logarithm, except where the scalar part is 0: on this tie, exactly half a turn, log(-m)
    /// is -log m. The logarithm of the turn by angle t about the point p is -t/2 p; of the translation by (x, y) it is
    /// -(x e01 - y e20)/2. Rotations keep their digits however small they are. NaN in gives NaN out, and so does an
    /// infinite e12; an infinite scalar part counts as no turn; an infinite translation stays infinite or becomes NaN.
    #[inline]
    pub fn log(self) -> Bivector<T> {
        kernels::motor_log(self.short_way())
    }

    /// Writes the logarithm of each motor into the place with the same index: [`Self::log`] of many.
    ///
    /// By polynomials in the scalar part, which the compiler makes vector code of; so results may differ from those of
    /// [`Self::log`] in the last digits, and by as much as a motor is off unit norm. Where the scalar part is above 1.0009 or
    /// NaN it is done one by one.
    ///
    /// # Errors
    /// Slices of different lengths; then nothing is written.
    pub fn log_slice(motors: &[Self], bivectors: &mut [Bivector<T>]) -> Result<(), LengthMismatch> {
        match precision::<T>() {
            Precision::Single => slices::map_quickly(
                motors,
                bivectors,
                |motor: Self| kernels::motor_log_f32(motor.short_way()),
                |motor: Self| kernels::motor_log_f32_holds(motor.short_way()),
                Self::log,
            ),
            Precision::Double => slices::map_quickly(
                motors,
                bivectors,
                |motor: Self| kernels::motor_log_f64(motor.short_way()),
                |motor: Self| kernels::motor_log_f64_holds(motor.short_way()),
                Self::log,
            ),
            Precision::Finer => slices::map(motors, bivectors, Self::log),
        }
    }

    /// The generator of the motor itself, by at most a whole turn: exp(m.log_double_cover()) is m and not -m.
    ///
    /// The same as [`Self::log`] where the scalar part is not negative; otherwise the motion the long way round.
    ///
    /// `None` where there is no generator or no one centre: for -1, and for the negative of a translator.
    ///
    /// ```
    /// use pga_motor::pga2d::f64::{Motor, Point};
    ///
    /// let long_way = -Motor::about(Point::new(3.0, 4.0), 1.0);
    /// let generator = long_way.log_double_cover().unwrap();
    /// assert!((generator.norm() - (std::f64::consts::PI - 0.5)).abs() < 1e-15);
    /// assert_eq!((-Motor::IDENTITY).log_double_cover(), None);
    /// ```
    pub fn log_double_cover(self) -> Option<Bivector<T>> {
        let Some(center) = self.long_way_center()? else { return Some(self.log()) };
        Some((-self).log() + center * T::PI)
    }

    /// The motion half way: sqrt(m) sqrt(m) is m or -m, which are the same motion. The short way, and defined for every
    /// motor; the same for m and -m, but on the tie of exactly half a turn, where sqrt(-m) turns the other way.
    #[inline]
    pub fn sqrt(self) -> Self {
        kernels::motor_sqrt(self.short_way())
    }

    /// The square root of the motor itself, with a scalar part that is not negative: its square is m and not -m. Where the
    /// scalar part of m is negative this is half of the long way round.
    ///
    /// `None` for -1 and for the negative of a translator, as for [`Self::log_double_cover`].
    pub fn sqrt_double_cover(self) -> Option<Self> {
        let Some(center) = self.long_way_center()? else { return Some(self.sqrt()) };
        // m = exp(L + pi P) with -m = exp(L) about the same unit point P, and exp(pi/2 P) = P.
        let root = EvenMultivector::from((-self).sqrt()) * EvenMultivector::from(center);
        Some(root.to_array().into())
    }

    /// The motion `exponent` times over, the short way: exp(exponent log m).
    #[inline]
    pub fn powf(self, exponent: T) -> Self {
        (self.log() * exponent).exp()
    }

    /// The motor without the rounding errors that many products leave in its norm: of unit norm to rounding.
    #[inline]
    pub fn renormalize(self) -> Self {
        EvenMultivector::from(self).over_norm()
    }

    /// m or -m, whichever has a scalar part that is not negative: the motion by at most half a turn.
    #[inline]
    fn short_way(self) -> Self {
        if self.s < T::ZERO { -self } else { self }
    }

    /// Where the scalar part is negative, the bivector part over its norm: the centre, of weight 1 or -1; `Some(None)` where
    /// it is not, and `None` where there is no centre.
    fn long_way_center(self) -> Option<Option<Bivector<T>>> {
        if self.s < T::ZERO { kernels::motor_bivector(self).over_norm().map(Some) } else { Some(None) }
    }

    /// The translation that carries a point to another.
    #[inline]
    pub fn between_points(from: Point<T>, to: Point<T>) -> Self {
        kernels::motor_between_points(from, to).into()
    }

    /// The turn about the point where they meet that carries a unit line to another, normal to normal; for parallel lines the
    /// translation along their normal.
    ///
    /// `None` for lines that run in opposite directions, any point on the line half way would do; and where something is not
    /// finite.
    ///
    /// ```
    /// use pga_motor::pga2d::f64::{Motor, Point, UnitLine};
    ///
    /// let (level, upright) = (UnitLine::new(0.0, 1.0, -2.0), UnitLine::new(1.0, 0.0, -3.0));
    /// let motor = Motor::between_lines(level, upright).unwrap();
    /// assert!(motor.transform_point(Point::new(3.0, 2.0)).distance_to_point(Point::new(3.0, 2.0)) < 1e-14);
    /// assert_eq!(Motor::between_lines(level, -level), None);
    /// ```
    pub fn between_lines(from: UnitLine<T>, to: UnitLine<T>) -> Option<Self> {
        let motor = kernels::motor_between_lines(from, to);
        motor.is_finite().then_some(motor)
    }
}
