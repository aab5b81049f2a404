//! Crowds against one character after the other.

use alloc::string::ToString;
use alloc::vec;
use alloc::vec::Vec;

use super::*;
use crate::batch::{InstructionSet, with_instruction_set};
use crate::skeleton::{JointModes, KeyMode, local_to_model};
use crate::{Direction, Rotor, Translator};

const JOINTS: usize = 7;

fn motor<T: Real>(index: usize) -> Motor<T> {
    let angle = T::from_f64(0.37 * index as f64);
    let (sin, cos) = angle.sin_cos();
    let rotor = Rotor::about_z(angle) * Rotor::about_y(sin) * Rotor::about_x(cos);
    Translator::from_vector(Direction::new(sin, cos, T::ONE)) * rotor
}

/// Two chains and a joint of its own.
fn skeleton<T: Real>() -> Skeleton<T> {
    let parents = [None, Some(0), Some(1), Some(0), Some(3), Some(4), None];
    let joints = parents.into_iter().enumerate().map(|(joint, parent)| (joint.to_string(), parent, motor(joint)));
    Skeleton::from_parents(joints).unwrap().0
}

fn clip<T: Real>(keys: usize) -> Clip<T> {
    let times = (0..keys).map(|key| T::from_f64(key as f64 * 0.5)).collect();
    Clip::new(JOINTS, times, (0..keys * JOINTS).map(motor).collect()).unwrap()
}

/// Chains of three products and an interpolation: 4 kernels of at most 30.3 u each on numbers up to 8, and as much for what they are
/// compared with.
fn assert_near<T: Real + core::fmt::Debug>(found: Motor<T>, expected: Motor<T>) {
    let tolerance = T::from_f64(4.0 * 30.3 * 8.0) * T::EPSILON;
    assert!((found - expected).norm() <= tolerance, "{found:?} and {expected:?}");
    assert!((found - expected).ideal_norm() <= tolerance, "{found:?} and {expected:?}");
}

fn crowds_are_as_single_characters<T: Real + core::fmt::Debug>() {
    let skeleton = skeleton::<T>();
    let modes = |rotation, translation| JointModes { rotation, translation };
    let mixed = clip::<T>(6)
        .with_modes(vec![
            modes(KeyMode::Linear, KeyMode::Linear),
            modes(KeyMode::Step, KeyMode::Linear),
            modes(KeyMode::Linear, KeyMode::Step),
            modes(KeyMode::Step, KeyMode::Step),
            modes(KeyMode::Linear, KeyMode::Linear),
            modes(KeyMode::Linear, KeyMode::Linear),
            modes(KeyMode::Linear, KeyMode::Linear),
        ])
        .unwrap();
    for clip in [clip(1), clip(2), clip(6), mixed] {
        for characters in [0, 1, 15, 16, 17, 40] {
            let times: Vec<T> = (0..characters).map(|i| T::from_f64(0.11 * i as f64 - 0.3)).collect();
            for (interpolation, wrap) in
                Interpolation::ALL.into_iter().flat_map(|way| [(way, Wrap::Clamp), (way, Wrap::Loop)])
            {
                for set in InstructionSet::ALL {
                    with_instruction_set(set, || {
                        let mut crowd = Poses::new(JOINTS, characters);
                        crowd.animate(&skeleton, &clip, &times, interpolation, wrap).unwrap();
                        let mut locals = Poses::new(JOINTS, characters);
                        locals.sample(&clip, &times, interpolation, wrap).unwrap();
                        let mut models = Poses::new(JOINTS, characters);
                        locals.local_to_model_into(&skeleton, &mut models).unwrap();
                        let mut made = locals.clone();
                        made.make_model(&skeleton).unwrap();
                        assert_eq!(made, models);
                        for (character, &time) in times.iter().enumerate() {
                            let (mut pose, mut model) = (vec![Motor::IDENTITY; JOINTS], vec![Motor::IDENTITY; JOINTS]);
                            clip.sample_into(time, interpolation, wrap, &mut pose).unwrap();
                            local_to_model(&skeleton, &pose, &mut model).unwrap();
                            for joint in 0..JOINTS {
                                assert_near(locals.get(character, joint).unwrap(), pose[joint]);
                                assert_near(crowd.get(character, joint).unwrap(), model[joint]);
                                assert_near(models.get(character, joint).unwrap(), model[joint]);
                            }
                        }
                    });
                }
            }
        }
    }
}

