//! Many products.

use crate::law::{Law, laws};
use crate::motion::Motion;

laws! {
    a_million_products_stay_unit_with_renormalization_and_drift_without
}

const PRODUCTS: u32 = 1_000_000;

/// A turn about an axis off the origin, without a slide, so that the motors stay as far away as they are. What is
/// normalised is unit to 5 u, and on the Study quadric to 18 u times the ideal part, however many products went before.
///
/// Without, a product is as far off as its factors together: what the step is off adds up.
fn a_million_products_stay_unit_with_renormalization_and_drift_without<M: Motion>(law: &Law) {
    let step = M::exp(M::generator([0.03, -0.02, 0.05], [0.02, 0.03, 0.0]));
    let (mut kept, mut left, mut largest) = (step, step, step.sizes()[2]);
    for _ in 0..PRODUCTS {
        kept = (step * kept).renormalize();
        left = step * left;
        largest = largest.max(kept.sizes()[2]);
    }
    let unit = M::unit();
    let [norm, study] = kept.defects();
    let outcome = law.within(norm.abs(), 2.0 * 5.0 * unit);
    outcome.and_then(|()| law.within(study.abs(), 18.0 * unit * largest)).expect("unit to a few ulp");
    assert!(left.defects()[0].abs() > 1000.0 * unit, "it drifts by {:e}", left.defects()[0]);
}
