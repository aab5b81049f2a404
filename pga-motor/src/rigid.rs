//! Matrices and quaternions of rigid motions.
//!
//! Matrices act on column vectors and are given by their columns, as in glam, OpenGL and glTF. A matrix is a motor only
//! if it is rigid: to [`TOLERANCE_F32`] or [`TOLERANCE_F64`], so that what has gathered rounding errors passes and
//! scales, shears and mirrors do not. What passes is made exactly unit. Otherwise [`NotRigid`] tells what was found,
//! and where. m and -m are the same motion; back comes the one of the two whose scalar part is not negative.

use crate::scalar::{Precision, precision};
use crate::{Direction, EvenMultivector, Motor, Real, Rotor, Scalar, Translator, kernels};
use core::fmt;

/// How far scalar products of a matrix's columns, its last row and a quaternion's squared norm may be from those of an
/// exact rigid motion in `f32`.
pub const TOLERANCE_F32: f64 = 1e-4;

/// How far scalar products of a matrix's columns, its last row and a quaternion's squared norm may be from those of an
/// exact rigid motion in `f64`: wide enough for what was once `f32`.
pub const TOLERANCE_F64: f64 = 1e-6;

/// Why a matrix or quaternion is no rigid motion, and where. Columns and rows are counted from 0; the first axis, or
/// what is most off, is named.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum NotRigid {
    /// An entry is infinite or NaN. Of a quaternion, x, y, z and w are the rows of column 0; of a vector after it,
    /// x, y and z those of column 1.
    NotFinite {
        /// The column of the first one.
        column: usize,
        /// Its row.
        row: usize,
    },
    /// The last row is not 0 0 0 1, or 0 0 1 in the plane.
    LastRow {
        /// The column in which it is most off.
        column: usize,
        /// What it is there.
        found: f64,
        /// What it should be: 1 in the last column, else 0.
        expected: f64,
        /// How far it may be off.
        tolerance: f64,
    },
    /// An axis is not of length 1.
    Scaled {
        /// The column that it is.
        column: usize,
        /// The square of its length.
        length_squared: f64,
        /// How far from 1 it may be.
        tolerance: f64,
    },
    /// Two axes are not perpendicular.
    Sheared {
        /// The columns that they are.
        columns: [usize; 2],
        /// Their scalar product.
        product: f64,
        /// How far from 0 it may be.
        tolerance: f64,
    },
    /// The axes are those of a reflection.
    Mirror {
        /// Their determinant, near -1.
        determinant: f64,
    },
    /// The quaternion is not of norm 1.
    NotUnit {
        /// The squared norm.
        norm_squared: f64,
        /// How far from 1 it may be.
        tolerance: f64,
    },
}

impl fmt::Display for NotRigid {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotFinite { column, row } => {
                write!(f, "column {column}, row {row}: expected a finite entry, found an infinite one or NaN")
            }
            Self::LastRow { column, found, expected, tolerance } => {
                write!(f, "column {column}, last row: expected {expected} within {tolerance:e}, found {found}")
            }
            Self::Scaled { column, length_squared, tolerance } => {
                write!(
                    f,
                    "column {column}: expected an axis of squared length 1 within {tolerance:e}, found {length_squared}"
                )
            }
            Self::Sheared { columns: [a, b], product, tolerance } => {
                write!(
                    f,
                    "columns {a} and {b}: expected perpendicular axes, product 0 within {tolerance:e}, found {product}"
                )
            }
            Self::Mirror { determinant } => {
                write!(f, "expected a rotation with determinant 1, found a mirror with determinant {determinant}")
            }
            Self::NotUnit { norm_squared, tolerance } => {
                write!(f, "expected a quaternion of squared norm 1 within {tolerance:e}, found {norm_squared}")
            }
        }
    }
}

impl core::error::Error for NotRigid {}

