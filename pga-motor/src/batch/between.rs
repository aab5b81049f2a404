//! Motors between motors, pair by pair.

use super::Blocks;
use super::blocks::LANES;
use super::lanes::Lanewise;
use super::layout::{Same, Sink, Source};
use super::work::{LaneCount, OnBlock, map};
use crate::scalar::{Fused, Precision, precision};
use crate::slices::check_lengths;
use crate::{EvenMultivector, LengthMismatch, Line, Motor, Real, Translator, kernels, weights};

/// Motors between each of these and the one at the same index of `others`, up to rounding of the larger of the two; so the second end is
/// met up to that, the first exactly. Of ends half a turn apart the same way is taken as by single motors. Nothing is written where
/// the lengths differ.
///
/// For t from 0 to 1 angles go by the polynomials of [`Motor::log_slice`] and [`Line::exp_slice`], and so results may be off by as much
/// as the motors are off unit norm. What the polynomials do not hold for, and other t, is done one by one.
impl<T: Real> Blocks<Motor<T>> {
    /// Writes the motors on the straight lines: [`Motor::nlerp`].
    ///
    /// # Errors
    /// Lists of different lengths.
    pub fn nlerp_into(&self, others: &Self, t: T, motors: &mut Self) -> Result<(), LengthMismatch> {
        between(Way::Nlerp, self, others, t, motors)
    }

    /// Writes the motors at the great arcs' weights: [`Motor::slerp`].
    ///
    /// # Errors
    /// Lists of different lengths.
    pub fn slerp_into(&self, others: &Self, t: T, motors: &mut Self) -> Result<(), LengthMismatch> {
        between(Way::Slerp, self, others, t, motors)
    }

    /// Writes the motors on the screws: [`Motor::screw_lerp`].
    ///
    /// # Errors
    /// Lists of different lengths.
    pub fn screw_lerp_into(&self, others: &Self, t: T, motors: &mut Self) -> Result<(), LengthMismatch> {
        between(Way::Screw, self, others, t, motors)
    }

    /// Writes the motors whose turns and translations are interpolated apart: [`Motor::split_lerp`].
    ///
    /// # Errors
    /// Lists of different lengths.
    pub fn split_lerp_into(&self, others: &Self, t: T, motors: &mut Self) -> Result<(), LengthMismatch> {
        between(Way::Split, self, others, t, motors)
    }
}

/// Motors between those of two arrays, pair by pair, as by the functions of [`Blocks`]. Nothing is written where the lengths differ.
impl<T: Real> Motor<T> {
    /// Writes the motors on the straight lines: [`Self::nlerp`].
    ///
    /// # Errors
    /// Slices of different lengths.
    pub fn nlerp_slice(a: &[Self], b: &[Self], t: T, motors: &mut [Self]) -> Result<(), LengthMismatch> {
        between(Way::Nlerp, a, b, t, motors)
    }

    /// Writes the motors at the great arcs' weights: [`Self::slerp`].
    ///
    /// # Errors
    /// Slices of different lengths.
    pub fn slerp_slice(a: &[Self], b: &[Self], t: T, motors: &mut [Self]) -> Result<(), LengthMismatch> {
        between(Way::Slerp, a, b, t, motors)
    }

    /// Writes the motors on the screws: [`Self::screw_lerp`].
    ///
    /// # Errors
    /// Slices of different lengths.
    pub fn screw_lerp_slice(a: &[Self], b: &[Self], t: T, motors: &mut [Self]) -> Result<(), LengthMismatch> {
        between(Way::Screw, a, b, t, motors)
    }

    /// Writes the motors whose turns and translations are interpolated apart: [`Self::split_lerp`].
    ///
    /// # Errors
    /// Slices of different lengths.
    pub fn split_lerp_slice(a: &[Self], b: &[Self], t: T, motors: &mut [Self]) -> Result<(), LengthMismatch> {
        between(Way::Split, a, b, t, motors)
    }
}

/// A way from motor to motor.
#[derive(Clone, Copy)]
pub(crate) enum Way {
    Nlerp,
    Slerp,
    Screw,
    Split,
}

impl Way {
    /// The function of two motors and t.
    pub(crate) fn of_one<T: Real>(self) -> fn(Motor<T>, Motor<T>, T) -> Motor<T> {
        match self {
            Self::Nlerp => Motor::nlerp,
            Self::Slerp => Motor::slerp,
            Self::Screw => Motor::screw_lerp,
            Self::Split => Motor::split_lerp,
        }
    }
}

/// Two motors, and how much of the way from the first to the second has passed.
#[derive(Clone, Copy)]
pub(crate) struct Pair<S> {
    pub(crate) a: Motor<S>,
    pub(crate) b: Motor<S>,
    pub(crate) t: S,
}

