//! Motions of the plane between motions.
//!
//! Every way here goes the short way, from a at t = 0 to b at t = 1, or to -b, which is the same motion; beyond 0
//! and 1 it extrapolates. They differ in the path, the speed and the cost:
//!
//! | | path | speed | depends on a choice of origin |
//! |---|---|---|---|
//! | `nlerp` | the turn from a to b about its centre | faster in the middle | no |
//! | `slerp`, `screw_lerp` | the turn from a to b about its centre | constant | no |
//! | `split_lerp` | the origin goes straight while the body turns | constant | on that of the moved body |
//! | `log_lerp` | the exponential of the straight line between the logarithms | varies | on that of both spaces |
//!
//! In the plane a turn has no slide, so the first three share their path, and the great arc is at constant speed.

use super::{Bivector, EvenMultivector, Motor, Rotor, Translator, kernels};
use crate::weights::{self, Weights};
use crate::{Real, alignment};

/// Interpolation: from this motion at t = 0 to another at t = 1.
///
/// The end is `other` or its negative, the same motion, whichever is nearer: where the Euclidean parts' scalar product
/// is negative, -b stands for b. So `other` = -`self` stays put, and of the two ways between motions exactly half a
/// turn apart the one to b as it stands is taken. Defined for every t as long as everything, t times the difference
/// of the ends included, is finite, else NaN. Equal ends stay put, by `screw_lerp` up to rounding errors times t.
///
/// In what follows 2 h is the angle between the two motions, h in \[0, pi/2\], and costs are for one call, beside
/// multiplications and additions.
impl<T: Real> Motor<T> {
    /// The straight line between the motors, a (1 - t) + b t, made unit again.
    ///
    /// The right choice where the ends are near or exact timing does not matter: it is the cheapest by far. It turns
    /// about the centre of the turn from a to b as [`Self::screw_lerp`] does and agrees with that at 0, 1/2 and 1;
    /// between them it lags, then leads, by up to 0.12 degrees of a turn by 45, 0.92 of 90, 8.2 of 180, for in the
    /// middle it is 1/cos(h/2)^2 times as fast as at the ends. A translation is run through at constant speed. Carrying
    /// both ends by a motion, on either side, carries the path.
    ///
    /// Cost: one square root.
    ///
    /// ```
    /// use pga_motor::pga2d::f64::{Motor, Point};
    ///
    /// let turn = |angle| Motor::about(Point::new(3.0, 0.0), angle);
    /// let middle = turn(0.0).nlerp(-turn(1.0), 0.5);
    /// assert!(middle.transform_origin().distance_to_point(turn(0.5).transform_origin()) < 1e-15);
    /// ```
    pub fn nlerp(self, other: Self, t: T) -> Self {
        between(self, aligned(self, other), t, weights::chord(t))
    }

    /// The great arc between the motors, a sin((1 - t) h)/sin h + b sin(t h)/sin h, made unit again. In the plane it is
    /// the path of [`Self::screw_lerp`], at the same speed, without logarithm and exponential.
    ///
    /// Cost: one square root, one arc tangent, three sines.
    ///
    /// ```
    /// use pga_motor::pga2d::f64::{Motor, Point};
    ///
    /// let turn = |angle| Motor::about(Point::new(3.0, 0.0), angle);
    /// assert!((turn(0.5).slerp(turn(2.5), 0.25) - turn(1.0)).norm() < 1e-15);
    /// ```
    pub fn slerp(self, other: Self, t: T) -> Self {
        let turn = self.reverse() * other;
        between(self, aligned(self, other), t, weights::great_arc(turn.e12.abs(), turn.s, t))
    }

    /// The turn from one to the other about its centre at constant speed, or the translation: a exp(t log(~a b)).
    ///
    /// The right choice where the motion itself matters: it is the geodesic, each step of t is the same motion, part of
    /// the path is the path between its ends, and carrying both ends by a motion, on either side, carries the path. For
    /// many t between the same ends take [`ScrewPath`]. A point of the body runs along an arc, not straight: for that
    /// see [`Self::split_lerp`].
    ///
    /// It starts from the nearer end, so it is exact at both, and the same from b to a.
    ///
    /// Cost: one logarithm and one exponential, that is one arc tangent and one sine with cosine.
    ///
    /// ```
    /// use pga_motor::pga2d::f64::{Motor, Point};
    ///
    /// let turn = |angle| Motor::about(Point::new(3.0, 0.0), angle);
    /// assert!((turn(0.0).screw_lerp(turn(2.0), 0.3) - turn(0.6)).norm() < 1e-15);
    /// ```
    pub fn screw_lerp(self, other: Self, t: T) -> Self {
        ScrewPath::new(self, other).at(t)
    }

