//! Motors, rotors and translators on concrete numbers.
//!
//! Tolerances: a transform or a product is at most 40 roundings of intermediates no larger than 4 times the size of
//! what goes in (points and translations up to `size`, unit parts up to 1), each off by at most EPSILON/2 of that.
//! Together 80 EPSILON size; two in a row, 160.

use pga_motor::LengthMismatch;
use pga_motor::f64::*;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_3, PI};

const ROUNDING: f64 = 160.0 * f64::EPSILON;

fn assert_near(found: Point, expected: Point, size: f64) {
    let error = found.distance_to_point(expected);
    assert!(error <= ROUNDING * size, "expected {expected}, found {found}, off by {error:e}");
}

fn assert_same(found: &[f64], expected: &[f64], size: f64) {
    let error = found.iter().zip(expected).fold(0.0_f64, |error, (a, b)| error.max((a - b).abs()));
    assert!(error <= ROUNDING * size, "expected {expected:?}, found {found:?}, off by {error:e}");
}

/// Motors with rotations of many sizes about several axes and with translations up to `size`.
fn motors(size: f64) -> Vec<Motor> {
    let axes = [Direction::X, Direction::new(1.0, 2.0, -2.0), Direction::new(-0.3, 0.1, 0.7)];
    let angles = [0.0, 1e-12, 1e-5, 0.1, 1.0, FRAC_PI_2, 3.0, PI, -0.5, -3.1];
    let vectors = [Direction::ZERO, Direction::new(0.5, -1.0, 0.25) * size, Direction::Z * (0.01 * size)];
    let mut motors = Vec::new();
    for axis in axes {
        for angle in angles {
            for vector in vectors {
                let rotor = Rotor::from_axis_angle(axis, angle).unwrap();
                motors.push(Motor::from_rotor_translator(rotor, Translator::from_vector(vector)));
            }
        }
    }
    motors
}

#[test]
fn translator_moves_the_origin_by_its_vector() {
    let translator = Translator::from_vector(Direction::new(1.0, 2.0, 3.0));
    assert_eq!(translator, Translator::new(-0.5, -1.0, -1.5));
    assert_eq!(translator.transform_point(Point::ORIGIN), Point::new(1.0, 2.0, 3.0));
    assert_eq!(Motor::from(translator).transform_origin(), Point::new(1.0, 2.0, 3.0));
    assert_eq!(translator.vector(), Direction::new(1.0, 2.0, 3.0));
    assert_eq!(translator.transform_direction(Direction::X), Direction::X);
}

#[test]
fn quarter_turns_are_counter_clockwise() {
    let cases = [
        (Rotor::about_x(FRAC_PI_2), [Direction::X, Direction::Y, Direction::Z]),
        (Rotor::about_y(FRAC_PI_2), [Direction::Y, Direction::Z, Direction::X]),
        (Rotor::about_z(FRAC_PI_2), [Direction::Z, Direction::X, Direction::Y]),
    ];
    for (rotor, [axis, from, to]) in cases {
        assert_same(&rotor.transform_direction(axis).to_array(), &axis.to_array(), 1.0);
        assert_same(&rotor.transform_direction(from).to_array(), &to.to_array(), 1.0);
        assert_same(&rotor.transform_direction(to).to_array(), &(-from).to_array(), 1.0);
    }
}

#[test]
fn axis_of_any_length_gives_the_same_rotor() {
    for angle in [0.3, PI, -2.0] {
        let expected = Rotor::about_x(angle);
        for length in [f64::from_bits(1), 1e-310, 1e-200, 1e-3, 1.0, 7.0, 1e200, f64::MAX] {
            assert_eq!(Rotor::from_axis_angle(Direction::new(length, 0.0, 0.0), angle), Some(expected));
        }
        let slanted = Rotor::from_axis_angle(Direction::new(1.0, 2.0, 2.0), angle).unwrap();
        let long = Rotor::from_axis_angle(Direction::new(1e300, 2e300, 2e300), angle).unwrap();
        assert_same(&slanted.to_array(), &long.to_array(), 1.0);
    }
}

#[test]
fn axis_without_direction_gives_no_rotor() {
    let (nan, infinite) = (f64::NAN, f64::INFINITY);
    assert_eq!(Rotor::from_axis_angle(Direction::ZERO, 1.0), None);
    assert_eq!(Rotor::from_axis_angle(Direction::new(nan, 0.0, 1.0), 1.0), None);
    assert_eq!(Rotor::from_axis_angle(Direction::new(1.0, infinite, 0.0), 1.0), None);
    assert_eq!(Rotor::from_axis_angle(Direction::X, nan), None);
    assert_eq!(Rotor::from_axis_angle(Direction::X, infinite), None);
}

