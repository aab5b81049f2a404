//! Products of versors, sandwiches of motions, inverses, duals and slices on numbers worked out by hand.
//!
//! The numbers are small multiples of powers of 2, so results are exact unless a tolerance is given.

use pga_motor::LengthMismatch;
use pga_motor::f64::*;
use std::f64::consts::{FRAC_PI_2, PI};

/// A few dozen roundings of numbers up to 10.
const ROUNDING: f64 = 256.0 * f64::EPSILON;

/// A third of a turn about (-1, -1, -1).
const ROTOR: Rotor = Rotor::new(0.5, 0.5, 0.5, 0.5);
/// By (2, 4, 6).
const TRANSLATOR: Translator = Translator::new(-1.0, -2.0, -3.0);
/// The plane z = 2.
const PLANE: UnitPlane = UnitPlane::new(0.0, 0.0, 1.0, -2.0);
/// The upward line through (3, 1, 0).
const LINE: UnitLine = UnitLine::new(0.0, 0.0, 1.0, 1.0, -3.0, 0.0);
const EVEN: EvenMultivector = EvenMultivector::new(1.0, 2.0, -3.0, 4.0, 5.0, 6.0, -7.0, 8.0);
const ODD: OddMultivector = OddMultivector::new(1.0, -2.0, 3.0, 4.0, 5.0, 6.0, 7.0, -8.0);

fn even(value: impl Into<EvenMultivector>) -> EvenMultivector {
    value.into()
}

fn odd(value: impl Into<OddMultivector>) -> OddMultivector {
    value.into()
}

fn assert_near(found: &[f64], expected: &[f64]) {
    let error = found.iter().zip(expected).fold(0.0_f64, |error, (a, b)| error.max((a - b).abs()));
    assert!(error <= ROUNDING, "expected {expected:?}, found {found:?}, off by {error:e}");
}

#[test]
fn the_line_of_the_tests_is_where_it_is_said_to_be() {
    assert_eq!(UnitLine::from_point_and_direction(Point::new(3.0, 1.0, 0.0), Direction::Z), Some(LINE));
}

#[test]
fn versors_multiply_as_their_blades_do() {
    let turn = Rotor::new(0.6, 0.0, 0.0, -0.8);
    let step = Translator::new(-1.0, 0.0, 0.0);
    let (mirror, axis) = (UnitPlane::new(1.0, 0.0, 0.0, 0.0), UnitLine::new(0.0, 0.0, 1.0, 0.0, 0.0, 0.0));
    let plane = |e1, e2, e0| odd(Plane::new(e1, e2, 0.0, e0));
    // e12 e1 = -e2, e1 e12 = e2.
    assert_eq!(turn * mirror, plane(0.6, 0.8, 0.0));
    assert_eq!(mirror * turn, plane(0.6, -0.8, 0.0));
    assert_eq!(Motor::from(turn) * mirror, plane(0.6, 0.8, 0.0));
    // e01 e1 = e0, e1 e01 = -e0.
    assert_eq!(step * mirror, plane(1.0, 0.0, -1.0));
    assert_eq!(mirror * step, plane(1.0, 0.0, 1.0));
    // e12 e12 = -1.
    assert_eq!(turn * axis, Motor { s: 0.8, e12: 0.6, ..Motor::from([0.0; 8]) });
    assert_eq!(axis * turn, turn * axis);
    // e01 e12 = e02, e12 e01 = -e02.
    assert_eq!(step * axis, Motor { e12: 1.0, e02: -1.0, ..Motor::from([0.0; 8]) });
    assert_eq!(axis * step, Motor { e12: 1.0, e02: 1.0, ..Motor::from([0.0; 8]) });
    assert_eq!(mirror * axis, plane(0.0, 1.0, 0.0));
    assert_eq!(axis * mirror, plane(0.0, -1.0, 0.0));
    assert_eq!(axis * axis, -Motor::IDENTITY);
}

