//! Whether what calls itself a motor is one.

use crate::{EvenMultivector, Motor, Real, kernels};

/// How far a rest or key motor may be from unit: what remains of a careless export is far below, a scale or a typing error far
/// above.
pub(super) fn tolerance<T: Real>() -> T {
    T::from_ratio(1, 1000)
}

/// Whether a motor is a unit motor. How far it is from the Study quadric is a length, and is measured against the ideal part that it
/// is made of. False for NaN.
pub(super) fn is_rigid<T: Real>(motor: Motor<T>, tolerance: T) -> bool {
    let even = EvenMultivector::from(motor);
    let study = kernels::even_study(even).e0123;
    (even.norm() - T::ONE).abs() <= tolerance && study.abs() <= tolerance * even.ideal_norm()
}
