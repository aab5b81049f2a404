//! glTF 2.0 files (`.glb`, `.gltf`): a skeleton, its skins, and a clip for each animation.
//!
//! **Joints** are the joints of the file's skins and all nodes above these, up to the roots, for those may move too; where the file
//! has no skin, all its nodes. [`Gltf::joints`] and [`Skin::joints`] tell which of the skeleton's joints are those of the skins.
//!
//! **Numbers** mean what the format says: lengths in metres, angles in radians, seconds, right-handed, y up. Model motors lead to
//! the file's space, in which its roots stand. Accessors may be sparse; one without a buffer view is zeros.
//!
//! **Scale.** A motor is rigid. A scale that is the same along all axes and at all times is folded into the translations below it,
//! so that joints are where the file has them. With s the scales of the nodes above a joint multiplied, and t and R the joint's own
//! translation and rotation, its local motor is
//!
//! ```text
//! local = translator(s t) * R
//! ```
//!
//! What the joints would scale besides, the mesh, is to be scaled beforehand, by [`Skin::scale`]. Scales that are not such are
//! refused.
//!
//! **Clips** have a key wherever a channel has one. LINEAR and STEP channels are kept to the letter: sampled with
//! [`Interpolation::Split`](crate::skeleton::Interpolation::Split), and with the clip's own modes for STEP, a clip is what the
//! format says. For CUBICSPLINE channels keys are added until joints are within 1e-4 of the skeleton's size of where the format
//! has them, whose size is the diagonal of the box around the joints of its skins at rest.
//!
//! ```
//! use pga_motor::import::gltf;
//!
//! let text = r#"{
//!     "asset": { "version": "2.0" },
//!     "nodes": [
//!         { "name": "armature", "children": [1], "scale": [0.01, 0.01, 0.01] },
//!         { "name": "hip", "children": [2], "translation": [0, 90, 0] },
//!         { "name": "knee", "translation": [0, -40, 0], "rotation": [0, 0, 0.6, 0.8] }
//!     ],
//!     "skins": [ { "joints": [2, 1] } ]
//! }"#;
//! let file = gltf::parse::<f64>(text.as_bytes())?;
//! assert_eq!(file.skeleton().names(), ["armature", "hip", "knee"]);
//! assert_eq!(file.joints(), [2, 1]);
//! assert!((file.skins()[0].scale - 0.01).abs() < 1e-8);
//!
//! // In single precision, as the format's numbers are.
//! let knee = file.skeleton().rest_pose()[2];
//! assert!((knee.transform_origin().y - -0.4).abs() < 1e-7);
//! # Ok::<(), gltf::GltfError>(())
//! ```

mod allowance;
mod buffers;
mod channel;
mod clip;
mod curve;
mod document;
mod error;
mod hierarchy;
mod place;
mod similarity;
mod skin;
mod sparse;
mod spline;
mod tolerance;
mod uri;
mod warning;

use alloc::string::{String, ToString};
use alloc::vec::Vec;
use std::fs;
use std::io::Read;
use std::path::Path;

pub use allowance::MAX_JOINT_KEYS;
pub use error::{GltfError, GltfReason};
pub use place::{Named, Place, Property};
pub use skin::Skin;
pub use warning::Warning;

use crate::Real;
use crate::skeleton::{Clip, Skeleton};
use buffers::{Buffers, Load, no_files};
use document::Document;
use hierarchy::Hierarchy;
use place::quote;

#[cfg(test)]
mod tests;

/// A file that has been read.
#[derive(Clone, Debug, PartialEq)]
pub struct Gltf<T> {
    skeleton: Skeleton<T>,
    nodes: Vec<usize>,
    joints: Vec<usize>,
    skins: Vec<Skin<T>>,
    clips: Vec<Clip<T>>,
    warnings: Vec<Warning>,
}

impl<T> Gltf<T> {
    /// The skeleton, in the pose that the nodes have. Names are the nodes'; a node without one is called `node_` and its index.
    ///
    /// The bind poses are those of the skins, for a joint of several the first one's, and for a joint of none the rest pose.
    pub fn skeleton(&self) -> &Skeleton<T> {
        &self.skeleton
    }

    /// For each joint of the skeleton the index of its node in the file.
    pub fn nodes(&self) -> &[usize] {
        &self.nodes
    }

    /// The joints of the file's skins, as indices into the skeleton, in the order of the file: skin after skin, each once. In a file
    /// without skins those of all its nodes.
    pub fn joints(&self) -> &[usize] {
        &self.joints
    }

    /// The skins, in the order of the file.
    pub fn skins(&self) -> &[Skin<T>] {
        &self.skins
    }

