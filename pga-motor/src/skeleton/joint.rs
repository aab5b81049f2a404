//! One joint of a skeleton.

use crate::Motor;

/// A joint: where it stood when a mesh was bound to it, and its place in the hierarchy.
///
/// Joints live in a [`Skeleton`](super::Skeleton), depth-first, and the two `u16`s speak about that order.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Joint<T> {
    /// Takes the skeleton's space in the bind pose to the joint's own frame: the inverse of the model motor that the joint
    /// had when a mesh was bound to it.
    pub inv_bind_pose: Motor<T>,
    /// How many places before this joint its parent stands: index minus parent's index. 0 marks a root.
    pub parent_offset: u16,
    /// How many joints the group of this joint has: itself and everything below it, which follow it without a gap. A leaf has 1.
    pub group_size: u16,
}

impl<T> Joint<T> {
    /// Whether the joint has no parent.
    pub const fn is_root(&self) -> bool {
        self.parent_offset == 0
    }
}
