//! Accessors whose values are replaced one by one, and those without a view.

use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;

use super::builder::{Builder, about_z, error};
use crate::import::gltf::{Gltf, parse, parse_with};

/// A matrix that moves along y.
fn along_y(y: f32) -> [f32; 16] {
    [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, y, 0.0, 1.0]
}

/// The matrices are accessor 0, the rotations accessor 1, their times accessor 2, each with the view of that index.
fn leg(matrices: &[[f32; 16]; 2], times: &[f32; 3], rotations: &[[f32; 4]; 3]) -> Builder {
    Builder::default()
        .node(r#""name": "hip", "children": [1]"#)
        .node(r#""name": "knee", "translation": [0, -4, 0]"#)
        .bound_skin("[0, 1]", matrices)
        .channel((0, "rotation"), "LINEAR", times, rotations)
}

fn good_leg() -> Builder {
    let rotations = [about_z(0.0), about_z(90.0), about_z(60.0)];
    leg(&[along_y(0.0), along_y(4.0)], &[0.0, 1.0, 2.0], &rotations)
}

fn floats<const N: usize>(rows: &[[f32; N]]) -> Vec<u8> {
    rows.as_flattened().iter().flat_map(|number| number.to_le_bytes()).collect()
}

/// The member of an accessor whose indices are in view 3 and its values in view 4.
fn sparse(count: usize, kind: u32) -> String {
    format!(
        r#", "sparse": {{ "count": {count}, "indices": {{ "bufferView": 3, "componentType": {kind} }},
            "values": {{ "bufferView": 4 }} }}"#
    )
}