#[test]
fn every_pair_of_versors_multiplies_as_multivectors_do() {
    let motor = TRANSLATOR * ROTOR;
    macro_rules! agree {
        ($($widen_a:ident $a:expr, $widen_b:ident $b:expr => $widen:ident;)*) => {
            $(
                assert_eq!($widen($a * $b), $widen_a($a) * $widen_b($b), "{} * {}", stringify!($a), stringify!($b));
                assert_eq!($widen($b * $a), $widen_b($b) * $widen_a($a), "{} * {}", stringify!($b), stringify!($a));
            )*
        };
    }
    agree! {
        even motor, even motor => even;
        even motor, even ROTOR => even;
        even motor, even TRANSLATOR => even;
        even ROTOR, even TRANSLATOR => even;
        even motor, even LINE => even;
        even ROTOR, even LINE => even;
        even TRANSLATOR, even LINE => even;
        even motor, odd PLANE => odd;
        even ROTOR, odd PLANE => odd;
        even TRANSLATOR, odd PLANE => odd;
        even LINE, odd PLANE => odd;
        odd PLANE, odd PLANE => even;
        even EVEN, even motor => even;
        even EVEN, even ROTOR => even;
        even EVEN, even TRANSLATOR => even;
        even EVEN, even LINE => even;
        even EVEN, odd PLANE => odd;
        odd ODD, even motor => odd;
        odd ODD, even ROTOR => odd;
        odd ODD, even TRANSLATOR => odd;
        odd ODD, even LINE => odd;
        odd ODD, odd PLANE => even;
        even EVEN, even Line::from(LINE) => even;
        even EVEN, odd Plane::from(PLANE) => odd;
        odd ODD, even Line::from(LINE) => odd;
        odd ODD, odd Plane::from(PLANE) => even;
    }
}

#[test]
fn unit_line_is_half_a_turn_about_itself() {
    let half_turn = Motor::from(LINE);
    assert_eq!(half_turn.transform_point(Point::new(3.0, 1.0, 5.0)), Point::new(3.0, 1.0, 5.0));
    assert_eq!(half_turn.transform_origin(), Point::new(6.0, 2.0, 0.0));
    let raised = Translator::from_vector(Direction::Z) * LINE;
    assert_eq!(raised.transform_origin(), Point::new(6.0, 2.0, 1.0));
}

#[test]
fn motions_are_seen_from_where_a_motion_carries_the_world() {
    let (x, y) = (Translator::from_vector(Direction::X), Translator::from_vector(Direction::Y));
    let (quarter, half) = (Rotor::about_z(FRAC_PI_2), Rotor::new(0.0, 0.0, 0.0, -1.0));
    let motor = x * quarter;
    assert_near(&(motor >> x).to_array(), &y.to_array());
    assert_near(&(quarter >> x).to_array(), &y.to_array());
    assert_eq!(y >> x, x);
    // Half a turn about the upward line through (1, 0, 0).
    assert_near(&(motor >> half).transform_origin().to_array(), &[2.0, 0.0, 0.0]);
    assert_eq!((x >> half).transform_origin(), Point::new(2.0, 0.0, 0.0));
    assert_eq!((x >> Motor::from(half)).transform_origin(), Point::new(2.0, 0.0, 0.0));
    // About the line through (0, 1, 0) for one through (1, 0, 0).
    let beside = quarter.transform(x.transform(half));
    assert_near(&beside.transform_origin().to_array(), &[0.0, 2.0, 0.0]);
    assert_near(&(Rotor::about_x(FRAC_PI_2) >> Rotor::about_y(PI)).to_array(), &Rotor::about_z(PI).to_array());
}

