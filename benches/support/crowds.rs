//! Many characters of one skeleton: forward kinematics, and sampling with it, each character at a time of its own. The others go through
//! one character after the other.
//!
//! Compared are the characters at some places of the crowd, and of samples what [`sampling`](super::sampling) compares.

use std::hint::black_box;

use glam::{Affine3A, Mat4};
use pga_motor::f32::{Clip, Motor, Poses};
use pga_motor::f64;
use pga_motor::skeleton::{Interpolation, Wrap, local_to_model};

use super::interpolation::{Agreement, along, lerp_parts, slerp_parts};
use super::kinematics::{in_order, parents, pose, skeleton};
use super::motion::{Motion, Pair, SinglePair, images, motions};
use super::{Contender, SINGLE, Workload};

/// As for kinematics, of 64 joints and of 1000.
const HOT: f64 = 4.0 * SINGLE;
const LARGE: f64 = 16.0 * SINGLE;

pub(super) const WORKLOADS: &[Workload] = &[
    Workload {
        name: "crowd kinematics, 64 joints, 16 characters",
        items: 64 * 16,
        tolerance: HOT,
        contenders: || kinematics(64, 16),
    },
    Workload {
        name: "crowd kinematics, 1000 joints, 1000 characters",
        items: 1000 * 1000,
        tolerance: LARGE,
        contenders: || kinematics(1000, 1000),
    },
    Workload {
        name: "crowd, two keys and kinematics, 64 joints, 64 characters, nlerp",
        items: 64 * 64,
        tolerance: HOT,
        contenders: || vec![ours(Interpolation::Nlerp), glam("glam lerp", Agreement::Turns, lerp_parts)],
    },
    Workload {
        name: "crowd, two keys and kinematics, 64 joints, 64 characters, screw",
        items: 64 * 64,
        tolerance: HOT,
        contenders: || vec![ours(Interpolation::Screw), glam("glam slerp", Agreement::Turns, slerp_parts)],
    },
    Workload {
        name: "crowd, two keys and kinematics, 64 joints, 64 characters, split",
        items: 64 * 64,
        tolerance: HOT,
        contenders: || vec![ours(Interpolation::Split), glam("glam slerp", Agreement::Whole, slerp_parts)],
    },
    Workload {
        name: "crowd, two keys and kinematics, 1000 joints, 1000 characters, screw",
        items: 1000 * 1000,
        tolerance: LARGE,
        contenders: || vec![threads(2), threads(1)],
    },
];

/// The characters that are compared.
fn compared(characters: usize) -> [usize; 3] {
    [0, characters / 2, characters - 1]
}

fn kinematics(joints: usize, characters: usize) -> Vec<Contender> {
    vec![
        in_lanes(joints, characters),
        one_by_one(joints, characters),
        down::<Affine3A>(joints, characters),
        down::<Mat4>(joints, characters),
        down::<SinglePair>(joints, characters),
    ]
}

fn locals(joints: usize, character: usize) -> Vec<f64::Motor> {
    pose(character..character + joints)
}

fn in_lanes(joints: usize, characters: usize) -> Contender {
    let (skeleton, remap) = skeleton(joints);
    let mut locals_of_all = Poses::new(joints, characters);
    for character in 0..characters {
        let pose = in_order(&remap, &motions::<Motor>(&locals(joints, character)));
        locals_of_all.set_pose(character, &pose).expect("one motor for each joint");
    }
    Contender::new(
        "Poses",
        Poses::new(joints, characters),
        move |models| {
            black_box(&locals_of_all).local_to_model_into(black_box(&skeleton), models).expect("as many joints");
        },
        move |models| {
            let mut pose = vec![Motor::IDENTITY; joints];
            let mut image = |character| {
                models.pose_into(character, &mut pose).expect("a character");
                images(&remap.iter().map(|&place| pose[place]).collect::<Vec<_>>())
            };
            compared(characters).into_iter().flat_map(&mut image).collect()
        },
    )
}

fn one_by_one(joints: usize, characters: usize) -> Contender {
    let (skeleton, remap) = skeleton(joints);
    let of_one = |character| in_order(&remap, &motions::<Motor>(&locals(joints, character)));
    let locals: Vec<Motor> = (0..characters).flat_map(of_one).collect();
    Contender::new(
        "ours, one by one",
        locals.clone(),
        move |models| {
            for (pose, model) in black_box(&locals).chunks_exact(joints).zip(models.chunks_exact_mut(joints)) {
                local_to_model(black_box(&skeleton), pose, model).expect("one motor for each joint");
            }
        },
        move |models| {
            let image = |character| {
                let model = &models[character * joints..];
                images(&remap.iter().map(|&place| model[place]).collect::<Vec<_>>())
            };
            compared(characters).into_iter().flat_map(image).collect()
        },
    )
}

