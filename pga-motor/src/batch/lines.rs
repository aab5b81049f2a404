//! Batches of lines.

use super::Blocks;
use super::work::{map, map_quickly};
use crate::scalar::{Precision, precision};
use crate::{LengthMismatch, Line, Motor, Real, kernels};

/// Functions of lines, one by one.
impl<T: Real> Blocks<Line<T>> {
    /// Writes the exponential of each line, as [`Line::exp_slice`] does, with the same results.
    ///
    /// # Errors
    /// Lists of different lengths; then nothing is written.
    pub fn exp_into(&self, motors: &mut Blocks<Motor<T>>) -> Result<(), LengthMismatch> {
        match precision::<T>() {
            Precision::Single => {
                map_quickly(self, motors, kernels::line_exp_f32, kernels::line_exp_f32_holds, Line::exp)
            }
            Precision::Double => {
                map_quickly(self, motors, kernels::line_exp_f64, kernels::line_exp_f64_holds, Line::exp)
            }
            Precision::Finer => map(self, motors, Line::exp),
        }
    }
}
