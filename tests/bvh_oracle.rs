//! Joint positions from BVH files agree with numbers computed elsewhere.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

use pga_motor::import::bvh::{self, Bvh};
use pga_motor::skeleton::{Interpolation, Wrap, local_to_model};
use pga_motor::{Motor, Point, Real};
use serde_json::Value;

type Outcome = Result<(), Box<dyn Error>>;

fn at_root(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(path)
}

fn read_json(path: &Path) -> Result<Value, Box<dyn Error>> {
    Ok(serde_json::from_str(&fs::read_to_string(path)?)?)
}

/// Where joints and end sites are in a pose, each kind in the file's order.
struct Positions {
    joints: Vec<[f64; 3]>,
    tips: Vec<[f64; 3]>,
}

impl Positions {
    fn of<T: Real + Into<f64>>(file: &Bvh<T>, locals: &[Motor<T>]) -> Self {
        let mut model = vec![Motor::IDENTITY; locals.len()];
        local_to_model(file.skeleton(), locals, &mut model).expect("the buffers have the skeleton's length");
        let place = |motor: Motor<T>, x, y, z| {
            let Point { x, y, z } = motor.transform_point(Point::new(x, y, z));
            [x.into(), y.into(), z.into()]
        };
        let joints = model.iter().map(|&motor| place(motor, T::ZERO, T::ZERO, T::ZERO)).collect();
        let tips = file.tips().iter().map(|tip| place(model[tip.joint], tip.offset.x, tip.offset.y, tip.offset.z));
        Self { tips: tips.collect(), joints }
    }

    fn in_frame<T: Real + Into<f64>>(file: &Bvh<T>, frame: usize) -> Self {
        let mut locals = vec![Motor::IDENTITY; file.skeleton().len()];
        file.pose_into(frame, &mut locals).expect("the frame is one of the file's");
        Self::of(file, &locals)
    }

    /// The length of the diagonal of the box around all positions.
    fn size(&self) -> f64 {
        let edge = |axis: usize| {
            let coordinates = self.joints.iter().chain(&self.tips).map(|position| position[axis]);
            let (low, high) = coordinates.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| (l.min(x), h.max(x)));
            high - low
        };
        (edge(0).powi(2) + edge(1).powi(2) + edge(2).powi(2)).sqrt()
    }

    /// The largest distance from a row `[name, x, y, z]` of the expected ones. The rows hold joints and end sites together.
    fn largest_error(&self, rows: &Value, names: &[String]) -> f64 {
        let rows = rows.as_array().expect("rows are a list");
        let (tips, joints): (Vec<_>, Vec<_>) = rows.iter().partition(|row| row[0] == "ENDSITE");
        assert_eq!((joints.len(), tips.len()), (self.joints.len(), self.tips.len()));
        assert!(joints.iter().zip(names).all(|(row, name)| row[0] == name.as_str()), "joints are in the file's order");
        let found = self.joints.iter().chain(&self.tips);
        let errors = joints.iter().chain(&tips).zip(found).map(|(row, found)| {
            let square =
                |axis: usize| (row[axis + 1].as_f64().expect("a coordinate is a number") - found[axis]).powi(2);
            (square(0) + square(1) + square(2)).sqrt()
        });
        errors.fold(0.0, f64::max)
    }
}

#[test]
fn marionette_agrees_with_matrices() -> Outcome {
    let text = fs::read_to_string(at_root("tests/data/marionette.bvh"))?;
    // Nothing in the file is further than 20 from the origin, along chains of at most 4 joints of at most 3 rotations.
    // Double precision: the numbers are rounded at 1e-12, and some 4 * 3 * 8 roundings of 2^-53 at size 20 add 2e-13.
    marionette_agrees::<f64>(&text, 2e-12)?;
    // Single precision: angles up to 540 degrees are off by two roundings, 540 * pi / 180 * 2^-23, in 3 angles of 3 joints on
    // 20 units of length: 2e-4 were they all to add up.
    marionette_agrees::<f32>(&text, 2e-4)
}

fn marionette_agrees<T: Real + Into<f64>>(text: &str, tolerance: f64) -> Outcome {
    let file = bvh::parse::<T>(text)?;
    let expected = read_json(&at_root("tests/data/marionette.json"))?;
    let frames = expected["frames"].as_array().ok_or("frames are a list")?;
    assert_eq!(frames.len(), file.frame_count());
    for (frame, rows) in frames.iter().enumerate() {
        let error = Positions::in_frame(&file, frame).largest_error(&rows["joints"], file.skeleton().names());
        println!("{} frame {frame}: largest error {error:.1e}", std::any::type_name::<T>());
        assert!(error <= tolerance, "frame {frame} is off by {error:e}");
    }
    Ok(())
}

#[test]
fn motion_capture_agrees_with_three_js() -> Outcome {
    let data = at_root("../shared/data");
    if !data.is_dir() {
        eprintln!("SKIPPED motion_capture_agrees_with_three_js: there is no folder {}", data.display());
        return Ok(());
    }
    let oracle = read_json(&data.join("oracle.json"))?;
    let cases = oracle["cases"].as_array().ok_or("cases are a list")?;
    let is_bvh = |case: &&Value| case["file"].as_str().is_some_and(|name| name.ends_with(".bvh"));
    let mut compared = 0;
    for case in cases.iter().filter(is_bvh) {
        let name = case["file"].as_str().ok_or("a file has a name")?;
        let file = bvh::parse::<f64>(&fs::read_to_string(data.join(name))?)?;
        let size = Positions::of(&file, file.skeleton().rest_pose()).size();
        let time = case["t"].as_f64().ok_or("a time is a number")?;
        let positions = Positions::of(&file, &locals_at(&file, time));
        let error = positions.largest_error(&case["joints"], file.skeleton().names()) / size;
        println!("{name} at {time:.6} s: largest error {error:.1e} of the skeleton's size {size:.2}");
        assert!(error <= 1e-4, "{name} at {time} s is off by {error:e} of the skeleton's size");
        compared += 1;
    }
    assert!(compared > 0, "the oracle has cases for BVH files");
    Ok(())
}

/// The pose at a time in seconds, as three.js has it: between two frames the translation on the straight line and the rotation
/// on the great arc.
fn locals_at(file: &Bvh<f64>, time: f64) -> Vec<Motor<f64>> {
    let clip = file.clip().expect("the file has frames");
    let mut locals = vec![Motor::IDENTITY; clip.joint_count()];
    clip.sample_into(time, Interpolation::Split, Wrap::Clamp, &mut locals).expect("the buffer has the clip's length");
    locals
}
