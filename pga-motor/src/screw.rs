//! What a motion is: a turn about an axis and a slide along it (Chasles).

use crate::{Line, Motor, Point, Real, UnitLine, kernels};

/// A motion as the turn about a line and the slide along it; any motion is one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Screw<T> {
    /// The line about which it turns and along which it slides; of a translation the parallel through the origin.
    /// `None` for the identity.
    pub axis: Option<UnitLine<T>>,
    /// In radians, right-handed about the axis. Of a motor's screw in \[0, pi\].
    pub angle: T,
    /// How far it slides along the axis, negative against it; in the caller's unit of length.
    pub distance: T,
}

/// What kind of motion it is, wherever it is looked at from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum MotionKind {
    /// Nothing moves.
    Identity,
    /// A turn about an axis.
    Rotation,
    /// A slide without a turn.
    Translation,
    /// A turn about an axis and a slide along it.
    Screw,
}

impl<T: Real> Screw<T> {
    /// The motor of this motion, as [`Motor::from_screw`].
    ///
    /// `None` where there is no axis although there is an angle or a distance, and where something is not finite.
    pub fn motor(self) -> Option<Motor<T>> {
        match self.axis {
            Some(axis) => Motor::from_screw(axis.into(), self.angle, self.distance),
            None => (self.kind() == MotionKind::Identity).then_some(Motor::IDENTITY),
        }
    }

    /// The kind of motion, exactly: any angle or distance but 0 counts. What is NaN counts as a screw.
    pub fn kind(self) -> MotionKind {
        kind(self.angle == T::ZERO, self.distance == T::ZERO)
    }

    fn nan() -> Self {
        let nan = T::from_f64(f64::NAN);
        Self { axis: None, angle: nan, distance: nan }
    }
}

fn kind(turnless: bool, slideless: bool) -> MotionKind {
    match (turnless, slideless) {
        (true, true) => MotionKind::Identity,
        (true, false) => MotionKind::Translation,
        (false, true) => MotionKind::Rotation,
        (false, false) => MotionKind::Screw,
    }
}

impl<T: Real> Motor<T> {
    /// The axis, the angle and the slide of the motion, the short way: the angle is in \[0, pi\]. Accurate at every
    /// angle, however small; m and -m have the same, but for half a turn, where either sense is as short.
    ///
    /// Of a translation the axis is the line through the origin along it, the angle 0, the distance its length. So is
    /// that of a turn by so little, about an axis so far away, that the moment of the axis is beyond the range of the
    /// numbers. The identity has no axis. Angle and distance are NaN where something is not finite.
    ///
    /// ```
    /// use pga_motor::f64::{Direction, Motor, Point};
    ///
    /// let axis = Point::new(1.0, 0.0, 0.0) & Direction::Z;
    /// let screw = Motor::from_screw(axis, 2.0, -3.0).unwrap().screw();
    /// assert!((screw.angle - 2.0).abs() < 1e-15 && (screw.distance + 3.0).abs() < 1e-15);
    /// assert!(screw.axis.unwrap().distance_to_point(Point::new(1.0, 0.0, 7.0)) < 1e-15);
    /// ```
    pub fn screw(self) -> Screw<T> {
        if !self.is_finite() {
            return Screw::nan();
        }
        let log = self.log();
        match log.reverse().normalize() {
            Some(axis) => Screw { axis: Some(axis), angle: self.angle(), distance: slide(log, axis) },
            None => self.translation_screw(),
        }
    }

    /// The kind of motion, to tolerances: for the angle in radians, for lengths in the caller's unit.
    ///
    /// A motion whose angle is within its tolerance counts as no turn: it is the identity where it moves the origin by
    /// no more than the other tolerance, else a translation. Any other motion is a rotation where its slide along the
    /// axis is within the tolerance, else a screw; where the axis is makes no difference. With tolerances 0 that is
    /// exact for the motor as it is, rounding errors included. A motor that is not finite is a screw.
    ///
    /// ```
    /// use pga_motor::MotionKind;
    /// use pga_motor::f64::{Direction, Motor, Point, Rotor, Translator};
    ///
    /// let turn = Motor::from(Rotor::about_z(1.0));
    /// let elsewhere = Translator::from_vector(Direction::new(3.0, 0.0, 0.0)).transform_motor(turn);
    /// assert_eq!(elsewhere.kind(1e-12, 1e-12), MotionKind::Rotation);
    /// let up = Translator::from_vector(Direction::new(0.0, 0.0, 2.0));
    /// assert_eq!((up * elsewhere).kind(1e-12, 1e-12), MotionKind::Screw);
    /// assert_eq!((turn * turn.inverse()).kind(1e-12, 1e-12), MotionKind::Identity);
    /// ```
    pub fn kind(self, angle_tolerance: T, distance_tolerance: T) -> MotionKind {
        let screw = self.screw();
        let turnless = screw.angle <= angle_tolerance;
        let length = if turnless { self.translator().vector().norm() } else { screw.distance.abs() };
        kind(turnless, length <= distance_tolerance)
    }

    /// The angle of the turn, in \[0, pi\]; the arc tangent keeps it there.
    fn angle(self) -> T {
        let direction = Line { e23: self.e23, e31: self.e31, e12: self.e12, ..Line::ZERO };
        let half = direction.norm().atan2(self.s.abs());
        half + half
    }

    fn translation_screw(self) -> Screw<T> {
        let vector = self.translator().vector();
        let axis = UnitLine::from_point_and_direction(Point::ORIGIN, vector);
        Screw { axis, angle: T::ZERO, distance: vector.norm() }
    }
}

/// The slide along the axis in the logarithm, which has half of it, and in which positive translations are negative.
fn slide<T: Real>(log: Line<T>, axis: UnitLine<T>) -> T {
    let moment = log.dual().direction();
    T::from_ratio(-2, 1) * kernels::direction_dot_direction(moment, axis.direction())
}

#[cfg(test)]
mod tests;
