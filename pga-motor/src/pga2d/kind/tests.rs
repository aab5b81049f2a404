//! Centres, angles and kinds of motions of the plane.

use super::*;
use crate::pga2d::{Direction, Translator};
use core::f64::consts::PI;

#[test]
fn a_turn_has_its_centre_and_angle_at_every_size() {
    let center = Point::new(3.0, -1.0);
    for angle in [1e-300, 1e-20, 1e-8, 0.5, 3.0, PI, -2.0, -1e-9] {
        for motor in [Motor::about(center, angle), -Motor::about(center, angle)] {
            // Sine, its products with the coordinates, and one quotient each.
            assert!(motor.center().unwrap().distance_to_point(center) <= 16.0 * f64::EPSILON, "{angle}");
            // Half a turn is one either way.
            assert!((motor.angle().abs() - angle.abs()).abs() <= 4.0 * f64::EPSILON * angle.abs(), "{angle}");
            assert!(angle == PI || motor.angle().signum() == angle.signum());
            assert_eq!(motor.kind(0.0, 0.0), MotionKind::Rotation);
        }
    }
}

#[test]
fn a_translation_has_no_centre() {
    let step = Motor::from(Translator::from_vector(Direction::new(3.0, 4.0)));
    assert_eq!((step.center(), step.angle()), (None, 0.0));
    assert_eq!(step.kind(0.0, 0.0), MotionKind::Translation);
    assert_eq!(step.kind(0.0, 5.0), MotionKind::Identity);
    assert_eq!((-Motor::<f32>::IDENTITY).kind(0.0, 0.0), MotionKind::Identity);
    assert_eq!(Motor::about(Point::new(1e9, 0.0), 1e-9).kind(1e-8, 0.5), MotionKind::Translation);
}

#[test]
fn what_is_not_finite_has_no_centre_and_no_simple_kind() {
    let motor = Motor { e01: f64::NAN, ..Motor::IDENTITY };
    assert_eq!((motor.center(), motor.kind(1.0, 1.0)), (None, MotionKind::Rotation));
    assert!(Motor { e12: f64::NAN, ..Motor::IDENTITY }.angle().is_nan());
}
