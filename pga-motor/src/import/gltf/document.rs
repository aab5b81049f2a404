//! The container, and the JSON in it.

use alloc::string::{String, ToString};
use alloc::vec::Vec;

use ::gltf::json::{Root, Value, deserialize};

use super::error::GltfReason;
use super::place::quote;

/// A file taken apart: its JSON, and the binary chunk where it has one.
pub(super) struct Document<'a> {
    pub(super) root: Root,
    pub(super) blob: Option<&'a [u8]>,
}

/// What is of no concern here, and may be as it likes: none of it is read into types, which would refuse what they do not know.
const UNREAD: [&str; 8] = ["cameras", "images", "materials", "meshes", "samplers", "scene", "scenes", "textures"];

/// What programs add to anything in the file, of any form.
const ADDED: [&str; 2] = ["extensions", "extras"];

/// The members that hold indices, or lists of them, and the constants of formats.
const INDICES: [&str; 12] = [
    "buffer",
    "bufferView",
    "children",
    "componentType",
    "input",
    "inverseBindMatrices",
    "joints",
    "node",
    "nodes",
    "output",
    "sampler",
    "skeleton",
];

/// Extensions that keep what is in buffers in another form, so that accessors read without them would be garbage.
const ENCODED: [&str; 2] = ["EXT_meshopt_compression", "KHR_meshopt_compression"];

impl<'a> Document<'a> {
    /// Takes a `.glb` or the text of a `.gltf` apart.
    pub(super) fn parse(bytes: &'a [u8]) -> Result<Self, GltfReason> {
        let (json, blob) = if bytes.starts_with(b"glTF") { split_chunks(bytes)? } else { (bytes, None) };
        let json = json.strip_prefix(b"\xef\xbb\xbf").unwrap_or(json);
        // Some programs pad the chunk so, instead of with spaces.
        let end = json.iter().rposition(|&byte| byte != 0).map_or(0, |last| last + 1);
        let json = &json[..end];
        let fault = |error: ::gltf::json::Error| GltfReason::Json { message: quote_message(&error.to_string()) };
        let mut value: Value = deserialize::from_slice(json).map_err(fault)?;
        check_version(&value)?;
        prune(&mut value);
        check_indices(&value, false)?;
        let root: Root = deserialize::from_value(value).map_err(fault)?;
        match root.extensions_required.iter().find(|name| ENCODED.contains(&name.as_str())) {
            Some(name) => Err(GltfReason::Extension { name: name.clone() }),
            None => Ok(Self { root, blob }),
        }
    }
}

/// The JSON chunk and the binary one. Chunks of other kinds are passed over, as the format wants.
fn split_chunks(bytes: &[u8]) -> Result<(&[u8], Option<&[u8]>), GltfReason> {
    let truncated = |what: &str, expected: usize, found: usize| GltfReason::Truncated {
        what: what.to_string(),
        expected: expected as u128,
        found: found as u128,
    };
    let word = |at: usize| {
        let word = bytes.get(at..).and_then(|rest| rest.first_chunk()).copied().map(u32::from_le_bytes);
        word.ok_or_else(|| truncated("the header of the file or of a chunk", at + 4, bytes.len()))
    };
    let version = word(4)?;
    if version != 2 {
        return Err(GltfReason::Version { found: version.to_string() });
    }
    let end = word(8)? as usize;
    let mut rest = bytes.get(..end).ok_or_else(|| truncated("the file, by its header", end, bytes.len()))?;
    rest = rest.get(12..).unwrap_or_default();
    let (mut json, mut blob) = (None, None);
    while !rest.is_empty() {
        let at = end - rest.len();
        let (length, kind) = (word(at)? as usize, word(at + 4)?.to_le_bytes());
        let body = rest.get(8..).unwrap_or_default();
        let chunk = body.get(..length).ok_or_else(|| truncated("a chunk", length, body.len()))?;
        match &kind {
            b"JSON" if json.is_none() => json = Some(chunk),
            b"BIN\0" if blob.is_none() => blob = Some(chunk),
            _ => {}
        }
        // Chunks are padded to four bytes; where the last one is not, nothing follows.
        rest = body.get(length.next_multiple_of(4)..).unwrap_or_default();
    }
    let missing = || GltfReason::Container { expected: "a chunk of JSON", found: "none".to_string() };
    Ok((json.ok_or_else(missing)?, blob))
}

/// The reader of the JSON quotes what it found, however long that is.
fn quote_message(message: &str) -> String {
    const LONGEST: usize = 200;
    message
        .char_indices()
        .nth(LONGEST)
        .map_or_else(|| message.to_string(), |(end, _)| message[..end].to_string() + "...")
}

fn check_version(value: &Value) -> Result<(), GltfReason> {
    match value.get("asset").and_then(|asset| asset.get("version")).and_then(Value::as_str) {
        // What is missing, the types report.
        None => Ok(()),
        Some(version) if version == "2" || version.starts_with("2.") => Ok(()),
        Some(version) => Err(GltfReason::Version { found: quote(version) }),
    }
}

/// Removes what is not read, and gives channels without a node one, with a path that is none: the types insist on a node, but
/// extensions do without.
fn prune(value: &mut Value) {
    strip(value);
    let Value::Object(members) = value else { return };
    UNREAD.iter().for_each(|&name| drop(members.remove(name)));
    let animations = members.get_mut("animations").and_then(Value::as_array_mut).into_iter().flatten();
    let channels = animations.filter_map(|animation| animation.get_mut("channels")?.as_array_mut()).flatten();
    for target in channels.filter_map(|channel| channel.get_mut("target")?.as_object_mut()) {
        if !target.contains_key("node") {
            target.insert("node".to_string(), Value::from(0));
            target.insert("path".to_string(), Value::from(""));
        }
    }
}

/// Removes what programs have added, at all levels. The reader of the JSON bounds how deep it nests.
fn strip(value: &mut Value) {
    match value {
        Value::Array(items) => items.iter_mut().for_each(strip),
        Value::Object(members) => {
            ADDED.iter().for_each(|&name| drop(members.remove(name)));
            members.values_mut().for_each(strip);
        }
        _ => {}
    }
}

/// Refuses indices beyond 32 bits, of which the types would keep the lower ones. The reader of the JSON bounds how deep it nests.
fn check_indices(value: &Value, is_index: bool) -> Result<(), GltfReason> {
    match value {
        Value::Number(number) if is_index => match number.as_u64() {
            Some(index) if u32::try_from(index).is_err() => {
                Err(GltfReason::Json { message: alloc::format!("the index {index}") })
            }
            _ => Ok(()),
        },
        Value::Array(items) => items.iter().try_for_each(|item| check_indices(item, is_index)),
        Value::Object(members) => {
            members.iter().try_for_each(|(name, member)| check_indices(member, INDICES.contains(&name.as_str())))
        }
        _ => Ok(()),
    }
}

/// How many elements a list of the file has, for an index into it.
pub(super) fn check_index(what: &'static str, found: usize, count: usize) -> Result<usize, GltfReason> {
    if found < count { Ok(found) } else { Err(GltfReason::OutOfRange { what, found, count }) }
}

/// A list of indices as plain numbers.
pub(super) fn values<T>(indices: &[::gltf::json::Index<T>]) -> Vec<usize> {
    indices.iter().map(::gltf::json::Index::value).collect()
}
