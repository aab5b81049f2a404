//! Conversions to and from glam, in `f32` and `f64`.
//!
//! | here | glam, `f32` | glam, `f64` | there | back |
//! |---|---|---|---|---|
//! | `Motor` | `Mat4`, `Affine3A`, `(Quat, Vec3)` | `DMat4`, `DAffine3`, `(DQuat, DVec3)` | `From` | `TryFrom` |
//! | `Rotor` | `Quat` | `DQuat` | `From` | `TryFrom` |
//! | `Point`, `Direction` | `Vec3`, `Vec3A` | `DVec3` | `From` | `From` |
//! | `pga2d::Point`, `pga2d::Direction` | `Vec2` | `DVec2` | `From` | `From` |
//!
//! A matrix acts on column vectors and a pair is the rotation followed by the translation, so `Mat4::from(b * a)` is
//! `Mat4::from(b) * Mat4::from(a)`. m and -m give the same matrix; back comes one of the two.
//!
//! A matrix is a motor only if it is rigid, and a quaternion is a rotor only if it is unit: to [`TOLERANCE_F32`] or
//! [`TOLERANCE_F64`], so that what has gathered rounding errors passes and scales, shears and mirrors do not. What
//! passes is made exactly unit. Otherwise [`NotRigid`] tells what was found.
//!
//! ```
//! use glam::{Mat4, Vec3};
//! use pga_motor::f32::{Motor, Point};
//! use pga_motor::interop::glam::NotRigid;
//!
//! let matrix = Mat4::from_translation(Vec3::new(1.0, 2.0, 3.0));
//! let motor = Motor::try_from(matrix)?;
//! assert_eq!(motor.transform_origin(), Point::new(1.0, 2.0, 3.0));
//! assert_eq!(Mat4::from(motor), matrix);
//!
//! let mirror = Mat4::from_scale(Vec3::new(-1.0, 1.0, 1.0));
//! assert_eq!(Motor::try_from(mirror), Err(NotRigid::Mirror { determinant: -1.0 }));
//! # Ok::<(), NotRigid>(())
//! ```

use crate::{Direction, Motor, Point, Rotor, Translator, pga2d};
use ::glam::{Affine3A, DAffine3, DMat3, DMat4, DQuat, DVec2, DVec3, Mat3, Mat4, Quat, Vec2, Vec3, Vec3A};
use core::fmt;

/// How far scalar products of a matrix's columns, its last row and a quaternion's squared norm may be from those of an
/// exact rigid motion in `f32`.
pub const TOLERANCE_F32: f64 = 1e-4;

/// How far scalar products of a matrix's columns, its last row and a quaternion's squared norm may be from those of an
/// exact rigid motion in `f64`: wide enough for what was once `f32`.
pub const TOLERANCE_F64: f64 = 1e-6;

/// Why a matrix or quaternion is no rigid motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NotRigid {
    /// An entry is infinite or NaN.
    NotFinite,
    /// The last row is not 0 0 0 1.
    LastRow {
        /// What it is.
        found: [f64; 4],
        /// How far each entry may be off.
        tolerance: f64,
    },
    /// The columns of the rotation part are not of length 1 and perpendicular.
    NotOrthonormal {
        /// The largest difference of a scalar product of two columns from 1 (same column) or 0.
        deviation: f64,
        /// The largest that is accepted.
        tolerance: f64,
    },
    /// The rotation part mirrors.
    Mirror {
        /// Its determinant, near -1.
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
            Self::NotFinite => f.write_str("expected finite entries, found an infinite one or NaN"),
            Self::LastRow { found, tolerance } => {
                write!(f, "expected the last row 0 0 0 1 to {tolerance:e}, found {found:?}")
            }
            Self::NotOrthonormal { deviation, tolerance } => {
                write!(f, "expected orthonormal columns to {tolerance:e}, found scalar products off by {deviation:e}")
            }
            Self::Mirror { determinant } => {
                write!(f, "expected a rotation with determinant 1, found a mirror with determinant {determinant}")
            }
            Self::NotUnit { norm_squared, tolerance } => {
                write!(f, "expected a quaternion of squared norm 1 to {tolerance:e}, found {norm_squared}")
            }
        }
    }
}

impl core::error::Error for NotRigid {}

/// Whether a matrix, given by columns, is that of a rigid motion.
fn check_matrix(columns: [[f64; 4]; 4], tolerance: f64) -> Result<(), NotRigid> {
    if !columns.iter().flatten().all(|entry| entry.is_finite()) {
        return Err(NotRigid::NotFinite);
    }
    let found = columns.map(|column| column[3]);
    if found.iter().zip([0.0, 0.0, 0.0, 1.0]).any(|(entry, expected)| (entry - expected).abs() > tolerance) {
        return Err(NotRigid::LastRow { found, tolerance });
    }
    let [x, y, z, _] = columns.map(|[x, y, z, _]| Direction::new(x, y, z));
    let products = [x.dot(x) - 1.0, y.dot(y) - 1.0, z.dot(z) - 1.0, y.dot(z), z.dot(x), x.dot(y)];
    let deviation = products.iter().fold(0.0_f64, |largest, product| largest.max(product.abs()));
    if deviation > tolerance {
        return Err(NotRigid::NotOrthonormal { deviation, tolerance });
    }
    let determinant = x.cross(y).dot(z);
    if determinant < 0.0 { Err(NotRigid::Mirror { determinant }) } else { Ok(()) }
}

