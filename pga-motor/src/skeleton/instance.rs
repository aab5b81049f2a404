//! One character that moves: a skeleton placed in a world.

use alloc::vec::Vec;

use super::kinematics::check_length;
use super::{Clip, ClipError, Interpolation, Skeleton, SkeletonError, Wrap, local_to_model};
use crate::{Motor, Point, Real, Scalar};

/// A skeleton placed in a world, and where its joints are there.
#[derive(Clone, Debug, PartialEq)]
pub struct SkeletonInstance<T> {
    /// Where each joint is in the world, written by [`animate_keyframe`] and [`animate_sample`].
    pub joint_positions: Vec<Point<T>>,
    /// Takes the skeleton's space to the world. It acts last.
    pub world: Motor<T>,
    model: Vec<Motor<T>>,
}

impl<T: Real> SkeletonInstance<T> {
    /// An instance in its rest pose.
    pub fn new(skeleton: &Skeleton<T>, world: Motor<T>) -> Self {
        let count = skeleton.len();
        let mut instance = Self {
            joint_positions: alloc::vec![Point::ORIGIN; count],
            world,
            model: alloc::vec![Motor::IDENTITY; count],
        };
        animate_keyframe(skeleton, &mut instance, skeleton.rest_pose())
            .expect("invariant: buffers of the skeleton's length");
        instance
    }
}

impl<T> SkeletonInstance<T> {
    /// The model motors of the last pose, one for each joint: they take a joint's own frame to the skeleton's space. With
    /// [`SkeletonInstance::world`] on the left they lead to the world.
    pub fn model(&self) -> &[Motor<T>] {
        &self.model
    }
}

/// Puts an instance into a pose, one local motor for each joint: forward kinematics, then the world. Nothing is allocated.
///
/// # Errors
/// [`SkeletonError::PoseLength`] where the pose or the instance is of another skeleton; the instance is then as it was.
///
/// ```
/// use pga_motor::f64::{Direction, Motor, Point, Rotor, SkeletonInstance, Translator};
/// use pga_motor::skeleton::{Skeleton, animate_keyframe};
///
/// let along_x = |length| Motor::from(Translator::from_vector(Direction::new(length, 0.0, 0.0)));
/// let (arm, _) = Skeleton::from_parents([("elbow", None, Motor::IDENTITY), ("wrist", Some(0), along_x(2.0))])?;
/// let mut instance = SkeletonInstance::new(&arm, along_x(10.0));
/// let mut pose = arm.rest_pose().clone();
/// pose[0] = Rotor::about_z(core::f64::consts::FRAC_PI_2).into();
/// animate_keyframe(&arm, &mut instance, &pose)?;
/// assert!(instance.joint_positions[1].distance_to_point(Point::new(10.0, 2.0, 0.0)) < 1e-14);
/// # Ok::<(), pga_motor::skeleton::SkeletonError>(())
/// ```
pub fn animate_keyframe<T: Scalar>(
    skeleton: &Skeleton<T>,
    instance: &mut SkeletonInstance<T>,
    pose: &[Motor<T>],
) -> Result<(), SkeletonError> {
    check_length("joint_positions", skeleton.len(), instance.joint_positions.len())?;
    check_length("instance", skeleton.len(), instance.model.len())?;
    check_length("pose", skeleton.len(), pose.len())?;
    local_to_model(skeleton, pose, &mut instance.model)?;
    for (position, &model) in instance.joint_positions.iter_mut().zip(&instance.model) {
        *position = (instance.world * model).transform_origin();
    }
    Ok(())
}

/// Puts an instance into the pose of a clip at a time in seconds. `scratch` holds the pose in between, one motor for each joint.
/// Nothing is allocated.
///
/// # Errors
/// [`ClipError::JointCount`] where the clip or the instance has another number of joints than the skeleton, and those of
/// [`Clip::sample_into`]; the instance is then as it was.
pub fn animate_sample<T: Real>(
    skeleton: &Skeleton<T>,
    instance: &mut SkeletonInstance<T>,
    clip: &Clip<T>,
    time: T,
    interpolation: Interpolation,
    wrap: Wrap,
    scratch: &mut [Motor<T>],
) -> Result<(), ClipError> {
    let expected = skeleton.len();
    let instance_joints = [("instance", instance.joint_positions.len()), ("instance", instance.model.len())];
    for (what, found) in [("clip", clip.joint_count())].into_iter().chain(instance_joints) {
        if found != expected {
            return Err(ClipError::JointCount { what, expected, found });
        }
    }
    clip.sample_into(time, interpolation, wrap, scratch)?;
    animate_keyframe(skeleton, instance, scratch).expect("invariant: buffers of the skeleton's length");
    Ok(())
}

/// The motors that carry a mesh from where it was bound to where the joints are now: `out[i] = model[i] * inv_bind_pose[i]`.
/// `model` and `out` have one motor for each joint. Nothing is allocated.
///
/// # Errors
/// [`SkeletonError::PoseLength`] where a buffer is longer or shorter than the skeleton; `out` is then as it was.
pub fn skinning_motors<T: Scalar>(
    skeleton: &Skeleton<T>,
    model: &[Motor<T>],
    out: &mut [Motor<T>],
) -> Result<(), SkeletonError> {
    check_length("model", skeleton.len(), model.len())?;
    check_length("out", skeleton.len(), out.len())?;
    for (out, (joint, &model)) in out.iter_mut().zip(skeleton.joints().iter().zip(model)) {
        *out = model * joint.inv_bind_pose;
    }
    Ok(())
}