/// What takes the ways of all pairs of a block.
pub(crate) trait Travel<T> {
    type Output;

    fn travel(
        self,
        plain: impl OnBlock<Pair<T>, Motor<T>>,
        fused: impl OnBlock<Pair<Fused<T>>, Motor<Fused<T>>>,
    ) -> Self::Output;
}

/// Chooses what is done for a way: by polynomials where every t is from 0 to 1.
pub(crate) fn choose<T: Real, V: Travel<T>>(way: Way, all_between: bool, traveller: V) -> V::Output {
    match (way, precision::<T>()) {
        (Way::Nlerp, _) if all_between => traveller.travel(chord, chord),
        (Way::Slerp, Precision::Single) if all_between => {
            traveller.travel(Arcs::<_, false>(Single), Arcs::<_, false>(Single))
        }
        (Way::Slerp, Precision::Double) if all_between => {
            traveller.travel(Arcs::<_, false>(Double), Arcs::<_, false>(Double))
        }
        (Way::Screw, Precision::Single) if all_between => traveller.travel(Screws(Single), Screws(Single)),
        (Way::Screw, Precision::Double) if all_between => traveller.travel(Screws(Double), Screws(Double)),
        (Way::Split, Precision::Single) if all_between => {
            traveller.travel(Arcs::<_, true>(Single), Arcs::<_, true>(Single))
        }
        (Way::Split, Precision::Double) if all_between => {
            traveller.travel(Arcs::<_, true>(Double), Arcs::<_, true>(Double))
        }
        _ => {
            let (plain, fused) = (way.of_one(), way.of_one());
            traveller.travel(|p: Pair<T>| plain(p.a, p.b, p.t), |p: Pair<_>| fused(p.a, p.b, p.t))
        }
    }
}

/// Writes the motors between those of slices of one length.
pub(crate) fn between_slices<T: Real>(way: Way, a: &[Motor<T>], b: &[Motor<T>], t: T, motors: &mut [Motor<T>]) {
    between(way, a, b, t, motors).expect("invariant: slices of one length");
}

/// Writes the motors a exp(t l), t from 0 to 1, for lists of one length.
pub(crate) fn along_screws<T: Real>(a: &Blocks<Motor<T>>, generators: &Blocks<Line<T>>, t: T, motors: &mut [Motor<T>]) {
    let items = ((a, generators), Same(t));
    let done = match precision::<T>() {
        Precision::Single => map(items, motors, Along(Single), Along(Single)),
        Precision::Double => map(items, motors, Along(Double), Along(Double)),
        Precision::Finer => map(items, motors, carried::<T>, carried::<Fused<T>>),
    };
    done.expect("invariant: lists of one length");
}

type Generated<S> = ((Motor<S>, Line<S>), Same<S>);

/// a exp(t l) in two stages, as [`Screws`].
struct Along<P>(P);

impl<S: Real, P: Polynomials> OnBlock<Generated<S>, Motor<S>> for Along<P> {
    #[inline(always)]
    fn run(&self, lanes: LaneCount, item: impl Fn(usize) -> Generated<S>, mut put: impl FnMut(usize, Motor<S>)) {
        let Self(polynomials) = *self;
        let mut steps = Motor::<S>::IDENTITY.splat::<LANES>();
        let mut failures = 0_u32;
        for lane in lanes.range() {
            let ((_, generator), Same(t)) = item(lane);
            failures |= u32::from(!polynomials.exp_holds(generator * t));
            polynomials.exp(generator * t).put(&mut steps, lane);
        }
        for lane in lanes.range() {
            let ((a, _), _) = item(lane);
            put(lane, kernels::motor_mul_motor_fma(a, Motor::<S>::get(&steps, lane)));
        }
        if failures != 0 {
            for lane in 0..LANES {
                let item @ ((_, generator), Same(t)) = item(lane);
                if !polynomials.exp_holds(generator * t) {
                    put(lane, carried(item));
                }
            }
        }
    }
}

fn carried<S: Real>(((a, generator), Same(t)): Generated<S>) -> Motor<S> {
    a * (generator * t).exp()
}

fn between<T: Real>(
    way: Way,
    a: impl Source<Item = Motor<T>>,
    b: impl Source<Item = Motor<T>>,
    t: T,
    motors: impl Sink<Item = Motor<T>>,
) -> Result<(), LengthMismatch> {
    check_lengths(a.len(), b.len())?;
    choose(way, weights::is_between(t), Lists { pairs: ((a, b), Same(t)), motors })
}

/// The pairs of two lists with one t, and the list of results.
struct Lists<P, D> {
    pairs: P,
    motors: D,
}

