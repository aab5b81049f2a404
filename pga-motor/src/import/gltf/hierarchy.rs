//! Which nodes are joints, how they hang together, and the skeleton that they make.

use alloc::borrow::ToOwned;
use alloc::vec::Vec;

use ::gltf::json::Root;

use super::cast;
use super::document::{check_index, values};
use super::error::{GltfError, GltfReason};
use super::place::{Named, Place, full_name};
use super::similarity::Similarity;
use super::warning::Warning;
use crate::skeleton::{Skeleton, SkeletonError};
use crate::{Motor, Real};

/// A joint of the skeleton: a node that is a joint of a skin, or stands above one.
pub(super) struct HierarchyJoint {
    pub(super) node: usize,
    pub(super) parent: Option<usize>,
    pub(super) rest: Similarity,
    /// The product of the scales of all joints above it, by which its translations are multiplied.
    pub(super) scale_above: f64,
}

impl HierarchyJoint {
    /// By how much the joint scales what is in its frame.
    pub(super) fn scale(&self) -> f64 {
        self.scale_above * self.rest.scale
    }
}

/// The joints, depth-first.
pub(super) struct Hierarchy {
    pub(super) joints: Vec<HierarchyJoint>,
    /// For each node of the file, which joint it is.
    joint_of_node: Vec<Option<usize>>,
    /// The joints of the file's skins in the file's order, each once; all nodes, where there are no skins.
    pub(super) listed: Vec<usize>,
}

impl Hierarchy {
    pub(super) fn of(root: &Root, warnings: &mut Vec<Warning>) -> Result<Self, GltfError> {
        let parents = parents(root)?;
        let listed_nodes = listed_nodes(root)?;
        let order = depth_first(root, &parents, &above(&parents, &listed_nodes));
        let mut joints: Vec<HierarchyJoint> = Vec::with_capacity(order.len());
        let mut joint_of_node = alloc::vec![None; root.nodes.len()];
        for node in order {
            let fault = |reason: GltfReason| reason.at(Place::Node(Named::node(root, node)));
            let rest = Similarity::of_node(&root.nodes[node]).map_err(fault)?;
            if rest.off_unit > ROUNDING {
                let place = Place::Node(Named::node(root, node));
                warnings.push(Warning::Renormalized { place, count: 1, worst: rest.off_unit });
            }
            let parent = parents[node].and_then(|parent: usize| joint_of_node[parent]);
            let scale_above = parent.map_or(1.0, |parent: usize| joints[parent].scale());
            let joint = HierarchyJoint { node, parent, rest, scale_above };
            if !joint.scale().is_normal() {
                let is_zero = joint.scale() < 1.0;
                let what = "product of the scales from the root down".to_owned();
                return Err(fault(if is_zero { GltfReason::ZeroScale } else { GltfReason::NotFinite { what } }));
            }
            joint_of_node[node] = Some(joints.len());
            joints.push(joint);
        }
        let listed = listed_nodes.into_iter().filter_map(|node| joint_of_node[node]).collect();
        Ok(Self { joints, joint_of_node, listed })
    }

    /// Which joint a node is, if any.
    pub(super) fn joint(&self, node: usize) -> Option<usize> {
        self.joint_of_node.get(node).copied().flatten()
    }

    /// The skeleton in the rest pose. The order of the joints is the skeleton's own.
    pub(super) fn skeleton<T: Real>(&self, root: &Root) -> Result<Skeleton<T>, GltfError> {
        let joints = self.joints.iter().map(|joint| {
            let name = full_name("node", joint.node, root.nodes[joint.node].name.as_ref());
            (name, joint.parent, cast(joint.rest.motor(joint.scale_above)))
        });
        let skeleton = Skeleton::from_parents(joints).map_err(|error| {
            let node = error.joint().map(|joint| Place::Node(Named::node(root, self.joints[joint].node)));
            let what = "place in space, and in the type read into".to_owned();
            let reason = match error {
                SkeletonError::NonFinite { .. } => GltfReason::NotFinite { what },
                other => GltfReason::Skeleton(other),
            };
            reason.at(node.unwrap_or(Place::File))
        });
        skeleton.map(|(skeleton, _)| skeleton)
    }

