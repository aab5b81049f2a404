//! Generators and motors to try the laws on: common ones, and those at which formulas fail.

use crate::motion::Motion;
use pga_motor::Real;
use proptest::prelude::*;
use proptest::sample::select;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, LOG10_2, PI};

/// Powers of ten that samples go down to.
#[derive(Clone, Copy)]
pub(crate) struct Range {
    /// Of half-angles and of what tells an axis from a coordinate axis.
    angle: f64,
    /// Of small ideal parts.
    ideal: f64,
}

/// All that the type can hold.
pub(crate) fn full<M: Motion>() -> Range {
    Range { angle: if is_double::<M>() { -300.0 } else { -30.0 }, ideal: -12.0 }
}

/// So that products of what several operations make of the samples do not underflow.
pub(crate) fn far_from_underflow<M: Motion>() -> Range {
    if is_double::<M>() { Range { angle: -30.0, ideal: -12.0 } } else { Range { angle: -3.0, ideal: -3.0 } }
}

pub(crate) fn is_double<M: Motion>() -> bool {
    M::unit() < 1e-10
}

fn power_of_ten(exponent: f64) -> f64 {
    10_f64.powf(exponent)
}

/// From the least power of ten to pi, logarithmically; at and near 0, pi/4, pi/2, half a turn, and pi.
fn half_angles(range: Range) -> impl Strategy<Value = f64> {
    let special = select(vec![0.0, FRAC_PI_4, FRAC_PI_2, PI]);
    let distance = (-17.0..0.0).prop_map(power_of_ten);
    prop_oneof![
        4 => (range.angle..5.0 * LOG10_2).prop_map(|exponent| power_of_ten(exponent).min(PI)),
        3 => (special.clone(), distance, select(vec![1.0, -1.0]))
            .prop_map(|(value, distance, sign)| f64::min((value + sign * distance).abs(), PI)),
        1 => special,
    ]
}

fn normalized(vector: [f64; 3]) -> [f64; 3] {
    vector.map(|coordinate| coordinate / f64::norm(vector))
}

fn cross([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> [f64; 3] {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

fn vectors() -> impl Strategy<Value = [f64; 3]> {
    [-1.0..1.0, -1.0..1.0, -1.0..1.0].prop_filter("not 0", |&vector| f64::norm(vector) > 1e-3)
}

fn coordinate_axes() -> impl Strategy<Value = [f64; 3]> {
    (0..3_usize, select(vec![1.0, -1.0])).prop_map(|(i, sign)| {
        let mut axis = [0.0; 3];
        axis[i] = sign;
        axis
    })
}

/// Of length 1: any, along coordinate axes, and nearly so.
pub(crate) fn directions(range: Range) -> impl Strategy<Value = [f64; 3]> {
    let small = (range.angle..0.0).prop_map(power_of_ten);
    prop_oneof![
        2 => vectors().prop_map(normalized),
        1 => coordinate_axes(),
        1 => (coordinate_axes(), vectors(), small).prop_map(|(axis, vector, size)| {
            normalized([0, 1, 2].map(|i| axis[i] + size * vector[i]))
        }),
    ]
}

/// None, small, about 1 and about a million.
fn lengths(range: Range) -> impl Strategy<Value = f64> {
    prop_oneof![Just(0.0), (range.ideal..0.0).prop_map(power_of_ten), 0.5..2.0, 5e5..2e6,]
}

/// An axis, with a moment in any direction, along the axis or perpendicular to it.
fn axes_and_moments(range: Range) -> impl Strategy<Value = ([f64; 3], [f64; 3])> {
    (directions(range), vectors(), lengths(range), 0..3).prop_map(|(axis, vector, length, kind)| {
        let across = cross(axis, vector);
        let direction = match kind {
            0 => axis,
            1 if f64::norm(across) > 1e-3 => normalized(across),
            _ => normalized(vector),
        };
        (axis, direction.map(|coordinate| coordinate * length))
    })
}

pub(crate) fn generators<M: Motion>(range: Range) -> impl Strategy<Value = M::Generator> {
    (half_angles(range), axes_and_moments(range))
        .prop_map(|(half_angle, (axis, moment))| M::generator(axis.map(|coordinate| coordinate * half_angle), moment))
}

/// Exponentials and exact half turns, and their negatives.
pub(crate) fn motors<M: Motion>(range: Range) -> impl Strategy<Value = M> {
    let half_turns = axes_and_moments(range).prop_map(|(axis, moment)| M::half_turn(axis, moment));
    let motors = prop_oneof![6 => generators::<M>(range).prop_map(M::exp), 1 => half_turns];
    (motors, any::<bool>()).prop_map(|(motor, negative)| if negative { -motor } else { motor })
}

/// Two motors; often near one another, or nearly half a turn or a whole turn apart.
pub(crate) fn pairs<M: Motion>(range: Range) -> impl Strategy<Value = (M, M)> {
    let pair = |(a, b, apart): (M, M, bool)| (a, if apart { b } else { (a * b).renormalize() });
    (motors::<M>(range), motors::<M>(range), any::<bool>()).prop_map(pair)
}

/// Parts of the way, the ends and the middle included; exact in `f32`.
pub(crate) fn times() -> impl Strategy<Value = f64> {
    prop_oneof![
        3 => (0.0_f32..1.0).prop_map(f64::from),
        1 => select(vec![0.0, 0.25, 0.5, 0.75, 1.0]),
        1 => (-12.0..0.0).prop_map(|exponent| f64::from(power_of_ten(exponent) as f32)),
    ]
}

/// Parts t of the way for which 1 - t is exact in `f32`.
pub(crate) fn exact_times() -> impl Strategy<Value = f64> {
    (0..=1_u32 << 20).prop_map(|part| f64::from(part) / f64::from(1_u32 << 20))
}

/// Factors of a generator that leave the angle within a turn or two.
pub(crate) fn factors() -> impl Strategy<Value = f64> {
    (-2.0_f32..2.0).prop_map(f64::from)
}
