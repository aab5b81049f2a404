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
    let names = |names: &[&str]| names.iter().map(|&name| String::from(name)).collect::<Vec<_>>();
    let expected = Unmatched {
        source: names(&["spine", "", "twin", "twin"]),
        target: names(&["hat", ""]),
        repeated: names(&["twin"]),
    };
    assert_eq!(retarget.unmatched(), &expected);

    // The spine, which the target lacks, bends by a quarter turn: the neck turns as far, as the spine took it along.
    let mut pose = source.rest_pose().clone();
    pose[1] = pose[1] * Rotor::about_z(core::f64::consts::FRAC_PI_2);
    let mut out = vec![M::IDENTITY; 4];
    retarget.pose_into(&pose, &mut out).unwrap();
    assert!((out[1] - by(0.0, 4.0, 0.0) * Rotor::about_z(core::f64::consts::FRAC_PI_2)).norm() < 1e-15);
    assert_eq!((out[2], out[3]), (rest, rest));
}

#[test]
fn a_clip_keeps_its_name_times_and_modes() {
    use crate::skeleton::{JointModes, KeyMode};
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
    assert_eq!(retarget.clip(&other).unwrap_err(), ClipError::JointCount { expected: 4, found: 3 });
}

#[test]
fn buffers_of_another_length_are_refused() {
    let skeleton = figure(1.0, |_| Rotor::IDENTITY);
    let mut retarget = Retarget::new(&skeleton, &skeleton);
    let untouched = [M { s: 7.0, ..M::IDENTITY }; 4];
    let mut out = untouched;
    let error = retarget.pose_into(&[M::IDENTITY; 3], &mut out).unwrap_err();
    assert_eq!(error, SkeletonError::PoseLength { buffer: "locals", expected: 4, found: 3 });
    let error = retarget.pose_into(&[M::IDENTITY; 4], &mut out[..2]).unwrap_err();
    assert_eq!(error, SkeletonError::PoseLength { buffer: "out", expected: 4, found: 2 });
    assert_eq!(out, untouched);
}
