//! Points: many by one motion, and each by its own.

use std::hint::black_box;

use glam::{Affine3A, DAffine3, DMat4, Mat4, Vec3};
use nalgebra::{Isometry3, UnitDualQuaternion};
use pga_motor::{f32, f64};
use ultraviolet::Isometry3x8;

#[cfg(feature = "peers")]
use super::motion::Peer;
use super::motion::{self, DoublePair, Motion, SinglePair, blocks, coordinates, motions, motor, point};
use super::{COUNT, Contender, DOUBLE, SINGLE, Workload, each, list, pairs};

/// More than the caches near a core hold.
const MANY: usize = 1 << 20;

pub(super) const WORKLOADS: &[Workload] = &[
    Workload {
        name: "one motor, 1024 points",
        items: COUNT,
        tolerance: SINGLE,
        contenders: || {
            vec![
                by_one_in_blocks(COUNT),
                by_one_in_slices(COUNT),
                by_one::<Mat4>(COUNT),
                by_one::<Affine3A>(COUNT),
                by_one::<SinglePair>(COUNT),
                by_one::<Isometry3<f32>>(COUNT),
                by_one::<Isometry3x8>(COUNT),
                #[cfg(feature = "peers")]
                by_one::<Peer>(COUNT),
            ]
        },
    },
    Workload {
        name: "one motor, 1M points",
        items: MANY,
        tolerance: SINGLE,
        contenders: || {
            vec![
                by_one_in_blocks(MANY),
                copy(),
                by_one_in_slices(MANY),
                by_one::<Mat4>(MANY),
                by_one::<Affine3A>(MANY),
                by_one::<Isometry3x8>(MANY),
            ]
        },
    },
    Workload {
        name: "one motor, 1M points in place",
        items: MANY,
        tolerance: SINGLE,
        contenders: || {
            vec![
                in_place_in_blocks(),
                copy(),
                in_place_in_slices(),
                in_place::<Mat4>(),
                in_place::<Affine3A>(),
                in_place::<SinglePair>(),
                in_place::<Isometry3<f32>>(),
                in_place::<Isometry3x8>(),
            ]
        },
    },
    Workload {
        name: "1024 motors, 1024 points",
        items: COUNT,
        tolerance: SINGLE,
        contenders: || {
            vec![
                by_many_in_blocks(),
                by_many::<Isometry3x8>(),
                by_many::<Affine3A>(),
                by_many::<SinglePair>(),
                by_many::<Isometry3<f32>>(),
                #[cfg(feature = "peers")]
                by_many::<Peer>(),
            ]
        },
    },
    Workload {
        name: "1024 motors, 1024 points, arrays of structs",
        items: COUNT,
        tolerance: SINGLE,
        contenders: || {
            vec![
                by_many::<f32::Motor>(),
                by_many::<Affine3A>(),
                by_many::<Mat4>(),
                by_many::<SinglePair>(),
                by_many::<Isometry3<f32>>(),
                by_many::<UnitDualQuaternion<f32>>(),
                by_many::<ultraviolet::Isometry3>(),
                #[cfg(feature = "peers")]
                by_many::<Peer>(),
            ]
        },
    },
    Workload {
        name: "1024 motors, 1024 points, arrays of structs, f64",
        items: COUNT,
        tolerance: DOUBLE,
        contenders: || {
            vec![
                by_many::<f64::Motor>(),
                by_many::<DAffine3>(),
                by_many::<DMat4>(),
                by_many::<DoublePair>(),
                by_many::<Isometry3<f64>>(),
            ]
        },
    },
];

fn points<M: Motion>(count: usize) -> Vec<M::Point> {
    motion::points::<M>(&(0..count).map(point).collect::<Vec<_>>())
}

/// The motion of all points.
fn one<M: Motion>() -> M {
    M::of(&vec![motor(3); M::LANES])
}

fn by_one<M: Motion>(count: usize) -> Contender {
    let motion: M = one();
    each(M::NAME, points::<M>(count), move |point| motion.carry(point), |out| coordinates::<M>(out))
}

fn by_one_in_blocks(count: usize) -> Contender {
    let (motor, points): (f32::Motor, _) = (one(), blocks(points::<f32::Motor>(count)));
    Contender::new(
        "Blocks<Point>",
        points.clone(),
        move |out| black_box(motor).transform_point_blocks(black_box(&points), out).expect("lists of one length"),
        |out| coordinates::<f32::Motor>(&Vec::from(out)),
    )
}

fn by_one_in_slices(count: usize) -> Contender {
    let (motor, points): (f32::Motor, _) = (one(), points::<f32::Motor>(count));
    Contender::new(
        "ours, array of structs",
        points.clone(),
        move |out| black_box(motor).transform_points(black_box(&points), out).expect("slices of one length"),
        |out| coordinates::<f32::Motor>(out),
    )
}

/// No contender but a measure: what it costs to get the bytes there.
fn copy() -> Contender {
    let points = points::<Mat4>(MANY);
    let run = move |out: &mut Vec<Vec3>| out.copy_from_slice(black_box(&points));
    Contender::new("memcpy of as many bytes", vec![Vec3::ZERO; MANY], run, |_| Vec::new())
}

fn in_place<M: Motion>() -> Contender {
    let motion: M = one();
    let run = move |out: &mut Vec<M::Point>| {
        let motion = black_box(motion);
        for point in out {
            *point = motion.carry(*point);
        }
    };
    Contender::new(M::NAME, points::<M>(MANY), run, |out| coordinates::<M>(out))
}

fn in_place_in_blocks() -> Contender {
    let motor: f32::Motor = one();
    Contender::new(
        "Blocks<Point>",
        blocks(points::<f32::Motor>(MANY)),
        move |out| black_box(motor).transform_point_blocks_in_place(out),
        |out| coordinates::<f32::Motor>(&Vec::from(out)),
    )
}

fn in_place_in_slices() -> Contender {
    let motor: f32::Motor = one();
    Contender::new(
        "ours, array of structs",
        points::<f32::Motor>(MANY),
        move |out| black_box(motor).transform_points_in_place(out),
        |out| coordinates::<f32::Motor>(out),
    )
}

fn by_many<M: Motion>() -> Contender {
    pairs(M::NAME, motions(&list(motor)), points::<M>(COUNT), M::carry, |out| coordinates::<M>(out))
}

fn by_many_in_blocks() -> Contender {
    let motors = blocks(motions::<f32::Motor>(&list(motor)));
    let points = blocks(points::<f32::Motor>(COUNT));
    Contender::new(
        "Blocks",
        points.clone(),
        move |out| black_box(&motors).transform_points_into(black_box(&points), out).expect("lists of one length"),
        |out| coordinates::<f32::Motor>(&Vec::from(out)),
    )
}
