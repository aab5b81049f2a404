//! Meshes that follow a skeleton.

use core::fmt;

use crate::interpolate::blend_each;
use crate::{Direction, Motor, Point, Real};

#[cfg(test)]
mod tests;

/// Which joints move a vertex, and how much, for each vertex of a mesh: `N` joints and as many weights, as in glTF's `JOINTS_0` and
/// `WEIGHTS_0`.
///
/// Weights are from 0 up and need not add up to 1: they are divided by their sum. Joints whose weight is 0 take no part. A vertex
/// whose weights are all 0 stays where it was bound.
#[derive(Clone, Copy, Debug)]
pub struct Influences<'a, T, const N: usize> {
    /// Indexes into the motors, for each vertex.
    pub joints: &'a [[u16; N]],
    /// The weights, for each vertex.
    pub weights: &'a [[T; N]],
}

/// Why a mesh cannot be skinned. Vertices are counted from 0.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum SkinError {
    /// A buffer has not one entry for each vertex.
    Length {
        /// Which one: the name of the parameter or field.
        buffer: &'static str,
        /// How many vertices there are.
        expected: usize,
        /// How many entries the buffer has.
        found: usize,
    },
    /// A vertex names a joint that there is not, with a weight that is not 0.
    NoSuchJoint {
        /// The vertex.
        vertex: usize,
        /// The joint that it names.
        joint: usize,
        /// How many motors there are.
        joints: usize,
    },
    /// A weight is negative, NaN or infinite, or the weights' sum is infinite.
    Weight {
        /// The vertex.
        vertex: usize,
    },
    /// The motor of a joint that moves a vertex is NaN or infinite.
    NonFinite {
        /// The vertex.
        vertex: usize,
        /// The joint.
        joint: usize,
    },
}

impl fmt::Display for SkinError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Length { buffer, expected, found } => {
                write!(f, "expected {expected} entries in `{buffer}`, one for each vertex, found {found}")
            }
            Self::NoSuchJoint { vertex, joint, joints } => {
                write!(f, "vertex {vertex}: expected joints below {joints}, the number of motors, found {joint}")
            }
            Self::Weight { vertex } => {
                write!(f, "vertex {vertex}: expected finite weights from 0 up, found another")
            }
            Self::NonFinite { vertex, joint } => {
                write!(f, "vertex {vertex}: expected a finite motor of joint {joint}, found a NaN or an infinity")
            }
        }
    }
}

impl core::error::Error for SkinError {}

impl<T: Real, const N: usize> Influences<'_, T, N> {
    /// Checks the lengths against the number of vertices, and every weight, joint and motor that counts.
    fn check(&self, motors: &[Motor<T>], bound: usize, out: usize) -> Result<(), SkinError> {
        let expected = self.joints.len();
        for (buffer, found) in [("weights", self.weights.len()), ("bound", bound), ("out", out)] {
            if found != expected {
                return Err(SkinError::Length { buffer, expected, found });
            }
        }
        for vertex in 0..expected {
            let weights = self.weights[vertex];
            let sum = weights.into_iter().fold(T::ZERO, |sum, weight| sum + weight);
            if !sum.is_finite() || weights.iter().any(|weight| *weight < T::ZERO) {
                return Err(SkinError::Weight { vertex });
            }
            for (&joint, _) in self.joints[vertex].iter().zip(weights).filter(|(_, weight)| *weight > T::ZERO) {
                let joint = usize::from(joint);
                let joints = motors.len();
                let motor = motors.get(joint).ok_or(SkinError::NoSuchJoint { vertex, joint, joints })?;
                if !motor.is_finite() {
                    return Err(SkinError::NonFinite { vertex, joint });
                }
            }
        }
        Ok(())
    }

    /// The motors that move a vertex, each with its weight divided by the sum of all.
    fn of(&self, vertex: usize, motors: &[Motor<T>]) -> impl Iterator<Item = (Motor<T>, T)> + Clone {
        let weights = self.weights[vertex];
        let sum = weights.into_iter().fold(T::ZERO, |sum, weight| sum + weight);
        let joints = self.joints[vertex].into_iter().zip(weights).filter(|(_, weight)| *weight > T::ZERO);
        joints.map(move |(joint, weight)| (motors[usize::from(joint)], weight / sum))
    }
}

