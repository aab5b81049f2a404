//! Motors beside glam and nalgebra, in double precision: that points, directions, planes and lines go where the
//! matrices, quaternions and isometries of others take them, and that motions compose, turn back and interpolate as
//! theirs do.
//!
//! Both sides get the same numbers, coordinates up to 10 and unit quaternions in every direction.
//! `pga-motor/tests/glam.rs` has the conversions.

#[path = "differential/exact.rs"]
#[allow(dead_code, unused_macros)]
mod exact;
#[path = "differential/samples.rs"]
#[allow(dead_code)]
mod samples;

use glam::{DAffine2, DMat4, DQuat, DVec2, DVec3, DVec4};
use nalgebra::{
    DualQuaternion, Isometry2, Isometry3, Matrix3, Point2, Point3, Quaternion, Translation3, UnitComplex,
    UnitDualQuaternion, UnitQuaternion, Vector2, Vector3,
};
use pga_motor::f64::{Direction, Line, Motor, Plane, Point, Rotor};
use pga_motor::pga2d;
use samples::Random;

const SAMPLES: usize = 2000;

/// One rounding of a number up to 1: u = 2^-53, and EPSILON is 2 u.
const U: f64 = f64::EPSILON / 2.0;

/// A coefficient of a unit quaternion is off by at most 4 u, from its normalisation on either side. What is of second
/// degree in these, an entry of a rotation's matrix, sums four products of two, each off by 8 u and its own rounding:
/// 40 u.
const ENTRY: f64 = 40.0 * U;

/// A moved coordinate is three entries times coordinates up to 10, and a translation up to 10: 3 * 10 ENTRY, and four
/// roundings of sums up to 40. For both sides.
const MOVED: f64 = 2.0 * (30.0 * ENTRY + 160.0 * U);

/// The same behind two motions, the second on coordinates up to 3 * 10 + 10.
const MOVED_TWICE: f64 = 2.0 * (3.0 * 40.0 * ENTRY + 3.0 * MOVED + 640.0 * U);

/// A moment is a difference of two products of moved coordinates up to 28 (a vector up to 10 sqrt 3 turned, and 10
/// added), each off by 28 * 2 MOVED / 2 on one side, and some roundings of numbers up to 1600. On our side it is a sum
/// of that size too, of coefficients that are as exact.
const MOMENT: f64 = 4.0 * (28.0 * MOVED + 8.0 * 1600.0 * U);

/// The arc cosine of a c off by 8 u, with |c| at most 0.9 and so a sine of at least 0.43, is off by 19 u; weights
/// sin(t h)/sin h, at most 2.3, by (19 u + 2.3 * 19 u)/0.43 and a few roundings: 160 u. Two of them, with coefficients up to
/// 1 that are off by 4 u, on both sides.
const GREAT_ARC: f64 = 2.0 * 2.0 * (160.0 + 2.3 * 4.0) * U;

/// The largest cosine of half the angle between two motions for [`GREAT_ARC`].
const LARGEST_COSINE: f64 = 0.9;

fn vector(random: &mut Random) -> DVec3 {
    DVec3::new(random.float(), random.float(), random.float()) * 10.0
}

/// A unit quaternion in a random direction.
fn quaternion(random: &mut Random) -> DQuat {
    loop {
        let [x, y, z, w] = std::array::from_fn(|_| random.float());
        let quaternion = DQuat::from_xyzw(x, y, z, w);
        if (0.1..1.0).contains(&quaternion.length()) {
            return quaternion.normalize();
        }
    }
}

/// One motion in all three libraries: first the rotation, then the translation.
struct Motion {
    motor: Motor,
    rotation: DQuat,
    translation: DVec3,
    matrix: DMat4,
    isometry: Isometry3<f64>,
}

fn theirs(quaternion: DQuat) -> UnitQuaternion<f64> {
    UnitQuaternion::new_unchecked(Quaternion::new(quaternion.w, quaternion.x, quaternion.y, quaternion.z))
}

fn motion(random: &mut Random) -> Motion {
    let (rotation, translation) = (quaternion(random), vector(random));
    Motion {
        motor: Motor::try_from((rotation, translation)).expect("a unit quaternion"),
        rotation,
        translation,
        matrix: DMat4::from_rotation_translation(rotation, translation),
        isometry: Isometry3::from_parts(Translation3::from(column(translation)), theirs(rotation)),
    }
}