    /// Turn and translation apart: the great arc between the rotors, the straight line between the translations, the
    /// motion being translator * rotor.
    ///
    /// The right choice for data that was made for it, and where the body's origin is to go straight. Which point
    /// of the body goes straight depends on where the body has its origin; carrying both ends by a motion on the left,
    /// as when the plane is moved, carries the path.
    ///
    /// Cost: one square root, one arc tangent, three sines.
    ///
    /// ```
    /// use pga_motor::pga2d::f64::{Direction, Motor, Point, Rotor, Translator};
    ///
    /// let a = Motor::IDENTITY;
    /// let b = Translator::from_vector(Direction::new(4.0, 8.0)) * Rotor::from_angle(3.0);
    /// assert!(a.split_lerp(b, 0.25).transform_origin().distance_to_point(Point::new(1.0, 2.0)) < 1e-14);
    /// ```
    pub fn split_lerp(self, other: Self, t: T) -> Self {
        let rotor = self.rotor().slerp(other.rotor(), t);
        let (start, end) = (self.translator().vector(), other.translator().vector());
        Self::from_rotor_translator(rotor, Translator::from_vector(weights::mix(start, end, t, weights::chord(t))))
    }

    /// The straight line between the logarithms: exp((1 - t) log a + t log b), with the sign of a.
    ///
    /// The right choice where motions are kept as logarithms anyway, say to blend small deviations from a rest pose,
    /// for then it is one exponential. The logarithms are those of a and b as they stand, seen from the identity: the
    /// path depends on where the origin is, and carrying both ends carries it only where both sides are carried
    /// together, a to g a ~g. Each logarithm is the short one of its own motion; of two motions that are both nearly
    /// half a turn, but in opposite senses, and so near one another, the path goes the long way, through the identity.
    /// Take [`Self::screw_lerp`] then. Where b is exactly half a turn, so that b and -b differ in their logarithms, it
    /// is that of the one nearer to a.
    ///
    /// Cost: two logarithms and one exponential, that is two arc tangents and one sine with cosine.
    ///
    /// ```
    /// use pga_motor::pga2d::f64::{Motor, Point};
    ///
    /// let a = Motor::about(Point::new(1.0, 0.0), 1.0);
    /// let b = Motor::about(Point::new(0.0, 2.0), 2.0);
    /// let middle = ((a.log() + b.log()) * 0.5).exp();
    /// assert!((a.log_lerp(b, 0.5) - middle).norm() < 1e-15);
    /// ```
    pub fn log_lerp(self, other: Self, t: T) -> Self {
        let near = aligned(self, other);
        let motor = weights::mix(self.log(), near.log(), t, weights::chord(t)).exp();
        if self.s < T::ZERO { -motor } else { motor }
    }
}

/// Interpolation: from this rotation at t = 0 to another at t = 1, or to its negative, the same rotation, whichever is
/// nearer. Outside \[0, 1\] it extrapolates.
impl<T: Real> Rotor<T> {
    /// The straight line between the rotors made unit again: the great arc, faster in the middle. See [`Motor::nlerp`].
    pub fn nlerp(self, other: Self, t: T) -> Self {
        let other = if kernels::rotor_scalar_product_rotor(self, other) < T::ZERO { -other } else { other };
        between(self, other, t, weights::chord(t)).rotor()
    }

    /// The great arc at constant speed: r exp(t log(~r other)). See [`Motor::slerp`].
    ///
    /// ```
    /// use pga_motor::pga2d::f64::Rotor;
    ///
    /// let third = Rotor::IDENTITY.slerp(Rotor::from_angle(1.5), 1.0 / 3.0);
    /// assert!((third.angle() - 0.5).abs() < 1e-15);
    /// ```
    pub fn slerp(self, other: Self, t: T) -> Self {
        let turn = self.reverse() * other;
        let other = if turn.s < T::ZERO { -other } else { other };
        between(self, other, t, weights::great_arc(turn.e12.abs(), turn.s, t)).rotor()
    }
}

/// The turn or translation from one motion to another, for many t: what [`Motor::screw_lerp`] works out once for all t
/// is kept, and the results are the same, bit for bit, for about half the cost. Named as in space.
///
/// ```
/// use pga_motor::pga2d::ScrewPath;
/// use pga_motor::pga2d::f64::{Motor, Point};
///
/// let end = Motor::about(Point::new(1.0, 0.0), 2.0);
/// let path = ScrewPath::new(Motor::IDENTITY, end);
/// assert_eq!((path.at(0.0), path.at(1.0)), (Motor::IDENTITY, end));
/// assert_eq!(path.at(0.7), Motor::IDENTITY.screw_lerp(end, 0.7));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScrewPath<T> {
    start: Motor<T>,
    end: Motor<T>,
    generator: Bivector<T>,
}

