//! Motions between motions.
//!
//! Every way here goes the short way, from a at t = 0 to b at t = 1, or to -b, which is the same motion; beyond 0
//! and 1 it extrapolates. They differ in the path, the speed and the cost:
//!
//! | | path | speed | depends on a choice of origin |
//! |---|---|---|---|
//! | `nlerp` | turn and slide about the axis of the screw from a to b | faster in the middle | no |
//! | `slerp` | turn and slide about the axis of the screw from a to b | turn constant, slide eased | no |
//! | `screw_lerp` | the screw from a to b | constant | no |
//! | `split_lerp` | the origin goes straight, the turn takes the great arc | constant | on that of the moved body |
//! | `log_lerp` | the exponential of the straight line between the logarithms | varies | on that of both spaces |

use crate::weights::{self, Weights};
use crate::{EvenMultivector, Line, Motor, Real, Rotor, Translator, alignment, kernels};

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
    /// The straight line between the motors, a (1 - t) + b t, made a motor again.
    ///
    /// The right choice where the ends are near or exact timing does not matter, as between neighbouring keys of a
    /// clip: it is the cheapest by far. It turns about the axis of the screw from a to b as [`Self::screw_lerp`] does
    /// and agrees with that at 0, 1/2 and 1; between them it lags, then leads, by up to 0.12 degrees of a turn by 45,
    /// 0.92 of 90, 8.2 of 180, for in the middle it is 1/cos(h/2)^2 times as fast as at the ends. A translation is run
    /// through at constant speed. Carrying both ends by a motion, on either side, carries the path.
    ///
    /// Cost: one square root.
    ///
    /// ```
    /// use pga_motor::f64::{Direction, Motor, Point};
    ///
    /// let axis = Point::new(1.0, 0.0, 0.0) & Direction::Z;
    /// let turn = |angle| Motor::from_screw(axis, angle, 0.0).unwrap();
    /// let middle = turn(0.0).nlerp(-turn(1.0), 0.5);
    /// assert!((middle - turn(0.5)).norm() < 1e-15);
    /// ```
    pub fn nlerp(self, other: Self, t: T) -> Self {
        between(self, aligned(self, other), t, weights::chord(t))
    }

    /// The straight line between the motors with the weights of the great arc between their rotors,
    /// a sin((1 - t) h)/sin h + b sin(t h)/sin h, made a motor again.
    ///
    /// The right choice where turns must have constant speed and the slide along the screw's axis need not, or for
    /// rotors alone: for a turn without slide it is [`Self::screw_lerp`], cheaper. Of a slide it has run through
    /// (1 + sin((2 t - 1) h)/sin h)/2 at t, so it eases in and out where the turn is large. Carrying both ends by a
    /// motion, on either side, carries the path.
    ///
    /// The angle h comes from both its sine and its cosine, which need the product ~a b and not a b; and on the Study
    /// quadric, which the weights lead off for a screw, the sum is brought back.
    ///
    /// Cost: two square roots, one arc tangent, three sines.
    ///
    /// ```
    /// use pga_motor::f64::{Motor, Rotor};
    ///
    /// let turn = |angle| Motor::from(Rotor::about_x(angle));
    /// assert!((turn(0.5).slerp(turn(2.5), 0.25) - turn(1.0)).norm() < 1e-15);
    /// ```
    pub fn slerp(self, other: Self, t: T) -> Self {
        let turn = self.reverse() * other;
        between(self, aligned(self, other), t, weights::great_arc(bivector_norm(turn.rotor()), turn.s, t))
    }

    /// The screw from one to the other at constant speed: a exp(t log(~a b)).
    ///
    /// The right choice where the motion itself matters, as of rigid bodies, tools and cameras: it is the geodesic,
    /// each step of t is the same motion, part of the path is the path between its ends, and carrying both ends by a
    /// motion, on either side, carries the path. For many t between the same ends take [`ScrewPath`], for about half
    /// the cost. A point of the body runs along a helix, not straight: for that see [`Self::split_lerp`].
    ///
    /// It starts from the nearer end, so it is exact at both, and the same from b to a.
    ///
    /// Cost: one logarithm and one exponential, that is two square roots, one arc tangent, one sine with cosine.
    ///
    /// ```
    /// use pga_motor::f64::{Direction, Motor, Point};
    ///
    /// let axis = Point::new(1.0, 0.0, 0.0) & Direction::Z;
    /// let screw = |part: f64| Motor::from_screw(axis, 2.0 * part, 6.0 * part).unwrap();
    /// assert!((screw(0.0).screw_lerp(screw(1.0), 0.3) - screw(0.3)).norm() < 1e-15);
    /// ```
    pub fn screw_lerp(self, other: Self, t: T) -> Self {
        ScrewPath::new(self, other).at(t)
    }

    /// Turn and translation apart: the great arc between the rotors, the straight line between the translations, the
    /// motion being translator * rotor. glTF calls this LINEAR.
    ///
    /// The right choice for data that was made for it, and where the body's origin is to go straight. Which point
    /// of the body goes straight depends on where the body has its origin; carrying both ends by a motion on the left,
    /// as when the world is moved, carries the path.
    ///
    /// Cost: two square roots, one arc tangent, three sines.
    ///
    /// ```
    /// use pga_motor::f64::{Direction, Motor, Point, Rotor, Translator};
    ///
    /// let a = Motor::IDENTITY;
    /// let b = Translator::from_vector(Direction::new(4.0, 8.0, 0.0)) * Rotor::about_z(3.0);
    /// assert!(a.split_lerp(b, 0.25).transform_origin().distance_to_point(Point::new(1.0, 2.0, 0.0)) < 1e-14);
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
    /// path depends on where the origin is and which way the axes point, and carrying both ends carries it only where
    /// both sides are carried together, a to g a ~g. Each logarithm is the short one of its own motion; of two motions
    /// that are both nearly half a turn, but in opposite senses, and so near one another, the path goes the long way,
    /// through the identity. Take [`Self::screw_lerp`] then. Where b is exactly half a turn, so that b and -b differ in
    /// their logarithms, it is that of the one nearer to a.
    ///
    /// Cost: two logarithms and one exponential, that is three square roots, two arc tangents, one sine with cosine.
    ///
    /// ```
    /// use pga_motor::f64::{Motor, Rotor};
    ///
    /// let a = Motor::from(Rotor::about_x(1.0));
    /// let b = Motor::from(Rotor::about_y(1.0));
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
    /// use pga_motor::f64::Rotor;
    ///
    /// let third = Rotor::IDENTITY.slerp(Rotor::about_z(1.5), 1.0 / 3.0);
    /// assert!((third.e12 - Rotor::about_z(0.5).e12).abs() < 1e-15);
    /// ```
    pub fn slerp(self, other: Self, t: T) -> Self {
        let turn = self.reverse() * other;
        let other = if turn.s < T::ZERO { -other } else { other };
        between(self, other, t, weights::great_arc(bivector_norm(turn), turn.s, t)).rotor()
    }
}