#[test]
fn quaternions_are_normalised() {
    let third = Rotor::from_quaternion_xyzw([0.0, 0.0, 3.0, 4.0]).unwrap();
    assert_same(&third.to_quaternion_xyzw(), &[0.0, 0.0, 0.6, 0.8], 1.0);
    for scale in [1e-310, 1e-200, 1e200, 1e307] {
        let scaled = Rotor::from_quaternion_xyzw([0.0, 0.0, 3.0 * scale, 4.0 * scale]).unwrap();
        assert_same(&scaled.to_array(), &third.to_array(), 1.0);
    }
    // The quaternion cos(t/2) + sin(t/2) k turns by t about z.
    let (sin, cos) = 0.4_f64.sin_cos();
    let about_z = Rotor::from_quaternion_xyzw([0.0, 0.0, sin, cos]).unwrap();
    assert_same(&about_z.to_array(), &Rotor::about_z(0.8).to_array(), 1.0);
    assert_eq!(Rotor::from_quaternion_xyzw([0.0; 4]), None);
    assert_eq!(Rotor::from_quaternion_xyzw([0.0, f64::NAN, 0.0, 1.0]), None);
    assert_eq!(Rotor::from_quaternion_xyzw([0.0, f64::INFINITY, 0.0, 1.0]), None);
}

#[test]
fn motor_is_its_translator_times_its_rotor() {
    for motor in motors(10.0) {
        let product = motor.translator() * motor.rotor();
        assert_same(&product.to_array(), &motor.to_array(), 10.0);
        let moved = motor.transform_origin();
        assert_near(Point::ORIGIN + motor.translator().vector(), moved, 10.0);
        assert_eq!(Motor::from_rotor_translator(motor.rotor(), motor.translator()), product);
    }
}

#[test]
fn inverse_undoes() {
    let point = Point::new(3.0, -4.0, 5.0);
    for motor in motors(10.0) {
        assert_near(motor.inverse().transform_point(motor.transform_point(point)), point, 20.0);
        assert_same(&(motor * motor.inverse()).to_array(), &Motor::IDENTITY.to_array(), 10.0);
    }
}

#[test]
fn product_applies_the_right_factor_first() {
    let turn = Motor::from(Rotor::about_z(FRAC_PI_2));
    let step = Motor::from(Translator::from_vector(Direction::X));
    assert_near((step * turn).transform_point(Point::new(1.0, 0.0, 0.0)), Point::new(1.0, 1.0, 0.0), 1.0);
    assert_near((turn * step).transform_point(Point::new(1.0, 0.0, 0.0)), Point::new(0.0, 2.0, 0.0), 1.0);
}

#[test]
fn conjugation_moves_the_axis() {
    let step = Motor::from(Translator::from_vector(Direction::new(1.0, 0.0, 0.0)));
    let turn = step.transform_motor(Rotor::about_z(PI).into());
    assert_near(turn.transform_origin(), Point::new(2.0, 0.0, 0.0), 1.0);
}

#[test]
fn transforms_keep_incidence_and_orientation() {
    let (a, b, c) = (Point::new(1.0, 0.0, 2.0), Point::new(3.0, 1.0, -1.0), Point::new(0.0, 5.0, 1.0));
    for motor in motors(3.0) {
        let [x, y, z] = [a, b, c].map(|point| motor.transform_point(point));
        // Joins of points within 10 of the origin: coefficients up to 1000.
        assert_same(&motor.transform_line(a & b).to_array(), &(x & y).to_array(), 1000.0);
        assert_same(&motor.transform_plane(a & b & c).to_array(), &(x & y & z).to_array(), 1000.0);
        assert_same(&motor.transform_direction(b - a).to_array(), &(y - x).to_array(), 10.0);
        let plane = UnitPlane::from_points(a, b, c).unwrap();
        let moved = UnitPlane::from_points(x, y, z).unwrap();
        assert_same(&motor.transform_unit_plane(plane).to_array(), &moved.to_array(), 100.0);
        let line = UnitLine::from_points(a, b).unwrap();
        let moved = UnitLine::from_points(x, y).unwrap();
        assert_same(&motor.transform_unit_line(line).to_array(), &moved.to_array(), 100.0);
        assert_near(motor.transform_projective_point(a.into()).to_point().unwrap(), x, 10.0);
    }
}

