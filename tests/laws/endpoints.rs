//! Interpolations start at one motion and end at the other.

use crate::law::{Law, laws};
use crate::motion::Motion;
use crate::samples::{full, pairs};
use crate::tolerance::{Estimate, up_to};
use pga_motor::Scalar;
use proptest::prelude::*;

laws! {
    interpolations_start_at_the_one
    interpolations_end_at_the_other
}

/// 4 ulp, each two units of rounding, of what is below 2 and of the ideal part as a whole.
fn four_ulp<M: Motion>(motor: M) -> Estimate {
    let four = 8.0 * M::unit();
    up_to(M::unit(), [four, four, four * motor.sizes()[2]])
}

fn interpolations_start_at_the_one<M: Motion>(law: &Law) {
    law.holds_for(pairs::<M>(full::<M>()), |(a, b)| {
        for (name, interpolate) in M::interpolations() {
            let outcome = law.same(interpolate(a, b, M::Number::ZERO), a, &[four_ulp(a)]);
            prop_assert!(outcome.is_ok(), "{name}: {outcome:?}");
        }
        Ok(())
    });
}

fn interpolations_end_at_the_other<M: Motion>(law: &Law) {
    law.holds_for(pairs::<M>(full::<M>()), |(a, b)| {
        for (name, interpolate) in M::interpolations() {
            let outcome = law.same_motion(interpolate(a, b, M::Number::ONE), b, &[four_ulp(b)]);
            prop_assert!(outcome.is_ok(), "{name}: {outcome:?}");
        }
        Ok(())
    });
}
