//! A law: samples, comparisons, and how near the worst of them comes to its tolerance.

use crate::motion::{Motion, Parts};
use crate::tolerance::Estimate;
use proptest::prelude::*;
use proptest::test_runner::{Config, RngSeed, TestCaseResult, TestRunner};
use std::cell::Cell;

/// Enough for each way of sampling to meet each other one.
const CASES: u32 = 400;

/// Prints the largest ratio of an error to its tolerance when it is done.
pub(crate) struct Law {
    name: &'static str,
    worst: Cell<f64>,
}

impl Law {
    pub(crate) fn new(name: &'static str) -> Self {
        Self { name, worst: Cell::new(0.0) }
    }

    /// Tries the law on the same samples every time.
    pub(crate) fn holds_for<S: Strategy>(&self, samples: S, law: impl Fn(S::Value) -> TestCaseResult) {
        let config =
            Config { cases: CASES, failure_persistence: None, rng_seed: RngSeed::Fixed(4), ..Config::default() };
        let outcome = TestRunner::new(config).run(&samples, law);
        outcome.unwrap_or_else(|failure| panic!("{}: {failure}", self.name));
    }

    /// That a number is at most its bound.
    pub(crate) fn within(&self, found: f64, bound: f64) -> TestCaseResult {
        let ratio = if found == 0.0 { 0.0 } else { found / bound };
        prop_assert!(ratio <= 1.0, "{found:e} is over {bound:e} by a factor of {ratio}");
        self.worst.set(self.worst.get().max(ratio));
        Ok(())
    }

    /// That two values are the same to the sum of the errors of both sides.
    pub(crate) fn same<P: Parts>(&self, found: P, expected: P, sides: &[Estimate]) -> TestCaseResult {
        let (ratio, allowed) = ratio(found, expected, sides);
        prop_assert!(
            ratio <= 1.0,
            "found {found:?}, expected {expected:?} to {allowed:?}, off by {ratio} times as much"
        );
        self.worst.set(self.worst.get().max(ratio));
        Ok(())
    }

    /// That a value is one of some, the nearest.
    pub(crate) fn one_of<P: Parts>(&self, found: P, expected: &[P], sides: &[Estimate]) -> TestCaseResult {
        let off = |&expected: &P| ratio(found, expected, sides).0;
        let nearest = expected.iter().copied().min_by(|a, b| off(a).total_cmp(&off(b)));
        self.same(found, nearest.expect("something is expected"), sides)
    }

    /// That two motors are the same motion: up to the sign.
    pub(crate) fn same_motion<M: Motion>(&self, found: M, expected: M, sides: &[Estimate]) -> TestCaseResult {
        self.one_of(found, &[expected, -expected], sides)
    }
}

impl Drop for Law {
    fn drop(&mut self) {
        println!("{}: largest error {:.3} of the tolerance", self.name, self.worst.get());
    }
}

/// The largest ratio of an error to its tolerance among the parts, NaN where something is, and the tolerances.
fn ratio<P: Parts>(found: P, expected: P, sides: &[Estimate]) -> (f64, [f64; 3]) {
    let (found, expected) = (found.parts(), expected.parts());
    let allowed = [0, 1, 2].map(|part| sides.iter().map(|side| side.error()[part] + side.underflow()).sum());
    let ratios = [0, 1, 2].map(|part| {
        let error = f64_norm([0, 1, 2, 3].map(|i| found[part][i] - expected[part][i]));
        if error == 0.0 { 0.0 } else { error / allowed[part] }
    });
    (ratios.into_iter().fold(0.0, |worst, ratio| if ratio > worst || ratio.is_nan() { ratio } else { worst }), allowed)
}

fn f64_norm(components: [f64; 4]) -> f64 {
    <f64 as pga_motor::Real>::norm(components)
}

macro_rules! laws {
    ($($law:ident)*) => {
        crate::law::laws! { @modules [$($law)*]
            in_space_f32: pga_motor::f32::Motor, in_space_f64: pga_motor::f64::Motor,
            in_the_plane_f32: pga_motor::pga2d::f32::Motor, in_the_plane_f64: pga_motor::pga2d::f64::Motor,
        }
    };
    (@modules $laws:tt $($module:ident: $motor:ty,)*) => {
        $( crate::law::laws! { @tests $laws $module: $motor } )*
    };
    (@tests [$($law:ident)*] $module:ident: $motor:ty) => {
        mod $module {
            $(
                #[test]
                fn $law() {
                    super::$law::<$motor>(&crate::law::Law::new(concat!(stringify!($law), " ", stringify!($module))));
                }
            )*
        }
    };
}

pub(crate) use laws;
