//! Between two motions.
//!
//! Others mostly interpolate the rotation and the place apart, the place along a straight line: another way than nlerp's and
//! screw_lerp's. Of all contenders both ends are compared, and the rotation at the time that is measured; the place there only of
//! those that go our way.

use std::hint::black_box;

use nalgebra::{Isometry3, UnitDualQuaternion};
use pga_motor::LengthMismatch;
use pga_motor::batch::Blocks;
use pga_motor::f32::Motor;
use ultraviolet::{Isometry3x8, Lerp, Slerp, f32x8};

use super::motion::{Motion, Pair, SinglePair, blocks, images, motions, motor};
use super::{COUNT, Contender, SINGLE, Workload, list, pairs};

pub(super) const WORKLOADS: &[Workload] = &[
    Workload {
        name: "nlerp",
        items: COUNT,
        tolerance: SINGLE,
        contenders: || {
            vec![
                in_blocks("Blocks<Motor>", Blocks::nlerp_into),
                in_slices("ours, arrays of structs", Motor::nlerp_slice),
                between("ours, one by one", Agreement::Whole, Motor::nlerp),
                between("ultraviolet x8 lerp", Agreement::Turns, lerp_x8),
                between("glam Quat lerp, Vec3 lerp", Agreement::Turns, lerp_parts),
                between("nalgebra UnitDualQuaternion nlerp", Agreement::Whole, |a: UnitDualQuaternion<f32>, b, t| {
                    a.nlerp(&b, t)
                }),
            ]
        },
    },
    Workload {
        name: "slerp",
        items: COUNT,
        tolerance: SINGLE,
        contenders: || {
            vec![
                in_blocks("Blocks<Motor>", Blocks::slerp_into),
                in_slices("ours, arrays of structs", Motor::slerp_slice),
                between("ours, one by one", Agreement::Whole, Motor::slerp),
                between("ultraviolet x8 slerp, lerp", Agreement::Turns, slerp_x8),
                between("glam Quat slerp, Vec3 lerp", Agreement::Turns, slerp_parts),
            ]
        },
    },
    Workload {
        name: "screw_lerp",
        items: COUNT,
        tolerance: SINGLE,
        contenders: || {
            vec![
                in_blocks("Blocks<Motor>", Blocks::screw_lerp_into),
                in_slices("ours, arrays of structs", Motor::screw_lerp_slice),
                between("ours, one by one", Agreement::Whole, Motor::screw_lerp),
                between("ultraviolet x8 slerp, lerp", Agreement::Turns, slerp_x8),
                between("glam Quat slerp, Vec3 lerp", Agreement::Turns, slerp_parts),
                between("nalgebra UnitDualQuaternion sclerp", Agreement::Whole, |a: UnitDualQuaternion<f32>, b, t| {
                    a.sclerp(&b, t)
                }),
                #[cfg(feature = "peers")]
                between("geometric_algebra powf", Agreement::Whole, peers::screw),
            ]
        },
    },
    Workload {
        name: "split_lerp",
        items: COUNT,
        tolerance: SINGLE,
        contenders: || {
            vec![
                in_blocks("Blocks<Motor>", Blocks::split_lerp_into),
                in_slices("ours, arrays of structs", Motor::split_lerp_slice),
                between("ours, one by one", Agreement::Whole, Motor::split_lerp),
                between("ultraviolet x8 slerp, lerp", Agreement::Whole, slerp_x8),
                between("glam Quat slerp, Vec3 lerp", Agreement::Whole, slerp_parts),
                between("nalgebra Isometry3 lerp_slerp", Agreement::Whole, |a: Isometry3<f32>, b, t| {
                    a.lerp_slerp(&b, t)
                }),
            ]
        },
    },
];

/// Where it is timed, and where contenders are compared in between.
pub(super) const T: f32 = 0.3;

/// What of a way is as ours is.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Agreement {
    /// The ends, and how far it has turned in between.
    Turns,
    /// The motions in between too.
    Whole,
}