#[test]
fn rotors_and_translators_act_as_the_motors_they_are() {
    let rotor = Rotor::from_axis_angle(Direction::new(1.0, 2.0, 3.0), 1.2).unwrap();
    let translator = Translator::from_vector(Direction::new(1.0, -2.0, 0.5));
    let (point, line, plane) =
        (Point::new(1.0, 2.0, 3.0), Line::new(1.0, 2.0, 3.0, 4.0, 5.0, 6.0), Plane::new(1.0, 2.0, 3.0, 4.0));
    for (motor, points, lines, planes) in [
        (rotor.into(), rotor.transform_point(point), rotor.transform_line(line), rotor.transform_plane(plane)),
        (
            Motor::from(translator),
            translator.transform_point(point),
            translator.transform_line(line),
            translator.transform_plane(plane),
        ),
    ] {
        assert_near(points, motor.transform_point(point), 20.0);
        assert_same(&lines.to_array(), &motor.transform_line(line).to_array(), 100.0);
        assert_same(&planes.to_array(), &motor.transform_plane(plane).to_array(), 100.0);
    }
}

#[test]
fn transform_takes_anything() {
    let motor = Motor::from_rotor_translator(Rotor::about_y(1.0), Translator::from_vector(Direction::Z));
    let (point, direction) = (Point::new(1.0, 2.0, 3.0), Direction::new(1.0, 2.0, 3.0));
    assert_eq!(motor.transform(point), motor.transform_point(point));
    assert_eq!(motor.transform(direction), motor.transform_direction(direction));
    assert_eq!(motor.transform(motor), motor.transform_motor(motor));
    assert_eq!(motor.transform(Plane::new(1.0, 2.0, 3.0, 4.0)), motor.transform_plane(Plane::new(1.0, 2.0, 3.0, 4.0)));
}

#[test]
fn points_are_transformed_in_order_or_not_at_all() {
    let motor = Motor::from(Translator::from_vector(Direction::X));
    let points = [Point::ORIGIN, Point::new(1.0, 2.0, 3.0), Point::new(-1.0, 0.0, 4.0)];
    let expected = points.map(|point| motor.transform_point(point));
    let mut results = [Point::ORIGIN; 3];
    assert_eq!(motor.transform_points(&points, &mut results), Ok(()));
    assert_eq!(results, expected);
    let mut moved = points;
    motor.transform_points_in_place(&mut moved);
    assert_eq!(moved, expected);

    let mut short = [Point::ORIGIN; 2];
    let error = motor.transform_points(&points, &mut short).unwrap_err();
    assert_eq!(error, LengthMismatch { items: 3, results: 2 });
    assert_eq!(error.to_string(), "expected lists of one length, found 3 items and 2");
    assert_eq!(short, [Point::ORIGIN; 2]);
}

#[test]
fn screw_turns_about_its_axis_and_slides_along_it() {
    // A quarter turn about the upward line through (2, 1, 0), and 5 up: (3, 1, 0) goes to (2, 2, 5).
    let axis = Point::new(2.0, 1.0, 0.0) & Direction::Z;
    let screw = Motor::from_screw(axis, FRAC_PI_2, 5.0).unwrap();
    assert_near(screw.transform_point(Point::new(3.0, 1.0, 0.0)), Point::new(2.0, 2.0, 5.0), 5.0);
    assert_near(screw.transform_point(Point::new(2.0, 1.0, -5.0)), Point::new(2.0, 1.0, 0.0), 5.0);
    assert!(screw.is_unit(ROUNDING * 5.0));
    // The other way about a line across: through (0, 0, 1) along x, from y to -z.
    let across = Motor::from_screw(Point::new(0.0, 0.0, 1.0) & Direction::X, -FRAC_PI_2, -1.0).unwrap();
    assert_near(across.transform_point(Point::new(4.0, 2.0, 1.0)), Point::new(3.0, 0.0, -1.0), 4.0);
}

#[test]
fn screw_agrees_with_its_parts() {
    let rotor = Motor::from_screw(Point::ORIGIN & Direction::Y, 0.7, 0.0).unwrap();
    assert_same(&rotor.to_array(), &Motor::from(Rotor::about_y(0.7)).to_array(), 1.0);
    let slide = Motor::from_screw(Point::ORIGIN & Direction::Y, 0.0, 3.0).unwrap();
    assert_eq!(slide, Translator::from_vector(Direction::Y * 3.0).into());
}

