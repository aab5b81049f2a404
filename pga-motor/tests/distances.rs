//! Points, lines and planes: constructors, norms, distances, angles and projections on numbers worked out by hand.
//!
//! Where the numbers are not exact in binary, the results are a few operations away from inputs up to 10 in size, so
//! 64 EPSILON is enough.

use pga_motor::f64::*;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_3, FRAC_PI_4, PI};

const ROUNDING: f64 = 64.0 * f64::EPSILON;

fn assert_near(found: f64, expected: f64) {
    assert!((found - expected).abs() <= ROUNDING, "expected {expected}, found {found}");
}

fn line(point: [f64; 3], direction: [f64; 3]) -> UnitLine {
    UnitLine::from_point_and_direction(point.into(), direction.into()).unwrap()
}

fn plane(point: [f64; 3], normal: [f64; 3]) -> UnitPlane {
    UnitPlane::from_point_and_normal(point.into(), normal.into()).unwrap()
}

#[test]
fn norms_do_not_leave_the_range_before_their_time() {
    for scale in [1e-320, 1e-300, 1e-200, 1e-150, 1.0, 1e150, 1e200, 1e300] {
        let relative = |found: f64, expected: f64| ((found - expected) / expected).abs();
        // A subnormal is off by up to half the smallest one to begin with.
        let tolerance = ROUNDING + f64::from_bits(4) / scale;
        assert!(relative(Direction::new(2.0 * scale, 3.0 * scale, 6.0 * scale).norm(), 7.0 * scale) <= tolerance);
        assert!(relative(Plane::new(2.0 * scale, 3.0 * scale, 6.0 * scale, 1.0).norm(), 7.0 * scale) <= tolerance);
        let line = Line::new(2.0, 3.0, 6.0, 1.0, 4.0, 8.0) * scale;
        assert!(relative(line.norm(), 7.0 * scale) <= tolerance);
        assert!(relative(line.ideal_norm(), 9.0 * scale) <= tolerance);
        let even = EvenMultivector::new(2.0, 4.0, 5.0, 6.0, 1.0, 1.0, 1.0, 1.0) * scale;
        assert!(relative(even.norm(), 9.0 * scale) <= tolerance);
        assert!(relative(even.ideal_norm(), 2.0 * scale) <= tolerance);
    }
    assert_eq!(Direction::ZERO.norm(), 0.0);
    assert_eq!(Direction::new(f64::NEG_INFINITY, 1.0, 0.0).norm(), f64::INFINITY);
    assert!(Direction::new(f64::NAN, 1.0, 0.0).norm().is_nan());
}

#[test]
fn directions_normalise_unless_zero_or_not_finite() {
    assert_eq!(Direction::new(0.0, 3.0, -4.0).normalize(), Some(Direction::new(0.0, 0.6, -0.8)));
    assert_eq!(Direction::new(0.0, 3e-310, 0.0).normalize(), Some(Direction::Y));
    assert_eq!(Direction::new(f64::MAX, 0.0, 0.0).normalize(), Some(Direction::X));
    assert!(Direction::new(f64::MAX, f64::MAX, f64::MAX).normalize().is_some());
    assert_eq!(Direction::ZERO.normalize(), None);
    assert_eq!(Direction::new(f64::INFINITY, 0.0, 0.0).normalize(), None);
    assert_eq!(Direction::new(1.0, f64::NAN, 0.0).normalize(), None);
}

#[test]
fn cross_is_right_handed_and_dot_measures() {
    assert_eq!(Direction::X.cross(Direction::Y), Direction::Z);
    assert_eq!(Direction::Y.cross(Direction::Z), Direction::X);
    assert_eq!(Direction::new(1.0, 2.0, 3.0).dot(Direction::new(4.0, -5.0, 6.0)), 12.0);
}

#[test]
fn angles_between_directions_are_accurate_at_both_ends() {
    assert_near(Direction::X.angle_to(Direction::new(1.0, 1.0, 0.0)).unwrap(), FRAC_PI_4);
    assert_near(Direction::X.angle_to(Direction::new(-2.0, 0.0, 0.0)).unwrap(), PI);
    let small = Direction::X.angle_to(Direction::new(1.0, 1e-100, 0.0)).unwrap();
    assert!((small - 1e-100).abs() <= 1e-100 * ROUNDING);
    assert_eq!(Direction::X.angle_to(Direction::X), Some(0.0));
    assert_eq!(Direction::ZERO.angle_to(Direction::X), None);
    assert_eq!(Direction::X.angle_to(Direction::new(f64::NAN, 0.0, 0.0)), None);
}

