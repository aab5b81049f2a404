//! Cubic splines as keys between which it goes straight, or along great arcs: as many as it takes to stay within a tolerance.

use alloc::vec::Vec;

use super::curve::{Curve, Keys, Spline, length};
use super::error::GltfReason;

/// The most keys that a channel with a spline may come to have.
pub(super) const MAX_CHANNEL_KEYS: usize = 1 << 16;

/// No tolerance is below some roundings of what it is for.
const ROUNDING: f64 = 1e-13;

/// The four points of a cubic.
type Cubic<const N: usize> = [[f64; N]; 4];

/// Translations within a distance of the spline, in its own unit.
pub(super) fn refine_translation(curve: Curve<3>, tolerance: f64) -> Result<Keys<3>, GltfReason> {
    // Differences of points are known to some roundings of these, and no better.
    refine(curve, |cubic| chord_deviation(cubic) <= tolerance.max(ROUNDING * longest(cubic)), Some)
}

/// Rotations within an angle of the spline, made unit, in radians.
pub(super) fn refine_rotation(curve: Curve<4>, tolerance: f64) -> Result<Keys<4>, GltfReason> {
    let unit = |quaternion: [f64; 4]| {
        let norm = length(quaternion);
        (norm > 0.0).then(|| quaternion.map(|x| x / norm))
    };
    refine(curve, |cubic| arc_deviation(cubic) <= tolerance.max(ROUNDING), unit)
}

/// The curve as keys: splines are halved until every piece is fine enough.
fn refine<const N: usize>(
    curve: Curve<N>,
    is_fine: impl Fn(&Cubic<N>) -> bool,
    finish: impl Fn([f64; N]) -> Option<[f64; N]>,
) -> Result<Keys<N>, GltfReason> {
    let Spline { times, cubics } = match curve {
        Curve::Keys(keys) => return Ok(keys),
        Curve::Spline(spline) => spline,
    };
    let finish = |value, key| finish(value).ok_or(GltfReason::ZeroRotation { key: Some(key) });
    let mut keys = Keys { times: Vec::new(), values: Vec::new(), holds: false };
    keys.times.push(times[0]);
    keys.values.push(finish(cubics[0][0], 0)?);
    for (key, (&cubic, span)) in cubics.iter().zip(times.windows(2)).enumerate() {
        let mut rest = alloc::vec![(span[0], span[1], cubic)];
        while let Some((start, end, piece)) = rest.pop() {
            match middle(start, end).filter(|_| !is_fine(&piece)) {
                None => {
                    keys.times.push(end);
                    keys.values.push(finish(piece[3], key)?);
                }
                Some(time) => {
                    let fraction = (f64::from(time) - f64::from(start)) / (f64::from(end) - f64::from(start));
                    let (first, second) = split(piece, fraction);
                    rest.extend([(time, end, second), (start, time, first)]);
                }
            }
            if keys.times.len() + rest.len() > MAX_CHANNEL_KEYS.max(times.len()) {
                return Err(GltfReason::SplineTooWild { limit: MAX_CHANNEL_KEYS });
            }
        }
    }
    Ok(keys)
}

/// A time between two others, in the middle half of their span, of as few binary digits as may be: so channels whose keys lie
/// at other times are refined at the same ones, and all of them together have not many more than one. `None` where single
/// precision has no time there.
fn middle(start: f32, end: f32) -> Option<f32> {
    let (low, high) = (f64::from(start), f64::from(end));
    // A multiple of a step no longer than half the span lies within a quarter of the span from the middle.
    let step = crate::Real::power_of_two((high - low) / 2.0);
    let time = (((low + high) / 2.0 / step).round() * step) as f32;
    (start < time && time < end).then_some(time)
}

/// The two parts of a cubic (de Casteljau 1959).
fn split<const N: usize>(cubic: Cubic<N>, fraction: f64) -> (Cubic<N>, Cubic<N>) {
    let mix = |a: [f64; N], b: [f64; N]| core::array::from_fn(|i| a[i] + fraction * (b[i] - a[i]));
    let [a, b, c, d] = cubic;
    let (ab, bc, cd) = (mix(a, b), mix(b, c), mix(c, d));
    let (abc, bcd) = (mix(ab, bc), mix(bc, cd));
    let middle = mix(abc, bcd);
    ([a, ab, abc, middle], [middle, bcd, cd, d])
}

/// Differences of the points next to each other: a third of the derivative's points.
fn differences<const N: usize, const M: usize, const L: usize>(points: &[[f64; N]; M]) -> [[f64; N]; L] {
    core::array::from_fn(|i| core::array::from_fn(|j| points[i + 1][j] - points[i][j]))
}

fn longest<const N: usize>(vectors: &[[f64; N]]) -> f64 {
    vectors.iter().map(|&vector| length(vector)).fold(0.0, f64::max)
}

/// How far a cubic may be from the straight way in the same time, at most: f is from its chord no further than max |f''| / 8, and
/// f'' goes straight from 6 times the first second difference of the points to 6 times the other.
fn chord_deviation<const N: usize>(cubic: &Cubic<N>) -> f64 {
    let first: [[f64; N]; 3] = differences(cubic);
    let second: [[f64; N]; 2] = differences(&first);
    0.75 * longest(&second)
}

/// By what angle, in radians, the rotation of a cubic made unit may be from that on the great arc in the same time, at most.
///
/// Let g = q / |q|. Along the sphere its acceleration is at most A = |q''| / m + 2 (|q'| / m)^2, with m the least |q|: the
/// derivative of q' / |q| is q'' / |q| - q' (q q') / |q|^3, its change of direction at least the same again. A curve of
/// acceleration at most A that meets a great arc of length l at both ends is away from it by no more than
/// A / l^2 (1 / cos(l / 2) - 1), to first order in that distance, which for l up to 1 is below 1.12 A / 8; a ninth more is for the
/// higher orders. The angle of a rotation is twice that of its quaternion: 2 * 1.25 A / 8. Infinite where m is not known to be
/// positive or the arc may be longer than 1.
fn arc_deviation(cubic: &Cubic<4>) -> f64 {
    let first: [[f64; 4]; 3] = differences(cubic);
    let second: [[f64; 4]; 2] = differences(&first);
    // The hull of the points is at least as far from the origin as the nearest of them along any one direction.
    let sum: [f64; 4] = core::array::from_fn(|i| cubic.iter().map(|point| point[i]).sum());
    let norm = length(sum);
    let along = |point: &[f64; 4]| point.iter().zip(sum).map(|(a, b)| a * (b / norm)).sum::<f64>();
    let least = cubic.iter().map(along).fold(f64::INFINITY, f64::min);
    let speed = 3.0 * longest(&first) / least;
    if !(least > 0.0 && speed <= 1.0) {
        return f64::INFINITY;
    }
    1.25 / 4.0 * (6.0 * longest(&second) / least + 2.0 * speed * speed)
}
