//! What the interpolations promise, in both precisions, and two mistakes of textbooks that they do not make.
//!
//! Tolerances: errors are measured in EPSILON, separately for the Euclidean part, whose norm is 1, and for the ideal
//! part, over the largest ideal norm among what goes in, or 1. An interpolation is at most three kernels in a row (a
//! product, a logarithm, an exponential, or sums, a root and a product), each at most 8 roundings deep on numbers below
//! 2 in these units. With half an EPSILON for each rounding that is 3 * 8 * 2 / 2 = 24; extrapolated by the factor |t|
//! as much more.

use super::*;
use crate::precision::in_both_precisions;
use crate::{Direction, Point};
use alloc::vec::Vec;
use core::fmt::{Debug, Display};

const ROUNDING: f64 = 24.0;

trait Float: Real + Debug + Display {}
impl Float for f32 {}
impl Float for f64 {}

/// Errors of the Euclidean and the ideal part in EPSILON.
fn errors<T: Real>(found: Motor<T>, expected: Motor<T>, size: f64) -> f64 {
    let error = found - expected;
    let ideal = error.ideal_norm().to_f64() / size.max(1.0);
    let larger = |a: f64, b: f64| if b > a || b.is_nan() { b } else { a };
    larger(error.norm().to_f64(), ideal) / T::EPSILON.to_f64()
}

#[track_caller]
fn assert_same<T: Float>(found: Motor<T>, expected: Motor<T>, size: f64, bound: f64) {
    let off = errors(found, expected, size);
    assert!(off <= bound, "expected {expected}, found {found}, off by {off} EPSILON");
}

/// As motions: up to the sign.
#[track_caller]
fn assert_same_motion<T: Float>(found: Motor<T>, expected: Motor<T>, size: f64, bound: f64) {
    let expected = if errors(found, -expected, size) < errors(found, expected, size) { -expected } else { expected };
    assert_same(found, expected, size, bound);
}

#[track_caller]
fn assert_unit<T: Float>(motor: Motor<T>, size: f64) {
    let [norm, study] = motor.relation_errors().map(|error| error.abs().to_f64() / T::EPSILON.to_f64());
    assert!(norm <= ROUNDING && study <= ROUNDING * size.max(1.0), "{motor}: {norm}, {study}");
}

fn direction<T: Real>([x, y, z]: [f64; 3]) -> Direction<T> {
    Direction::new(T::from_f64(x), T::from_f64(y), T::from_f64(z))
}

fn screw<T: Real>(point: [f64; 3], axis: [f64; 3], angle: f64, distance: f64) -> Motor<T> {
    let line = (Point::ORIGIN + direction(point)) & direction(axis);
    Motor::from_screw(line, T::from_f64(angle), T::from_f64(distance)).unwrap()
}

/// How far motions here reach: axes are up to 3 from the origin and slides up to 8 long.
const SIZE: f64 = 10.0;

fn motors<T: Real>() -> Vec<Motor<T>> {
    let mut motors = Vec::from([Motor::IDENTITY, Translator::from_vector(direction([3.0, -4.0, 1.0])).into()]);
    for angle in [1e-30, 1e-9, 1e-3, 0.7, 2.0, 3.0, core::f64::consts::PI, -2.9] {
        motors.push(screw([1.0, 0.0, 2.0], [0.0, 0.6, 0.8], angle, 0.0));
        motors.push(-screw::<T>([0.0, -3.0, 0.5], [1.0, 2.0, -2.0], angle, 8.0));
    }
    motors
}

type Interpolation<T> = fn(Motor<T>, Motor<T>, T) -> Motor<T>;

