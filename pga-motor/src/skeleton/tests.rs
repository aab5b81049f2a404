//! The order and the bookkeeping of skeletons, forward kinematics against matrices, and every error's message.

use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec;
use alloc::vec::Vec;

use super::*;
use crate::{Direction, Motor, Point, Rotor, Translator};

type Listed = (String, Option<usize>, Motor<f64>);

fn listed(parents: &[Option<usize>]) -> Vec<Listed> {
    parents.iter().enumerate().map(|(joint, &parent)| (format!("j{joint}"), parent, Motor::IDENTITY)).collect()
}

#[track_caller]
fn error(joints: Vec<Listed>) -> SkeletonError {
    Skeleton::from_parents(joints).expect_err("broken joints must make no skeleton")
}

/// A sequence of numbers that looks random and is the same everywhere (Knuth's MMIX constants).
pub(super) struct Sequence(u64);

impl Sequence {
    pub(super) fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// A unit direction.
    pub(super) fn direction(&mut self) -> Direction<f64> {
        loop {
            let direction = Direction::new(self.signed(), self.signed(), self.signed());
            if direction.norm() > 0.1 {
                return direction.normalize().unwrap();
            }
        }
    }

    pub(super) fn rotor(&mut self) -> Rotor<f64> {
        let axis = self.direction();
        Rotor::from_axis_angle(axis, 3.0 * self.signed()).unwrap()
    }

    fn below(&mut self, end: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        usize::try_from(self.0 >> 33).unwrap() % end
    }

    /// In -1..1.
    fn signed(&mut self) -> f64 {
        self.below(2001) as f64 / 1000.0 - 1.0
    }

    fn shuffle(&mut self, items: &mut [usize]) {
        for end in (2..=items.len()).rev() {
            items.swap(end - 1, self.below(end));
        }
    }

    /// Parents of a random forest of `count` joints, each before its children.
    fn forest(&mut self, count: usize) -> Vec<Option<usize>> {
        (0..count).map(|joint| if joint == 0 || self.below(12) == 0 { None } else { Some(self.below(joint)) }).collect()
    }
}

#[test]
fn joints_come_out_depth_first_with_their_groups() {
    //  0 ── 1 ── 3        2 ── 6
    //   └── 4 ── 5
    let parents = [None, Some(0), None, Some(1), Some(0), Some(4), Some(2)];
    let (skeleton, remap) = Skeleton::from_parents(listed(&parents)).unwrap();
    assert_eq!(skeleton.names(), ["j0", "j1", "j3", "j4", "j5", "j2", "j6"]);
    assert_eq!(remap, [0, 1, 5, 2, 3, 4, 6]);
    let places: Vec<_> = skeleton.joints().iter().map(|joint| (joint.parent_offset, joint.group_size)).collect();
    assert_eq!(places, [(0, 5), (1, 2), (1, 1), (3, 2), (1, 1), (0, 2), (1, 1)]);
    assert_eq!((skeleton.find("j4"), skeleton.find("j7"), skeleton.parent(7)), (Some(3), None, None));
}

#[test]
fn joints_given_depth_first_stay_where_they_are() {
    let parents = [None, Some(0), Some(1), Some(1), Some(0), None, Some(5)];
    let (_, remap) = Skeleton::from_parents(listed(&parents)).unwrap();
    assert_eq!(remap, [0, 1, 2, 3, 4, 5, 6]);
}

#[test]
fn any_order_of_the_joints_gives_the_same_hierarchy() {
    let mut sequence = Sequence(1);
    for count in 1..60 {
        let parents = sequence.forest(count);
        let mut place: Vec<usize> = (0..count).collect();
        sequence.shuffle(&mut place);
        let mut shuffled = listed(&vec![None; count]);
        for (joint, &parent) in parents.iter().enumerate() {
            shuffled[place[joint]] = (format!("j{joint}"), parent.map(|parent| place[parent]), Motor::IDENTITY);
        }
        let (skeleton, remap) = Skeleton::from_parents(shuffled).unwrap();
        for joint in 0..count {
            let new = remap[place[joint]];
            assert_eq!(skeleton.names()[new], format!("j{joint}"));
            assert_eq!(skeleton.parent(new), parents[joint].map(|parent| remap[place[parent]]));
        }
        assert_groups_are_subtrees(&skeleton);
    }
}

