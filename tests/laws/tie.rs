//! Half a turn: there the two short ways are equally short, and rounding decides between them.
//!
//! A law that follows a motion through rounding errors can end on the other side of the tie. So near it the law is
//! asked for with the motion turned a little further and a little less far about its own axis: one of these is on the
//! side that was meant, and what it was turned by is part of the tolerance.

use crate::motion::{Motion, Parts};
use crate::tolerance::{Estimate, motor};
use proptest::test_runner::TestCaseResult;

/// A motion beside a sampled one, on a side of the tie, and its estimate.
pub(crate) type Side<M> = (M, Estimate);

pub(crate) fn estimate<M: Motion>(sample: M) -> Estimate {
    motor(M::unit(), sample.sizes())
}

/// The motion itself where `cosine`, 0 on the tie, is further from 0 than rounding may carry it; else the motion by
/// `excess` more and less about the axis of `around`, in the moved body's space.
///
/// m exp(x B) is off m by x in the e0-free part, for B of length 1, and by x (|r_m| + |r_B|) in the ideal part.
pub(crate) fn sides<M: Motion>(sample: M, around: M::Generator, cosine: f64, rounding: f64) -> Vec<Side<M>> {
    let estimate = estimate(sample);
    if cosine.abs() > rounding {
        return vec![(sample, estimate)];
    }
    let excess = 4.0 * rounding;
    let [_, norm, moment] = around.sizes();
    let off = estimate.off_by(excess, excess * (sample.sizes()[2] + moment / norm));
    let turned = |sign: f64| (sample * M::exp(M::times(around, sign * excess / norm)), off);
    vec![turned(1.0), turned(-1.0)]
}

/// A motion on either side of half a turn, where it is that to within `rounding`.
pub(crate) fn sides_of_half_turn<M: Motion>(sample: M, rounding: f64) -> Vec<Side<M>> {
    sides(sample, sample.log(), sample.scalar(), rounding)
}

/// Success if there is one.
pub(crate) fn any_of(outcomes: Vec<TestCaseResult>) -> TestCaseResult {
    let first = outcomes.into_iter().reduce(|outcome, next| outcome.or(next));
    first.expect("there is something to choose from")
}
