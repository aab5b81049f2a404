//! NaN in gives NaN out, or `None`; what is infinite gives what is not finite; nothing panics.

use crate::interpolation::at;
use crate::law::{Law, laws};
use crate::motion::{Motion, Parts};
use pga_motor::{Motor, Point, UnitLine, UnitPlane, pga2d};

laws! {
    what_is_not_finite_shows_in_exp
    what_is_not_finite_shows_in_log_roots_and_normalization
    what_is_not_finite_shows_in_interpolation
}

/// The value with each coefficient in turn NaN, and infinite either way.
fn spoiled<P: Parts>(value: P) -> Vec<P> {
    let mut spoiled = Vec::new();
    for (part, i) in (0..3).flat_map(|part| (0..4).map(move |i| (part, i))) {
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let mut parts = value.parts();
            parts[part][i] = bad;
            // Coefficients that the type does not have are dropped.
            let value = P::from_parts(parts);
            spoiled.extend((!value.is_all_finite()).then_some(value));
        }
    }
    spoiled
}

#[track_caller]
fn assert_shows<I: Parts, O: Parts>(name: &str, spoiled: I, found: Option<O>) {
    let Some(found) = found else { return };
    assert!(!found.is_all_finite(), "{name} of {spoiled:?} is {found:?}");
    assert!(!spoiled.has_nan() || found.has_nan(), "{name} of {spoiled:?} is {found:?}");
}

/// The special and some common ones.
fn generators<M: Motion>() -> Vec<M::Generator> {
    let mut generators = Vec::new();
    for half_angle in [0.0, 1e-30, 0.7, std::f64::consts::FRAC_PI_2, 2.0, std::f64::consts::PI] {
        for moment in [[0.0; 3], [0.0, 0.0, 2.0], [1.0, -2.0, 3.0]] {
            generators.push(M::generator([0.0, 0.0, half_angle], moment));
            generators.push(M::generator([0.6 * half_angle, 0.0, -0.8 * half_angle], moment));
        }
    }
    generators
}

fn motors<M: Motion>() -> Vec<M> {
    let half_turn = M::half_turn([0.0, 1.0, 0.0], [1.0, 2.0, 3.0]);
    generators::<M>().into_iter().map(M::exp).chain([half_turn]).flat_map(|motor| [motor, -motor]).collect()
}

/// In the plane the logarithm takes an infinite scalar part for that of no turn, as its documentation says.
fn counts_as_no_turn<M: Motion>(motor: M) -> bool {
    !M::IN_SPACE && motor.scalar().is_infinite()
}

fn what_is_not_finite_shows_in_exp<M: Motion>(_: &Law) {
    for b in generators::<M>().into_iter().flat_map(spoiled) {
        assert_shows("exp", b, Some(M::exp(b)));
    }
}

fn what_is_not_finite_shows_in_log_roots_and_normalization<M: Motion>(_: &Law) {
    for m in motors::<M>().into_iter().flat_map(spoiled) {
        if !counts_as_no_turn(m) {
            assert_shows("log", m, Some(m.log()));
            assert_shows("log_double_cover", m, m.log_double_cover());
            assert_shows("powf", m, Some(m.powf(0.3)));
        }
        assert_shows("sqrt", m, Some(m.sqrt()));
        assert_shows("sqrt_double_cover", m, m.sqrt_double_cover());
        assert_shows("renormalize", m, Some(m.renormalize()));
        assert_eq!(M::normalize(m.scaled(2.0, 0.5)), None, "normalize {m:?}");
    }
    for m in motors::<M>() {
        assert!(m.powf(f64::NAN).has_nan());
    }
}

fn what_is_not_finite_shows_in_interpolation<M: Motion>(_: &Law) {
    let motors = motors::<M>();
    for (i, &a) in motors.iter().enumerate() {
        for b in spoiled(motors[(7 * i + 3) % motors.len()]) {
            for (name, interpolate) in M::interpolations() {
                if name == "log_lerp" && counts_as_no_turn(b) {
                    continue;
                }
                for t in [0.0, 0.3, 0.5, 1.0] {
                    assert_shows(name, b, Some(at(interpolate, a, b, t)));
                    assert_shows(name, b, Some(at(interpolate, b, a, t)));
                }
                assert!(at(interpolate, a, a, f64::NAN).has_nan(), "{name}");
            }
            assert_eq!(M::blend(&[(a, 0.5), (b, 0.5)]), None);
            assert_eq!(M::blend(&[(b, 0.0), (a, 0.5)]), None);
        }
        assert_eq!(M::blend(&[(a, f64::NAN)]), None);
    }
}

#[test]
fn what_is_not_finite_shows_in_motions_from_one_thing_to_another() {
    let plane = UnitPlane::new(0.6, 0.0, 0.8, 2.0);
    for bad in spoiled(plane) {
        assert_eq!(Motor::between_planes(plane, bad), None, "{bad:?}");
        assert_eq!(Motor::between_planes(bad, plane), None, "{bad:?}");
    }
    let line = UnitLine::new(0.6, 0.0, 0.8, 0.0, 2.0, 0.0);
    for bad in spoiled(line) {
        assert_eq!(Motor::between_lines(line, bad), None, "{bad:?}");
        assert_eq!(Motor::between_lines(bad, line), None, "{bad:?}");
    }
    let flat = pga2d::UnitLine::new(0.6, 0.8, 2.0);
    for bad in spoiled(flat) {
        assert_eq!(pga2d::Motor::between_lines(flat, bad), None, "{bad:?}");
        assert_eq!(pga2d::Motor::between_lines(bad, flat), None, "{bad:?}");
    }
    for bad in spoiled(Point::new(1.0, 2.0, 3.0)) {
        assert_shows("between_points", bad, Some(Motor::between_points(bad, Point::ORIGIN)));
    }
}

#[test]
fn what_is_not_finite_shows_in_screws_matrices_and_quaternions() {
    for m in motors::<pga_motor::f64::Motor>().into_iter().flat_map(spoiled) {
        let screw = m.screw();
        assert!(!(screw.angle.is_finite() && screw.distance.is_finite()), "{m:?} has {screw:?}");
        assert_eq!(screw.motor(), None);
        assert!(Motor::from_columns(m.to_matrix().to_columns()).is_err(), "{m:?}");
        let (quaternion, translation) = m.to_quaternion_translation();
        assert_eq!(Motor::from_quaternion_translation(quaternion, translation), None, "{m:?}");
    }
    for m in motors::<pga2d::f64::Motor>().into_iter().flat_map(spoiled) {
        assert!(pga2d::Motor::from_columns(m.to_columns()).is_err(), "{m:?}");
    }
}
