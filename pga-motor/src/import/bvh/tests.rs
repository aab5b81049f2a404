//! What is accepted, and for everything that is not, the exact line and message.

use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec;
use alloc::vec::Vec;

use super::*;
use crate::Point;
use crate::skeleton::{Interpolation, JointModes, Wrap, local_to_model};

const LEG: &str = "\
HIERARCHY
ROOT hip
{
  OFFSET 0 1 0
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  JOINT knee
  {
    OFFSET 0 -4 0
    CHANNELS 3 Zrotation Xrotation Yrotation
    End Site
    {
      OFFSET 0 -3 0.5
    }
  }
}
MOTION
Frames: 2
Frame Time: 0.5
0 9 0 90 0 0 0 0 0
1 9 -1e1 0 0 0 0 .9 +45
";

fn read(text: &str) -> Bvh<f64> {
    parse(text).unwrap_or_else(|error| panic!("{error}"))
}

/// The error that `LEG` gives after one replacement.
#[track_caller]
fn error_of(old: &str, new: &str) -> String {
    assert_eq!(LEG.matches(old).count(), 1, "`{old}` must stand once in the text");
    error(&LEG.replace(old, new))
}

#[track_caller]
fn error(text: &str) -> String {
    parse::<f64>(text).expect_err("broken text must not be read").to_string()
}

#[test]
fn a_file_is_read_as_written() {
    let file = read(LEG);
    assert_eq!(file.skeleton().names(), ["hip", "knee"]);
    assert_eq!([file.skeleton().parent(0), file.skeleton().parent(1)], [None, Some(0)]);
    assert_eq!(file.tips(), [Tip { joint: 1, offset: Direction::new(0.0, -3.0, 0.5) }]);
    let names: Vec<_> = file.channels(1).iter().map(|channel| channel.name()).collect();
    assert_eq!(names, ["Zrotation", "Xrotation", "Yrotation"]);
    assert_eq!((file.channels(0).len(), file.channels(2).len()), (6, 0));
    assert_eq!((file.frame_count(), file.frame_time()), (2, 0.5));
    assert_eq!(file.frame(1), Some(&[1.0, 9.0, -10.0, 0.0, 0.0, 0.0, 0.0, 0.9, 45.0][..]));
    assert_eq!(file.frame(2), None);
}

#[test]
fn line_ends_tabs_capitals_and_layout_do_not_matter() {
    let expected = read(LEG);
    let layouts = [
        LEG.replace('\n', "\r\n"),
        LEG.replace('\n', "\r"),
        LEG.replace(' ', "\t").replace("Frame\tTime", "Frame \t Time"),
        LEG.replace("rotation", "ROTATION").replace("HIERARCHY", "hierarchy").replace("JOINT", "Joint"),
        LEG.replace("\n  ", " ").replace("\n{", " {").replace("hip {", "hip{"),
        LEG.replace('\n', "\n\n  \n"),
        LEG.replace("Frames: 2", "Frames:2").replace("Time: 0.5", "Time : 0.5 "),
        format!("\u{feff}{LEG}"),
        LEG.trim_end().into(),
    ];
    for layout in layouts {
        assert_eq!(read(&layout), expected, "{layout}");
    }
}

#[test]
fn names_may_have_spaces_and_repeat() {
    let file = read(
        &LEG.replace("ROOT hip", "ROOT mixamorig: left knee \t")
            .replace("JOINT knee", "JOINT mixamorig: left knee{")
            .replacen("  {\n", "", 1),
    );
    assert_eq!(file.skeleton().names(), ["mixamorig: left knee", "mixamorig: left knee"]);
}

#[test]
fn several_roots_and_joints_without_channels_are_read() {
    let file = read(
        "HIERARCHY ROOT a { OFFSET 0 0 0 JOINT b { CHANNELS 1 Yposition OFFSET 1 0 0 } JOINT c { OFFSET 2 0 0 CHANNELS 0 } }
         ROOT d { OFFSET 5 0 0 CHANNELS 2 Zrotation Zposition }
         MOTION\nFrames: 1\nFrame Time: 0\n7 90 8",
    );
    assert_eq!(file.skeleton().names(), ["a", "b", "c", "d"]);
    assert_eq!([0, 1, 2, 3].map(|joint| file.skeleton().parent(joint)), [None, Some(0), Some(0), None]);
    assert_eq!([0, 1, 2, 3].map(|joint| file.channels(joint).len()), [0, 1, 0, 2]);
    let mut pose = file.skeleton().rest_pose().clone();
    file.pose_into(0, &mut pose).unwrap();
    let origins: Vec<_> = pose.iter().map(|local| local.transform_origin()).collect();
    assert_eq!(origins[1..], [Point::new(1.0, 7.0, 0.0), Point::new(2.0, 0.0, 0.0), Point::new(5.0, 0.0, 8.0)]);
}

