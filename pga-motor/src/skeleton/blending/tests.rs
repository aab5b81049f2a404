use alloc::string::ToString;
use alloc::vec;
use alloc::vec::Vec;

use super::*;
use crate::{Direction, Rotor, Translator};

type M = Motor<f64>;

fn turned(angle: f64) -> M {
    Rotor::about_z(angle).into()
}

fn posed(x: f64, angle: f64) -> M {
    Translator::from_vector(Direction::new(x, 1.0, 0.0)) * Rotor::about_x(angle)
}

/// Two joints at rest at the origin.
fn skeleton() -> Skeleton<f64> {
    Skeleton::from_parents([("a", None, M::IDENTITY), ("b", Some(0), M::IDENTITY)]).unwrap().0
}

fn blended(layers: &[Layer<'_, f64>], threshold: f64) -> Vec<M> {
    let mut out = vec![M::IDENTITY; 2];
    blend_poses(&skeleton(), layers, threshold, &mut out).unwrap();
    out
}

/// A few roundings of numbers of size 1.
fn assert_near(found: M, expected: M) {
    assert!((found - expected).norm() + (found - expected).ideal_norm() < 1e-14, "{found} instead of {expected}");
}

#[test]
fn the_order_and_the_signs_of_layers_do_not_matter() {
    let poses = [[posed(1.0, 0.3), turned(2.8)], [posed(-2.0, 2.0), turned(-2.9)], [posed(0.5, -1.5), turned(1.0)]];
    let negated = poses.map(|pose| pose.map(|motor| -motor));
    let weights = [0.5, 0.2, 0.7];
    let layers = |order: [usize; 3]| order.map(|i| Layer::new(&poses[i], weights[i]));
    let expected = blended(&layers([0, 1, 2]), 0.0);
    for order in [[0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]] {
        for (found, &expected) in blended(&layers(order), 0.0).into_iter().zip(&expected) {
            assert_near(found, expected);
        }
    }
    for flipped in 0..3 {
        let mut layers = layers([0, 1, 2]);
        layers[flipped].pose = &negated[flipped];
        for (found, &expected) in blended(&layers, 0.0).into_iter().zip(&expected) {
            let found = if (found + expected).norm() < 1.0 { -found } else { found };
            assert_near(found, expected);
        }
    }
}

#[test]
fn only_the_proportions_of_weights_above_the_threshold_matter() {
    let poses = [[turned(0.2); 2], [turned(1.0); 2]];
    for scale in [1e-300, 0.5, 3.0, 1e300] {
        let layers = [Layer::new(&poses[0], scale), Layer::new(&poses[1], scale)];
        blended(&layers, 0.0).into_iter().for_each(|found| assert_near(found, turned(0.6)));
    }
}

#[test]
fn below_the_threshold_the_rest_pose_counts_for_what_is_missing() {
    let pose = [turned(1.0); 2];
    let half = blended(&[Layer::new(&pose, 0.05)], 0.1);
    assert_near(half[0], turned(0.5));
    let none = blended(&[Layer::new(&pose, 0.0)], 0.1);
    assert_eq!(none, [M::IDENTITY; 2]);
    assert_eq!(blended(&[], 0.0), [M::IDENTITY; 2]);
    assert_eq!(blended(&[Layer::new(&pose, 0.1)], 0.1), pose);
}

#[test]
fn joints_that_a_layer_does_not_move_are_not_looked_at() {
    let nothing = M { s: f64::NAN, ..M::IDENTITY };
    let (body, arm) = ([turned(0.3), turned(0.1)], [nothing, turned(0.5)]);
    let layers = [Layer::new(&body, 1.0), Layer::new(&arm, 2.0).with_joint_weights(&[0.0, 0.5])];
    let found = blended(&layers, 0.1);
    assert_near(found[0], turned(0.3));
    assert_near(found[1], turned(0.3));
}

#[test]
fn a_deviation_acts_first_in_the_joints_own_frame() {
    let (reference, pose) = ([posed(1.0, 0.4)], [posed(3.0, 1.4)]);
    let mut deviation = [M::IDENTITY];
    deviation_into(&reference, &pose, &mut deviation).unwrap();
    let mut found = reference;
    add_layers(&[Layer::new(&deviation, 1.0)], &mut found).unwrap();
    assert_near(found[0], pose[0]);
    // On top of another pose: its own motor last, on the left.
    let other = posed(-2.0, -1.0);
    let mut found = [other];
    add_layers(&[Layer::new(&deviation, 1.0)], &mut found).unwrap();
    assert_near(found[0], other * (reference[0].reverse() * pose[0]));
    assert!((found[0] - (reference[0].reverse() * pose[0]) * other).norm() + (found[0] - pose[0]).norm() > 0.1);
    // Taken away again.
    add_layers(&[Layer::new(&deviation, -1.0)], &mut found).unwrap();
    assert_near(found[0], other);
    // Half of it twice is all of it.
    add_layers(&[Layer::new(&deviation, 0.5), Layer::new(&deviation, 0.5)], &mut found).unwrap();
    assert_near(found[0], other * deviation[0]);
}

#[test]
fn a_masked_deviation_leaves_the_other_joints_alone() {
    let deviation = [turned(1.0), M { s: f64::INFINITY, ..M::IDENTITY }];
    let mut pose = [turned(0.5), turned(0.5)];
    add_layers(&[Layer::new(&deviation, 1.0).with_joint_weights(&[1.0, 0.0])], &mut pose).unwrap();
    assert_near(pose[0], turned(1.5));
    assert_eq!(pose[1], turned(0.5));
}

#[test]
fn faults_are_named_and_leave_the_result_alone() {
    let untouched = [M { s: 7.0, ..M::IDENTITY }; 2];
    let pose = [M::IDENTITY; 2];
    let error = |layers: &[Layer<'_, f64>], threshold: f64| {
        let mut out = untouched;
        let error = blend_poses(&skeleton(), layers, threshold, &mut out).unwrap_err();
        assert_eq!(out, untouched);
        error.to_string()
    };
    let good = Layer::new(&pose, 1.0);
    let message = "expected a finite threshold from 0 up, found another";
    assert_eq!(error(&[good], f64::NAN), message);
    assert_eq!(error(&[good], -0.1), message);
    let message = "layer 1: expected 2 entries, one for each joint, found 1";
    assert_eq!(error(&[good, Layer::new(&pose[..1], 1.0)], 0.0), message);
    assert_eq!(error(&[good, good.with_joint_weights(&[1.0])], 0.0), message);
    let message = "layer 1: expected a finite weight from 0 up, found another";
    for weight in [-1.0, f64::NAN, f64::INFINITY] {
        assert_eq!(error(&[good, Layer::new(&pose, weight)], 0.0), message);
    }
    let message = "layer 0, joint 1: expected a finite weight from 0 up, found another";
    for weight in [-1.0, f64::NAN, f64::INFINITY] {
        assert_eq!(error(&[good.with_joint_weights(&[1.0, weight])], 0.0), message);
        // A layer of no weight is checked all the same.
        assert_eq!(error(&[Layer::new(&pose, 0.0).with_joint_weights(&[1.0, weight])], 0.0), message);
    }
    let broken = [M::IDENTITY, M { e01: f64::NAN, ..M::IDENTITY }];
    let message = "layer 1, joint 1: expected a finite motor, found a NaN or an infinity";
    assert_eq!(error(&[good, Layer::new(&broken, 0.5)], 0.0), message);
    let mut short = [M::IDENTITY; 1];
    let error = blend_poses(&skeleton(), &[good], 0.0, &mut short).unwrap_err();
    assert_eq!(error.to_string(), "expected 2 motors in the result, one for each joint, found 1");

    let mut out = untouched;
    let error = add_layers(&[good, Layer::new(&pose, f64::NAN)], &mut out).unwrap_err();
    assert_eq!((error, out), (BlendError::Weight { layer: Some(1), joint: None }, untouched));
    let error = deviation_into(&pose, &pose[..1], &mut out).unwrap_err();
    assert_eq!((error, out), (BlendError::Length { layer: Some(1), expected: 2, found: 1 }, untouched));
}