fn interpolations<T: Real>() -> [(&'static str, Interpolation<T>); 5] {
    [
        ("nlerp", Motor::nlerp),
        ("slerp", Motor::slerp),
        ("screw_lerp", Motor::screw_lerp),
        ("split_lerp", Motor::split_lerp),
        ("log_lerp", Motor::log_lerp),
    ]
}

fn half<T: Real>() -> T {
    T::from_ratio(1, 2)
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
    the_middle_is_the_same_for_nlerp_slerp_and_screw_lerp: middle;
    extrapolation_goes_on_along_the_screw: extrapolation;
    screw_lerp_has_a_constant_twist: constant_twist;
    a_kept_path_gives_the_same_bits: kept_path;
    nlerp_slerp_and_screw_lerp_go_with_their_ends: equivariance;
    split_lerp_goes_with_the_world_and_log_lerp_with_both: partial_equivariance;
    slerp_turns_evenly_and_eases_the_slide: slerp_speed;
    what_is_not_finite_gives_nan: not_finite;
    blend_does_not_depend_on_the_order: blend_order;
    blend_of_two_is_nlerp: blend_of_two;
    blend_depends_on_the_proportions_of_weights_only: blend_scale;
    blend_of_nothing_is_none: blend_none;
    joints_move_from_rest_to_animated: joint;
    rotors_turn_as_the_motors_they_are: rotors;
}

fn ends<T: Float>() {
    // The issue asks for 4 units in the last place; an ulp of a norm in [1, 2) is EPSILON, of one below half of it.
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
                    assert_unit(interpolate(a, b, T::from_f64(t)), 4.0 * SIZE);
                }
            }
        }
    }
}

fn short_way<T: Float>() {
    let (a, b) =
        (screw::<T>([1.0, 0.0, 0.0], [0.0, 0.0, 1.0], 0.2, 1.0), screw([1.0, 0.0, 0.0], [0.0, 0.0, 1.0], 1.4, 3.0));
    let between = screw([1.0, 0.0, 0.0], [0.0, 0.0, 1.0], 0.8, 2.0);
    for (name, interpolate) in interpolations() {
        for (a, b, expected) in [(a, b, between), (a, -b, between), (-a, b, -between), (-a, -b, -between)] {
            let found = interpolate(a, b, half());
            // Turn and translation apart take another path for the translation.
            assert_same(found.rotor().into(), expected.rotor().into(), 1.0, ROUNDING);
            if name != "split_lerp" {
                assert_same(found, expected, SIZE, ROUNDING);
            }
        }
    }
}

fn stays_put<T: Float>() {
    let half_turn = Motor::from(Rotor::new(T::ZERO, T::ZERO, T::ZERO, T::ONE));
    for motor in motors::<T>().into_iter().chain([half_turn]) {
        for (_, interpolate) in interpolations() {
            for other in [motor, -motor] {
                for t in [-2.0, 0.0, 0.3, 0.5, 1.0, 3.0] {
                    assert_same(interpolate(motor, other, T::from_f64(t)), motor, SIZE, 3.0 * ROUNDING);
                }
            }
        }
    }
}

fn half_turns<T: Float>() {
    for a in motors::<T>() {
        for distance in [0.0, 5.0] {
            // With a scalar part of exactly 0.
            let turn = Motor { s: T::ZERO, ..screw([1.0, 0.0, 0.0], [0.0, 0.0, 1.0], core::f64::consts::PI, 0.0) };
            let turn = turn * Translator::from_vector(direction([0.0, 0.0, distance]));
            assert_eq!(turn.s, T::ZERO);
            for b in [a * turn, -(a * turn)] {
                for (name, interpolate) in interpolations() {
                    let middle = interpolate(a, b, half());
                    assert_unit(middle, 4.0 * SIZE);
                    if matches!(name, "nlerp" | "slerp" | "screw_lerp") {
                        assert_same_motion((a.reverse() * middle) * (a.reverse() * middle), turn, 4.0 * SIZE, ROUNDING);
                    }
                }
            }
        }
    }
}