/// A joint's group is itself and those whose chain of parents passes it, and nothing else.
fn assert_groups_are_subtrees(skeleton: &Skeleton<f64>) {
    for (top, joint) in skeleton.joints().iter().enumerate() {
        let group = top..top + usize::from(joint.group_size);
        for below in 0..skeleton.len() {
            let passes = core::iter::successors(Some(below), |&joint| skeleton.parent(joint)).any(|joint| joint == top);
            assert_eq!(group.contains(&below), passes, "joint {below} and the group of {top}");
        }
    }
}

type Matrix = [[f64; 4]; 4];

fn multiply(a: &Matrix, b: &Matrix) -> Matrix {
    core::array::from_fn(|row| core::array::from_fn(|column| (0..4).map(|k| a[row][k] * b[k][column]).sum()))
}

/// The same rigid motion twice, turned about z, then about x, then displaced: as a motor and as a matrix of column vectors.
fn random_motion(sequence: &mut Sequence) -> (Motor<f64>, Matrix) {
    let [z, x] = [3.0 * sequence.signed(), 3.0 * sequence.signed()];
    let [tx, ty, tz] = [sequence.signed(), sequence.signed(), sequence.signed()];
    let rotor = Rotor::about_x(x) * Rotor::about_z(z);
    let motor = Motor::from_rotor_translator(rotor, Translator::from_vector(Direction::new(tx, ty, tz)));
    let about_z =
        [[z.cos(), -z.sin(), 0.0, 0.0], [z.sin(), z.cos(), 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]];
    let then = [[1.0, 0.0, 0.0, tx], [0.0, x.cos(), -x.sin(), ty], [0.0, x.sin(), x.cos(), tz], [0.0, 0.0, 0.0, 1.0]];
    (motor, multiply(&then, &about_z))
}

#[test]
fn forward_kinematics_agrees_with_matrices() {
    let mut sequence = Sequence(2);
    for count in [1, 2, 10, 100] {
        let parents = sequence.forest(count);
        let (skeleton, remap) = Skeleton::from_parents(listed(&parents)).unwrap();
        let motions: Vec<_> = (0..count).map(|_| random_motion(&mut sequence)).collect();
        let mut locals = vec![Motor::IDENTITY; count];
        let mut matrices: Vec<Matrix> = Vec::new();
        for joint in 0..count {
            locals[remap[joint]] = motions[joint].0;
            matrices
                .push(parents[joint].map_or(motions[joint].1, |parent| multiply(&matrices[parent], &motions[joint].1)));
        }
        let mut model = vec![Motor::IDENTITY; count];
        local_to_model(&skeleton, &locals, &mut model).unwrap();
        for joint in 0..count {
            assert_same_motion(&model[remap[joint]], &matrices[joint]);
        }
    }
}

/// Where a motor and a matrix take a point that is off every axis.
///
/// The forests above are less than 32 deep, so positions are below 32 * sqrt(3) + 2 < 64. A level of either computation
/// multiplies sums of at most 8 products, with a relative error below 16 * 2^-53 of the position's size: over 32 levels and
/// both sides 2 * 32 * 16 * 64 * 2^-53 < 1e-11.
fn assert_same_motion(motor: &Motor<f64>, matrix: &Matrix) {
    let found = motor.transform_point(Point::new(0.3, -0.5, 1.0));
    let expected: [f64; 3] = core::array::from_fn(|row| {
        let [a, b, c, d] = matrix[row];
        0.3 * a - 0.5 * b + c + d
    });
    for (found, expected) in [found.x, found.y, found.z].iter().zip(expected) {
        assert!((found - expected).abs() < 1e-11, "{found} instead of {expected}");
    }
}

#[test]
fn the_inverse_bind_pose_undoes_the_rest_pose() {
    let mut sequence = Sequence(3);
    let mut joints = listed(&sequence.forest(40));
    for joint in &mut joints {
        joint.2 = random_motion(&mut sequence).0;
    }
    let (skeleton, remap) = Skeleton::from_parents(joints.clone()).unwrap();
    let mut model = vec![Motor::IDENTITY; skeleton.len()];
    local_to_model(&skeleton, skeleton.rest_pose(), &mut model).unwrap();
    for (joint, (_, _, rest)) in joints.iter().enumerate() {
        let new = remap[joint];
        assert_eq!(skeleton.rest_pose()[new], *rest);
        let nothing: Matrix =
            core::array::from_fn(|row| core::array::from_fn(|column| f64::from(u8::from(row == column))));
        assert_same_motion(&(model[new] * skeleton.joints()[new].inv_bind_pose), &nothing);
    }
}