#[test]
fn sandwiches_of_sums_are_the_sums_of_sandwiches() {
    let motor = TRANSLATOR * ROTOR;
    let (other, line) = (Motor::from(LINE), Line::new(1.0, 2.0, 3.0, 4.0, 5.0, 6.0));
    let (plane, point) = (Plane::new(1.0, 2.0, 3.0, 4.0), ProjectivePoint::new(5.0, 6.0, 7.0, 2.0));
    assert_eq!(motor >> (even(other) + even(line)), even(motor >> other) + even(motor >> line));
    assert_eq!(motor >> (odd(plane) + odd(point)), odd(motor >> plane) + odd(motor >> point));
    assert_eq!(ROTOR >> EVEN, even(ROTOR) * EVEN * even(ROTOR.reverse()));
    assert_eq!(ROTOR >> ODD, ROTOR * ODD * ROTOR.reverse());
    assert_eq!(TRANSLATOR >> EVEN, TRANSLATOR * EVEN * TRANSLATOR.reverse());
    assert_eq!(TRANSLATOR >> ODD, TRANSLATOR * ODD * TRANSLATOR.reverse());
}

#[test]
fn inverses_multiply_to_one() {
    assert_eq!(LINE * LINE.inverse(), Motor::IDENTITY);
    assert_eq!(LINE.inverse(), -LINE);
    assert_eq!(PLANE * PLANE.inverse(), Motor::IDENTITY);
    assert_eq!(PLANE.inverse(), PLANE);

    let plane = Plane::new(0.0, 2.0, 0.0, 3.0);
    assert_eq!(plane.inverse(), Some(Plane::new(0.0, 0.5, 0.0, 0.75)));
    // 2 e12 + e03: squared norm 4, and e0123 from its pitch: l ~l = 4 - 4 e0123.
    let screw = Line::new(0.0, 0.0, 2.0, 0.0, 0.0, 1.0);
    let inverse = screw.inverse().unwrap();
    assert_eq!(inverse, Line::new(0.0, 0.0, -0.5, 0.0, 0.0, 0.25));
    assert_eq!(screw * inverse, EvenMultivector::IDENTITY);

    let odd = OddMultivector { e1: 1.0, e0: 4.0, e123: 1.0, ..OddMultivector::ZERO };
    let inverse = OddMultivector { e1: 0.5, e032: 2.0, e123: -0.5, ..OddMultivector::ZERO };
    assert_eq!(odd.inverse(), Some(inverse));
    assert_eq!((odd * inverse, inverse * odd), (EvenMultivector::IDENTITY, EvenMultivector::IDENTITY));

    for scale in [1e-250, 1.0, 1e250] {
        let (even, odd) = (EVEN * scale, ODD * scale);
        assert_near(&(even * even.inverse().unwrap()).to_array(), &EvenMultivector::IDENTITY.to_array());
        assert_near(&(odd.inverse().unwrap() * odd).to_array(), &EvenMultivector::IDENTITY.to_array());
        let (line, plane) = (Line::new(1.0, 2.0, 3.0, 4.0, 5.0, 6.0) * scale, Plane::new(1.0, 2.0, 3.0, 4.0) * scale);
        assert_near(&(line * line.inverse().unwrap()).to_array(), &EvenMultivector::IDENTITY.to_array());
        assert_near(&(plane * plane.inverse().unwrap()).to_array(), &EvenMultivector::IDENTITY.to_array());
    }
}

#[test]
fn what_has_no_euclidean_part_has_no_inverse() {
    assert_eq!(EvenMultivector { s: 0.0, e23: 0.0, e31: 0.0, e12: 0.0, ..EVEN }.inverse(), None);
    assert_eq!(EvenMultivector { e01: f64::NAN, ..EVEN }.inverse(), None);
    assert_eq!(EvenMultivector { s: f64::INFINITY, ..EVEN }.inverse(), None);
    assert_eq!(OddMultivector { e1: 0.0, e2: 0.0, e3: 0.0, e123: 0.0, ..ODD }.inverse(), None);
    assert_eq!(OddMultivector { e0: f64::INFINITY, ..ODD }.inverse(), None);
    assert_eq!(Line::new(0.0, 0.0, 0.0, 1.0, 0.0, 0.0).inverse(), None);
    assert_eq!(Line::new(1.0, 0.0, 0.0, f64::NAN, 0.0, 0.0).inverse(), None);
    assert_eq!(Plane::new(0.0, 0.0, 0.0, 1.0).inverse(), None);
    assert_eq!(Plane::new(f64::NAN, 0.0, 0.0, 1.0).inverse(), None);
}

