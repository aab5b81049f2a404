//! Conversions to and from glam, and agreement about which way is which.
#![cfg(feature = "glam")]

use glam::{Affine3A, DAffine3, DMat4, DQuat, DVec2, DVec3, Mat4, Quat, Vec3, Vec3A, Vec4};
use pga_motor::f64::{Direction, Motor, Point, Rotor, Translator};
use pga_motor::interop::glam::{NotRigid, TOLERANCE_F32, TOLERANCE_F64};
use std::f64::consts::PI;

/// Points and translations here are up to 10 from the origin. A quaternion is off by a few EPSILON, an entry of its
/// matrix by 4 times as much; that times 10, added over 3 columns and a translation, on either side: 2 * 4 * 3 * 10
/// EPSILON and the few roundings of the sum itself.
const ROUNDING: f64 = 300.0 * f64::EPSILON;

fn axes() -> [DVec3; 5] {
    [DVec3::X, DVec3::Y, DVec3::Z, DVec3::new(1.0, 2.0, -2.0) / 3.0, DVec3::new(-0.48, 0.6, 0.64)]
}

const ANGLES: [f64; 8] = [0.0, 1e-9, 0.3, 1.5, 3.0, PI, -0.7, -2.9];

/// The same motions in glam and here.
fn motions() -> Vec<(DQuat, DVec3, Motor)> {
    let vector = DVec3::new(1.0, -7.0, 4.0);
    let mut motions = Vec::new();
    for axis in axes() {
        for angle in ANGLES {
            let rotor = Rotor::from_axis_angle(axis.into(), angle).unwrap();
            let motor = Motor::from_rotor_translator(rotor, Translator::from_vector(vector.into()));
            motions.push((DQuat::from_axis_angle(axis, angle), vector, motor));
        }
    }
    motions
}

fn assert_near(found: DVec3, expected: DVec3) {
    assert!((found - expected).length() <= ROUNDING, "expected {expected}, found {found}");
}

/// Equal up to the sign, which is all that a motion tells.
fn assert_same_motion(found: Motor, expected: Motor) {
    let distance = |a: Motor| (a - expected).norm() + (a - expected).ideal_norm();
    assert!(distance(found).min(distance(-found)) <= ROUNDING, "expected {expected}, found {found}");
}

#[test]
fn motions_agree_with_glam() {
    let point = DVec3::new(3.0, 5.0, -2.0);
    for (quaternion, vector, motor) in motions() {
        let matrix = DMat4::from_rotation_translation(quaternion, vector);
        assert_near(motor.transform_point(point.into()).into(), matrix.transform_point3(point));
        assert_near(motor.transform_direction(point.into()).into(), matrix.transform_vector3(point));
        assert!(DMat4::from(motor).abs_diff_eq(matrix, ROUNDING));
        assert!(DAffine3::from(motor).abs_diff_eq(DAffine3::from_mat4(matrix), ROUNDING));
        let (turn, step) = motor.into();
        assert!(turn.abs_diff_eq(quaternion, ROUNDING));
        assert_near(step, vector);
        assert_near(motor.inverse().transform_point(point.into()).into(), matrix.inverse().transform_point3(point));
    }
}

#[test]
fn turns_about_the_axes_agree_with_glam() {
    for angle in ANGLES {
        assert!(DQuat::from(Rotor::about_x(angle)).abs_diff_eq(DQuat::from_rotation_x(angle), ROUNDING));
        assert!(DQuat::from(Rotor::about_y(angle)).abs_diff_eq(DQuat::from_rotation_y(angle), ROUNDING));
        assert!(DQuat::from(Rotor::about_z(angle)).abs_diff_eq(DQuat::from_rotation_z(angle), ROUNDING));
    }
}

#[test]
fn products_agree_with_glam() {
    for (_, _, a) in motions() {
        for (_, _, b) in motions() {
            // Entries up to 20 here, twice what the constant allows for.
            assert!(DMat4::from(b * a).abs_diff_eq(DMat4::from(b) * DMat4::from(a), 2.0 * ROUNDING));
        }
    }
}

#[test]
fn motors_come_back() {
    for (quaternion, vector, motor) in motions() {
        assert_same_motion(DMat4::from(motor).try_into().unwrap(), motor);
        assert_same_motion(DAffine3::from(motor).try_into().unwrap(), motor);
        assert_same_motion((quaternion, vector).try_into().unwrap(), motor);
        let rotor = Rotor::try_from(DQuat::from(motor.rotor())).unwrap();
        assert_same_motion(rotor.into(), motor.rotor().into());
    }
}

#[test]
fn single_precision_comes_back() {
    let tolerance = 300.0 * f32::EPSILON;
    for (_, _, motor) in motions() {
        let motor = motor.map(|coefficient| coefficient as f32);
        let pair = <(Quat, Vec3)>::from(motor);
        for back in [Mat4::from(motor).try_into(), Affine3A::from(motor).try_into(), pair.try_into()] {
            let back: pga_motor::f32::Motor = back.unwrap();
            let distance = |a: pga_motor::f32::Motor| (a - motor).norm() + (a - motor).ideal_norm();
            assert!(distance(back).min(distance(-back)) <= tolerance);
        }
    }
}