#[test]
fn a_file_without_frames_has_a_rest_pose() {
    let file = read("HIERARCHY ROOT a { OFFSET 1 2 3 } MOTION\nFrames: 0\nFrame Time: 0.01");
    assert_eq!(file.frame_count(), 0);
    assert_eq!(file.skeleton().rest_pose()[0].transform_origin(), Point::new(1.0, 2.0, 3.0));
    let error = file.pose_into(0, &mut [Motor::IDENTITY]).unwrap_err();
    assert_eq!(error.to_string(), "expected a frame below 0, the number of frames, found 0");
}

#[test]
fn the_rotation_listed_last_acts_first() {
    let pose_knee = |order: &str| {
        let file = read(
            &LEG.replace("3 Zrotation Xrotation Yrotation", order).replace("0 9 0 90 0 0 0 0 0", "0 0 0 0 0 0 90 90 0"),
        );
        let mut locals = [Motor::IDENTITY; 2];
        file.pose_into(0, &mut locals).unwrap();
        locals[1].transform_point(Point::new(0.0, 1.0, 0.0))
    };
    // About x the point (0, 1, 0) goes to (0, 0, 1), where a turn about z leaves it. About z first, it goes to (-1, 0, 0).
    // The distances allow three roundings of sin, cos and their products, each at most 2^-52.
    let near = |p: Point<f64>, q: [f64; 3]| [p.x - q[0], p.y - q[1], p.z - q[2]].iter().all(|d| d.abs() < 4e-15);
    assert!(near(pose_knee("3 Zrotation Xrotation Yrotation"), [0.0, -4.0, 1.0]));
    assert!(near(pose_knee("3 Xrotation Zrotation Yrotation"), [-1.0, -4.0, 0.0]));
}

#[test]
fn words_out_of_place_are_named() {
    assert_eq!(error_of("HIERARCHY", "HIERACHY"), "line 1: expected `HIERARCHY`, found `HIERACHY`");
    assert_eq!(error_of("ROOT", "JOINT"), "line 2: expected `ROOT`, found `JOINT`");
    assert_eq!(
        error_of("JOINT", "JIONT"),
        "line 6: expected `OFFSET`, `CHANNELS`, `JOINT`, `End Site` or `}` in joint `hip`, found `JIONT`"
    );
    assert_eq!(error_of("Site", "Effector"), "line 10: expected `Site`, found `Effector`");
    assert_eq!(
        error_of("    {\n      OFFSET", "{ CHANNELS"),
        "line 11: expected `OFFSET` in the end site of joint `knee`, found `CHANNELS`"
    );
    assert_eq!(error_of("\nMOTION", "\n}\nMOTION"), "line 16: expected `ROOT` or `MOTION`, found `}`");
    assert_eq!(error_of("MOTION", "MOTIONS"), "line 16: expected `ROOT` or `MOTION`, found `MOTIONS`");
    assert_eq!(
        error_of("OFFSET 0 -4 0", "OFFSET 0 -4 0 7"),
        "line 8: expected `OFFSET`, `CHANNELS`, `JOINT`, `End Site` or `}` in joint `knee`, found `7`"
    );
}

#[test]
fn missing_braces_are_named() {
    assert_eq!(error_of("ROOT hip\n{", "ROOT hip\n"), "line 4: expected `{` of joint `hip`, found `OFFSET`");
    assert_eq!(
        error_of("End Site\n    {", "End Site\n"),
        "line 12: expected `{` of the end site of joint `knee`, found `OFFSET`"
    );
    assert_eq!(error_of("0.5\n    }", "0.5\n{"), "line 13: expected `}` of the end site of joint `knee`, found `{`");
    assert_eq!(error_of("}\nMOTION", "\nMOTION"), "line 16: expected `}` of joint `hip`, found `MOTION`");
}

