//! Joints and skins from glTF files are where matrices have them, and where numbers computed elsewhere have them; whatever is
//! done to a file, it is read or refused.

mod matrices;
mod mutations;

use std::fs;
use std::path::{Path, PathBuf};

use matrices::{Matrix, Outcome, Raw, apply, multiply};
use pga_motor::import::gltf::{self, Gltf};
use pga_motor::skeleton::{Clip, Influences, Interpolation, Wrap, local_to_model, skin_points_linear};
use pga_motor::{Motor, Point, Real};
use serde_json::Value;

fn at_root(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(path)
}

/// The folder of files that are not part of the project; `None`, and a line that says so, where there is none.
fn shared(test: &str) -> Option<PathBuf> {
    let folder = std::env::var_os("GA_MOTOR_DATA").map_or_else(|| at_root("../shared/data"), PathBuf::from);
    if folder.is_dir() {
        return Some(folder);
    }
    eprintln!("SKIPPED {test}: there is no folder {}", folder.display());
    None
}

fn origin<T: Real>(motor: Motor<T>) -> [f64; 3] {
    let Point { x, y, z } = motor.transform_origin();
    [x, y, z].map(T::to_f64)
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
}

/// The model motors at rest, or in a clip at a time.
fn models<T: Real>(file: &Gltf<T>, at: Option<(&Clip<T>, f64)>) -> Vec<Motor<T>> {
    let mut pose = file.skeleton().rest_pose().clone();
    if let Some((clip, time)) = at {
        clip.sample_into(T::from_f64(time), Interpolation::Split, Wrap::Clamp, &mut pose)
            .expect("buffers of one length");
    }
    let mut model = vec![Motor::IDENTITY; pose.len()];
    local_to_model(file.skeleton(), &pose, &mut model).expect("buffers of one length");
    model
}

/// The diagonal of the box around the skins' joints at rest.
fn size<T: Real>(file: &Gltf<T>) -> f64 {
    let model = models(file, None);
    let positions: Vec<_> = file.joints().iter().map(|&joint| origin(model[joint])).collect();
    let edge = |axis: usize| {
        let coordinates = positions.iter().map(|position| position[axis]);
        coordinates.clone().fold(f64::NEG_INFINITY, f64::max) - coordinates.fold(f64::INFINITY, f64::min)
    };
    (edge(0).powi(2) + edge(1).powi(2) + edge(2).powi(2)).sqrt()
}

/// The largest distance of a joint, or of a vertex that hangs on one, from where the matrices have it.
fn largest_error<T: Real>(file: &Gltf<T>, model: &[Motor<T>], raw: &Raw, world: &[Matrix], size: f64) -> f64 {
    let joints = file.nodes().iter().zip(model);
    let mut worst =
        joints.map(|(&node, &motor)| distance(origin(motor), apply(world[node], [0.0; 3]))).fold(0.0, f64::max);
    for (skin, joints) in file.skins().iter().zip(raw.skins()) {
        let k = skin.scale.to_f64();
        assert_eq!(skin.joints.len(), joints.len());
        for ((&joint, &bind), (node, inverse)) in skin.joints.iter().zip(&skin.inv_bind_poses).zip(joints) {
            // Vertices where a mesh of the skeleton's size may have some.
            for direction in [[0.1, 0.0, 0.0], [0.0, 0.2, 0.1], [-0.1, 0.0, 0.3]] {
                let vertex = direction.map(|x| x * size / k);
                let [x, y, z] = vertex.map(|x| T::from_f64(x * k));
                let Point { x, y, z } = (model[joint] * bind).transform_point(Point::new(x, y, z));
                let expected = apply(multiply(world[node], inverse), vertex);
                worst = worst.max(distance([x, y, z].map(T::to_f64), expected));
            }
        }
    }
    worst
}

/// Compares a file at rest and in all its clips, at times before, in and after them.
fn agrees<T: Real>(path: &Path, tolerance: f64) -> Outcome {
    let (file, raw) = (gltf::read::<T>(path)?, Raw::read(path)?);
    let name = format!("{} in {}", path.file_name().ok_or("a file")?.display(), std::any::type_name::<T>());
    file.warnings().iter().take(5).for_each(|warning| println!("{name}: {warning}"));
    let size = size(&file);
    let rest = largest_error(&file, &models(&file, None), &raw, &raw.world(None), size) / size;
    println!(
        "{name}: {} joints, {} clips; at rest off by {rest:.1e} of size {size:.3}",
        file.nodes().len(),
        file.clips().len()
    );
    assert!(rest <= tolerance, "{name}: at rest off by {rest:e}");
    assert_eq!(file.clips().len(), raw.animations());
    for (index, clip) in file.clips().iter().enumerate() {
        let (start, end) = (clip.start().to_f64(), clip.end().to_f64());
        let mut worst: (f64, f64) = (0.0, 0.0);
        for step in -3..=203 {
            // Times of single precision are the same to both.
            let time = f64::from((start + (end - start) * f64::from(step) / 200.37) as f32);
            let model = models(&file, Some((clip, time)));
            let error = largest_error(&file, &model, &raw, &raw.world(Some((index, time))), size) / size;
            worst = if error > worst.0 { (error, time) } else { worst };
        }
        let (error, time) = worst;
        println!("{name}, `{}`: {} keys, off by {error:.1e} at {time:.4} s", clip.name(), clip.key_count());
        assert!(error <= tolerance, "{name}, clip {index}: off by {error:e} of the size at {time} s");
    }
    Ok(())
}