#[test]
fn a_skeleton_needs_a_joint_and_takes_65535() {
    assert_eq!(error(Vec::new()).to_string(), "expected at least one joint, found none");
    let chain = |count: usize| listed(&(0..count).map(|joint| joint.checked_sub(1)).collect::<Vec<_>>());
    let (skeleton, _) = Skeleton::from_parents(chain(65_535)).unwrap();
    assert_eq!((skeleton.joints()[0].group_size, skeleton.len()), (65_535, Skeleton::<f64>::MAX_JOINTS));
    let too_many = error(chain(65_536));
    assert_eq!(too_many.to_string(), "joint 65535 `j65535`: expected at most 65535 joints, found more");
    // Joints without end are refused as well.
    let endless = core::iter::repeat(("again", None, Motor::<f64>::IDENTITY));
    assert_eq!(Skeleton::from_parents(endless).unwrap_err().joint(), Some(65_535));
}

#[test]
fn a_parent_must_be_one_of_the_joints() {
    let error = error(listed(&[None, Some(0), Some(3)]));
    assert_eq!(error.to_string(), "joint 2 `j2`: expected a parent below 3, the number of joints, found 3");
}

#[test]
fn a_cycle_is_named_by_its_first_joint() {
    let message = |joint: usize| {
        format!("joint {joint} `j{joint}`: expected a chain of parents that ends at a root, found a cycle")
    };
    assert_eq!(error(listed(&[Some(0)])).to_string(), message(0));
    assert_eq!(error(listed(&[None, Some(0), Some(3), Some(2)])).to_string(), message(2));
    // Joint 0 hangs below the cycle 3 -> 4 -> 3, which is met before the cycle 1 -> 2 -> 1.
    assert_eq!(error(listed(&[Some(3), Some(2), Some(1), Some(4), Some(3)])).to_string(), message(1));
}

#[test]
fn a_cycle_as_long_as_a_skeleton_is_found_in_one_pass() {
    let joints = 65_535;
    let parents: Vec<_> = (0..joints).map(|joint| Some((joint + 1) % joints)).collect();
    assert_eq!(error(listed(&parents)).joint(), Some(0));
}

#[test]
fn rest_motors_must_be_finite_and_rigid() {
    let with = |motor: Motor<f64>| {
        let mut joints = listed(&[None, Some(0)]);
        joints[1].2 = motor;
        error(joints).to_string()
    };
    let not_finite = "joint 1 `j1`: expected a finite motor, found a NaN or an infinity";
    assert_eq!(with(Motor { e31: f64::NAN, ..Motor::IDENTITY }), not_finite);
    assert_eq!(with(Motor { e02: f64::INFINITY, ..Motor::IDENTITY }), not_finite);
    let not_rigid = "joint 1 `j1`: expected a unit motor, found one that is not rigid";
    assert_eq!(with(Motor { s: 0.0, ..Motor::IDENTITY }), not_rigid);
    assert_eq!(with(Motor { s: 1.1, ..Motor::IDENTITY }), not_rigid);
    assert_eq!(with(Motor { e0123: 0.5, ..Motor::IDENTITY }), not_rigid);
}

#[test]
fn finite_rest_motors_may_not_add_up_to_infinity() {
    let far = Motor { e01: -1.0e308, ..Motor::IDENTITY };
    let mut joints = listed(&[Some(1), None]);
    joints[0].2 = far;
    joints[1].2 = far;
    assert_eq!(error(joints), SkeletonError::NonFinite { joint: 0, name: "j0".into() });
}

#[test]
fn buffers_of_another_length_are_refused() {
    let (skeleton, _) = Skeleton::from_parents(listed(&[None, Some(0)])).unwrap();
    let untouched = [Motor { s: 7.0, ..Motor::IDENTITY }; 2];
    let mut out = untouched;
    let error = local_to_model(&skeleton, &[Motor::IDENTITY; 3], &mut out).unwrap_err();
    assert_eq!(error.to_string(), "expected 2 motors in `locals`, one for each joint, found 3");
    assert_eq!(out, untouched);
    let error = local_to_model(&skeleton, skeleton.rest_pose(), &mut out[..1]).unwrap_err();
    assert_eq!(error.to_string(), "expected 2 motors in `out`, one for each joint, found 1");
    assert_eq!(error.joint(), None);
}