/// Neither end is nearer where the scalar product is exactly 0.
fn ties<T: Float>() {
    let half_turn = Rotor::new(T::ZERO, T::ONE, T::ZERO, T::ZERO);
    for end in [half_turn, -half_turn] {
        for (_, interpolate) in interpolations() {
            assert_same(interpolate(Motor::IDENTITY, end.into(), T::ONE), end.into(), 1.0, 4.0);
        }
        let path = ScrewPath::new(Motor::IDENTITY, end.into());
        assert_eq!((path.start(), path.end()), (Motor::IDENTITY, end.into()));
        assert_eq!((Rotor::IDENTITY.nlerp(end, T::ONE), Rotor::IDENTITY.slerp(end, T::ONE)), (end, end));
    }
}

fn translations<T: Float>() {
    let by = |x: f64, y: f64| Motor::<T>::from(Translator::from_vector(direction([x, y, 0.0])));
    for (_, interpolate) in interpolations() {
        for t in [-1.0, 0.0, 0.25, 0.5, 1.0, 2.0] {
            for sign in [by(0.0, 0.0), -by(0.0, 0.0)] {
                let found = interpolate(by(1.0, 2.0), by(9.0, -2.0) * sign, T::from_f64(t));
                assert_eq!(found, by(1.0 + 8.0 * t, 2.0 - 4.0 * t), "exact: all numbers are short");
            }
        }
    }
}

fn backwards<T: Float>() {
    for a in motors::<T>() {
        for b in motors() {
            for (name, interpolate) in interpolations() {
                // Beside the tie the two directions of screws may take the two ways of half a turn.
                let tie = (a.reverse() * b).s.abs() <= T::EPSILON * T::from_ratio(8, 1);
                if tie || name == "log_lerp" && (a.s.abs() <= T::EPSILON || b.s.abs() <= T::EPSILON) {
                    continue;
                }
                for t in [0.0, 0.25, 0.5, 0.75, 1.0] {
                    let (t, back) = (T::from_f64(t), T::from_f64(1.0 - t));
                    assert_same_motion(interpolate(a, b, t), interpolate(b, a, back), 4.0 * SIZE, 2.0 * ROUNDING);
                }
            }
        }
    }
}

fn middle<T: Float>() {
    for a in motors::<T>() {
        for b in motors() {
            let nlerp = a.nlerp(b, half());
            if (a.reverse() * b).s.abs() > T::EPSILON * T::from_ratio(8, 1) {
                assert_same(nlerp, a.screw_lerp(b, half()), 4.0 * SIZE, 2.0 * ROUNDING);
                assert_same(nlerp, a.slerp(b, half()), 4.0 * SIZE, 2.0 * ROUNDING);
            }
        }
    }
}

fn extrapolation<T: Float>() {
    let part = |t: f64| screw::<T>([1.0, 2.0, 0.0], [0.0, 0.6, 0.8], 0.8 * t, 2.0 * t);
    for t in [-3.0, -0.5, 1.5, 4.0] {
        assert_same_motion(part(0.0).screw_lerp(part(1.0), T::from_f64(t)), part(t), SIZE, 4.0 * ROUNDING);
        // Of a turn without a slide the great arc is the same.
        let turn = |t: f64| screw::<T>([1.0, 2.0, 0.0], [0.0, 0.6, 0.8], 0.8 * t, 0.0);
        assert_same_motion(turn(0.0).slerp(turn(1.0), T::from_f64(t)), turn(t), SIZE, 4.0 * ROUNDING);
    }
}

fn constant_twist<T: Float>() {
    for a in motors::<T>() {
        for b in motors() {
            let path = ScrewPath::new(a, b);
            let step = (path.generator() * T::from_ratio(1, 4)).exp();
            for t in [-0.5, 0.0, 0.25, 0.5, 0.75, 1.0] {
                let (here, next) = (path.at(T::from_f64(t)), path.at(T::from_f64(t + 0.25)));
                assert_same(here * step, next, 4.0 * SIZE, 2.0 * ROUNDING);
            }
            // Part of the path is the path between its ends.
            let part = path.at(T::from_ratio(1, 4)).screw_lerp(path.at(T::from_ratio(3, 4)), T::from_ratio(1, 4));
            assert_same(part, path.at(T::from_ratio(3, 8)), 4.0 * SIZE, 2.0 * ROUNDING);
        }
    }
}

