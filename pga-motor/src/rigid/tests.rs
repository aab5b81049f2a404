//! Matrices and quaternions, there and back, and everything that is refused.
//!
//! Tolerance: an entry of a matrix is off by at most 4 EPSILON, what comes of it by as much again and the roundings of
//! a root and two products; with translations up to 10, 16 * 10 EPSILON.

use super::*;
use crate::Point;
use alloc::string::ToString;
use alloc::vec::Vec;
use core::f64::consts::PI;

const ROUNDING: f64 = 160.0;

type Columns = [[f64; 4]; 4];

const IDENTITY: Columns = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]];

fn axes() -> Vec<Direction<f64>> {
    let mut axes = Vec::new();
    for x in [-1.0, -1e-3, 0.0, 1e-9, 1.0] {
        for y in [-1.0, 0.0, 0.7, 1e-9] {
            for z in [-0.5, 0.0, 1e-200, 1.0] {
                axes.extend(Direction::new(x, y, z).normalize());
            }
        }
    }
    axes
}

fn motors() -> impl Iterator<Item = Motor<f64>> {
    let angles = [0.0, 1e-12, 1e-8, 0.3, 2.0, 2.2, 3.0, PI - 1e-8, PI, PI + 1e-8, 5.0];
    let step = Translator::from_vector(Direction::new(1.0, -7.0, 4.0));
    let turns = move |axis| angles.map(|angle| step * Rotor::from_axis_angle(axis, angle).unwrap());
    axes().into_iter().flat_map(turns)
}

fn off<T: Real>(found: Motor<T>, expected: Motor<T>) -> f64 {
    let error = |sum: EvenMultivector<T>| (sum.norm() + sum.ideal_norm()).to_f64() / T::EPSILON.to_f64();
    error(found - expected).min(error(found + expected))
}

#[test]
fn matrices_give_their_motion_back_at_every_angle_and_axis() {
    for motor in motors() {
        let back = Motor::from_columns(motor.to_matrix().to_columns()).unwrap();
        assert!(off(back, motor) <= ROUNDING, "{motor}: {back}");
        assert!(back.s >= 0.0 && back.is_unit(ROUNDING * f64::EPSILON));
        let single = motor.map(|coefficient| coefficient as f32);
        let back = Motor::from_columns(single.to_matrix().to_columns()).unwrap();
        assert!(off(back, single) <= ROUNDING, "{single}: {back}");
    }
}

#[test]
fn small_turns_keep_their_digits_through_matrices() {
    // The matrix has the sine of the angle, so a turn of 1e-20 is in it to the last digit.
    let motor = Motor::from(Rotor::about_y(1e-20));
    let back = Motor::from_columns(motor.to_matrix().to_columns()).unwrap();
    assert!((back.e31 / motor.e31 - 1.0).abs() <= 4.0 * f64::EPSILON);
}

#[test]
fn exact_half_turns_are_exact() {
    for (axis, columns) in [
        (Direction::X, [[1.0, 0.0, 0.0, 0.0], [0.0, -1.0, 0.0, 0.0], [0.0, 0.0, -1.0, 0.0], [0.0, 0.0, 0.0, 1.0]]),
        (Direction::Y, [[-1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, -1.0, 0.0], [0.0, 0.0, 0.0, 1.0]]),
        (Direction::Z, [[-1.0, 0.0, 0.0, 0.0], [0.0, -1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]]),
    ] {
        let axis = EvenMultivector::from(Point::ORIGIN & axis) * -1.0;
        assert_eq!(EvenMultivector::from(Motor::from_columns(columns).unwrap()), axis);
    }
}

