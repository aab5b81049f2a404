//! One channel of an animation: what it drives, and its values.

use alloc::format;
use alloc::vec::Vec;

use ::gltf::json::accessor::Type;
use ::gltf::json::animation::{Interpolation, Property as Path, Sampler};
use ::gltf::json::validation::Checked;

use super::buffers::{Buffers, Content, Elements};
use super::curve::{Curve, Keys, Spline, length};
use super::error::GltfReason;
use super::place::Property;
use super::similarity::{ROUNDING, TOLERANCE, finite};

/// What was brought in order in the quaternions of a channel.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Mending {
    /// How many were made unit, and how far off the worst was.
    pub(super) renormalized: usize,
    pub(super) worst: f64,
    /// How many changed their sign.
    pub(super) realigned: usize,
}

/// The property that a channel drives; `None` where it is none of those that there are.
pub(super) fn property(path: Checked<Path>) -> Option<Property> {
    match path {
        Checked::Valid(Path::Translation) => Some(Property::Translation),
        Checked::Valid(Path::Rotation) => Some(Property::Rotation),
        Checked::Valid(Path::Scale) => Some(Property::Scale),
        Checked::Valid(Path::MorphTargetWeights) => Some(Property::Weights),
        Checked::Invalid => None,
    }
}

/// How many values a channel has, before any of them is read; at least one. Whether they are there is seen later.
pub(super) fn count_values(buffers: &mut Buffers<'_>, sampler: &Sampler) -> Result<usize, GltfReason> {
    let each = if interpolation(sampler)? == Interpolation::CubicSpline { 3 } else { 1 };
    match buffers.elements::<1>(sampler.input.value(), Type::Scalar, Content::Float)?.len() {
        0 => Err(GltfReason::NoKeys),
        keys => Ok(keys.saturating_mul(each)),
    }
}

/// The times of the keys: finite, and increasing.
fn read_times(buffers: &mut Buffers<'_>, sampler: &Sampler) -> Result<Vec<f32>, GltfReason> {
    let elements = buffers.elements::<1>(sampler.input.value(), Type::Scalar, Content::Float)?;
    // A place only for those that are read: zeros without a view may be any number, but do not increase.
    let mut times: Vec<f32> = Vec::new();
    for key in 0..elements.len() {
        let [time] = finite(elements.get(key), &format!("time of key {key}"))?;
        // It was single precision in the file.
        let time = time as f32;
        if times.last().is_some_and(|&before| before >= time) {
            return Err(GltfReason::TimeNotIncreasing { key });
        }
        times.push(time);
    }
    Ok(times)
}

/// The values of a channel as they stand: for each key one, or with tangents before and after it.
struct Outputs<'a, const N: usize> {
    elements: Elements<'a, N>,
    has_tangents: bool,
}

impl<'a, const N: usize> Outputs<'a, N> {
    fn of(
        buffers: &'a mut Buffers<'_>,
        sampler: &Sampler,
        keys: usize,
        shape: Type,
        content: Content,
    ) -> Result<Self, GltfReason> {
        let has_tangents = interpolation(sampler)? == Interpolation::CubicSpline;
        let elements = buffers.elements::<N>(sampler.output.value(), shape, content)?;
        let expected = keys.saturating_mul(if has_tangents { 3 } else { 1 });
        if elements.len() == expected {
            Ok(Self { elements, has_tangents })
        } else {
            Err(GltfReason::ValueCount { expected, found: elements.len() })
        }
    }

    fn value(&self, key: usize) -> Result<[f64; N], GltfReason> {
        finite(self.elements.get(if self.has_tangents { 3 * key + 1 } else { key }), &format!("value of key {key}"))
    }

    /// The tangents before and after a key, per second; zero where there are none.
    fn tangents(&self, key: usize) -> Result<[[f64; N]; 2], GltfReason> {
        if !self.has_tangents {
            return Ok([[0.0; N]; 2]);
        }
        let tangent = |index| finite(self.elements.get(index), &format!("tangent of key {key}"));
        Ok([tangent(3 * key)?, tangent(3 * key + 2)?])
    }

    /// The curve through values that were read, one for each time.
    fn curve(&self, times: Vec<f32>, values: Vec<[f64; N]>, holds: bool) -> Result<Curve<N>, GltfReason> {
        if !self.has_tangents || times.len() == 1 {
            return Ok(Curve::Keys(Keys { times, values, holds }));
        }
        let mut cubics = Vec::with_capacity(times.len() - 1);
        for key in 0..times.len() - 1 {
            let third = (f64::from(times[key + 1]) - f64::from(times[key])) / 3.0;
            let ([_, out], [into, _]) = (self.tangents(key)?, self.tangents(key + 1)?);
            let (from, to) = (values[key], values[key + 1]);
            let near =
                |value: [f64; N], tangent: [f64; N], step: f64| core::array::from_fn(|i| value[i] + step * tangent[i]);
            cubics.push([from, near(from, out, third), near(to, into, -third), to]);
        }
        Ok(Curve::Spline(Spline { times, cubics }))
    }
}

