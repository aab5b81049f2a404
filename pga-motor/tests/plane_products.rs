//! The plane: products of versors, sandwiches of motions, inverses and duals on numbers worked out by hand.
//!
//! The numbers are small multiples of powers of 2, so results are exact unless a tolerance is given.

use pga_motor::LengthMismatch;
use pga_motor::pga2d::f64::*;
use std::f64::consts::FRAC_PI_2;

const ROUNDING: f64 = 256.0 * f64::EPSILON;

/// Half a turn about the origin.
const ROTOR: Rotor = Rotor::new(0.0, -1.0);
/// By (2, 4): 1 - e01 + 2 e20.
const TRANSLATOR: Translator = Translator::new(-1.0, 2.0);
/// The line x = 3, running downwards: its normal, (1, 0), is to the left.
const LINE: UnitLine = UnitLine::new(1.0, 0.0, -3.0);
const EVEN: EvenMultivector = EvenMultivector::new(1.0, 2.0, -3.0, 4.0);
const ODD: OddMultivector = OddMultivector::new(1.0, -2.0, 3.0, 4.0);

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
fn versors_multiply_as_their_blades_do() {
    // e12 e1 = -e2 and e12 e0 = e012.
    assert_eq!(ROTOR * LINE, OddMultivector { e2: 1.0, e012: 3.0, ..OddMultivector::ZERO });
    assert_eq!(LINE * ROTOR, OddMultivector { e2: -1.0, e012: 3.0, ..OddMultivector::ZERO });
    // e01 e1 = e0, e20 e1 = e012; e1 e01 = -e0, e1 e20 = e012.
    assert_eq!(TRANSLATOR * LINE, OddMultivector { e1: 1.0, e0: -4.0, e012: 2.0, ..OddMultivector::ZERO });
    assert_eq!(LINE * TRANSLATOR, OddMultivector { e1: 1.0, e0: -2.0, e012: 2.0, ..OddMultivector::ZERO });
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
        even motor, even ROTOR => even;
        even motor, even TRANSLATOR => even;
        even ROTOR, even TRANSLATOR => even;
        even motor, odd LINE => odd;
        even ROTOR, odd LINE => odd;
        even TRANSLATOR, odd LINE => odd;
        odd LINE, odd LINE => even;
        even EVEN, even motor => even;
        even EVEN, even ROTOR => even;
        even EVEN, even TRANSLATOR => even;
        even EVEN, odd LINE => odd;
        odd ODD, even motor => odd;
        odd ODD, even ROTOR => odd;
        odd ODD, even TRANSLATOR => odd;
        odd ODD, odd LINE => even;
        odd ODD, odd Line::from(LINE) => even;
    }
}

#[test]
fn motions_are_seen_from_where_a_motion_carries_the_world() {
    let (x, y) = (Translator::from_vector(Direction::X), Translator::from_vector(Direction::Y));
    let quarter = Rotor::from_angle(FRAC_PI_2);
    let motor = x * quarter;
    assert_near(&(motor >> x).to_array(), &y.to_array());
    assert_near(&(quarter >> x).to_array(), &y.to_array());
    assert_eq!((y >> x, quarter >> ROTOR), (x, ROTOR));
    assert_eq!((x >> ROTOR).transform_origin(), Point::new(2.0, 0.0));
    assert_eq!(x.transform_motor(ROTOR.into()).transform_origin(), Point::new(2.0, 0.0));
    assert_near(&(motor >> ROTOR).transform_origin().to_array(), &[2.0, 0.0]);
    assert_near(&quarter.transform_motor(x >> ROTOR).transform_origin().to_array(), &[0.0, 2.0]);
    let exact = TRANSLATOR * ROTOR;
    assert_eq!(exact >> EVEN, exact * EVEN * exact.reverse());
    assert_eq!(exact >> ODD, exact * ODD * exact.reverse());
    assert_eq!(ROTOR >> EVEN, ROTOR * EVEN * ROTOR.reverse());
    assert_eq!(ROTOR >> ODD, ROTOR * ODD * ROTOR.reverse());
    assert_eq!(TRANSLATOR >> EVEN, TRANSLATOR * EVEN * TRANSLATOR.reverse());
    assert_eq!(TRANSLATOR >> ODD, TRANSLATOR * ODD * TRANSLATOR.reverse());
    assert_eq!(TRANSLATOR.transform_unit_line(LINE), UnitLine::new(1.0, 0.0, -5.0));
    assert_eq!(ROTOR.transform_unit_line(LINE), UnitLine::new(-1.0, 0.0, -3.0));
}

