//! The skeleton itself: joints in depth-first order with their names and rest pose.

use alloc::string::String;
use alloc::vec::Vec;

use super::kinematics::check_length;
use super::order::{depth_first, first_on_cycle};
use super::rigidity::Rigidity;
use super::{Joint, Pose, SkeletonError};
use crate::{Motor, Real};

/// Joints in depth-first order, with their names and the pose they rest in. There may be several roots.
///
/// Invariants, which [`Skeleton::from_parents`] establishes and nothing can break: there is at least one joint and at most
/// [`Skeleton::MAX_JOINTS`]; a parent stands before its children; a joint and all below it are contiguous; there are as many
/// names and rest motors as joints; all motors are finite.
#[derive(Clone, Debug, PartialEq)]
pub struct Skeleton<T> {
    joints: Vec<Joint<T>>,
    names: Vec<String>,
    rest_pose: Pose<T>,
}

/// The joints as the caller lists them, field by field.
struct Listing<T> {
    names: Vec<String>,
    parents: Vec<Option<usize>>,
    rests: Vec<Motor<T>>,
}

impl<T> Skeleton<T> {
    /// The most joints that a skeleton can have: a group of all of them must be countable in a `u16`.
    pub const MAX_JOINTS: usize = u16::MAX as usize;

    /// How many joints there are; never 0.
    #[expect(clippy::len_without_is_empty, reason = "a skeleton is never empty")]
    pub fn len(&self) -> usize {
        self.joints.len()
    }

    /// The joints, depth-first.
    pub fn joints(&self) -> &[Joint<T>] {
        &self.joints
    }

    /// The joints' names, one for each joint. They need not be unique, and may be empty.
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// The pose that the skeleton rests in: one local motor for each joint.
    pub fn rest_pose(&self) -> &Pose<T> {
        &self.rest_pose
    }

    /// Index of the first joint of this name.
    pub fn find(&self, name: &str) -> Option<usize> {
        self.names.iter().position(|candidate| candidate == name)
    }

    /// Index of a joint's parent; `None` for a root, and for an index at which there is no joint.
    pub fn parent(&self, joint: usize) -> Option<usize> {
        let offset = self.joints.get(joint)?.parent_offset;
        (offset != 0).then(|| joint - usize::from(offset))
    }
}

impl<T: Real> Skeleton<T> {
    /// Builds a skeleton from joints in any order, each as `(name, parent, rest)`: the parent is an index into the same list, or
    /// `None` for a root, and `rest` the joint's local motor at rest, brought back to unit if it is a little off. The bind pose is
    /// taken to be the rest pose.
    ///
    /// Returns the skeleton and the remap, which holds the new index of each joint at its old one. Children of one parent, and
    /// roots, keep the order they were given in; so a list that is depth-first already keeps its order altogether.
    ///
    /// # Errors
    /// [`SkeletonError::Empty`], [`SkeletonError::TooManyJoints`] above [`Skeleton::MAX_JOINTS`],
    /// [`SkeletonError::ParentOutOfRange`], [`SkeletonError::NonFinite`] where a rest motor, or the product of them from the
    /// root down, is, [`SkeletonError::NotRigid`] where a rest motor is more than 1e-3 away from unit, [`SkeletonError::Cycle`].
    ///
    /// ```
    /// use pga_motor::Motor;
    /// use pga_motor::skeleton::Skeleton;
    ///
    /// let rest = Motor::<f32>::IDENTITY;
    /// let (skeleton, remap) = Skeleton::from_parents([("hand", Some(2), rest), ("root", None, rest), ("arm", Some(1), rest)])?;
    /// assert_eq!(skeleton.names(), ["root", "arm", "hand"]);
    /// assert_eq!(remap, [2, 0, 1]);
    /// # Ok::<(), pga_motor::skeleton::SkeletonError>(())
    /// ```
    pub fn from_parents<N: Into<String>>(
        joints: impl IntoIterator<Item = (N, Option<usize>, Motor<T>)>,
    ) -> Result<(Self, Vec<usize>), SkeletonError> {
        let mut listing = Listing::take(joints)?;
        listing.check()?;
        let order = depth_first(&listing.parents);
        if let Some(joint) = (order.len() < listing.len()).then(|| first_on_cycle(&listing.parents)).flatten() {
            return Err(SkeletonError::Cycle { joint, name: listing.name(joint) });
        }
        let mut remap = alloc::vec![0; order.len()];
        for (new, &old) in order.iter().enumerate() {
            remap[old] = new;
        }
        let joints = listing.link(&order, &remap)?;
        let rest_pose = order.iter().map(|&old| listing.rests[old]).collect();
        let names = order.iter().map(|&old| core::mem::take(&mut listing.names[old])).collect();
        Ok((Self { joints, names, rest_pose }, remap))
    }