#[test]
fn offsets_are_checked() {
    assert_eq!(error_of("OFFSET 0 1 0", ""), "line 15: expected an `OFFSET` in joint `hip`, found none");
    assert_eq!(
        error_of("OFFSET 0 -3 0.5", ""),
        "line 13: expected an `OFFSET` in the end site of joint `knee`, found none"
    );
    assert_eq!(
        error_of("OFFSET 0 1 0", "OFFSET 0 1 0 OFFSET 0 1 0"),
        "line 4: expected one `OFFSET` in joint `hip`, found a second"
    );
    assert_eq!(
        error_of("OFFSET 0 1 0", "OFFSET 0 1"),
        "line 5: expected a number for z of the `OFFSET` of joint `hip`, found `CHANNELS`"
    );
    assert_eq!(
        error_of("OFFSET 0 -4 0", "OFFSET 0 -4,5 0"),
        "line 8: expected a number for y of the `OFFSET` of joint `knee`, found `-4,5`"
    );
    assert_eq!(
        error_of("OFFSET 0 -4 0", "OFFSET nan -4 0"),
        "line 8: expected a finite number for x of the `OFFSET` of joint `knee`, found `nan`"
    );
    assert_eq!(
        error_of("-3 0.5", "-3 1e999"),
        "line 12: expected a finite number for z of the `OFFSET` of the end site of joint `knee`, found `1e999`"
    );
}

#[test]
fn channels_are_checked() {
    assert_eq!(
        error_of("CHANNELS 6", "CHANNELS 5"),
        "line 5: expected 5 channels in joint `hip`, as declared, found 6"
    );
    assert_eq!(
        error_of("CHANNELS 3", "CHANNELS 99999999999"),
        "line 9: expected 99999999999 channels in joint `knee`, as declared, found 3"
    );
    assert_eq!(error_of("CHANNELS 3", "CHANNELS"), "line 9: expected the number of channels, found `Zrotation`");
    assert_eq!(error_of("CHANNELS 3", "CHANNELS -3"), "line 9: expected the number of channels, found `-3`");
    assert_eq!(
        error_of("CHANNELS 3 Zrotation", "CHANNELS 3 Wrotation"),
        "line 9: expected a channel from Xposition to Zrotation in joint `knee`, found `Wrotation`"
    );
    assert_eq!(
        error_of("6 Xposition", "6 Yposition"),
        "line 5: expected one `Yposition` in joint `hip`, found a second"
    );
    assert_eq!(
        error_of("    End", "CHANNELS 0 End"),
        "line 10: expected one `CHANNELS` in joint `knee`, found a second"
    );
    let late = "HIERARCHY\nROOT a {\nOFFSET 0 0 0\nJOINT b { OFFSET 0 0 0 }\nCHANNELS 1 Xrotation }";
    assert_eq!(error(late), "line 5: expected `CHANNELS` of joint `a` before its first `JOINT`, found none");
}

#[test]
fn the_motion_header_is_checked() {
    assert_eq!(
        error_of("Frames: 2\n", ""),
        "line 17: expected `Frames:` and the number of frames, found `Frame Time: 0.5`"
    );
    assert_eq!(error_of("Frames: 2", "Frames: -2"), "line 17: expected the number of frames, found `-2`");
    assert_eq!(error_of("Frames: 2", "Frames: 2.5"), "line 17: expected the number of frames, found `2.5`");
    assert_eq!(
        error_of("Frames: 2", "Frames: 99999999999999999999999"),
        "line 17: expected the number of frames, found `99999999999999999999999`"
    );
    assert_eq!(
        error_of("Frame Time: 0.5\n", ""),
        "line 18: expected `Frame Time:` and the seconds between frames, found `0 9 0 90 0 0 0 0 0`"
    );
    assert_eq!(
        error_of("Time: 0.5", "Time: inf"),
        "line 18: expected a finite number for the time between frames, found `inf`"
    );
    assert_eq!(
        error_of("Time: 0.5", "Time: 0,5"),
        "line 18: expected a number for the time between frames, found `0,5`"
    );
    assert_eq!(error_of("Time: 0.5", "Time: 0"), "line 18: expected a positive time between frames, found `0`");
    assert_eq!(error_of("Time: 0.5", "Time: -0.5"), "line 18: expected a positive time between frames, found `-0.5`");
    let idle = "HIERARCHY ROOT a { OFFSET 0 0 0 } MOTION\nFrames: 9\nFrame Time: 1";
    assert_eq!(error(idle), "line 2: expected channels for 9 frames to fill, found none");
}