crate::precision::in_both_precisions! {
    crowds_agree: crowds_are_as_single_characters;
}

#[test]
fn a_crowd_can_start_in_one_pose() {
    let pose = [motor(1), motor(2), motor(3)];
    let crowd = Poses::<f64>::filled(&pose, 20);
    assert!((0..20).all(|character| (0..3).all(|joint| crowd.get(character, joint) == Some(pose[joint]))));
    assert_eq!(alloc::format!("{crowd:?}"), "Poses { joint_count: 3, len: 20, .. }");
}

#[test]
#[should_panic(expected = "capacity overflow")]
fn a_crowd_that_no_memory_holds_is_refused() {
    Poses::<f32>::new(1 << 63, 32);
}

#[test]
fn poses_are_read_and_written_one_by_one() {
    let mut crowd = Poses::<f32>::new(3, 20);
    assert_eq!((crowd.joint_count(), crowd.len(), crowd.is_empty()), (3, 20, false));
    // Two groups of 16 characters, 3 joints, 8 numbers of 4 bytes.
    assert_eq!(crowd.size_in_bytes(), 2 * 16 * 3 * 8 * 4);
    let pose = [motor(1), motor(2), motor(3)];
    crowd.set_pose(17, &pose).unwrap();
    let mut found = [Motor::IDENTITY; 3];
    crowd.pose_into(17, &mut found).unwrap();
    assert_eq!(found, pose);
    assert_eq!(crowd.replace(17, 2, motor(9)), Some(motor(3)));
    assert_eq!((crowd.get(17, 2), crowd.get(16, 2)), (Some(motor(9)), Some(Motor::IDENTITY)));
    assert_eq!((crowd.get(20, 0), crowd.get(0, 3), crowd.replace(20, 0, motor(1))), (None, None, None));
    assert_eq!(crowd.pose_into(20, &mut found), Err(PosesError::NoSuchCharacter { character: 20, len: 20 }));
    assert_eq!(crowd.set_pose(3, &pose[..2]), Err(PosesError::Joints { expected: 3, found: 2 }));
}

#[test]
fn what_does_not_fit_is_refused_and_nothing_changed() {
    let (skeleton, clip) = (skeleton::<f64>(), clip::<f64>(2));
    let (way, wrap) = (Interpolation::Split, Wrap::Clamp);
    let mut crowd = Poses::new(JOINTS, 2);
    assert_eq!(crowd.sample(&clip, &[0.1], way, wrap), Err(PosesError::Characters { expected: 2, found: 1 }));
    assert_eq!(
        crowd.animate(&skeleton, &clip, &[0.1, f64::NAN], way, wrap).unwrap_err().to_string(),
        "character 1: expected a finite time to sample at, found a NaN or an infinity"
    );
    let mut few = Poses::<f64>::new(JOINTS - 1, 2);
    let error = PosesError::Joints { expected: JOINTS - 1, found: JOINTS };
    assert_eq!(few.make_model(&skeleton), Err(error.clone()));
    assert_eq!(few.sample(&clip, &[0.1, 0.2], way, wrap), Err(error));
    assert_eq!(
        crowd.local_to_model_into(&skeleton, &mut few),
        Err(PosesError::Joints { expected: JOINTS, found: JOINTS - 1 })
    );
    assert_eq!(
        crowd.local_to_model_into(&skeleton, &mut Poses::new(JOINTS, 3)),
        Err(PosesError::Characters { expected: 2, found: 3 })
    );
    assert!((0..JOINTS).all(|joint| crowd.get(1, joint) == Some(Motor::IDENTITY)));
}

#[cfg(feature = "rayon")]
#[test]
fn threads_change_nothing() {
    let (skeleton, clip) = (skeleton::<f32>(), clip::<f32>(6));
    let times: Vec<f32> = (0..100).map(|i| 0.07 * i as f32).collect();
    let (mut one, mut many) = (Poses::new(JOINTS, 100), Poses::new(JOINTS, 100));
    one.animate(&skeleton, &clip, &times, Interpolation::Screw, Wrap::Loop).unwrap();
    many.animate_in_parallel(&skeleton, &clip, &times, Interpolation::Screw, Wrap::Loop).unwrap();
    for (character, joint) in (0..100).flat_map(|character| (0..JOINTS).map(move |joint| (character, joint))) {
        assert_eq!(one.get(character, joint), many.get(character, joint));
    }
}
