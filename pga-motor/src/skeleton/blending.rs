//! Poses mixed from several: layers with weights, and deviations added on top.

use core::fmt;

use super::Skeleton;
use crate::interpolate::blend_each;
use crate::{Motor, Real};

#[cfg(test)]
mod tests;

/// A pose that takes part in a blend.
///
/// A partial pose is a layer whose joint weights are 0 for the joints that it does not move: their motors are not looked at, and may be
/// anything.
#[derive(Clone, Copy, Debug)]
pub struct Layer<'a, T> {
    /// One local motor for each joint.
    pub pose: &'a [Motor<T>],
    /// How much it counts, beside the other layers.
    pub weight: T,
    /// A mask: for each joint a factor to the weight. `None` is 1 for every joint.
    pub joint_weights: Option<&'a [T]>,
}

impl<'a, T: Real> Layer<'a, T> {
    /// A layer in which all joints count the same.
    pub const fn new(pose: &'a [Motor<T>], weight: T) -> Self {
        Self { pose, weight, joint_weights: None }
    }

    /// The layer with a mask.
    pub const fn with_joint_weights(self, joint_weights: &'a [T]) -> Self {
        Self { joint_weights: Some(joint_weights), ..self }
    }

    fn weight_of(&self, joint: usize) -> T {
        self.joint_weights.map_or(self.weight, |weights| weights[joint] * self.weight)
    }
}

/// Why layers cannot be blended. Layers and joints are counted from 0.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum BlendError {
    /// A layer's pose, its mask, or the result has not one entry for each joint.
    Length {
        /// The layer; `None` for the result.
        layer: Option<usize>,
        /// How many joints the skeleton has.
        expected: usize,
        /// How many entries there are.
        found: usize,
    },
    /// A weight is NaN or infinite, or negative where it must not be.
    Weight {
        /// The layer; `None` for the threshold.
        layer: Option<usize>,
        /// The joint whose weight it is; `None` where it is that of the whole layer.
        joint: Option<usize>,
    },
    /// A motor is NaN or infinite.
    NonFinite {
        /// The layer.
        layer: usize,
        /// The joint.
        joint: usize,
    },
}

impl fmt::Display for BlendError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Length { layer: Some(layer), expected, found } => {
                write!(f, "layer {layer}: expected {expected} entries, one for each joint, found {found}")
            }
            Self::Length { layer: None, expected, found } => {
                write!(f, "expected {expected} motors in the result, one for each joint, found {found}")
            }
            Self::Weight { layer: None, .. } => write!(f, "expected a finite threshold from 0 up, found another"),
            Self::Weight { layer: Some(layer), joint: None } => {
                write!(f, "layer {layer}: expected a finite weight from 0 up, found another")
            }
            Self::Weight { layer: Some(layer), joint: Some(joint) } => {
                write!(f, "layer {layer}, joint {joint}: expected a finite weight from 0 up, found another")
            }
            Self::NonFinite { layer, joint } => {
                write!(f, "layer {layer}, joint {joint}: expected a finite motor, found a NaN or an infinity")
            }
        }
    }
}

impl core::error::Error for BlendError {}

/// Blends layers: each joint is the weighted mean [`blend`](crate::blend) of its motors, whose signs are aligned to that of
/// greatest weight, so the order of the layers changes the result by rounding only. Weights need not add up to 1.
///
/// Where the weights of a joint add up to less than `threshold`, its rest pose counts for what is missing. So layers fade out into
/// the rest pose instead of keeping their proportions to the last; 0 keeps them, and only a joint that nothing moves is at rest.
/// A weight that is 0 takes no part. Nothing is allocated.
///
/// # Errors
/// [`BlendError`]; `out` is then as it was. Weights and threshold are finite and not negative.
///
/// ```
/// use pga_motor::f64::{Motor, Rotor};
/// use pga_motor::skeleton::{Layer, Skeleton, blend_poses};
///
/// let (skeleton, _) = Skeleton::from_parents([("root", None, Motor::IDENTITY), ("arm", Some(0), Motor::IDENTITY)])?;
/// let turned = |angle| [Motor::from(Rotor::about_z(angle)); 2];
/// let (walk, wave) = (turned(0.2), turned(0.8));
/// let layers = [Layer::new(&walk, 1.0), Layer::new(&wave, 1.0).with_joint_weights(&[0.0, 1.0])];
/// let mut pose = skeleton.rest_pose().clone();
/// blend_poses(&skeleton, &layers, 0.1, &mut pose)?;
/// assert!((pose[0] - turned(0.2)[0]).norm() < 1e-15 && (pose[1] - turned(0.5)[0]).norm() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn blend_poses<T: Real>(
    skeleton: &Skeleton<T>,
    layers: &[Layer<'_, T>],
    threshold: T,
    out: &mut [Motor<T>],
) -> Result<(), BlendError> {
    check_result(skeleton.len(), out.len())?;
    if !is_weight(threshold) {
        return Err(BlendError::Weight { layer: None, joint: None });
    }
    for (index, layer) in layers.iter().enumerate() {
        check_layer(index, layer, skeleton.len(), is_weight)?;
    }
    for (joint, (out, &rest)) in out.iter_mut().zip(skeleton.rest_pose().iter()).enumerate() {
        let moving = layers.iter().map(|layer| (layer, layer.weight_of(joint))).filter(|(_, weight)| *weight > T::ZERO);
        let total = moving.clone().fold(T::ZERO, |total, (_, weight)| total + weight);
        let missing = if total < threshold { Some((rest, threshold - total)) } else { None };
        let inputs = moving.map(|(layer, weight)| (layer.pose[joint], weight)).chain(missing);
        // Weights from 0 up do not cancel, and everything is finite: only where there is no input, there is no mean.
        *out = blend_each(inputs).unwrap_or(rest);
    }
    Ok(())
}

