//! A BVH file of any text is read or refused, and every pose of one that was read has model motors.
#![no_main]

use libfuzzer_sys::fuzz_target;
use pga_motor::Motor;
use pga_motor::import::bvh;
use pga_motor::skeleton::local_to_model;

fuzz_target!(|text: &str| {
    let Ok(file) = bvh::parse::<f32>(text) else { return };
    let mut pose = file.skeleton().rest_pose().clone();
    let mut model = vec![Motor::IDENTITY; pose.len()];
    for frame in 0..file.frame_count().min(10) {
        file.pose_into(frame, &mut pose).expect("a frame that there is");
        local_to_model(file.skeleton(), &pose, &mut model).expect("buffers of the skeleton's length");
    }
});