#[test]
fn reverses_change_the_sign_of_bivectors_and_trivectors() {
    assert_eq!(PLANE.reverse(), PLANE);
    assert_eq!(Plane::new(1.0, 2.0, 3.0, 4.0).reverse(), Plane::new(1.0, 2.0, 3.0, 4.0));
    assert_eq!(LINE.reverse(), -LINE);
    assert_eq!(Point::new(1.0, 2.0, 3.0).reverse(), ProjectivePoint::new(-1.0, -2.0, -3.0, -1.0));
    assert_eq!(Direction::new(1.0, 2.0, 3.0).reverse(), Direction::new(-1.0, -2.0, -3.0));
}

#[test]
fn duals_complement_each_blade() {
    // e032 ^ -e1 = e123 ^ -e0 = e0123, and e1 ^ e032 = e0 ^ e123 = e0123.
    assert_eq!(Point::new(1.0, 2.0, 3.0).dual(), Plane::new(-1.0, -2.0, -3.0, -1.0));
    assert_eq!(Point::new(1.0, 2.0, 3.0).undual(), Plane::new(1.0, 2.0, 3.0, 1.0));
    assert_eq!(Direction::new(1.0, 2.0, 3.0).dual(), Plane::new(-1.0, -2.0, -3.0, 0.0));
    assert_eq!(Direction::new(1.0, 2.0, 3.0).undual(), Plane::new(1.0, 2.0, 3.0, 0.0));
    assert_eq!(PLANE.dual(), ProjectivePoint::new(0.0, 0.0, 1.0, -2.0));
    assert_eq!(PLANE.undual().dual(), PLANE.into());
    assert_eq!(LINE.dual(), Line::new(1.0, -3.0, 0.0, 0.0, 0.0, 1.0));
    assert_eq!(LINE.undual().dual(), LINE.into());
    assert_eq!(Motor::IDENTITY.dual(), EvenMultivector { e0123: 1.0, ..EvenMultivector::ZERO });
    assert_eq!(Motor::IDENTITY.undual().dual(), EvenMultivector::IDENTITY);
    assert_eq!(ROTOR.dual(), EvenMultivector::new(0.0, 0.0, 0.0, 0.0, 0.5, 0.5, 0.5, 0.5));
    assert_eq!(ROTOR.undual().dual(), ROTOR.into());
    assert_eq!(TRANSLATOR.dual(), EvenMultivector::new(0.0, -1.0, -2.0, -3.0, 0.0, 0.0, 0.0, 1.0));
    assert_eq!(TRANSLATOR.undual().dual(), TRANSLATOR.into());
    assert_eq!(Pseudoscalar::new(3.0).dual(), 3.0);
}

#[test]
fn inner_products_of_points_are_minus_their_weights() {
    let (point, other) = (Point::new(1.0, 2.0, 3.0), Point::new(-4.0, 5.0, 6.0));
    let heavy = ProjectivePoint::new(1.0, 2.0, 3.0, 4.0);
    assert_eq!(point | other, -1.0);
    assert_eq!((point | heavy, heavy | point, heavy | heavy), (-4.0, -4.0, -16.0));
}

#[test]
fn norms_of_parts() {
    let odd = OddMultivector::new(2.0, 4.0, 5.0, 1.0, 4.0, 4.0, 4.0, -6.0);
    assert_eq!((odd.norm(), odd.ideal_norm()), (9.0, 7.0));
    assert_eq!(PLANE.ideal_norm(), 2.0);
    assert_eq!(LINE.ideal_norm(), 10.0_f64.sqrt());
}