impl<T, A, B, D> Travel<T> for Lists<((A, B), Same<T>), D>
where
    T: Real,
    A: Source<Item = Motor<T>>,
    B: Source<Item = Motor<T>>,
    D: Sink<Item = Motor<T>>,
{
    type Output = Result<(), LengthMismatch>;

    #[inline(always)]
    fn travel(
        self,
        plain: impl OnBlock<Pair<T>, Motor<T>>,
        fused: impl OnBlock<Pair<Fused<T>>, Motor<Fused<T>>>,
    ) -> Self::Output {
        map(self.pairs, self.motors, Paired(plain), Paired(fused))
    }
}

/// What is done with pairs, done with what lists have of them.
struct Paired<F>(F);

impl<S: Copy, F: OnBlock<Pair<S>, Motor<S>>> OnBlock<((Motor<S>, Motor<S>), Same<S>), Motor<S>> for Paired<F> {
    #[inline(always)]
    fn run(
        &self,
        lanes: LaneCount,
        item: impl Fn(usize) -> ((Motor<S>, Motor<S>), Same<S>),
        put: impl FnMut(usize, Motor<S>),
    ) {
        let pair = |lane| {
            let ((a, b), Same(t)) = item(lane);
            Pair { a, b, t }
        };
        self.0.run(lanes, pair, put);
    }
}

/// [`Motor::nlerp`] at a t from 0 to 1, without a branch. Equal ends stay put.
#[inline(always)]
fn chord<S: Real>(Pair { a, b, t }: Pair<S>) -> Motor<S> {
    // Not fused: of ends half a turn apart the rounding says which way is taken, on every machine the same.
    let sign = sign_of(kernels::motor_scalar_product_motor(a, b));
    kernels::even_normalize_fma(weighted(a, S::ONE, times(b, sign), t))
}

/// a near + (b - a) step
#[inline(always)]
fn weighted<S: Real>(a: Motor<S>, near: S, b: Motor<S>, step: S) -> EvenMultivector<S> {
    let (a, b) = (a.to_array(), b.to_array());
    EvenMultivector::from(core::array::from_fn(|i| (b[i] - a[i]).mul_add(step, a[i] * near)))
}

/// The motor or its negative, the same motion.
#[inline(always)]
fn times<S: Real>(motor: Motor<S>, sign: S) -> Motor<S> {
    Motor::from(motor.to_array().map(|coefficient| coefficient * sign))
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
    fn exp_holds<S: Real>(self, line: Line<S>) -> bool;
}

/// For `f32`.
#[derive(Clone, Copy)]
struct Single;

/// For `f64`.
#[derive(Clone, Copy)]
struct Double;

macro_rules! polynomials {
    ($precision:ident: $log:ident $log_holds:ident $exp:ident $exp_holds:ident) => {
        impl Polynomials for $precision {
            #[inline(always)]
            fn log<S: Real>(self, motor: Motor<S>) -> Line<S> {
                kernels::$log(motor)
            }
            #[inline(always)]
            fn log_holds<S: Real>(self, motor: Motor<S>) -> bool {
                kernels::$log_holds(motor)
            }
            #[inline(always)]
            fn exp<S: Real>(self, line: Line<S>) -> Motor<S> {
                kernels::$exp(line)
            }
            #[inline(always)]
            fn exp_holds<S: Real>(self, line: Line<S>) -> bool {
                kernels::$exp_holds(line)
            }
        }
    };
}

polynomials!(Single: motor_log_f32 motor_log_f32_holds line_exp_f32 line_exp_f32_holds);
polynomials!(Double: motor_log_f64 motor_log_f64_holds line_exp_f64 line_exp_f64_holds);

/// ~a b, the motion from one to the other as it is seen there, the short way.
#[inline(always)]
fn step<S: Real>(Pair { a, b, .. }: Pair<S>) -> Motor<S> {
    // The way is chosen without fusing, as by single motors. Where the fused product has the other sign, by a rounding, the logarithm
    // does not hold, or it is that of half a turn.
    let sign = sign_of(kernels::motor_mul_motor(a.reverse(), b).s);
    times(kernels::motor_mul_motor_fma(a.reverse(), b), sign)
}

/// What it turns by.
#[inline(always)]
fn turn<S: Real>(Pair { a, b, .. }: Pair<S>) -> Motor<S> {
    Motor::from(kernels::rotor_mul_rotor(a.rotor().reverse(), b.rotor()))
}

/// a exp(t log(~a b)) at a t from 0 to 1, in stages: each is a loop of its own over the lanes, short enough to be inlined and to stay in
/// registers.
struct Screws<P>(P);

