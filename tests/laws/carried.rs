//! Carrying both ends by a motion carries the path, on either side.

use crate::interpolation::{at, interpolated};
use crate::law::{Law, laws};
use crate::motion::{Interpolation, Motion};
use crate::samples::{full, motors, pairs, times};
use crate::tie::{Side, any_of, estimate, sides};
use crate::tolerance::Estimate;
use proptest::prelude::*;

laws! {
    paths_are_carried_on_the_left
    paths_are_carried_on_the_right
}

fn paths_are_carried_on_the_left<M: Motion>(law: &Law) {
    paths_are_carried::<M>(law, |g, m| g * m, |g, m| g.product(m));
}

fn paths_are_carried_on_the_right<M: Motion>(law: &Law) {
    paths_are_carried::<M>(law, |g, m| m * g, |g, m| m.product(g));
}

type Carry<M> = fn(M, M) -> M;

fn paths_are_carried<M: Motion>(law: &Law, carry: Carry<M>, follow: fn(Estimate, Estimate) -> Estimate) {
    law.holds_for((motors::<M>(full::<M>()), pairs::<M>(full::<M>()), times()), |(g, (a, b), t)| {
        for (name, interpolate) in M::interpolations().into_iter().take(3) {
            let outcome = path_is_carried(law, (name, interpolate), g, [a, b], t, (carry, follow));
            prop_assert!(outcome.is_ok(), "{name}: {outcome:?}");
        }
        Ok(())
    });
}

fn path_is_carried<M: Motion>(
    law: &Law,
    (name, interpolate): (&str, Interpolation<M>),
    g: M,
    [a, b]: [M; 2],
    t: f64,
    (carry, follow): (Carry<M>, fn(Estimate, Estimate) -> Estimate),
) -> Result<(), TestCaseError> {
    let between = a.reverse() * b;
    let carried = |(m, given): Side<M>| (carry(g, m), follow(estimate(g), given));
    let from = carried((a, estimate(a)));
    let decided = follow(estimate(g), estimate(a)).product(follow(estimate(g), estimate(b))).rotor().error()[0];
    let outcome = |(side, two): Side<M>| {
        let found = at(interpolate, from.0, carry(g, b), t);
        let expected = carry(g, at(interpolate, a, side, t));
        let before = interpolated(name, from, (carry(g, side), follow(estimate(g), two)), t);
        let after = follow(estimate(g), interpolated(name, (a, estimate(a)), (side, two), t));
        law.same_motion(found, expected, &[before, after])
    };
    let sides = sides(b, between.log(), between.scalar(), decided);
    any_of(sides.into_iter().map(outcome).collect())
}