fn column(vector: DVec3) -> Vector3<f64> {
    Vector3::new(vector.x, vector.y, vector.z)
}

fn row(vector: Vector3<f64>) -> DVec3 {
    DVec3::new(vector.x, vector.y, vector.z)
}

/// Runs a check on many random motions, and says how near the two sides came.
fn check(claim: &str, tolerance: f64, mut distance: impl FnMut(&mut Random) -> f64) {
    let mut random = Random(claim.len() as u64);
    let mut worst = 0.0_f64;
    for sample in 0..SAMPLES {
        let distance = distance(&mut random);
        assert!(distance <= tolerance, "{claim}, sample {sample}: off by {distance:e} > {tolerance:e}");
        worst = worst.max(distance);
    }
    println!("{claim}: {SAMPLES} samples, off by at most {worst:.1e}, allowed {tolerance:.1e}");
}

/// The largest difference of two rows of numbers; NaN counts as infinite.
fn difference<const N: usize>(a: [f64; N], b: [f64; N]) -> f64 {
    let differences = a.iter().zip(&b).map(|(a, b)| (a - b).abs());
    differences.fold(0.0, |worst, each| if each.is_nan() { f64::INFINITY } else { worst.max(each) })
}

fn apart(found: impl Into<DVec3>, expected: DVec3) -> f64 {
    difference(found.into().to_array(), expected.to_array())
}

/// The coefficients that the line through two points should have: its direction and its moment about the origin.
fn line_through(a: DVec3, b: DVec3) -> [f64; 6] {
    let (direction, moment) = (b - a, a.cross(b));
    [direction.x, direction.y, direction.z, moment.x, moment.y, moment.z]
}

#[test]
fn points_and_directions_go_where_matrices_and_isometries_take_them() {
    check("points", MOVED, |random| {
        let (motion, point) = (motion(random), vector(random));
        let moved = DVec3::from(motion.motor.transform_point(point.into()));
        let isometric = motion.isometry * Point3::from(column(point));
        apart(moved, motion.matrix.transform_point3(point)).max(apart(moved, row(isometric.coords)))
    });
    check("directions", MOVED, |random| {
        let (motion, direction) = (motion(random), vector(random));
        let moved = DVec3::from(motion.motor.transform_direction(direction.into()));
        let isometric = motion.isometry * column(direction);
        apart(moved, motion.matrix.transform_vector3(direction)).max(apart(moved, row(isometric)))
    });
}

#[test]
fn lines_go_where_their_points_go() {
    check("lines", MOMENT, |random| {
        let (motion, a, b) = (motion(random), vector(random), vector(random));
        let moved = motion.motor.transform_line(Point::from(a) & Point::from(b)).to_array();
        let by_matrix = line_through(motion.matrix.transform_point3(a), motion.matrix.transform_point3(b));
        let isometric = [a, b].map(|point| row((motion.isometry * Point3::from(column(point))).coords));
        difference(moved, by_matrix).max(difference(moved, line_through(isometric[0], isometric[1])))
    });
}

#[test]
fn planes_go_by_the_inverse_transpose() {
    // The last coefficient is that of the plane, minus the moved normal, up to 18, times the translation: three
    // products of coordinates up to 10 and 18, the latter off by MOVED. glam's inverse has entries up to 30 that are
    // off by a moved coordinate, and is multiplied with a normal up to 10.
    check("planes", 2.0 * 3.0 * 10.0 * MOVED, |random| {
        let (motion, normal, offset) = (motion(random), vector(random), 10.0 * random.float());
        let moved = motion.motor.transform_plane(Plane::new(normal.x, normal.y, normal.z, offset)).to_array();
        let by_matrix = motion.matrix.inverse().transpose() * DVec4::new(normal.x, normal.y, normal.z, offset);
        let homogeneous = motion.isometry.inverse().to_homogeneous().transpose();
        let isometric = homogeneous * nalgebra::Vector4::new(normal.x, normal.y, normal.z, offset);
        difference(moved, by_matrix.to_array()).max(difference(moved, isometric.into()))
    });
}