#[test]
fn distance_between_points() {
    assert_eq!(Point::new(1.0, 2.0, 3.0).distance_to_point(Point::new(3.0, 5.0, 9.0)), 7.0);
    assert_eq!(Point::new(1.0, 2.0, 3.0).distance_to_point(Point::new(1.0, 2.0, 3.0)), 0.0);
}

#[test]
fn distance_from_a_plane_is_positive_on_the_side_of_its_normal() {
    // x + 2 y + 2 z - 6 = 0, at (1, 2, 3): (1 + 4 + 6 - 6) / 3.
    let plane = Plane::new(1.0, 2.0, 2.0, -6.0).normalize().unwrap();
    assert_near(Point::new(1.0, 2.0, 3.0).signed_distance_to_plane(plane), 5.0 / 3.0);
    assert_near(plane.signed_distance_to_point(Point::ORIGIN), -2.0);
    assert_near((-plane).signed_distance_to_point(Point::ORIGIN), 2.0);
}

#[test]
fn distance_from_a_line() {
    let diagonal = line([0.0, 0.0, 0.0], [1.0, 1.0, 0.0]);
    assert_near(Point::new(2.0, 0.0, 1.0).distance_to_line(diagonal), 3.0_f64.sqrt());
    assert_near(diagonal.distance_to_point(Point::new(-5.0, -5.0, 4.0)), 4.0);
}

#[test]
fn distance_between_lines_skew_meeting_and_parallel() {
    let x_axis = line([0.0, 0.0, 0.0], [1.0, 0.0, 0.0]);
    assert_near(x_axis.distance_to_line(line([9.0, 4.0, 3.0], [1.0, 1.0, 0.0])), 3.0);
    assert_near(x_axis.distance_to_line(line([9.0, 0.0, 0.0], [1.0, 1.0, 5.0])), 0.0);
    assert_near(x_axis.distance_to_line(line([9.0, 3.0, 4.0], [1.0, 0.0, 0.0])), 5.0);
    assert_near(x_axis.distance_to_line(line([9.0, 3.0, 4.0], [-1.0, 0.0, 0.0])), 5.0);
    assert_near(x_axis.distance_to_line(x_axis), 0.0);
    // Parallel but for rounding: the same direction by two ways.
    let slanted = line([0.0, 0.0, 0.0], [1.0, 3.0, 7.0]);
    let beside = UnitLine::from_points(Point::new(3.0, -1.0, 0.0), Point::new(3.1, -0.7, 0.7)).unwrap();
    assert_near(slanted.distance_to_line(beside), 10.0_f64.sqrt());
}

#[test]
fn angles_between_lines_and_planes() {
    let x_axis = line([0.0, 0.0, 0.0], [1.0, 0.0, 0.0]);
    let slanted = line([5.0, 6.0, 7.0], [1.0, 3.0_f64.sqrt(), 0.0]);
    assert_near(x_axis.angle_to_line(slanted), FRAC_PI_3);
    assert_near((-x_axis).angle_to_line(slanted), PI - FRAC_PI_3);
    assert_near(x_axis.angle_to_line(-x_axis), PI);

    let (ground, wall) = (plane([0.0, 0.0, 3.0], [0.0, 0.0, 1.0]), plane([1.0, 0.0, 0.0], [1.0, 0.0, 0.0]));
    let roof = plane([0.0, 0.0, 9.0], [0.0, 1.0, 1.0]);
    assert_near(ground.angle_to_plane(wall), FRAC_PI_2);
    assert_near(ground.angle_to_plane(roof), FRAC_PI_4);
    assert_near(ground.angle_to_plane(-roof), PI - FRAC_PI_4);

    let rising = line([4.0, 5.0, 6.0], [1.0, 0.0, 1.0]);
    assert_near(rising.angle_to_plane(ground), FRAC_PI_4);
    assert_near(ground.angle_to_line(-rising), -FRAC_PI_4);
    assert_near(ground.angle_to_line(x_axis), 0.0);
    assert_near(wall.angle_to_line(x_axis), FRAC_PI_2);
}

#[test]
fn points_project_onto_planes_and_lines() {
    let point = Point::new(1.0, 2.0, 3.0);
    assert_eq!(point.project_onto_plane(plane([0.0, 0.0, 1.0], [0.0, 0.0, 5.0])), Point::new(1.0, 2.0, 1.0));
    assert_eq!(point.project_onto_line(line([7.0, 0.0, 1.0], [0.0, 2.0, 0.0])), Point::new(7.0, 2.0, 1.0));
}

