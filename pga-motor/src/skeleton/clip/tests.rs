use alloc::string::ToString;
use alloc::vec;

use super::*;
use crate::{Direction, Rotor, Translator};

type M = Motor<f64>;

fn raised(height: f64, angle: f64) -> M {
    Translator::from_vector(Direction::new(0.0, 0.0, height)) * Rotor::about_x(angle)
}

/// Two joints, three keys at 1, 2 and 4 seconds.
fn clip() -> Clip<f64> {
    let keys =
        vec![M::IDENTITY, raised(1.0, 0.5), raised(2.0, 1.0), raised(3.0, 2.0), raised(6.0, -1.0), raised(0.0, 3.0)];
    Clip::new(2, vec![1.0, 2.0, 4.0], keys).unwrap()
}

fn sample(clip: &Clip<f64>, time: f64, interpolation: Interpolation, wrap: Wrap) -> Vec<M> {
    let mut pose = vec![M::IDENTITY; clip.joint_count()];
    clip.sample_into(time, interpolation, wrap, &mut pose).unwrap();
    pose
}

/// A few roundings of coefficients below 10.
fn assert_near(found: M, expected: M) {
    let apart = (found - expected).norm() + (found - expected).ideal_norm();
    assert!(apart < 1e-14, "{found} instead of {expected}");
}

#[test]
fn keys_around_any_time_are_found() {
    let clip = clip();
    let around = |time| {
        let span = clip.keys_around(time);
        (span.before, span.after, span.fraction)
    };
    assert_eq!(around(-7.0), (0, 0, 0.0));
    assert_eq!(around(1.0), (0, 1, 0.0));
    assert_eq!(around(1.75), (0, 1, 0.75));
    assert_eq!(around(2.0), (1, 2, 0.0));
    assert_eq!(around(2.5), (1, 2, 0.25));
    assert_eq!(around(4.0), (2, 2, 0.0));
    assert_eq!(around(f64::MAX), (2, 2, 0.0));
    assert_eq!(around(f64::NAN), (0, 0, 0.0));
    // The last number before a key does not reach it, though the quotient rounds to 1.
    let (before, after, fraction) = around(4.0_f64.next_down());
    assert_eq!((before, after), (1, 2));
    assert!(fraction < 1.0);
}

#[test]
fn times_may_be_farther_apart_than_numbers_go_and_as_near_as_they_go() {
    let clip = Clip::new(1, vec![-f64::MAX, f64::MAX], vec![M::IDENTITY; 2]).unwrap();
    assert_eq!(clip.keys_around(0.0).fraction, 0.5);
    let clip = Clip::new(1, vec![0.0, f64::from_bits(1)], vec![M::IDENTITY; 2]).unwrap();
    assert_eq!(clip.keys_around(0.0).fraction, 0.0);
}

#[test]
fn each_interpolation_is_that_of_motors() {
    let clip = clip();
    type Way = fn(M, M, f64) -> M;
    let ways: [(Interpolation, Way); 5] = [
        (Interpolation::Step, |a, _, _| a),
        (Interpolation::Nlerp, M::nlerp),
        (Interpolation::Slerp, M::slerp),
        (Interpolation::Screw, M::screw_lerp),
        (Interpolation::Split, M::split_lerp),
    ];
    assert_eq!(ways.map(|(interpolation, _)| interpolation), Interpolation::ALL);
    for (interpolation, way) in ways {
        let (a, b) = (clip.key(1).unwrap(), clip.key(2).unwrap());
        let expected = [way(a[0], b[0], 0.25), way(a[1], b[1], 0.25)];
        for (found, expected) in sample(&clip, 2.5, interpolation, Wrap::Clamp).into_iter().zip(expected) {
            assert_near(found, expected);
        }
        assert_eq!(sample(&clip, 2.0, interpolation, Wrap::Clamp), a);
        assert_eq!(sample(&clip, 0.0, interpolation, Wrap::Clamp), clip.key(0).unwrap());
        assert_eq!(sample(&clip, 9.0, interpolation, Wrap::Clamp), b);
    }
}