/// Whether a quaternion is of norm 1.
fn check_quaternion(quaternion: [f64; 4], tolerance: f64) -> Result<(), NotRigid> {
    if !quaternion.iter().all(|coefficient| coefficient.is_finite()) {
        return Err(NotRigid::NotFinite);
    }
    let norm_squared: f64 = quaternion.iter().map(|coefficient| coefficient * coefficient).sum();
    let unit = (norm_squared - 1.0).abs() <= tolerance;
    if unit { Ok(()) } else { Err(NotRigid::NotUnit { norm_squared, tolerance }) }
}

macro_rules! convert_vectors {
    ($($ours:ty, [$($field:ident),*] <=> $glam:ident;)*) => {
        $(
            impl From<$ours> for $glam {
                #[inline]
                fn from(value: $ours) -> Self {
                    Self::new($(value.$field),*)
                }
            }

            impl From<$glam> for $ours {
                #[inline]
                fn from(value: $glam) -> Self {
                    Self::new($(value.$field),*)
                }
            }
        )*
    };
}

convert_vectors! {
    Point<f32>, [x, y, z] <=> Vec3;
    Point<f32>, [x, y, z] <=> Vec3A;
    Point<f64>, [x, y, z] <=> DVec3;
    Direction<f32>, [x, y, z] <=> Vec3;
    Direction<f32>, [x, y, z] <=> Vec3A;
    Direction<f64>, [x, y, z] <=> DVec3;
    pga2d::Point<f32>, [x, y] <=> Vec2;
    pga2d::Point<f64>, [x, y] <=> DVec2;
    pga2d::Direction<f32>, [x, y] <=> Vec2;
    pga2d::Direction<f64>, [x, y] <=> DVec2;
}

macro_rules! convert_rotors {
    ($float:ident, $quaternion:ident, $vector:ident, $tolerance:ident) => {
        impl From<Rotor<$float>> for $quaternion {
            #[inline]
            fn from(rotor: Rotor<$float>) -> Self {
                Self::from_array(rotor.to_quaternion_xyzw())
            }
        }

        impl TryFrom<$quaternion> for Rotor<$float> {
            type Error = NotRigid;

            /// The rotor of a unit quaternion; it is normalised.
            fn try_from(quaternion: $quaternion) -> Result<Self, NotRigid> {
                check_quaternion(quaternion.to_array().map(f64::from), $tolerance)?;
                Self::from_quaternion_xyzw(quaternion.to_array()).ok_or(NotRigid::NotFinite)
            }
        }

        impl From<Motor<$float>> for ($quaternion, $vector) {
            /// The rotation, and the translation that follows it.
            #[inline]
            fn from(motor: Motor<$float>) -> Self {
                (motor.rotor().into(), motor.translator().vector().into())
            }
        }

        impl TryFrom<($quaternion, $vector)> for Motor<$float> {
            type Error = NotRigid;

            /// The rotation of a unit quaternion followed by the translation.
            fn try_from((quaternion, vector): ($quaternion, $vector)) -> Result<Self, NotRigid> {
                if !vector.is_finite() {
                    return Err(NotRigid::NotFinite);
                }
                let translator = Translator::from_vector(vector.into());
                Ok(Self::from_rotor_translator(quaternion.try_into()?, translator))
            }
        }
    };
}

convert_rotors!(f32, Quat, Vec3, TOLERANCE_F32);
convert_rotors!(f64, DQuat, DVec3, TOLERANCE_F64);

macro_rules! convert_matrices {
    ($float:ident, $matrix:ident, $affine:ident, $rotation:ident, $quaternion:ident, $tolerance:ident) => {
        impl From<Motor<$float>> for $matrix {
            /// The matrix of the motion; its columns are where the axes' directions and the origin go.
            fn from(motor: Motor<$float>) -> Self {
                Self::from_cols_array_2d(&motor.to_matrix().to_columns())
            }
        }

        impl From<Motor<$float>> for $affine {
            /// The matrix of the motion; its columns are where the axes' directions and the origin go.
            fn from(motor: Motor<$float>) -> Self {
                Self::from_cols_array_2d(&motor.to_matrix().to_columns().map(|[x, y, z, _]| [x, y, z]))
            }
        }

        impl TryFrom<$matrix> for Motor<$float> {
            type Error = NotRigid;

            /// The motion of a rigid matrix.
            fn try_from(matrix: $matrix) -> Result<Self, NotRigid> {
                let columns = matrix.to_cols_array_2d();
                check_matrix(columns.map(|column| column.map(f64::from)), $tolerance)?;
                let [x, y, z, origin] = columns.map(|[x, y, z, _]| [x, y, z]);
                let quaternion = $quaternion::from_mat3(&$rotation::from_cols_array_2d(&[x, y, z]));
                let rotor = Rotor::from_quaternion_xyzw(quaternion.to_array()).ok_or(NotRigid::NotFinite)?;
                Ok(Self::from_rotor_translator(rotor, Translator::from_vector(origin.into())))
            }
        }

        impl TryFrom<$affine> for Motor<$float> {
            type Error = NotRigid;

            /// The motion of a rigid affine map.
            fn try_from(affine: $affine) -> Result<Self, NotRigid> {
                $matrix::from(affine).try_into()
            }
        }
    };
}

convert_matrices!(f32, Mat4, Affine3A, Mat3, Quat, TOLERANCE_F32);
convert_matrices!(f64, DMat4, DAffine3, DMat3, DQuat, TOLERANCE_F64);