#[test]
fn frames_are_checked() {
    assert_eq!(
        error_of("0 9 0 90 0 0 0 0 0", "0 9 0 90 0 0 0 0"),
        "line 19: expected 9 values in the frame, one for each channel, found 8"
    );
    assert_eq!(
        error_of(".9 +45", ".9 +45 0"),
        "line 20: expected 9 values in the frame, one for each channel, found 10"
    );
    assert_eq!(
        error_of(".9 +45", ".9 NaN"),
        "line 20: expected a finite number for `Yrotation` of joint `knee` in frame 1, found `NaN`"
    );
    assert_eq!(
        error_of(".9 +45", ".9 -1.#IND"),
        "line 20: expected a number for `Yrotation` of joint `knee` in frame 1, found `-1.#IND`"
    );
    assert_eq!(error_of("Frames: 2", "Frames: 1"), "line 20: expected 1 frames, as declared, found 2");
    assert_eq!(
        error_of("Frames: 2", "Frames: 99999999999"),
        "line 20: expected 99999999999 frames, as declared, found 2"
    );
}

#[test]
fn a_number_too_large_for_the_scalar_is_not_finite() {
    let text = LEG.replace("-1e1", "-1e60");
    assert!(parse::<f64>(&text).is_ok());
    let error = parse::<f32>(&text).unwrap_err();
    assert_eq!(
        error.to_string(),
        "line 20: expected a finite number for `Zposition` of joint `hip` in frame 1, found `-1e60`"
    );
    // Finite offsets may still add up to a joint at infinity.
    let text = "HIERARCHY\nROOT a { OFFSET 3e38 0 0\nJOINT b { OFFSET 3e38 0 0\nJOINT c { OFFSET 3e38 0 0 } } }\nMOTION\nFrames: 0\nFrame Time: 1";
    let error = parse::<f32>(text).unwrap_err();
    assert_eq!(error.to_string(), "line 4: joint 2 `c`: expected a finite motor, found a NaN or an infinity");
}

#[test]
fn every_truncation_of_the_hierarchy_and_header_is_an_error_on_the_last_line() {
    assert_eq!(error(""), "line 1: expected `HIERARCHY`, found the end of the file");
    assert_eq!(error("HIERARCHY\n\n"), "line 1: expected `ROOT`, found the end of the file");
    assert_eq!(error("HIERARCHY\nROOT a\n"), "line 2: expected `{` of joint `a`, found the end of the file");
    assert_eq!(
        error("HIERARCHY\nROOT a {\nOFFSET 0 0"),
        "line 3: expected z of the `OFFSET` of joint `a`, found the end of the file"
    );
    let end = LEG.find("1 9 -1e1").unwrap();
    for cut in (0..end).filter(|&cut| LEG.is_char_boundary(cut)) {
        let text = &LEG[..cut];
        let error = parse::<f64>(text).expect_err(text);
        assert_eq!(error.line(), text.trim_end().lines().count().max(1), "{text}");
    }
    assert_eq!(error(&LEG[..end]), "line 19: expected 2 frames, as declared, found 1");
}

#[test]
fn long_words_are_cut_short_in_messages() {
    let error = error_of("HIERARCHY", &"é".repeat(1000));
    assert_eq!(error, format!("line 1: expected `HIERARCHY`, found `{}...`", "é".repeat(40)));
}

#[test]
fn a_hierarchy_of_any_depth_is_read_or_refused_without_recursion() {
    let nested = |depth: usize| {
        let mut text = String::from("HIERARCHY\nROOT r\n{ OFFSET 0 0 0 CHANNELS 1 Zrotation\n");
        for _ in 1..depth {
            text += "JOINT j { OFFSET 0 1 0\n";
        }
        text += &"}".repeat(depth);
        text + "\nMOTION\nFrames: 1\nFrame Time: 1\n180\n"
    };
    let file = read(&nested(65_535));
    let mut pose = file.skeleton().rest_pose().clone();
    file.pose_into(0, &mut pose).unwrap();
    let mut model = vec![Motor::IDENTITY; pose.len()];
    local_to_model(file.skeleton(), &pose, &mut model).unwrap();
    // The chain stands on its head. The half turn's rotor is (2^-54, 1) instead of (0, 1), so at the far end of a chain of
    // 65,534 the sine 2^-53 makes 1e-11; each of as many additions may round by 2^-37, half a place of their size, 5e-7 in all.
    let tip = model[65_534].transform_origin();
    assert!((tip.y + 65_534.0).abs() < 1e-6 && tip.x.abs() < 1e-6, "{tip:?}");

    // Joint 65,535 is on line 65,538 of the text: the root takes lines 2 and 3.
    let error = parse::<f64>(&nested(100_000)).unwrap_err();
    assert_eq!(error.to_string(), "line 65538: joint 65535 `j`: expected at most 65535 joints, found more");
}

