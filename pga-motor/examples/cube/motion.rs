//! How the cube moves.

use std::f64::consts::{PI, TAU};

use pga_motor::f64::{Direction, Line, Motor, Point};

/// A motion that comes back to where it began.
pub(crate) struct Motion {
    pub(crate) name: &'static str,
    pub(crate) formula: &'static str,
    pub(crate) remark: &'static str,
    /// Where the cube is at a time from 0 to 1.
    pub(crate) at: fn(f64) -> Motor,
}

pub(crate) fn all() -> [Motion; 3] {
    [
        Motion {
            name: "a sum of lines",
            formula: "exp(α x + β y + …)",
            remark: "turns and steps at once, in no order",
            at: by_sum,
        },
        Motion {
            name: "screws",
            formula: "exp(α a + δ a*) T exp(α b)",
            remark: "round a line and along it, with a turn of its own",
            at: by_screws,
        },
        Motion {
            name: "a product of motors",
            formula: "T R T R",
            remark: "what stands right acts first",
            at: by_product,
        },
    ]
}

/// The unit line through a point.
fn axis(through: [f64; 3], along: [f64; 3]) -> Line {
    let [[x, y, z], [u, v, w]] = [through, along];
    let direction = Direction::new(u, v, w).normalize().expect("the axes have directions");
    Point::new(x, y, z) & direction
}

/// The generator of the turn about a unit line by an angle: its exponential is the motor.
fn turn(axis: Line, angle: f64) -> Line {
    axis * (-angle / 2.0)
}

/// The generator of a translation.
fn translation(vector: [f64; 3]) -> Line {
    let [x, y, z] = vector.map(|length| -length / 2.0);
    Line::new(0.0, 0.0, 0.0, x, y, z)
}

/// Turns about three axes that meet in the cube's centre, and translations along them, all in one exponential.
fn by_sum(t: f64) -> Motor {
    let [x, y, z] = [Direction::X, Direction::Y, Direction::Z].map(|along| Point::ORIGIN & along);
    let swing = |times: f64, angle: f64| angle * (TAU * times * t).sin();
    let turns = turn(x, swing(1.0, PI)) + turn(y, swing(2.0, 0.8 * PI)) + turn(z, swing(3.0, 0.4 * PI));
    (turns + translation([swing(2.0, 1.5), swing(1.0, 1.2), swing(3.0, 0.9)])).exp()
}

/// Once round a slanting line, twice up and down along it, while the cube beside the line turns about a diagonal of its own.
fn by_screws(t: f64) -> Motor {
    let slanting = axis([0.0; 3], [0.3, 1.0, 0.2]);
    let slide = slanting.direction() * (0.6 * (2.0 * TAU * t).sin());
    let outer = turn(slanting, TAU * t) + translation(slide.to_array());
    let beside = translation([-1.2, 0.0, 0.0]);
    let own = turn(axis([0.0; 3], [1.0, 1.0, 1.0]), TAU * t);
    outer.exp() * beside.exp() * own.exp()
}

/// Twice round its own axis, which lies over; that carried out and once round an upright one; that up and down.
fn by_product(t: f64) -> Motor {
    let inner = turn(axis([0.0; 3], [1.0, 0.4, 0.0]), 2.0 * TAU * t).exp();
    let out = translation([1.3, 0.0, 0.0]).exp();
    let outer = turn(axis([0.0; 3], [0.0, 1.0, 0.0]), TAU * t).exp();
    let lift = translation([0.0, 0.7 * (2.0 * TAU * t).sin(), 0.0]).exp();
    lift * outer * out * inner
}
