//! What runs once a frame allocates nothing: counted by the allocator.
// An allocator is an unsafe trait.
#![allow(unsafe_code)]

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

use pga_motor::f64::{Clip, Direction, Motor, Point, Poses, Rotor, ScrewCache, Skeleton, SkeletonInstance, Translator};
use pga_motor::skeleton::{
    Aim, Influences, Interpolation, Layer, Retarget, RootMotion, RootMotionPart, TwoBone, Wrap, add_layers,
    animate_keyframe, animate_sample, blend_poses, deviation_into, local_to_model, skin_normals, skin_normals_linear,
    skin_points, skin_points_linear, skinning_motors,
};

thread_local! {
    static COUNT: Cell<usize> = const { Cell::new(0) };
}

struct Counting;

#[global_allocator]
static ALLOCATOR: Counting = Counting;

// SAFETY: everything is handed on to the system's allocator as it comes.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        COUNT.set(COUNT.get() + 1);
        // SAFETY: as above.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, memory: *mut u8, layout: Layout) {
        // SAFETY: as above.
        unsafe { System.dealloc(memory, layout) }
    }
}

/// How often this thread allocates in the course of something.
fn allocations(work: impl FnOnce()) -> usize {
    let before = COUNT.get();
    work();
    COUNT.get() - before
}

#[test]
fn allocations_are_counted() {
    assert_eq!(allocations(|| drop(std::hint::black_box(Box::new(1)))), 1);
}

fn along_x(length: f64) -> Motor {
    Translator::from_vector(Direction::new(length, 0.0, 0.0)).into()
}

#[test]
fn what_runs_once_a_frame_allocates_nothing() {
    let joints = [("a", None, along_x(0.0)), ("b", Some(0), along_x(2.0)), ("c", Some(1), along_x(1.0))];
    let (skeleton, _) = Skeleton::from_parents(joints).unwrap();
    let turned = [0.2, 0.5, 1.0].map(|angle| along_x(1.0) * Rotor::about_z(angle));
    let clip = Clip::new(3, vec![0.0, 1.0], [&skeleton.rest_pose()[..], &turned].concat()).unwrap();
    let (root_motion, _) = RootMotion::extract(&clip, 0, RootMotionPart::All).unwrap();

    let mut instance = SkeletonInstance::new(&skeleton, along_x(5.0));
    let mut cache = ScrewCache::new(3);
    let mut retarget = Retarget::new(&skeleton, &skeleton);
    let (mut pose, mut out) = (skeleton.rest_pose().clone(), skeleton.rest_pose().clone());
    let mut model = vec![Motor::IDENTITY; 3];
    let times: Vec<f64> = (0..40).map(|character| 0.05 * f64::from(character)).collect();
    let (mut crowd, mut crowd_model) = (Poses::new(3, times.len()), Poses::new(3, times.len()));
    let (mut points, mut normals) = ([Point::ORIGIN; 4], [Direction::X; 4]);
    let (bound, bound_normals) = (points, normals);
    let influences = Influences { joints: &[[0, 2]; 4], weights: &[[0.5, 0.25]; 4] };

    let frame = || {
        for interpolation in Interpolation::ALL {
            for wrap in [Wrap::Clamp, Wrap::Loop] {
                clip.sample_into(0.3, interpolation, wrap, &mut pose).unwrap();
                animate_sample(&skeleton, &mut instance, &clip, 7.3, interpolation, wrap, &mut out).unwrap();
                root_motion.between(0.3, 8.1, interpolation, wrap).unwrap();
            }
        }
        clip.sample_cached_into(0.3, Wrap::Loop, &mut cache, &mut pose).unwrap();
        crowd.animate(&skeleton, &clip, &times, Interpolation::Screw, Wrap::Loop).unwrap();
        crowd.local_to_model_into(&skeleton, &mut crowd_model).unwrap();
        local_to_model(&skeleton, &pose, &mut model).unwrap();
        animate_keyframe(&skeleton, &mut instance, &pose).unwrap();
        let layers = [Layer::new(&pose, 0.3), Layer::new(&turned, 0.5).with_joint_weights(&[0.0, 1.0, 0.1])];
        blend_poses(&skeleton, &layers, 0.9, &mut out).unwrap();
        deviation_into(&pose, &turned, &mut out).unwrap();
        let deviation = [out[0], out[1], out[2]];
        add_layers(&[Layer::new(&deviation, 0.5)], &mut pose).unwrap();
        retarget.pose_into(&pose, &mut out).unwrap();
        local_to_model(&skeleton, &pose, &mut model).unwrap();
        TwoBone::new(0, 1, 2, Point::new(1.0, 1.0, 1.0)).solve(&skeleton, &mut pose, &mut model).unwrap();
        Aim::new(1, Direction::Y, Point::new(9.0, 1.0, 1.0)).solve(&skeleton, &mut pose, &mut model).unwrap();
        skinning_motors(&skeleton, &model, &mut out).unwrap();
        skin_points(&out, influences, &bound, &mut points).unwrap();
        skin_points_linear(&out, influences, &bound, &mut points).unwrap();
        skin_normals(&out, influences, &bound_normals, &mut normals).unwrap();
        skin_normals_linear(&out, influences, &bound_normals, &mut normals).unwrap();
    };
    assert_eq!(allocations(frame), 0);
}
