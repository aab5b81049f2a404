//! Motors between motors, pair by pair.

use super::Blocks;
use super::blocks::LANES;
use super::lanes::Lanewise;
use super::layout::{Sink, Source};
use super::work::{LaneCount, OnBlock, for_failures, zip};
use crate::scalar::{Fused, Precision, precision};
use crate::weights;
use crate::{EvenMultivector, LengthMismatch, Line, Motor, Real, kernels};

/// Motors between each of these and the one at the same index of `others`. Nothing is written where the lengths differ.
impl<T: Real> Blocks<Motor<T>> {
    /// Writes the motors on the straight lines: [`Motor::nlerp`].
    ///
    /// # Errors
    /// Lists of different lengths.
    pub fn nlerp_into(&self, others: &Self, t: T, motors: &mut Self) -> Result<(), LengthMismatch> {
        nlerp(self, others, t, motors)
    }

    /// Writes the motors at the great arcs' weights: [`Motor::slerp`], up to the last digits.
    ///
    /// For t from 0 to 1 by the polynomials of [`Motor::log_slice`] and [`Line::exp_slice`]; what these do not hold for, and other
    /// t, is done one by one.
    ///
    /// # Errors
    /// Lists of different lengths.
    pub fn slerp_into(&self, others: &Self, t: T, motors: &mut Self) -> Result<(), LengthMismatch> {
        slerp(self, others, t, motors)
    }

    /// Writes the motors on the screws: [`Motor::screw_lerp`], up to the last digits. By polynomials, as
    /// [`Self::slerp_into`].
    ///
    /// # Errors
    /// Lists of different lengths.
    pub fn screw_lerp_into(&self, others: &Self, t: T, motors: &mut Self) -> Result<(), LengthMismatch> {
        screw_lerp(self, others, t, motors)
    }
}

/// Motors between those of two arrays, pair by pair. Nothing is written where the lengths differ.
impl<T: Real> Motor<T> {
    /// Writes the motors on the straight lines: [`Self::nlerp`].
    ///
    /// # Errors
    /// Slices of different lengths.
    pub fn nlerp_slice(a: &[Self], b: &[Self], t: T, motors: &mut [Self]) -> Result<(), LengthMismatch> {
        nlerp(a, b, t, motors)
    }

    /// Writes the motors at the great arcs' weights: [`Self::slerp`], up to the last digits, as
    /// [`Blocks::slerp_into`](crate::batch::Blocks::slerp_into).
    ///
    /// # Errors
    /// Slices of different lengths.
    pub fn slerp_slice(a: &[Self], b: &[Self], t: T, motors: &mut [Self]) -> Result<(), LengthMismatch> {
        slerp(a, b, t, motors)
    }

    /// Writes the motors on the screws: [`Self::screw_lerp`], up to the last digits, as
    /// [`Blocks::screw_lerp_into`](crate::batch::Blocks::screw_lerp_into).
    ///
    /// # Errors
    /// Slices of different lengths.
    pub fn screw_lerp_slice(a: &[Self], b: &[Self], t: T, motors: &mut [Self]) -> Result<(), LengthMismatch> {
        screw_lerp(a, b, t, motors)
    }
}

fn nlerp<T: Real, A, B, D>(a: A, b: B, t: T, motors: D) -> Result<(), LengthMismatch>
where
    A: Source<Item = Motor<T>>,
    B: Source<Item = Motor<T>>,
    D: Sink<Item = Motor<T>>,
{
    if weights::is_between(t) {
        zip(a, b, motors, chord(t), chord(Fused(t)))
    } else {
        zip(a, b, motors, one_by_one(t, Motor::nlerp), one_by_one(Fused(t), Motor::nlerp))
    }
}

fn slerp<T: Real, A, B, D>(a: A, b: B, t: T, motors: D) -> Result<(), LengthMismatch>
where
    A: Source<Item = Motor<T>>,
    B: Source<Item = Motor<T>>,
    D: Sink<Item = Motor<T>>,
{
    match precision::<T>() {
        Precision::Single if weights::is_between(t) => zip(a, b, motors, Arcs(t, SINGLE), Arcs(Fused(t), SINGLE)),
        Precision::Double if weights::is_between(t) => zip(a, b, motors, Arcs(t, DOUBLE), Arcs(Fused(t), DOUBLE)),
        _ => zip(a, b, motors, one_by_one(t, Motor::slerp), one_by_one(Fused(t), Motor::slerp)),
    }
}

