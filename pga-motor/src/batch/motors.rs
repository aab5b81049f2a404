//! Batches of motors.

use super::Blocks;
use super::lanes::sealed::Fusible;
use super::work::{OnBlock, Quickly, map, map_in_place, zip};
use crate::scalar::{Fused, Precision, precision};
use crate::slices;
use crate::{Direction, EvenMultivector, LengthMismatch, Line, Motor, Plane, Point, Real, Scalar, kernels};

/// Motors, pair by pair, and on points. Nothing is written where the lengths differ.
impl<T: Scalar> Blocks<Motor<T>> {
    /// Writes the product of each motor with the one at the same index of `others`, which acts first.
    ///
    /// # Errors
    /// Lists of different lengths.
    pub fn mul_into(&self, others: &Self, products: &mut Self) -> Result<(), LengthMismatch> {
        zip(self, others, products, product_of_pair, product_of_pair)
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
        zip(self, points, results, transformed, transformed)
    }
}

/// Functions of motors, one by one. Nothing is written where the lengths differ.
impl<T: Real> Blocks<Motor<T>> {
    /// Writes the logarithm of each motor, as [`Motor::log_slice`] does.
    ///
    /// # Errors
    /// Lists of different lengths.
    pub fn log_into(&self, lines: &mut Blocks<Line<T>>) -> Result<(), LengthMismatch> {
        match precision::<T>() {
            Precision::Single => map(self, lines, log_f32::<T>(), log_f32::<Fused<T>>()),
            Precision::Double => map(self, lines, log_f64::<T>(), log_f64::<Fused<T>>()),
            Precision::Finer => map(self, lines, Motor::<T>::log, Motor::<Fused<T>>::log),
        }
    }

    /// Writes each motor without the rounding errors that it has gathered: [`Motor::renormalize`].
    ///
    /// # Errors
    /// Lists of different lengths.
    pub fn renormalize_into(&self, motors: &mut Self) -> Result<(), LengthMismatch> {
        map(self, motors, renormalized, renormalized)
    }
}

/// Pairs and lists in arrays of structs. Nothing is written where the lengths differ. [`Blocks`](crate::batch::Blocks) do the same in a
/// fraction of the time.
impl<T: Scalar> Motor<T> {
    /// Writes the product of each motor with the one at the same index of `others`, which acts first.
    ///
    /// # Errors
    /// Slices of different lengths.
    pub fn mul_slice(motors: &[Self], others: &[Self], products: &mut [Self]) -> Result<(), LengthMismatch> {
        slices::zip(motors, others, products, |a, b| a * b)
    }

    /// Writes where each motor carries the point at the same index.
    ///
    /// # Errors
    /// Slices of different lengths.
    pub fn transform_points_slice(
        motors: &[Self],
        points: &[Point<T>],
        results: &mut [Point<T>],
    ) -> Result<(), LengthMismatch> {
        slices::zip(motors, points, results, Self::transform_point)
    }
}

/// As above.
impl<T: Real> Motor<T> {
    /// Writes each motor without the rounding errors that it has gathered: [`Self::renormalize`].
    ///
    /// # Errors
    /// Slices of different lengths.
    pub fn renormalize_slice(motors: &[Self], results: &mut [Self]) -> Result<(), LengthMismatch> {
        slices::map(motors, results, Self::renormalize)
    }
}

/// One motion of many things, worked out once for all. Nothing is written where the lengths differ.
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
        map(points, results, point_mover(self), point_mover(self.fuse()))
    }

    /// Moves each point.
    pub fn transform_point_blocks_in_place(self, points: &mut Blocks<Point<T>>) {
        map_in_place(points, point_mover(self), point_mover(self.fuse()));
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
        map(directions, results, direction_mover(self), direction_mover(self.fuse()))
    }

    /// Turns each direction.
    pub fn transform_direction_blocks_in_place(self, directions: &mut Blocks<Direction<T>>) {
        map_in_place(directions, direction_mover(self), direction_mover(self.fuse()));
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
        map(lines, results, line_mover(self), line_mover(self.fuse()))
    }

    /// Moves each line.
    pub fn transform_line_blocks_in_place(self, lines: &mut Blocks<Line<T>>) {
        map_in_place(lines, line_mover(self), line_mover(self.fuse()));
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
        map(planes, results, plane_mover(self), plane_mover(self.fuse()))
    }

    /// Moves each plane.
    pub fn transform_plane_blocks_in_place(self, planes: &mut Blocks<Plane<T>>) {
        map_in_place(planes, plane_mover(self), plane_mover(self.fuse()));
    }
}

fn log_f32<S: Real>() -> impl OnBlock<Motor<S>, Line<S>> {
    Quickly {
        quick: |motor: Motor<S>| kernels::motor_log_f32(motor.short_way()),
        holds: |motor: Motor<S>| kernels::motor_log_f32_holds(motor.short_way()),
        exact: Motor::log,
    }
}

fn log_f64<S: Real>() -> impl OnBlock<Motor<S>, Line<S>> {
    Quickly {
        quick: |motor: Motor<S>| kernels::motor_log_f64(motor.short_way()),
        holds: |motor: Motor<S>| kernels::motor_log_f64_holds(motor.short_way()),
        exact: Motor::log,
    }
}

#[inline(always)]
pub(crate) fn product<S: Scalar>(a: Motor<S>, b: Motor<S>) -> Motor<S> {
    kernels::motor_mul_motor_fma(a, b)
}

#[inline(always)]
fn product_of_pair<S: Scalar>((a, b): (Motor<S>, Motor<S>)) -> Motor<S> {
    product(a, b)
}

#[inline(always)]
fn transformed<S: Scalar>((motor, point): (Motor<S>, Point<S>)) -> Point<S> {
    kernels::motor_transform_point_fma(motor, point)
}

#[inline(always)]
fn renormalized<S: Real>(motor: Motor<S>) -> Motor<S> {
    kernels::even_normalize_fma(EvenMultivector::from(motor))
}

fn point_mover<S: Scalar>(motor: Motor<S>) -> impl Fn(Point<S>) -> Point<S> {
    let matrix = kernels::motor_to_matrix(motor);
    #[inline(always)]
    move |point| kernels::matrix_apply_point(matrix, point)
}

fn direction_mover<S: Scalar>(motor: Motor<S>) -> impl Fn(Direction<S>) -> Direction<S> {
    let matrix = kernels::motor_to_direction_matrix(motor);
    #[inline(always)]
    move |direction| kernels::matrix_apply_direction(matrix, direction)
}

fn line_mover<S: Scalar>(motor: Motor<S>) -> impl Fn(Line<S>) -> Line<S> {
    let matrix = kernels::motor_to_line_matrix(motor);
    #[inline(always)]
    move |line| kernels::matrix_apply_line(matrix, line)
}

fn plane_mover<S: Scalar>(motor: Motor<S>) -> impl Fn(Plane<S>) -> Plane<S> {
    let matrix = kernels::motor_to_plane_matrix(motor);
    #[inline(always)]
    move |plane| kernels::matrix_apply_plane(matrix, plane)
}