#[test]
fn a_loop_goes_on_before_and_after() {
    let clip = clip();
    // The clip is 3 seconds long.
    for turns in [-2.0, -1.0, 1.0, 5.0] {
        for time in [1.0, 1.5, 2.0, 3.75] {
            let again = sample(&clip, time + 3.0 * turns, Interpolation::Screw, Wrap::Loop);
            assert_eq!(again, sample(&clip, time, Interpolation::Screw, Wrap::Clamp));
        }
    }
    assert_eq!(sample(&clip, 4.0, Interpolation::Screw, Wrap::Loop), clip.key(0).unwrap());
}

#[test]
fn a_clip_of_one_key_is_constant() {
    let clip = Clip::new(1, vec![3.0], vec![raised(1.0, 0.5)]).unwrap();
    assert_eq!(clip.duration(), 0.0);
    for time in [-1e300, 0.0, 3.0, 8.0] {
        for wrap in [Wrap::Clamp, Wrap::Loop] {
            for interpolation in Interpolation::ALL {
                assert_eq!(sample(&clip, time, interpolation, wrap), clip.key(0).unwrap());
            }
        }
    }
}

#[test]
fn neighbouring_keys_get_the_same_sign() {
    let turn = |angle: f64| M::from(Rotor::about_z(angle));
    let clip = Clip::new(1, vec![0.0, 1.0, 2.0], vec![turn(1.0), -turn(1.2), turn(1.4)]).unwrap();
    assert_eq!(clip.key(1).unwrap(), [turn(1.2)]);
    assert_eq!(clip.key(2).unwrap(), [turn(1.4)]);
}

#[test]
fn keys_that_are_a_little_off_unit_are_brought_back_and_others_stay_as_they_are() {
    let off = M { s: 1.0002, ..M::IDENTITY };
    assert_eq!(Clip::new(1, vec![0.0], vec![off]).unwrap().key(0).unwrap(), [M::IDENTITY]);
    let product = raised(1e3, 1.0) * raised(2.0, 0.3);
    assert_eq!(Clip::new(1, vec![0.0], vec![product]).unwrap().key(0).unwrap(), [product]);
}

#[test]
fn what_a_joint_holds_is_held_whatever_the_interpolation() {
    let modes = |rotation, translation| JointModes { rotation, translation };
    let all = [
        modes(KeyMode::Linear, KeyMode::Linear),
        modes(KeyMode::Step, KeyMode::Linear),
        modes(KeyMode::Linear, KeyMode::Step),
        modes(KeyMode::Step, KeyMode::Step),
    ];
    let (a, b) = (raised(2.0, 0.4), raised(4.0, 0.8));
    let clip = Clip::new(4, vec![0.0, 1.0], vec![a, a, a, a, b, b, b, b]).unwrap();
    let clip = clip.with_modes(all.to_vec()).unwrap();
    for interpolation in Interpolation::ALL {
        let pose = sample(&clip, 0.5, interpolation, Wrap::Clamp);
        if interpolation == Interpolation::Step {
            assert_eq!(pose, [a; 4]);
        } else {
            let whole = Clip::new(1, vec![0.0, 1.0], vec![a, b]).unwrap();
            assert_eq!(pose[0], sample(&whole, 0.5, interpolation, Wrap::Clamp)[0]);
            assert_near(pose[1], raised(3.0, 0.4));
            assert_near(pose[2], raised(2.0, 0.6));
            assert_eq!(pose[3], a);
        }
        assert_eq!(sample(&clip, 1.0, interpolation, Wrap::Clamp), [b; 4]);
    }
}