fn screw_lerp<T: Real, A, B, D>(a: A, b: B, t: T, motors: D) -> Result<(), LengthMismatch>
where
    A: Source<Item = Motor<T>>,
    B: Source<Item = Motor<T>>,
    D: Sink<Item = Motor<T>>,
{
    match precision::<T>() {
        Precision::Single if weights::is_between(t) => zip(a, b, motors, Screws(t, SINGLE), Screws(Fused(t), SINGLE)),
        Precision::Double if weights::is_between(t) => zip(a, b, motors, Screws(t, DOUBLE), Screws(Fused(t), DOUBLE)),
        _ => zip(a, b, motors, one_by_one(t, Motor::screw_lerp), one_by_one(Fused(t), Motor::screw_lerp)),
    }
}

/// A way between motors at one t.
fn one_by_one<S: Real>(
    t: S,
    way: impl Fn(Motor<S>, Motor<S>, S) -> Motor<S>,
) -> impl Fn((Motor<S>, Motor<S>)) -> Motor<S> {
    move |(a, b)| way(a, b, t)
}

/// [`Motor::nlerp`] at a t from 0 to 1, without a branch.
fn chord<S: Real>(t: S) -> impl Fn((Motor<S>, Motor<S>)) -> Motor<S> {
    let (starts_at_a, step) = (t <= S::from_ratio(1, 2), weights::chord(t).step);
    #[inline(always)]
    move |(a, b)| {
        let sign = sign_of(kernels::motor_scalar_product_motor_fma(a, b));
        let (a, b) = (a.to_array(), b.to_array());
        let sum = core::array::from_fn(|i| {
            let end = b[i] * sign;
            let (near, far) = if starts_at_a { (a[i], end) } else { (end, a[i]) };
            (far - near).mul_add(step, near)
        });
        kernels::even_normalize_fma(EvenMultivector::from(sum))
    }
}

#[inline(always)]
fn sign_of<S: Real>(number: S) -> S {
    if number < S::ZERO { -S::ONE } else { S::ONE }
}

/// The polynomials of one precision.
trait Polynomials: Copy {
    fn log<S: Real>(self, motor: Motor<S>) -> Line<S>;
    fn log_holds<S: Real>(self, motor: Motor<S>) -> bool;
    fn exp<S: Real>(self, line: Line<S>) -> Motor<S>;
}

/// For `f32`.
#[derive(Clone, Copy)]
struct Single;

/// For `f64`.
#[derive(Clone, Copy)]
struct Double;

const SINGLE: Single = Single;
const DOUBLE: Double = Double;

macro_rules! polynomials {
    ($precision:ident: $log:ident $holds:ident $exp:ident) => {
        impl Polynomials for $precision {
            #[inline(always)]
            fn log<S: Real>(self, motor: Motor<S>) -> Line<S> {
                kernels::$log(motor)
            }
            #[inline(always)]
            fn log_holds<S: Real>(self, motor: Motor<S>) -> bool {
                kernels::$holds(motor)
            }
            #[inline(always)]
            fn exp<S: Real>(self, line: Line<S>) -> Motor<S> {
                kernels::$exp(line)
            }
        }
    };
}

polynomials!(Single: motor_log_f32 motor_log_f32_holds line_exp_f32);
polynomials!(Double: motor_log_f64 motor_log_f64_holds line_exp_f64);

/// a exp(t log(~a b)), from the nearer end, in stages: each is a loop of its own over the lanes, short enough to be inlined and to stay in
/// registers. t is from 0 to 1.
struct Screws<S, P>(S, P);

