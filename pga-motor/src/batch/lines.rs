//! Batches of lines.

use super::Blocks;
use super::work::{OnBlock, Quickly, map};
use crate::scalar::{Fused, Precision, precision};
use crate::{LengthMismatch, Line, Motor, Real, kernels};

/// Functions of lines, one by one.
impl<T: Real> Blocks<Line<T>> {
    /// Writes the exponential of each line, as [`Line::exp_slice`] does.
    ///
    /// # Errors
    /// Lists of different lengths; then nothing is written.
    pub fn exp_into(&self, motors: &mut Blocks<Motor<T>>) -> Result<(), LengthMismatch> {
        match precision::<T>() {
            Precision::Single => map(self, motors, exp_f32::<T>(), exp_f32::<Fused<T>>()),
            Precision::Double => map(self, motors, exp_f64::<T>(), exp_f64::<Fused<T>>()),
            Precision::Finer => map(self, motors, Line::<T>::exp, Line::<Fused<T>>::exp),
        }
    }
}

fn exp_f32<S: Real>() -> impl OnBlock<Line<S>, Motor<S>> {
    Quickly { quick: kernels::line_exp_f32, holds: kernels::line_exp_f32_holds, exact: Line::exp }
}

fn exp_f64<S: Real>() -> impl OnBlock<Line<S>, Motor<S>> {
    Quickly { quick: kernels::line_exp_f64, holds: kernels::line_exp_f64_holds, exact: Line::exp }
}
