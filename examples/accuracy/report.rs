//! The errors of a function over its samples.

use crate::float::Float;
use crate::functions::Function;
use crate::measure::{self, Errors, Exact};
use crate::samples::Sample;

/// The errors of our function and of the textbook's.
#[derive(Clone, Copy, Default)]
pub(crate) struct Pair {
    pub(crate) ours: Errors,
    pub(crate) textbook: Errors,
}

impl Pair {
    /// The larger ones.
    pub(crate) fn max(self, other: Self) -> Self {
        Self { ours: self.ours.max(other.ours), textbook: self.textbook.max(other.textbook) }
    }
}

/// The errors at each sample whose result is in the range of the floats.
pub(crate) fn errors<T: Float>(function: &Function<T>) -> Vec<(Sample<T>, Pair)> {
    let at = |sample: Sample<T>| {
        let exact = Exact::of(function.reference, &sample.input, function.sizes);
        if exact.as_ref().is_some_and(|exact| !exact.is_in_range::<T>()) {
            return None;
        }
        let errors = |computed: Option<Vec<T>>| measure::errors(exact.as_ref(), function.result, computed.as_deref());
        let pair =
            Pair { ours: errors((function.ours)(&sample.input)), textbook: errors((function.textbook)(&sample.input)) };
        Some((sample, pair))
    };
    (function.samples)().into_iter().filter_map(at).collect()
}

/// The largest errors.
pub(crate) fn largest<T: Float>(errors: &[(Sample<T>, Pair)]) -> Pair {
    errors.iter().fold(Pair::default(), |largest, (_, pair)| largest.max(*pair))
}
