//! Whatever is done to a glTF file, it is read or refused: never a panic, and never a clip that kinematics chokes on.

use pga_motor::Motor;
use pga_motor::import::gltf;
use pga_motor::skeleton::{Interpolation, Wrap, local_to_model};
use proptest::prelude::*;
use proptest::sample::{Index, select};
use serde_json::{Value, json};

const VALID: &str = include_str!("../data/crane.gltf");

/// What may stand in place of anything in the JSON.
fn replacement() -> impl Strategy<Value = Value> {
    let numbers = select(vec![
        json!(0),
        json!(1),
        json!(2),
        json!(3),
        json!(-1),
        json!(7),
        json!(0.5),
        json!(1e38),
        json!(1e39),
        json!(-1e-45),
        json!(1e300),
        json!(4),
        json!(5120),
        json!(5122),
        json!(5125),
        json!(5126),
        json!(252),
        json!(1_000_000),
        json!(u32::MAX),
        json!(u64::from(u32::MAX) + 1),
        json!(u64::from(u32::MAX) + 5127),
        json!(u64::MAX),
        json!(u64::MAX - 40),
        json!(i64::MIN),
    ]);
    let others = select(vec![
        json!(null),
        json!(true),
        json!(""),
        json!([]),
        json!({}),
        json!([0]),
        json!([0, 1, 2, 3, 4, 5, 6]),
        json!("STEP"),
        json!("LINEAR"),
        json!("CUBICSPLINE"),
        json!("SCALAR"),
        json!("VEC3"),
        json!("VEC4"),
        json!("MAT4"),
        json!("translation"),
        json!("rotation"),
        json!("scale"),
        json!("weights"),
        json!("pointer"),
        json!("data:,"),
        json!("data:;base64,AAAA"),
        json!("../x"),
        json!({ "count": 9, "indices": { "bufferView": 0, "componentType": 5125 }, "values": { "bufferView": 1 } }),
    ]);
    prop_oneof![3 => numbers, 2 => others]
}

#[derive(Clone, Debug)]
enum Mutation {
    Replace(Index, Value),
    Remove(Index),
    /// Puts one part in place of another.
    Copy(Index, Index),
    /// Puts an item of a list, or a copy of it, at another place of the list.
    Repeat(Index, Index),
    /// Changes bytes of the buffer.
    Bytes(Index, Vec<u8>),
}

fn mutation() -> impl Strategy<Value = Mutation> {
    let index = any::<Index>;
    prop_oneof![
        5 => (index(), replacement()).prop_map(|(at, value)| Mutation::Replace(at, value)),
        1 => index().prop_map(Mutation::Remove),
        2 => (index(), index()).prop_map(|(from, to)| Mutation::Copy(from, to)),
        1 => (index(), index()).prop_map(|(at, to)| Mutation::Repeat(at, to)),
        2 => (index(), prop::collection::vec(any::<u8>(), 1..9)).prop_map(|(at, bytes)| Mutation::Bytes(at, bytes)),
    ]
}

/// All the places in a document, as pointers.
fn places(value: &Value, path: &str, found: &mut Vec<String>) {
    found.push(path.to_owned());
    match value {
        Value::Array(items) => {
            items.iter().enumerate().for_each(|(index, item)| places(item, &format!("{path}/{index}"), found));
        }
        Value::Object(members) => {
            members.iter().for_each(|(name, member)| places(member, &format!("{path}/{name}"), found))
        }
        _ => {}
    }
}

fn mutate(document: &mut Value, mutation: &Mutation) {
    let mut all = Vec::new();
    places(document, "", &mut all);
    let place = |index: &Index| index.get(&all).clone();
    match mutation {
        Mutation::Replace(at, value) => {
            // Not everything at once.
            if let Some(part) = document.pointer_mut(&place(at)).filter(|part| !part.is_object()) {
                *part = value.clone();
            }
        }
        Mutation::Remove(at) => {
            let path = place(at);
            let Some((parent, name)) = path.rsplit_once('/') else { return };
            match document.pointer_mut(parent) {
                Some(Value::Object(members)) => drop(members.remove(name)),
                Some(Value::Array(items)) => drop(items.remove(name.parse().expect("an index"))),
                _ => {}
            }
        }
        Mutation::Copy(from, to) => {
            let part = document.pointer(&place(from)).cloned().unwrap_or_default();
            if let Some(other) = document.pointer_mut(&place(to)) {
                *other = part;
            }
        }
        Mutation::Repeat(at, to) => {
            if let Some(Value::Array(items)) = document.pointer_mut(&place(at)).filter(|part| part.is_array()) {
                let item = items.first().cloned().unwrap_or_default();
                items.insert(to.index(items.len() + 1), item);
            }
        }
        Mutation::Bytes(at, bytes) => {
            let Some(Value::String(uri)) = document.pointer_mut("/buffers/0/uri") else { return };
            let Some(start) = uri.find(',') else { return };
            let digits = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
            let text: String = bytes.iter().map(|&byte| char::from(digits[usize::from(byte) % 64])).collect();
            let from = start + 1 + at.index(uri.len() - start);
            if uri.is_char_boundary(from) && uri.is_char_boundary(uri.len().min(from + text.len())) {
                uri.replace_range(from..uri.len().min(from + text.len()), &text);
            }
        }
    }
}

