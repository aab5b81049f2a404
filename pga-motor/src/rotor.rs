//! Rotations about axes through the origin.

use crate::{
    Direction, EvenMultivector, LengthMismatch, Line, Motor, Plane, Point, ProjectivePoint, Real, Rotor, Scalar,
    UnitLine, UnitPlane, kernels, magnitude, slices,
};
use core::ops::Shr;

/// Constructors. Angles are in radians and right-handed: counter-clockwise, seen against the axis. The rotor of angle t
/// about the unit axis (x, y, z) is cos(t/2) - sin(t/2) (x e23 + y e31 + z e12).
///
/// ```
/// use pga_motor::f64::{Direction, Rotor};
///
/// let quarter_turn = Rotor::about_z(std::f64::consts::FRAC_PI_2);
/// let turned = quarter_turn.transform_direction(Direction::X);
/// assert!((turned - Direction::Y).norm() < 1e-15);
/// ```
impl<T: Real> Rotor<T> {
    /// The rotation about the x axis, from y towards z. NaN for an angle that is not finite.
    #[inline]
    pub fn about_x(angle: T) -> Self {
        Self::about_unit_direction(Direction::X, angle)
    }

    /// The rotation about the y axis, from z towards x. NaN for an angle that is not finite.
    #[inline]
    pub fn about_y(angle: T) -> Self {
        Self::about_unit_direction(Direction::Y, angle)
    }

    /// The rotation about the z axis, from x towards y. NaN for an angle that is not finite.
    #[inline]
    pub fn about_z(angle: T) -> Self {
        Self::about_unit_direction(Direction::Z, angle)
    }

    /// The rotation about an axis of any length other than 0 through the origin.
    ///
    /// `None` where the axis is zero, or the axis or the angle is not finite. However short or long the axis, its
    /// squares neither underflow nor overflow.
    #[inline]
    pub fn from_axis_angle(axis: Direction<T>, angle: T) -> Option<Self> {
        let axis = axis.normalize()?;
        angle.is_finite().then(|| Self::about_unit_direction(axis, angle))
    }

    fn about_unit_direction(axis: Direction<T>, angle: T) -> Self {
        let (sin, cos) = (angle * T::from_ratio(1, 2)).sin_cos();
        kernels::direction_rotor(axis, cos, sin)
    }

    /// The rotation of the quaternion w + x i + y j + z k, given as `[x, y, z, w]` as in glam and glTF; it is
    /// normalised. The rotor is w - x e23 - y e31 - z e12.
    ///
    /// `None` for the zero quaternion and for coefficients that are not finite.
    #[inline]
    pub fn from_quaternion_xyzw(quaternion: [T; 4]) -> Option<Self> {
        let scale = magnitude::scale(quaternion)?;
        let [x, y, z, w] = quaternion.map(|coefficient| coefficient * scale);
        let zero = T::ZERO;
        let norm = kernels::even_norm_squared(EvenMultivector::new(w, -x, -y, -z, zero, zero, zero, zero)).sqrt();
        Some(Self::new(w / norm, -(x / norm), -(y / norm), -(z / norm)))
    }
}

impl<T: Real> Rotor<T> {
    /// Whether the promise of the type, unit norm, holds to an absolute `tolerance`. False for NaN.
    #[inline]
    pub fn is_unit(self, tolerance: T) -> bool {
        self.satisfies_relations(tolerance)
    }
}

impl<T: Scalar> Rotor<T> {
    /// The unit quaternion w + x i + y j + z k of the same rotation, as `[x, y, z, w]`.
    #[inline]
    pub fn to_quaternion_xyzw(self) -> [T; 4] {
        [-self.e23, -self.e31, -self.e12, self.s]
    }

    /// ~r: the opposite rotation.
    #[inline]
    pub fn reverse(self) -> Self {
        kernels::rotor_reverse(self)
    }

    /// The opposite rotation. A rotor is of unit norm, so this is the reverse.
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

    /// r x ~r for anything that a rotor can act on; the same as `r >> x`.
    #[inline]
    pub fn transform<X>(self, x: X) -> <Self as Shr<X>>::Output
    where
        Self: Shr<X>,
    {
        self >> x
    }

    /// Where the rotation carries a point.
    #[inline]
    pub fn transform_point(self, point: Point<T>) -> Point<T> {
        kernels::rotor_transform_point(self, point)
    }

    /// Where the rotation carries a projective point; its weight stays.
    #[inline]
    pub fn transform_projective_point(self, point: ProjectivePoint<T>) -> ProjectivePoint<T> {
        kernels::rotor_transform_projective_point(self, point)
    }

    /// Where the rotation carries a direction.
    #[inline]
    pub fn transform_direction(self, direction: Direction<T>) -> Direction<T> {
        kernels::rotor_transform_direction(self, direction)
    }

    /// Where the rotation carries a line or a screw.
    #[inline]
    pub fn transform_line(self, line: Line<T>) -> Line<T> {
        kernels::rotor_transform_line(self, line)
    }

    /// Where the rotation carries a unit line.
    #[inline]
    pub fn transform_unit_line(self, line: UnitLine<T>) -> UnitLine<T> {
        kernels::rotor_transform_unit_line(self, line)
    }

    /// Where the rotation carries a plane.
    #[inline]
    pub fn transform_plane(self, plane: Plane<T>) -> Plane<T> {
        kernels::rotor_transform_plane(self, plane)
    }

    /// Where the rotation carries a unit plane.
    #[inline]
    pub fn transform_unit_plane(self, plane: UnitPlane<T>) -> UnitPlane<T> {
        kernels::rotor_transform_unit_plane(self, plane)
    }

    /// r m ~r: the motion m about the place to which the rotation carries it.
    #[inline]
    pub fn transform_motor(self, motor: Motor<T>) -> Motor<T> {
        kernels::rotor_transform_motor(self, motor)
    }

    /// Writes where the rotation carries each point into the place with the same index.
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