#[test]
fn cached_samples_are_the_same() {
    let modes = JointModes { rotation: KeyMode::Linear, translation: KeyMode::Step };
    for clip in [clip(), clip().with_modes(vec![modes, JointModes::default()]).unwrap()] {
        let mut cache = ScrewCache::new(2);
        let mut pose = vec![M::IDENTITY; 2];
        for time in [1.2, 1.7, 1.0, 2.0, 3.0, 3.5, 1.5, -1.0, 8.0] {
            for wrap in [Wrap::Clamp, Wrap::Loop] {
                clip.sample_cached_into(time, wrap, &mut cache, &mut pose).unwrap();
                for (&found, expected) in pose.iter().zip(sample(&clip, time, Interpolation::Screw, wrap)) {
                    assert_near(found, expected);
                }
            }
        }
    }
    // Another clip with keys of the same numbers, and the first joint the same.
    let mut keys: Vec<M> = (0..3).flat_map(|key| clip().key(key).unwrap().to_vec()).collect();
    keys[1] = raised(9.0, 0.1);
    let other = Clip::new(2, vec![1.0, 2.0, 4.0], keys).unwrap();
    let (mut cache, mut pose) = (ScrewCache::new(2), vec![M::IDENTITY; 2]);
    clip().sample_cached_into(1.5, Wrap::Clamp, &mut cache, &mut pose).unwrap();
    other.sample_cached_into(1.5, Wrap::Clamp, &mut cache, &mut pose).unwrap();
    for (&found, expected) in pose.iter().zip(sample(&other, 1.5, Interpolation::Screw, Wrap::Clamp)) {
        assert_near(found, expected);
    }
}

#[test]
fn faults_of_a_clip_are_named() {
    let error =
        |joints, times: &[f64], keys: &[M]| Clip::new(joints, times.to_vec(), keys.to_vec()).unwrap_err().to_string();
    let one = M::IDENTITY;
    assert_eq!(error(0, &[0.0], &[]), "expected at least one joint and one key, found 0 joints and 1 keys");
    assert_eq!(error(2, &[], &[]), "expected at least one joint and one key, found 2 joints and 0 keys");
    assert_eq!(error(2, &[0.0], &[one]), "expected 2 motors, one for each joint in each key, found 1");
    let message = "key 1: expected a finite time, found a NaN or an infinity";
    assert_eq!(error(1, &[0.0, f64::NAN], &[one, one]), message);
    assert_eq!(error(1, &[0.0, f64::INFINITY], &[one, one]), message);
    let message = "key 2: expected a time after that of key 1, found one that is not";
    assert_eq!(error(1, &[0.0, 1.0, 1.0], &[one; 3]), message);
    assert_eq!(error(1, &[0.0, 1.0, 0.5], &[one; 3]), message);
    let with = |motor: M| error(2, &[0.0, 1.0], &[one, one, one, motor]);
    let message = "key 1, joint 1: expected a finite motor, found a NaN or an infinity";
    assert_eq!(with(M { e02: f64::NAN, ..one }), message);
    assert_eq!(with(M { s: f64::NEG_INFINITY, ..one }), message);
    let message = "key 1, joint 1: expected a unit motor, found one whose rotation is zero";
    assert_eq!(with(M { s: 0.0, e01: 1.0, ..one }), message);
    let message = "key 1, joint 1: expected a unit motor, found one that is not rigid";
    assert_eq!(with(M { s: 2.0, ..one }), message);
    assert_eq!(with(M { e0123: 0.1, ..one }), message);
    let error = clip().with_modes(vec![JointModes::default()]).unwrap_err();
    assert_eq!(error.to_string(), "expected 2 pairs of modes, one for each joint, found 1");
}

#[test]
fn faults_of_a_request_are_named_and_leave_the_pose_alone() {
    let clip = clip();
    let untouched = [M { s: 7.0, ..M::IDENTITY }; 3];
    let mut pose = untouched;
    let error = clip.sample_into(1.5, Interpolation::Nlerp, Wrap::Clamp, &mut pose).unwrap_err();
    assert_eq!(error.to_string(), "expected 2 motors in the pose, one for each joint of the clip, found 3");
    for time in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for wrap in [Wrap::Clamp, Wrap::Loop] {
            let error = clip.sample_into(time, Interpolation::Nlerp, wrap, &mut pose[..2]).unwrap_err();
            assert_eq!(error.to_string(), "expected a finite time to sample at, found a NaN or an infinity");
        }
    }
    let error = clip.sample_cached_into(1.5, Wrap::Clamp, &mut ScrewCache::new(1), &mut pose[..2]).unwrap_err();
    assert_eq!(error, ClipError::PoseLength { expected: 2, found: 1 });
    assert_eq!(pose, untouched);
}