#[test]
fn planes_meet_where_their_equations_are_solved() {
    // Cramer's rule with normals up to 1 and offsets up to 10: numerators up to 60 over a determinant of at least 0.3.
    // Either side errs by some 10 u in a term, so by 60 * 10 u / 0.3 and, through the determinant of 6 terms up to 1,
    // 60 * 60 u / 0.3^2; elimination with pivoting grows entries up to 4 times, and solves with what it has rounded.
    let tolerance = 2.0 * 4.0 * (60.0 * 10.0 / 0.3 + 60.0 * 60.0 / 0.09) * U;
    check("meets of planes", tolerance, |random| {
        let (normals, offsets) = loop {
            let normals = Matrix3::from_fn(|_, _| random.float());
            if normals.determinant().abs() > 0.3 {
                break (normals, Vector3::from_fn(|_, _| 10.0 * random.float()));
            }
        };
        let plane = |i: usize| Plane::new(normals[(i, 0)], normals[(i, 1)], normals[(i, 2)], offsets[i]);
        let point = (plane(0) ^ plane(1) ^ plane(2)).to_point().expect("a determinant other than 0");
        apart(point, row(normals.lu().solve(&-offsets).expect("a determinant other than 0")))
    });
}

#[test]
fn motions_compose_as_isometries_and_matrices() {
    check("products", MOVED_TWICE, |random| {
        let (a, b, point) = (motion(random), motion(random), vector(random));
        let moved = DVec3::from((b.motor * a.motor).transform_point(point.into()));
        let isometric = (b.isometry * a.isometry) * Point3::from(column(point));
        apart(moved, (b.matrix * a.matrix).transform_point3(point)).max(apart(moved, row(isometric.coords)))
    });
    // Four products of coefficients up to 1, off by 4 u each, and the roundings, on either side.
    check("products of rotors", 2.0 * 4.0 * 10.0 * U, |random| {
        let (a, b) = (quaternion(random), quaternion(random));
        let rotor = |quaternion: DQuat| Rotor::try_from(quaternion).expect("a unit quaternion");
        let product = (rotor(b) * rotor(a)).to_quaternion_xyzw();
        let isometric: [f64; 4] = (theirs(b) * theirs(a)).coords.into();
        difference(product, (b * a).to_array()).max(difference(product, isometric))
    });
}

#[test]
fn inverses_turn_back_as_theirs_do() {
    // The inverse takes back the translation before it turns: as two motions.
    check("inverses", MOVED_TWICE, |random| {
        let (motion, point) = (motion(random), vector(random));
        let moved = DVec3::from(motion.motor.inverse().transform_point(point.into()));
        let isometric = motion.isometry.inverse_transform_point(&Point3::from(column(point)));
        apart(moved, motion.matrix.inverse().transform_point3(point)).max(apart(moved, row(isometric.coords)))
    });
}

#[test]
fn quaternions_come_in_and_go_out() {
    check("quaternions", 2.0 * 4.0 * U, |random| {
        let quaternion = quaternion(random);
        let rotor = Rotor::from_quaternion_xyzw(quaternion.to_array()).expect("a unit quaternion");
        difference(rotor.to_quaternion_xyzw(), theirs(quaternion).coords.into())
    });
    // Angles up to pi, at axes off by 4 u: the half-angle is off by 8 u, and a few roundings.
    check("axes and angles", 2.0 * 20.0 * U, |random| {
        let (axis, angle) = (quaternion(random).xyz().normalize(), 3.0 * random.float());
        let rotor = Rotor::from_axis_angle(axis.into(), angle).expect("a unit axis").to_quaternion_xyzw();
        let unit = nalgebra::Unit::new_unchecked(column(axis));
        let isometric: [f64; 4] = UnitQuaternion::from_axis_angle(&unit, angle).coords.into();
        difference(rotor, DQuat::from_axis_angle(axis, angle).to_array()).max(difference(rotor, isometric))
    });
}

#[test]
fn exponentials_and_logarithms_are_scaled_axes() {
    // A turn by the vector w, the axis times the angle, is exp(-w/2). Up to pi long, off by some 10 u relatively.
    let tolerance = 2.0 * 10.0 * 4.0 * U;
    check("exponentials", tolerance, |random| {
        let w = vector(random) * 0.18;
        let rotor = Line::new(-w.x / 2.0, -w.y / 2.0, -w.z / 2.0, 0.0, 0.0, 0.0).exp().rotor();
        let isometric: [f64; 4] = UnitQuaternion::from_scaled_axis(column(w)).coords.into();
        let glam = DQuat::from_scaled_axis(w).to_array();
        difference(rotor.to_quaternion_xyzw(), isometric).max(difference(rotor.to_quaternion_xyzw(), glam))
    });
    check("logarithms", tolerance, |random| {
        let rotation = quaternion(random);
        let log = Motor::from(Rotor::try_from(rotation).expect("a unit quaternion")).log();
        let expected = theirs(rotation).scaled_axis();
        difference([log.e23, log.e31, log.e12].map(|x| -2.0 * x), expected.into())
    });
}

