//! Directions, lines and planes, by one motion.

use std::hint::black_box;

use glam::{Affine3A, Mat4, Vec3, Vec4};
use nalgebra::{Isometry3, Vector3};
use pga_motor::batch::{Blocks, Lanewise};
use pga_motor::f32::{Direction, Line, Motor, Plane};
use pga_motor::{LengthMismatch, f64};

use super::motion::{Motion, SinglePair, blocks, motor, point};
use super::{COUNT, Contender, SINGLE, Workload, each, list};

pub(super) const WORKLOADS: &[Workload] = &[
    Workload {
        name: "one motor, 1024 directions",
        items: COUNT,
        tolerance: SINGLE,
        contenders: || {
            let (affine, matrix): (Affine3A, Mat4) = (one(), one());
            let SinglePair { rotation, .. } = one();
            let turn = one::<Isometry3<f32>>().rotation;
            let vectors = || list(|i| Vec3::from(direction(i)));
            vec![
                in_blocks("Blocks<Direction>", list(direction), Motor::transform_direction_blocks),
                one_by_one(list(direction), Motor::transform_direction),
                each("glam Affine3A", vectors(), move |v| affine.transform_vector3(v), |out| vector_numbers(out)),
                each("glam Mat4", vectors(), move |v| matrix.transform_vector3(v), |out| vector_numbers(out)),
                each("glam Quat", vectors(), move |v| rotation * v, |out| vector_numbers(out)),
                each(
                    "nalgebra UnitQuaternion",
                    list(|i| Vector3::from(direction(i).to_array())),
                    move |v| turn * v,
                    |out| numbers(out.iter().map(|&v| v.into())),
                ),
            ]
        },
    },
    Workload {
        name: "one motor, 1024 lines",
        items: COUNT,
        tolerance: SINGLE,
        contenders: || {
            vec![
                in_blocks("Blocks<Line>", list(line), Motor::transform_line_blocks),
                one_by_one(list(line), Motor::transform_line),
                #[cfg(feature = "peers")]
                peers::lines(),
            ]
        },
    },
    Workload {
        name: "one motor, 1024 planes",
        items: COUNT,
        tolerance: SINGLE,
        contenders: || {
            // Planes go the other way than points.
            let matrix = one::<Mat4>().inverse().transpose();
            let vectors = list(|i| Vec4::from(plane(i).to_array()));
            vec![
                in_blocks("Blocks<Plane>", list(plane), Motor::transform_plane_blocks),
                one_by_one(list(plane), Motor::transform_plane),
                each(
                    "glam Mat4, inverse transposed",
                    vectors,
                    move |v| matrix * v,
                    |out| numbers(out.iter().map(|v| v.to_array())),
                ),
                #[cfg(feature = "peers")]
                peers::planes(),
            ]
        },
    },
];

/// The motion of all of them.
fn one<M: Motion>() -> M {
    M::of(&[motor(3)])
}

fn direction(index: usize) -> Direction {
    Direction::from(point(index).to_array().map(|coordinate| coordinate as f32))
}

/// The axis and the pitch of a motion: a line in general, a screw.
fn line(index: usize) -> Line {
    Line::from(motor(index).log().to_array().map(|coefficient| coefficient as f32))
}

fn plane(index: usize) -> Plane {
    let f64::Point { x, y, z } = point(index);
    Plane::from([x, y, z, x - y].map(|coefficient| coefficient as f32))
}

fn numbers<const N: usize>(items: impl Iterator<Item = [f32; N]>) -> Vec<f64> {
    items.flatten().map(f64::from).collect()
}

fn vector_numbers(vectors: &[Vec3]) -> Vec<f64> {
    numbers(vectors.iter().map(|v| v.to_array()))
}

fn in_blocks<E, const N: usize>(
    name: &'static str,
    items: Vec<E>,
    transform: impl Fn(Motor, &Blocks<E>, &mut Blocks<E>) -> Result<(), LengthMismatch> + 'static,
) -> Contender
where
    E: Lanewise + Into<[f32; N]> + 'static,
{
    let (motor, items) = (one::<Motor>(), blocks(items));
    Contender::new(
        name,
        items.clone(),
        move |out| transform(black_box(motor), black_box(&items), out).expect("lists of one length"),
        |out| numbers(out.iter().map(E::into)),
    )
}

fn one_by_one<E, const N: usize>(items: Vec<E>, transform: impl Fn(Motor, E) -> E + Copy + 'static) -> Contender
where
    E: Copy + Into<[f32; N]> + 'static,
{
    let motor: Motor = one();
    each("ours, one by one", items, move |e| transform(motor, e), |out| numbers(out.iter().map(|&e| e.into())))
}

#[cfg(feature = "peers")]
mod peers {
    use super::super::motion::{Motion, Peer};
    use super::{Contender, Line, Plane, each, line, list, numbers, one, plane};
    use geometric_algebra::{Transformation, ppga3d};

    pub(super) fn lines() -> Contender {
        let motor: Peer = one();
        let lines = list(|i| {
            let Line { e23, e31, e12, e01, e02, e03 } = line(i);
            ppga3d::Line::new(e01, e02, e03, e23, e31, e12)
        });
        let in_our_order = |line: &ppga3d::Line| [line[3], line[4], line[5], line[0], line[1], line[2]];
        each(Peer::NAME, lines, move |line| motor.transformation(line), |out| numbers(out.iter().map(in_our_order)))
    }

    pub(super) fn planes() -> Contender {
        let motor: Peer = one();
        let planes = list(|i| {
            let Plane { e1, e2, e3, e0 } = plane(i);
            ppga3d::Plane::new(e0, e1, e2, e3)
        });
        let in_our_order = |plane: &ppga3d::Plane| [plane[1], plane[2], plane[3], plane[0]];
        each(Peer::NAME, planes, move |plane| motor.transformation(plane), |out| numbers(out.iter().map(in_our_order)))
    }
}
