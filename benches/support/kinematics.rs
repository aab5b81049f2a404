//! Forward kinematics of one skeleton: each joint's motion after its parent's.

use std::hint::black_box;
use std::ops::Range;

use glam::{Affine3A, DAffine3, DMat4, Mat4};
use nalgebra::Isometry3;
use pga_motor::skeleton::{Skeleton, local_to_model};
use pga_motor::{Motor, Real, f64};

#[cfg(feature = "peers")]
use super::motion::Peer;
use super::motion::{DoublePair, Motion, SinglePair, images, motions, motor};
use super::{Contender, DOUBLE, SINGLE, Workload};

/// The last joints gather the rounding of all above them, a third of the joints. More, as its root, where there are more joints.
const TOLERANCE: f64 = 4.0;

pub(super) const WORKLOADS: &[Workload] = &[
    Workload {
        name: "forward kinematics, 64 joints",
        items: 64,
        tolerance: TOLERANCE * SINGLE,
        contenders: || single(64),
    },
    Workload {
        name: "forward kinematics, 1000 joints",
        items: 1000,
        tolerance: 4.0 * TOLERANCE * SINGLE,
        contenders: || single(1000),
    },
    Workload {
        name: "forward kinematics, 64 joints, f64",
        items: 64,
        tolerance: TOLERANCE * DOUBLE,
        contenders: || {
            vec![
                ours::<f64>(64),
                down::<DAffine3>(64),
                down::<DMat4>(64),
                down::<DoublePair>(64),
                down::<Isometry3<f64>>(64),
            ]
        },
    },
];

fn single(joints: usize) -> Vec<Contender> {
    vec![
        ours::<f32>(joints),
        down::<Affine3A>(joints),
        down::<Mat4>(joints),
        down::<SinglePair>(joints),
        down::<Isometry3<f32>>(joints),
        #[cfg(feature = "peers")]
        down::<Peer>(joints),
    ]
}

/// Every third joint has three children. In the order of the list a parent stands before its children.
pub(super) fn parents(joints: usize) -> Vec<Option<usize>> {
    (0..joints).map(|joint| joint.checked_sub(1).map(|before| before - before % 3)).collect()
}

/// Small motions, as of one limb to the next.
pub(super) fn pose(indices: Range<usize>) -> Vec<f64::Motor> {
    indices.map(|index| motor(index).nlerp(f64::Motor::IDENTITY, 0.9)).collect()
}

/// The skeleton and the place in it of each joint of the list.
pub(super) fn skeleton<T: Real>(joints: usize) -> (Skeleton<T>, Vec<usize>) {
    let joint = |parent| (String::new(), parent, Motor::IDENTITY);
    Skeleton::from_parents(parents(joints).into_iter().map(joint)).expect("a tree")
}

/// A list by joints in the skeleton's order.
pub(super) fn in_order<M: Copy>(remap: &[usize], list: &[M]) -> Vec<M> {
    let mut ordered = list.to_vec();
    remap.iter().zip(list).for_each(|(&place, &item)| ordered[place] = item);
    ordered
}

fn ours<T: Real>(joints: usize) -> Contender
where
    Motor<T>: Motion,
{
    let (skeleton, remap) = skeleton::<T>(joints);
    let pose = in_order(&remap, &motions::<Motor<T>>(&pose(0..joints)));
    Contender::new(
        "local_to_model",
        pose.clone(),
        move |out| local_to_model(black_box(&skeleton), black_box(&pose), out).expect("one motor for each joint"),
        move |out| images(&remap.iter().map(|&place| out[place]).collect::<Vec<_>>()),
    )
}

fn down<M: Motion>(joints: usize) -> Contender {
    let (parents, pose) = (parents(joints), motions::<M>(&pose(0..joints)));
    let out = pose.clone();
    let run = move |model: &mut Vec<M>| {
        let (parents, model) = (black_box(&parents[..]), &mut model[..]);
        for (joint, &local) in black_box(&pose).iter().enumerate() {
            model[joint] = parents[joint].map_or(local, |parent| model[parent].after(local));
        }
    };
    Contender::new(M::NAME, out, run, |model| images(model))
}