/// Motions as quaternion and vector, and as matrices.
impl<T: Real> Motor<T> {
    /// The rotation of the quaternion w + x i + y j + z k, given as `[x, y, z, w]`, followed by the translation by
    /// `[x, y, z]`: what glTF and glam's pairs hold. The quaternion is normalised.
    ///
    /// `None` for the zero quaternion, and where something is not finite.
    ///
    /// ```
    /// use pga_motor::f64::{Motor, Point};
    ///
    /// let motor = Motor::from_quaternion_translation([0.0, 0.0, 2.0, 2.0], [5.0, 0.0, 0.0]).unwrap();
    /// let moved = motor.transform_point(Point::new(1.0, 0.0, 0.0));
    /// assert!(moved.distance_to_point(Point::new(5.0, 1.0, 0.0)) < 1e-15);
    /// ```
    pub fn from_quaternion_translation(quaternion: [T; 4], translation: [T; 3]) -> Option<Self> {
        let rotor = Rotor::from_quaternion_xyzw(quaternion)?;
        let motor = Self::from_rotor_translator(rotor, Translator::from_vector(translation.into()));
        motor.is_finite().then_some(motor)
    }

    /// The motion of a rigid 4 x 4 matrix, given by columns: where the axes' directions and the origin go. The way back
    /// is `to_matrix().to_columns()`.
    ///
    /// Accurate at every angle, half turns included.
    ///
    /// # Errors
    /// A matrix that is not finite, not affine, scales, shears or mirrors; see [`rigid`](crate::rigid).
    ///
    /// ```
    /// use pga_motor::NotRigid;
    /// use pga_motor::f64::{Motor, Rotor};
    ///
    /// // Half a turn about the vertical through (1, 0, 0).
    /// let columns = [[-1.0, 0.0, 0.0, 0.0], [0.0, -1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [2.0, 0.0, 0.0, 1.0]];
    /// let motor = Motor::from_columns(columns)?;
    /// assert_eq!(motor.to_matrix().to_columns(), columns);
    ///
    /// let mut mirror = columns;
    /// mirror[2][2] = -1.0;
    /// assert_eq!(Motor::from_columns(mirror), Err(NotRigid::Mirror { determinant: -1.0 }));
    /// # Ok::<(), NotRigid>(())
    /// ```
    pub fn from_columns(columns: [[T; 4]; 4]) -> Result<Self, NotRigid> {
        let checked = columns.map(|column| column.map(T::to_f64));
        check_columns(checked, tolerance::<T>())?;
        let [x, y, z, _] = checked.map(direction);
        check_orientation(x.cross(y).dot(z))?;
        let [x, y, z, origin] = columns.map(direction);
        Ok(Self::from_rotor_translator(rotor([x, y, z]), Translator::from_vector(origin)))
    }
}

impl<T: Scalar> Motor<T> {
    /// The rotation as the unit quaternion w + x i + y j + z k, `[x, y, z, w]`, and the translation that follows it,
    /// `[x, y, z]`.
    pub fn to_quaternion_translation(self) -> ([T; 4], [T; 3]) {
        (self.rotor().to_quaternion_xyzw(), self.translator().vector().to_array())
    }
}

fn direction<T: Scalar>([x, y, z, _]: [T; 4]) -> Direction<T> {
    Direction::new(x, y, z)
}

/// The rotor that turns the coordinate axes to the given ones, with a scalar part that is not negative.
///
/// The quaternion (1 + trace, antisymmetric part) has the square root of 4 (1 + trace) for a norm, which half turns
/// bring to 0. So the axes are first turned by half a turn, or none, about the coordinate axis for which the trace is
/// greatest, which leaves it no less than 0: the four traces add up to 0 (Shepperd 1978, as one case instead of four).
fn rotor<T: Real>(axes: [Direction<T>; 3]) -> Rotor<T> {
    let (zero, one) = (T::ZERO, T::ONE);
    let half_turns = [[one, zero, zero], [zero, one, zero], [zero, zero, one]];
    let mut best = (axes, Rotor::IDENTITY);
    for [x, y, z] in half_turns {
        let kept = |part: T, axis: Direction<T>| if part == one { axis } else { -axis };
        let turned = [kept(x, axes[0]), kept(y, axes[1]), kept(z, axes[2])];
        if trace(turned) > trace(best.0) {
            best = (turned, Rotor::new(zero, -x, -y, -z));
        }
    }
    let (turned, half_turn) = best;
    let rotor = kernels::rotor_mul_rotor(near_rotor(turned), half_turn);
    if rotor.s < zero { -rotor } else { rotor }
}

