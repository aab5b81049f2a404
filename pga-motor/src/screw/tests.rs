//! Screws from motors and back.
//!
//! A tolerance of 16 EPSILON, relative where a number is compared alone: log and the screw's numbers are at most 16
//! roundings in a row, each half an EPSILON, with factors up to 2.

use super::*;
use crate::{Direction, Rotor, Translator};
use core::f64::consts::PI;

const ROUNDING: f64 = 16.0;

fn axis() -> UnitLine<f64> {
    let direction = Direction::new(1.0, -2.0, 2.0) / 3.0;
    UnitLine::from_point_and_direction(Point::new(2.0, 1.0, -1.0), direction).unwrap()
}

#[track_caller]
fn assert_close(found: f64, expected: f64, scale: f64) {
    let off = (found - expected).abs() / f64::EPSILON / scale;
    assert!(off <= ROUNDING, "expected {expected:e}, found {found:e}, off by {off} EPSILON");
}

#[track_caller]
fn assert_axis(found: Option<UnitLine<f64>>, expected: UnitLine<f64>, scale: f64) {
    let found = found.expect("there is an axis");
    found.to_array().iter().zip(expected.to_array()).for_each(|(a, b)| assert_close(*a, b, scale));
}

#[test]
fn screw_is_what_the_motor_was_made_of_at_every_angle() {
    for angle in [1e-300, 1e-160, 1e-20, 1e-8, 1e-3, 0.5, 2.0, 3.1] {
        for distance in [0.0, -1e-9, 3.0, 1e6] {
            let motor = Motor::from_screw(axis().into(), angle, distance).unwrap();
            for motor in [motor, -motor] {
                let screw = motor.screw();
                assert_close(screw.angle, angle, angle);
                // The motor keeps the moment, times the angle, beside the slide: rounding in one is seen in both.
                let (moment, turned) = (4.0, 4.0 * angle);
                assert_close(screw.distance, distance, distance.abs() + turned);
                assert_axis(screw.axis, axis(), 2.0 * moment + distance.abs() / angle);
            }
        }
    }
}

#[test]
fn half_turns_have_their_axis_up_to_its_sense() {
    for distance in [0.0, 3.0] {
        let motor = Motor { s: 0.0, ..Motor::from(axis()) } * Motor::from_screw(axis().into(), 0.0, distance).unwrap();
        for motor in [motor, -motor] {
            let screw = motor.screw();
            assert_close(screw.angle, PI, 1.0);
            assert!(screw.angle <= PI);
            assert_close(screw.distance.abs(), distance, 4.0);
            let sense = if screw.distance < 0.0 || screw.axis.unwrap().e31 > 0.0 { axis().reverse() } else { axis() };
            assert_axis(screw.axis, sense, 8.0);
        }
    }
}

#[test]
fn slide_of_a_turn_about_z_is_exact() {
    let motor = Motor::from_screw(Point::ORIGIN & Direction::Z, 0.5, -3.0).unwrap();
    let screw = motor.screw();
    assert_eq!(screw.axis, Some(UnitLine::new(0.0, 0.0, 1.0, 0.0, 0.0, 0.0)));
    assert_close(screw.distance, -3.0, 3.0);
}

#[test]
fn translation_is_a_slide_along_a_line_through_the_origin() {
    let motor = Motor::from(Translator::from_vector(Direction::new(2.0, -4.0, 4.0)));
    for motor in [motor, -motor] {
        let screw = motor.screw();
        assert_eq!((screw.angle, screw.distance), (0.0, 6.0));
        assert_axis(screw.axis, UnitLine::new(1.0 / 3.0, -2.0 / 3.0, 2.0 / 3.0, 0.0, 0.0, 0.0), 1.0);
        assert_eq!(screw.kind(), MotionKind::Translation);
    }
    // So short a turn about an axis so far away that its moment is beyond the range.
    let bent = Motor { e23: 1e-310, ..motor };
    assert_eq!(bent.screw(), motor.screw());
}

