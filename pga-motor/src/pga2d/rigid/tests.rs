//! Matrices of motions of the plane, there and back, and those that are refused.
//!
//! Tolerance: an entry of a matrix is off by at most 4 EPSILON, what comes of it by as much again and the roundings of
//! a root and two products; with translations up to 10, 16 * 10 EPSILON.

use super::*;
use crate::pga2d::Point;
use core::f64::consts::PI;

#[test]
fn matrices_give_their_motion_back_at_every_angle() {
    for angle in [0.0, 1e-20, 1e-8, 0.3, 1.5, PI / 2.0, 1.6, 3.0, PI - 1e-8, PI, PI + 1e-8, 4.0, -1e-9] {
        let motor = Motor::about(Point::new(3.0, -4.0), angle);
        let back = Motor::from_columns(motor.to_columns()).unwrap();
        let off = [back - motor, back + motor].map(|sum| sum.norm() + sum.ideal_norm());
        assert!(off[0].min(off[1]) <= 160.0 * f64::EPSILON, "{motor}, {back}");
        assert!(back.s >= 0.0 && back.is_unit(4.0 * f64::EPSILON));
        let point = Point::new(2.0, 5.0);
        let [x, y, origin] = motor.to_columns();
        let by_matrix = [0, 1].map(|row| x[row] * point.x + y[row] * point.y + origin[row]);
        assert!(motor.transform_point(point).distance_to_point(by_matrix.into()) <= 160.0 * f64::EPSILON);
    }
}

#[test]
fn small_turns_keep_their_digits_and_half_turns_are_exact() {
    let small = Motor::from(Rotor::from_angle(1e-20));
    let back = Motor::from_columns(small.to_columns()).unwrap();
    assert!((back.e12 / small.e12 - 1.0).abs() <= 4.0 * f64::EPSILON);
    let half_turn = [[-1.0_f32, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]];
    assert_eq!(Motor::from_columns(half_turn), Ok(Motor::new(0.0, -1.0, 0.0, 0.0)));
}

#[test]
fn what_is_not_rigid_is_named_with_its_place() {
    let tolerance = rigid::TOLERANCE_F64;
    let refused = |columns: [[f64; 3]; 3]| Motor::from_columns(columns).unwrap_err();
    let (x, y, origin) = ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [5.0, 6.0, 1.0]);
    assert_eq!(refused([x, [0.0, f64::NAN, 0.0], origin]), NotRigid::NotFinite { column: 1, row: 1 });
    let last_row = NotRigid::LastRow { column: 2, found: 2.0, expected: 1.0, tolerance };
    assert_eq!(refused([x, y, [5.0, 6.0, 2.0]]), last_row);
    assert_eq!(refused([x, [0.0, 2.0, 0.0], origin]), NotRigid::Scaled { column: 1, length_squared: 4.0, tolerance });
    let sheared = NotRigid::Sheared { columns: [0, 1], product: 0.6, tolerance };
    assert_eq!(refused([x, [0.6, 0.8, 0.0], origin]), sheared);
    assert_eq!(refused([y, x, origin]), NotRigid::Mirror { determinant: -1.0 });
}
