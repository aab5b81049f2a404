//! What can be wrong with a clip, or with what it is asked for.

use core::fmt;

/// Why a clip cannot be built or sampled. Keys and joints are counted from 0.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ClipError {
    /// There are no joints or no keys.
    Empty {
        /// How many joints there are.
        joints: usize,
        /// How many keys there are.
        keys: usize,
    },
    /// There is not one motor for each joint in each key.
    KeyCount {
        /// The number of times multiplied by the number of joints.
        expected: usize,
        /// How many motors there are.
        found: usize,
    },
    /// A file makes more motors of a clip than are allowed for its size.
    TooManyKeys {
        /// How many are allowed.
        limit: usize,
        /// How many there would be: the number of keys multiplied by the number of joints.
        found: usize,
    },
    /// There is not one pair of modes for each joint.
    ModeCount {
        /// How many joints there are.
        expected: usize,
        /// How many pairs there are.
        found: usize,
    },
    /// A key's time is NaN or infinite.
    TimeNotFinite {
        /// The key.
        key: usize,
    },
    /// A key's time is not after that of the key before.
    TimeNotIncreasing {
        /// The later key.
        key: usize,
    },
    /// A key's motor is NaN or infinite.
    NonFinite {
        /// The key.
        key: usize,
        /// The joint.
        joint: usize,
    },
    /// A key's motor has no rotation at all, not even that by 0.
    ZeroKey {
        /// The key.
        key: usize,
        /// The joint.
        joint: usize,
    },
    /// A key's motor is far from a unit motor.
    NotRigid {
        /// The key.
        key: usize,
        /// The joint.
        joint: usize,
    },
    /// A buffer does not have one motor for each joint.
    PoseLength {
        /// How many joints the clip has.
        expected: usize,
        /// How many motors the buffer has.
        found: usize,
    },
    /// The time asked for is NaN or infinite.
    SampleTime,
    /// A clip or an instance has another number of joints than the skeleton.
    JointCount {
        /// Which of them: `"clip"` or `"instance"`.
        what: &'static str,
        /// How many joints the skeleton has.
        expected: usize,
        /// How many joints it has.
        found: usize,
    },
    /// What was asked for leaves the range of the numbers: a way of very many rounds.
    OutOfRange,
}

impl fmt::Display for ClipError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Empty { joints, keys } => {
                write!(f, "expected at least one joint and one key, found {joints} joints and {keys} keys")
            }
            Self::KeyCount { expected, found } => {
                write!(f, "expected {expected} motors, one for each joint in each key, found {found}")
            }
            Self::TooManyKeys { limit, found } => write!(f, "expected at most {limit} motors in a clip, found {found}"),
            Self::ModeCount { expected, found } => {
                write!(f, "expected {expected} pairs of modes, one for each joint, found {found}")
            }
            Self::TimeNotFinite { key } => write!(f, "key {key}: expected a finite time, found a NaN or an infinity"),
            Self::TimeNotIncreasing { key } => {
                write!(f, "key {key}: expected a time after that of key {}, found one that is not", key - 1)
            }
            Self::NonFinite { key, joint } => {
                write!(f, "key {key}, joint {joint}: expected a finite motor, found a NaN or an infinity")
            }
            Self::ZeroKey { key, joint } => {
                write!(f, "key {key}, joint {joint}: expected a unit motor, found one whose rotation is zero")
            }
            Self::NotRigid { key, joint } => {
                write!(f, "key {key}, joint {joint}: expected a unit motor, found one that is not rigid")
            }
            Self::PoseLength { expected, found } => {
                write!(f, "expected {expected} motors in the pose, one for each joint of the clip, found {found}")
            }
            Self::SampleTime => write!(f, "expected a finite time to sample at, found a NaN or an infinity"),
            Self::JointCount { what, expected, found } => {
                write!(f, "expected {expected} joints in the {what}, as many as the skeleton has, found {found}")
            }
            Self::OutOfRange => write!(f, "expected a way in the range of the numbers, found one that leaves it"),
        }
    }
}

impl core::error::Error for ClipError {}