/// Reads a file; where that succeeds, every clip must pose the skeleton.
fn read(bytes: &[u8]) -> Result<(), TestCaseError> {
    let file = match gltf::parse::<f32>(bytes) {
        Ok(file) => file,
        Err(error) => {
            prop_assert!(error.to_string().len() < 1000, "{error}");
            return Ok(());
        }
    };
    let mut pose = file.skeleton().rest_pose().clone();
    let mut model = vec![Motor::IDENTITY; pose.len()];
    for clip in file.clips() {
        for time in [clip.start(), (clip.start() + clip.end()) / 2.0, clip.end()] {
            prop_assert!(clip.sample_into(time, Interpolation::Split, Wrap::Clamp, &mut pose).is_ok());
            prop_assert!(local_to_model(file.skeleton(), &pose, &mut model).is_ok());
        }
    }
    prop_assert!(file.skins().iter().flat_map(|skin| &skin.joints).all(|&joint| joint < pose.len()));
    prop_assert!(file.warnings().iter().all(|warning| warning.to_string().len() < 1000));
    Ok(())
}

/// The file as a container with its buffer in the binary chunk.
fn container(json: &[u8], blob: &[u8]) -> Vec<u8> {
    let chunk = |kind: &[u8], body: &[u8], filler: u8| {
        let mut body = body.to_vec();
        body.resize(body.len().next_multiple_of(4), filler);
        [&u32::try_from(body.len()).expect("a short chunk").to_le_bytes(), kind, &body].concat()
    };
    let chunks = [chunk(b"JSON", json, b' '), chunk(b"BIN\0", blob, 0)].concat();
    let length = u32::try_from(12 + chunks.len()).expect("a short file");
    [b"glTF", &2u32.to_le_bytes()[..], &length.to_le_bytes(), &chunks].concat()
}

fn valid_container() -> Vec<u8> {
    let mut document: Value = serde_json::from_str(VALID).expect("the file is JSON");
    let uri = document["buffers"][0]["uri"].take();
    document["buffers"][0].as_object_mut().expect("a buffer is an object").remove("uri");
    let text = uri.as_str().and_then(|uri| uri.split_once(',')).expect("a data address").1.to_owned();
    container(document.to_string().as_bytes(), &super::matrices::base64(&text))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 3000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn mutated_documents_are_read_or_refused(mutations in prop::collection::vec(mutation(), 1..4)) {
        let mut document: Value = serde_json::from_str(VALID).expect("the file is JSON");
        mutations.iter().for_each(|mutation| mutate(&mut document, mutation));
        read(document.to_string().as_bytes())?;
    }

    #[test]
    fn mutated_bytes_are_read_or_refused(changes in prop::collection::vec((any::<Index>(), any::<u8>()), 1..6)) {
        let mut bytes = valid_container();
        for (at, byte) in changes {
            let at = at.index(bytes.len());
            bytes[at] = byte;
        }
        read(&bytes)?;
    }

    #[test]
    fn headers_of_containers_are_read_or_refused(
        at in 0..24_usize,
        word in select(vec![0, 1, 2, 3, 8, 11, 12, 19, 20, 0x4E4F_534A, 0x004E_4942, 0x7FFF_FFFF, 0x8000_0000, u32::MAX]),
        end in any::<Index>(),
    ) {
        let mut bytes = valid_container();
        bytes[at..at + 4].copy_from_slice(&word.to_le_bytes());
        read(&bytes)?;
        read(&bytes[..end.index(bytes.len())])?;
    }

    #[test]
    fn truncated_files_are_read_or_refused(end in any::<Index>()) {
        let bytes = valid_container();
        let end = end.index(bytes.len());
        prop_assert!(gltf::parse::<f64>(&bytes[..end]).is_err());
        read(&VALID.as_bytes()[..end.min(VALID.len())])?;
    }
}

#[test]
fn the_files_to_mutate_are_valid() {
    assert!(gltf::parse::<f64>(VALID.as_bytes()).is_ok());
    assert_eq!(gltf::parse::<f64>(&valid_container()), gltf::parse::<f64>(VALID.as_bytes()));
}
