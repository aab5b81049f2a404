//! Channels of all kinds, and what becomes of them.

use alloc::string::ToString;
use alloc::vec::Vec;

use super::builder::{Builder, about_z, assert_near, at};
use crate::import::gltf::{Gltf, parse};
use crate::skeleton::{JointModes, KeyMode};

fn leg() -> Builder {
    Builder::default()
        .node(r#""name": "hip", "children": [1], "translation": [0, 9, 0]"#)
        .node(r#""name": "knee", "translation": [0, -4, 0]"#)
        .node(r#""name": "lamp", "scale": [1, 2, 3]"#)
        .skin("[0, 1]")
}

fn warnings(file: &Gltf<f64>) -> Vec<alloc::string::String> {
    file.warnings().iter().map(ToString::to_string).collect()
}

#[test]
fn channels_with_different_times_meet_in_one_list() {
    let file = leg()
        .channel((0, "rotation"), "LINEAR", &[0.5, 1.5], &[about_z(0.0), about_z(90.0)])
        .channel((1, "translation"), "LINEAR", &[1.0, 3.0], &[[0.0, -4.0, 0.0], [0.0, -8.0, 0.0]])
        .read();
    let clip = &file.clips()[0];
    assert_eq!((clip.name(), clip.times()), ("kick", &[0.5, 1.0, 1.5, 3.0][..]));
    assert_eq!(clip.modes(), [JointModes::default(); 2]);
    // Before the first key and after the last of a channel it keeps what it has there.
    assert_near(at(&file, 0.0)[1], [0.0, 5.0, 0.0]);
    assert_near(at(&file, 0.75)[1], [4.0 * 22.5_f64.to_radians().sin(), 9.0 - 4.0 * 22.5_f64.to_radians().cos(), 0.0]);
    assert_near(at(&file, 2.0)[1], [6.0, 9.0, 0.0]);
    assert_near(at(&file, 9.0)[1], [8.0, 9.0, 0.0]);
    assert_eq!(file.warnings(), []);
}

#[test]
fn steps_hold_until_the_next_key() {
    let file = leg()
        .channel((0, "rotation"), "STEP", &[0.0, 2.0], &[about_z(0.0), about_z(90.0)])
        .channel((0, "translation"), "LINEAR", &[0.0, 3.0], &[[0.0, 9.0, 0.0], [3.0, 9.0, 0.0]])
        .channel((1, "translation"), "STEP", &[0.5, 1.0], &[[0.0, -4.0, 0.0], [0.0, -5.0, 0.0]])
        .read();
    let step = KeyMode::Step;
    let expected = [
        JointModes { rotation: step, translation: KeyMode::Linear },
        // Its rotation stands still, so it may as well hold.
        JointModes { rotation: step, translation: step },
    ];
    assert_eq!(file.clips()[0].modes(), expected);
    assert_near(at(&file, 0.999)[1], [0.999, 5.0, 0.0]);
    assert_near(at(&file, 1.0)[1], [1.0, 4.0, 0.0]);
    assert_near(at(&file, 1.999)[1], [1.999, 4.0, 0.0]);
    assert_near(at(&file, 2.0)[1], [7.0, 9.0, 0.0]);
}

#[test]
fn splines_are_followed_closely_and_by_few_keys() {
    // From rest to rest: the half of the way is gone in the half of the time, 0.15625 of it in a quarter (3 t^2 - 2 t^3).
    let still = [0.0; 3];
    let file = leg()
        .channel(
            (1, "translation"),
            "CUBICSPLINE",
            &[0.0, 1.0],
            &[[9.0; 3], [0.0, -4.0, 0.0], still, still, [8.0, -4.0, 0.0], [9.0; 3]],
        )
        .read();
    for (time, x) in [(0.25, 1.25), (0.5, 4.0), (0.75, 6.75), (0.0, 0.0), (1.0, 8.0)] {
        // The size is 4.
        let found = at(&file, time)[1].x;
        assert!((found - x).abs() <= 4e-4, "{found} at {time}");
    }
    // f'' is 6 * 8 at the ends and 0 in the middle: with 8e-5 of 4 for its only spline, steps of sqrt(8 * 3.2e-4 / 48) and longer.
    let keys = file.clips()[0].key_count();
    assert!((50..=300).contains(&keys), "{keys} keys");
    // Other channels are refined at the same times.
    let both = leg()
        .channel(
            (1, "translation"),
            "CUBICSPLINE",
            &[0.0, 1.0],
            &[[9.0; 3], still, still, still, [8.0, 0.0, 0.0], still],
        )
        .channel(
            (0, "translation"),
            "CUBICSPLINE",
            &[0.1, 0.9],
            &[[9.0; 3], still, still, still, [8.0, 0.0, 0.0], still],
        )
        .read();
    assert!(both.clips()[0].key_count() < 2 * keys, "{} keys", both.clips()[0].key_count());
}

#[test]
fn splines_turn_and_keep_the_signs_of_their_keys() {
    let turned = |degrees: f32, rate: f32| {
        let half = degrees.to_radians() / 2.0;
        [0.0, 0.0, half.cos() * rate / 2.0, -half.sin() * rate / 2.0]
    };
    // A constant rate of 2 radians per second as its tangents.
    let degrees = 2.0_f32.to_degrees();
    let values = [turned(0.0, 2.0), about_z(0.0), turned(0.0, 2.0), turned(degrees, 2.0), about_z(degrees), [0.0; 4]];
    let file = leg().channel((0, "rotation"), "CUBICSPLINE", &[0.0, 1.0], &values).read();
    for time in [0.1, 0.3, 0.5, 0.77] {
        // Hermite's cubic, made unit.
        let (t, t2, t3) = (time, time * time, time * time * time);
        let hermite = |i: usize| {
            let [a, m, n, b] = [1, 2, 3, 4].map(|row: usize| f64::from(values[row][i]));
            (2.0 * t3 - 3.0 * t2 + 1.0) * a + (t3 - 2.0 * t2 + t) * m + (3.0 * t2 - 2.0 * t3) * b + (t3 - t2) * n
        };
        let angle = 2.0 * hermite(2).atan2(hermite(3));
        let found = at(&file, time)[1];
        let distance = (found.x - 4.0 * angle.sin()).hypot(found.y - (9.0 - 4.0 * angle.cos()));
        assert!(distance <= 4e-4, "off by {distance} at {time}");
    }
}

#[test]
fn one_key_is_enough() {
    let file = leg()
        .channel((0, "rotation"), "LINEAR", &[2.0], &[about_z(90.0)])
        .channel((1, "translation"), "CUBICSPLINE", &[1.0], &[[9.0; 3], [0.0, -2.0, 0.0], [9.0; 3]])
        .read();
    assert_eq!(file.clips()[0].times(), [1.0, 2.0]);
    for time in [0.0, 1.5, 5.0] {
        assert_near(at(&file, time)[1], [2.0, 9.0, 0.0]);
    }
}

#[test]
fn an_animation_without_channels_is_the_rest_pose() {
    let file = leg().read();
    assert_eq!(file.clips()[0].key(0), Some(&file.skeleton().rest_pose()[..]));
    let text = leg().text().replace(r#""name": "kick", "#, "");
    assert_eq!(parse::<f32>(text.as_bytes()).unwrap().clips()[0].name(), "animation_0");
}

#[test]
fn signs_and_lengths_of_quaternions_are_brought_in_order() {
    let long = about_z(90.0).map(|x| x * -1.0002);
    let file = leg().channel((0, "rotation"), "LINEAR", &[0.0, 1.0, 2.0], &[about_z(0.0), long, about_z(90.0)]).read();
    assert_near(at(&file, 0.5)[1], [8.0_f64.sqrt(), 9.0 - 8.0_f64.sqrt(), 0.0]);
    assert_near(at(&file, 1.5)[1], [4.0, 9.0, 0.0]);
    let channel = "animation 0 `kick`, channel 0 (rotation of node 0 `hip`)";
    let expected = [
        alloc::format!("{channel}: made 1 quaternions unit whose lengths were off 1 by up to 2.0e-4"),
        alloc::format!("{channel}: changed the sign of 1 quaternions, for the short way"),
    ];
    assert_eq!(warnings(&file), expected);
}

#[test]
fn quaternions_may_be_normalized_integers() {
    let quarter = [0.0, 0.0, 0.5_f64.sqrt(), 0.5_f64.sqrt()];
    let scaled = |most: f64| quarter.map(|x| (x * most).round());
    let shorts: Vec<u8> = scaled(32767.0).iter().flat_map(|&x| (x as i16).to_le_bytes()).collect();
    let unsigned_shorts: Vec<u8> = scaled(65535.0).iter().flat_map(|&x| (x as u16).to_le_bytes()).collect();
    let minus: Vec<u8> = scaled(127.0).iter().map(|&x| (-x as i8).cast_unsigned()).collect();
    let formats = [
        (5120, scaled(127.0).map(|x| x as u8).to_vec(), 127.0),
        (5120, minus, 127.0),
        (5121, scaled(255.0).map(|x| x as u8).to_vec(), 255.0),
        (5122, shorts, 32767.0),
        (5123, unsigned_shorts, 65535.0),
    ];
    for (component, bytes, most) in formats {
        let file = leg().normalized(0, &[0.0], component, &bytes).read();
        let knee = at(&file, 0.0)[1];
        // Made unit again, this one is as good as exact, the rounding being the same in both.
        assert!((knee.x - 4.0).hypot(knee.y - 9.0) < 4.0 / most, "{component}");
        assert_eq!(file.warnings(), [], "{component}");
    }
    // The lowest integer is -1 too.
    let file = leg().normalized(0, &[0.0], 5120, &[0, 0, 128, 0]).read();
    assert_near(at(&file, 0.0)[1], [0.0, 13.0, 0.0]);
}

#[test]
fn what_is_not_read_is_told_and_what_is_outside_is_ignored() {
    let text = leg()
        .channel((2, "weights"), "LINEAR", &[0.0], &[[1.0]])
        .channel((0, "pointer"), "LINEAR", &[0.0], &[[1.0]])
        .channel((9, "colour"), "LINEAR", &[0.0], &[[1.0]])
        .channel((1, "translation"), "STEP", &[0.0], &[[0.0, -5.0, 0.0]])
        .channel((2, "scale"), "LINEAR", &[1.0, 0.0], &[[f32::NAN; 3]])
        .channel((2, "scale"), "CRAZY", &[], &[[0.0]])
        .text()
        .replace(r#""node": 0, "path": "pointer""#, r#""path": "pointer""#);
    let file = parse::<f64>(text.as_bytes()).unwrap_or_else(|error| panic!("{error}"));
    assert_near(at(&file, 0.0)[1], [0.0, 4.0, 0.0]);
    let expected = [
        "animation 0 `kick`, channel 0 (weights of node 2 `lamp`): left out weights of morph targets",
        "animation 0 `kick`, channel 1: skipped, for it drives nothing that is read here",
        "animation 0 `kick`, channel 2: skipped, for it drives nothing that is read here",
    ];
    assert_eq!(warnings(&file), expected);
}

#[test]
fn scale_may_be_animated_as_long_as_it_stays() {
    let file = leg().channel((1, "scale"), "LINEAR", &[0.0, 1.0], &[[1.0; 3]; 2]).read();
    assert_eq!(file.warnings(), []);
    assert_eq!(file.clips()[0].key_count(), 1);
    let file = leg().channel((1, "scale"), "LINEAR", &[0.0, 1.0], &[[1.0; 3], [1.0, 1.0, 1.00005]]).read();
    let expected = "animation 0 `kick`, channel 0 (scale of node 1 `knee`): \
                    left out a scale that differs from the node's by up to 5.0e-5 of it";
    assert_eq!(warnings(&file), [expected]);
    // Also with tangents, if these are small.
    let nearly = [[1e-4; 3], [1.0; 3], [1e-4; 3], [1e-4; 3], [1.0; 3], [1e-4; 3]];
    assert_eq!(leg().channel((1, "scale"), "CUBICSPLINE", &[0.0, 1.0], &nearly).read().warnings().len(), 1);
}