#[test]
fn buffers_of_another_length_are_refused() {
    let file = read(LEG);
    let mut locals = [Motor::IDENTITY; 3];
    let error = file.pose_into(1, &mut locals).unwrap_err();
    assert_eq!(error.to_string(), "expected 2 motors in the pose, one for each joint, found 3");
    assert_eq!(locals, [Motor::IDENTITY; 3]);
}

#[test]
fn a_clip_has_the_frames_as_keys() {
    let file = read(LEG);
    let clip = file.clip().unwrap();
    assert_eq!((clip.name(), clip.times()), ("", &[0.0, 0.5][..]));
    assert_eq!(clip.modes(), [JointModes::default(); 2]);
    let mut locals = [Motor::IDENTITY; 2];
    for frame in 0..2 {
        file.pose_into(frame, &mut locals).unwrap();
        assert_eq!(clip.key(frame).unwrap(), locals);
    }
    clip.sample_into(0.25, Interpolation::Split, Wrap::Clamp, &mut locals).unwrap();
    // Half way from (0, 10, 0) to (1, 10, -10); sums and halves of few bits, so only the motors' half vectors and products round.
    let middle = locals[0].transform_origin();
    assert!(middle.distance_to_point(Point::new(0.5, 10.0, -5.0)) < 1e-14, "{middle:?}");
}

#[test]
fn a_clip_takes_the_nearer_sign_where_angles_wrap() {
    let text = LEG.replace("0 9 0 90 0 0 0 0 0", "0 0 0 179 0 0 0 0 0").replace("1 9 -1e1 0", "0 0 0 -179");
    let clip = read(&text).clip().unwrap();
    let mut locals = [Motor::IDENTITY; 2];
    clip.sample_into(0.25, Interpolation::Screw, Wrap::Clamp, &mut locals).unwrap();
    // Two degrees through the half turn, not 358 back: a few roundings of angles up to pi.
    let point = locals[0].transform_point(Point::new(1.0, 0.0, 0.0));
    assert!(point.distance_to_point(Point::new(-1.0, 1.0, 0.0)) < 1e-14, "{point:?}");
}

#[test]
fn a_clip_needs_frames_whose_times_and_places_are_numbers() {
    let file = read("HIERARCHY ROOT a { OFFSET 1 2 3 } MOTION\nFrames: 0\nFrame Time: 0.01");
    assert_eq!(file.clip().unwrap_err(), ClipError::Empty { joints: 1, keys: 0 });
    let one = read("HIERARCHY ROOT a { OFFSET 0 0 0 CHANNELS 1 Xposition } MOTION\nFrames: 1\nFrame Time: 0\n7");
    assert_eq!(one.clip().unwrap().times(), [0.0]);
    let slow = LEG.replace("Time: 0.5", "Time: 3e38").replace("Frames: 2", "Frames: 3") + "0 0 0 0 0 0 0 0 0\n";
    let error = parse::<f32>(&slow).unwrap().clip().unwrap_err();
    assert_eq!(error, ClipError::TimeNotFinite { key: 2 });
    let far = LEG.replace("OFFSET 0 1 0", "OFFSET 0 3e38 0").replace("0 9 0 90", "0 3e38 0 90");
    let error = parse::<f32>(&far).unwrap().clip().unwrap_err();
    assert_eq!(error, ClipError::NonFinite { key: 0, joint: 0 });
}

#[test]
fn joints_without_channels_do_not_make_a_short_file_a_large_clip() {
    let (joints, frames) = (6000, 12_000);
    let mut text = String::from("HIERARCHY\nROOT a { OFFSET 0 0 0 CHANNELS 1 Zrotation\n");
    text += &"JOINT j { OFFSET 0 0 0 }\n".repeat(joints);
    text += &format!("}}\nMOTION\nFrames: {frames}\nFrame Time: 1\n");
    text += &"0\n".repeat(frames);
    let error = read(&text).clip().unwrap_err();
    assert_eq!(error.to_string(), "expected at most 8388608 motors in a clip, found 72012000");
}
