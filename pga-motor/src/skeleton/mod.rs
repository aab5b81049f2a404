//! Rigid skeletons: joints in a hierarchy, poses of them, and forward kinematics, with motors all the way.
//!
//! A joint carries a frame of its own. Where that frame stands relative to the joint's parent is its *local* motor, where it
//! stands in the space of the whole skeleton its *model* motor, and the two are tied by one rule:
//!
//! ```text
//! model[i] = model[parent(i)] * local[i]          (model[i] = local[i] for a root)
//! ```
//!
//! The right factor acts first, so a point given in the joint's own frame is moved by the joint's own motor, then by its
//! parent's, and so on up to the root; a motor that places the whole skeleton in a world comes last, on the left of them all.
//!
//! Joints are stored depth-first: a parent stands before its children, and a joint together with everything below it is one
//! contiguous run ([`Joint::group_size`]). One pass from front to back therefore suffices ([`local_to_model`]), and a whole
//! limb is a slice. Lengths are in whatever unit the caller uses throughout; angles, where there are any, in radians; times in seconds.
//!
//! The stages of a frame, each of which writes to a buffer of the caller's and allocates nothing:
//!
//! | | |
//! |---|---|
//! | [`Clip::sample_into`], [`Clip::sample_cached_into`] | the pose of a clip at a time |
//! | [`Retarget::pose_into`] | that pose for a skeleton of other proportions |
//! | [`blend_poses`], [`add_layers`] | one pose of several |
//! | [`RootMotion::between`] | how far the character gets, to be multiplied to its place in the world |
//! | [`local_to_model`] | model motors |
//! | [`TwoBone::solve`], [`Aim::solve`] | hands and feet, heads and eyes where they should be |
//! | [`skinning_motors`], [`skin_points`], [`skin_normals`] | a mesh that follows |
//!
//! [`Poses`] has the poses of many characters side by side, and does the first and the fifth for all of them at a time.
//!
//! [`animate_sample`] does the first and the fifth for a [`SkeletonInstance`], and puts its joints into the world. Files come from
//! [`import`](crate::import).
//!
//! ```
//! use pga_motor::skeleton::{Skeleton, local_to_model};
//! use pga_motor::f64::{Direction, Motor, Rotor, Translator};
//!
//! let along_x = |length| Motor::from(Translator::from_vector(Direction::new(length, 0.0, 0.0)));
//! let (arm, _) = Skeleton::from_parents([
//!     ("shoulder", None, Motor::IDENTITY),
//!     ("elbow", Some(0), along_x(3.0)),
//!     ("wrist", Some(1), along_x(2.0)),
//! ])?;
//!
//! // Bend the elbow by a quarter turn: the wrist ends up straight above it.
//! let mut pose = arm.rest_pose().clone();
//! pose[1] = pose[1] * Rotor::about_z(core::f64::consts::FRAC_PI_2);
//! let mut model = vec![Motor::IDENTITY; arm.len()];
//! local_to_model(&arm, &pose, &mut model)?;
//!
//! let wrist = model[2].transform_origin();
//! assert!((wrist.x - 3.0).abs() < 1e-12 && (wrist.y - 2.0).abs() < 1e-12);
//! # Ok::<(), pga_motor::skeleton::SkeletonError>(())
//! ```

mod blending;
mod clip;
mod error;
mod hierarchy;
mod ik;
mod instance;
mod joint;
mod kinematics;
mod order;
#[cfg(feature = "rayon")]
mod parallel;
mod pose;
mod poses;
mod retarget;
mod rigidity;
mod root_motion;
mod skinning;

pub use blending::{BlendError, Layer, add_layers, blend_poses, deviation_into};
pub use clip::{Clip, ClipError, Interpolation, JointModes, KeyMode, KeySpan, ScrewCache, Wrap};
pub use error::SkeletonError;
pub use hierarchy::Skeleton;
pub use ik::{Aim, IkError, Reach, TwoBone, Upright};
pub use instance::{SkeletonInstance, animate_keyframe, animate_sample, skinning_motors};
pub use joint::Joint;
pub use kinematics::local_to_model;
#[cfg(feature = "rayon")]
pub use parallel::{Character, CrowdError, animate_characters};
pub use pose::Pose;
pub use poses::{Poses, PosesError};
pub use retarget::{Retarget, Unmatched};
pub use root_motion::{RootMotion, RootMotionError, RootMotionPart};
pub use skinning::{Influences, SkinError, skin_normals, skin_normals_linear, skin_points, skin_points_linear};

#[cfg(test)]
mod tests;