#[test]
fn small_files_agree_with_matrices() -> Outcome {
    // Splines are followed to 8e-5 of the size; all else is rounding: in single precision some 2^-24 for each of some ten products.
    agrees::<f64>(&at_root("tests/data/crane.gltf"), 1e-4)?;
    agrees::<f32>(&at_root("tests/data/crane.gltf"), 1e-4)
}

#[test]
fn models_of_others_agree_with_matrices() -> Outcome {
    let Some(folder) = shared("models_of_others_agree_with_matrices") else { return Ok(()) };
    for name in ["Fox.glb", "RobotExpressive.glb", "RiggedSimple.gltf"] {
        agrees::<f64>(&folder.join(name), 1e-4)?;
        agrees::<f32>(&folder.join(name), 1e-4)?;
    }
    Ok(())
}

#[test]
fn crane_agrees_with_numbers_of_its_own() -> Outcome {
    let oracle: Value = serde_json::from_str(&fs::read_to_string(at_root("tests/data/crane.json"))?)?;
    let file = gltf::read::<f64>(at_root("tests/data/crane.gltf"))?;
    let worst = largest_distance(&file, &oracle, "crane.gltf")?;
    println!("crane.gltf: off by up to {worst:.1e} of its size");
    assert!(worst <= 1e-4, "off by {worst:e} of the size");
    Ok(())
}

#[test]
fn fox_agrees_with_three_js() -> Outcome {
    let Some(folder) = shared("fox_agrees_with_three_js") else { return Ok(()) };
    let oracle: Value = serde_json::from_str(&fs::read_to_string(folder.join("oracle.json"))?)?;
    let file = gltf::read::<f64>(folder.join("Fox.glb"))?;
    let worst = largest_distance(&file, &oracle, "Fox.glb")?;
    println!("Fox.glb: off by up to {worst:.1e} of its size");
    assert!(worst <= 1e-4, "off by {worst:e} of the size");
    Ok(())
}

/// The numbers are in the mesh's own space, which is the file's: its node stands at the origin.
#[test]
fn the_skin_of_the_fox_agrees_with_three_js() -> Outcome {
    let Some(folder) = shared("the_skin_of_the_fox_agrees_with_three_js") else { return Ok(()) };
    let oracle: Value = serde_json::from_str(&fs::read_to_string(folder.join("oracle.json"))?)?;
    let path = folder.join("Fox.glb");
    let (file, raw) = (gltf::read::<f64>(&path)?, Raw::read(&path)?);
    let skin = &file.skins()[0];
    let (mut worst, mut compared): (f64, usize) = (0.0, 0);
    for case in oracle["cases"].as_array().ok_or("cases are a list")?.iter().filter(|case| case["file"] == "Fox.glb") {
        let time = case["t"].as_f64().ok_or("a time is a number")?;
        let clip = &file.clips()[case["clip"].as_u64().ok_or("a clip has an index")? as usize];
        let model = models(&file, Some((clip, time)));
        let motors: Vec<_> =
            skin.joints.iter().zip(&skin.inv_bind_poses).map(|(&joint, &bind)| model[joint] * bind).collect();
        for row in case["lbs_vertices_local"].as_array().ok_or("vertices are a list")? {
            let (place, joints, weights) = raw.vertex(row[0].as_u64().ok_or("a vertex has an index")? as usize);
            let [x, y, z] = place.map(|length| length * skin.scale);
            let influences = Influences { joints: &[joints], weights: &[weights] };
            let mut found = [Point::ORIGIN];
            skin_points_linear(&motors, influences, &[Point::new(x, y, z)], &mut found)?;
            let expected = [1, 2, 3].map(|i| row[i].as_f64().expect("a coordinate is a number"));
            worst = worst.max(distance([found[0].x, found[0].y, found[0].z], expected));
            compared += 1;
        }
    }
    let worst = worst / size(&file);
    println!("Fox.glb: {compared} vertices, off by up to {worst:.1e} of its size");
    assert!(compared > 0 && worst <= 1e-4, "{compared} vertices, off by {worst:e} of the size");
    Ok(())
}

/// The largest distance of a joint from where the cases for a file have it, relative to the size.
fn largest_distance(file: &Gltf<f64>, oracle: &Value, name: &str) -> Outcome<f64> {
    let cases = oracle["cases"].as_array().ok_or("cases are a list")?;
    let mut worst: f64 = 0.0;
    let mut compared = 0;
    for case in cases.iter().filter(|case| case["file"] == name) {
        let time = case["t"].as_f64().ok_or("a time is a number")?;
        let clip = &file.clips()[case["clip"].as_u64().ok_or("a clip has an index")? as usize];
        let model = models(file, Some((clip, time)));
        let rows = case["joints"].as_array().ok_or("joints are a list")?;
        assert_eq!(rows.len(), file.joints().len());
        for (row, &joint) in rows.iter().zip(file.joints()) {
            assert_eq!(row[0], file.skeleton().names()[joint].as_str(), "joints are in the file's order");
            let expected = [1, 2, 3].map(|i| row[i].as_f64().expect("a coordinate is a number"));
            worst = worst.max(distance(origin(model[joint]), expected));
        }
        compared += 1;
    }
    assert!(compared > 0, "there are cases for {name}");
    Ok(worst / size(file))
}