/// Adds layers of deviations on top of a pose, one after the other: `pose[i] = pose[i] * deviation[i]^weight`.
///
/// The deviation stands on the right, so it acts first: it is what the joint does in its own frame before the pose takes it along.
/// [`deviation_into`] makes such layers. A weight of 1 adds the whole, 0 nothing, 2 twice as much, -1 takes it away. Order matters
/// where several layers move the same joint. Nothing is allocated.
///
/// # Errors
/// [`BlendError`]; `pose` is then as it was. Weights are finite.
pub fn add_layers<T: Real>(layers: &[Layer<'_, T>], pose: &mut [Motor<T>]) -> Result<(), BlendError> {
    for (index, layer) in layers.iter().enumerate() {
        check_layer(index, layer, pose.len(), T::is_finite)?;
    }
    for layer in layers {
        for (joint, local) in pose.iter_mut().enumerate() {
            let weight = layer.weight_of(joint);
            if weight != T::ZERO {
                *local = *local * layer.pose[joint].powf(weight);
            }
        }
    }
    Ok(())
}

/// What a pose adds to a reference, in each joint's own frame: `out[i] = ~reference[i] * pose[i]`, for [`add_layers`]. With weight 1
/// on top of the reference it gives the pose again.
///
/// # Errors
/// [`BlendError::Length`] where `reference` (layer 0), `pose` (layer 1) and `out` are not of one length; `out` is then as it was.
pub fn deviation_into<T: Real>(
    reference: &[Motor<T>],
    pose: &[Motor<T>],
    out: &mut [Motor<T>],
) -> Result<(), BlendError> {
    for (layer, found) in [reference.len(), pose.len()].into_iter().enumerate() {
        if found != out.len() {
            return Err(BlendError::Length { layer: Some(layer), expected: out.len(), found });
        }
    }
    for (out, (reference, &pose)) in out.iter_mut().zip(reference.iter().zip(pose)) {
        *out = reference.reverse() * pose;
    }
    Ok(())
}

fn is_weight<T: Real>(weight: T) -> bool {
    weight.is_finite() && weight >= T::ZERO
}

fn check_result(expected: usize, found: usize) -> Result<(), BlendError> {
    if found == expected { Ok(()) } else { Err(BlendError::Length { layer: None, expected, found }) }
}

/// Checks the lengths and weights of a layer, and the motors that count.
fn check_layer<T: Real>(
    index: usize,
    layer: &Layer<'_, T>,
    joints: usize,
    is_weight: impl Fn(T) -> bool,
) -> Result<(), BlendError> {
    for found in [layer.pose.len(), layer.joint_weights.map_or(joints, <[T]>::len)] {
        if found != joints {
            return Err(BlendError::Length { layer: Some(index), expected: joints, found });
        }
    }
    if !is_weight(layer.weight) {
        return Err(BlendError::Weight { layer: Some(index), joint: None });
    }
    for (joint, motor) in layer.pose.iter().enumerate() {
        let weight = layer.weight_of(joint);
        let own = layer.joint_weights.map_or(T::ZERO, |weights| weights[joint]);
        if !is_weight(weight) || !is_weight(own) {
            return Err(BlendError::Weight { layer: Some(index), joint: Some(joint) });
        }
        if weight != T::ZERO && !motor.is_finite() {
            return Err(BlendError::NonFinite { layer: index, joint });
        }
    }
    Ok(())
}
