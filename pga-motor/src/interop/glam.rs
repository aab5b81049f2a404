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
//! `Mat4::from(b) * Mat4::from(a)`. m and -m give the same matrix; back comes the one whose scalar part is not
//! negative.
//!
//! A matrix is a motor only if it is rigid, and a quaternion is a rotor only if it is unit: to [`TOLERANCE_F32`] or
//! [`TOLERANCE_F64`], so that what has gathered rounding errors passes and scales, shears and mirrors do not. What
//! passes is made exactly unit. Otherwise [`NotRigid`] tells what was found, and where.
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

pub use crate::rigid::{NotRigid, TOLERANCE_F32, TOLERANCE_F64};

use crate::rigid::{check_finite, rotor_from_unit_quaternion};
use crate::{Direction, Motor, Point, Rotor, Translator, pga2d};
use ::glam::{Affine3A, DAffine3, DMat4, DQuat, DVec2, DVec3, Mat4, Quat, Vec2, Vec3, Vec3A};

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
    ($float:ident, $quaternion:ident, $vector:ident) => {
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
                rotor_from_unit_quaternion(quaternion.to_array())
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
                let rotor = quaternion.try_into()?;
                check_finite(1, &vector.to_array().map(f64::from))?;
                Ok(Self::from_rotor_translator(rotor, Translator::from_vector(vector.into())))
            }
        }
    };
}

convert_rotors!(f32, Quat, Vec3);
convert_rotors!(f64, DQuat, DVec3);

macro_rules! convert_matrices {
    ($float:ident, $matrix:ident, $affine:ident) => {
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
                Self::from_columns(matrix.to_cols_array_2d())
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

convert_matrices!(f32, Mat4, Affine3A);
convert_matrices!(f64, DMat4, DAffine3);
