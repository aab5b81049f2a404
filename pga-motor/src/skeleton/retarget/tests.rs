use alloc::vec;

use super::*;
use crate::Point;

type M = Motor<f64>;

fn by(x: f64, y: f64, z: f64) -> M {
    Translator::from_vector(Direction::new(x, y, z)).into()
}

/// A hip with a leg and an arm, times a size, whose joints' frames are turned by `frame`.
fn figure(size: f64, frame: impl Fn(usize) -> Rotor<f64>) -> Skeleton<f64> {
    let places = [
        ("hip", None, [0.0, 9.0, 0.0]),
        ("knee", Some(0), [0.0, 5.0, 0.5]),
        ("foot", Some(1), [0.0, 1.0, 0.0]),
        ("arm", Some(0), [2.0, 12.0, 0.0]),
    ];
    let model = |joint: usize| {
        let [x, y, z] = places[joint].2.map(|length: f64| length * size);
        by(x, y, z) * frame(joint)
    };
    let joints = places.iter().enumerate().map(|(joint, &(name, parent, _))| {
        (name, parent, parent.map_or(model(joint), |parent: usize| model(parent).reverse() * model(joint)))
    });
    Skeleton::from_parents(joints).unwrap().0
}

/// The figure's joints each turned, and displaced, from rest.
fn posed(skeleton: &Skeleton<f64>, size: f64) -> Vec<M> {
    let moves = [by(1.0, -0.5, 0.2), by(0.0, 0.1, 0.0), by(0.0, 0.0, 0.0), by(0.0, 0.0, 0.3)];
    let turns = [Rotor::about_x(0.4), Rotor::about_z(-1.0), Rotor::about_x(0.3), Rotor::about_y(2.0)];
    let rests = skeleton.rest_pose().iter();
    let scaled = |motor: M| M::from(Translator::from_vector(motor.translator().vector() * size));
    rests.zip(moves.iter().zip(turns)).map(|(&rest, (&step, turn))| scaled(step) * rest * turn).collect()
}

fn places(skeleton: &Skeleton<f64>, pose: &[M]) -> Vec<Point<f64>> {
    let mut model = vec![M::IDENTITY; skeleton.len()];
    local_to_model(skeleton, pose, &mut model).unwrap();
    model.iter().map(|motor| motor.transform_origin()).collect()
}

/// A few products of motors with lengths up to 40.
fn assert_near(found: &[Point<f64>], expected: &[Point<f64>]) {
    for (found, &expected) in found.iter().zip(expected) {
        assert!(found.distance_to_point(expected) < 1e-12, "{found} instead of {expected}");
    }
}

#[test]
fn the_same_skeleton_keeps_the_pose() {
    let skeleton = figure(1.0, |_| Rotor::about_y(0.3));
    let pose = posed(&skeleton, 1.0);
    let mut retarget = Retarget::new(&skeleton, &skeleton);
    assert_eq!(retarget.unmatched(), &Unmatched::default());
    let mut out = vec![M::IDENTITY; 4];
    retarget.pose_into(&pose, &mut out).unwrap();
    assert_near(&places(&skeleton, &out), &places(&skeleton, &pose));
    for (found, expected) in out.iter().zip(&pose) {
        assert!((*found - *expected).norm().min((*found + *expected).norm()) < 1e-14);
    }
}

#[test]
fn a_skeleton_three_times_as_large_gets_three_times_as_far() {
    let plain = |_| Rotor::IDENTITY;
    let (small, large) = (figure(1.0, plain), figure(3.0, plain));
    let mut out = vec![M::IDENTITY; 4];
    Retarget::new(&small, &large).pose_into(&posed(&small, 1.0), &mut out).unwrap();
    let expected: Vec<_> =
        places(&small, &posed(&small, 1.0)).iter().map(|p| Point::new(3.0 * p.x, 3.0 * p.y, 3.0 * p.z)).collect();
    assert_near(&places(&large, &out), &expected);
}

#[test]
fn the_axes_of_the_frames_do_not_matter() {
    let plain = figure(1.0, |_| Rotor::IDENTITY);
    let other = figure(1.0, |joint| Rotor::about_x(0.7 * joint as f64) * Rotor::about_z(1.1 + joint as f64));
    let mut out = vec![M::IDENTITY; 4];
    Retarget::new(&plain, &other).pose_into(&posed(&plain, 1.0), &mut out).unwrap();
    assert_near(&places(&other, &out), &places(&plain, &posed(&plain, 1.0)));
}

