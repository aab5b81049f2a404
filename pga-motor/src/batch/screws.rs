//! Screws between motors, pair by pair.

use super::Blocks;
use super::blocks::{Block, LANES};
use super::lanes::Lanewise;
use super::work::zip;
use crate::instructions::{Work, dispatch};
use crate::scalar::{Precision, precision};
use crate::slices::check_lengths;
use crate::{LengthMismatch, Line, Motor, Real, kernels};

/// Screws between motors.
impl<T: Real> Blocks<Motor<T>> {
    /// Writes the motors on the screw from each of these to the one at the same index of `others`: [`Motor::screw_lerp`], up to the
    /// last digits and the sign.
    ///
    /// For t from 0 to 1 by the polynomials of [`Motor::log_slice`] and [`Line::exp_slice`]; what these do not hold for, and other
    /// t, is done one by one.
    ///
    /// # Errors
    /// Lists of different lengths; then nothing is written.
    pub fn screw_lerp_into(&self, others: &Self, t: T, motors: &mut Self) -> Result<(), LengthMismatch> {
        check_lengths(self.len(), others.len())?;
        check_lengths(self.len(), motors.len())?;
        if !(t >= T::ZERO && t <= T::ONE) {
            return zip(self, others, motors, |a: Motor<T>, b: Motor<T>| a.screw_lerp(b, t));
        }
        let (a, b, results) = (&self.blocks, &others.blocks, &mut motors.blocks);
        match precision::<T>() {
            Precision::Single => {
                let (log, holds, exp) = (kernels::motor_log_f32, kernels::motor_log_f32_holds, kernels::line_exp_f32);
                dispatch(Screws { a, b, t, results, log, holds, exp });
            }
            Precision::Double => {
                let (log, holds, exp) = (kernels::motor_log_f64, kernels::motor_log_f64_holds, kernels::line_exp_f64);
                dispatch(Screws { a, b, t, results, log, holds, exp });
            }
            Precision::Finer => return zip(self, others, motors, |a: Motor<T>, b: Motor<T>| a.screw_lerp(b, t)),
        }
        Ok(())
    }
}

/// a exp(t log(~a b)), from the nearer end, in stages: each is a loop of its own over the lanes, short enough to be inlined and to stay in
/// registers.
struct Screws<'a, T: Real, L, H, E> {
    a: &'a [Block<Motor<T>>],
    b: &'a [Block<Motor<T>>],
    /// From 0 to 1.
    t: T,
    results: &'a mut [Block<Motor<T>>],
    log: L,
    holds: H,
    exp: E,
}

impl<T, L, H, E> Work for Screws<'_, T, L, H, E>
where
    T: Real,
    L: Fn(Motor<T>) -> Line<T>,
    H: Fn(Motor<T>) -> bool,
    E: Fn(Line<T>) -> Motor<T>,
{
    #[inline(always)]
    fn run(self) {
        let starts_at_a = self.t <= T::from_ratio(1, 2);
        let part = if starts_at_a { self.t } else { self.t - T::ONE };
        for ((a, b), results) in self.a.iter().zip(self.b).zip(self.results) {
            let from = if starts_at_a { a } else { b };
            let mut steps = *a;
            for lane in 0..LANES {
                let step = kernels::motor_mul_motor(Motor::get(&a.0, lane).reverse(), Motor::get(&b.0, lane));
                step.short_way().put(&mut steps.0, lane);
            }
            let mut failures = [0_u32; LANES];
            for (lane, failure) in failures.iter_mut().enumerate() {
                *failure = u32::from(!(self.holds)(Motor::get(&steps.0, lane)));
            }
            let mut generators = Line::<T>::ZERO.splat::<LANES>();
            for lane in 0..LANES {
                ((self.log)(Motor::get(&steps.0, lane)) * part).put(&mut generators, lane);
            }
            for lane in 0..LANES {
                (self.exp)(Line::get(&generators, lane)).put(&mut steps.0, lane);
            }
            for lane in 0..LANES {
                let motor = kernels::motor_mul_motor(Motor::get(&from.0, lane), Motor::get(&steps.0, lane));
                motor.put(&mut results.0, lane);
            }
            if failures.iter().fold(0, |any, failure| any | failure) != 0 {
                for (lane, _) in failures.iter().enumerate().filter(|(_, failure)| **failure != 0) {
                    let motor = Motor::get(&a.0, lane).screw_lerp(Motor::get(&b.0, lane), self.t);
                    motor.put(&mut results.0, lane);
                }
            }
        }
    }
}
