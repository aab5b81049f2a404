//! Motion capture.

use std::path::Path;
use std::{fs, str};

use pga_motor::import::bvh::{self, Bvh};

use super::{Source, name_of, rest_clip};

/// Reads a BVH file. Its one clip is called like the file. The error names the line.
pub(super) fn read(path: &Path) -> Result<Source, String> {
    let bytes = fs::read(path).map_err(|error| format!("cannot be read: {error}"))?;
    let text = str::from_utf8(&bytes).map_err(|error| {
        let before = &bytes[..error.valid_up_to()];
        let line = 1 + before.iter().filter(|&&byte| byte == b'\n').count();
        format!("line {line}: expected text in UTF-8, found byte {:#04x}", bytes[before.len()])
    })?;
    let file: Bvh<f64> = bvh::parse(text).map_err(|error| error.to_string())?;
    let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let clip = match file.frame_count() {
        0 => rest_clip(file.skeleton()),
        _ => file.clip().map(|clip| clip.with_name(stem)),
    };
    Ok(Source {
        name: name_of(path),
        skeleton: file.skeleton().clone(),
        clips: vec![clip.map_err(|error| error.to_string())?],
        joints: (0..file.skeleton().len()).collect(),
        tips: file.tips().to_vec(),
        warnings: Vec::new(),
    })
}