#[test]
fn each_bone_has_its_own_proportion() {
    let leg = |thigh: f64, shin: f64| {
        let joints = [
            ("hip", None, by(0.0, 0.0, 0.0)),
            ("knee", Some(0), by(0.0, thigh, 0.0)),
            ("foot", Some(1), by(0.0, shin, 0.0)),
        ];
        Skeleton::from_parents(joints).unwrap().0
    };
    let (source, target) = (leg(2.0, 2.0), leg(6.0, 1.0));
    // Each joint is displaced by 1 along x, the hip too.
    let pose: Vec<M> = source.rest_pose().iter().map(|&rest| by(1.0, 0.0, 0.0) * rest).collect();
    let mut out = vec![M::IDENTITY; 3];
    Retarget::new(&source, &target).pose_into(&pose, &mut out).unwrap();
    let steps: Vec<f64> = out.iter().map(|motor| motor.transform_origin().x).collect();
    // The hip by the ratio of both bones together, 7/4.
    for (step, expected) in steps.into_iter().zip([1.75, 3.0, 0.5]) {
        assert!((step - expected).abs() < 1e-15);
    }
}

#[test]
fn joints_without_a_namesake_are_reported_and_rest() {
    let rest = by(0.0, 1.0, 0.0);
    let source = [
        ("hip", None, rest),
        ("spine", Some(0), rest),
        ("neck", Some(1), rest),
        ("", Some(0), rest),
        ("twin", Some(0), rest),
        ("twin", Some(0), rest),
    ];
    let target =
        [("hip", None, rest), ("neck", Some(0), by(0.0, 4.0, 0.0)), ("hat", Some(1), rest), ("", Some(0), rest)];
    let (source, target) = (Skeleton::from_parents(source).unwrap().0, Skeleton::from_parents(target).unwrap().0);
    let mut retarget = Retarget::new(&source, &target);
    let names = |names: &[(usize, &str)]| names.iter().map(|&(joint, name)| (joint, String::from(name))).collect();
    let expected = Unmatched {
        source: names(&[(1, "spine"), (3, ""), (4, "twin"), (5, "twin")]),
        target: names(&[(2, "hat"), (3, "")]),
        repeated: ["twin".into()].into(),
    };
    assert_eq!(retarget.unmatched(), &expected);

    // The spine, which the target lacks, bends by a quarter turn: the neck turns as far, as the spine takes it along, and gets from
    // (0, 2) above the hip to (-1, 1). The target's is 4 above the hip, twice as much.
    let mut pose = source.rest_pose().clone();
    pose[1] = pose[1] * Rotor::about_z(core::f64::consts::FRAC_PI_2);
    let mut out = vec![M::IDENTITY; 4];
    retarget.pose_into(&pose, &mut out).unwrap();
    assert_near(&places(&target, &out)[1..2], &[Point::new(-2.0, 1.0 + 2.0, 0.0)]);
    let turned = M::from(Rotor::about_z(core::f64::consts::FRAC_PI_2));
    assert!((M::from(out[1].rotor()) - turned).norm() < 1e-15);
    assert_eq!((out[2], out[3]), (rest, rest));
}

#[test]
fn what_a_joint_above_all_does_reaches_the_joints_of_the_same_names() {
    let up = by(0.0, 2.0, 0.0);
    let source = [("armature", None, M::IDENTITY), ("hips", Some(0), up), ("head", Some(1), up)];
    let target = [("hips", None, up), ("neck", Some(0), by(0.0, 1.0, 0.0)), ("head", Some(1), by(0.0, 1.0, 0.0))];
    let (source, target) = (Skeleton::from_parents(source).unwrap().0, Skeleton::from_parents(target).unwrap().0);
    let pose = [by(5.0, 0.0, 1.0) * Rotor::about_z(1.0), up, up * Rotor::about_x(0.5)];
    let mut out = vec![M::IDENTITY; 3];
    Retarget::new(&source, &target).pose_into(&pose, &mut out).unwrap();
    let (found, expected) = (places(&target, &out), places(&source, &pose));
    assert_near(&[found[0], found[2]], &[expected[1], expected[2]]);
}