fn trace<T: Scalar>([x, y, z]: [Direction<T>; 3]) -> T {
    x.x + y.y + z.z
}

/// The rotor of a turn by at most 120 degrees.
fn near_rotor<T: Real>(axes: [Direction<T>; 3]) -> Rotor<T> {
    let [x, y, z] = axes;
    EvenMultivector { s: T::ONE + trace(axes), e23: z.y - y.z, e31: x.z - z.x, e12: y.x - x.y, ..EvenMultivector::ZERO }
        .over_norm()
        .rotor()
}

/// Types as fine as `f64` must be as exact as that, coarser ones as `f32`.
pub(crate) fn tolerance<T: Real>() -> f64 {
    if precision::<T>() == Precision::Single { TOLERANCE_F32 } else { TOLERANCE_F64 }
}

/// Whether a matrix, given by columns, is finite and affine with orthonormal axes.
pub(crate) fn check_columns<const N: usize>(columns: [[f64; N]; N], tolerance: f64) -> Result<(), NotRigid> {
    for (column, entries) in columns.iter().enumerate() {
        check_finite(column, entries)?;
    }
    check_last_row(columns, tolerance)?;
    check_axes(columns, tolerance)
}

/// Whether the entries of a column are finite.
pub(crate) fn check_finite(column: usize, entries: &[f64]) -> Result<(), NotRigid> {
    match entries.iter().position(|entry| !entry.is_finite()) {
        Some(row) => Err(NotRigid::NotFinite { column, row }),
        None => Ok(()),
    }
}

fn check_last_row<const N: usize>(columns: [[f64; N]; N], tolerance: f64) -> Result<(), NotRigid> {
    let mut worst = (tolerance, Ok(()));
    for (column, entries) in columns.iter().enumerate() {
        let (found, expected) = (entries[N - 1], if column == N - 1 { 1.0 } else { 0.0 });
        let deviation = (found - expected).abs();
        if deviation > worst.0 {
            worst = (deviation, Err(NotRigid::LastRow { column, found, expected, tolerance }));
        }
    }
    worst.1
}

fn check_axes<const N: usize>(columns: [[f64; N]; N], tolerance: f64) -> Result<(), NotRigid> {
    let mut worst = (tolerance, Ok(()));
    for a in 0..N - 1 {
        for b in a..N - 1 {
            let rows = columns[a].iter().zip(&columns[b]).take(N - 1);
            let product: f64 = rows.map(|(a, b)| a * b).sum();
            let (deviation, error) = if a == b {
                ((product - 1.0).abs(), NotRigid::Scaled { column: a, length_squared: product, tolerance })
            } else {
                (product.abs(), NotRigid::Sheared { columns: [a, b], product, tolerance })
            };
            if deviation > worst.0 {
                worst = (deviation, Err(error));
            }
        }
    }
    worst.1
}

/// Whether axes of this determinant are those of a rotation.
pub(crate) fn check_orientation(determinant: f64) -> Result<(), NotRigid> {
    if determinant < 0.0 { Err(NotRigid::Mirror { determinant }) } else { Ok(()) }
}

/// The rotor of a quaternion that is unit to the tolerance of its type.
#[cfg(feature = "glam")]
pub(crate) fn rotor_from_unit_quaternion<T: Real>(quaternion: [T; 4]) -> Result<Rotor<T>, NotRigid> {
    let checked = quaternion.map(T::to_f64);
    check_finite(0, &checked)?;
    let norm_squared = checked.iter().map(|coefficient| coefficient * coefficient).sum();
    let tolerance = tolerance::<T>();
    let not_unit = NotRigid::NotUnit { norm_squared, tolerance };
    if (norm_squared - 1.0).abs() > tolerance {
        return Err(not_unit);
    }
    Rotor::from_quaternion_xyzw(quaternion).ok_or(not_unit)
}

#[cfg(test)]
mod tests;