#[test]
fn units_are_told_from_what_is_not() {
    let motor = TRANSLATOR * ROTOR;
    assert!(motor.is_unit(0.0) && ROTOR.is_unit(0.0) && PLANE.is_unit(0.0) && LINE.is_unit(0.0));
    assert!(Plane::from(PLANE).is_unit(0.0) && Line::from(LINE).is_unit(0.0) && Direction::Y.is_unit(0.0));
    assert!(!Motor { e0123: motor.e0123 + 1.0, ..motor }.is_unit(0.25), "off the Study quadric");
    assert!(!Motor { s: f64::NAN, ..motor }.is_unit(1e9));
    assert!(!Rotor { s: 0.75, ..ROTOR }.is_unit(0.25));
    assert!(Rotor { s: 0.75, ..ROTOR }.is_unit(0.3125), "0.5625 for 0.25");
    assert!(!UnitPlane { e1: 1.0, ..PLANE }.is_unit(0.5));
    assert!(!UnitLine { e03: 1.0, ..LINE }.is_unit(0.5), "off the Pluecker relation");
    assert!(!Line::new(2.0, 0.0, 0.0, 0.0, 0.0, 0.0).is_unit(0.5));
    assert!(!Plane::new(2.0, 0.0, 0.0, 0.0).is_unit(0.5));
    assert!(!Direction::new(1.0, 1.0, 0.0).is_unit(0.5));
}

#[test]
fn distances_without_a_sign() {
    assert_eq!(Point::new(7.0, 8.0, -1.0).distance_to_plane(PLANE), 3.0);
    assert_eq!(PLANE.distance_to_point(Point::new(7.0, 8.0, 6.0)), 4.0);
    assert_eq!((-PLANE).distance_to_point(Point::new(7.0, 8.0, 6.0)), 4.0);

    let higher = UnitPlane::new(0.0, 0.0, 1.0, -7.0);
    assert_eq!((PLANE.distance_to_plane(higher), PLANE.distance_to_plane(-higher)), (5.0, 5.0));
    assert_eq!(higher.distance_to_plane(PLANE), 5.0);
    assert_eq!(PLANE.distance_to_plane(PLANE), 0.0);
    assert_eq!(PLANE.distance_to_plane(UnitPlane::new(1.0, 0.0, 0.0, 9.0)), 0.0);
    // Parallel but for rounding: 2 x + 3 y + 6 z = 7 and = -14 by two ways.
    let slanted = Plane::new(2.0, 3.0, 6.0, -7.0).normalize().unwrap();
    let below = Plane::new(0.2, 0.3, 0.6, 1.4).normalize().unwrap();
    assert_near(&[slanted.distance_to_plane(below)], &[3.0]);

    let level = UnitLine::from_point_and_direction(Point::new(3.0, 1.0, 6.0), Direction::Y).unwrap();
    assert_eq!((level.distance_to_plane(PLANE), PLANE.distance_to_line(level)), (4.0, 4.0));
    assert_eq!(LINE.distance_to_plane(PLANE), 0.0);
}

