//! exp and log of many by polynomials: near the ones one by one at every angle, lanes outside the polynomials' range among
//! the others.

use pga_motor::{LengthMismatch, Line, Motor, Real, pga2d};

/// Half-angles in the range of the polynomials, at its ends, and far outside.
const HALF_ANGLES: [f64; 14] =
    [0.0, 1e-30, 1e-12, 1e-5, 0.1, 0.7, 1.5, std::f64::consts::FRAC_PI_2, 1.58, 1.5812, 3.0, 10.0, 1e3, f64::NAN];

/// Every half-angle about axes in all directions, with no, a small and a large slide.
fn lines<T: Real>() -> Vec<Line<T>> {
    let axes = [[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.36, 0.48, 0.8], [-0.6, 0.64, 0.48]];
    let moments = [[0.0, 0.0, 0.0], [0.5, -0.25, 2.0], [3e4, 1e5, -2e5]];
    let mut lines = Vec::new();
    for angle in HALF_ANGLES {
        for axis in axes {
            for moment in moments {
                let [e23, e31, e12] = axis.map(|x| T::from_f64(angle * x));
                let [e01, e02, e03] = moment.map(T::from_f64);
                lines.push(Line { e23, e31, e12, e01, e02, e03 });
            }
        }
    }
    lines
}

fn norm<const N: usize, T: Real>(coefficients: [T; N]) -> f64 {
    coefficients.iter().map(|x| x.to_f64() * x.to_f64()).sum::<f64>().sqrt()
}

/// Coefficients of the polynomials err by at most 2.2 u of Horner's roundings and the fit (`ga-codegen fit` prints them), the
/// products and sums behind them by 3 u of the terms, whose norms add up to at most 2 (1 + l) |c| for the ideal part; one by
/// one the error is at most half of that. Half-angles are below 1.6 here: together less than 40 u. Outside the range the
/// results are the same bits.
fn assert_near<T: Real, const N: usize>(found: [T; N], expected: [T; N], size: f64, in_range: bool, case: &str) {
    if expected.iter().any(|x| x.to_f64().is_nan()) {
        assert!(found.iter().any(|x| x.to_f64().is_nan()), "{case}: {:?}", found.map(T::to_f64));
        return;
    }
    let difference = norm(std::array::from_fn::<_, N, _>(|index| found[index] - expected[index]));
    let unit = T::EPSILON.to_f64() / 2.0;
    let tolerance = if in_range { 40.0 * unit * size } else { 0.0 };
    assert!(difference <= tolerance, "{case}: {difference:e} > {tolerance:e}");
}

fn agree<T: Real + std::fmt::Debug>() {
    let lines = lines::<T>();
    let mut motors = vec![Motor::IDENTITY; lines.len()];
    Line::exp_slice(&lines, &mut motors).expect("as many places as lines");
    let mut logs = vec![Line::ZERO; lines.len()];
    let signed: Vec<_> = motors.iter().enumerate().map(|(i, &m)| if i % 2 == 0 { m } else { -m }).collect();
    Motor::log_slice(&signed, &mut logs).expect("as many places as motors");
    for ((line, motor), (signed, log)) in lines.iter().zip(&motors).zip(signed.iter().zip(&logs)) {
        let case = format!("{:?}", line.to_array().map(T::to_f64));
        let (angle, moment) = (line.norm().to_f64(), line.ideal_norm().to_f64());
        let exact = line.exp();
        let (found, expected) = (motor.rotor().to_array(), exact.rotor().to_array());
        assert_near(found, expected, 1.0, angle < 1.59, &case);
        let ideal = |m: Motor<T>| [m.e01, m.e02, m.e03, m.e0123];
        assert_near(ideal(*motor), ideal(exact), 4.0 * moment, angle < 1.59, &case);
        let exact = signed.log();
        let case = format!("log of the motor of {case}");
        assert_near([log.e23, log.e31, log.e12], [exact.e23, exact.e31, exact.e12], 1.6, true, &case);
        assert_near([log.e01, log.e02, log.e03], [exact.e01, exact.e02, exact.e03], 6.0 * moment, true, &case);
    }
    let translation = Line { e23: T::ZERO, e31: T::ZERO, e12: T::ZERO, ..lines[lines.len() - 1] };
    let mut motor = [Motor::IDENTITY];
    Line::exp_slice(&[translation], &mut motor).expect("one place for one line");
    assert_eq!(motor, [translation.exp()], "translations are exact");
}

#[test]
fn exp_and_log_of_many_are_those_one_by_one() {
    agree::<f32>();
    agree::<f64>();
}

fn agree_in_the_plane<T: Real>() {
    let weights = HALF_ANGLES.iter().flat_map(|&angle| [angle, -angle]);
    let bivectors: Vec<_> = weights
        .map(|angle| pga2d::Bivector { e12: T::from_f64(angle), e01: T::from_f64(3.0), e20: T::from_f64(-1e4) })
        .collect();
    let mut motors = vec![pga2d::Motor::IDENTITY; bivectors.len()];
    pga2d::Bivector::exp_slice(&bivectors, &mut motors).expect("as many places as bivectors");
    let mut logs = vec![pga2d::Bivector::ZERO; motors.len()];
    pga2d::Motor::log_slice(&motors, &mut logs).expect("as many places as motors");
    for ((bivector, motor), log) in bivectors.iter().zip(&motors).zip(&logs) {
        let case = format!("{:?}", bivector.to_array().map(T::to_f64));
        let (exact, in_range) = (bivector.exp(), bivector.norm().to_f64() < 1.59);
        assert_near([motor.s, motor.e12], [exact.s, exact.e12], 1.0, in_range, &case);
        assert_near([motor.e01, motor.e20], [exact.e01, exact.e20], 2e4, in_range, &case);
        let exact = motor.log();
        assert_near([log.e12], [exact.e12], 1.6, true, &case);
        assert_near([log.e01, log.e20], [exact.e01, exact.e20], 3e4, true, &case);
    }
}

#[test]
fn exp_and_log_of_many_in_the_plane_are_those_one_by_one() {
    agree_in_the_plane::<f32>();
    agree_in_the_plane::<f64>();
}

#[test]
fn slices_of_any_length_are_filled_and_of_different_lengths_left_alone() {
    let lines = lines::<f32>();
    for length in [0, 1, 63, 64, 65, 128, 150] {
        let mut motors = vec![Motor::IDENTITY; length];
        assert_eq!(Line::exp_slice(&lines[..length], &mut motors), Ok(()));
        let mut alone = [Motor::IDENTITY];
        for (line, motor) in lines.iter().zip(&motors) {
            assert_eq!(Line::exp_slice(&[*line], &mut alone), Ok(()));
            assert_eq!(alone[0].to_array().map(f32::to_bits), motor.to_array().map(f32::to_bits), "{line:?}");
        }
    }
    let mut motors = [Motor::IDENTITY; 2];
    assert_eq!(Line::exp_slice(&lines[..3], &mut motors), Err(LengthMismatch { items: 3, results: 2 }));
    assert_eq!(motors, [Motor::IDENTITY; 2]);
    assert_eq!(Motor::log_slice(&motors, &mut [Line::ZERO; 3]), Err(LengthMismatch { items: 2, results: 3 }));
}
