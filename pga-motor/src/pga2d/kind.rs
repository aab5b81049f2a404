//! What a motion of the plane is: a turn about a point, or a translation.

use super::{EvenMultivector, Motor, Point};
use crate::Real;

/// What kind of motion of the plane it is, wherever it is looked at from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum MotionKind {
    /// Nothing moves.
    Identity,
    /// A turn about a point.
    Rotation,
    /// A move without a turn.
    Translation,
}

impl<T: Real> Motor<T> {
    /// The point about which the motion turns, which stays where it is.
    ///
    /// `None` where there is no such point, or not just one: for translations and the identity, and where something is
    /// not finite, as for turns by so little that the centre is beyond the range of the numbers.
    ///
    /// ```
    /// use pga_motor::pga2d::f64::{Motor, Point};
    ///
    /// let motor = Motor::about(Point::new(3.0, 1.0), 2.0);
    /// assert!(motor.center().unwrap().distance_to_point(Point::new(3.0, 1.0)) < 1e-15);
    /// assert!((motor.angle() - 2.0).abs() < 1e-15);
    /// assert_eq!(Motor::IDENTITY.center(), None);
    /// ```
    pub fn center(self) -> Option<Point<T>> {
        EvenMultivector::from(self).bivector().to_point()
    }

    /// The angle of the turn the short way, in \[-pi, pi\] radians, counter-clockwise; m and -m have the same. 0 for
    /// translations. NaN in gives NaN out.
    pub fn angle(self) -> T {
        self.rotor().angle()
    }

    /// The kind of motion, to tolerances: for the angle in radians, for lengths in the caller's unit.
    ///
    /// A motion whose angle is within its tolerance counts as no turn: it is the identity where it moves the origin by
    /// no more than the other tolerance, else a translation. Any other motion is a rotation, and so is one that is not
    /// finite.
    ///
    /// ```
    /// use pga_motor::pga2d::MotionKind;
    /// use pga_motor::pga2d::f64::{Direction, Motor, Point, Translator};
    ///
    /// let turn = Motor::about(Point::new(3.0, 1.0), 2.0);
    /// assert_eq!(turn.kind(1e-12, 1e-12), MotionKind::Rotation);
    /// assert_eq!((turn * turn.inverse()).kind(1e-12, 1e-12), MotionKind::Identity);
    /// let step = Motor::from(Translator::from_vector(Direction::X));
    /// assert_eq!(step.kind(1e-12, 1e-12), MotionKind::Translation);
    /// ```
    pub fn kind(self, angle_tolerance: T, distance_tolerance: T) -> MotionKind {
        let turnless = self.angle().abs() <= angle_tolerance && self.is_finite();
        let length = self.translator().vector().norm();
        match (turnless, length <= distance_tolerance) {
            (false, _) => MotionKind::Rotation,
            (true, true) => MotionKind::Identity,
            (true, false) => MotionKind::Translation,
        }
    }
}

#[cfg(test)]
mod tests;