    /// One clip for each animation, in the order of the file, with its name, or `animation_` and its index. One that moves nothing of
    /// the skeleton is a clip of the rest pose.
    pub fn clips(&self) -> &[Clip<T>] {
        &self.clips
    }

    /// What was brought in order or left out, in the order in which it was found.
    pub fn warnings(&self) -> &[Warning] {
        &self.warnings
    }
}

/// How many bytes the files beside a file may have together.
pub const MAX_BUFFER_BYTES: u64 = 1 << 31;

/// Reads a file, and the files beside it in which it keeps buffers. Of these only what skins and animations need is read, and only
/// from the file's folder and below.
///
/// # Errors
/// [`GltfReason::Io`] where the file cannot be read, [`GltfReason::Load`] where one beside it cannot, or all of them have more than
/// [`MAX_BUFFER_BYTES`], and those of [`parse`].
pub fn read<T: Real>(path: impl AsRef<Path>) -> Result<Gltf<T>, GltfError> {
    let path = path.as_ref();
    let io = |error: std::io::Error| GltfReason::Io { path: path.display().to_string(), message: error.to_string() };
    let bytes = fs::read(path).map_err(|error| io(error).at(Place::File))?;
    let folder = path.parent().unwrap_or_else(|| Path::new(""));
    let mut left = MAX_BUFFER_BYTES;
    parse_all(&bytes, &mut |uri| {
        let beside = uri::path_beside(uri)?;
        let load = |message: String| GltfReason::Load { uri: quote(uri), message };
        let file = fs::File::open(folder.join(beside)).map_err(|error| load(error.to_string()))?;
        let mut buffer = Vec::new();
        let length = file.take(left + 1).read_to_end(&mut buffer).map_err(|error| load(error.to_string()))? as u64;
        left = left
            .checked_sub(length)
            .ok_or_else(|| load(alloc::format!("more than {MAX_BUFFER_BYTES} bytes in all")))?;
        Ok(buffer)
    })
}

/// Reads a file from its bytes. Its buffers must be within it: in the binary chunk, or in data addresses.
///
/// Time and memory are proportional to the length of the file, plus what clips take: no more than [`MAX_JOINT_KEYS`] keys of
/// joints, whatever numbers the file declares. How deep nodes nest does not matter.
///
/// # Errors
/// [`GltfError`], with the place and the reason: for a container or JSON that is damaged, and for versions other than 2; for
/// buffers that are too short, accessors that leave them or hold something else than they should, sparse accessors whose indices
/// do not increase or are not below their count, and indices that lead nowhere; for nodes that have two parents or form a cycle;
/// for scales that are animated, differ along the axes by more than 1e-4 of them, are zero or mirror, and for matrices that shear,
/// of joints and of inverse bind matrices; for skins whose joints scale the mesh differently; for numbers that are not finite; for
/// quaternions of length zero; for key times that do not increase, values that are not as many as the keys, and several channels
/// for one property of a joint; for more joints than [`Skeleton::MAX_JOINTS`] and more keys than [`MAX_JOINT_KEYS`]. What is not
/// part of the skeleton may be as it likes.
pub fn parse<T: Real>(bytes: &[u8]) -> Result<Gltf<T>, GltfError> {
    parse_all(bytes, &mut no_files)
}

/// Reads a file from its bytes, and buffers from wherever `load` gets them. It is handed the address as it is written in the file,
/// which deserves no trust: it may be absolute, remote, or go up. Data addresses never reach it.
///
/// # Errors
/// [`GltfReason::Load`] where `load` fails, and those of [`parse`].
pub fn parse_with<T: Real, E: ToString>(
    bytes: &[u8],
    mut load: impl FnMut(&str) -> Result<Vec<u8>, E>,
) -> Result<Gltf<T>, GltfError> {
    parse_all(bytes, &mut |uri| {
        load(uri).map_err(|error| GltfReason::Load { uri: quote(uri), message: error.to_string() })
    })
}

fn parse_all<T: Real>(bytes: &[u8], load: Load<'_>) -> Result<Gltf<T>, GltfError> {
    let document = Document::parse(bytes).map_err(|reason| reason.at(Place::File))?;
    let root = &document.root;
    let mut warnings = Vec::new();
    let hierarchy = Hierarchy::of(root, &mut warnings)?;
    let skeleton = hierarchy.skeleton(root)?;
    let mut buffers = Buffers::new(&document, load);
    let skins = skin::read_skins(root, &hierarchy, &mut buffers)?;
    let skeleton = skin::bind(root, skeleton, &hierarchy, &skins)?;
    let clips = clip::Reader::new(root, &hierarchy, &mut buffers, &mut warnings).read()?;
    let nodes = hierarchy.joints.iter().map(|joint| joint.node).collect();
    Ok(Gltf { skeleton, nodes, joints: hierarchy.listed, skins, clips, warnings })
}
