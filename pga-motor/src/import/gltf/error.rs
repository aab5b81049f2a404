//! What can be wrong with a glTF file.

use alloc::boxed::Box;
use alloc::string::String;
use core::fmt;

use super::place::Place;
use crate::skeleton::{ClipError, SkeletonError};

/// A file that cannot be read: the place in it, and the reason.
#[derive(Clone, Debug, PartialEq)]
pub struct GltfError {
    /// On the heap, so that results stay small.
    fault: Box<(Place, GltfReason)>,
}

/// Why a file cannot be read. What is quoted from the file is cut short where it is very long. Keys, joints of a skin and all
/// else are counted from 0.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum GltfReason {
    /// A file could not be opened or read.
    Io {
        /// Its path.
        path: String,
        /// What the system says.
        message: String,
    },
    /// The container is damaged, or there is no glTF in it.
    Container {
        /// What should be there.
        expected: &'static str,
        /// What is there.
        found: String,
    },
    /// The JSON is damaged, or is not glTF's.
    Json {
        /// What its reader says.
        message: String,
    },
    /// The file is of another version than 2.
    Version {
        /// Which one.
        found: String,
    },
    /// The file requires an extension that keeps its buffers in another form.
    Extension {
        /// Its name.
        name: String,
    },
    /// An address of a buffer that is not followed.
    Uri {
        /// What addresses are followed.
        expected: &'static str,
        /// The address.
        found: String,
    },
    /// The data of a buffer could not be had.
    Load {
        /// The buffer's address.
        uri: String,
        /// Why.
        message: String,
    },
    /// An index leads nowhere.
    OutOfRange {
        /// Of what.
        what: &'static str,
        /// The index.
        found: usize,
        /// How many of these there are.
        count: usize,
    },
    /// There are fewer bytes than needed.
    Truncated {
        /// What they are needed for.
        what: String,
        /// How many are needed.
        expected: u128,
        /// How many there are.
        found: u128,
    },
    /// An accessor holds something else than it should, or in a way that is not read.
    Accessor {
        /// Its index.
        accessor: usize,
        /// What it should hold.
        expected: String,
        /// What it holds.
        found: String,
    },
    /// There are not as many values as the keys, or the joints, ask for.
    ValueCount {
        /// How many there should be.
        expected: usize,
        /// How many there are.
        found: usize,
    },
    /// A channel has no keys.
    NoKeys,
    /// The interpolation of a sampler is none of the three that there are.
    UnknownInterpolation,
    /// A number is NaN, infinite, or too large for the type it is read into.
    NotFinite {
        /// What the number is for.
        what: String,
    },
    /// Going from node to parent leads back to the node.
    Cycle,
    /// A node is the child of two nodes, or twice of one.
    TwoParents {
        /// The nodes.
        parents: [usize; 2],
    },
    /// A scale is 0, or so near that it cannot be computed with.
    ZeroScale,
    /// A scale has a negative factor, or a matrix mirrors.
    Mirrored,
    /// A scale is not the same along all axes.
    NotUniform {
        /// The factors along the axes.
        scale: [f64; 3],
    },
    /// The axes of a matrix are not perpendicular.
    Sheared {
        /// The greatest cosine of an angle between two of them.
        cosine: f64,
    },
    /// The last row of a matrix is not 0 0 0 1.
    NotAffine,
    /// A quaternion is zero.
    ZeroRotation {
        /// Which key; `None` for a node's own.
        key: Option<usize>,
    },
    /// A node's scale is animated: it is not that of the node at rest to 1e-4 at all times.
    AnimatedScale {
        /// The first key at fault.
        key: usize,
        /// The node's scale at rest.
        expected: f64,
        /// The scale there, or, where that is right, the furthest that the tangents beside it may lead.
        found: [f64; 3],
    },
    /// Scales that are animated by less than 1e-4 of the node's own add up, or have so long a lever, that without them joints would be
    /// off by more than 1e-4 of the skeleton's size. The channel is the one that counts most.
    ScaleDrift {
        /// How far joints would be off at most, relative to the skeleton's size.
        off: f64,
    },
    /// A key's time is not after that of the key before.
    TimeNotIncreasing {
        /// The later key.
        key: usize,
    },
    /// An earlier channel of the animation drives the same.
    RepeatedChannel {
        /// Which one.
        first: usize,
    },
    /// The keys of all clips together, or the values in the file, are too many.
    TooManyKeys {
        /// How many there may be.
        limit: usize,
        /// What is counted.
        what: &'static str,
    },
    /// A spline cannot be followed with as many keys as may be added to a channel.
    SplineTooWild {
        /// How many that are.
        limit: usize,
    },
    /// The joints of a skin scale its mesh by different factors, which no rigid motion can.
    SkinScale {
        /// The factor of the first joint.
        expected: f64,
        /// The factor of this one.
        found: f64,
    },
    /// The nodes are well written but make no skeleton.
    Skeleton(SkeletonError),
    /// The keys are well written but make no clip.
    Clip(ClipError),
}

