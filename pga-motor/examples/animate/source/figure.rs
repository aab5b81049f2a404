//! A figure written in code, and what it does.

use std::f64::consts::{PI, TAU};

use pga_motor::import::bvh::Tip;
use pga_motor::skeleton::{Clip, Pose, Skeleton};
use pga_motor::{Direction, Motor, Rotor, Translator};

use super::Source;

/// A figure that waves, and that leaps.
pub(super) fn source() -> Source {
    let joints = FIGURE.iter().map(|(name, parent, [x, y, z])| {
        let parent = parent.map(|parent| FIGURE.iter().position(|row| row.0 == parent).expect("a parent is a row"));
        (*name, parent, along(*x, *y, *z))
    });
    let (skeleton, _) = Skeleton::from_parents(joints).expect("the figure is a skeleton");
    let tips = TIPS.iter().map(|(name, [x, y, z])| {
        let joint = skeleton.find(name).expect("a tip hangs from a joint");
        Tip { joint, offset: Direction::new(*x, *y, *z) }
    });
    Source {
        name: "figure".to_owned(),
        tips: tips.collect(),
        clips: vec![waving(&skeleton), leaping(&skeleton)],
        joints: (0..skeleton.len()).collect(),
        warnings: Vec::new(),
        skeleton,
    }
}

fn along(x: f64, y: f64, z: f64) -> Motor<f64> {
    Translator::from_vector(Direction::new(x, y, z)).into()
}

/// The clip of some poses at some times.
fn clip(name: &str, poses: impl IntoIterator<Item = (f64, Pose<f64>)>) -> Clip<f64> {
    let (times, poses): (Vec<_>, Vec<_>) = poses.into_iter().unzip();
    let joints = poses[0].len();
    let keys = poses.into_iter().flat_map(Pose::into_locals).collect();
    Clip::new(joints, times, keys).expect("the keys are products of rotors and translators").with_name(name)
}

/// The resting figure with some joints turned.
fn posed(skeleton: &Skeleton<f64>, turns: &[(&str, Rotor<f64>)]) -> Pose<f64> {
    let mut pose = skeleton.rest_pose().clone();
    for (name, rotor) in turns {
        let joint = skeleton.find(name).expect("the name is one of the figure's");
        pose[joint] = pose[joint] * *rotor;
    }
    pose
}

/// Name, parent and offset in metres of each joint of the waving figure, which looks along +z.
const FIGURE: &[(&str, Option<&str>, [f64; 3])] = &[
    ("hips", None, [0.0, 0.95, 0.0]),
    ("spine", Some("hips"), [0.0, 0.12, 0.0]),
    ("chest", Some("spine"), [0.0, 0.2, 0.0]),
    ("neck", Some("chest"), [0.0, 0.2, 0.0]),
    ("head", Some("neck"), [0.0, 0.09, 0.01]),
    ("left_arm", Some("chest"), [0.18, 0.15, 0.0]),
    ("left_forearm", Some("left_arm"), [0.28, 0.0, 0.0]),
    ("left_hand", Some("left_forearm"), [0.25, 0.0, 0.0]),
    ("right_arm", Some("chest"), [-0.18, 0.15, 0.0]),
    ("right_forearm", Some("right_arm"), [-0.28, 0.0, 0.0]),
    ("right_hand", Some("right_forearm"), [-0.25, 0.0, 0.0]),
    ("left_thigh", Some("hips"), [0.1, -0.06, 0.0]),
    ("left_shin", Some("left_thigh"), [0.0, -0.43, 0.01]),
    ("left_foot", Some("left_shin"), [0.0, -0.4, -0.02]),
    ("right_thigh", Some("hips"), [-0.1, -0.06, 0.0]),
    ("right_shin", Some("right_thigh"), [0.0, -0.43, 0.01]),
    ("right_foot", Some("right_shin"), [0.0, -0.4, -0.02]),
];

const TIPS: &[(&str, [f64; 3])] = &[
    ("head", [0.0, 0.2, 0.02]),
    ("left_hand", [0.16, 0.0, 0.0]),
    ("right_hand", [-0.16, 0.0, 0.0]),
    ("left_foot", [0.02, -0.05, 0.17]),
    ("right_foot", [-0.02, -0.05, 0.17]),
];

/// The right arm goes up, waves and comes down again: two seconds with a key thirty times in each.
fn waving(skeleton: &Skeleton<f64>) -> Clip<f64> {
    let pose = |time: f64| {
        // At the end the sine rounds to somewhere around 0.
        let raised = (PI * time / 2.0).sin().max(0.0).sqrt();
        let swing = (TAU * 1.5 * time).sin() * raised;
        let turns = [
            ("spine", Rotor::about_z(0.05 * raised)),
            ("neck", Rotor::about_z(-0.12 * raised)),
            ("left_arm", Rotor::about_z(-1.3)),
            ("left_forearm", Rotor::about_y(-0.3)),
            ("right_arm", Rotor::about_z(1.3 - 1.7 * raised)),
            ("right_forearm", Rotor::about_z(-raised - 0.55 * swing) * Rotor::about_y(0.3)),
            ("right_hand", Rotor::about_z(-0.35 * swing)),
        ];
        posed(skeleton, &turns)
    };
    clip("waving", (0..=60).map(|key| f64::from(key) / 30.0).map(|time| (time, pose(time))))
}

/// A leap to the side, once around: three keys, far enough from each other to tell the ways between them apart.
fn leaping(skeleton: &Skeleton<f64>) -> Clip<f64> {
    let pose = |hips: Motor<f64>, arms: f64, knees: f64| {
        let turns = [
            ("left_arm", Rotor::about_z(arms)),
            ("right_arm", Rotor::about_z(-arms)),
            ("left_thigh", Rotor::about_x(-knees)),
            ("left_shin", Rotor::about_x(2.0 * knees)),
            ("right_thigh", Rotor::about_x(-0.6 * knees)),
            ("right_shin", Rotor::about_x(1.2 * knees)),
        ];
        let mut pose = posed(skeleton, &turns);
        let joint = skeleton.find("hips").expect("the name is one of the figure's");
        pose[joint] = hips * pose[joint];
        pose
    };
    let high = along(0.9, 0.45, 0.0) * Rotor::about_y(2.9);
    let landed = along(1.8, 0.0, 0.0) * Rotor::about_y(5.9);
    let poses = [pose(Motor::IDENTITY, -1.3, 0.0), pose(high, 1.1, 0.7), pose(landed, -1.2, 0.0)];
    clip("leaping", [0.0, 0.8, 1.6].into_iter().zip(poses))
}
