//! Batches of motors.

use super::Blocks;
use super::work::{map, map_quickly, zip};
use crate::scalar::{Precision, precision};
use crate::{Direction, LengthMismatch, Line, Motor, Plane, Point, Real, Scalar, interpolate, kernels};

/// Motors, pair by pair, and on points.
///
/// In each of these nothing is written where the lengths differ, and results are those of the kernels, bit for bit: of
/// [`kernels::motor_mul_motor`], which operators add up in another order for `f32`, and of [`kernels::motor_transform_point`].
impl<T: Scalar> Blocks<Motor<T>> {
    /// Writes the product of each motor with the one at the same index of `others`, which acts first.
    ///
    /// # Errors
    /// Lists of different lengths.
    pub fn mul_into(&self, others: &Self, products: &mut Self) -> Result<(), LengthMismatch> {
        zip(self, others, products, kernels::motor_mul_motor)
    }

    /// Writes where each motor carries the point at the same index.
    ///
    /// # Errors
    /// Lists of different lengths.
    pub fn transform_points_into(
        &self,
        points: &Blocks<Point<T>>,
        results: &mut Blocks<Point<T>>,
    ) -> Result<(), LengthMismatch> {
        zip(self, points, results, kernels::motor_transform_point)
    }
}

/// Functions of motors, one by one.
impl<T: Real> Blocks<Motor<T>> {
    /// Writes the logarithm of each motor, as [`Motor::log_slice`] does, with the same results.
    ///
    /// # Errors
    /// Lists of different lengths; then nothing is written.
    pub fn log_into(&self, lines: &mut Blocks<Line<T>>) -> Result<(), LengthMismatch> {
        match precision::<T>() {
            Precision::Single => map_quickly(
                self,
                lines,
                |motor: Motor<T>| kernels::motor_log_f32(motor.short_way()),
                |motor: Motor<T>| kernels::motor_log_f32_holds(motor.short_way()),
                Motor::log,
            ),
            Precision::Double => map_quickly(
                self,
                lines,
                |motor: Motor<T>| kernels::motor_log_f64(motor.short_way()),
                |motor: Motor<T>| kernels::motor_log_f64_holds(motor.short_way()),
                Motor::log,
            ),
            Precision::Finer => map(self, lines, Motor::log),
        }
    }

    /// Writes the motors between each of these and the one at the same index of `others`: [`Motor::nlerp`], with the same results.
    ///
    /// # Errors
    /// Lists of different lengths; then nothing is written.
    pub fn nlerp_into(&self, others: &Self, t: T, motors: &mut Self) -> Result<(), LengthMismatch> {
        let path = interpolate::Chord::at(t);
        if path.is_between() {
            zip(self, others, motors, |a, b| path.between(a, b))
        } else {
            zip(self, others, motors, |a: Motor<T>, b: Motor<T>| a.nlerp(b, t))
        }
    }
}

/// One motion of many things, worked out once for all.
///
/// In each of these nothing is written where the lengths differ, and results are those of the functions of slices, bit for bit.
impl<T: Scalar> Motor<T> {
    /// Writes where the motion carries each point.
    ///
    /// # Errors
    /// Lists of different lengths.
    pub fn transform_point_blocks(
        self,
        points: &Blocks<Point<T>>,
        results: &mut Blocks<Point<T>>,
    ) -> Result<(), LengthMismatch> {
        let matrix = kernels::motor_to_matrix(self);
        map(points, results, |point| kernels::matrix_apply_point(matrix, point))
    }

    /// Writes where the motion carries each direction.
    ///
    /// # Errors
    /// Lists of different lengths.
    pub fn transform_direction_blocks(
        self,
        directions: &Blocks<Direction<T>>,
        results: &mut Blocks<Direction<T>>,
    ) -> Result<(), LengthMismatch> {
        let matrix = kernels::motor_to_direction_matrix(self);
        map(directions, results, |direction| kernels::matrix_apply_direction(matrix, direction))
    }

    /// Writes where the motion carries each line.
    ///
    /// # Errors
    /// Lists of different lengths.
    pub fn transform_line_blocks(
        self,
        lines: &Blocks<Line<T>>,
        results: &mut Blocks<Line<T>>,
    ) -> Result<(), LengthMismatch> {
        let matrix = kernels::motor_to_line_matrix(self);
        map(lines, results, |line| kernels::matrix_apply_line(matrix, line))
    }

    /// Writes where the motion carries each plane.
    ///
    /// # Errors
    /// Lists of different lengths.
    pub fn transform_plane_blocks(
        self,
        planes: &Blocks<Plane<T>>,
        results: &mut Blocks<Plane<T>>,
    ) -> Result<(), LengthMismatch> {
        let matrix = kernels::motor_to_plane_matrix(self);
        map(planes, results, |plane| kernels::matrix_apply_plane(matrix, plane))
    }
}
