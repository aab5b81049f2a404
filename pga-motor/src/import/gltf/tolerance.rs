//! How closely the splines of a clip must be followed, so that joints are where they should be.

use alloc::vec::Vec;

use super::curve::Movement;
use super::hierarchy::Hierarchy;

/// How far from its place a joint may be for keys in place of splines, relative to the skeleton's size. The promise is 1e-4; the
/// rest of it is left to rounding in single precision.
const POSITION: f64 = 8e-5;

/// How far from its place a joint may be for scales that are left out, relative to the skeleton's size.
const SCALE: f64 = 1e-4;

/// How far from a joint, beside other joints, something hangs on it, relative to the skeleton's size: its part of the mesh.
const FLESH: f64 = 0.1;

/// By how much translations, and by what angle rotations, may be off, for each joint.
///
/// Where a joint stands is the origin carried by the product of the local motors of its ancestors and itself. Exchange one after
/// the other for the one that was refined. The motors left of it are rigid, so distances stay. A translation off by d moves the
/// joint by d; a rotation off by an angle a moves it by at most a times its distance from the rotated joint. That distance is at most
/// the sum of the lengths of the translations on the way down, each as long as it ever gets: the reach. If n splines at most are on
/// any way from a root to a leaf through a joint, each may cost a share of 1/n of the tolerance.
pub(super) struct Tolerances {
    translations: Vec<f64>,
    rotations: Vec<f64>,
    /// For each joint, how far from it at most anything below is, relative to the skeleton's size.
    reach: Vec<f64>,
    parents: Vec<Option<usize>>,
}

impl Tolerances {
    pub(super) fn of(hierarchy: &Hierarchy, movements: &[Movement]) -> Self {
        let joints = &hierarchy.joints;
        let lengths: Vec<f64> = joints
            .iter()
            .zip(movements)
            .map(|(joint, movement)| {
                let rest = joint.rest.translation.norm();
                movement.translation.as_ref().map_or(rest, |(_, curve)| curve.longest()) * joint.scale_above
            })
            .collect();
        // The splines of the joint itself, then of the worst way up and down from it, itself included.
        let own: Vec<usize> = movements.iter().map(count_splines).collect();
        let (mut up, mut down) = (own.clone(), own.clone());
        let mut reach = alloc::vec![0.0; joints.len()];
        for (joint, parent) in joints.iter().enumerate().filter_map(|(joint, of)| Some((joint, of.parent?))) {
            up[joint] += up[parent];
        }
        for (joint, parent) in joints.iter().enumerate().rev().filter_map(|(joint, of)| Some((joint, of.parent?))) {
            down[parent] = down[parent].max(own[parent] + down[joint]);
            reach[parent] = f64::max(reach[parent], lengths[joint] + reach[joint]);
        }
        let size = size(hierarchy, &lengths);
        let share = |joint: usize| POSITION * size / (up[joint] + down[joint] - own[joint]).max(1) as f64;
        Self {
            translations: (0..joints.len()).map(|joint| share(joint) / joints[joint].scale_above).collect(),
            rotations: (0..joints.len()).map(|joint| share(joint) / (reach[joint] + FLESH * size)).collect(),
            reach: reach.iter().map(|reach| reach / size).collect(),
            parents: joints.iter().map(|joint| joint.parent).collect(),
        }
    }

    /// Whether scales that were left out move joints too far in all: the joint and channel that count most, and how far at most
    /// joints are off, relative to the skeleton's size. A joint's scale, off by a part of itself, moves what is below by that part
    /// of the distance; all joints above one add up.
    pub(super) fn scale_too_far(&self, movements: &[Movement]) -> Option<(usize, usize, f64)> {
        let own = |joint: usize| movements[joint].scale.map_or(0.0, |(_, worst)| worst * self.reach[joint]);
        let mut sums: Vec<f64> = Vec::with_capacity(movements.len());
        for joint in 0..movements.len() {
            let above = self.parents[joint].map_or(0.0, |parent| sums[parent]);
            sums.push(above + own(joint));
        }
        let off = sums.into_iter().fold(0.0, f64::max);
        let joint = (0..movements.len()).max_by(|&a, &b| own(a).total_cmp(&own(b)))?;
        let (channel, _) = movements[joint].scale?;
        (off > SCALE).then_some((joint, channel, off))
    }

    /// How far a joint's translation may be off, in the unit of its channel.
    pub(super) fn translation(&self, joint: usize) -> f64 {
        self.translations[joint]
    }

    /// By what angle a joint's rotation may be off, in radians.
    pub(super) fn rotation(&self, joint: usize) -> f64 {
        self.rotations[joint]
    }
}

fn count_splines(movement: &Movement) -> usize {
    usize::from(movement.translation.as_ref().is_some_and(|(_, curve)| curve.is_spline()))
        + usize::from(movement.rotation.as_ref().is_some_and(|(_, curve)| curve.is_spline()))
}

/// The diagonal of the box around the skins' joints at rest; where they all stand at one place, how far any joint gets from its
/// parent, and 1 where none does.
fn size(hierarchy: &Hierarchy, lengths: &[f64]) -> f64 {
    let models = hierarchy.rest_models();
    let positions: Vec<[f64; 3]> = hierarchy
        .listed
        .iter()
        .map(|&joint| {
            let position = models[joint].transform_origin();
            [position.x, position.y, position.z]
        })
        .collect();
    let edge = |axis: usize| {
        let axis = positions.iter().map(|position| position[axis]);
        axis.clone().fold(f64::NEG_INFINITY, f64::max) - axis.fold(f64::INFINITY, f64::min)
    };
    let diagonal = <f64 as crate::Real>::norm([edge(0), edge(1), edge(2)]);
    let longest = lengths.iter().copied().fold(0.0, f64::max);
    [diagonal, longest].into_iter().find(|&size| size > 0.0).unwrap_or(1.0)
}
