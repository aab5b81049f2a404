//! The plane: motors, points and lines on concrete numbers.
//!
//! Everything is a few dozen roundings of numbers up to 10, so 256 EPSILON is enough.

use pga_motor::LengthMismatch;
use pga_motor::pga2d::f64::*;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

const ROUNDING: f64 = 256.0 * f64::EPSILON;

fn assert_near(found: Point, expected: Point) {
    let error = found.distance_to_point(expected);
    assert!(error <= ROUNDING, "expected {expected}, found {found}, off by {error:e}");
}

fn assert_same(found: Motor, expected: Motor) {
    let error = found - expected;
    assert!(error.norm() + error.ideal_norm() <= ROUNDING, "expected {expected}, found {found}");
}

fn motors() -> Vec<Motor> {
    let angles = [0.0, 1e-12, 1e-5, 0.1, 1.0, FRAC_PI_2, 3.0, -0.5, -3.1];
    let vectors = [Direction::ZERO, Direction::new(3.0, -4.0), Direction::Y * 0.01];
    let all = angles.map(|angle| {
        vectors.map(|vector| Motor::from_rotor_translator(Rotor::from_angle(angle), Translator::from_vector(vector)))
    });
    all.into_iter().flatten().collect()
}

#[test]
fn translator_and_point_agree_about_right_and_up() {
    let translator = Translator::from_vector(Direction::new(1.0, 2.0));
    assert_eq!(translator.transform_point(Point::ORIGIN), Point::new(1.0, 2.0));
    assert_eq!(Motor::from(translator).transform_origin(), Point::new(1.0, 2.0));
    assert_eq!(translator.vector(), Direction::new(1.0, 2.0));
    assert_eq!(Point::ORIGIN + Direction::new(1.0, 2.0), Point::new(1.0, 2.0));
    assert_eq!(translator, Translator { e01: -0.5, e20: 1.0 });
}

#[test]
fn quarter_turn_is_counter_clockwise() {
    let rotor = Rotor::from_angle(FRAC_PI_2);
    assert_near(rotor.transform_point(Point::new(1.0, 0.0)), Point::new(0.0, 1.0));
    assert_near(rotor.transform_point(Point::new(0.0, 1.0)), Point::new(-1.0, 0.0));
    assert!((rotor.angle() - FRAC_PI_2).abs() <= ROUNDING);
    assert!((Rotor::from_angle(2.0 * PI - 0.5).angle() + 0.5).abs() <= ROUNDING, "the short way");
    let about = Motor::about(Point::new(2.0, 1.0), FRAC_PI_2);
    assert_near(about.transform_point(Point::new(3.0, 1.0)), Point::new(2.0, 2.0));
}

#[test]
fn motor_is_its_translator_times_its_rotor() {
    for motor in motors() {
        assert_same(motor.translator() * motor.rotor(), motor);
        assert_near(Point::ORIGIN + motor.translator().vector(), motor.transform_origin());
        assert_same(motor * motor.inverse(), Motor::IDENTITY);
    }
}

#[test]
fn transforms_keep_incidence() {
    let (a, b) = (Point::new(1.0, 2.0), Point::new(-3.0, 0.5));
    for motor in motors() {
        let (x, y) = (motor.transform_point(a), motor.transform_point(b));
        let error = motor.transform_line(a & b) - (x & y);
        assert!(error.norm() + error.ideal_norm() <= ROUNDING);
        let line = UnitLine::from_points(a, b).unwrap();
        assert!(motor.transform_unit_line(line).signed_distance_to_point(x).abs() <= ROUNDING);
        assert_eq!(motor.transform(a), x);
        assert_eq!(motor.transform_direction(b - a), motor.transform(b - a));
        assert_near(motor.transform_bivector(a.into()).to_point().unwrap(), x);
    }
}