#[test]
fn slices_are_transformed_as_their_items_are() {
    let motor = Translator::from_vector(Direction::new(1.0, 2.0, 3.0)) * Rotor::about_z(FRAC_PI_2);
    // (x, y, z) goes to (1 - y, 2 + x, 3 + z).
    let points = [Point::ORIGIN, Point::new(4.0, 5.0, 6.0)];
    let mut moved = points;
    motor.transform_points_in_place(&mut moved);
    assert_near(&moved[0].to_array(), &[1.0, 2.0, 3.0]);
    assert_near(&moved[1].to_array(), &[-4.0, 6.0, 9.0]);
    let mut results = [Point::ORIGIN; 2];
    assert_eq!(motor.transform_points(&points, &mut results), Ok(()));
    assert_eq!(results, moved);

    let directions = [Direction::X, Direction::new(4.0, 5.0, 6.0)];
    let mut moved = directions;
    motor.transform_directions_in_place(&mut moved);
    assert_near(&moved[0].to_array(), &[0.0, 1.0, 0.0]);
    assert_near(&moved[1].to_array(), &[-5.0, 4.0, 6.0]);
    let mut results = [Direction::ZERO; 2];
    assert_eq!(motor.transform_directions(&directions, &mut results), Ok(()));
    assert_eq!(results, moved);

    // The z axis goes to the upward line through (1, 2, 0), with moment 2 e01 - e02; x = 4 goes to y = 6.
    let lines = [Line::new(0.0, 0.0, 1.0, 0.0, 0.0, 0.0), Line::new(1.0, 2.0, 3.0, 4.0, 5.0, 6.0)];
    let mut moved = lines;
    motor.transform_lines_in_place(&mut moved);
    assert_near(&moved[0].to_array(), &[0.0, 0.0, 1.0, 2.0, -1.0, 0.0]);
    assert_near(&moved[1].to_array(), &motor.transform_line(lines[1]).to_array());
    let mut results = [Line::ZERO; 2];
    assert_eq!(motor.transform_lines(&lines, &mut results), Ok(()));
    assert_eq!(results, moved);

    let planes = [Plane::new(1.0, 0.0, 0.0, -4.0), Plane::new(1.0, 2.0, 3.0, 4.0)];
    let mut moved = planes;
    motor.transform_planes_in_place(&mut moved);
    assert_near(&moved[0].to_array(), &[0.0, 1.0, 0.0, -6.0]);
    assert_near(&moved[1].to_array(), &motor.transform_plane(planes[1]).to_array());
    let mut results = [Plane::ZERO; 2];
    assert_eq!(motor.transform_planes(&planes, &mut results), Ok(()));
    assert_eq!(results, moved);
}

#[test]
fn slices_of_different_lengths_are_left_alone() {
    let motor = TRANSLATOR * ROTOR;
    let mismatch = Err(LengthMismatch { items: 2, results: 1 });
    let mut point = [Point::ORIGIN];
    assert_eq!(motor.transform_points(&[Point::ORIGIN; 2], &mut point), mismatch);
    assert_eq!(ROTOR.transform_points(&[Point::ORIGIN; 2], &mut point), mismatch);
    assert_eq!(TRANSLATOR.transform_points(&[Point::ORIGIN; 2], &mut point), mismatch);
    assert_eq!(point, [Point::ORIGIN]);
    assert_eq!(motor.transform_directions(&[Direction::X; 2], &mut [Direction::ZERO]), mismatch);
    assert_eq!(motor.transform_lines(&[Line::from(LINE); 2], &mut [Line::ZERO]), mismatch);
    assert_eq!(motor.transform_planes(&[Plane::from(PLANE); 2], &mut [Plane::ZERO]), mismatch);
    assert_eq!(motor.transform_points(&[], &mut []), Ok(()));
}

#[test]
fn rotors_and_translators_move_points_too() {
    let points = [Point::ORIGIN, Point::new(1.0, 2.0, 3.0)];
    let mut results = points;
    assert_eq!(TRANSLATOR.transform_points(&points, &mut results), Ok(()));
    assert_eq!(results, [Point::new(2.0, 4.0, 6.0), Point::new(3.0, 6.0, 9.0)]);
    let mut moved = points;
    TRANSLATOR.transform_points_in_place(&mut moved);
    assert_eq!(moved, results);
    // A third of a turn about (-1, -1, -1) takes x to z, y to x and z to y.
    assert_eq!(ROTOR.transform_points(&points, &mut results), Ok(()));
    assert_eq!(results, [Point::ORIGIN, Point::new(2.0, 3.0, 1.0)]);
    let mut moved = points;
    ROTOR.transform_points_in_place(&mut moved);
    assert_eq!(moved, results);
}

#[test]
fn matrix_has_the_images_of_the_axes_and_the_origin_as_columns() {
    let matrix: Matrix = (TRANSLATOR * ROTOR).to_matrix();
    let columns = [[0.0, 0.0, 1.0, 0.0], [1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [2.0, 4.0, 6.0, 1.0]];
    assert_eq!(matrix.to_columns(), columns);
    assert_eq!(matrix.transform_point(Point::new(1.0, 2.0, 3.0)), Point::new(4.0, 7.0, 7.0));
}