/// The screw from one motion to another, for many t: what [`Motor::screw_lerp`] works out once for all t is kept, and
/// the results are the same, bit for bit, for about half the cost.
///
/// ```
/// use pga_motor::ScrewPath;
/// use pga_motor::f64::{Direction, Motor, Point};
///
/// let axis = Point::new(1.0, 0.0, 0.0) & Direction::Z;
/// let end = Motor::from_screw(axis, 2.0, 6.0).unwrap();
/// let path = ScrewPath::new(Motor::IDENTITY, end);
/// assert_eq!((path.at(0.0), path.at(1.0)), (Motor::IDENTITY, end));
/// assert_eq!(path.at(0.7), Motor::IDENTITY.screw_lerp(end, 0.7));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScrewPath<T> {
    start: Motor<T>,
    end: Motor<T>,
    generator: Line<T>,
}

impl<T: Real> ScrewPath<T> {
    /// The path from a at t = 0 the short way to b at t = 1.
    ///
    /// Cost: one logarithm.
    pub fn new(a: Motor<T>, b: Motor<T>) -> Self {
        let between = a.reverse() * b;
        Self { start: a, end: if between.s < T::ZERO { -b } else { b }, generator: between.log() }
    }

    /// The motion at t, a exp(t log(~a b)), worked out from the nearer end. Outside \[0, 1\] the screw goes on. NaN
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
    pub fn generator(self) -> Line<T> {
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
/// use pga_motor::blend;
/// use pga_motor::f64::{Direction, Motor, Point, Translator};
///
/// let by = |x, y| Motor::from(Translator::from_vector(Direction::new(x, y, 0.0)));
/// let mean = blend(&[(by(4.0, 0.0), 1.0), (-by(0.0, 4.0), 1.0), (by(0.0, 0.0), 2.0)]).unwrap();
/// assert_eq!(mean.transform_origin(), Point::new(1.0, 1.0, 0.0));
/// assert_eq!(blend(&[(by(4.0, 0.0), 1.0), (by(0.0, 4.0), -1.0)]), None);
/// ```
pub fn blend<T: Real>(inputs: &[(Motor<T>, T)]) -> Option<Motor<T>> {
    blend_each(inputs.iter().copied())
}

/// [`blend`] of inputs that need not stand in one place.
pub(crate) fn blend_each<T: Real>(inputs: impl Iterator<Item = (Motor<T>, T)> + Clone) -> Option<Motor<T>> {
    let count = inputs.clone().count();
    let sum = alignment::aligned_sum(inputs, kernels::motor_scalar_product_motor)?;
    let sum = EvenMultivector::from(sum);
    if sum.norm() <= alignment::rounding(count) {
        return None;
    }
    let motor = sum.over_norm();
    motor.is_finite().then_some(motor)
}

/// A joint moved from its rest pose towards an animated one: rest exp(weight log(~rest animated)), as
/// [`Motor::screw_lerp`]. Weight 0 is `rest`, 1 is `animated`, more exaggerates, less than 0 moves away from it.
///
/// ```
/// use pga_motor::f64::{Motor, Rotor};
/// use pga_motor::interpolate_joint;
///
/// let (rest, animated) = (Motor::from(Rotor::about_x(0.5)), Motor::from(Rotor::about_x(1.5)));
/// let half = interpolate_joint(rest, animated, 0.5);
/// assert!((half - Motor::from(Rotor::about_x(1.0))).norm() < 1e-15);
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

/// The sine of half the angle of a turn.
fn bivector_norm<T: Real>(Rotor { e23, e31, e12, .. }: Rotor<T>) -> T {
    Line { e23, e31, e12, ..Line::ZERO }.norm()
}

#[cfg(test)]
mod tests;
