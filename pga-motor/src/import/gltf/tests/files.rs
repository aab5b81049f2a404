//! Containers, buffers and addresses.

use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use std::fs;
use std::path::PathBuf;

use super::builder::{Builder, about_z, assert_near, at, error};
use crate::import::gltf::{parse, parse_with, read};

fn leg() -> Builder {
    Builder::default()
        .node(r#""name": "hip", "children": [1], "translation": [0, 9, 0]"#)
        .node(r#""name": "knee", "translation": [0, -4, 0]"#)
        .channel((0, "rotation"), "LINEAR", &[0.0, 1.0], &[about_z(0.0), about_z(90.0)])
}

fn chunk(kind: &[u8], body: &[u8], filler: u8) -> Vec<u8> {
    let mut body = body.to_vec();
    body.resize(body.len().next_multiple_of(4), filler);
    [&(body.len() as u32).to_le_bytes(), kind, &body].concat()
}

fn container(version: u32, chunks: &[Vec<u8>]) -> Vec<u8> {
    let chunks = chunks.concat();
    [b"glTF", &version.to_le_bytes()[..], &(12 + chunks.len() as u32).to_le_bytes(), &chunks].concat()
}

#[track_caller]
fn error_of(bytes: &[u8]) -> String {
    parse::<f64>(bytes).expect_err("a broken file must not be read").to_string()
}

#[test]
fn containers_hold_the_same_as_text() {
    let builder = leg();
    let text = builder.text_with("");
    let (json, blob) = (chunk(b"JSON", text.as_bytes(), b' '), chunk(b"BIN\0", builder.bytes(), 0));
    let expected = builder.read();
    for chunks in [
        [json.clone(), blob.clone()].to_vec(),
        [json.clone(), chunk(b"MORE", b"what is not known is passed over", 0), blob.clone()].to_vec(),
        [json.clone(), blob.clone(), chunk(b"MORE", b"", 0)].to_vec(),
    ] {
        let mut bytes = container(2, &chunks);
        assert_eq!(parse::<f64>(&bytes).as_ref(), Ok(&expected));
        // What stands after the end that the header gives is no part of the file.
        bytes.extend_from_slice(b"more");
        assert_eq!(parse::<f64>(&bytes).as_ref(), Ok(&expected));
    }
    let text = format!("\u{feff}{}", builder.text());
    assert_eq!(parse::<f64>(text.as_bytes()), Ok(expected));
}

#[test]
fn damaged_containers_are_refused() {
    let builder = leg();
    let chunks = [chunk(b"JSON", builder.text_with("").as_bytes(), b' '), chunk(b"BIN\0", builder.bytes(), 0)];
    let whole = container(2, &chunks);
    assert_eq!(error_of(&container(1, &chunks)), "file: expected glTF of version 2, found version `1`");
    assert_eq!(error_of(b"glTF"), "file: expected 8 bytes for the header of the file or of a chunk, found 4");
    let cut = format!("file: expected {} bytes for the file, by its header, found {}", whole.len(), whole.len() - 1);
    assert_eq!(error_of(&whole[..whole.len() - 1]), cut);
    assert_eq!(error_of(&container(2, &chunks[1..])), "file: expected a chunk of JSON, found none");
    assert_eq!(error_of(&container(2, &[])), "file: expected a chunk of JSON, found none");
    // A header that says the file is shorter than itself.
    let short = [b"glTF", &2u32.to_le_bytes()[..], &3u32.to_le_bytes()].concat();
    assert_eq!(error_of(&short), "file: expected a chunk of JSON, found none");
    let mut long = whole.clone();
    long[12..16].copy_from_slice(&u32::MAX.to_le_bytes());
    let rest = whole.len() - 20;
    assert_eq!(error_of(&long), format!("file: expected 4294967295 bytes for a chunk, found {rest}"));
    let missing = "animation 0 `kick`, channel 0 (rotation of node 0 `hip`): expected 40 bytes for buffer 0, found 0";
    assert_eq!(error_of(&container(2, &chunks[..1])), missing);
}

#[test]
fn damaged_json_is_refused() {
    let expected = "file: expected the JSON of glTF, found: expected value at line 1 column 1";
    assert_eq!(error("solid teapot"), expected);
    let expected = "file: expected the JSON of glTF, found: EOF while parsing a value at line 1 column 0";
    assert_eq!(error(""), expected);
    assert_eq!(error("{}"), "file: expected the JSON of glTF, found: missing field `asset`");
    let version = r#"{ "asset": { "version": "1.0" }, "nodes": { "old": {} } }"#;
    assert_eq!(error(version), "file: expected glTF of version 2, found version `1.0`");
    let deep = format!("{}{}", "[".repeat(100_000), "]".repeat(100_000));
    let expected = "file: expected the JSON of glTF, found: recursion limit exceeded at line 1 column 128";
    assert_eq!(error(&deep), expected);
    // The types keep 32 bits of an index.
    let index = leg().text().replace(r#""children": [1]"#, r#""children": [4294967297]"#);
    assert_eq!(error(&index), "file: expected the JSON of glTF, found: the index 4294967297");
}

#[test]
fn what_is_not_read_may_be_broken_and_extensions_may_be_required() {
    let text = leg().text().replace(
        r#""nodes""#,
        r#""meshes": 7, "materials": [{ "pbr": "?" }], "images": [{ "uri": "../../secret.png" }], "cameras": [{}],
           "extensions": { "KHR_xmp": 3 }, "extensionsRequired": ["KHR_draco_mesh_compression"], "scene": 99, "nodes""#,
    );
    assert_eq!(parse::<f64>(text.as_bytes()), Ok(leg().read()));
    // What programs add may have any form and hold any numbers, and a second scene may be empty.
    let added = leg().text().replace(
        r#""nodes""#,
        r#""extras": ["x", { "buffer": 1700000000000 }], "scenes": [{ "nodes": [0] }, { "name": "empty" }], "nodes""#,
    );
    let added = added.replacen(
        r#""name""#,
        r#""extras": null, "extensions": { "EXT_x": { "node": 1099511627776 } }, "name""#,
        1,
    );
    assert_eq!(parse::<f64>(added.as_bytes()), Ok(leg().read()));
    let encoded = text.replace("KHR_draco_mesh_compression", "EXT_meshopt_compression");
    let expected =
        "file: expected buffers as they are, found them in the form of the extension `EXT_meshopt_compression`";
    assert_eq!(error(&encoded), expected);
}

#[test]
fn buffers_may_be_files_beside_the_file() {
    let folder = Folder::new();
    let builder = leg();
    fs::create_dir(folder.0.join("data")).unwrap();
    fs::write(folder.0.join("data/a leg.bin"), builder.bytes()).unwrap();
    fs::write(folder.0.join("leg.gltf"), builder.text_with(r#", "uri": "data/a%20leg.bin""#)).unwrap();
    let file = read::<f64>(folder.0.join("leg.gltf")).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(file, builder.read());
    assert_near(at(&file, 1.0)[1], [4.0, 9.0, 0.0]);

    let channel = "animation 0 `kick`, channel 0 (rotation of node 0 `hip`)";
    for uri in ["../leg.bin", "%2e%2e/leg.bin", "/etc/hosts", "file:///etc/hosts", "https://example.org/leg.bin"] {
        fs::write(folder.0.join("leg.gltf"), builder.text_with(&format!(r#", "uri": "{uri}""#))).unwrap();
        let error = read::<f64>(folder.0.join("leg.gltf")).unwrap_err().to_string();
        let expected = "expected the path of a file beside the glTF file or below its folder";
        assert_eq!(error, format!("{channel}: {expected}, found `{uri}`"));
    }
    fs::write(folder.0.join("leg.gltf"), builder.text_with(r#", "uri": "missing.bin""#)).unwrap();
    let error = read::<f64>(folder.0.join("leg.gltf")).unwrap_err().to_string();
    assert!(error.starts_with(&format!("{channel}: expected a buffer at `missing.bin`, found: ")), "{error}");
    let error = read::<f64>(folder.0.join("missing.gltf")).unwrap_err().to_string();
    assert!(error.starts_with("file: expected to read ") && error.contains("missing.gltf, found: "), "{error}");
}

#[test]
fn buffers_may_come_from_anywhere() {
    let builder = leg();
    let text = builder.text_with(r#", "uri": "db://leg""#);
    let mut asked = Vec::new();
    let file = parse_with::<f64, String>(text.as_bytes(), |uri| {
        asked.push(uri.to_string());
        Ok(builder.bytes().to_vec())
    });
    assert_eq!(file, Ok(builder.read()));
    // Once, for all the accessors in it.
    assert_eq!(asked, ["db://leg"]);
    let channel = "animation 0 `kick`, channel 0 (rotation of node 0 `hip`)";
    let error = parse_with::<f64, _>(text.as_bytes(), |_| Err("it is gone")).unwrap_err().to_string();
    assert_eq!(error, format!("{channel}: expected a buffer at `db://leg`, found: it is gone"));
    let expected = format!("{channel}: expected a buffer within the file or a data address, found `db://leg`");
    assert_eq!(error_of(text.as_bytes()), expected);
}

#[test]
fn values_may_lie_apart() {
    // Times 0 and 1 with the rotations after each.
    let mut bytes = Vec::new();
    for (time, rotation) in [(0.0_f32, about_z(0.0)), (1.0, about_z(90.0))] {
        [time].iter().chain(&rotation).for_each(|number| bytes.extend_from_slice(&number.to_le_bytes()));
    }
    let text = leg().text_with(r#", "uri": "leg.bin""#);
    let start = text.find(r#""accessors""#).unwrap();
    let text = format!(
        r#"{}"accessors": [
            {{ "bufferView": 0, "byteOffset": 4, "componentType": 5126, "count": 2, "type": "VEC4" }},
            {{ "bufferView": 0, "componentType": 5126, "count": 2, "type": "SCALAR" }} ],
        "bufferViews": [ {{ "buffer": 0, "byteLength": 40, "byteStride": 20 }} ],
        "buffers": [ {{ "byteLength": 40, "uri": "leg.bin" }} ] }}"#,
        &text[..start]
    );
    let load = |_: &str| Ok::<_, String>(bytes.clone());
    assert_eq!(parse_with::<f64, _>(text.as_bytes(), load), Ok(leg().read()));
    let narrow = text.replace(r#""byteStride": 20"#, r#""byteStride": 2"#);
    let error = parse_with::<f64, _>(narrow.as_bytes(), load).unwrap_err().to_string();
    let expected = "expected a stride of at least 4 bytes in accessor 1, found 2";
    assert_eq!(error, format!("animation 0 `kick`, channel 0 (rotation of node 0 `hip`): {expected}"));
}

/// A folder for one test, removed with all that is in it.
struct Folder(PathBuf);

impl Folder {
    fn new() -> Self {
        let folder = std::env::temp_dir().join(format!("pga-motor-gltf-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        Self(folder)
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}
