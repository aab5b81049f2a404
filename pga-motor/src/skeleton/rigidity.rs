//! Whether what calls itself a motor is one.

use crate::{EvenMultivector, Motor, Real, kernels};

/// Tells motors from what is none, among motors of a kind.
pub(super) struct Rigidity<T> {
    /// What e0123 may be off though the translation be 0: the length that rounding leaves of differences.
    negligible: T,
}

impl<T: Real> Rigidity<T> {
    /// For motors that were worked out with lengths like those of these motors. Differences of lengths leave some roundings of these
    /// behind, or of 1 where all are shorter.
    pub(super) fn among<'a>(motors: impl IntoIterator<Item = &'a Motor<T>>) -> Self
    where
        T: 'a,
    {
        let lengths = motors.into_iter().map(|&motor| EvenMultivector::from(motor).ideal_norm());
        let longest = lengths.fold(T::ONE, |longest, length| if length > longest { length } else { longest });
        Self { negligible: if longest.is_finite() { rounding::<T>() * longest } else { T::ZERO } }
    }

    /// A motor that is unit up to 1e-3, brought back to unit; `None` for one that is further off, or NaN. What remains of a careless
    /// export is far below that, a scale or a typing error far above.
    ///
    /// What products of unit motors leave behind stays as it is, so that motors are what was handed in.
    pub(super) fn brought_back(&self, motor: Motor<T>) -> Option<Motor<T>> {
        if self.is_rigid(motor, rounding()) {
            Some(motor)
        } else {
            self.is_rigid(motor, T::from_ratio(1, 1000)).then(|| motor.renormalize())
        }
    }

    /// Whether a motor is a unit motor. How far it is from the Study quadric is a length, and is measured against the ideal part that it
    /// is made of.
    fn is_rigid(&self, motor: Motor<T>, tolerance: T) -> bool {
        let even = EvenMultivector::from(motor);
        let study = kernels::even_study(even).e0123;
        (even.norm() - T::ONE).abs() <= tolerance && study.abs() <= tolerance * even.ideal_norm() + self.negligible
    }
}

/// What some products leave of a number of size 1.
fn rounding<T: Real>() -> T {
    T::from_ratio(64, 1) * T::EPSILON
}