impl<S: Real, P: Polynomials> OnBlock<(Motor<S>, Motor<S>), Motor<S>> for Screws<S, P> {
    #[inline(always)]
    fn run(
        &self,
        lanes: LaneCount,
        pair: impl Fn(usize) -> (Motor<S>, Motor<S>),
        mut put: impl FnMut(usize, Motor<S>),
    ) {
        let Self(t, polynomials) = *self;
        let starts_at_a = t <= S::from_ratio(1, 2);
        let part = if starts_at_a { t } else { t - S::ONE };
        let mut steps = Motor::<S>::IDENTITY.splat::<LANES>();
        let mut signs = [S::ONE; LANES];
        for lane in 0..lanes.get() {
            let (a, b) = pair(lane);
            let step = kernels::motor_mul_motor_fma(a.reverse(), b);
            signs[lane] = if starts_at_a { S::ONE } else { sign_of(step.s) };
            step.short_way().put(&mut steps, lane);
        }
        let mut failures = [0_u32; LANES];
        for lane in 0..lanes.get() {
            failures[lane] = u32::from(!polynomials.log_holds(Motor::<S>::get(&steps, lane)));
        }
        let mut generators = Line::<S>::ZERO.splat::<LANES>();
        for lane in 0..lanes.get() {
            (polynomials.log(Motor::<S>::get(&steps, lane)) * part).put(&mut generators, lane);
        }
        for lane in 0..lanes.get() {
            polynomials.exp(Line::<S>::get(&generators, lane)).put(&mut steps, lane);
        }
        for lane in 0..lanes.get() {
            let (a, b) = pair(lane);
            let from = if starts_at_a { a } else { b };
            let step = Motor::<S>::get(&steps, lane);
            let signed = Motor::from(step.to_array().map(|coefficient| coefficient * signs[lane]));
            put(lane, kernels::motor_mul_motor_fma(from, signed));
        }
        for_failures(&failures, |lane| {
            let (a, b) = pair(lane);
            put(lane, a.screw_lerp(b, t));
        });
    }
}

/// [`Motor::slerp`] at a t from 0 to 1, in stages.
struct Arcs<S, P>(S, P);

impl<S: Real, P: Polynomials> OnBlock<(Motor<S>, Motor<S>), Motor<S>> for Arcs<S, P> {
    #[inline(always)]
    fn run(
        &self,
        lanes: LaneCount,
        pair: impl Fn(usize) -> (Motor<S>, Motor<S>),
        mut put: impl FnMut(usize, Motor<S>),
    ) {
        let Self(t, polynomials) = *self;
        let (half, starts_at_a) = (S::from_ratio(1, 2), t <= S::from_ratio(1, 2));
        let part = if starts_at_a { t } else { S::ONE - t };
        let mut signs = [S::ONE; LANES];
        let mut failures = [0_u32; LANES];
        let mut angles = [S::ZERO; LANES];
        for lane in 0..lanes.get() {
            let (a, b) = pair(lane);
            let turn = Motor::from(a.rotor().reverse() * b.rotor());
            signs[lane] = sign_of(turn.s);
            failures[lane] = u32::from(!polynomials.log_holds(turn.short_way()));
            let generator = polynomials.log(turn.short_way());
            angles[lane] = kernels::line_norm_squared(generator).sqrt();
        }
        // The weights as those of `weights::great_arc`.
        let mut near_weights = [S::ONE; LANES];
        let mut steps = [S::ONE; LANES];
        for lane in 0..lanes.get() {
            let angle = angles[lane];
            let (part_sinc, _) = sinc_and_cosine(polynomials, part * angle);
            let (whole_sinc, _) = sinc_and_cosine(polynomials, angle);
            let (_, part_cosine) = sinc_and_cosine(polynomials, (half - part) * angle);
            let (_, half_cosine) = sinc_and_cosine(polynomials, half * angle);
            near_weights[lane] = part_cosine / half_cosine;
            steps[lane] = part * (part_sinc / whole_sinc);
        }
        for lane in 0..lanes.get() {
            let (a, b) = pair(lane);
            let (a, b) = (a.to_array(), b.to_array());
            let sum = core::array::from_fn(|i| {
                let end = b[i] * signs[lane];
                let (near, far) = if starts_at_a { (a[i], end) } else { (end, a[i]) };
                (far - near).mul_add(steps[lane], near * near_weights[lane])
            });
            put(lane, kernels::even_normalize_fma(EvenMultivector::from(sum)));
        }
        for_failures(&failures, |lane| {
            let (a, b) = pair(lane);
            put(lane, a.slerp(b, t));
        });
    }
}

/// sin x / x and cos x. In the exponential of the line x e23 + e02 they are the coefficients of e02 and 1.
#[inline(always)]
fn sinc_and_cosine<S: Real>(polynomials: impl Polynomials, angle: S) -> (S, S) {
    let motor = polynomials.exp(Line { e23: angle, e02: S::ONE, ..Line::ZERO });
    (motor.e02, motor.s)
}
