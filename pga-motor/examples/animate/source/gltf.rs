//! glTF, text or binary.

use std::path::Path;

use pga_motor::import::gltf::{self, Place};

use super::{Source, Warning, name_of, rest_clip};

/// Reads a glTF file. Without clips it stands in its rest pose.
pub(super) fn read(path: &Path) -> Result<Source, String> {
    let file = gltf::read::<f64>(path).map_err(|error| error.to_string())?;
    let mut clips = file.clips().to_vec();
    if clips.is_empty() {
        clips.push(rest_clip(file.skeleton()).map_err(|error| error.to_string())?);
    }
    let warnings =
        file.warnings().iter().map(|warning| Warning { clip: clip_of(warning.place()), text: warning.to_string() });
    Ok(Source {
        name: name_of(path),
        skeleton: file.skeleton().clone(),
        clips,
        joints: file.joints().to_vec(),
        tips: Vec::new(),
        warnings: warnings.collect(),
    })
}

/// The clip that something is about. There is one for each animation.
fn clip_of(place: &Place) -> Option<usize> {
    match place {
        Place::Animation(animation) | Place::Channel { animation, .. } => Some(animation.index),
        _ => None,
    }
}