#[test]
fn lines_and_planes_project() {
    let ground = plane([0.0, 0.0, 1.0], [0.0, 0.0, 1.0]);
    let slanted = line([0.0, 2.0, 5.0], [3.0, 0.0, 4.0]);
    // The shadow: through (0, 2, 1) along x, of length 3/5.
    let shadow = slanted.project_onto_plane(ground);
    let expected = (Point::new(0.0, 2.0, 1.0) & Direction::X) * 0.6;
    assert_near((shadow - expected).norm() + (shadow - expected).ideal_norm(), 0.0);
    assert_eq!(Line::from(slanted).project_onto_plane(ground), shadow);

    let moved = slanted.project_onto_point(Point::new(1.0, 1.0, 1.0));
    assert_near(moved.distance_to_point(Point::new(4.0, 1.0, 5.0)), 0.0);
    assert_near(moved.angle_to_line(slanted), 0.0);
    assert_eq!(Line::from(slanted).project_onto_point(Point::new(1.0, 1.0, 1.0)), moved.into());

    let upper = ground.project_onto_point(Point::new(8.0, 9.0, 4.0));
    assert_eq!(upper, UnitPlane::new(0.0, 0.0, 1.0, -4.0));
    assert_eq!(Plane::from(ground).project_onto_point(Point::new(8.0, 9.0, 4.0)), upper.into());
    // Closest to level through the slanted line: its normal is (-4, 0, 3)/5, the cosine of the angle 3/5.
    let ramp = ground.project_onto_line(slanted);
    assert_near(ramp.norm(), 0.6);
    assert_near(ramp.normalize().unwrap().signed_distance_to_point(Point::new(3.0, -7.0, 9.0)), 0.0);
    assert_near(ramp.normalize().unwrap().normal().x, -0.8);
}

#[test]
fn mirrors_reflect() {
    let mirror = plane([1.0, 0.0, 0.0], [2.0, 0.0, 0.0]);
    assert_eq!(mirror.reflect_point(Point::new(3.0, 4.0, 5.0)), Point::new(-1.0, 4.0, 5.0));
    assert_eq!(mirror.reflect_direction(Direction::new(3.0, 4.0, 5.0)), Direction::new(-3.0, 4.0, 5.0));
    assert_eq!(mirror.reflect_plane(mirror.into()), (-mirror).into());
    assert_eq!(mirror.reflect_unit_plane(plane([0.0, 2.0, 0.0], [0.0, 1.0, 0.0])), UnitPlane::new(0.0, 1.0, 0.0, -2.0));
    // The turn about an upright line is mirrored to the turn the other way.
    let axis = line([3.0, 0.0, 0.0], [0.0, 0.0, 1.0]);
    let image = mirror.reflect_unit_line(axis);
    assert_eq!(image, line([-1.0, 0.0, 0.0], [0.0, 0.0, -1.0]));
    assert_eq!(mirror.reflect_line(axis.into()), image.into());
    let (turn, mirrored) = ((Line::from(axis) * 0.3).exp(), (Line::from(image) * 0.3).exp());
    let point = Point::new(0.5, -2.0, 0.25);
    let found = mirrored.transform_point(mirror.reflect_point(point));
    assert_near(found.distance_to_point(mirror.reflect_point(turn.transform_point(point))), 0.0);
}

#[test]
fn planes_through_three_points_face_the_counter_clockwise_side() {
    let (a, b, c) = (Point::new(0.0, 0.0, 2.0), Point::new(1.0, 0.0, 2.0), Point::new(0.0, 1.0, 2.0));
    assert_eq!(UnitPlane::from_points(a, b, c), Some(UnitPlane::new(0.0, 0.0, 1.0, -2.0)));
    assert_eq!((a & b & c).normalize(), UnitPlane::from_points(a, b, c));
    assert_eq!(UnitPlane::from_points(a, c, b), Some(UnitPlane::new(0.0, 0.0, -1.0, 2.0)));
}