/// The text with an accessor replaced.
#[track_caller]
fn replaced(builder: &Builder, accessor: usize, new: &str) -> String {
    let text = builder.text();
    let start = text.find(&format!(r#"{{ "bufferView": {accessor},"#)).expect("an accessor with the view of its index");
    let end = start + text[start..].find('}').expect("the end of the accessor");
    format!("{}{{ {new} {}", &text[..start], &text[end..])
}

#[track_caller]
fn read(text: &str) -> Gltf<f64> {
    parse(text.as_bytes()).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn values_of_a_view_are_replaced() {
    let wrong = [about_z(10.0), about_z(90.0), about_z(20.0)];
    let values = floats(&[about_z(0.0), about_z(60.0)]);
    let base = || leg(&[along_y(0.0), along_y(4.0)], &[0.0, 1.0, 2.0], &wrong);
    assert_ne!(base().read(), good_leg().read());
    for (kind, indices) in [(5121, &[0, 2][..]), (5123, &[0, 0, 2, 0]), (5125, &[0, 0, 0, 0, 2, 0, 0, 0])] {
        // Of the indices there may be more in the view.
        let builder = base().view(&[indices, &[0; 3]].concat()).view(&values);
        let list = sparse(2, kind);
        let accessor = format!(r#""bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC4"{list}"#);
        assert_eq!(read(&replaced(&builder, 1, &accessor)), good_leg().read());
    }
}

#[test]
fn lists_may_start_within_their_views_and_be_empty() {
    let wrong = leg(&[along_y(0.0), along_y(4.0)], &[0.0, 1.0, 2.0], &[about_z(0.0), about_z(10.0), about_z(60.0)]);
    let builder = wrong.view(&[9, 9, 9, 1]).view(&[[7; 4].to_vec(), floats(&[about_z(90.0)])].concat());
    let accessor = r#""bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC4""#;
    let list = r#""sparse": { "count": 1, "indices": { "bufferView": 3, "byteOffset": 3, "componentType": 5121 },
        "values": { "bufferView": 4, "byteOffset": 4 } }"#;
    assert_eq!(read(&replaced(&builder, 1, &format!("{accessor}, {list}"))), good_leg().read());
    let empty = good_leg().view(&[]).view(&[]);
    assert_eq!(read(&replaced(&empty, 1, &format!("{accessor}{}", sparse(0, 5121)))), good_leg().read());
}

#[test]
fn values_without_a_view_are_zeros_where_none_is_given() {
    let times = good_leg().view(&[1, 2]).view(&floats(&[[1.0], [2.0]]));
    let accessor = format!(r#""componentType": 5126, "count": 3, "type": "SCALAR"{}"#, sparse(2, 5121));
    assert_eq!(read(&replaced(&times, 2, &accessor)), good_leg().read());

    let matrices = good_leg().view(&[0, 1]).view(&floats(&[along_y(0.0), along_y(4.0)]));
    let accessor = format!(r#""componentType": 5126, "count": 2, "type": "MAT4"{}"#, sparse(2, 5121));
    assert_eq!(read(&replaced(&matrices, 0, &accessor)), good_leg().read());

    // What no joint asks for may be zero.
    let accessor =
        format!(r#""componentType": 5126, "count": 18446744073709551615, "type": "MAT4"{}"#, sparse(2, 5121));
    assert_eq!(read(&replaced(&matrices, 0, &accessor)), good_leg().read());

    let slide = |values: &[[f32; 3]; 3]| {
        let builder = Builder::default().node(r#""name": "hip", "translation": [0, 9, 0]"#);
        builder.channel((0, "translation"), "LINEAR", &[0.0, 1.0, 2.0], values)
    };
    let full = slide(&[[0.0; 3], [0.0, 5.0, 0.0], [0.0; 3]]);
    // Its views 0 and 1 are the values and the times, 2 is of no use.
    let builder = slide(&[[7.0; 3]; 3]).view(&[]).view(&[1]).view(&floats(&[[0.0_f32, 5.0, 0.0]]));
    let accessor = format!(r#""componentType": 5126, "count": 3, "type": "VEC3"{}"#, sparse(1, 5121));
    assert_eq!(read(&replaced(&builder, 0, &accessor)), full.read());
    let still = read(&replaced(&builder, 0, r#""componentType": 5126, "count": 3, "type": "VEC3""#));
    assert_eq!(still, slide(&[[0.0; 3]; 3]).read());
}

#[test]
fn normalized_integers_are_replaced() {
    let turn = |bytes: &[u8]| {
        Builder::default().node(r#""name": "hip""#).normalized(0, &[0.0, 1.0], 5120, bytes).view(&[]).view(&[1])
    };
    let builder = turn(&[0, 0, 0, 127, 0, 0, 0, 127]).view(&[0, 127, 0, 0]);
    let accessor = r#""componentType": 5120, "normalized": true, "count": 2, "type": "VEC4", "bufferView": 0"#;
    let found = read(&replaced(&builder, 0, &format!("{accessor}{}", sparse(1, 5121))));
    assert_eq!(found, turn(&[0, 0, 0, 127, 0, 127, 0, 0]).read());
}

/// The error for accessor 1, given its sparse member and the bytes of the indices; there is one value.
#[track_caller]
fn error_of(list: &str, indices: &[u8]) -> String {
    let builder = good_leg().view(indices).view(&floats(&[about_z(0.0)]));
    let accessor = r#""bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC4""#;
    of_channel(&error(&replaced(&builder, 1, &format!("{accessor}{list}"))))
}

#[track_caller]
fn of_channel(error: &str) -> String {
    let place = "animation 0 `kick`, channel 0 (rotation of node 0 `hip`): ";
    error.strip_prefix(place).unwrap_or_else(|| panic!("{error}")).to_string()
}

#[test]
fn broken_lists_are_named() {
    let outside = error_of(&sparse(1, 5121), &[3]);
    assert_eq!(outside, "expected sparse indices that increase and are below 3 in accessor 1, found 3");
    let list = sparse(1, 5125);
    let outside = error_of(&list, &[255; 4]);
    assert_eq!(outside, "expected sparse indices that increase and are below 3 in accessor 1, found 4294967295");
    assert_eq!(error_of(&list, &[0; 3]), "expected 4 bytes for the sparse indices of accessor 1, found 3");
    let few = error_of(&sparse(2, 5121), &[0, 1]);
    assert_eq!(few, "expected 32 bytes for the sparse values of accessor 1, found 16");
    let long = error_of(&list.replace(r#""count": 1"#, r#""count": 18446744073709551615"#), &[0; 4]);
    assert_eq!(long, "expected 73786976294838206460 bytes for the sparse indices of accessor 1, found 4");
    let far =
        error_of(&list.replace(r#""indices": {"#, r#""indices": { "byteOffset": 18446744073709551615,"#), &[0; 4]);
    assert_eq!(far, "expected 4 bytes for the sparse indices of accessor 1, found 0");
    let far = error_of(&list.replace(r#""values": {"#, r#""values": { "byteOffset": 1,"#), &[0; 4]);
    assert_eq!(far, "expected 16 bytes for the sparse values of accessor 1, found 15");
    for kind in [5120, 5122, 5126, 7] {
        let unknown = error_of(&sparse(1, kind), &[0; 4]);
        let expected = "expected sparse indices of unsigned bytes, shorts or ints in accessor 1";
        assert_eq!(unknown, format!("{expected}, found an unknown kind"));
    }
    for view in [3, 4] {
        let missing = error_of(&list.replace(&format!(r#""bufferView": {view}"#), r#""bufferView": 9"#), &[0; 4]);
        assert_eq!(missing, "expected a buffer view below 5, the number of them, found 9");
    }
}

#[test]
fn lists_out_of_order_are_named() {
    for (indices, found) in [([1, 1], "1 after 1"), ([2, 0], "0 after 2")] {
        let builder = good_leg().view(&indices).view(&floats(&[about_z(0.0); 2]));
        let accessor = format!(r#""componentType": 5126, "count": 3, "type": "VEC4"{}"#, sparse(2, 5121));
        let expected = "expected sparse indices that increase and are below 3 in accessor 1";
        assert_eq!(of_channel(&error(&replaced(&builder, 1, &accessor))), format!("{expected}, found {found}"));
    }
}

#[test]
fn lists_that_lie_apart_are_named() {
    let values = floats(&[about_z(0.0); 2]);
    let of = |view: &str, stride: usize| {
        let builder = good_leg().view(&[1, 0]).view(&values);
        let accessor = format!(r#""componentType": 5126, "count": 3, "type": "VEC4"{}"#, sparse(1, 5121));
        let text = replaced(&builder, 1, &accessor);
        let (old, new) = (format!("{view} }}"), format!(r#"{view}, "byteStride": {stride} }}"#));
        assert_eq!(text.matches(&old).count(), 1, "{text}");
        of_channel(&error(&text.replace(&old, &new)))
    };
    let (indices, list) = (r#""byteLength": 2"#, r#""byteLength": 32"#);
    let apart = of(indices, 4);
    assert_eq!(apart, "expected sparse indices one after the other in accessor 1, found a stride of 4 bytes");
    let apart = of(list, 32);
    assert_eq!(apart, "expected sparse values one after the other in accessor 1, found a stride of 32 bytes");
    // One after the other it is too, so that what is wrong are the zeros beside the value.
    assert_eq!(of(list, 16), "key 0: expected a unit quaternion, found one of length zero");
}

#[test]
fn counts_that_no_view_bounds_take_no_place() {
    let of = |accessor: usize, shape: &str, count: u64| {
        let new = format!(r#""componentType": 5126, "count": {count}, "type": "{shape}""#);
        error(&replaced(&good_leg(), accessor, &new))
    };
    let many = "expected at most 25165824 values of channels in all animations together, found more";
    assert_eq!(of_channel(&of(2, "SCALAR", u64::MAX)), many);
    let most = of_channel(&of(2, "SCALAR", 25_165_824));
    assert_eq!(most, "key 1: expected a time after that of key 0, found one that is not");
    let values = of_channel(&of(1, "VEC4", 1 << 31));
    assert_eq!(values, "expected 3 values, found 2147483648");
    let zero = of_channel(&of(1, "VEC4", 3));
    assert_eq!(zero, "key 0: expected a unit quaternion, found one of length zero");
    let matrix = of(0, "MAT4", u64::MAX);
    let expected = "expected a matrix with the last row 0 0 0 1, found another";
    assert_eq!(matrix, format!("skin 0 `leg`, inverse bind matrix 0 (of node 0 `hip`): {expected}"));
}

/// The outcome for skins with the given accessors, all of which share a list of 2^20 matrices.
fn shared(accessors: usize, of_skins: impl Iterator<Item = usize>) -> Result<usize, String> {
    let count = 1_u32 << 20;
    let list = format!(
        r#"{{ "componentType": 5126, "count": {count}, "type": "MAT4", "sparse": {{ "count": {count},
            "indices": {{ "bufferView": 0, "componentType": 5125 }}, "values": {{ "bufferView": 1 }} }} }}"#
    );
    let lists = alloc::vec![list; accessors].join(",");
    let skins: Vec<String> =
        of_skins.map(|accessor| format!(r#"{{ "joints": [0], "inverseBindMatrices": {accessor} }}"#)).collect();
    let (indices, length) = (4 * count, 68 * count);
    let text = format!(
        r#"{{ "asset": {{ "version": "2.0" }}, "nodes": [ {{}} ], "skins": [ {} ], "accessors": [ {lists} ],
        "bufferViews": [ {{ "buffer": 0, "byteLength": {indices} }},
            {{ "buffer": 0, "byteOffset": {indices}, "byteLength": {} }} ],
        "buffers": [ {{ "byteLength": {length}, "uri": "many.bin" }} ] }}"#,
        skins.join(","),
        length - indices
    );
    let load = |_: &str| {
        let mut bytes: Vec<u8> = (0..count).flat_map(u32::to_le_bytes).collect();
        bytes.extend(floats(&[along_y(0.0)]));
        bytes.resize(length as usize, 0);
        Ok::<_, String>(bytes)
    };
    parse_with::<f64, _>(text.as_bytes(), load).map(|file| file.skins().len()).map_err(|error| error.to_string())
}

#[test]
fn lists_that_many_share_are_looked_at_within_a_bound() {
    assert_eq!(shared(1, (0..30).map(|_| 0)), Ok(30));
    let many = "expected at most 25165824 sparse values in all accessors together, found more";
    assert_eq!(shared(25, 0..25), Err(format!("skin 24 `skin_24`: {many}")));
}