/// A random skeleton in a random pose, with the parents of its joints.
fn random_pose(sequence: &mut Sequence, count: usize) -> (Skeleton<f64>, Vec<Motor<f64>>) {
    let mut joints = listed(&sequence.forest(count));
    for joint in &mut joints {
        joint.2 = random_motion(sequence).0;
    }
    let (skeleton, _) = Skeleton::from_parents(joints).unwrap();
    let pose = (0..count).map(|_| random_motion(sequence).0).collect();
    (skeleton, pose)
}

/// Where the joints are by applying each joint's motor to the positions of its group, in this order of the joints.
fn positions_by_groups(
    skeleton: &Skeleton<f64>,
    pose: &[Motor<f64>],
    order: impl Iterator<Item = usize>,
) -> Vec<Point<f64>> {
    let mut positions = vec![Point::ORIGIN; skeleton.len()];
    for joint in order {
        let group = joint..joint + usize::from(skeleton.joints()[joint].group_size);
        pose[joint].transform_points_in_place(&mut positions[group]);
    }
    positions
}

fn farthest(a: &[Point<f64>], b: &[Point<f64>]) -> f64 {
    a.iter().zip(b).map(|(a, &b)| a.distance_to_point(b)).fold(0.0, f64::max)
}

#[test]
fn an_instance_is_where_groups_moved_from_the_leaves_to_the_root_are_and_the_world_comes_last() {
    let mut sequence = Sequence(4);
    for count in [1, 5, 40] {
        let (skeleton, pose) = random_pose(&mut sequence, count);
        let world = random_motion(&mut sequence).0;
        let mut instance = SkeletonInstance::new(&skeleton, world);
        animate_keyframe(&skeleton, &mut instance, &pose).unwrap();
        let mut expected = positions_by_groups(&skeleton, &pose, (0..count).rev());
        world.transform_points_in_place(&mut expected);
        // As for matrices above.
        assert!(farthest(&instance.joint_positions, &expected) < 1e-11);
        let mut model = vec![Motor::IDENTITY; count];
        local_to_model(&skeleton, &pose, &mut model).unwrap();
        assert_eq!(instance.model(), model);
    }
}

/// The order that is sometimes published: each joint's motor applied from the root down, to positions that start at the world's place.
/// It is the product of the motors in the reverse order.
#[test]
fn groups_moved_from_the_root_to_the_leaves_are_somewhere_else() {
    let along_x = |length| Motor::<f64>::from(Translator::from_vector(Direction::new(length, 0.0, 0.0)));
    let joints = [("a", None, along_x(0.0)), ("b", Some(0), along_x(1.0)), ("c", Some(1), along_x(1.0))];
    let (skeleton, _) = Skeleton::from_parents(joints).unwrap();
    let quarter = Rotor::about_z(core::f64::consts::FRAC_PI_2);
    let pose = [along_x(0.0) * quarter, along_x(1.0), along_x(1.0) * quarter];
    let mut instance = SkeletonInstance::new(&skeleton, Motor::IDENTITY);
    animate_keyframe(&skeleton, &mut instance, &pose).unwrap();
    let reversed = positions_by_groups(&skeleton, &pose, 0..3);
    // Two bones of length 1 that point along y; the wrong order turns about the origin in the end, and points along x again.
    assert!(instance.joint_positions[2].distance_to_point(Point::new(0.0, 2.0, 0.0)) < 1e-15);
    assert!(reversed[2].distance_to_point(Point::new(0.0, 2.0, 0.0)) > 1.0, "{}", reversed[2]);

    let mut sequence = Sequence(5);
    let (skeleton, pose) = random_pose(&mut sequence, 40);
    let mut instance = SkeletonInstance::new(&skeleton, Motor::IDENTITY);
    animate_keyframe(&skeleton, &mut instance, &pose).unwrap();
    assert!(farthest(&instance.joint_positions, &positions_by_groups(&skeleton, &pose, 0..40)) > 1.0);
}