#[test]
fn vectors_convert_both_ways() {
    assert_eq!(DVec3::from(Point::new(1.0, 2.0, 3.0)), DVec3::new(1.0, 2.0, 3.0));
    assert_eq!(Point::from(DVec3::new(1.0, 2.0, 3.0)), Point::new(1.0, 2.0, 3.0));
    assert_eq!(Direction::from(DVec3::X), Direction::X);
    let point = pga_motor::f32::Point::new(1.0, 2.0, 3.0);
    assert_eq!(pga_motor::f32::Point::from(Vec3A::from(point)), point);
    assert_eq!(pga_motor::f32::Point::from(Vec3::from(point)), point);
    let point = pga_motor::pga2d::f64::Point::new(1.0, 2.0);
    assert_eq!(DVec2::from(point), DVec2::new(1.0, 2.0));
    assert_eq!(pga_motor::pga2d::f64::Point::from(DVec2::from(point)), point);
}

#[test]
fn rounding_in_a_matrix_is_forgiven() {
    let exact = Mat4::from_rotation_y(0.7);
    let rough = exact * (1.0 + 1e-5);
    let motor = pga_motor::f32::Motor::try_from(rough).unwrap();
    assert!(motor.is_unit(4.0 * f32::EPSILON));
    // What was single precision is a motion in double precision too.
    assert!(Motor::try_from(exact.as_dmat4()).is_ok());
}

#[test]
fn matrices_that_are_not_rigid_are_refused() {
    let refused = |matrix: Mat4| pga_motor::f32::Motor::try_from(matrix).unwrap_err();

    let tolerance = TOLERANCE_F32;
    let scaled = refused(Mat4::from_scale(Vec3::splat(2.0)));
    assert_eq!(scaled, NotRigid::Scaled { column: 0, length_squared: 4.0, tolerance });
    assert_eq!(scaled.to_string(), "column 0: expected an axis of squared length 1 within 1e-4, found 4");

    let sheared = Mat4::from_cols(Vec4::X, Vec4::new(0.6, 0.8, 0.0, 0.0), Vec4::Z, Vec4::W);
    assert!(
        matches!(refused(sheared), NotRigid::Sheared { columns: [0, 1], product, .. } if (product - 0.6).abs() < 1e-6)
    );

    let mirror = refused(Mat4::from_scale(Vec3::new(1.0, 1.0, -1.0)));
    assert_eq!(mirror, NotRigid::Mirror { determinant: -1.0 });

    let projective = refused(Mat4::from_cols(Vec4::X, Vec4::Y, Vec4::NEG_Z - Vec4::W, Vec4::NEG_Z));
    assert_eq!(projective, NotRigid::LastRow { column: 2, found: -1.0, expected: 0.0, tolerance });

    let not_finite = NotRigid::NotFinite { column: 3, row: 1 };
    assert_eq!(refused(Mat4::from_translation(Vec3::new(0.0, f32::NAN, 0.0))), not_finite);
    assert_eq!(refused(Mat4::from_translation(Vec3::new(0.0, f32::INFINITY, 0.0))), not_finite);

    let affine = pga_motor::f32::Motor::try_from(Affine3A::from_scale(Vec3::splat(0.5))).unwrap_err();
    assert_eq!(affine, NotRigid::Scaled { column: 0, length_squared: 0.25, tolerance });
    let double = Motor::try_from(DMat4::from_scale(DVec3::splat(1.0 + 1e-5))).unwrap_err();
    assert!(matches!(double, NotRigid::Scaled { tolerance: TOLERANCE_F64, .. }));
    assert_eq!(
        Motor::try_from(DAffine3::from_scale(DVec3::new(-1.0, 1.0, 1.0))),
        Err(NotRigid::Mirror { determinant: -1.0 })
    );
}

#[test]
fn quaternions_that_are_not_unit_are_refused() {
    let refused = |quaternion: DQuat| Rotor::try_from(quaternion).unwrap_err();
    let long = refused(DQuat::from_xyzw(0.0, 0.0, 0.0, 2.0));
    assert_eq!(long, NotRigid::NotUnit { norm_squared: 4.0, tolerance: TOLERANCE_F64 });
    assert_eq!(long.to_string(), "expected a quaternion of squared norm 1 within 1e-6, found 4");
    assert_eq!(
        refused(DQuat::from_xyzw(0.0, 0.0, 0.0, 0.0)),
        NotRigid::NotUnit { norm_squared: 0.0, tolerance: TOLERANCE_F64 }
    );
    assert_eq!(refused(DQuat::from_xyzw(0.0, f64::NAN, 0.0, 1.0)), NotRigid::NotFinite { column: 0, row: 1 });
    let far = DVec3::new(0.0, 0.0, f64::INFINITY);
    assert_eq!(Motor::try_from((DQuat::IDENTITY, far)), Err(NotRigid::NotFinite { column: 1, row: 2 }));
    assert!(Motor::try_from((DQuat::from_xyzw(0.0, 0.0, 0.5, 0.5), DVec3::ZERO)).is_err());
}