/// Of a bone of no length, differences of places would make one of 1e-16.
#[test]
fn a_bone_of_no_length_takes_the_ratio_of_all() {
    let turn = Rotor::about_x(0.7) * Rotor::about_z(1.1);
    let figure = |size: f64, twist: f64| {
        let root = by(1.3, 2.7, 0.9) * turn;
        let joints = [
            ("root", None, root),
            ("spine", Some(0), by(0.0, size, 0.1) * turn),
            ("twist", Some(1), by(twist, 0.0, 0.0) * Rotor::about_y(0.4)),
        ];
        Skeleton::from_parents(joints).unwrap().0
    };
    for (from, to) in [(0.0, 0.5), (0.5, 0.0), (0.0, 0.0)] {
        let (source, target) = (figure(1.0, from), figure(1.0, to));
        let mut pose = source.rest_pose().clone();
        pose[2] = by(0.001, 0.0, 0.0) * pose[2];
        let mut out = vec![M::IDENTITY; 3];
        Retarget::new(&source, &target).pose_into(&pose, &mut out).unwrap();
        let step = out[2].transform_origin().x - to;
        assert!((step - 0.001).abs() < 1e-15, "{step}");
    }
}

#[test]
fn what_holds_is_held_unless_a_joint_in_between_moves_it() {
    let up = by(0.0, 1.0, 0.0);
    let source = [("hip", None, up), ("spine", Some(0), up), ("neck", Some(1), up), ("head", Some(2), up)];
    let target = [("hip", None, up), ("neck", Some(0), up), ("head", Some(1), up)];
    let (source, target) = (Skeleton::from_parents(source).unwrap().0, Skeleton::from_parents(target).unwrap().0);
    let step = JointModes { rotation: KeyMode::Step, translation: KeyMode::Step };
    let linear_turn = JointModes { rotation: KeyMode::Linear, translation: KeyMode::Step };
    let clip =
        Clip::new(4, vec![0.0], source.rest_pose().to_vec()).unwrap().with_modes(vec![step, linear_turn, step, step]);
    let carried = Retarget::new(&source, &target).clip(&clip.unwrap()).unwrap();
    assert_eq!(carried.modes(), [step, JointModes::default(), step]);
}

#[test]
fn a_clip_keeps_its_name_times_and_modes() {
    let (small, large) = (figure(1.0, |_| Rotor::IDENTITY), figure(2.0, |_| Rotor::about_x(0.5)));
    let mut keys = small.rest_pose().to_vec();
    keys.extend(posed(&small, 1.0));
    let mut modes = vec![JointModes::default(); 4];
    modes[2].rotation = KeyMode::Step;
    let clip = Clip::new(4, vec![0.5, 2.0], keys.clone()).unwrap().with_modes(modes.clone()).unwrap().with_name("kick");
    let mut retarget = Retarget::new(&small, &large);
    let carried = retarget.clip(&clip).unwrap();
    assert_eq!((carried.name(), carried.times(), carried.modes()), ("kick", clip.times(), &modes[..]));
    let mut out = vec![M::IDENTITY; 4];
    retarget.pose_into(&keys[4..], &mut out).unwrap();
    assert_near(&places(&large, carried.key(1).unwrap()), &places(&large, &out));
    let other = Clip::new(3, vec![0.0], vec![M::IDENTITY; 3]).unwrap();
    assert_eq!(retarget.clip(&other).unwrap_err(), ClipError::JointCount { what: "clip", expected: 4, found: 3 });
}

#[test]
fn buffers_of_another_length_are_refused() {
    let skeleton = figure(1.0, |_| Rotor::IDENTITY);
    let mut retarget = Retarget::new(&skeleton, &skeleton);
    let untouched = [M { s: 7.0, ..M::IDENTITY }; 4];
    let mut out = untouched;
    let error = retarget.pose_into(&[M::IDENTITY; 3], &mut out).unwrap_err();
    assert_eq!(error, SkeletonError::PoseLength { buffer: "pose", expected: 4, found: 3 });
    let error = retarget.pose_into(&[M::IDENTITY; 4], &mut out[..2]).unwrap_err();
    assert_eq!(error, SkeletonError::PoseLength { buffer: "out", expected: 4, found: 2 });
    assert_eq!(out, untouched);
}
