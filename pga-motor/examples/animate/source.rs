//! What can be played: a skeleton and its clips, wherever they come from.

mod bvh;
mod figure;
#[cfg(feature = "gltf")]
mod gltf;

use std::path::Path;

use pga_motor::import::bvh::Tip;
use pga_motor::skeleton::{Clip, ClipError, Skeleton};

/// A skeleton with at least one clip.
pub(crate) struct Source {
    /// The file's name, without the folders before it.
    pub(crate) name: String,
    pub(crate) skeleton: Skeleton<f64>,
    pub(crate) clips: Vec<Clip<f64>>,
    /// Which of the skeleton's joints are shown and listed, in the file's order. Others only carry them.
    pub(crate) joints: Vec<usize>,
    /// Where bones end beyond the last joints.
    pub(crate) tips: Vec<Tip<f64>>,
    warnings: Vec<Warning>,
}

/// What the file has that is not played as it says.
struct Warning {
    /// Of which clip; none if of the skeleton.
    clip: Option<usize>,
    text: String,
}

impl Source {
    /// Reads a file of the kind that its name tells. The error names the file and what is wrong with it.
    pub(crate) fn open(path: &Path) -> Result<Self, String> {
        let extension = path.extension().unwrap_or_default().to_string_lossy().to_ascii_lowercase();
        let read = match extension.as_str() {
            // What comes through a pipe has no name.
            "bvh" | "" => bvh::read(path),
            "glb" | "gltf" => read_gltf(path),
            _ => Err("expected a file that ends in .glb, .gltf or .bvh".to_owned()),
        };
        read.map_err(|error| format!("{}: {error}", path.display()))
    }

    /// A figure written in code.
    pub(crate) fn figure() -> Self {
        figure::source()
    }

    /// The clip with exactly this name, or else at this index; the first if none is named.
    pub(crate) fn clip(&self, wanted: Option<&str>) -> Result<usize, String> {
        let Some(wanted) = wanted else { return Ok(0) };
        let named = self.clips.iter().position(|clip| clip.name() == wanted);
        let numbered = || wanted.parse().ok().filter(|&index| index < self.clips.len());
        named.or_else(numbered).ok_or_else(|| {
            let clips: Vec<_> =
                self.clips.iter().enumerate().map(|(i, clip)| format!("{i} `{}`", clip.name())).collect();
            format!("{}: expected one of the clips {}, found `{wanted}`", self.name, clips.join(", "))
        })
    }

    /// What is to be known before a clip is played.
    pub(crate) fn warnings(&self, clip: usize) -> impl Iterator<Item = &str> {
        let concerns = move |warning: &&Warning| warning.clip.is_none_or(|of| of == clip);
        self.warnings.iter().filter(concerns).map(|warning| warning.text.as_str())
    }

    /// What a clip is called: its name, or its index if it has none.
    pub(crate) fn clip_name(&self, clip: usize) -> String {
        match self.clips[clip].name() {
            "" => clip.to_string(),
            name => name.to_owned(),
        }
    }
}

#[cfg(feature = "gltf")]
fn read_gltf(path: &Path) -> Result<Source, String> {
    gltf::read(path)
}

#[cfg(not(feature = "gltf"))]
fn read_gltf(_: &Path) -> Result<Source, String> {
    Err("glTF is read by a build with `--features gltf`, which this one is not".to_owned())
}

/// The name of a file without the folders before it.
fn name_of(path: &Path) -> String {
    path.file_name().map_or_else(|| path.display().to_string(), |name| name.to_string_lossy().into_owned())
}

/// A clip of one key, the rest pose, for a file that has none.
fn rest_clip(skeleton: &Skeleton<f64>) -> Result<Clip<f64>, ClipError> {
    Ok(Clip::new(skeleton.len(), vec![0.0], skeleton.rest_pose().to_vec())?.with_name("rest"))
}
