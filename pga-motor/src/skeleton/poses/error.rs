//! What can be wrong with poses, or with what they are asked for.

use core::fmt;

/// Why something cannot be done with [`Poses`](super::Poses). Characters and joints are counted from 0.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum PosesError {
    /// A pose, skeleton or clip has another number of joints.
    Joints {
        /// How many joints the poses have.
        expected: usize,
        /// How many there are.
        found: usize,
    },
    /// There is not one time, or place for results, for each character.
    Characters {
        /// How many characters there are.
        expected: usize,
        /// How many times or places.
        found: usize,
    },
    /// There is no such character.
    NoSuchCharacter {
        /// The one asked for.
        character: usize,
        /// How many there are.
        len: usize,
    },
    /// The time to sample at is NaN or infinite.
    SampleTime {
        /// Whose time it is.
        character: usize,
    },
}

impl fmt::Display for PosesError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Joints { expected, found } => write!(f, "expected {expected} joints, found {found}"),
            Self::Characters { expected, found } => write!(f, "expected {expected} characters, found {found}"),
            Self::NoSuchCharacter { character, len } => {
                write!(f, "expected one of {len} characters, found character {character}")
            }
            Self::SampleTime { character } => {
                write!(f, "character {character}: expected a finite time to sample at, found a NaN or an infinity")
            }
        }
    }
}

impl core::error::Error for PosesError {}
