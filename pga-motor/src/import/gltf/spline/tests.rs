//! Keys stay as near to their splines as was asked for.

use super::*;

/// Numbers from -1 to 1 that look like chance (the generator of Knuth's MMIX).
fn noise(state: &mut u64) -> f64 {
    *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
}

fn cubic<const N: usize>(state: &mut u64, spread: f64) -> Cubic<N> {
    let from: [f64; N] = core::array::from_fn(|_| noise(state));
    core::array::from_fn(|_| core::array::from_fn(|i| from[i] + spread * noise(state)))
}

/// The greatest distance between the spline and its keys, at many times.
fn worst<const N: usize>(
    spline: &Cubic<N>,
    keys: &Keys<N>,
    mix: impl Fn([f64; N], [f64; N], f64) -> [f64; N],
    distance: impl Fn([f64; N], [f64; N]) -> f64,
) -> f64 {
    let mut cursor = 0;
    let times = (0..=2000).map(|step| 0.25 + 1.5 * step as f32 / 2000.0);
    let error = |time: f32| {
        let (_, [on_spline, ..]) = split(*spline, (f64::from(time) - 0.25) / 1.5);
        distance(on_spline, keys.at(time, &mut cursor, &mix))
    };
    times.map(error).fold(0.0, f64::max)
}

fn apart<const N: usize>(a: [f64; N], b: [f64; N]) -> f64 {
    length::<N>(core::array::from_fn(|i| a[i] - b[i]))
}

fn line<const N: usize>(a: [f64; N], b: [f64; N], t: f64) -> [f64; N] {
    core::array::from_fn(|i| a[i] + t * (b[i] - a[i]))
}

fn unit(quaternion: [f64; 4]) -> [f64; 4] {
    quaternion.map(|x| x / length(quaternion))
}

/// The angle between two directions, from their chord: accurate where it is small.
fn arc_between(a: [f64; 4], b: [f64; 4]) -> f64 {
    2.0 * (apart(a, b) / 2.0).min(1.0).asin()
}

fn great_arc(a: [f64; 4], b: [f64; 4], t: f64) -> [f64; 4] {
    let angle = arc_between(a, b);
    if angle < 1e-9 {
        return line(a, b, t);
    }
    let [p, q] = [1.0 - t, t].map(|part| (part * angle).sin() / angle.sin());
    core::array::from_fn(|i| p * a[i] + q * b[i])
}

#[test]
fn translations_stay_within_the_tolerance() {
    let state = &mut 1;
    for (spread, tolerance) in [(1.0, 1e-3), (0.01, 1e-3), (100.0, 1e-2), (1.0, 1e-5)] {
        for _ in 0..30 {
            let points = cubic::<3>(state, spread);
            let curve = Curve::Spline(Spline { times: [0.25, 1.75].to_vec(), cubics: [points].to_vec() });
            let keys = refine_translation(curve, tolerance).unwrap();
            let worst = worst(&points, &keys, line, apart);
            assert!(worst <= tolerance, "{points:?}: off by {worst:e}, {} keys", keys.times.len());
        }
    }
}

#[test]
fn rotations_stay_within_the_tolerance() {
    let state = &mut 2;
    let mut nearest: f64 = 0.0;
    for (spread, tolerance) in [(1.0, 1e-3), (0.01, 1e-3), (0.3, 1e-2), (0.3, 1e-5), (0.5, 0.3)] {
        for _ in 0..30 {
            let points = cubic::<4>(state, spread);
            let curve = Curve::Spline(Spline { times: [0.25, 1.75].to_vec(), cubics: [points].to_vec() });
            let keys = refine_rotation(curve, tolerance).unwrap();
            // A rotation turns by twice the angle of its quaternion.
            let worst = worst(&points, &keys, great_arc, |a, b| 2.0 * arc_between(unit(a), b));
            assert!(worst <= tolerance, "{points:?}: off by {worst:e}, {} keys", keys.times.len());
            nearest = nearest.max(worst / tolerance);
        }
    }
    // The bound is no idle one either.
    assert!(nearest > 0.3, "never further off than {nearest} of the tolerance");
}

#[test]
fn times_are_in_the_middle_half_and_round() {
    let state = &mut 3;
    for _ in 0..1000 {
        let start = (noise(state) * 10.0) as f32;
        // So long that single precision has many times within.
        let end = start + 0.01 + noise(state).abs() as f32;
        let Some(time) = middle(start, end) else { continue };
        let fraction = (f64::from(time) - f64::from(start)) / (f64::from(end) - f64::from(start));
        assert!((0.249..=0.751).contains(&fraction), "{start} {time} {end}");
    }
    assert_eq!(middle(0.1, 1.1), Some(0.5));
    assert_eq!(middle(0.0, 1.0), middle(0.1, 0.9));
    assert_eq!(middle(1.0, 1.0 + f32::EPSILON), None);
}