impl GltfReason {
    pub(super) fn at(self, place: Place) -> GltfError {
        GltfError { fault: Box::new((place, self)) }
    }
}

impl GltfError {
    /// Where in the file it is.
    pub fn place(&self) -> &Place {
        &self.fault.0
    }

    /// What is wrong there.
    pub fn reason(&self) -> &GltfReason {
        &self.fault.1
    }
}

impl fmt::Display for GltfError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.place(), self.reason())
    }
}

/// Factors of a scale with the digits that a file has: most of them were single precision there.
struct Factors<'a>(&'a [f64]);

impl fmt::Display for Factors<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, &factor) in self.0.iter().enumerate() {
            write!(f, "{}{}", if i == 0 { "" } else { " " }, factor as f32)?;
        }
        Ok(())
    }
}

impl fmt::Display for GltfReason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Io { path, message } => write!(f, "expected to read {path}, found: {message}"),
            Self::Container { expected, found } => write!(f, "expected {expected}, found {found}"),
            Self::Json { message } => write!(f, "expected the JSON of glTF, found: {message}"),
            Self::Version { found } => write!(f, "expected glTF of version 2, found version `{found}`"),
            Self::Extension { name } => {
                write!(f, "expected buffers as they are, found them in the form of the extension `{name}`")
            }
            Self::Uri { expected, found } => write!(f, "expected {expected}, found `{found}`"),
            Self::Load { uri, message } => write!(f, "expected a buffer at `{uri}`, found: {message}"),
            Self::OutOfRange { what, found, count } => {
                write!(f, "expected {what} below {count}, the number of them, found {found}")
            }
            Self::Truncated { what, expected, found } => {
                write!(f, "expected {expected} bytes for {what}, found {found}")
            }
            Self::Accessor { accessor, expected, found } => {
                write!(f, "expected {expected} in accessor {accessor}, found {found}")
            }
            Self::ValueCount { expected, found } => write!(f, "expected {expected} values, found {found}"),
            Self::NoKeys => write!(f, "expected at least one key, found none"),
            Self::UnknownInterpolation => {
                write!(f, "expected an interpolation of LINEAR, STEP and CUBICSPLINE, found another")
            }
            Self::NotFinite { what } => write!(f, "expected a finite {what}, found a NaN or an infinity"),
            Self::Cycle => write!(f, "expected a chain of parents that ends at a root, found a cycle"),
            Self::TwoParents { parents: [a, b] } => {
                write!(f, "expected at most one parent, found it among the children of node {a} and node {b}")
            }
            Self::ZeroScale => write!(f, "expected a positive scale, found zero"),
            Self::Mirrored => write!(f, "expected a positive scale, found a mirror"),
            Self::NotUniform { scale } => {
                write!(f, "expected the same scale along all axes, found {}", Factors(scale))
            }
            Self::Sheared { cosine } => {
                write!(f, "expected perpendicular axes, found two with a cosine of {}", *cosine as f32)
            }
            Self::NotAffine => write!(f, "expected a matrix with the last row 0 0 0 1, found another"),
            Self::ZeroRotation { key: Some(key) } => {
                write!(f, "key {key}: expected a unit quaternion, found one of length zero")
            }
            Self::ZeroRotation { key: None } => write!(f, "expected a unit quaternion, found one of length zero"),
            Self::AnimatedScale { key, expected, found } => {
                let (expected, found) = (*expected as f32, Factors(found));
                write!(f, "key {key}: expected the scale of the node at rest, {expected}, found {found}")
            }
            Self::ScaleDrift { off } => {
                write!(
                    f,
                    "expected animated scales that move joints by at most 1e-4 of the skeleton's size, found {off:.1e}"
                )
            }
            Self::TimeNotIncreasing { key } => {
                write!(f, "key {key}: expected a time after that of key {}, found one that is not", key - 1)
            }
            Self::RepeatedChannel { first } => {
                write!(f, "expected one channel for a property of a node, found a second after channel {first}")
            }
            Self::TooManyKeys { limit, what } => write!(f, "expected at most {limit} {what}, found more"),
            Self::SplineTooWild { limit } => {
                write!(f, "expected a spline that {limit} further keys can follow, found one that needs more")
            }
            Self::SkinScale { expected, found } => {
                let (expected, found) = (*expected as f32, *found as f32);
                write!(f, "expected the mesh to be scaled by {expected}, as at the skin's first joint, found {found}")
            }
            Self::Skeleton(error) => error.fmt(f),
            Self::Clip(error) => error.fmt(f),
        }
    }
}

impl core::error::Error for GltfError {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        match self.reason() {
            GltfReason::Skeleton(error) => Some(error),
            GltfReason::Clip(error) => Some(error),
            _ => None,
        }
    }
}