/// What is compared of some motions' ways.
pub(super) fn along<M: Motion>(agreement: Agreement, mut at: impl FnMut(f32) -> Vec<M>) -> Vec<f64> {
    let mut results = [images(&at(0.0)), images(&at(1.0))].concat();
    let middle = images(&at(T));
    // The images of the origin stand before those of the other points.
    let (origins, others) = middle.split_at(middle.len() / 4);
    results.extend(others.iter().zip(origins.iter().cycle()).map(|(other, origin)| other - origin));
    if agreement == Agreement::Whole {
        results.extend(middle);
    }
    results
}

fn ends<M: Motion>() -> (Vec<M>, Vec<M>) {
    (motions(&list(motor)), motions(&list(|i| motor(i + 3))))
}

fn between<M: Motion>(
    name: &'static str,
    agreement: Agreement,
    function: impl Fn(M, M, f32) -> M + Copy + 'static,
) -> Contender {
    let (a, b) = ends::<M>();
    let results = along(agreement, |t| a.iter().zip(&b).map(|(a, b)| function(*a, *b, t)).collect());
    let t = T;
    pairs(name, a, b, move |a, b| function(a, b, t), |_| results)
}

fn in_blocks(
    name: &'static str,
    function: impl Fn(&Blocks<Motor>, &Blocks<Motor>, f32, &mut Blocks<Motor>) -> Result<(), LengthMismatch> + 'static,
) -> Contender {
    let (a, b) = ends::<Motor>();
    let (a, b) = (blocks(a), blocks(b));
    let results = along(Agreement::Whole, |t| {
        let mut motors = a.clone();
        function(&a, &b, t, &mut motors).expect("lists of one length");
        Vec::from(&motors)
    });
    let run =
        move |out: &mut _| function(black_box(&a), black_box(&b), black_box(T), out).expect("lists of one length");
    Contender::new(name, blocks(ends().0), run, |_| results)
}

fn in_slices(
    name: &'static str,
    function: impl Fn(&[Motor], &[Motor], f32, &mut [Motor]) -> Result<(), LengthMismatch> + 'static,
) -> Contender {
    let (a, b) = ends::<Motor>();
    let results = along(Agreement::Whole, |t| {
        let mut motors = a.clone();
        function(&a, &b, t, &mut motors).expect("slices of one length");
        motors
    });
    let run = move |out: &mut Vec<Motor>| {
        function(black_box(&a), black_box(&b), black_box(T), out).expect("slices of one length");
    };
    Contender::new(name, ends().0, run, |_| results)
}

pub(super) fn lerp_parts(a: SinglePair, b: SinglePair, t: f32) -> SinglePair {
    Pair::new(a.rotation.lerp(b.rotation, t), a.translation.lerp(b.translation, t))
}

pub(super) fn slerp_parts(a: SinglePair, b: SinglePair, t: f32) -> SinglePair {
    Pair::new(a.rotation.slerp(b.rotation, t), a.translation.lerp(b.translation, t))
}

fn lerp_x8(a: Isometry3x8, b: Isometry3x8, t: f32) -> Isometry3x8 {
    let t = f32x8::splat(t);
    Isometry3x8::new(a.translation.lerp(b.translation, t), a.rotation.lerp(b.rotation, t).normalized())
}

fn slerp_x8(a: Isometry3x8, b: Isometry3x8, t: f32) -> Isometry3x8 {
    let t = f32x8::splat(t);
    Isometry3x8::new(a.translation.lerp(b.translation, t), a.rotation.slerp(b.rotation, t))
}

#[cfg(feature = "peers")]
mod peers {
    use super::super::motion::Peer;
    use geometric_algebra::{GeometricProduct, Powf, Reversal};

    pub(super) fn screw(a: Peer, b: Peer, t: f32) -> Peer {
        a.geometric_product(a.reversal().geometric_product(b).powf(t))
    }
}