#[test]
fn a_sampled_instance_is_in_the_clips_pose() {
    let mut sequence = Sequence(6);
    let (skeleton, first) = random_pose(&mut sequence, 20);
    let second: Vec<_> = (0..20).map(|_| random_motion(&mut sequence).0).collect();
    let clip = Clip::new(20, vec![0.0, 2.0], [&first[..], &second].concat()).unwrap();
    let world = random_motion(&mut sequence).0;
    let (mut sampled, mut posed) = (SkeletonInstance::new(&skeleton, world), SkeletonInstance::new(&skeleton, world));
    let mut scratch = skeleton.rest_pose().clone();
    for interpolation in Interpolation::ALL {
        animate_sample(&skeleton, &mut sampled, &clip, 0.7, interpolation, Wrap::Clamp, &mut scratch).unwrap();
        let mut pose = first.clone();
        clip.sample_into(0.7, interpolation, Wrap::Clamp, &mut pose).unwrap();
        animate_keyframe(&skeleton, &mut posed, &pose).unwrap();
        assert_eq!(sampled, posed);
    }
}

#[test]
fn skinning_motors_carry_a_bound_mesh_along() {
    let mut sequence = Sequence(7);
    let (skeleton, pose) = random_pose(&mut sequence, 12);
    let binds: Vec<_> = (0..12).map(|_| random_motion(&mut sequence).0).collect();
    let skeleton = skeleton.with_inv_bind_poses(&binds).unwrap();
    let mut model = vec![Motor::IDENTITY; 12];
    local_to_model(&skeleton, &pose, &mut model).unwrap();
    let mut skinning = model.clone();
    skinning_motors(&skeleton, &model, &mut skinning).unwrap();
    for joint in 0..12 {
        // What was at the joint's own frame when bound is there now.
        let bound = binds[joint].reverse().transform_point(Point::new(0.1, 0.2, 0.3));
        let now = model[joint].transform_point(Point::new(0.1, 0.2, 0.3));
        assert!(skinning[joint].transform_point(bound).distance_to_point(now) < 1e-11);
    }
    let error = skinning_motors(&skeleton, &model[..3], &mut skinning).unwrap_err();
    assert_eq!(error.to_string(), "expected 12 motors in `model`, one for each joint, found 3");
}

#[test]
fn bind_poses_are_checked() {
    let (skeleton, _) = Skeleton::from_parents(listed(&[None, Some(0)])).unwrap();
    let error = |binds: &[Motor<f64>]| skeleton.clone().with_inv_bind_poses(binds).unwrap_err().to_string();
    let good = Motor::IDENTITY;
    assert_eq!(error(&[good]), "expected 2 motors in `inv_bind_poses`, one for each joint, found 1");
    let message = "joint 1 `j1`: expected a finite motor, found a NaN or an infinity";
    assert_eq!(error(&[good, Motor { e01: f64::NAN, ..good }]), message);
    assert_eq!(
        error(&[good, Motor { s: 0.5, ..good }]),
        "joint 1 `j1`: expected a unit motor, found one that is not rigid"
    );
}

#[test]
fn instances_and_clips_of_other_skeletons_are_refused() {
    let (small, _) = Skeleton::from_parents(listed(&[None])).unwrap();
    let (large, _) = Skeleton::from_parents(listed(&[None, Some(0)])).unwrap();
    let mut instance = SkeletonInstance::new(&large, Motor::IDENTITY);
    let before = instance.clone();
    let error = animate_keyframe(&small, &mut instance, small.rest_pose()).unwrap_err();
    assert_eq!(error.to_string(), "expected 1 motors in `joint_positions`, one for each joint, found 2");
    let error = animate_keyframe(&large, &mut instance, small.rest_pose()).unwrap_err();
    assert_eq!(error.to_string(), "expected 2 motors in `locals`, one for each joint, found 1");
    let clip = Clip::new(1, vec![0.0], vec![Motor::IDENTITY]).unwrap();
    let mut scratch = [Motor::IDENTITY; 2];
    let mut sample = |skeleton, scratch: &mut [Motor<f64>], time| {
        animate_sample(skeleton, &mut instance, &clip, time, Interpolation::Nlerp, Wrap::Clamp, scratch).unwrap_err()
    };
    let error = sample(&large, &mut scratch, 0.0);
    assert_eq!(error.to_string(), "expected a clip of 2 joints, as many as the skeleton has, found 1");
    assert_eq!(sample(&small, &mut scratch, 0.0), ClipError::JointCount { expected: 1, found: 2 });
    assert_eq!(instance, before);
}