fn interpolation(sampler: &Sampler) -> Result<Interpolation, GltfReason> {
    match sampler.interpolation {
        Checked::Valid(interpolation) => Ok(interpolation),
        Checked::Invalid => Err(GltfReason::UnknownInterpolation),
    }
}

/// Reads the translations of a node.
pub(super) fn read_translation(buffers: &mut Buffers<'_>, sampler: &Sampler) -> Result<Curve<3>, GltfReason> {
    let times = read_times(buffers, sampler)?;
    let outputs = Outputs::of(buffers, sampler, times.len(), Type::Vec3, Content::Float)?;
    let values = (0..times.len()).map(|key| outputs.value(key)).collect::<Result<_, _>>()?;
    outputs.curve(times, values, interpolation(sampler)? == Interpolation::Step)
}

/// Reads the rotations of a node. Those of a spline keep their signs and lengths, for its tangents are made for these; the others
/// become unit and take the short way.
pub(super) fn read_rotation(buffers: &mut Buffers<'_>, sampler: &Sampler) -> Result<(Curve<4>, Mending), GltfReason> {
    let times = read_times(buffers, sampler)?;
    let outputs = Outputs::<4>::of(buffers, sampler, times.len(), Type::Vec4, Content::FloatOrNormalized)?;
    let mut mending = Mending::default();
    let mut values: Vec<[f64; 4]> = Vec::with_capacity(times.len());
    // Half a step off in each of four components is a step in all.
    let allowed = ROUNDING + outputs.elements.step();
    for key in 0..times.len() {
        let value = outputs.value(key)?;
        let norm = length(value);
        if norm == 0.0 {
            return Err(GltfReason::ZeroRotation { key: Some(key) });
        }
        let off_unit = (norm - 1.0).abs();
        if off_unit > allowed {
            mending.renormalized += 1;
            mending.worst = mending.worst.max(off_unit);
        }
        if outputs.has_tangents && times.len() > 1 {
            values.push(value);
            continue;
        }
        let unit = value.map(|x| x / norm);
        let is_far = values.last().is_some_and(|before| before.iter().zip(unit).map(|(a, b)| a * b).sum::<f64>() < 0.0);
        mending.realigned += usize::from(is_far);
        values.push(if is_far { unit.map(|x| -x) } else { unit });
    }
    Ok((outputs.curve(times, values, interpolation(sampler)? == Interpolation::Step)?, mending))
}

/// Reads the scales of a node and compares them with the one that it has at rest; the greatest relative difference.
pub(super) fn check_scale(buffers: &mut Buffers<'_>, sampler: &Sampler, rest: f64) -> Result<f64, GltfReason> {
    let times = read_times(buffers, sampler)?;
    let outputs = Outputs::<3>::of(buffers, sampler, times.len(), Type::Vec3, Content::Float)?;
    let difference = |scale: [f64; 3]| scale.iter().map(|&x| (x - rest).abs() / rest).fold(0.0, f64::max);
    let mut worst: f64 = 0.0;
    for key in 0..times.len() {
        let value = outputs.value(key)?;
        let [before, after] = outputs.tangents(key)?;
        let distance =
            |other: Option<&f32>| other.map_or(0.0, |&other| (f64::from(other) - f64::from(times[key])).abs());
        let (to_before, to_after) =
            (distance(key.checked_sub(1).and_then(|before| times.get(before))), distance(times.get(key + 1)));
        // A tangent moves the curve by no more than 4/27 of itself times the distance of the keys; a span has two of them. Away
        // from the scale at rest, that is, whichever way it points: it is the value of the other key that it may add to.
        let reached = |tangent: [f64; 3], distance: f64| {
            core::array::from_fn(|i| value[i] + (tangent[i].abs() * distance * 8.0 / 27.0).copysign(value[i] - rest))
        };
        for found in [value, reached(before, to_before), reached(after, to_after)] {
            let difference = difference(found);
            if difference > TOLERANCE {
                return Err(GltfReason::AnimatedScale { key, expected: rest, found });
            }
            worst = worst.max(difference);
        }
    }
    Ok(worst)
}