#[test]
fn identity_has_no_axis() {
    for motor in [Motor::IDENTITY, -Motor::IDENTITY] {
        let screw: Screw<f64> = motor.screw();
        assert_eq!(screw, Screw { axis: None, angle: 0.0, distance: 0.0 });
        assert_eq!(screw.kind(), MotionKind::Identity);
        assert_eq!(screw.motor(), Some(Motor::IDENTITY));
    }
}

#[test]
fn screw_gives_its_motor_back() {
    for angle in [0.0, 1e-300, 1e-8, 0.5, 2.0, 3.1, PI] {
        for distance in [0.0, -2.0, 3.0] {
            let motor = Motor::from_screw(axis().into(), angle, distance).unwrap();
            let back = motor.screw().motor().unwrap();
            let difference = [back - motor, back + motor].map(|sum| sum.norm() + sum.ideal_norm());
            // The half turn may come back with the other sense, which is another sign.
            assert_close(difference[0].min(difference[1]), 0.0, 8.0);
        }
    }
    assert_eq!(Screw { axis: None, angle: 1.0, distance: 0.0 }.motor(), None);
    assert_eq!(Screw { axis: Some(axis()), angle: f64::NAN, distance: 0.0 }.motor(), None);
}

#[test]
fn what_is_not_finite_has_no_screw() {
    for motor in [Motor { e02: f64::NAN, ..Motor::IDENTITY }, Motor { e12: f64::INFINITY, ..Motor::IDENTITY }] {
        let screw = motor.screw();
        assert!(screw.axis.is_none() && screw.angle.is_nan() && screw.distance.is_nan());
        assert_eq!((screw.motor(), screw.kind(), motor.kind(1.0, 1.0)), (None, MotionKind::Screw, MotionKind::Screw));
    }
}

#[test]
fn kind_is_told_by_angle_then_length() {
    let kind = |angle: f64, distance: f64| {
        Motor::from_screw(Point::new(0.0, 1.0, 0.0) & Direction::Z, angle, distance).unwrap().kind(1e-6, 1e-3)
    };
    assert_eq!(kind(0.0, 0.0), MotionKind::Identity);
    assert_eq!(kind(0.9e-6, 0.9e-3), MotionKind::Identity);
    assert_eq!(kind(0.9e-6, 1.1e-3), MotionKind::Translation);
    assert_eq!(kind(1.1e-6, 0.9e-3), MotionKind::Rotation);
    assert_eq!(kind(-2.0, -1.1e-3), MotionKind::Screw);
    // A turn within the tolerance about an axis 1e9 away moves the origin by more than the tolerance.
    let far = Motor::from_screw(Point::new(0.0, 1e9, 0.0) & Direction::Z, 0.9e-6, 0.0).unwrap();
    assert_eq!(far.kind(1e-6, 1e-3), MotionKind::Translation);
    let exact = |motor: Motor<f64>| motor.kind(0.0, 0.0);
    assert_eq!(exact(Motor::from(Rotor::about_x(1e-300))), MotionKind::Rotation);
    assert_eq!(exact(Translator::from_vector(Direction::new(0.0, 5e-324 * 2.0, 0.0)).into()), MotionKind::Translation);
    assert_eq!(exact(-Motor::IDENTITY), MotionKind::Identity);
}

#[test]
fn single_precision_works_alike() {
    let motor = Motor::<f32>::from_screw(Point::new(1.0, 0.0, 0.0) & Direction::Z, 2.0, -3.0).unwrap();
    let screw = motor.screw();
    assert!((screw.angle - 2.0).abs() <= 16.0 * f32::EPSILON && (screw.distance + 3.0).abs() <= 48.0 * f32::EPSILON);
    assert!(screw.axis.unwrap().distance_to_point(Point::new(1.0, 0.0, 5.0)) <= 80.0 * f32::EPSILON);
}