/// Moves points by the weighted mean of motors: dual-quaternion skinning (Kavan, Collins, Zara and O'Sullivan, *Geometric Skinning
/// with Approximate Dual Quaternion Blending*, 2008). What is near two joints moves rigidly too, so a twist does not thin it.
///
/// `motors` are those of [`skinning_motors`](super::skinning_motors), one for each joint; `bound` the points as they were bound, and
/// `out` where they get, one for each vertex. The signs of a vertex's motors are aligned to that of greatest weight. Nothing is
/// allocated.
///
/// # Errors
/// [`SkinError`]; `out` is then as it was.
///
/// ```
/// use pga_motor::f64::{Motor, Point, Rotor};
/// use pga_motor::skeleton::{Influences, skin_points};
///
/// let motors = [Motor::IDENTITY, Rotor::about_x(2.0).into()];
/// let influences = Influences { joints: &[[0, 1]], weights: &[[3.0, 3.0]] };
/// let mut out = [Point::ORIGIN];
/// skin_points(&motors, influences, &[Point::new(0.0, 1.0, 0.0)], &mut out)?;
/// assert!(out[0].distance_to_point(Point::new(0.0, 1.0_f64.cos(), 1.0_f64.sin())) < 1e-15);
/// # Ok::<(), pga_motor::skeleton::SkinError>(())
/// ```
pub fn skin_points<T: Real, const N: usize>(
    motors: &[Motor<T>],
    influences: Influences<'_, T, N>,
    bound: &[Point<T>],
    out: &mut [Point<T>],
) -> Result<(), SkinError> {
    skin(motors, influences, bound, out, Motor::transform_point)
}

/// Moves normals, or other directions, as [`skin_points`] moves points. Lengths stay.
///
/// # Errors
/// [`SkinError`]; `out` is then as it was.
pub fn skin_normals<T: Real, const N: usize>(
    motors: &[Motor<T>],
    influences: Influences<'_, T, N>,
    bound: &[Direction<T>],
    out: &mut [Direction<T>],
) -> Result<(), SkinError> {
    skin(motors, influences, bound, out, Motor::transform_direction)
}

fn skin<T: Real, X: Copy, const N: usize>(
    motors: &[Motor<T>],
    influences: Influences<'_, T, N>,
    bound: &[X],
    out: &mut [X],
    transform: impl Fn(Motor<T>, X) -> X,
) -> Result<(), SkinError> {
    influences.check(motors, bound.len(), out.len())?;
    for (vertex, (out, &bound)) in out.iter_mut().zip(bound).enumerate() {
        *out = blend_each(influences.of(vertex, motors)).map_or(bound, |motor| transform(motor, bound));
    }
    Ok(())
}

/// Moves points by the weighted mean of where each joint would take them: linear blend skinning, what glTF prescribes. Half-way between
/// two joints that twist against each other it thins: at half a turn to nothing. [`skin_points`] does not.
///
/// Parameters as for [`skin_points`].
///
/// # Errors
/// [`SkinError`]; `out` is then as it was.
pub fn skin_points_linear<T: Real, const N: usize>(
    motors: &[Motor<T>],
    influences: Influences<'_, T, N>,
    bound: &[Point<T>],
    out: &mut [Point<T>],
) -> Result<(), SkinError> {
    influences.check(motors, bound.len(), out.len())?;
    for (vertex, (out, &bound)) in out.iter_mut().zip(bound).enumerate() {
        let displaced =
            influences.of(vertex, motors).map(|(motor, weight)| (motor.transform_point(bound) - bound) * weight);
        *out = displaced.fold(bound, |place, step| place + step);
    }
    Ok(())
}

/// Moves normals as [`skin_points_linear`] moves points, and brings each back to the length that it had. One that cancels, as it does
/// between two joints half a turn apart, has no direction, and comes out as 0.
///
/// # Errors
/// [`SkinError`]; `out` is then as it was.
pub fn skin_normals_linear<T: Real, const N: usize>(
    motors: &[Motor<T>],
    influences: Influences<'_, T, N>,
    bound: &[Direction<T>],
    out: &mut [Direction<T>],
) -> Result<(), SkinError> {
    influences.check(motors, bound.len(), out.len())?;
    for (vertex, (out, &bound)) in out.iter_mut().zip(bound).enumerate() {
        let mut moved = influences.of(vertex, motors).map(|(motor, weight)| motor.transform_direction(bound) * weight);
        let Some(first) = moved.next() else {
            *out = bound;
            continue;
        };
        let sum = moved.fold(first, |sum, term| sum + term);
        *out = sum.normalize().map_or(Direction::ZERO, |direction| direction * bound.norm());
    }
    Ok(())
}