fn kept_path<T: Float>() {
    for a in motors::<T>() {
        for b in motors() {
            let path = ScrewPath::new(a, b);
            assert_eq!((path.start(), path.end()), (path.at(T::ZERO), path.at(T::ONE)));
            assert!(path.start() == a && (path.end() == b || path.end() == -b));
            for t in [-1.0, 0.0, 0.3, 0.5, 0.7, 1.0, 2.0] {
                assert_eq!(path.at(T::from_f64(t)), a.screw_lerp(b, T::from_f64(t)));
            }
        }
    }
}

fn equivariance<T: Float>() {
    let carry = screw::<T>([0.0, 2.0, 1.0], [1.0, 0.0, 1.0], 1.3, 4.0);
    let (a, b) =
        (screw([1.0, 0.0, 2.0], [0.0, 0.6, 0.8], 0.7, 1.0), screw([0.0, -3.0, 0.5], [1.0, 2.0, -2.0], 2.0, 8.0));
    for interpolate in [Motor::nlerp, Motor::slerp, Motor::screw_lerp] as [Interpolation<T>; 3] {
        for t in [-0.5, 0.0, 0.3, 0.8, 1.5] {
            let t = T::from_f64(t);
            let path = interpolate(a, b, t);
            assert_same(interpolate(carry * a, carry * b, t), carry * path, 4.0 * SIZE, 2.0 * ROUNDING);
            assert_same(interpolate(a * carry, b * carry, t), path * carry, 4.0 * SIZE, 2.0 * ROUNDING);
        }
    }
}

fn partial_equivariance<T: Float>() {
    let carry = screw::<T>([0.0, 2.0, 1.0], [1.0, 0.0, 1.0], 1.3, 4.0);
    let (a, b) =
        (screw([1.0, 0.0, 2.0], [0.0, 0.6, 0.8], 0.7, 1.0), screw([0.0, -3.0, 0.5], [1.0, 2.0, -2.0], 2.0, 8.0));
    for t in [-0.5, 0.0, 0.3, 0.8, 1.5] {
        let t = T::from_f64(t);
        assert_same((carry * a).split_lerp(carry * b, t), carry * a.split_lerp(b, t), 4.0 * SIZE, 2.0 * ROUNDING);
        let around = |motor| carry.transform_motor(motor);
        assert_same(around(a).log_lerp(around(b), t), around(a.log_lerp(b, t)), 4.0 * SIZE, 2.0 * ROUNDING);
    }
    // And no further: these differ by much more than rounding.
    let far = |found, expected| errors::<T>(found, expected, SIZE) * T::EPSILON.to_f64() > 1e-2;
    assert!(far((a * carry).split_lerp(b * carry, half()), a.split_lerp(b, half()) * carry));
    assert!(far((carry * a).log_lerp(carry * b, half()), carry * a.log_lerp(b, half())));
}

fn slerp_speed<T: Float>() {
    for h in [0.1_f64, 0.8, 1.5] {
        for t in [0.1, 0.25, 0.6, 0.9] {
            let (point, axis) = ([1.0, 0.0, 2.0], [0.0, 0.6, 0.8]);
            let slid = (1.0 + ((2.0 * t - 1.0) * h).sin() / h.sin()) / 2.0;
            let expected = screw(point, axis, 2.0 * h * t, 5.0 * slid);
            let found = Motor::IDENTITY.slerp(screw::<T>(point, axis, 2.0 * h, 5.0), T::from_f64(t));
            assert_same(found, expected, SIZE, 2.0 * ROUNDING);
        }
    }
}

