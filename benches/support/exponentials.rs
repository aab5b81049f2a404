//! Exponentials of lines and logarithms of motors. Of the crates measured only geometric_algebra has them for motions; glam, nalgebra
//! and ultraviolet have them for rotations, which is less.

use std::hint::black_box;

use pga_motor::f32::{Line, Motor};
use pga_motor::f64;

use super::motion::{blocks, images, motions, motor};
use super::{COUNT, Contender, SINGLE, Workload, each, list};

pub(super) const WORKLOADS: &[Workload] = &[
    Workload {
        name: "exp",
        items: COUNT,
        tolerance: SINGLE,
        contenders: || {
            vec![
                exp_in_blocks(),
                each("ours, one by one", lines(), Line::exp, |out| images(out)),
                #[cfg(feature = "peers")]
                peers::exp(),
            ]
        },
    },
    Workload {
        name: "log",
        items: COUNT,
        tolerance: SINGLE,
        contenders: || {
            vec![
                log_in_blocks(),
                each("ours, one by one", motions(&motors()), Motor::log, |out| numbers(out)),
                #[cfg(feature = "peers")]
                peers::log(),
            ]
        },
    },
];

/// Those that turn by at most half a turn: others take the logarithm of the long way where the scalar part is negative.
fn motors() -> Vec<f64::Motor> {
    list(|i| if motor(i).s < 0.0 { -motor(i) } else { motor(i) })
}

fn lines() -> Vec<Line> {
    let single = |line: f64::Line| Line::from(line.to_array().map(|coefficient| coefficient as f32));
    motors().into_iter().map(|motor| single(motor.log())).collect()
}

fn numbers(lines: &[Line]) -> Vec<f64> {
    lines.iter().flat_map(|line| line.to_array().map(f64::from)).collect()
}

fn exp_in_blocks() -> Contender {
    let lines = blocks(lines());
    Contender::new(
        "Blocks<Line>",
        blocks(vec![Motor::IDENTITY; COUNT]),
        move |out| black_box(&lines).exp_into(out).expect("lists of one length"),
        |out| images(&Vec::from(out)),
    )
}

fn log_in_blocks() -> Contender {
    let motors = blocks(motions::<Motor>(&motors()));
    Contender::new(
        "Blocks<Motor>",
        blocks(vec![Line::ZERO; COUNT]),
        move |out| black_box(&motors).log_into(out).expect("lists of one length"),
        |out| numbers(&Vec::from(out)),
    )
}

#[cfg(feature = "peers")]
mod peers {
    use super::super::motion::{Motion, Peer, images, motions};
    use super::{Contender, Line, each, lines, motors, numbers};
    use geometric_algebra::{Exp, Ln, ppga3d};

    pub(super) fn exp() -> Contender {
        let theirs = |Line { e23, e31, e12, e01, e02, e03 }| ppga3d::Line::new(e01, e02, e03, e23, e31, e12);
        each(Peer::NAME, lines().into_iter().map(theirs).collect(), ppga3d::Line::exp, |out| images(out))
    }

    pub(super) fn log() -> Contender {
        let ours = |line: &ppga3d::Line| Line::new(line[3], line[4], line[5], line[0], line[1], line[2]);
        let results = |out: &Vec<ppga3d::Line>| numbers(&out.iter().map(ours).collect::<Vec<_>>());
        each(Peer::NAME, motions(&motors()), Peer::ln, results)
    }
}
