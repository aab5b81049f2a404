//! The unit of length: scaling the ideal part by a power of two commutes with everything, bit for bit.

use crate::law::{Law, laws};
use crate::motion::{Motion, Parts};
use crate::samples::{far_from_underflow, generators, motors, pairs, times};
use proptest::prelude::*;

laws! {
    scaling_commutes_with_exp
    scaling_commutes_with_log_and_roots
    scaling_commutes_with_normalization
    scaling_commutes_with_interpolation
}

fn scaled<P: Parts>(value: P, exponent: i32) -> P {
    value.map_ideal(|coefficient| coefficient * 2_f64.powi(exponent))
}

/// Up, so that nothing underflows which does not without.
fn exponents() -> impl Strategy<Value = i32> {
    1..20
}

fn scaling_commutes_with_exp<M: Motion>(law: &Law) {
    law.holds_for((generators::<M>(far_from_underflow::<M>()), exponents()), |(b, k)| {
        prop_assert_eq!(M::exp(scaled(b, k)), scaled(M::exp(b), k));
        Ok(())
    });
}

fn scaling_commutes_with_log_and_roots<M: Motion>(law: &Law) {
    law.holds_for((motors::<M>(far_from_underflow::<M>()), exponents(), -2.0..2.0), |(m, k, exponent)| {
        let big = scaled(m, k);
        prop_assert_eq!(big.log(), scaled(m.log(), k));
        prop_assert_eq!(big.log_double_cover(), m.log_double_cover().map(|log| scaled(log, k)));
        prop_assert_eq!(big.sqrt(), scaled(m.sqrt(), k));
        prop_assert_eq!(big.sqrt_double_cover(), m.sqrt_double_cover().map(|root| scaled(root, k)));
        prop_assert_eq!(big.powf(exponent), scaled(m.powf(exponent), k));
        Ok(())
    });
}

fn scaling_commutes_with_normalization<M: Motion>(law: &Law) {
    law.holds_for(
        (motors::<M>(far_from_underflow::<M>()), exponents(), 0.1..10.0, -2.0..2.0),
        |(m, k, scale, study)| {
            let even = m.scaled(scale, study);
            prop_assert_eq!(M::normalize(scaled(even, k)), M::normalize(even).map(|motor| scaled(motor, k)));
            Ok(())
        },
    );
}

fn scaling_commutes_with_interpolation<M: Motion>(law: &Law) {
    law.holds_for((pairs::<M>(far_from_underflow::<M>()), exponents(), times()), |((a, b), k, t)| {
        for (name, interpolate) in M::interpolations() {
            let t = <M::Number as pga_motor::Real>::from_f64(t);
            let (found, expected) = (interpolate(scaled(a, k), scaled(b, k), t), interpolate(a, b, t));
            prop_assert_eq!(found, scaled(expected, k), "{}", name);
        }
        let blend = |a: M, b: M| M::blend(&[(a, 0.75), (b, t), (a * b, 0.5)]);
        prop_assert_eq!(blend(scaled(a, k), scaled(b, k)), blend(a, b).map(|mean| scaled(mean, k)));
        Ok(())
    });
}
