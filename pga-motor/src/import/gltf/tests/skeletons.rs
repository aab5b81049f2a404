//! Nodes, skins and what becomes of them.

use alloc::format;
use alloc::string::ToString;
use alloc::vec::Vec;

use super::builder::{Builder, assert_near, rest};
use crate::import::gltf::{Skin, Warning, parse};
use crate::skeleton::Skeleton;
use crate::{Motor, Point};

/// The matrix of a scale, then a translation.
fn scale_translate(scale: f32, [x, y, z]: [f32; 3]) -> [f32; 16] {
    [scale, 0.0, 0.0, 0.0, 0.0, scale, 0.0, 0.0, 0.0, 0.0, scale, 0.0, x, y, z, 1.0]
}

#[test]
fn joints_come_in_any_order_unnamed_and_with_several_roots() {
    let file = Builder::default()
        .node(r#""translation": [0, -3, 0]"#)
        .node(r#""name": "mesh""#)
        .node(r#""name": "hip", "children": [1, 4, 0], "translation": [0, 9, 0]"#)
        .node(r#""name": "prop""#)
        .node(r#""name": "hip", "translation": [1, 0, 0]"#)
        .node(r#""name": "scene", "children": [2], "translation": [5, 0, 0]"#)
        .skin("[0, 3, 2]")
        .skin("[4, 0]")
        .read();
    let names = ["prop", "scene", "hip", "hip", "node_0"];
    assert_eq!(file.skeleton().names(), names);
    assert_eq!(file.nodes(), [3, 5, 2, 4, 0]);
    assert_eq!([0, 1, 2, 3, 4].map(|joint| file.skeleton().parent(joint)), [None, None, Some(1), Some(2), Some(2)]);
    // Skin after skin, each joint once.
    assert_eq!(file.joints(), [4, 0, 2, 3]);
    let of_skins: Vec<_> = file.skins().iter().map(|skin| skin.joints.clone()).collect();
    assert_eq!(of_skins, [[4, 0, 2].to_vec(), [3, 4].to_vec()]);
    assert_near(rest(&file)[4], [5.0, 6.0, 0.0]);
    assert_eq!(file.warnings(), []);
}

#[test]
fn without_skins_every_node_is_a_joint() {
    let file = Builder::default().node(r#""name": "a""#).node(r#""children": [0]"#).read();
    assert_eq!(file.skeleton().names(), ["node_1", "a"]);
    assert_eq!(file.joints(), [1, 0]);
    assert_eq!(file.skins(), []);
}

#[test]
fn scale_is_folded_into_translations_and_left_for_the_mesh() {
    let file = Builder::default()
        .node(r#""children": [1], "scale": [2, 2, 2], "translation": [10, 0, 0]"#)
        .node(r#""children": [2], "scale": [0.25, 0.25, 0.25], "translation": [0, 3, 0], "rotation": [0, 0, 1, 0]"#)
        .node(r#""translation": [0, 8, 0]"#)
        // Bound where they are, with a mesh in half the unit.
        .bound_skin("[1, 2]", &[scale_translate(1.0, [0.0; 3]), scale_translate(1.0, [0.0, 2.0, 0.0])])
        .read();
    let joints = rest(&file);
    assert_near(joints[1], [10.0, 6.0, 0.0]);
    assert_near(joints[2], [10.0, 2.0, 0.0]);
    let Skin { inv_bind_poses, scale, .. } = &file.skins()[0];
    assert_eq!(*scale, 0.5);
    // By the matrices: (x, y, z) goes to (x, y + 2, z), is scaled by 0.5, turned by half a turn about z, and carried to the joint.
    let model = [Motor::IDENTITY, Motor::IDENTITY, Motor::IDENTITY];
    let mut model = model;
    crate::skeleton::local_to_model(file.skeleton(), file.skeleton().rest_pose(), &mut model).unwrap();
    let vertex = Point::new(0.5 * 4.0, 0.5 * 6.0, 0.0);
    assert_near((model[2] * inv_bind_poses[1]).transform_point(vertex), [8.0, -2.0, 0.0]);
}

#[test]
fn matrices_are_taken_apart() {
    // A quarter turn about z and a scale by 3.
    let file = Builder::default()
        .node(r#""children": [1], "matrix": [0, 3, 0, 0, -3, 0, 0, 0, 0, 0, 3, 0, 1, 2, 3, 1]"#)
        .node(r#""translation": [1, 0, 0]"#)
        .read();
    assert_near(rest(&file)[1], [1.0, 5.0, 3.0]);
    let turned = file.skeleton().rest_pose()[0].transform_point(Point::new(1.0, 0.0, 0.0));
    assert_near(turned, [1.0, 3.0, 3.0]);
}

#[test]
fn what_is_beside_the_skeleton_may_scale_as_it_likes() {
    let file = Builder::default()
        .node(r#""children": [1, 2]"#)
        .node("")
        .node(r#""scale": [1, -2, 0], "children": [3], "rotation": [0, 0, 0, 0]"#)
        .node(r#""translation": [1e39, 0, 0]"#)
        .skin("[1]")
        .read();
    assert_eq!(file.nodes(), [0, 1]);
}

#[test]
fn bind_poses_are_those_of_the_first_skin_that_has_the_joint() {
    let file = Builder::default()
        .node(r#""children": [1], "translation": [0, 9, 0]"#)
        .node(r#""children": [2], "translation": [0, -4, 0]"#)
        .node(r#""translation": [0, -3, 0]"#)
        .bound_skin("[1]", &[scale_translate(1.0, [7.0, 0.0, 0.0])])
        .bound_skin("[2, 1]", &[scale_translate(2.0, [0.0, 5.0, 0.0]), scale_translate(2.0, [0.0; 3])])
        .read();
    let origins: Vec<_> = file.skeleton().joints().iter().map(|joint| joint.inv_bind_pose.transform_origin()).collect();
    // The first stands in no skin: from the rest pose.
    assert_near(origins[0], [0.0, -9.0, 0.0]);
    assert_near(origins[1], [7.0, 0.0, 0.0]);
    assert_near(origins[2], [0.0, 5.0, 0.0]);
    assert_eq!([file.skins()[0].scale, file.skins()[1].scale], [1.0, 2.0]);
}

#[test]
fn a_skin_without_matrices_has_identities() {
    let file = Builder::default().node(r#""translation": [0, 9, 0]"#).skin("[0]").read();
    assert_eq!(file.skins()[0].inv_bind_poses, [Motor::IDENTITY]);
    assert_eq!((file.skins()[0].name.as_str(), file.skins()[0].scale), ("leg", 1.0));
}

#[test]
fn quaternions_of_nodes_become_unit() {
    let file = Builder::default().node(r#""name": "hip", "rotation": [0, 0, 0.6002, 0.8]"#).read();
    let [warning @ Warning::Renormalized { .. }] = file.warnings() else { panic!("{:?}", file.warnings()) };
    let message = "node 0 `hip`: made 1 quaternions unit whose lengths were off 1 by up to 1.2e-4";
    assert_eq!(warning.to_string(), message);
    assert!(file.skeleton().rest_pose()[0].is_unit(1e-15));
}

#[test]
fn a_chain_of_many_nodes_needs_no_stack() {
    // The last joints of a list are the first of the chain.
    let chain = |count: usize| {
        let nodes = (0..count).map(|node| match node {
            0 => "{}".to_string(),
            _ => format!(r#"{{ "children": [{}] }}"#, node - 1),
        });
        let nodes = nodes.collect::<Vec<_>>().join(",");
        format!(r#"{{ "asset": {{ "version": "2.0" }}, "nodes": [{nodes}] }}"#)
    };
    let file = parse::<f32>(chain(Skeleton::<f32>::MAX_JOINTS).as_bytes()).unwrap();
    assert_eq!(file.skeleton().names()[0], "node_65534");
    let error = parse::<f32>(chain(Skeleton::<f32>::MAX_JOINTS + 1).as_bytes()).unwrap_err();
    let expected = "node 0 `node_0`: joint 65535 `node_0`: expected at most 65535 joints, found more";
    assert_eq!(error.to_string(), expected);
}