#[test]
fn quaternions_with_translations_go_both_ways() {
    for motor in motors() {
        let (quaternion, translation) = motor.to_quaternion_translation();
        let back = Motor::from_quaternion_translation(quaternion, translation).unwrap();
        assert!(off(back, motor) <= ROUNDING);
        let long = quaternion.map(|coefficient| coefficient * 1e200);
        assert!(off(Motor::from_quaternion_translation(long, translation).unwrap(), motor) <= ROUNDING);
    }
    assert_eq!(Motor::from_quaternion_translation([0.0; 4], [0.0; 3]), None);
    assert_eq!(Motor::from_quaternion_translation([0.0, f64::NAN, 0.0, 1.0], [0.0; 3]), None);
    assert_eq!(Motor::from_quaternion_translation([0.0, 0.0, 0.0, 1.0], [0.0, f64::INFINITY, 0.0]), None);
}

#[track_caller]
fn assert_refused(change: impl Fn(&mut Columns), expected: NotRigid, message: &str) {
    let mut columns = IDENTITY;
    change(&mut columns);
    assert_eq!(Motor::from_columns(columns), Err(expected));
    assert_eq!(expected.to_string(), message);
}

#[test]
fn what_is_not_rigid_is_named_with_its_place() {
    let tolerance = TOLERANCE_F64;
    for bad in [f64::NAN, f64::INFINITY] {
        assert_refused(
            |columns| columns[3][1] = bad,
            NotRigid::NotFinite { column: 3, row: 1 },
            "column 3, row 1: expected a finite entry, found an infinite one or NaN",
        );
    }
    assert_refused(
        |columns| (columns[2][3], columns[3][3]) = (-1.0, 0.5),
        NotRigid::LastRow { column: 2, found: -1.0, expected: 0.0, tolerance },
        "column 2, last row: expected 0 within 1e-6, found -1",
    );
    assert_refused(
        |columns| (columns[0][0], columns[1][1]) = (2.0, 3.0),
        NotRigid::Scaled { column: 1, length_squared: 9.0, tolerance },
        "column 1: expected an axis of squared length 1 within 1e-6, found 9",
    );
    assert_refused(
        |columns| columns[2] = [0.0, 0.6, 0.8, 0.0],
        NotRigid::Sheared { columns: [1, 2], product: 0.6, tolerance },
        "columns 1 and 2: expected perpendicular axes, product 0 within 1e-6, found 0.6",
    );
    assert_refused(
        |columns| columns.swap(0, 1),
        NotRigid::Mirror { determinant: -1.0 },
        "expected a rotation with determinant 1, found a mirror with determinant -1",
    );
    assert_refused(
        |columns| columns[0][0] = 1e200,
        NotRigid::Scaled { column: 0, length_squared: f64::INFINITY, tolerance },
        "column 0: expected an axis of squared length 1 within 1e-6, found inf",
    );
    assert!(matches!(Motor::from_columns([[0.0; 4]; 4]), Err(NotRigid::LastRow { column: 3, .. })));
}

#[test]
fn rounding_is_forgiven_as_far_as_the_precision_goes() {
    let rough = |scale: f64| Rotor::about_y(0.7).transform_direction(Direction::X).to_array().map(|x| x * scale);
    let columns = |scale| {
        let (x, y, z) =
            (rough(scale), [0.0, 1.0, 0.0], Rotor::about_y(0.7).transform_direction(Direction::Z).to_array());
        [x, y, z, [0.0; 3]].map(|[x, y, z]| [x, y, z, 0.0])
    };
    let with_origin = |mut columns: Columns| {
        columns[3][3] = 1.0;
        columns
    };
    let slightly = with_origin(columns(1.0 + 4e-7));
    assert!(Motor::from_columns(slightly).unwrap().is_unit(4.0 * f64::EPSILON));
    let more = with_origin(columns(1.0 + 4e-5));
    assert!(matches!(Motor::from_columns(more), Err(NotRigid::Scaled { column: 0, .. })));
    let single = more.map(|column| column.map(|entry| entry as f32));
    assert!(Motor::from_columns(single).unwrap().is_unit(4.0 * f32::EPSILON));
}
