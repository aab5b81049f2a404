//! Files that are refused, and the words for it.

use alloc::format;
use alloc::string::String;

use super::builder::{Builder, about_z, error};
use crate::import::gltf::{GltfReason, MAX_JOINT_KEYS, Place, parse};

const IDENTITY: [f32; 16] = [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0];

fn nodes(hip: &str, knee: &str) -> Builder {
    Builder::default()
        .node(&format!(r#""name": "hip", "children": [1]{hip}"#))
        .node(&format!(r#""name": "knee", "translation": [0, -4, 0]{knee}"#))
}

fn leg() -> Builder {
    nodes("", "").bound_skin("[0, 1]", &[IDENTITY, IDENTITY]).channel(
        (0, "rotation"),
        "LINEAR",
        &[0.0, 1.0],
        &[about_z(0.0), about_z(90.0)],
    )
}

/// The error that `leg` gives after one replacement in its text.
#[track_caller]
fn error_of(old: &str, new: &str) -> String {
    let text = leg().text();
    assert_eq!(text.matches(old).count(), 1, "`{old}` must stand once in the text");
    error(&text.replace(old, new))
}

/// What the error says of the channel that there is.
#[track_caller]
fn of_channel(error: &str) -> &str {
    error
        .strip_prefix("animation 0 `kick`, channel 0 (rotation of node 0 `hip`): ")
        .unwrap_or_else(|| panic!("{error}"))
}

#[test]
fn transforms_that_are_no_motion_are_named() {
    let of_knee = |members: &str| nodes("", members).error();
    let scale = |scale: &str| of_knee(&format!(r#", "scale": {scale}"#));
    let uneven = "node 1 `knee`: expected the same scale along all axes, found 1 1.001 1";
    assert_eq!(scale("[1, 1.001, 1]"), uneven);
    assert_eq!(scale("[2, -2, 2]"), "node 1 `knee`: expected a positive scale, found a mirror");
    assert_eq!(scale("[0, 0, 0]"), "node 1 `knee`: expected a positive scale, found zero");
    assert_eq!(scale("[1e39, 1, 1]"), "node 1 `knee`: expected a finite scale, found a NaN or an infinity");
    assert!(nodes("", r#", "scale": [1, 1.00009, 1]"#).read().warnings().is_empty());
    let matrix = |columns: &str| of_knee(&format!(r#", "matrix": [{columns}]"#));
    let mirror = matrix("1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1");
    assert_eq!(mirror, "node 1 `knee`: expected a positive scale, found a mirror");
    let sheared = matrix("1, 0, 0, 0, 0.6, 0.8, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1");
    assert_eq!(sheared, "node 1 `knee`: expected perpendicular axes, found two with a cosine of 0.6");
    let uneven = matrix("1, 0, 0, 0, 0, 2, 0, 0, 0, 0, 3, 0, 0, 0, 0, 1");
    assert_eq!(uneven, "node 1 `knee`: expected the same scale along all axes, found 1 2 3");
    let flat = matrix("1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1");
    assert_eq!(flat, "node 1 `knee`: expected a positive scale, found zero");
    let projective = matrix("1, 0, 0, 0, 0, 1, 0, 0.5, 0, 0, 1, 0, 0, 0, 0, 1");
    assert_eq!(projective, "node 1 `knee`: expected a matrix with the last row 0 0 0 1, found another");
    let infinite = matrix("1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1e39, 0, 0, 1");
    assert_eq!(infinite, "node 1 `knee`: expected a finite entry of the matrix, found a NaN or an infinity");
    let zero = of_knee(r#", "rotation": [0, 0, 0, 0]"#);
    assert_eq!(zero, "node 1 `knee`: expected a unit quaternion, found one of length zero");
    let infinite = of_knee(r#", "rotation": [0, 0, 1e39, 0]"#);
    assert_eq!(infinite, "node 1 `knee`: expected a finite rotation, found a NaN or an infinity");
    let infinite = nodes(r#", "translation": [0, -1e39, 0]"#, "").error();
    assert_eq!(infinite, "node 0 `hip`: expected a finite translation, found a NaN or an infinity");
}

#[test]
fn what_does_not_fit_into_the_type_is_named() {
    let text =
        nodes(r#", "scale": [1e30, 1e30, 1e30]"#, r#", "scale": [1e30, 1e30, 1e30], "translation": [1e30, 0, 0]"#)
            .text();
    assert!(parse::<f64>(text.as_bytes()).is_ok());
    let error = parse::<f32>(text.as_bytes()).unwrap_err();
    let expected = "expected a finite place in space, and in the type read into, found a NaN or an infinity";
    assert_eq!(alloc::string::ToString::to_string(&error), format!("node 1 `knee`: {expected}"));
}

#[test]
fn hierarchies_that_are_no_trees_are_named() {
    let knee = r#""name": "knee""#;
    assert_eq!(
        error_of(knee, r#""children": [0], "name": "knee""#),
        "node 0 `hip`: expected a chain of parents that ends at a root, found a cycle"
    );
    let twice = error_of(r#""children": [1]"#, r#""children": [1, 1]"#);
    assert_eq!(twice, "node 1 `knee`: expected at most one parent, found it among the children of node 0 and node 0");
    let outside = error_of(r#""children": [1]"#, r#""children": [1, 2]"#);
    assert_eq!(outside, "node 0 `hip`: expected a child below 2, the number of them, found 2");
    let two = nodes("", "").node(r#""children": [1]"#).error();
    assert_eq!(two, "node 1 `knee`: expected at most one parent, found it among the children of node 0 and node 2");
    let itself = Builder::default().node("").node(r#""children": [1]"#).error();
    assert_eq!(itself, "node 1 `node_1`: expected a chain of parents that ends at a root, found a cycle");
    assert_eq!(Builder::default().error(), "file: expected at least one joint, found none");
}

#[test]
fn broken_skins_are_named() {
    let joints = r#""joints": [0, 1]"#;
    let outside = error_of(joints, r#""joints": [0, 5]"#);
    assert_eq!(outside, "skin 0 `leg`: expected a joint's node below 2, the number of them, found 5");
    assert_eq!(error_of(joints, r#""joints": []"#), "skin 0 `leg`: expected at least one joint, found none");
    let few = error_of(joints, r#""joints": [0, 1, 0]"#);
    assert_eq!(few, "skin 0 `leg`: expected 3 values, found 2");
    let matrices = |change: fn(&mut [f32; 16])| {
        let mut matrix = IDENTITY;
        change(&mut matrix);
        let error = nodes("", "").bound_skin("[0, 1]", &[IDENTITY, matrix]).error();
        let place = "skin 0 `leg`, inverse bind matrix 1 (of node 1 `knee`): ";
        String::from(error.strip_prefix(place).unwrap_or_else(|| panic!("{error}")))
    };
    let infinite = matrices(|matrix| matrix[12] = f32::NAN);
    assert_eq!(infinite, "expected a finite entry, found a NaN or an infinity");
    assert_eq!(matrices(|matrix| matrix[0] = 0.5), "expected the same scale along all axes, found 0.5 1 1");
    assert_eq!(matrices(|matrix| matrix[0] = -1.0), "expected a positive scale, found a mirror");
    assert_eq!(matrices(|matrix| matrix[..12].fill(0.0)), "expected a positive scale, found zero");
    let other = matrices(|matrix| [0, 5, 10].iter().for_each(|&i| matrix[i] = 2.0));
    assert_eq!(other, "expected the mesh to be scaled by 1, as at the skin's first joint, found 2");
    let scaled = nodes("", r#", "scale": [3, 3, 3]"#).skin("[0, 1]").error();
    let expected = "expected the mesh to be scaled by 1, as at the skin's first joint, found 3";
    assert_eq!(scaled, format!("skin 0 `leg`, inverse bind matrix 1 (of node 1 `knee`): {expected}"));
}

#[test]
fn broken_accessors_are_named() {
    // The rotations are accessor 1, their times accessor 2.
    let view = r#""bufferView": 1, "componentType": 5126, "count": 2, "type": "VEC4""#;
    let of = |new: &str| String::from(of_channel(&error_of(view, new)));
    let missing = of(r#""bufferView": 9, "componentType": 5126, "count": 2, "type": "VEC4""#);
    assert_eq!(missing, "expected a buffer view below 3, the number of them, found 9");
    let long = of(r#""bufferView": 1, "componentType": 5126, "count": 18446744073709551615, "type": "VEC4""#);
    assert_eq!(long, "expected 295147905179352825840 bytes for accessor 1, found 32");
    let late = of(r#""bufferView": 1, "byteOffset": 4, "componentType": 5126, "count": 2, "type": "VEC4""#);
    assert_eq!(late, "expected 32 bytes for accessor 1, found 28");
    let far =
        of(r#""bufferView": 1, "byteOffset": 18446744073709551615, "componentType": 5126, "count": 2, "type": "VEC4""#);
    assert_eq!(far, "expected 32 bytes for accessor 1, found 0");
    let shape = of(r#""bufferView": 1, "componentType": 5126, "count": 2, "type": "VEC3""#);
    let expected = "expected VEC4 of float or normalized integers of 8 or 16 bits in accessor 1, found";
    assert_eq!(shape, format!("{expected} VEC3 of float"));
    let plain = of(r#""bufferView": 1, "componentType": 5122, "count": 2, "type": "VEC4""#);
    assert_eq!(plain, format!("{expected} VEC4 of short"));
    let wide = of(r#""bufferView": 1, "componentType": 5125, "normalized": true, "count": 2, "type": "VEC4""#);
    assert_eq!(wide, format!("{expected} VEC4 of normalized unsigned int"));
    let unknown = of(r#""bufferView": 1, "componentType": 7, "count": 2, "type": "QUATERNION""#);
    assert_eq!(unknown, format!("{expected} an unknown shape of an unknown kind"));
    let times = r#""componentType": 5126, "count": 2, "type": "SCALAR""#;
    let normalized = error_of(times, r#""componentType": 5121, "normalized": true, "count": 2, "type": "SCALAR""#);
    let expected = "expected SCALAR of float in accessor 2, found SCALAR of normalized unsigned byte";
    assert_eq!(of_channel(&normalized), expected);
}

#[test]
fn broken_buffers_are_named() {
    // 128 bytes of matrices, 32 of rotations, 8 of times.
    let view = r#""byteOffset": 128, "byteLength": 32"#;
    let late = error_of(view, r#""byteOffset": 137, "byteLength": 32"#);
    assert_eq!(of_channel(&late), "expected 169 bytes for buffer view 1, found 168");
    let far = error_of(view, r#""byteOffset": 18446744073709551615, "byteLength": 18446744073709551615"#);
    assert_eq!(of_channel(&far), "expected 36893488147419103230 bytes for buffer view 1, found 168");
    let missing = error_of(r#""buffer": 0, "byteOffset": 128"#, r#""buffer": 1, "byteOffset": 128"#);
    assert_eq!(of_channel(&missing), "expected a buffer below 1, the number of them, found 1");
    let truncated = error_of(r#""byteLength": 168"#, r#""byteLength": 169"#);
    assert_eq!(truncated, "skin 0 `leg`: expected 169 bytes for buffer 0, found 168");
    let short = leg().text_with(r#", "uri": "data:application/octet-stream;base64,AAAA""#);
    assert_eq!(error(&short), "skin 0 `leg`: expected 168 bytes for buffer 0, found 3");
    let bad = leg().text_with(r#", "uri": "data:application/octet-stream;base64,A*AA""#);
    let expected = "skin 0 `leg`: expected data of base 64, found `data:application/octet-stream;base64,A*A...`";
    assert_eq!(error(&bad), expected);
    let bare = error(&leg().text_with(r#", "uri": "data:base64""#));
    assert_eq!(bare, "skin 0 `leg`: expected a comma before the data of a data address, found `data:base64`");
}

#[test]
fn broken_channels_are_named() {
    let node = error_of(r#""node": 0"#, r#""node": 7"#);
    assert_eq!(node, "animation 0 `kick`, channel 0: expected a node below 2, the number of them, found 7");
    let sampler = error_of(r#""sampler": 0"#, r#""sampler": 3"#);
    assert_eq!(of_channel(&sampler), "expected a sampler below 1, the number of them, found 3");
    let input = error_of(r#""input": 2"#, r#""input": 3"#);
    assert_eq!(of_channel(&input), "expected an accessor below 3, the number of them, found 3");
    let crazy = error_of("LINEAR", "BEZIER");
    assert_eq!(of_channel(&crazy), "expected an interpolation of LINEAR, STEP and CUBICSPLINE, found another");
    let cubic = error_of("LINEAR", "CUBICSPLINE");
    assert_eq!(of_channel(&cubic), "expected 6 values, found 2");

    let turn = |times: &[f32], values: &[[f32; 4]]| {
        let error = nodes("", "").channel((0, "rotation"), "LINEAR", times, values).error();
        String::from(of_channel(&error))
    };
    let quarter = about_z(90.0);
    assert_eq!(turn(&[], &[]), "expected at least one key, found none");
    assert_eq!(turn(&[0.0, 1.0], &[quarter]), "expected 2 values, found 1");
    let same = turn(&[0.0, 1.0, 1.0], &[quarter; 3]);
    assert_eq!(same, "key 2: expected a time after that of key 1, found one that is not");
    let never = turn(&[0.0, f32::NAN], &[quarter; 2]);
    assert_eq!(never, "expected a finite time of key 1, found a NaN or an infinity");
    let infinite = turn(&[0.0, 1.0], &[quarter, [f32::INFINITY, 0.0, 0.0, 1.0]]);
    assert_eq!(infinite, "expected a finite value of key 1, found a NaN or an infinity");
    assert_eq!(turn(&[0.0, 1.0], &[quarter, [0.0; 4]]), "key 1: expected a unit quaternion, found one of length zero");

    let twice = leg().channel((0, "rotation"), "STEP", &[0.0], &[quarter]).error();
    let expected = "expected one channel for a property of a node, found a second after channel 0";
    assert_eq!(twice, format!("animation 0 `kick`, channel 1 (rotation of node 0 `hip`): {expected}"));
}

/// Each is within 1e-4 of the node's own; together, or on a long lever, they are not within 1e-4 of the skeleton's size.
#[test]
fn scales_that_add_up_are_named() {
    let far = nodes("", "").channel((0, "scale"), "LINEAR", &[0.0, 1.0], &[[1.0; 3], [1.00009; 3]]);
    assert_eq!(far.read().warnings().len(), 1);
    let mut chain = Builder::default();
    for joint in 0..19 {
        chain = chain.node(&format!(r#""children": [{}], "translation": [1, 0, 0]"#, joint + 1));
    }
    chain = chain.node(r#""translation": [1, 0, 0]"#);
    for joint in 0..20 {
        chain = chain.channel((joint, "scale"), "LINEAR", &[0.0, 1.0], &[[1.0; 3], [1.00009; 3]]);
    }
    // Joint i is 19 - i from the last of 20, which are 19 in all: 9e-5 * (19 + 18 + ... + 1) / 19.
    let expected = "animation 0 `kick`, channel 0 (scale of node 0 `node_0`): expected animated scales that move joints by at most \
                    1e-4 of the skeleton's size, found 9.0e-4";
    assert_eq!(chain.error(), expected);
}

#[test]
fn animated_scale_is_named() {
    let scale = |mode: &str, values: &[[f32; 3]]| {
        let times = if mode == "CUBICSPLINE" { values.len() / 3 } else { values.len() };
        let times: alloc::vec::Vec<f32> = (0..times).map(|key| key as f32).collect();
        let error = nodes("", r#", "scale": [2, 2, 2]"#).channel((1, "scale"), mode, &times, values).error();
        let place = "animation 0 `kick`, channel 0 (scale of node 1 `knee`): ";
        String::from(error.strip_prefix(place).unwrap_or_else(|| panic!("{error}")))
    };
    let grows = scale("LINEAR", &[[2.0; 3], [2.0, 2.5, 2.0]]);
    assert_eq!(grows, "key 1: expected the scale of the node at rest, 2, found 2 2.5 2");
    // That stays, but the mesh was bound to the other.
    let other = scale("STEP", &[[1.0; 3]]);
    assert_eq!(other, "key 0: expected the scale of the node at rest, 2, found 1 1 1");
    let between = scale("CUBICSPLINE", &[[0.0; 3], [2.0; 3], [0.0, 0.0, 2.7], [0.0; 3], [2.0; 3], [0.0; 3]]);
    assert_eq!(between, "key 0: expected the scale of the node at rest, 2, found 2 2 2.8");
    assert_eq!(scale("STEP", &[[f32::NAN; 3]]), "expected a finite value of key 0, found a NaN or an infinity");
}

#[test]
fn splines_that_no_keys_follow_are_named() {
    let wild = [[0.0; 3], [0.0; 3], [1e30, 0.0, 0.0], [1e30, 0.0, 0.0], [0.0; 3], [0.0; 3]];
    let error = nodes("", "").channel((1, "translation"), "CUBICSPLINE", &[0.0, 1.0], &wild).error();
    let expected = "expected a spline that 65536 further keys can follow, found one that needs more";
    assert_eq!(error, format!("animation 0 `kick`, channel 0 (translation of node 1 `knee`): {expected}"));
}

#[test]
fn too_many_keys_are_refused_before_there_is_a_place_for_them() {
    // One channel of many keys, in a skeleton of many joints that stand still.
    let (joints, keys) = (4000, MAX_JOINT_KEYS / 4000 + 1);
    let mut builder = Builder::default();
    for _ in 0..joints {
        builder = builder.node("");
    }
    let times: alloc::vec::Vec<f32> = (0..keys).map(|key| key as f32).collect();
    let builder = builder.channel((0, "translation"), "STEP", &times, &alloc::vec![[0.0; 3]; keys]);
    let expected = "animation 0 `kick`: expected at most 8388608 keys of joints in all clips together, found more";
    assert_eq!(builder.error(), expected);
}

#[test]
fn errors_tell_their_place_and_reason() {
    let text = leg().text().replace(r#""children": [1]"#, r#""children": [1, 2]"#);
    let error = parse::<f32>(text.as_bytes()).unwrap_err();
    assert!(matches!(error.place(), Place::Node(node) if node.index == 0 && node.name == "hip"));
    assert_eq!(error.reason(), &GltfReason::OutOfRange { what: "a child", found: 2, count: 2 });
    let long = leg().text().replace(r#""hip""#, &format!(r#""{}""#, "ü".repeat(100_000))).replace("[1]", "[2]");
    let message = alloc::string::ToString::to_string(&parse::<f32>(long.as_bytes()).unwrap_err());
    assert!(message.starts_with(&format!("node 0 `{}...`: ", "ü".repeat(40))), "{message}");
}