#[test]
fn inverses_multiply_to_one() {
    assert_eq!((LINE.inverse(), LINE * LINE.inverse()), (LINE, Motor::IDENTITY));
    assert_eq!(Line::new(0.0, 2.0, 3.0).inverse(), Some(Line::new(0.0, 0.5, 0.75)));
    let even = EvenMultivector::new(1.0, 1.0, 4.0, -6.0);
    assert_eq!(even.inverse(), Some(EvenMultivector::new(0.5, -0.5, -2.0, 3.0)));
    assert_eq!(even * even.inverse().unwrap(), EvenMultivector::IDENTITY);
    let odd = OddMultivector::new(1.0, -1.0, 4.0, 6.0);
    assert_eq!(odd.inverse(), Some(OddMultivector::new(0.5, -0.5, 2.0, -3.0)));
    assert_eq!(odd * odd.inverse().unwrap(), EvenMultivector::IDENTITY);
    for scale in [1e-250, 1e250] {
        assert_near(&((EVEN * scale).inverse().unwrap() * (EVEN * scale)).to_array(), &[1.0, 0.0, 0.0, 0.0]);
        assert_near(&((ODD * scale).inverse().unwrap() * (ODD * scale)).to_array(), &[1.0, 0.0, 0.0, 0.0]);
    }
    assert_eq!(Line::new(0.0, 0.0, 1.0).inverse(), None);
    assert_eq!(EvenMultivector::new(0.0, 0.0, 1.0, 2.0).inverse(), None);
    assert_eq!(EvenMultivector { e01: f64::NAN, ..EVEN }.inverse(), None);
    assert_eq!(OddMultivector::new(0.0, 0.0, 1.0, 2.0).inverse(), None);
    assert_eq!(OddMultivector { e012: f64::INFINITY, ..ODD }.inverse(), None);
}

#[test]
fn duals_and_reverses() {
    // e1 ^ e20 = e12 ^ e0 = e0 ^ e12 = e012 and so on: every complement has the sign 1.
    assert_eq!(Point::new(1.0, 2.0).dual(), Line::new(0.0, 0.0, 1.0) + Direction::new(1.0, 2.0).dual());
    assert_eq!(Direction::new(3.0, 4.0).dual().norm(), 5.0);
    assert_eq!(Point::new(1.0, 2.0).undual().dual(), Point::new(1.0, 2.0).into());
    assert_eq!(LINE.undual().dual(), LINE.into());
    assert_eq!(EVEN.dual().undual(), EVEN);
    assert_eq!(ODD.undual().dual(), ODD);
    assert_eq!(Motor::IDENTITY.dual(), OddMultivector { e012: 1.0, ..OddMultivector::ZERO });
    assert_eq!(ROTOR.dual(), OddMultivector { e0: -1.0, ..OddMultivector::ZERO });
    assert_eq!(TRANSLATOR.undual().dual(), TRANSLATOR.into());
    assert_eq!((Pseudoscalar::new(3.0).dual(), Pseudoscalar::new(3.0).undual()), (3.0, 3.0));
    assert_eq!(LINE.reverse(), LINE);
    assert_eq!(ODD.reverse(), OddMultivector { e012: -4.0, ..ODD });
    assert_eq!(Point::new(1.0, 2.0).reverse(), Bivector { e12: -1.0, e01: -2.0, e20: -1.0 });
    assert_eq!(Direction::new(1.0, 2.0).reverse(), Direction::new(-1.0, -2.0));
}

#[test]
fn norms_distances_and_units() {
    let odd = OddMultivector::new(3.0, 4.0, -5.0, 12.0);
    assert_eq!((odd.norm(), odd.ideal_norm(), LINE.ideal_norm()), (5.0, 13.0, 3.0));
    assert_eq!(Point::new(1.0, 7.0).distance_to_line(LINE), 2.0);
    assert_eq!(LINE.distance_to_point(Point::new(7.0, 7.0)), 4.0);
    assert_eq!(LINE.distance_to_line(UnitLine::new(-1.0, 0.0, -2.0)), 5.0);
    assert_eq!(LINE.distance_to_line(UnitLine::new(0.0, 1.0, 9.0)), 0.0);
    assert!(LINE.is_unit(0.0) && ROTOR.is_unit(0.0) && (TRANSLATOR * ROTOR).is_unit(0.0) && Direction::X.is_unit(0.0));
    assert!(!UnitLine::new(1.0, 1.0, 0.0).is_unit(0.5) && !Rotor::new(1.0, 1.0).is_unit(0.5));
    assert!(!Line::new(0.0, 2.0, 0.0).is_unit(0.5) && !Direction::new(1.0, 1.0).is_unit(0.5));
    assert_eq!(Point::new(1.0, 2.0) | Point::new(3.0, 4.0), -1.0);
}

#[test]
fn rotors_and_translators_move_points_too() {
    let points = [Point::ORIGIN, Point::new(1.0, 2.0)];
    let mut results = points;
    assert_eq!(TRANSLATOR.transform_points(&points, &mut results), Ok(()));
    assert_eq!(results, [Point::new(2.0, 4.0), Point::new(3.0, 6.0)]);
    let mut moved = points;
    ROTOR.transform_points_in_place(&mut moved);
    assert_eq!(moved, [Point::ORIGIN, Point::new(-1.0, -2.0)]);
    let mismatch = Err(LengthMismatch { items: 1, results: 2 });
    assert_eq!(ROTOR.transform_points(&points[..1], &mut results), mismatch);
}
