//! How far an answer may be off.

use super::Coefficient;
use super::coefficient::Running;
use crate::reference::Multivector;

/// How far a coefficient of an answer may be from that of the definition.
///
/// NaN is never near enough, not even to NaN: keep inputs at which the definition itself overflows out of the
/// strategies.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Tolerance {
    /// Not at all.
    Exact,
    /// This times the largest coefficient of what is expected.
    Relative(f64),
    /// As far as rounding explains; for exact numbers that is not at all.
    ///
    /// Let S be the definition worked out on absolute values, every difference a sum, and d the largest number of
    /// operations that a term of the coefficient goes through, both counted along the naive evaluation. With the unit
    /// roundoff u, that evaluation errs by at most d u S, up to terms of u^2 (Higham, "Accuracy and Stability of
    /// Numerical Algorithms", section 3.1). A coefficient may be off by 4 d u S: once for the reference itself, once
    /// for an implementation that does no more operations, and twice that for what relies on unit inputs, which are
    /// unit only up to some u, or for terms that the definition cancels. d times the least normal number is for
    /// underflow. So a mistake below that is not seen, and an implementation that cancels more than the definition does
    /// may be reported.
    ///
    /// A function f of a coefficient x counts as |f| + |f'| S(x) in S, and as five operations, which are its own roundings: so
    /// exp, log, normalize and sqrt are allowed what their closed forms, with naive sines, roots and quotients, may err,
    /// times 4. Near the border of their domain, where that grows beyond all bounds, so does the tolerance.
    #[default]
    Derived,
}

/// A coefficient that differs.
#[derive(Clone, Debug, PartialEq)]
pub struct Difference<T> {
    /// The blade, its generators ascending.
    pub blade: String,
    /// What the definition gives.
    pub expected: T,
    /// What the implementation gives.
    pub found: T,
    /// How far it might have been off.
    pub allowed: f64,
}

impl Tolerance {
    /// The first coefficient, by grade and word, that is too far off.
    pub(super) fn difference<T: Coefficient>(
        self,
        expected: &Multivector<Running<T>>,
        found: &Multivector<T>,
    ) -> Option<Difference<T>> {
        let largest = expected.blades().iter().map(|(_, each)| each.value.magnitude()).fold(0.0, f64::max);
        let words = expected.blades().into_iter().map(|(word, _)| word);
        let mut words: Vec<_> = words.chain(found.blades().into_iter().map(|(word, _)| word)).collect();
        words.sort_by_key(|word| (if word == "1" { 0 } else { word.len() }, word.clone()));
        words.into_iter().find_map(|blade| {
            let (expected, found) = (expected.coefficient(&blade), found.coefficient(&blade));
            let allowed = self.allowed(&expected, largest);
            let expected = expected.value;
            let is_near =
                expected == found || (found.clone() - expected.clone()).magnitude() <= allowed && allowed > 0.0;
            (!is_near).then_some(Difference { blade, expected, found, allowed })
        })
    }

    fn allowed<T: Coefficient>(self, expected: &Running<T>, largest: f64) -> f64 {
        match self {
            Self::Exact => 0.0,
            Self::Relative(factor) => factor * largest,
            Self::Derived if expected.size == 0.0 => 0.0,
            Self::Derived => {
                let depth = f64::from(expected.depth);
                4.0 * depth * T::UNIT_ROUNDOFF * expected.size + depth * T::LEAST_NORMAL
            }
        }
    }
}