    /// The skeleton with other bind poses than its rest pose: for each joint, in the skeleton's order, the motor from the
    /// skeleton's space to the joint's own frame when a mesh was bound to it.
    ///
    /// # Errors
    /// [`SkeletonError::PoseLength`] where there is not one for each joint, [`SkeletonError::NonFinite`] and
    /// [`SkeletonError::NotRigid`] where one is that; joints are counted in the skeleton's order.
    pub fn with_inv_bind_poses(mut self, inv_bind_poses: &[Motor<T>]) -> Result<Self, SkeletonError> {
        check_length("inv_bind_poses", self.len(), inv_bind_poses.len())?;
        let rigidity = Rigidity::among(inv_bind_poses);
        for (joint, &motor) in inv_bind_poses.iter().enumerate() {
            if !motor.is_finite() {
                return Err(SkeletonError::NonFinite { joint, name: self.names[joint].clone() });
            }
            let motor = rigidity.brought_back(motor);
            let fault = || SkeletonError::NotRigid { joint, name: self.names[joint].clone() };
            self.joints[joint].inv_bind_pose = motor.ok_or_else(fault)?;
        }
        Ok(self)
    }
}

impl<T: Real> Listing<T> {
    /// Takes the joints in, and no more than a skeleton can hold.
    fn take<N: Into<String>>(
        joints: impl IntoIterator<Item = (N, Option<usize>, Motor<T>)>,
    ) -> Result<Self, SkeletonError> {
        let mut listing = Self { names: Vec::new(), parents: Vec::new(), rests: Vec::new() };
        for (name, parent, rest) in joints {
            if listing.len() == Skeleton::<T>::MAX_JOINTS {
                return Err(SkeletonError::TooManyJoints { joint: listing.len(), name: name.into() });
            }
            listing.names.push(name.into());
            listing.parents.push(parent);
            listing.rests.push(rest);
        }
        if listing.len() == 0 { Err(SkeletonError::Empty) } else { Ok(listing) }
    }

    fn len(&self) -> usize {
        self.parents.len()
    }

    fn name(&self, joint: usize) -> String {
        self.names[joint].clone()
    }

    /// Checks each joint by itself, and brings rest motors back to unit.
    fn check(&mut self) -> Result<(), SkeletonError> {
        let (joints, rigidity) = (self.len(), Rigidity::among(&self.rests));
        for (joint, (parent, rest)) in self.parents.iter().zip(&mut self.rests).enumerate() {
            if let Some(parent) = parent.filter(|&parent| parent >= joints) {
                let name = self.names[joint].clone();
                return Err(SkeletonError::ParentOutOfRange { joint, name, parent, joints });
            }
            if !rest.is_finite() {
                return Err(SkeletonError::NonFinite { joint, name: self.names[joint].clone() });
            }
            match rigidity.brought_back(*rest) {
                Some(motor) => *rest = motor,
                None => return Err(SkeletonError::NotRigid { joint, name: self.names[joint].clone() }),
            }
        }
        Ok(())
    }

    /// Makes the joints of a skeleton, in depth-first `order`.
    fn link(&self, order: &[usize], remap: &[usize]) -> Result<Vec<Joint<T>>, SkeletonError> {
        let mut models: Vec<Motor<T>> = Vec::with_capacity(order.len());
        let mut joints: Vec<Joint<T>> = Vec::with_capacity(order.len());
        for (new, &old) in order.iter().enumerate() {
            let parent = self.parents[old].map(|parent| remap[parent]);
            let model = parent.map_or(self.rests[old], |parent| models[parent] * self.rests[old]);
            if !model.is_finite() {
                return Err(SkeletonError::NonFinite { joint: old, name: self.name(old) });
            }
            models.push(model);
            let parent_offset = count(parent.map_or(0, |parent| new - parent));
            joints.push(Joint { inv_bind_pose: model.inverse(), parent_offset, group_size: 1 });
        }
        for joint in (0..joints.len()).rev() {
            let Joint { parent_offset, group_size, .. } = joints[joint];
            if parent_offset != 0 {
                joints[joint - usize::from(parent_offset)].group_size += group_size;
            }
        }
        Ok(joints)
    }
}

/// A number of joints, as joints store it.
fn count(joints: usize) -> u16 {
    u16::try_from(joints).expect("invariant: a skeleton has at most MAX_JOINTS joints")
}
