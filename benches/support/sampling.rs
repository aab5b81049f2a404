//! A pose between two keys of a clip, and forward kinematics of it: 64 joints.
//!
//! glam's keys are rotations and translations, its joints affine maps. It goes the way of split_lerp; with the others it is compared as
//! in [`interpolation`](super::interpolation).

use std::hint::black_box;

use glam::Affine3A;
use pga_motor::f32::{Clip, Motor, ScrewCache};
use pga_motor::f64;
use pga_motor::skeleton::{Interpolation, Wrap, local_to_model};

use super::interpolation::{Agreement, T, along, lerp_parts, slerp_parts};
use super::kinematics::{in_order, parents, pose, skeleton};
use super::motion::{Pair, SinglePair, motions};
use super::{Contender, SINGLE, Workload};

const JOINTS: usize = 64;
/// As for kinematics.
const TOLERANCE: f64 = 4.0 * SINGLE;

pub(super) const WORKLOADS: &[Workload] = &[
    Workload {
        name: "two keys and kinematics, 64 joints, nlerp",
        items: JOINTS,
        tolerance: TOLERANCE,
        contenders: || {
            vec![ours("sample_into", sample(Interpolation::Nlerp)), glam("glam lerp", Agreement::Turns, lerp_parts)]
        },
    },
    Workload {
        name: "two keys and kinematics, 64 joints, screw",
        items: JOINTS,
        tolerance: TOLERANCE,
        contenders: || {
            let mut cache = ScrewCache::new(JOINTS);
            vec![
                ours("sample_into", sample(Interpolation::Screw)),
                ours("ours, screws kept", move |clip, t, pose| {
                    clip.sample_cached_into(t, Wrap::Clamp, &mut cache, pose)
                }),
                glam("glam slerp", Agreement::Turns, slerp_parts),
            ]
        },
    },
    Workload {
        name: "two keys and kinematics, 64 joints, split",
        items: JOINTS,
        tolerance: TOLERANCE,
        contenders: || {
            vec![ours("sample_into", sample(Interpolation::Split)), glam("glam slerp", Agreement::Whole, slerp_parts)]
        },
    },
];

/// Poses at the two keys.
fn keys() -> [Vec<f64::Motor>; 2] {
    [pose(0..JOINTS), pose(3..JOINTS + 3)]
}

type SampleResult = Result<(), pga_motor::skeleton::ClipError>;

fn sample(interpolation: Interpolation) -> impl FnMut(&Clip, f32, &mut [Motor]) -> SampleResult {
    move |clip, t, pose| clip.sample_into(t, interpolation, Wrap::Clamp, pose)
}

fn ours(name: &'static str, mut sample: impl FnMut(&Clip, f32, &mut [Motor]) -> SampleResult + 'static) -> Contender {
    let (skeleton, remap) = skeleton(JOINTS);
    let keys = keys().map(|key| in_order(&remap, &motions::<Motor>(&key))).concat();
    let clip = Clip::new(JOINTS, vec![0.0, 1.0], keys).expect("two keys");
    let buffer = vec![Motor::IDENTITY; JOINTS];
    let mut run = move |t, [pose, model]: &mut [Vec<Motor>; 2]| {
        sample(black_box(&clip), t, pose).expect("one motor for each joint");
        local_to_model(black_box(&skeleton), pose, model).expect("one motor for each joint");
    };
    let results = along(Agreement::Whole, |t| {
        let mut buffers = [buffer.clone(), buffer.clone()];
        run(t, &mut buffers);
        remap.iter().map(|&place| buffers[1][place]).collect()
    });
    Contender::new(name, [buffer.clone(), buffer], move |buffers| run(black_box(T), buffers), |_| results)
}

fn glam(
    name: &'static str,
    agreement: Agreement,
    between: impl Fn(SinglePair, SinglePair, f32) -> SinglePair + 'static,
) -> Contender {
    let parents = parents(JOINTS);
    let [a, b] = keys().map(|key| motions::<SinglePair>(&key));
    let buffer = vec![Affine3A::IDENTITY; JOINTS];
    let run = move |t, model: &mut Vec<Affine3A>| {
        let (parents, model) = (black_box(&parents[..]), &mut model[..]);
        for (joint, (a, b)) in black_box(&a).iter().zip(black_box(&b)).enumerate() {
            let Pair { rotation, translation, .. } = between(*a, *b, t);
            let local = Affine3A::from_rotation_translation(rotation, translation);
            model[joint] = parents[joint].map_or(local, |parent| model[parent] * local);
        }
    };
    let results = along(agreement, |t| {
        let mut model = buffer.clone();
        run(t, &mut model);
        model
    });
    Contender::new(name, buffer, move |model| run(black_box(T), model), |_| results)
}
