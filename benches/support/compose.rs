//! One motion after another.

use std::hint::black_box;

use glam::{Affine3A, DAffine3, DMat4, Mat4};
use nalgebra::{Isometry3, UnitDualQuaternion};
use pga_motor::{f32, f64};
use ultraviolet::Isometry3x8;

#[cfg(feature = "peers")]
use super::motion::Peer;
use super::motion::{DoublePair, Motion, SinglePair, blocks, images, motions, motor};
use super::{COUNT, Contender, DOUBLE, SINGLE, Workload, list, pairs};

pub(super) const WORKLOADS: &[Workload] = &[
    Workload {
        name: "compose 1024 pairs",
        items: COUNT,
        tolerance: SINGLE,
        contenders: || {
            vec![
                in_blocks(),
                of_pairs::<Isometry3x8>(),
                of_pairs::<Affine3A>(),
                of_pairs::<SinglePair>(),
                of_pairs::<Isometry3<f32>>(),
                #[cfg(feature = "peers")]
                of_pairs::<Peer>(),
            ]
        },
    },
    Workload {
        name: "compose 1024 pairs, arrays of structs",
        items: COUNT,
        tolerance: SINGLE,
        contenders: || {
            vec![
                of_pairs::<f32::Motor>(),
                of_pairs::<Affine3A>(),
                of_pairs::<Mat4>(),
                of_pairs::<SinglePair>(),
                of_pairs::<Isometry3<f32>>(),
                of_pairs::<UnitDualQuaternion<f32>>(),
                of_pairs::<ultraviolet::Isometry3>(),
                #[cfg(feature = "peers")]
                of_pairs::<Peer>(),
            ]
        },
    },
    Workload {
        name: "compose 1024 pairs, arrays of structs, f64",
        items: COUNT,
        tolerance: DOUBLE,
        contenders: || {
            vec![
                of_pairs::<f64::Motor>(),
                of_pairs::<DAffine3>(),
                of_pairs::<DMat4>(),
                of_pairs::<DoublePair>(),
                of_pairs::<Isometry3<f64>>(),
            ]
        },
    },
    Workload {
        name: "compose, 16 chains of 64",
        items: COUNT,
        // Rounding goes now one way, now the other: the root of 64.
        tolerance: 8.0 * SINGLE,
        contenders: || {
            vec![
                chains::<f32::Motor>(),
                chains::<Affine3A>(),
                chains::<Mat4>(),
                chains::<SinglePair>(),
                chains::<Isometry3<f32>>(),
                chains::<ultraviolet::Isometry3>(),
                #[cfg(feature = "peers")]
                chains::<Peer>(),
            ]
        },
    },
];

/// Longer than chains of joints. Far longer ones would not measure products: after some 300 of them the lanes that glam's Affine3A has no
/// use for have faded to subnormal numbers, and each product takes ten times as long.
const CHAIN: usize = 64;

fn factors() -> (Vec<f64::Motor>, Vec<f64::Motor>) {
    (list(motor), list(|i| motor(COUNT - 1 - i)))
}

fn in_blocks() -> Contender {
    let (a, b) = factors();
    let (a, b) = (blocks(motions::<f32::Motor>(&a)), blocks(motions(&b)));
    Contender::new(
        "Blocks<Motor>",
        a.clone(),
        move |out| black_box(&a).mul_into(black_box(&b), out).expect("lists of one length"),
        |out| images(&Vec::from(out)),
    )
}

fn of_pairs<M: Motion>() -> Contender {
    let (a, b) = factors();
    pairs(M::NAME, motions(&a), motions(&b), M::after, |out| images(out))
}

/// Each product waits for the one before.
fn chains<M: Motion>() -> Contender {
    let factors: Vec<M> = motions(&list(motor));
    let identity = M::of(&[f64::Motor::IDENTITY]);
    let run = move |out: &mut Vec<M>| {
        for (out, chain) in out.iter_mut().zip(black_box(&factors).chunks_exact(CHAIN)) {
            *out = chain.iter().fold(black_box(identity), |product, next| product.after(*next));
        }
    };
    Contender::new(M::NAME, vec![identity; COUNT / CHAIN], run, |out| images(out))
}
