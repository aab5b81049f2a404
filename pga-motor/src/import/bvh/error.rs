//! What can be wrong with a BVH file.

use alloc::borrow::ToOwned;
use alloc::string::String;
use core::fmt;

use crate::skeleton::SkeletonError;

/// A file that cannot be read: the line, and the reason.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BvhError {
    line: usize,
    reason: BvhReason,
}

/// Why a file cannot be read. Words found are quoted from the file, the very long ones cut short.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum BvhReason {
    /// A word that the format does not have at this place.
    UnknownKeyword {
        /// What may stand here.
        expected: String,
        /// What does.
        found: String,
    },
    /// A joint or an end site has no body in braces, or no end of it.
    MissingBrace {
        /// Which brace, and of what.
        expected: String,
        /// What stands in its place.
        found: String,
    },
    /// The file ends too early.
    Truncated {
        /// What should have followed.
        expected: String,
    },
    /// A joint or an end site lacks something it must have.
    Missing {
        /// What, and of which joint.
        expected: String,
    },
    /// A joint has something twice.
    Repeated {
        /// What, and of which joint.
        what: String,
    },
    /// A word that should be a number is not.
    NotANumber {
        /// What the number is for.
        what: String,
        /// What stands in its place.
        found: String,
    },
    /// A number is NaN, infinite, or too large for the type it is read into.
    NotFinite {
        /// What the number is for.
        what: String,
        /// The number as written.
        found: String,
    },
    /// A word that should be a whole number from 0 up is not.
    NotACount {
        /// What is counted.
        what: String,
        /// What stands in its place.
        found: String,
    },
    /// A channel has a name that is none of `Xposition`, ..., `Zrotation`.
    UnknownChannel {
        /// Which joint's.
        joint: String,
        /// The name.
        found: String,
    },
    /// A joint declares a number of channels and names another.
    ChannelCount {
        /// Which joint.
        joint: String,
        /// The number declared.
        expected: usize,
        /// The number of names.
        found: usize,
    },
    /// There are frames, but no channels for them to fill.
    NoChannels {
        /// The number of frames declared.
        frames: usize,
    },
    /// The time between frames is negative, or zero where there are several frames.
    FrameTime {
        /// The time as written.
        found: String,
    },
    /// A frame has not one value for each channel.
    ValueCount {
        /// The number of channels.
        expected: usize,
        /// The number of values.
        found: usize,
    },
    /// There are not as many frames as declared.
    FrameCount {
        /// The number declared.
        expected: usize,
        /// The number there are.
        found: usize,
    },
    /// The joints are well written but make no skeleton.
    Skeleton(SkeletonError),
}

impl BvhError {
    pub(super) const fn new(line: usize, reason: BvhReason) -> Self {
        Self { line, reason }
    }

    /// The line at fault, counted from 1. Where something is missing at the end of the file, the last line with text on it.
    pub const fn line(&self) -> usize {
        self.line
    }

    /// What is wrong there.
    pub const fn reason(&self) -> &BvhReason {
        &self.reason
    }
}

impl fmt::Display for BvhError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "line {}: {}", self.line, self.reason)
    }
}

impl fmt::Display for BvhReason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::UnknownKeyword { expected, found } | Self::MissingBrace { expected, found } => {
                write!(f, "expected {expected}, found `{found}`")
            }
            Self::Truncated { expected } => write!(f, "expected {expected}, found the end of the file"),
            Self::Missing { expected } => write!(f, "expected {expected}, found none"),
            Self::Repeated { what } => write!(f, "expected one {what}, found a second"),
            Self::NotANumber { what, found } => write!(f, "expected a number for {what}, found `{found}`"),
            Self::NotFinite { what, found } => write!(f, "expected a finite number for {what}, found `{found}`"),
            Self::NotACount { what, found } => write!(f, "expected the number of {what}, found `{found}`"),
            Self::UnknownChannel { joint, found } => {
                write!(f, "expected a channel from Xposition to Zrotation in {joint}, found `{found}`")
            }
            Self::ChannelCount { joint, expected, found } => {
                write!(f, "expected {expected} channels in {joint}, as declared, found {found}")
            }
            Self::NoChannels { frames } => write!(f, "expected channels for {frames} frames to fill, found none"),
            Self::FrameTime { found } => write!(f, "expected a positive time between frames, found `{found}`"),
            Self::ValueCount { expected, found } => {
                write!(f, "expected {expected} values in the frame, one for each channel, found {found}")
            }
            Self::FrameCount { expected, found } => write!(f, "expected {expected} frames, as declared, found {found}"),
            Self::Skeleton(error) => write!(f, "{error}"),
        }
    }
}

impl core::error::Error for BvhError {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        match &self.reason {
            BvhReason::Skeleton(error) => Some(error),
            _ => None,
        }
    }
}

/// A frame that cannot be given.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum FrameError {
    /// There is no frame of this number.
    OutOfRange {
        /// The number asked for, from 0 up.
        frame: usize,
        /// How many frames there are.
        frames: usize,
    },
    /// The buffer does not have one motor for each joint.
    PoseLength {
        /// How many joints there are.
        expected: usize,
        /// How many motors the buffer has.
        found: usize,
    },
}

impl fmt::Display for FrameError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::OutOfRange { frame, frames } => {
                write!(f, "expected a frame below {frames}, the number of frames, found {frame}")
            }
            Self::PoseLength { expected, found } => {
                write!(f, "expected {expected} motors in the pose, one for each joint, found {found}")
            }
        }
    }
}

impl core::error::Error for FrameError {}

/// A piece of the file, to be quoted in an error: at most 40 characters of it, so that an error stays readable.
pub(super) fn quote(text: &str) -> String {
    const LONGEST: usize = 40;
    match text.char_indices().nth(LONGEST) {
        Some((end, _)) => text[..end].to_owned() + "...",
        None => text.to_owned(),
    }
}
