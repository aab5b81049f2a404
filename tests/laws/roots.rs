//! Square roots.

use crate::law::{Law, laws};
use crate::motion::Motion;
use crate::samples::{full, motors};
use crate::tie::estimate;
use crate::tolerance::exact;
use proptest::prelude::*;

laws! {
    root_squared_is_the_motion
    root_of_the_double_cover_squared_is_the_motor
    log_of_the_root_is_half_the_log
}

fn root_squared_is_the_motion<M: Motion>(law: &Law) {
    law.holds_for(motors::<M>(full::<M>()), |m| {
        let root = estimate(m).sqrt(m.half_angle());
        law.same_motion(m.sqrt() * m.sqrt(), m, &[root.product(root)])
    });
}

/// For a negative scalar part the root of -m times the axis.
fn root_of_the_double_cover_squared_is_the_motor<M: Motion>(law: &Law) {
    law.holds_for(motors::<M>(full::<M>()), |m| {
        let [_, norm, ideal] = m.sizes();
        let Some(found) = m.sqrt_double_cover() else {
            prop_assert!(m.log_double_cover().is_none(), "{m:?} has a root");
            return Ok(());
        };
        prop_assert!(m.log_double_cover().is_some(), "{m:?} has no one root");
        prop_assert!(found.scalar() >= 0.0);
        let short = estimate(m).sqrt(m.half_angle());
        let axis = exact(M::unit(), [0.0, norm, ideal]).axis(norm);
        let root = if m.scalar() < 0.0 { short.product(axis) } else { short };
        law.same(found * found, m, &[root.product(root)])
    });
}

fn log_of_the_root_is_half_the_log<M: Motion>(law: &Law) {
    law.holds_for(motors::<M>(full::<M>()), |m| {
        let (h, given) = (m.half_angle(), estimate(m));
        let (root, whole) = (given.sqrt(h).log(h / 2.0), given.log(h).times(0.5));
        law.same(m.sqrt().log(), M::times(m.log(), 0.5), &[root, whole])
    });
}