#[test]
fn degenerate_planes_and_lines_are_none() {
    let (a, b) = (Point::new(1.0, 2.0, 3.0), Point::new(2.0, 4.0, 6.0));
    let nan = Point::new(f64::NAN, 0.0, 0.0);
    assert_eq!(UnitPlane::from_points(a, b, Point::new(3.0, 6.0, 9.0)), None);
    assert_eq!(UnitPlane::from_points(a, a, b), None);
    assert_eq!(UnitPlane::from_points(a, b, nan), None);
    assert_eq!(UnitPlane::from_point_and_normal(a, Direction::ZERO), None);
    assert_eq!(UnitPlane::from_point_and_normal(nan, Direction::X), None);
    assert_eq!(Plane::new(0.0, 0.0, 0.0, 1.0).normalize(), None);
    assert_eq!(Plane::new(1e-300, 0.0, 0.0, 1e300).normalize(), None, "at a distance of 1e600");
    assert_eq!(Plane::new(1.0, f64::INFINITY, 0.0, 1.0).normalize(), None);
    assert_eq!(UnitLine::from_points(a, a), None);
    assert_eq!(UnitLine::from_points(a, nan), None);
    assert_eq!(UnitLine::from_point_and_direction(a, Direction::ZERO), None);
    assert_eq!(Line::ZERO.normalize(), None);
    assert_eq!(Line::new(0.0, 0.0, 0.0, 1.0, 0.0, 0.0).normalize(), None);
    assert_eq!(Line::new(1.0, 0.0, 0.0, f64::NAN, 0.0, 0.0).normalize(), None);
}

#[test]
fn normalised_line_is_the_axis_of_the_screw() {
    let axis = line([1.0, 2.0, 3.0], [2.0, 3.0, 6.0]);
    // The screw with this axis and a pitch: the moment has a part along the direction.
    for (length, pitch) in [(1.0, 0.0), (7.0, 0.5), (1e-200, 3.0), (1e200, -2.0)] {
        let along = Line { e01: axis.e23, e02: axis.e31, e03: axis.e12, ..Line::ZERO };
        let screw = (Line::from(axis) + along * pitch) * length;
        let found = screw.normalize().unwrap();
        let error = Line::from(found) - Line::from(axis);
        assert_near(error.norm() + error.ideal_norm(), 0.0);
        assert!(found.is_unit(ROUNDING));
    }
}

#[test]
fn projective_points_come_down_to_points() {
    assert_eq!(ProjectivePoint::new(2.0, 4.0, 6.0, 2.0).to_point(), Some(Point::new(1.0, 2.0, 3.0)));
    assert_eq!(ProjectivePoint::new(2.0, 4.0, 6.0, -2.0).to_point(), Some(Point::new(-1.0, -2.0, -3.0)));
    assert_eq!(ProjectivePoint::new(2.0, 4.0, 6.0, 0.0).to_point(), None);
    assert_eq!(ProjectivePoint::ZERO.to_point(), None);
    assert_eq!(ProjectivePoint::new(1e300, 0.0, 0.0, 1e-300).to_point(), None);
    assert_eq!(ProjectivePoint::new(2.0, 4.0, 4.0, -3.0).norm(), 3.0);
    assert_eq!(ProjectivePoint::new(2.0, 4.0, 4.0, -3.0).ideal_norm(), 6.0);
}

#[test]
fn duals_are_inverse_to_each_other() {
    let plane = Plane::new(1.0, 2.0, 3.0, 4.0);
    assert_eq!(plane.dual(), ProjectivePoint::new(1.0, 2.0, 3.0, 4.0));
    assert_eq!(plane.dual().undual(), plane);
    assert_eq!(plane.undual().dual(), plane);
    let line = Line::new(1.0, 2.0, 3.0, 4.0, 5.0, 6.0);
    assert_eq!(line.dual().undual(), line);
    assert_eq!(line.reverse(), -line);
    let even = EvenMultivector::new(1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0);
    assert_eq!(even.dual().undual(), even);
    assert_eq!(even.reverse(), EvenMultivector::new(1.0, -2.0, -3.0, -4.0, -5.0, -6.0, -7.0, 8.0));
    let odd = OddMultivector::new(1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0);
    assert_eq!(odd.dual().undual(), odd);
    assert_eq!(odd.reverse().reverse(), odd);
    assert_eq!(Pseudoscalar::new(3.0).undual(), 3.0);
}

#[test]
fn even_element_knows_whether_it_is_a_motor() {
    let motor = Motor::from_screw(Point::new(1.0, 2.0, 3.0) & Direction::Y, 1.0, 2.0).unwrap();
    let even = EvenMultivector::from(motor);
    assert!(even.is_unit(ROUNDING));
    assert!(!(even * 1.001).is_unit(1e-4));
    assert!(!EvenMultivector { e0123: even.e0123 + 0.1, ..even }.is_unit(1e-4), "off the Study quadric");
    assert!(!EvenMultivector { s: f64::NAN, ..even }.is_unit(1e9));
}
