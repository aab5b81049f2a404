//! What was changed or left out in reading a file that was read all the same.

use core::fmt;

use super::place::Place;

/// Something in a file that was brought in order or left out. There is at most one of each kind for a node or a channel, however
/// many keys it is about.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Warning {
    /// Quaternions off unit length by more than the rounding of their format were made unit.
    Renormalized {
        /// Of which node or channel.
        place: Place,
        /// How many.
        count: usize,
        /// The greatest distance of a length from 1.
        worst: f64,
    },
    /// Keys on the far side of the sphere of quaternions from the key before were taken as their negatives, the same rotations.
    Realigned {
        /// Of which channel.
        place: Place,
        /// How many.
        count: usize,
    },
    /// An animated scale that stays within 1e-4 of the node's own was left out.
    ScaleDropped {
        /// Of which channel.
        place: Place,
        /// The greatest difference, relative to the node's scale.
        worst: f64,
    },
    /// Weights of morph targets are not read.
    MorphWeights {
        /// Of which channel.
        place: Place,
    },
    /// A channel that drives no node, or something of it that the format's core does not know, was skipped.
    ChannelSkipped {
        /// Which channel.
        place: Place,
    },
}

impl Warning {
    /// Where in the file it is.
    pub const fn place(&self) -> &Place {
        match self {
            Self::Renormalized { place, .. }
            | Self::Realigned { place, .. }
            | Self::ScaleDropped { place, .. }
            | Self::MorphWeights { place }
            | Self::ChannelSkipped { place } => place,
        }
    }
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: ", self.place())?;
        match self {
            Self::Renormalized { count, worst, .. } => {
                write!(f, "made {count} quaternions unit whose lengths were off 1 by up to {worst:.1e}")
            }
            Self::Realigned { count, .. } => write!(f, "changed the sign of {count} quaternions, for the short way"),
            Self::ScaleDropped { worst, .. } => {
                write!(f, "left out a scale that differs from the node's by up to {worst:.1e} of it")
            }
            Self::MorphWeights { .. } => write!(f, "left out weights of morph targets"),
            Self::ChannelSkipped { .. } => write!(f, "skipped, for it drives nothing that is read here"),
        }
    }
}