fn not_finite<T: Real>() {
    let motor = screw::<T>([1.0, 0.0, 2.0], [0.0, 0.6, 0.8], 0.7, 1.0);
    let nan = T::from_f64(f64::NAN);
    for (_, interpolate) in interpolations() {
        assert!(!interpolate(motor, Motor { e31: nan, ..motor }, half()).is_finite());
        assert!(!interpolate(Motor { e02: nan, ..motor }, motor, half()).is_finite());
        assert!(!interpolate(motor, Motor { s: T::from_f64(f64::INFINITY), ..motor }, half()).is_finite());
        assert!(!interpolate(motor, motor.reverse(), nan).is_finite());
    }
}

fn blend_order<T: Float>() {
    let turns = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|axis| {
        // Exactly half turns about perpendicular axes: their scalar products are 0.
        let slide = Translator::from_vector(direction(axis.map(|x| 2.0 * x)));
        let [x, y, z] = axis.map(T::from_f64);
        Rotor::new(T::ZERO, x, y, z) * slide
    });
    let far = -screw::<T>([1.0, 0.0, 2.0], [0.0, 0.6, 0.8], 2.9, 1.0);
    let inputs = [turns[0], turns[1], -turns[2], far, -far, -Motor::IDENTITY];
    let equal = inputs.map(|motor| (motor, T::ONE));
    let mut different = equal;
    different.iter_mut().enumerate().for_each(|(i, input)| input.1 = T::from_f64([1.0, -0.25, 2.0, 2.0, 0.5, 0.0][i]));
    for mut inputs in [equal, different] {
        let expected = blend(&inputs).unwrap();
        assert_unit(expected, SIZE);
        for order in 0..30 {
            inputs.rotate_left(1);
            inputs.swap(0, 1 + order % 5);
            assert_same(blend(&inputs).unwrap(), expected, SIZE, 4.0 * ROUNDING);
        }
    }
    // Each with the other sign: the same mean up to the sign of the reference.
    assert_same_motion(blend(&equal.map(|(m, w)| (-m, w))).unwrap(), blend(&equal).unwrap(), SIZE, 4.0 * ROUNDING);
}

fn blend_of_two<T: Float>() {
    for a in motors::<T>() {
        assert_same(blend(&[(a, T::from_f64(0.3))]).unwrap(), a, SIZE, 4.0);
        for b in motors() {
            if (a.reverse() * b).s.abs() <= T::EPSILON * T::from_ratio(8, 1) {
                continue;
            }
            // At 5/4 the weights are -1/4 and 5/4.
            for t in [0.0, 0.25, 0.5, 0.75, 1.0, 1.25] {
                let t = T::from_f64(t);
                let mean = blend(&[(a, T::ONE - t), (b, t)]).unwrap();
                assert_same_motion(mean, a.nlerp(b, t), 4.0 * SIZE, 2.0 * ROUNDING);
            }
        }
    }
}

fn blend_scale<T: Float>() {
    let largest = T::from_f64(if T::EPSILON.to_f64() < 1e-10 { 1e300 } else { 1e37 });
    for a in motors::<T>() {
        for b in motors() {
            let mean = |scale: T| blend(&[(a, scale), (b, scale * T::from_ratio(3, 1))]).unwrap();
            for scale in [largest, T::ONE / largest, T::from_ratio(-1, 1)] {
                assert_same(mean(scale), mean(T::ONE), SIZE, 4.0);
            }
        }
    }
}