#[test]
fn points_are_transformed_in_order_or_not_at_all() {
    let motor = Motor::about(Point::new(1.0, 0.0), 0.5);
    let points = [Point::ORIGIN, Point::new(1.0, 2.0)];
    let expected = points.map(|point| motor.transform_point(point));
    let mut results = [Point::ORIGIN; 2];
    assert_eq!(motor.transform_points(&points, &mut results), Ok(()));
    assert_eq!(results, expected);
    let mut moved = points;
    motor.transform_points_in_place(&mut moved);
    assert_eq!(moved, expected);
    let mismatch = Err(LengthMismatch { items: 1, results: 2 });
    assert_eq!(motor.transform_points(&points[..1], &mut results), mismatch);
}

#[test]
fn exponential_of_the_logarithm_is_the_same_motion() {
    for motor in motors() {
        let expected = if motor.s < 0.0 { -motor } else { motor };
        assert_same(motor.log().exp(), expected);
        if motor.s != 0.0 {
            assert_eq!(motor.log(), (-motor).log());
        }
    }
    assert_eq!(Motor::IDENTITY.log(), Bivector::ZERO);
    assert_eq!((-Motor::IDENTITY).log(), Bivector::ZERO);
    assert_eq!(Bivector::ZERO.exp(), Motor::IDENTITY);
    let translation = Motor::from(Translator::from_vector(Direction::new(2.0, 4.0)));
    assert_eq!(translation.log(), Bivector { e12: 0.0, e01: -1.0, e20: 2.0 });
    assert_eq!(translation.log().exp(), translation);
    assert_same((Bivector::from(Point::new(2.0, 1.0)) * -0.4).exp(), Motor::about(Point::new(2.0, 1.0), 0.8));
}

#[test]
fn nlerp_goes_the_short_way_and_is_unit() {
    let center = Point::new(3.0, 0.0);
    let (a, b) = (Motor::about(center, 0.2), Motor::about(center, 1.4));
    assert_same(a.nlerp(b, 0.5), Motor::about(center, 0.8));
    assert_same(a.nlerp(-b, 0.5), Motor::about(center, 0.8));
    assert_same((-a).nlerp(b, 0.5), -Motor::about(center, 0.8));
    for t in [-2.0, 0.0, 0.3, 1.0, 7.0] {
        assert!(a.nlerp(b, t).is_unit(ROUNDING));
    }
    assert_same(a.nlerp(b, 0.0), a);
    assert_same(a.nlerp(b, 1.0), b);
}

#[test]
fn nlerp_is_defined_for_equal_antipodal_and_opposite_motors() {
    for motor in motors() {
        for t in [-1.0, 0.0, 0.25, 0.5, 1.0, 2.0] {
            assert_same(motor.nlerp(motor, t), motor);
            assert_same(motor.nlerp(-motor, t), motor);
        }
    }
    let half_turn = Motor::about(Point::new(1.0, 1.0), PI);
    assert!(Motor::IDENTITY.nlerp(half_turn, 0.5).is_unit(ROUNDING));
    let step = Motor::from(Translator::from_vector(Direction::X));
    assert_near(Motor::IDENTITY.nlerp(step, 0.25).transform_origin(), Point::new(0.25, 0.0));
}

#[test]
fn even_elements_normalise_to_motors() {
    for motor in motors() {
        for scale in [1e-200, 0.5, 1e200] {
            assert_same((EvenMultivector::from(motor) * scale).normalize().unwrap(), motor);
        }
        assert!(EvenMultivector::from(motor).is_unit(ROUNDING));
    }
    assert!(!EvenMultivector::new(1.0, 0.5, 0.0, 0.0).is_unit(0.1));
    assert_eq!(EvenMultivector::ZERO.normalize(), None);
    assert_eq!(EvenMultivector::new(0.0, 0.0, 1.0, 2.0).normalize(), None);
    assert_eq!(EvenMultivector::new(1.0, f64::NAN, 1.0, 2.0).normalize(), None);
    assert_eq!(EvenMultivector::new(1.0, 0.0, f64::INFINITY, 2.0).normalize(), None);
    assert_eq!(EvenMultivector::new(3.0, 4.0, 5.0, 12.0).norm(), 5.0);
    assert_eq!(EvenMultivector::new(3.0, 4.0, 5.0, 12.0).ideal_norm(), 13.0);
}