#[test]
fn screw_takes_any_length_of_axis_and_of_a_screw_its_axis() {
    let axis = Point::new(2.0, 1.0, 0.0) & Direction::new(0.0, 3.0, 4.0);
    let expected = Motor::from_screw(axis, 1.0, 2.0).unwrap();
    for scale in [1e-250, 1e-3, 1e250] {
        assert_same(&Motor::from_screw(axis * scale, 1.0, 2.0).unwrap().to_array(), &expected.to_array(), 5.0);
    }
    let pitched = Line { e02: axis.e02 + 0.25 * axis.e31, e03: axis.e03 + 0.25 * axis.e12, ..axis };
    assert_same(&Motor::from_screw(pitched, 1.0, 2.0).unwrap().to_array(), &expected.to_array(), 5.0);
}

#[test]
fn screw_needs_an_axis() {
    let axis = Point::new(1.0, 0.0, 0.0) & Direction::Z;
    assert_eq!(Motor::from_screw(Line::ZERO, 1.0, 1.0), None);
    assert_eq!(Motor::from_screw(Line::new(0.0, 0.0, 0.0, 1.0, 2.0, 3.0), 1.0, 1.0), None);
    assert_eq!(Motor::from_screw(Line { e03: f64::NAN, ..axis }, 1.0, 1.0), None);
    assert_eq!(Motor::from_screw(Line { e12: f64::INFINITY, ..axis }, 1.0, 1.0), None);
    assert_eq!(Motor::from_screw(axis, f64::NAN, 1.0), None);
    assert_eq!(Motor::from_screw(axis, 1.0, f64::INFINITY), None);
}

#[test]
fn logarithm_of_special_motions_is_exact() {
    assert_eq!(Motor::IDENTITY.log(), Line::ZERO);
    assert_eq!((-Motor::IDENTITY).log(), Line::ZERO);
    assert_eq!(Line::ZERO.exp(), Motor::IDENTITY);
    let translation = Motor::from(Translator::from_vector(Direction::new(2.0, 4.0, 1e6)));
    let generator = Line::new(0.0, 0.0, 0.0, -1.0, -2.0, -0.5e6);
    assert_eq!(translation.log(), generator);
    assert_eq!((-translation).log(), generator);
    assert_eq!(generator.exp(), translation);
}

#[test]
fn logarithm_of_a_turn_is_minus_half_the_angle_times_its_axis() {
    let axis = UnitLine::from_points(Point::new(2.0, 1.0, 0.0), Point::new(2.0, 4.0, 4.0)).unwrap();
    let turn = Motor::from_screw(axis.into(), FRAC_PI_3, 0.0).unwrap();
    let expected = Line::from(axis) * (-FRAC_PI_3 / 2.0);
    assert_same(&turn.log().to_array(), &expected.to_array(), 3.0);
    assert_same(&expected.exp().to_array(), &turn.to_array(), 3.0);
}

#[test]
fn exponential_of_the_logarithm_is_the_same_motion() {
    // Rounding of log and exp, each at most 40 operations on parts up to `size`; the quotients with cancelling
    // numerators are multiplied by what they were divided by.
    for size in [0.0, 1.0, 1e6] {
        for motor in motors(size) {
            let back = motor.log().exp();
            let sign = if motor.s < 0.0 { -1.0 } else { 1.0 };
            let expected = motor.to_array().map(|coefficient| sign * coefficient);
            assert_same(&back.to_array()[..4], &expected[..4], 1.0);
            assert_same(&back.to_array()[4..], &expected[4..], 1.0 + size);
        }
    }
}

#[test]
fn logarithm_is_the_same_for_both_signs() {
    for motor in motors(10.0).into_iter().filter(|motor| motor.s != 0.0) {
        assert_eq!(motor.log(), (-motor).log());
        assert!(motor.log().norm() <= FRAC_PI_2 * (1.0 + f64::EPSILON));
    }
    let tie = Motor::from(Rotor::new(0.0, 0.0, 0.0, 1.0));
    assert_eq!((-tie).log(), -tie.log());
}

#[test]
fn single_precision_works_alike() {
    use pga_motor::f32::{Direction, Motor, Point, Rotor, Translator};
    let rotor = Rotor::from_axis_angle(Direction::new(0.0, 0.0, 1e-40), std::f32::consts::FRAC_PI_2).unwrap();
    let motor = Motor::from_rotor_translator(rotor, Translator::from_vector(Direction::new(1.0, 2.0, 3.0)));
    let moved = motor.transform_point(Point::new(1.0, 0.0, 0.0));
    assert!(moved.distance_to_point(Point::new(1.0, 3.0, 3.0)) <= 80.0 * f32::EPSILON);
    let single = motor.map(f64::from).map(|coefficient| coefficient as f32);
    assert_eq!(single, motor);
}