fn blend_none<T: Float>() {
    let motor = screw::<T>([1.0, 0.0, 2.0], [0.0, 0.6, 0.8], 0.7, 1.0);
    let (one, minus_one, nan) = (T::ONE, T::from_ratio(-1, 1), T::from_f64(f64::NAN));
    assert_eq!(blend::<T>(&[]), None);
    assert_eq!(blend(&[(motor, T::ZERO)]), None);
    assert_eq!(blend(&[(motor, one), (motor * motor, minus_one)]), None, "weights that add up to 0");
    let tenths = [1, 2, -3].map(|tenths| (motor, T::from_ratio(tenths, 10)));
    assert_eq!(blend(&tenths), None, "0 to rounding: 0.1 + 0.2 - 0.3 is not 0");
    assert_eq!(blend(&[(motor, nan), (motor, one)]), None);
    assert_eq!(blend(&[(motor, T::from_f64(f64::INFINITY))]), None);
    assert_eq!(blend(&[(Motor { e01: nan, ..motor }, T::ZERO), (motor, one)]), None, "whatever its weight");
    // A turn by 60 degrees this way and that way, less what they have in common: twice the cosine of 30 degrees.
    let turn = |angle: f64| screw::<T>([0.0; 3], [0.0, 0.0, 1.0], angle, 0.0);
    let sixth = core::f64::consts::FRAC_PI_3;
    let common = |weight: f64| [(turn(sixth), one), (turn(-sixth), one), (Motor::IDENTITY, T::from_f64(weight))];
    assert_eq!(blend(&common(-3_f64.sqrt())), None);
    assert!(blend(&common(-1.73)).is_some());
    let huge = T::from_f64(if T::EPSILON.to_f64() < 1e-10 { 1e308 } else { 3e38 });
    let far = Motor { e01: huge, ..Motor::IDENTITY };
    assert_eq!(blend(&[(far, T::from_ratio(-3, 1)), (-Motor { e01: -huge, ..far }, T::from_ratio(4, 1))]), None);
}

fn joint<T: Float>() {
    for rest in motors::<T>() {
        for animated in motors() {
            assert_eq!(interpolate_joint(rest, animated, T::ZERO), rest);
            let end = interpolate_joint(rest, animated, T::ONE);
            assert!(end == animated || end == -animated);
            let twice = interpolate_joint(rest, animated, T::from_ratio(2, 1));
            let step = rest.reverse() * animated;
            assert_same_motion(twice, animated * step, 4.0 * SIZE, 2.0 * ROUNDING);
        }
    }
}

fn rotors<T: Float>() {
    for a in motors::<T>() {
        for b in motors() {
            for t in [-1.0, 0.0, 0.25, 1.0, 2.0] {
                let (a, b, t) = (a.rotor(), b.rotor(), T::from_f64(t));
                let as_motors = (Motor::from(a), Motor::from(b));
                assert_same(a.slerp(b, t).into(), as_motors.0.slerp(as_motors.1, t), 1.0, ROUNDING);
                assert_same(a.nlerp(b, t).into(), as_motors.0.nlerp(as_motors.1, t), 1.0, ROUNDING);
            }
        }
    }
}

/// Great-arc weights on all eight coefficients from any scalar product, as textbooks have them.
fn textbook_slerp(
    a: Motor<f64>,
    b: Motor<f64>,
    t: f64,
    product: fn(Motor<f64>, Motor<f64>) -> f64,
) -> EvenMultivector<f64> {
    let angle = product(a, b).acos();
    a * (((1.0 - t) * angle).sin() / angle.sin()) + b * ((t * angle).sin() / angle.sin())
}

