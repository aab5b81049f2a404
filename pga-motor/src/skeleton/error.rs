//! What can be wrong with a skeleton, or with the buffers handed to it.

use alloc::string::String;
use core::fmt;

/// Why a skeleton cannot be built, or a pose of it not be taken. Where a joint is at fault it is named, by its index in the
/// list that the caller gave and by its name.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum SkeletonError {
    /// No joints were given.
    Empty,
    /// More joints were given than [`Skeleton::MAX_JOINTS`](super::Skeleton::MAX_JOINTS).
    TooManyJoints {
        /// Index of the first joint that has no place.
        joint: usize,
        /// Its name.
        name: String,
    },
    /// A joint's parent is not one of the joints.
    ParentOutOfRange {
        /// Index of the joint as given.
        joint: usize,
        /// Its name.
        name: String,
        /// The index that it gives as its parent.
        parent: usize,
        /// How many joints there are.
        joints: usize,
    },
    /// Going from parent to parent leads back to the joint.
    Cycle {
        /// Index of the first joint, as given, that is its own ancestor.
        joint: usize,
        /// Its name.
        name: String,
    },
    /// A joint's rest motor, or the model motor that follows from it and its ancestors', or its bind motor, is NaN or infinite.
    NonFinite {
        /// Index of the joint as given.
        joint: usize,
        /// Its name.
        name: String,
    },
    /// A joint's rest or bind motor is far from a unit motor: it would scale or tear what it moves.
    NotRigid {
        /// Index of the joint as given.
        joint: usize,
        /// Its name.
        name: String,
    },
    /// A buffer does not have one motor for each joint.
    PoseLength {
        /// Which one: the name of the parameter.
        buffer: &'static str,
        /// How many joints the skeleton has.
        expected: usize,
        /// How many motors the buffer has.
        found: usize,
    },
}

impl SkeletonError {
    /// Index, in the list that the caller gave, of the joint at fault; `None` where no single joint is.
    pub const fn joint(&self) -> Option<usize> {
        match self {
            Self::Empty | Self::PoseLength { .. } => None,
            Self::TooManyJoints { joint, .. }
            | Self::ParentOutOfRange { joint, .. }
            | Self::Cycle { joint, .. }
            | Self::NonFinite { joint, .. }
            | Self::NotRigid { joint, .. } => Some(*joint),
        }
    }
}

impl fmt::Display for SkeletonError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Empty => write!(f, "expected at least one joint, found none"),
            Self::TooManyJoints { joint, name } => {
                write!(f, "joint {joint} `{name}`: expected at most {} joints, found more", u16::MAX)
            }
            Self::ParentOutOfRange { joint, name, parent, joints } => {
                write!(
                    f,
                    "joint {joint} `{name}`: expected a parent below {joints}, the number of joints, found {parent}"
                )
            }
            Self::Cycle { joint, name } => {
                write!(f, "joint {joint} `{name}`: expected a chain of parents that ends at a root, found a cycle")
            }
            Self::NonFinite { joint, name } => {
                write!(f, "joint {joint} `{name}`: expected a finite motor, found a NaN or an infinity")
            }
            Self::NotRigid { joint, name } => {
                write!(f, "joint {joint} `{name}`: expected a unit motor, found one that is not rigid")
            }
            Self::PoseLength { buffer, expected, found } => {
                write!(f, "expected {expected} motors in `{buffer}`, one for each joint, found {found}")
            }
        }
    }
}

impl core::error::Error for SkeletonError {}