    /// Where each joint is at rest, in the file's space.
    pub(super) fn rest_models(&self) -> Vec<Motor<f64>> {
        let mut models: Vec<Motor<f64>> = Vec::with_capacity(self.joints.len());
        for joint in &self.joints {
            let local = joint.rest.motor(joint.scale_above);
            models.push(joint.parent.map_or(local, |parent| models[parent] * local));
        }
        models
    }
}

/// How far a quaternion of floating-point numbers may be off unit length without a word: some roundings in single precision.
pub(super) const ROUNDING: f64 = 1e-6;

/// The parent of each node. Fails where a node has several, or is its own ancestor.
fn parents(root: &Root) -> Result<Vec<Option<usize>>, GltfError> {
    let count = root.nodes.len();
    let mut parents = alloc::vec![None; count];
    for (parent, node) in root.nodes.iter().enumerate() {
        for child in values(node.children.as_deref().unwrap_or_default()) {
            check_index("a child", child, count).map_err(|reason| reason.at(Place::Node(Named::node(root, parent))))?;
            if let Some(first) = parents[child].replace(parent) {
                let reason = GltfReason::TwoParents { parents: [first, parent] };
                return Err(reason.at(Place::Node(Named::node(root, child))));
            }
        }
    }
    // Every node is passed once: what a walk upwards meets that an earlier one has met leads to where that one led, a root.
    let mut walk_of = alloc::vec![usize::MAX; count];
    for start in 0..count {
        let mut next = Some(start);
        while let Some(node) = next.filter(|&node| walk_of[node] == usize::MAX) {
            walk_of[node] = start;
            next = parents[node];
        }
        if let Some(node) = next.filter(|&node| walk_of[node] == start) {
            return Err(GltfReason::Cycle.at(Place::Node(Named::node(root, node))));
        }
    }
    Ok(parents)
}

/// The nodes that are joints of skins, in the file's order, each once; all of them where there are no skins.
fn listed_nodes(root: &Root) -> Result<Vec<usize>, GltfError> {
    if root.skins.is_empty() {
        return Ok((0..root.nodes.len()).collect());
    }
    let mut is_listed = alloc::vec![false; root.nodes.len()];
    let mut listed = Vec::new();
    for (index, skin) in root.skins.iter().enumerate() {
        let fault = |reason: GltfReason| reason.at(Place::Skin(Named::skin(root, index)));
        if skin.joints.is_empty() {
            return Err(fault(GltfReason::Skeleton(SkeletonError::Empty)));
        }
        for node in values(&skin.joints) {
            check_index("a joint's node", node, root.nodes.len()).map_err(fault)?;
            if !core::mem::replace(&mut is_listed[node], true) {
                listed.push(node);
            }
        }
    }
    Ok(listed)
}

/// For each node, whether it is one of those listed or stands above one.
fn above(parents: &[Option<usize>], listed: &[usize]) -> Vec<bool> {
    let mut is_above = alloc::vec![false; parents.len()];
    for &node in listed {
        let mut next = Some(node);
        while let Some(node) = next.filter(|&node| !is_above[node]) {
            is_above[node] = true;
            next = parents[node];
        }
    }
    is_above
}

/// The chosen nodes depth-first: roots in the file's order, children as their parent lists them.
fn depth_first(root: &Root, parents: &[Option<usize>], is_chosen: &[bool]) -> Vec<usize> {
    let mut order = Vec::new();
    for start in (0..parents.len()).filter(|&node| parents[node].is_none()) {
        let mut stack = alloc::vec![start];
        while let Some(node) = stack.pop() {
            if is_chosen[node] {
                order.push(node);
                stack.extend(values(root.nodes[node].children.as_deref().unwrap_or_default()).into_iter().rev());
            }
        }
    }
    order
}