/// Two motions whose cosine of half the angle between them is at most [`LARGEST_COSINE`], and a time.
fn ends(random: &mut Random) -> (Motion, Motion, f64) {
    loop {
        let (a, b) = (motion(random), motion(random));
        // Near a half turn apart, rounding decides which way is the short one.
        if (1e-6..LARGEST_COSINE).contains(&a.rotation.dot(b.rotation).abs()) {
            return (a, b, (random.float() + 1.0) / 2.0);
        }
    }
}

/// Unit quaternions up to sign.
fn turned_apart(found: Rotor, expected: DQuat) -> f64 {
    let found = found.to_quaternion_xyzw();
    difference(found, expected.to_array()).min(difference(found, (-expected).to_array()))
}

#[test]
fn slerp_and_nlerp_of_rotors_are_those_of_quaternions() {
    check("slerp", GREAT_ARC, |random| {
        let (a, b, t) = ends(random);
        let found = Motor::from(a.motor.rotor()).slerp(b.motor.rotor().into(), t).rotor();
        let isometric = theirs(a.rotation).slerp(&theirs(b.rotation), t).coords;
        let isometric = DQuat::from_xyzw(isometric.x, isometric.y, isometric.z, isometric.w);
        turned_apart(found, a.rotation.slerp(b.rotation, t)).max(turned_apart(found, isometric))
    });
    // The sum is at least 1/sqrt 2 long, as the ends are at most a right angle apart; off by 8 u, and so is its norm.
    check("nlerp", 2.0 * 2.0 * 8.0 * 2.0 * U, |random| {
        let (a, b, t) = ends(random);
        let found = Motor::from(a.motor.rotor()).nlerp(b.motor.rotor().into(), t).rotor();
        turned_apart(found, a.rotation.lerp(b.rotation, t))
    });
}

#[test]
fn split_lerp_is_the_lerp_and_slerp_of_isometries() {
    // Coefficients off by GREAT_ARC where ENTRY allows for 4 u each: an entry is off by 8 times that.
    check("split_lerp", 3.0 * 10.0 * 8.0 * GREAT_ARC + MOVED, |random| {
        let (a, b, t) = ends(random);
        let point = vector(random);
        let moved = DVec3::from(a.motor.split_lerp(b.motor, t).transform_point(point.into()));
        let isometric = a.isometry.lerp_slerp(&b.isometry, t) * Point3::from(column(point));
        let glam = a.rotation.slerp(b.rotation, t) * point + a.translation.lerp(b.translation, t);
        apart(moved, row(isometric.coords)).max(apart(moved, glam))
    });
}

#[test]
fn screw_lerp_is_the_interpolation_of_dual_quaternions() {
    fn dual_quaternion(motion: &Motion) -> UnitDualQuaternion<f64> {
        let rotation = theirs(motion.rotation);
        let vector = Quaternion::from_imag(column(motion.translation));
        let dual = (vector * rotation.quaternion()) * 0.5;
        UnitDualQuaternion::new_unchecked(DualQuaternion::from_real_and_dual(*rotation.quaternion(), dual))
    }
    // The screw from a to b moves by up to 40, so its ideal part is up to 20, off by 20 * 8 u. Its pitch and moment
    // come from that over the sine, at least 0.43, twice, and through an angle off by 19 u: 20 * (8 + 2 * 19)/0.43^2 u.
    // They are multiplied with a, whose translation is up to 10, and doubled as a moved point is; the turn as in
    // GREAT_ARC.
    let tolerance = 2.0 * 2.0 * 4.0 * 20.0 * (8.0 + 38.0) / (0.43 * 0.43) * U + 3.0 * 40.0 * 8.0 * GREAT_ARC + MOVED;
    check("screw_lerp", tolerance, |random| {
        let (a, b, t) = ends(random);
        let point = vector(random);
        let moved = DVec3::from(a.motor.screw_lerp(b.motor, t).transform_point(point.into()));
        let screw = dual_quaternion(&a).sclerp(&dual_quaternion(&b), t);
        apart(moved, row((screw * Point3::from(column(point))).coords))
    });
}

