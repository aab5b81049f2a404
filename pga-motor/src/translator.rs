//! Translations.

use crate::{
    Direction, EvenMultivector, LengthMismatch, Line, Motor, Plane, Point, ProjectivePoint, Scalar, Translator,
    UnitLine, UnitPlane, kernels, slices,
};
use core::ops::Shr;

/// Lengths are in the caller's unit.
///
/// ```
/// use pga_motor::f64::{Direction, Point, Translator};
///
/// let translator = Translator::from_vector(Direction::new(1.0, 2.0, 3.0));
/// assert_eq!(translator.transform_point(Point::ORIGIN), Point::new(1.0, 2.0, 3.0));
/// assert_eq!(translator.inverse().vector(), Direction::new(-1.0, -2.0, -3.0));
/// ```
impl<T: Scalar> Translator<T> {
    /// The translation by a vector: by (x, y, z) it is 1 - (x e01 + y e02 + z e03)/2.
    #[inline]
    pub fn from_vector(vector: Direction<T>) -> Self {
        kernels::translator_from_direction(vector)
    }

    /// The vector by which this translates.
    #[inline]
    pub fn vector(self) -> Direction<T> {
        kernels::translator_direction(self)
    }

    /// ~t: the opposite translation.
    #[inline]
    pub fn reverse(self) -> Self {
        kernels::translator_reverse(self)
    }

    /// The opposite translation. A translator is of unit norm, so this is the reverse.
    #[inline]
    pub fn inverse(self) -> Self {
        self.reverse()
    }

    /// The right complement: X ^ X.dual() is e0123 for every basis blade X.
    #[inline]
    pub fn dual(self) -> EvenMultivector<T> {
        EvenMultivector::from(self).dual()
    }

    /// The inverse of [`EvenMultivector::dual`].
    #[inline]
    pub fn undual(self) -> EvenMultivector<T> {
        EvenMultivector::from(self).undual()
    }

    /// t x ~t for anything that a translator can act on; the same as `t >> x`.
    #[inline]
    pub fn transform<X>(self, x: X) -> <Self as Shr<X>>::Output
    where
        Self: Shr<X>,
    {
        self >> x
    }

    /// Where the translation carries a point.
    #[inline]
    pub fn transform_point(self, point: Point<T>) -> Point<T> {
        kernels::translator_transform_point(self, point)
    }

    /// Where the translation carries a projective point; its weight stays.
    #[inline]
    pub fn transform_projective_point(self, point: ProjectivePoint<T>) -> ProjectivePoint<T> {
        kernels::translator_transform_projective_point(self, point)
    }

    /// The direction itself: translations do not move directions.
    #[inline]
    pub fn transform_direction(self, direction: Direction<T>) -> Direction<T> {
        kernels::translator_transform_direction(self, direction)
    }

    /// Where the translation carries a line or a screw.
    #[inline]
    pub fn transform_line(self, line: Line<T>) -> Line<T> {
        kernels::translator_transform_line(self, line)
    }

    /// Where the translation carries a unit line.
    #[inline]
    pub fn transform_unit_line(self, line: UnitLine<T>) -> UnitLine<T> {
        kernels::translator_transform_unit_line(self, line)
    }

    /// Where the translation carries a plane.
    #[inline]
    pub fn transform_plane(self, plane: Plane<T>) -> Plane<T> {
        kernels::translator_transform_plane(self, plane)
    }

    /// Where the translation carries a unit plane.
    #[inline]
    pub fn transform_unit_plane(self, plane: UnitPlane<T>) -> UnitPlane<T> {
        kernels::translator_transform_unit_plane(self, plane)
    }

    /// t m ~t: the motion m about the place to which the translation carries it.
    #[inline]
    pub fn transform_motor(self, motor: Motor<T>) -> Motor<T> {
        kernels::translator_transform_motor(self, motor)
    }

    /// Writes where the translation carries each point into the place with the same index.
    ///
    /// # Errors
    /// Slices of different lengths; then nothing is written.
    pub fn transform_points(self, points: &[Point<T>], results: &mut [Point<T>]) -> Result<(), LengthMismatch> {
        slices::map(points, results, |point| self.transform_point(point))
    }

    /// Moves each point.
    pub fn transform_points_in_place(self, points: &mut [Point<T>]) {
        slices::map_in_place(points, |point| self.transform_point(point));
    }
}
