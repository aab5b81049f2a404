//! Skins: where joints stood when a mesh was bound to them.

use alloc::borrow::ToOwned;
use alloc::string::String;
use alloc::vec::Vec;

use ::gltf::json::Root;
use ::gltf::json::accessor::Type;

use super::buffers::{Buffers, Content};
use super::document::values;
use super::error::{GltfError, GltfReason};
use super::hierarchy::Hierarchy;
use super::place::{Named, Place, full_name};
use super::similarity::{Similarity, cast, rigid};
use crate::skeleton::Skeleton;
use crate::{Motor, Real};

/// A skin: the joints that move a mesh, and where they stood when it was bound to them.
///
/// The vertex v of the mesh that hangs on the joint `joints[i]` alone is in the file's space at
/// `model[joints[i]] * inv_bind_poses[i]`, applied to `scale * v`.
#[derive(Clone, Debug, PartialEq)]
pub struct Skin<T> {
    /// Its name, or `skin_` and its index where the file gives none.
    pub name: String,
    /// Indices into the skeleton, in the order of the skin, to which the meshes' `JOINTS_0` refer.
    pub joints: Vec<usize>,
    /// For each of the joints, the motor from where the mesh was bound, scaled by `scale`, to the joint's own frame.
    pub inv_bind_poses: Vec<Motor<T>>,
    /// By this the mesh's vertices are to be multiplied first. Positive.
    pub scale: T,
}

/// How far, relatively, inverse bind matrices may be from rigid and their scales from each other. They are products of long chains, turned
/// round and often rounded, and what they move is a mesh, not the joints.
const TOLERANCE: f64 = 1e-3;

/// Reads the skins.
///
/// A joint that scales by c what is in its frame stands at M S, M its model motor and S the scaling by c. With its inverse bind
/// matrix I it moves a vertex v to M (S I v), and S I is a motion after a scaling by k, as I is itself one after another: S I = B K.
/// So B is the motor, k the scale; the joints of a skin must agree on it.
pub(super) fn read_skins<T: Real>(
    root: &Root,
    hierarchy: &Hierarchy,
    buffers: &mut Buffers<'_>,
) -> Result<Vec<Skin<T>>, GltfError> {
    (0..root.skins.len()).map(|index| read_skin(root, index, hierarchy, buffers)).collect()
}

fn read_skin<T: Real>(
    root: &Root,
    index: usize,
    hierarchy: &Hierarchy,
    buffers: &mut Buffers<'_>,
) -> Result<Skin<T>, GltfError> {
    let skin = &root.skins[index];
    let fault = |reason: GltfReason| reason.at(Place::Skin(Named::skin(root, index)));
    let nodes = values(&skin.joints);
    let joints: Vec<usize> = nodes.iter().filter_map(|&node| hierarchy.joint(node)).collect();
    let matrices = match skin.inverse_bind_matrices {
        None => None,
        Some(accessor) => Some(buffers.elements::<16>(accessor.value(), Type::Mat4, Content::Float).map_err(fault)?),
    };
    if let Some(found) = matrices.as_ref().map(|matrices| matrices.len()).filter(|&found| found < joints.len()) {
        return Err(fault(GltfReason::ValueCount { expected: joints.len(), found }));
    }
    let mut inv_bind_poses = Vec::with_capacity(joints.len());
    let mut scale = None;
    for (matrix, &joint) in joints.iter().enumerate() {
        let fault = |reason: GltfReason| {
            let node = Named::node(root, hierarchy.joints[joint].node);
            reason.at(Place::InverseBindMatrix { skin: Named::skin(root, index), matrix, node })
        };
        let of_joint = hierarchy.joints[joint].scale();
        let (motor, found) = match &matrices {
            // Where there are none, they count as identities.
            None => (Motor::IDENTITY, of_joint),
            Some(matrices) => {
                let inverse = Similarity::of_matrix(matrices.get(matrix), "entry", TOLERANCE).map_err(fault)?;
                (rigid(inverse.rotation, inverse.translation * of_joint), inverse.scale * of_joint)
            }
        };
        let expected = *scale.get_or_insert(found);
        if (found - expected).abs() > TOLERANCE * expected.abs() {
            return Err(fault(GltfReason::SkinScale { expected, found }));
        }
        let motor = cast::<T>(motor);
        if !motor.is_finite() || !T::from_f64(found).is_finite() {
            return Err(fault(GltfReason::NotFinite { what: "motor, in the type read into".to_owned() }));
        }
        inv_bind_poses.push(motor);
    }
    let name = full_name("skin", index, skin.name.as_ref());
    Ok(Skin { name, joints, inv_bind_poses, scale: T::from_f64(scale.unwrap_or(1.0)) })
}

/// The skeleton with the bind poses of the skins: for a joint of several, those of the first; for one of none, the rest pose.
pub(super) fn bind<T: Real>(
    root: &Root,
    skeleton: Skeleton<T>,
    hierarchy: &Hierarchy,
    skins: &[Skin<T>],
) -> Result<Skeleton<T>, GltfError> {
    let mut inv_bind_poses: Vec<Motor<T>> = skeleton.joints().iter().map(|joint| joint.inv_bind_pose).collect();
    for skin in skins.iter().rev() {
        // Within a skin too the first counts.
        for (&joint, &motor) in skin.joints.iter().zip(&skin.inv_bind_poses).rev() {
            inv_bind_poses[joint] = motor;
        }
    }
    skeleton.with_inv_bind_poses(&inv_bind_poses).map_err(|error| {
        let node = error.joint().map(|joint| Place::Node(Named::node(root, hierarchy.joints[joint].node)));
        GltfReason::Skeleton(error).at(node.unwrap_or(Place::File))
    })
}