#[test]
fn slerp_between_equal_motors_needs_the_reverse_in_the_scalar_product() {
    // Without it the product of m = cos x + sin x l with itself is cos^2 x - sin^2 x = cos 2 x, not 1.
    let without_reverse: fn(Motor<f64>, Motor<f64>) -> f64 = |a, b| (a * b).s;
    let (x, axis) = (0.6_f64, Direction::new(0.0, 0.6, 0.8));
    let turn = Motor::from(Rotor::from_axis_angle(axis, 2.0 * x).unwrap());
    assert!((without_reverse(turn, turn) - (2.0 * x).cos()).abs() < 4.0 * f64::EPSILON);
    // So twice the weight at t = 1/2 is sin x / sin 2 x * 2 = 1/cos x: the norm is 1.2 where it should be 1.
    let trap = textbook_slerp(turn, turn, 0.5, without_reverse);
    assert!((trap.norm() - 1.0 / x.cos()).abs() < 8.0 * f64::EPSILON && trap.norm() > 1.2);
    assert_same(turn.slerp(turn, 0.5), turn, 1.0, 4.0);

    // Between translators any product is 1, the angle 0, and its sine divides 0.
    let step = Motor::from(Translator::from_vector(Direction::new(4.0, 0.0, 0.0)));
    assert!(!textbook_slerp(Motor::IDENTITY, step, 0.5, without_reverse).is_finite());
    assert_eq!(Motor::IDENTITY.slerp(step, 0.5).transform_origin(), Point::new(2.0, 0.0, 0.0));
}

#[test]
fn slerp_of_a_screw_must_come_back_to_the_study_quadric() {
    let end = screw::<f64>([1.0, 0.0, 2.0], [0.0, 0.6, 0.8], 2.0, 6.0);
    let study = |even: EvenMultivector<f64>| crate::kernels::even_study(even).e0123.abs();
    // From 1 to cos h - sin h l + (slide/2) sin h e0123 + ..., sin h = 0.84: halfway both weights are
    // w = 1/(2 cos(h/2)) = 0.57, s = w (1 + cos h) = 0.88, p = w 3 sin h = 1.44, b.c = w^2 3 sin h cos h = 0.44;
    // s p - b.c = 3 w^2 sin h = 0.82, where a motor has 0.
    let trap = textbook_slerp(Motor::IDENTITY, end, 0.5, |a, b| (a.reverse() * b).s);
    assert!((trap.norm() - 1.0).abs() < 8.0 * f64::EPSILON, "the norm is right");
    assert!((study(trap) - 0.82).abs() < 0.005, "off the quadric by {}", study(trap));
    let ours = Motor::IDENTITY.slerp(end, 0.5);
    assert!(study(ours.into()) <= ROUNDING * SIZE * f64::EPSILON);
    // A point one from the axis goes to where only the rotor turns it: the sandwich with the other is no motion.
    assert_same(ours, screw([1.0, 0.0, 2.0], [0.0, 0.6, 0.8], 1.0, 3.0), SIZE, ROUNDING);
}

#[test]
fn log_lerp_takes_the_long_way_between_opposite_half_turns() {
    let (a, b) = (Motor::from(Rotor::about_x(3.0)), Motor::from(Rotor::about_x(-3.0)));
    assert_same(a.log_lerp(b, 0.5), Motor::IDENTITY, 1.0, ROUNDING);
    assert_same_motion(a.screw_lerp(b, 0.5), Motor::from(Rotor::about_x(core::f64::consts::PI)), 1.0, ROUNDING);
}

#[test]
fn small_and_large_motions_keep_their_digits() {
    for angle in [f64::MIN_POSITIVE, 1e-300, 1e-160, 1e-9] {
        for distance in [0.0, 1.0, 1e6] {
            let end = screw::<f64>([0.0; 3], [0.0, 0.0, 1.0], angle, distance);
            for interpolate in [Motor::nlerp, Motor::slerp, Motor::screw_lerp, Motor::split_lerp, Motor::log_lerp] {
                let quarter: Motor<f64> = interpolate(Motor::IDENTITY, end, 0.25);
                // Relative to each of the two coefficients that count.
                let off =
                    [quarter.e12 / (end.e12 / 4.0), quarter.e03 / (end.e03 / 4.0)].map(|ratio| (ratio - 1.0).abs());
                assert!(off[0] <= 8.0 * f64::EPSILON, "{angle:e}, {distance:e}: {quarter}");
                assert!(distance == 0.0 || off[1] <= 8.0 * f64::EPSILON, "{angle:e}, {distance:e}: {quarter}");
            }
        }
    }
}
