//! What the interpolations of the plane promise, in both precisions.
//!
//! Tolerances: errors are measured in EPSILON, separately for the Euclidean part, whose norm is 1, and for the ideal
//! part, over the largest ideal norm among what goes in, or 1. An interpolation is at most three kernels in a row, each
//! at most 8 roundings deep on numbers below 2 in these units: 3 * 8 * 2 / 2 = 24; extrapolated by the factor |t| as
//! much more.

use super::*;
use crate::pga2d::{Direction, Point};
use crate::precision::in_both_precisions;
use alloc::vec::Vec;
use core::f64::consts::PI;
use core::fmt::{Debug, Display};

const ROUNDING: f64 = 24.0;

/// How far motions here reach.
const SIZE: f64 = 10.0;

trait Float: Real + Debug + Display {}
impl Float for f32 {}
impl Float for f64 {}

/// The larger of the errors of the Euclidean and of the ideal part, in EPSILON.
fn errors<T: Float>(found: Motor<T>, expected: Motor<T>, size: f64) -> f64 {
    let error = found - expected;
    let ideal = error.ideal_norm().to_f64() / size.max(1.0);
    let larger = |a: f64, b: f64| if b > a || b.is_nan() { b } else { a };
    larger(error.norm().to_f64(), ideal) / T::EPSILON.to_f64()
}

#[track_caller]
fn assert_same<T: Float>(found: Motor<T>, expected: Motor<T>, bound: f64) {
    let off = errors(found, expected, SIZE);
    assert!(off <= bound, "expected {expected}, found {found}, off by {off} EPSILON");
}

#[track_caller]
fn assert_same_motion<T: Float>(found: Motor<T>, expected: Motor<T>, bound: f64) {
    let off = errors(found, expected, SIZE).min(errors(found, -expected, SIZE));
    assert!(off <= bound, "expected {expected} or its negative, found {found}, off by {off} EPSILON");
}

fn turn<T: Float>([x, y]: [f64; 2], angle: f64) -> Motor<T> {
    Motor::about(Point::new(T::from_f64(x), T::from_f64(y)), T::from_f64(angle))
}

fn by<T: Float>(x: f64, y: f64) -> Motor<T> {
    Translator::from_vector(Direction::new(T::from_f64(x), T::from_f64(y))).into()
}

fn motors<T: Float>() -> Vec<Motor<T>> {
    let mut motors = Vec::from([Motor::IDENTITY, by(3.0, -4.0)]);
    for angle in [1e-30, 1e-9, 1e-3, 0.7, 2.0, 3.0, PI, -2.9] {
        motors.push(turn([1.0, 2.0], angle));
        motors.push(-turn::<T>([-3.0, 0.5], angle));
    }
    motors
}

type Interpolation<T> = fn(Motor<T>, Motor<T>, T) -> Motor<T>;