impl<S: Real, P: Polynomials> OnBlock<Pair<S>, Motor<S>> for Screws<P> {
    #[inline(always)]
    fn run(&self, lanes: LaneCount, pair: impl Fn(usize) -> Pair<S>, mut put: impl FnMut(usize, Motor<S>)) {
        let Self(polynomials) = *self;
        let mut steps = Motor::<S>::IDENTITY.splat::<LANES>();
        let mut failures = 0_u32;
        for lane in lanes.range() {
            let step = step(pair(lane));
            failures |= u32::from(!polynomials.log_holds(step));
            step.put(&mut steps, lane);
        }
        let mut generators = Line::<S>::ZERO.splat::<LANES>();
        for lane in lanes.range() {
            (polynomials.log(Motor::<S>::get(&steps, lane)) * pair(lane).t).put(&mut generators, lane);
        }
        for lane in lanes.range() {
            polynomials.exp(Line::<S>::get(&generators, lane)).put(&mut steps, lane);
        }
        for lane in lanes.range() {
            put(lane, kernels::motor_mul_motor_fma(pair(lane).a, Motor::<S>::get(&steps, lane)));
        }
        if failures != 0 {
            for lane in 0..LANES {
                let pair @ Pair { a, b, t } = pair(lane);
                if !polynomials.log_holds(step(pair)) {
                    put(lane, a.screw_lerp(b, t));
                }
            }
        }
    }
}

/// Ways by the weights of the great arc between the rotors (Shoemake 1985), a sin((1 - t) h)/sin h + b sin(t h)/sin h, at a t from 0 to
/// 1, in stages: [`Motor::slerp`], or where `SPLIT` [`Motor::split_lerp`].
struct Arcs<P, const SPLIT: bool>(P);

impl<S: Real, P: Polynomials, const SPLIT: bool> OnBlock<Pair<S>, Motor<S>> for Arcs<P, SPLIT> {
    #[inline(always)]
    fn run(&self, lanes: LaneCount, pair: impl Fn(usize) -> Pair<S>, mut put: impl FnMut(usize, Motor<S>)) {
        let Self(polynomials) = *self;
        let mut signs = [S::ONE; LANES];
        let mut angles = [S::ZERO; LANES];
        let mut failures = 0_u32;
        for lane in lanes.range() {
            let turn = turn(pair(lane));
            signs[lane] = sign_of(turn.s);
            failures |= u32::from(!polynomials.log_holds(turn.short_way()));
            angles[lane] = kernels::line_norm_squared(polynomials.log(turn.short_way())).sqrt();
        }
        let (mut near, mut steps) = ([S::ONE; LANES], [S::ONE; LANES]);
        for lane in lanes.range() {
            let (angle, t) = (angles[lane], pair(lane).t);
            let (rest, whole) = (S::ONE - t, S::ONE / sinc(polynomials, angle));
            let of_b = t * sinc(polynomials, t * angle) * whole;
            near[lane] = rest * sinc(polynomials, rest * angle) * whole + of_b;
            steps[lane] = of_b;
        }
        for lane in lanes.range() {
            let Pair { a, b, t } = pair(lane);
            let pair = Pair { a, b: times(b, signs[lane]), t };
            let (near, step) = (near[lane], steps[lane]);
            put(lane, if SPLIT { split(pair, near, step) } else { weighted_and_normalized(pair, near, step) });
        }
        if failures != 0 {
            for lane in 0..LANES {
                let pair @ Pair { a, b, t } = pair(lane);
                if !polynomials.log_holds(turn(pair).short_way()) {
                    put(lane, if SPLIT { a.split_lerp(b, t) } else { a.slerp(b, t) });
                }
            }
        }
    }
}

#[inline(always)]
fn weighted_and_normalized<S: Real>(Pair { a, b, .. }: Pair<S>, near: S, step: S) -> Motor<S> {
    kernels::even_normalize_fma(weighted(a, near, b, step))
}

/// The weighted rotors, and the translation on the straight line.
#[inline(always)]
fn split<S: Real>(Pair { a, b, t }: Pair<S>, near: S, step: S) -> Motor<S> {
    let rotor = weighted_and_normalized(Pair { a: a.rotor().into(), b: b.rotor().into(), t }, near, step).rotor();
    let (from, to) = (a.translator().vector().to_array(), b.translator().vector().to_array());
    let vector = core::array::from_fn(|i| (to[i] - from[i]).mul_add(t, from[i]));
    Motor::from_rotor_translator(rotor, Translator::from_vector(vector.into()))
}

/// sin x / x: in the exponential of the line x e23 + e02 the coefficient of e02.
#[inline(always)]
fn sinc<S: Real>(polynomials: impl Polynomials, angle: S) -> S {
    polynomials.exp(Line { e23: angle, e02: S::ONE, ..Line::ZERO }).e02
}