#[test]
fn distances_and_angles() {
    let line = UnitLine::from_points(Point::new(0.0, 2.0), Point::new(3.0, 6.0)).unwrap();
    // The normal (-4, 3)/5 is to the left of the way (3, 4).
    assert_eq!(line.normal(), Direction::new(-0.8, 0.6));
    assert_eq!(line.direction(), Direction::new(0.6, 0.8));
    assert!((Point::new(-4.0, 5.0).signed_distance_to_line(line) - 5.0).abs() <= ROUNDING);
    assert!((Point::new(4.0, -1.0).signed_distance_to_line(line) + 5.0).abs() <= ROUNDING);
    assert_near(Point::new(-4.0, 5.0).project_onto_line(line), Point::new(0.0, 2.0));
    assert_eq!(Point::new(1.0, 2.0).distance_to_point(Point::new(4.0, 6.0)), 5.0);

    let along = |direction| UnitLine::from_point_and_direction(Point::new(5.0, 7.0), direction).unwrap();
    let x = along(Direction::X);
    assert!((x.angle_to_line(along(Direction::new(1.0, 1.0))) - FRAC_PI_4).abs() <= ROUNDING);
    assert!((x.angle_to_line(along(Direction::new(1.0, -1.0))) + FRAC_PI_4).abs() <= ROUNDING);
    assert!((Direction::X.angle_to(Direction::Y).unwrap() - FRAC_PI_2).abs() <= ROUNDING);
    assert_eq!(Direction::X.cross(Direction::Y), 1.0);
    assert_eq!(Direction::new(1.0, 2.0).dot(Direction::new(3.0, 4.0)), 11.0);
}

#[test]
fn norms_meets_and_duals() {
    let line = Line::new(3.0, 4.0, -7.0);
    assert_eq!((line.norm(), line.ideal_norm()), (5.0, 7.0));
    assert_eq!(line.normal(), Direction::new(3.0, 4.0));
    assert_eq!(line.direction(), Direction::new(4.0, -3.0));
    assert_eq!(line.dual().undual(), line);
    assert_eq!(line.undual().dual(), line);
    let parallel = line.project_onto_point(Point::new(1.0, 2.0));
    assert_eq!(parallel, Line::new(3.0, 4.0, -11.0));
    assert_eq!((line ^ parallel).to_point(), None);
    let point = Bivector { e12: -2.0, e01: -6.0, e20: -8.0 };
    assert_eq!((point.norm(), point.ideal_norm()), (2.0, 10.0));
    assert_eq!(point.to_point(), Some(Point::new(4.0, 3.0)));
}

#[test]
fn mirrors_reflect() {
    let mirror = UnitLine::from_points(Point::new(1.0, 0.0), Point::new(1.0, 5.0)).unwrap();
    assert_eq!(mirror.reflect_point(Point::new(3.0, 4.0)), Point::new(-1.0, 4.0));
    assert_eq!(mirror.reflect_direction(Direction::new(3.0, 4.0)), Direction::new(-3.0, 4.0));
    assert_eq!(mirror.reflect_unit_line(mirror), -mirror);
    assert_eq!(mirror.reflect_line(Line::new(0.0, 1.0, -3.0)), Line::new(0.0, 1.0, -3.0));
}

#[test]
fn degenerate_input_is_none() {
    let a = Point::new(1.0, 2.0);
    assert_eq!(UnitLine::from_points(a, a), None);
    assert_eq!(UnitLine::from_points(a, Point::new(f64::NAN, 0.0)), None);
    assert_eq!(UnitLine::from_point_and_direction(a, Direction::ZERO), None);
    assert_eq!(Line::new(0.0, 0.0, 1.0).normalize(), None);
    assert_eq!(Line::new(1.0, f64::INFINITY, 1.0).normalize(), None);
    assert_eq!(Direction::ZERO.normalize(), None);
    assert_eq!(Direction::ZERO.angle_to(Direction::X), None);
    assert_eq!(Direction::new(1e-300, 0.0).normalize(), Some(Direction::X));
}