fn interpolations<T: Float>() -> [(&'static str, Interpolation<T>); 5] {
    [
        ("nlerp", Motor::nlerp),
        ("slerp", Motor::slerp),
        ("screw_lerp", Motor::screw_lerp),
        ("split_lerp", Motor::split_lerp),
        ("log_lerp", Motor::log_lerp),
    ]
}

/// Beside half a turn the way there and the way back may differ.
fn is_tie<T: Float>(motor: Motor<T>) -> bool {
    motor.s.abs() <= T::EPSILON * T::from_ratio(8, 1)
}

in_both_precisions! {
    interpolations_start_at_one_and_end_at_the_other: ends;
    every_interpolation_is_a_motor_within_and_beyond_its_ends: units;
    the_short_way_is_taken_for_either_sign: short_way;
    equal_and_antipodal_motors_stay_put: stays_put;
    motors_half_a_turn_apart_are_joined: half_turns;
    of_two_ways_as_short_the_one_to_the_end_as_it_stands_is_taken: ties;
    translations_go_straight_at_constant_speed: translations;
    backwards_is_the_same_path: backwards;
    slerp_is_screw_lerp_and_nlerp_agrees_in_the_middle: one_path;
    a_kept_path_gives_the_same_bits: kept_path;
    interpolations_go_with_their_ends: equivariance;
    what_is_not_finite_gives_nan: not_finite;
    blend_does_not_depend_on_the_order: blend_order;
    blend_of_nothing_is_none: blend_none;
    joints_move_from_rest_to_animated: joint;
    rotors_turn_as_the_motors_they_are: rotors;
}

fn ends<T: Float>() {
    for a in motors::<T>() {
        for b in motors() {
            for (name, interpolate) in interpolations() {
                let (start, end) = (interpolate(a, b, T::ZERO), interpolate(a, b, T::ONE));
                let size = |motor: Motor<T>| (motor - Motor::IDENTITY).ideal_norm().to_f64();
                assert!(errors(start, a, size(a)) <= 4.0, "{name}, {a}: {}", errors(start, a, size(a)));
                let end_error = errors(end, b, size(b)).min(errors(end, -b, size(b)));
                assert!(end_error <= 4.0, "{name}, {b}: {end_error}");
            }
        }
    }
}

fn units<T: Float>() {
    for a in motors::<T>() {
        for b in motors() {
            for (_, interpolate) in interpolations() {
                for t in [-1.0, 0.0, 1e-30, 0.1, 0.5, 0.9, 1.0, 2.0] {
                    let motor = interpolate(a, b, T::from_f64(t));
                    assert!(motor.is_unit(T::EPSILON * T::from_f64(ROUNDING)), "{motor}");
                }
            }
        }
    }
}

fn short_way<T: Float>() {
    let (a, b, between) = (turn::<T>([1.0, 2.0], 0.2), turn([1.0, 2.0], 1.4), turn([1.0, 2.0], 0.8));
    for (name, interpolate) in interpolations() {
        for (a, b, expected) in [(a, b, between), (a, -b, between), (-a, b, -between), (-a, -b, -between)] {
            let found = interpolate(a, b, T::from_ratio(1, 2));
            assert_same(found.rotor().into(), expected.rotor().into(), ROUNDING);
            if name != "split_lerp" {
                assert_same(found, expected, ROUNDING);
            }
        }
    }
}

fn stays_put<T: Float>() {
    let half_turn = Motor::from(Rotor::new(T::ZERO, T::ONE));
    for motor in motors::<T>().into_iter().chain([half_turn]) {
        for (_, interpolate) in interpolations() {
            for other in [motor, -motor] {
                for t in [-2.0, 0.0, 0.3, 0.5, 1.0, 3.0] {
                    assert_same(interpolate(motor, other, T::from_f64(t)), motor, 3.0 * ROUNDING);
                }
            }
        }
    }
}

fn half_turns<T: Float>() {
    let half_turn = Motor { s: T::ZERO, ..turn([1.0, 2.0], PI) };
    for a in motors::<T>() {
        for b in [a * half_turn, -(a * half_turn)] {
            for interpolate in [Motor::nlerp, Motor::slerp, Motor::screw_lerp] as [Interpolation<T>; 3] {
                let quarter = a.reverse() * interpolate(a, b, T::from_ratio(1, 2));
                assert_same_motion(quarter * quarter, half_turn, 4.0 * ROUNDING);
            }
        }
    }
}

/// Neither end is nearer where the scalar product is exactly 0.
fn ties<T: Float>() {
    let half_turn = Rotor::new(T::ZERO, T::ONE);
    for end in [half_turn, -half_turn] {
        for (_, interpolate) in interpolations() {
            assert_same(interpolate(Motor::IDENTITY, end.into(), T::ONE), end.into(), 4.0);
        }
        let path = ScrewPath::new(Motor::IDENTITY, end.into());
        assert_eq!((path.start(), path.end()), (Motor::IDENTITY, end.into()));
        assert_eq!((Rotor::IDENTITY.nlerp(end, T::ONE), Rotor::IDENTITY.slerp(end, T::ONE)), (end, end));
    }
}

fn translations<T: Float>() {
    for (_, interpolate) in interpolations() {
        for t in [-1.0, 0.0, 0.25, 0.5, 1.0, 2.0] {
            for end in [by(9.0, -2.0), -by::<T>(9.0, -2.0)] {
                let found = interpolate(by(1.0, 2.0), end, T::from_f64(t));
                assert_eq!(found, by(1.0 + 8.0 * t, 2.0 - 4.0 * t), "exact: all numbers are short");
            }
        }
    }
}

fn backwards<T: Float>() {
    for a in motors::<T>() {
        for b in motors() {
            for (name, interpolate) in interpolations() {
                if is_tie(a.reverse() * b) || name == "log_lerp" && (is_tie(a) || is_tie(b)) {
                    continue;
                }
                for t in [0.0, 0.25, 0.5, 0.75, 1.0] {
                    let (there, back) = (T::from_f64(t), T::from_f64(1.0 - t));
                    assert_same_motion(interpolate(a, b, there), interpolate(b, a, back), 2.0 * ROUNDING);
                }
            }
        }
    }
}

fn one_path<T: Float>() {
    for a in motors::<T>() {
        for b in motors() {
            if is_tie(a.reverse() * b) {
                continue;
            }
            for t in [-1.0, 0.0, 0.3, 0.5, 1.0, 2.0] {
                let t = T::from_f64(t);
                assert_same(a.slerp(b, t), a.screw_lerp(b, t), 4.0 * ROUNDING);
            }
            let half = T::from_ratio(1, 2);
            assert_same(a.nlerp(b, half), a.screw_lerp(b, half), 2.0 * ROUNDING);
        }
    }
}

fn kept_path<T: Float>() {
    for a in motors::<T>() {
        for b in motors() {
            let path = ScrewPath::new(a, b);
            assert_eq!((path.start(), path.end()), (path.at(T::ZERO), path.at(T::ONE)));
            assert!(path.start() == a && (path.end() == b || path.end() == -b));
            let step = (path.generator() * T::from_ratio(1, 4)).exp();
            for t in [-1.0, 0.0, 0.25, 0.5, 0.75, 1.0] {
                assert_eq!(path.at(T::from_f64(t)), a.screw_lerp(b, T::from_f64(t)));
                assert_same(path.at(T::from_f64(t)) * step, path.at(T::from_f64(t + 0.25)), 2.0 * ROUNDING);
            }
        }
    }
}

fn equivariance<T: Float>() {
    let carry = turn::<T>([2.0, 1.0], 1.3);
    let (a, b) = (turn([1.0, 2.0], 0.7), turn([-3.0, 0.5], 2.0));
    for t in [-0.5, 0.0, 0.3, 0.8, 1.5] {
        let t = T::from_f64(t);
        for interpolate in [Motor::nlerp, Motor::slerp, Motor::screw_lerp] as [Interpolation<T>; 3] {
            let path = interpolate(a, b, t);
            assert_same(interpolate(carry * a, carry * b, t), carry * path, 2.0 * ROUNDING);
            assert_same(interpolate(a * carry, b * carry, t), path * carry, 2.0 * ROUNDING);
        }
        assert_same((carry * a).split_lerp(carry * b, t), carry * a.split_lerp(b, t), 2.0 * ROUNDING);
        let around = |motor| carry.transform_motor(motor);
        assert_same(around(a).log_lerp(around(b), t), around(a.log_lerp(b, t)), 2.0 * ROUNDING);
    }
}

fn not_finite<T: Float>() {
    let (motor, half) = (turn::<T>([1.0, 2.0], 0.7), T::from_ratio(1, 2));
    let nan = T::from_f64(f64::NAN);
    for (_, interpolate) in interpolations() {
        assert!(!interpolate(motor, Motor { e12: nan, ..motor }, half).is_finite());
        assert!(!interpolate(Motor { e01: nan, ..motor }, motor, half).is_finite());
        assert!(!interpolate(motor, motor.reverse(), nan).is_finite());
    }
}

fn blend_order<T: Float>() {
    // Half a turn and none are perpendicular: their scalar product is exactly 0.
    let half_turn = Motor { s: T::ZERO, ..turn([1.0, 2.0], PI) };
    let far = turn([-3.0, 0.5], 2.9);
    let inputs = [half_turn, -Motor::IDENTITY, by(3.0, -4.0), far, -far, turn([1.0, 2.0], 0.7)];
    let equal = inputs.map(|motor| (motor, T::ONE));
    let mut different = equal;
    different
        .iter_mut()
        .zip([1.0, -0.25, 2.0, 2.0, 0.5, 0.0])
        .for_each(|(input, weight)| input.1 = T::from_f64(weight));
    for mut inputs in [equal, different] {
        let expected = blend(&inputs).unwrap();
        for order in 0..30 {
            inputs.rotate_left(1);
            inputs.swap(0, 1 + order % 5);
            assert_same(blend(&inputs).unwrap(), expected, 4.0 * ROUNDING);
        }
    }
    assert_same_motion(blend(&equal.map(|(m, w)| (-m, w))).unwrap(), blend(&equal).unwrap(), 4.0 * ROUNDING);
    let (a, b, quarter) = (turn([1.0, 2.0], 0.7), turn([-3.0, 0.5], 2.0), T::from_ratio(1, 4));
    assert_same_motion(blend(&[(a, T::ONE - quarter), (b, quarter)]).unwrap(), a.nlerp(b, quarter), 2.0 * ROUNDING);
}

fn blend_none<T: Float>() {
    let motor = turn::<T>([1.0, 2.0], 0.7);
    let (one, minus_one, nan) = (T::ONE, T::from_ratio(-1, 1), T::from_f64(f64::NAN));
    assert_eq!(blend::<T>(&[]), None);
    assert_eq!(blend(&[(motor, T::ZERO)]), None);
    assert_eq!(blend(&[(motor, one), (motor * motor, minus_one)]), None, "weights that add up to 0");
    assert_eq!(blend(&[(motor, nan), (motor, one)]), None);
    assert_eq!(blend(&[(Motor { e01: nan, ..motor }, T::ZERO), (motor, one)]), None, "whatever its weight");
    // A turn by 60 degrees this way and that way, less what they have in common: twice the cosine of 30 degrees.
    let sixth = turn::<T>([0.0, 0.0], PI / 3.0);
    let cancelling = [(sixth, one), (sixth.reverse(), one), (Motor::IDENTITY, T::from_f64(-3_f64.sqrt()))];
    assert_eq!(blend(&cancelling), None);
}

fn joint<T: Float>() {
    for rest in motors::<T>() {
        for animated in motors() {
            assert_eq!(interpolate_joint(rest, animated, T::ZERO), rest);
            let end = interpolate_joint(rest, animated, T::ONE);
            assert!(end == animated || end == -animated);
        }
    }
}

fn rotors<T: Float>() {
    for a in motors::<T>() {
        for b in motors() {
            for t in [-1.0, 0.0, 0.25, 1.0, 2.0] {
                let (a, b, t) = (a.rotor(), b.rotor(), T::from_f64(t));
                assert_same(a.slerp(b, t).into(), Motor::from(a).slerp(b.into(), t), ROUNDING);
                assert_same(a.nlerp(b, t).into(), Motor::from(a).nlerp(b.into(), t), ROUNDING);
            }
        }
    }
}

#[test]
fn slerp_between_equal_motors_needs_the_reverse_in_the_scalar_product() {
    // Without it the product of cos x - sin x e12 with itself is cos 2 x, and the weights at 1/2 add up to 1/cos x.
    let motor = turn::<f64>([0.0, 0.0], 1.2);
    let angle = (motor * motor).s.acos();
    let weight = (angle / 2.0).sin() / angle.sin();
    let trap = motor * weight + motor * weight;
    assert!((trap.norm() - 1.0 / 0.6_f64.cos()).abs() < 8.0 * f64::EPSILON && trap.norm() > 1.2);
    assert_same(motor.slerp(motor, 0.5), motor, 4.0);
}

#[test]
fn split_lerp_moves_the_origin_straight_and_screw_lerp_in_an_arc() {
    let (a, b) = (Motor::<f64>::IDENTITY, by(4.0, 0.0) * turn([0.0, 0.0], PI / 2.0));
    let near =
        |found: Point<f64>, x: f64, y: f64| assert!(found.distance_to_point(Point::new(x, y)) <= 1e-14, "{found}");
    near(a.split_lerp(b, 0.5).transform_origin(), 2.0, 0.0);
    // About (2, 2), from which both ends are at a distance of the square root of 8.
    near(a.screw_lerp(b, 0.5).transform_origin(), 2.0, 2.0 - 8_f64.sqrt());
}