fn down<M: Motion>(joints: usize, characters: usize) -> Contender {
    let parents = parents(joints);
    let locals: Vec<M> = (0..characters).flat_map(|character| motions::<M>(&locals(joints, character))).collect();
    Contender::new(
        M::NAME,
        locals.clone(),
        move |models| {
            let parents = black_box(&parents[..]);
            for (pose, model) in black_box(&locals).chunks_exact(joints).zip(models.chunks_exact_mut(joints)) {
                for (joint, &local) in pose.iter().enumerate() {
                    model[joint] = parents[joint].map_or(local, |parent| model[parent].after(local));
                }
            }
        },
        move |models| {
            let image = |character| images(&models[character * joints..(character + 1) * joints]);
            compared(characters).into_iter().flat_map(image).collect()
        },
    )
}

const JOINTS: usize = 64;
const CHARACTERS: usize = 64;

/// Times that differ from character to character.
fn times(characters: usize) -> Vec<f32> {
    (0..characters).map(|character| (0.5 + character as f32) / characters as f32).collect()
}

fn clip(joints: usize, remap: &[usize]) -> Clip {
    let keys = [pose(0..joints), pose(3..joints + 3)];
    Clip::new(joints, vec![0.0, 1.0], keys.map(|key| in_order(remap, &motions::<Motor>(&key))).concat())
        .expect("two keys")
}

fn ours(interpolation: Interpolation) -> Contender {
    let (skeleton, remap) = skeleton(JOINTS);
    let clip = clip(JOINTS, &remap);
    let run = move |times: &[f32], models: &mut Poses| {
        let (skeleton, clip) = (black_box(&skeleton), black_box(&clip));
        models.animate(skeleton, clip, black_box(times), interpolation, Wrap::Clamp).expect("as many joints and times");
    };
    let results = along(Agreement::Whole, |t| {
        let mut models = Poses::new(JOINTS, CHARACTERS);
        run(&[t; CHARACTERS], &mut models);
        let mut pose = vec![Motor::IDENTITY; JOINTS];
        models.pose_into(CHARACTERS / 2, &mut pose).expect("a character");
        remap.iter().map(|&place| pose[place]).collect()
    });
    let times = times(CHARACTERS);
    Contender::new("Poses", Poses::new(JOINTS, CHARACTERS), move |models| run(&times, models), |_| results)
}

fn glam(
    name: &'static str,
    agreement: Agreement,
    between: impl Fn(SinglePair, SinglePair, f32) -> SinglePair + 'static,
) -> Contender {
    let parents = parents(JOINTS);
    let [a, b] = [pose(0..JOINTS), pose(3..JOINTS + 3)].map(|key| motions::<SinglePair>(&key));
    let run = move |times: &[f32], models: &mut Vec<Affine3A>| {
        let parents = black_box(&parents[..]);
        for (&t, model) in black_box(times).iter().zip(models.chunks_exact_mut(JOINTS)) {
            for (joint, (a, b)) in black_box(&a).iter().zip(black_box(&b)).enumerate() {
                let Pair { rotation, translation, .. } = between(*a, *b, t);
                let local = Affine3A::from_rotation_translation(rotation, translation);
                model[joint] = parents[joint].map_or(local, |parent| model[parent] * local);
            }
        }
    };
    let results = along(agreement, |t| {
        let mut models = vec![Affine3A::IDENTITY; JOINTS * CHARACTERS];
        run(&[t; CHARACTERS], &mut models);
        models[CHARACTERS / 2 * JOINTS..][..JOINTS].to_vec()
    });
    let times = times(CHARACTERS);
    Contender::new(name, vec![Affine3A::IDENTITY; JOINTS * CHARACTERS], move |models| run(&times, models), |_| results)
}

/// A large crowd on so many threads.
fn threads(count: usize) -> Contender {
    const MANY: usize = 1000;
    let pool = rayon::ThreadPoolBuilder::new().num_threads(count).build().expect("threads");
    let (skeleton, remap) = skeleton(MANY);
    let (clip, times) = (clip(MANY, &remap), times(MANY));
    Contender::new(
        if count == 1 { "1 thread" } else { "Poses, 2 threads" },
        Poses::new(MANY, MANY),
        move |models| {
            let (skeleton, clip, times) = (black_box(&skeleton), black_box(&clip), black_box(&times));
            pool.install(|| models.animate_in_parallel(skeleton, clip, times, Interpolation::Screw, Wrap::Clamp))
                .expect("as many joints and times");
        },
        |models| {
            let mut pose = vec![Motor::IDENTITY; MANY];
            let mut image = |character| {
                models.pose_into(character, &mut pose).expect("a character");
                images(&pose)
            };
            compared(MANY).into_iter().flat_map(&mut image).collect()
        },
    )
}