impl<T: Real> ScrewPath<T> {
    /// The path from a at t = 0 the short way to b at t = 1.
    ///
    /// Cost: one logarithm.
    pub fn new(a: Motor<T>, b: Motor<T>) -> Self {
        let between = a.reverse() * b;
        Self { start: a, end: if between.s < T::ZERO { -b } else { b }, generator: between.log() }
    }

    /// The motion at t, a exp(t log(~a b)), worked out from the nearer end. Outside \[0, 1\] the turn goes on. NaN
    /// where something is not finite.
    ///
    /// Cost: one exponential.
    pub fn at(self, t: T) -> Motor<T> {
        if t <= T::from_ratio(1, 2) {
            self.start * (self.generator * t).exp()
        } else {
            self.end * (self.generator * (t - T::ONE)).exp()
        }
    }

    /// Where it starts: a.
    #[inline]
    pub fn start(self) -> Motor<T> {
        self.start
    }

    /// Where it ends: b, or -b, the same motion, where that is nearer to a.
    #[inline]
    pub fn end(self) -> Motor<T> {
        self.end
    }

    /// log(~a b): the motion in one unit of t, seen from the moved body; the same all along the path.
    #[inline]
    pub fn generator(self) -> Bivector<T> {
        self.generator
    }
}

/// The weighted mean of motors, made a motor again: of two [`Motor::nlerp`], of more its like.
///
/// Only the proportions of the weights matter; they need not add up to 1. Negative ones extrapolate. m and -m are the
/// same motion, so each input enters with the sign that brings it nearer to a fixed reference: the input of greatest
/// weight, of equal ones the one that comes last in the order of coefficients. So the order of the inputs changes the
/// result by rounding only. Carrying all inputs by a motion, on either side, carries the mean, as long as the reference
/// stays the same input.
///
/// The right choice to mix poses or bones: the mean does not depend on where the origin is. With many motions far apart
/// it is no exact mean of their angles.
///
/// `None` where there is no mean: no inputs, weights that add up to 0, motions that cancel, which takes negative
/// weights; and where something, the result included, is not finite. Sums below the rounding errors that may be in them
/// count as 0.
///
/// Cost: one square root, two quotients for each input.
///
/// ```
/// use pga_motor::pga2d::blend;
/// use pga_motor::pga2d::f64::{Direction, Motor, Point, Translator};
///
/// let by = |x, y| Motor::from(Translator::from_vector(Direction::new(x, y)));
/// let mean = blend(&[(by(4.0, 0.0), 1.0), (-by(0.0, 4.0), 1.0), (by(0.0, 0.0), 2.0)]).unwrap();
/// assert_eq!(mean.transform_origin(), Point::new(1.0, 1.0));
/// assert_eq!(blend(&[(by(4.0, 0.0), 1.0), (by(0.0, 4.0), -1.0)]), None);
/// ```
pub fn blend<T: Real>(inputs: &[(Motor<T>, T)]) -> Option<Motor<T>> {
    let sum = alignment::aligned_sum(inputs.iter().copied(), kernels::motor_scalar_product_motor)?;
    let sum = EvenMultivector::from(sum);
    if sum.norm() <= alignment::rounding(inputs.len()) {
        return None;
    }
    let motor = sum.over_norm();
    motor.is_finite().then_some(motor)
}

/// A joint moved from its rest pose towards an animated one: rest exp(weight log(~rest animated)), as
/// [`Motor::screw_lerp`]. Weight 0 is `rest`, 1 is `animated`, more exaggerates, less than 0 moves away from it.
///
/// ```
/// use pga_motor::pga2d::f64::{Motor, Point};
/// use pga_motor::pga2d::interpolate_joint;
///
/// let turn = |angle| Motor::about(Point::new(3.0, 0.0), angle);
/// assert!((interpolate_joint(turn(0.5), turn(1.5), 0.5) - turn(1.0)).norm() < 1e-15);
/// ```
pub fn interpolate_joint<T: Real>(rest: Motor<T>, animated: Motor<T>, weight: T) -> Motor<T> {
    rest.screw_lerp(animated, weight)
}

/// The motor or its negative, the same motion, whichever is nearer to a.
fn aligned<T: Real>(a: Motor<T>, motor: Motor<T>) -> Motor<T> {
    if kernels::motor_scalar_product_motor(a, motor) < T::ZERO { -motor } else { motor }
}

/// The weighted sum of the ends made a motor; between them its norm is near 1.
fn between<T: Real>(
    a: impl Into<EvenMultivector<T>>,
    b: impl Into<EvenMultivector<T>>,
    t: T,
    weights: Weights<T>,
) -> Motor<T> {
    let sum = weights::mix(a.into(), b.into(), t, weights);
    if weights::is_between(t) {
        return sum.over_norm();
    }
    sum.normalize().unwrap_or_else(|| (sum * T::from_f64(f64::NAN)).over_norm())
}

#[cfg(test)]
mod tests;