mod plane {
    use super::*;

    /// One motion of the plane in all three libraries.
    fn motion(random: &mut Random) -> (pga2d::f64::Motor, DAffine2, Isometry2<f64>) {
        let (angle, vector) = (3.0 * random.float(), place(random));
        let rotor = pga2d::f64::Rotor::from_angle(angle);
        let translator = pga2d::f64::Translator::from_vector(vector.into());
        let isometry = Isometry2::new(Vector2::new(vector.x, vector.y), angle);
        let motor = pga2d::f64::Motor::from_rotor_translator(rotor, translator);
        (motor, DAffine2::from_angle_translation(angle, vector), isometry)
    }

    fn place(random: &mut Random) -> DVec2 {
        DVec2::new(random.float(), random.float()) * 10.0
    }

    fn moved(isometry: Isometry2<f64>, point: DVec2) -> DVec2 {
        let moved = isometry * Point2::new(point.x, point.y);
        DVec2::new(moved.x, moved.y)
    }

    fn apart(found: impl Into<DVec2>, expected: DVec2) -> f64 {
        difference(found.into().to_array(), expected.to_array())
    }

    #[test]
    fn points_and_products_go_where_matrices_and_isometries_take_them() {
        // The bounds of space hold: there are fewer terms.
        check("points of the plane", MOVED, |random| {
            let ((motor, matrix, isometry), point) = (motion(random), place(random));
            let found = DVec2::from(motor.transform_point(point.into()));
            apart(found, matrix.transform_point2(point)).max(apart(found, self::moved(isometry, point)))
        });
        check("products of the plane", MOVED_TWICE, |random| {
            let (a, b, point) = (motion(random), motion(random), place(random));
            let found = DVec2::from((b.0 * a.0).transform_point(point.into()));
            apart(found, (b.1 * a.1).transform_point2(point)).max(apart(found, self::moved(b.2 * a.2, point)))
        });
        check("inverses of the plane", MOVED_TWICE, |random| {
            let ((motor, matrix, isometry), point) = (motion(random), place(random));
            let found = DVec2::from(motor.inverse().transform_point(point.into()));
            apart(found, matrix.inverse().transform_point2(point))
                .max(apart(found, self::moved(isometry.inverse(), point)))
        });
    }

    #[test]
    fn lines_go_where_their_points_go() {
        check("lines of the plane", MOMENT, |random| {
            let ((motor, matrix, isometry), a, b) = (motion(random), place(random), place(random));
            let line = pga2d::f64::Point::from(a) & pga2d::f64::Point::from(b);
            let found = motor.transform_line(line).to_array();
            // The line through a and b, to whose left its normal points.
            let through = |a: DVec2, b: DVec2| [a.y - b.y, b.x - a.x, a.perp_dot(b)];
            let by_matrix = through(matrix.transform_point2(a), matrix.transform_point2(b));
            difference(found, by_matrix)
                .max(difference(found, through(self::moved(isometry, a), self::moved(isometry, b))))
        });
    }

    #[test]
    fn slerp_of_rotors_is_that_of_unit_complex_numbers() {
        // Angles up to 3, whose difference is off by some 8 u, and a moved point.
        check("slerp of the plane", 10.0 * 2.0 * 8.0 * U + MOVED, |random| {
            let (from, by) = (3.0 * random.float(), 3.0 * random.float());
            let (t, point) = ((random.float() + 1.0) / 2.0, place(random));
            let rotor = |angle: f64| pga2d::f64::Motor::from(pga2d::f64::Rotor::from_angle(angle));
            let found = DVec2::from(rotor(from).slerp(rotor(from + by), t).transform_point(point.into()));
            let complex = UnitComplex::new(from).slerp(&UnitComplex::new(from + by), t);
            let expected = complex * Point2::new(point.x, point.y);
            apart(found, DVec2::new(expected.x, expected.y))
        });
    }
}

#[test]
fn directions_are_not_moved_by_translations() {
    check("translations of directions", 0.0, |random| {
        let (step, direction) = (vector(random), vector(random));
        let motor = Motor::try_from((DQuat::IDENTITY, step)).expect("a unit quaternion");
        apart(DVec3::from(motor.transform_direction(Direction::from(direction))), direction)
    });
}
