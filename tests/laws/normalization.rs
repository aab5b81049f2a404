//! Normalisation.

use crate::law::{Law, laws};
use crate::motion::{Motion, Parts};
use crate::samples::{far_from_underflow, full, motors};
use crate::tie::estimate;
use crate::tolerance::{exact, up_to};
use proptest::prelude::*;

laws! {
    exponentials_are_unit_motors
    normalizing_a_multiple_gives_the_motor
    what_is_normalized_is_a_unit_motor
    normalizing_twice_is_normalizing_once_to_2_ulp
    powers_of_two_change_nothing_bit_for_bit
}

/// What the samples of all laws are taken to be: see [`crate::tolerance::motor`].
fn exponentials_are_unit_motors<M: Motion>(law: &Law) {
    law.holds_for(motors::<M>(full::<M>()), |m| {
        let [norm, study] = m.defects();
        law.within(norm.abs(), 12.0 * M::unit())?;
        law.within(study.abs(), 18.0 * M::unit() * m.sizes()[2])
    });
}

/// Multiples by Study numbers, with a scalar part that is not 0, and a pseudoscalar part that leads off the Study
/// quadric.
fn multiples<M: Motion>() -> impl Strategy<Value = (M, f64, f64)> {
    let scale = (-9_f64..9.0).prop_map(|exponent| f64::from(10_f64.powf(exponent) as f32));
    let study = prop_oneof![Just(0.0), -2_f64..2.0, -1e6..1e6].prop_map(|study| f64::from(study as f32));
    (motors::<M>(full::<M>()), scale, study)
}

fn normalizing_a_multiple_gives_the_motor<M: Motion>(law: &Law) {
    law.holds_for(multiples::<M>(), |(m, scale, study)| {
        let found = M::normalize(m.scaled(scale, study)).expect("a multiple of a motor");
        let multiple = estimate(m).product(exact(M::unit(), [1.0, 0.0, study.abs()])).times(scale);
        law.same(found, m, &[estimate(m), multiple.of_norm(scale).normalized()])
    });
}

fn what_is_normalized_is_a_unit_motor<M: Motion>(law: &Law) {
    law.holds_for(multiples::<M>(), |(m, scale, study)| {
        let even = m.scaled(scale, study);
        let [norm, off] = M::normalize(even).expect("a multiple of a motor").defects();
        let [scalar, bivector, ideal] = even.sizes();
        law.within(norm.abs(), 2.0 * 5.0 * M::unit())?;
        law.within(off.abs(), 18.0 * M::unit() * (ideal / scalar.hypot(bivector)))
    });
}

/// An ulp of what is below 2 is EPSILON, two units of rounding; for the ideal part, times its norm. Of what was off the
/// Study quadric, a part of the ideal part was lost to which the errors are in proportion: those of any normalisation,
/// 18 u.
fn normalizing_twice_is_normalizing_once_to_2_ulp<M: Motion>(law: &Law) {
    law.holds_for(multiples::<M>(), |(m, scale, study)| {
        let even = m.scaled(scale, study);
        let once = M::normalize(even).expect("a multiple of a motor");
        let two = 4.0 * M::unit();
        let ideal = if study == 0.0 {
            two * once.sizes()[2]
        } else {
            let [scalar, bivector, ideal] = even.sizes();
            18.0 * M::unit() * ideal / scalar.hypot(bivector)
        };
        law.same(once.renormalize(), once, &[up_to(M::unit(), [two, two, ideal])])
    });
}

fn powers_of_two_change_nothing_bit_for_bit<M: Motion>(law: &Law) {
    // What f32 holds: coefficients down to 1e-3^2 times 2^-60, and 1e6 times 2^60.
    let largest = if M::unit() < 1e-10 { 300 } else { 60 };
    let samples = (motors::<M>(far_from_underflow::<M>()), -largest..=largest, -2.0_f32..2.0);
    law.holds_for(samples, |(m, exponent, study)| {
        let even = |scale: f64| M::normalize(m.scaled(scale, f64::from(study)));
        prop_assert_eq!(even(2_f64.powi(exponent)), even(1.0));
        Ok(())
    });
}
