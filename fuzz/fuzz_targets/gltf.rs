//! A glTF file of any bytes is read or refused, and every clip of one that was read poses its skeleton.
#![no_main]

use libfuzzer_sys::fuzz_target;
use pga_motor::Motor;
use pga_motor::import::gltf;
use pga_motor::skeleton::{Interpolation, Wrap, local_to_model};

fuzz_target!(|bytes: &[u8]| {
    let Ok(file) = gltf::parse::<f32>(bytes) else { return };
    let mut pose = file.skeleton().rest_pose().clone();
    let mut model = vec![Motor::IDENTITY; pose.len()];
    for clip in file.clips().iter().take(10) {
        for time in [clip.start(), (clip.start() + clip.end()) / 2.0, clip.end()] {
            clip.sample_into(time, Interpolation::Split, Wrap::Clamp, &mut pose).expect("a buffer of the clip's length");
            local_to_model(file.skeleton(), &pose, &mut model).expect("buffers of the skeleton's length");
        }
    }
});
