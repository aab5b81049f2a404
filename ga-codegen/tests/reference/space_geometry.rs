//! The geometry of space in Cl(3,0,1). Plane a x + b y + c z + d = 0: `a e1 + b e2 + c e3 + d e0`; point:
//! `e123 + x e032 + y e013 + z e021`. Rotations are right-handed and counter-clockwise, under X -> m X ~m.

use ga_codegen::reference::{Multivector, Number};

use crate::surd::{SQRT_3, Surd};
use crate::{PGA_3D, multivector};

fn point<T: Number>(x: T, y: T, z: T) -> Multivector<T> {
    &multivector(PGA_3D, [("e123", T::from(1))]) + &direction(x, y, z)
}

fn direction<T: Number>(x: T, y: T, z: T) -> Multivector<T> {
    multivector(PGA_3D, [("e032", x), ("e013", y), ("e021", z)])
}

fn plane<T: Number>(a: T, b: T, c: T, d: T) -> Multivector<T> {
    multivector(PGA_3D, [("e1", a), ("e2", b), ("e3", c), ("e0", d)])
}

fn surd(whole: i64) -> Surd {
    Surd { whole, root: 0 }
}

#[test]
fn a_normalised_point_squares_to_minus_one() {
    let p = point(3, -5, 7);
    assert_eq!(p.geometric(&p), Multivector::scalar(PGA_3D, -1));
}

#[test]
fn a_direction_squares_to_zero() {
    let v = direction(3, -5, 7);
    assert_eq!(v.geometric(&v), Multivector::zero(PGA_3D));
    assert_eq!(v.norm_squared(), 0);
    assert_eq!(v.ideal_norm_squared(), 9 + 25 + 49);
}

#[test]
fn join_of_two_points_is_the_line_through_both() {
    let join = point(1, 2, 3).regressive(&point(6, 5, 4));
    let expected = [("e23", 5), ("e31", 3), ("e12", 1), ("e01", -7), ("e02", 14), ("e03", -7)];
    assert_eq!(join, multivector(PGA_3D, expected));
    // The points (1, 2, 3) and (6, 5, 4), and the one as far beyond, lie on it; the origin does not.
    let zero = Multivector::zero(PGA_3D);
    assert_eq!(join.regressive(&point(1, 2, 3)), zero);
    assert_eq!(join.regressive(&point(6, 5, 4)), zero);
    assert_eq!(join.regressive(&point(11, 8, 5)), zero);
    assert_ne!(join.regressive(&point(0, 0, 0)), zero);
    assert_eq!(join.norm_squared(), 25 + 9 + 1);
}

#[test]
fn join_of_the_origin_and_a_point_on_an_axis_is_the_axis() {
    let origin = point(0, 0, 0);
    assert_eq!(origin.regressive(&point(1, 0, 0)), multivector(PGA_3D, [("e23", 1)]));
    assert_eq!(origin.regressive(&point(0, 1, 0)), multivector(PGA_3D, [("e31", 1)]));
    assert_eq!(origin.regressive(&point(0, 0, 1)), multivector(PGA_3D, [("e12", 1)]));
}

#[test]
fn planes_meet_in_their_common_line_and_point() {
    // x = 2, y = 3, z = 4.
    let (a, b, c) = (plane(1, 0, 0, -2), plane(0, 1, 0, -3), plane(0, 0, 1, -4));
    assert_eq!(a.outer(&b).outer(&c), point(2, 3, 4));
    // The line x = 2, y = 3 holds every (2, 3, z).
    assert_eq!(a.outer(&b).regressive(&point(2, 3, 99)), Multivector::zero(PGA_3D));
}

#[test]
fn join_of_three_points_is_the_plane_through_them() {
    let join = point(2, 0, 0).regressive(&point(0, 3, 0)).regressive(&point(0, 0, 6));
    // x/2 + y/3 + z/6 = 1, up to a factor.
    let expected = plane(3, 2, 1, -6);
    assert!([-6, 6].iter().any(|&factor| join == expected.scale(factor)), "{join}");
}

#[test]
fn product_of_points_is_minus_one_and_their_distance() {
    // From p to q it is (2, 3, 6), of length 7. All steps are exact in f64.
    let (p, q) = (point(1.0, 2.0, 3.0), point(3.0, 5.0, 9.0));
    let expected = multivector(PGA_3D, [("1", -1.0), ("e01", -2.0), ("e02", -3.0), ("e03", -6.0)]);
    assert_eq!(p.geometric(&q), expected);
    assert_eq!(p.geometric(&q).ideal_norm(), 7.0);
    assert_eq!(p.regressive(&q).norm(), 7.0);
}

#[test]
fn product_of_a_plane_and_a_point_is_the_perpendicular_and_the_distance() {
    // 2 x + 3 y + 6 z = 7 has a normal of length 7; (1, 2, 3) is (26 - 7)/7 away from it.
    let (a, p) = (plane(2, 3, 6, -7), point(1, 2, 3));
    assert_eq!(a.geometric(&p), &a.inner(&p) + &a.outer(&p));
    assert_eq!(a.outer(&p), multivector(PGA_3D, [("e0123", 26 - 7)]));
    // The line through the point along the normal, which is the join of the point and the direction (2, 3, 6).
    assert_eq!(a.inner(&p), p.regressive(&direction(2, 3, 6)));
}

#[test]
fn outer_product_of_unit_planes_is_the_sine_times_their_line_or_the_distance_times_their_direction() {
    // 3 x + 4 y = 0 with a normal of length 5, and y = 0: the cosine is 4/5 and the sine 3/5.
    let (a, b) = (plane(3, 4, 0, 0), plane(0, 1, 0, 0));
    assert_eq!(a.inner(&b), Multivector::scalar(PGA_3D, 4));
    assert_eq!(a.outer(&b), multivector(PGA_3D, [("e12", 3)]));
    // z = 5 and z = 8 are 3 apart.
    assert_eq!(plane(0, 0, 1, -5).outer(&plane(0, 0, 1, -8)), multivector(PGA_3D, [("e03", 3)]));
}

#[test]
fn pseudoscalar_takes_a_plane_to_its_normal_direction_and_a_point_to_the_plane_at_infinity() {
    let pseudoscalar = multivector(PGA_3D, [("e0123", 1)]);
    assert_eq!(plane(1, 2, 3, 4).geometric(&pseudoscalar), direction(1, 2, 3));
    assert_eq!(point(1, 2, 3).geometric(&pseudoscalar), multivector(PGA_3D, [("e0", 1)]));
}

#[test]
fn translator_by_twelve_along_z_is_what_two_mirrors_and_what_an_ideal_line_make() {
    let expected = multivector(PGA_3D, [("1", 1), ("e03", -6)]);
    // Mirrors half the way apart: first z = 0, then z = 6.
    assert_eq!(plane(0, 0, 1, -6).geometric(&plane(0, 0, 1, 0)), expected);
    // Half the way times the ideal line that is perpendicular to the join of the origin and the direction.
    let axis = point(0, 0, 0).regressive(&direction(0, 0, 1)).geometric(&multivector(PGA_3D, [("e0123", 1)]));
    assert_eq!(&Multivector::scalar(PGA_3D, 1) + &axis.scale(6), expected);
}

#[test]
fn rotor_of_120_degrees_about_y_is_what_an_axis_and_what_two_mirrors_make() {
    // Twice the rotor, for the sake of whole numbers: cos 60 - sin 60 times the axis through the origin and (0, 1, 0).
    let expected = multivector(PGA_3D, [("1", surd(1)), ("e31", -SQRT_3)]);
    let (zero, one) = (surd(0), surd(1));
    let axis = point(zero, zero, zero).regressive(&point(zero, one, zero));
    assert_eq!(&Multivector::scalar(PGA_3D, one) - &axis.scale(SQRT_3), expected);
    // Mirrors 60 degrees apart: first that with the normal z, then that with twice the normal (sin 60, 0, cos 60).
    let turned = plane(SQRT_3, zero, one, zero);
    assert_eq!(turned.geometric(&plane(zero, zero, one, zero)), expected);
}

#[test]
fn translator_by_twelve_along_z_moves_points_and_leaves_directions() {
    let translator = multivector(PGA_3D, [("1", 1), ("e03", -6)]);
    assert_eq!(translator.sandwich(&point(1, 2, 3)), point(1, 2, 15));
    assert_eq!(translator.sandwich(&direction(1, 2, 3)), direction(1, 2, 3));
    // The plane z = 5 becomes z = 17.
    assert_eq!(translator.sandwich(&plane(0, 0, 1, -5)), plane(0, 0, 1, -17));
}

#[test]
fn rotor_of_120_degrees_about_y_turns_z_towards_x_exactly() {
    // Twice the rotor 1/2 - sqrt(3)/2 e31 has coefficients in Z[sqrt(3)], and its sandwich is four times the rotation
    // x' = x cos + z sin, z' = -x sin + z cos.
    let twice = multivector(PGA_3D, [("1", surd(1)), ("e31", -SQRT_3)]);
    let (x, y, z) = (surd(3), surd(5), surd(7));
    let two = surd(2);
    let rotated = direction(-two * x + two * SQRT_3 * z, surd(4) * y, -two * SQRT_3 * x - two * z);
    let expected = &multivector(PGA_3D, [("e123", surd(4))]) + &rotated;
    assert_eq!(twice.sandwich(&point(x, y, z)), expected);
}

#[test]
fn rotor_of_120_degrees_about_y_turns_z_towards_x_in_floating_point() {
    let half_root = 3.0_f64.sqrt() / 2.0;
    let rotor = multivector(PGA_3D, [("1", 0.5), ("e31", -half_root)]);
    let rotated = rotor.sandwich(&point(3.0, 5.0, 7.0));
    let expected = point(-1.5 + 7.0 * half_root, 5.0, -3.0 * half_root - 3.5);
    // With u = 2^-53: each coefficient of the sandwich sums at most four terms r r' x, where r and r' are coefficients
    // of the rotor. A term meets at most six roundings: one in each r, two products, two sums. Its error is thus below
    // 6 u (1/2 + sqrt(3)/2)^2 (|x| + |z|) < 6 u * 2 * 10 = 120 u. The expected value meets three roundings and is
    // smaller, so twice that bound covers both.
    let unit_roundoff = f64::EPSILON / 2.0;
    let tolerance = 2.0 * 120.0 * unit_roundoff;
    for (word, difference) in (&rotated - &expected).blades() {
        assert!(difference.abs() <= tolerance, "{word}: {difference}");
    }
}

#[test]
fn rotor_of_120_degrees_about_the_diagonal_permutes_the_axes() {
    // Twice the rotor 1/2 - (e23 + e31 + e12)/2: x goes to y, y to z, z to x.
    let twice = multivector(PGA_3D, [("1", 1), ("e23", -1), ("e31", -1), ("e12", -1)]);
    assert_eq!(twice.sandwich(&point(3, 5, 7)), point(7, 3, 5).scale(4));
    assert_eq!(twice.norm_squared(), 4);
}

#[test]
fn quarter_turns_are_counter_clockwise_about_each_axis() {
    // A quarter turn's rotor is (1 - axis)/sqrt(2), so the sandwich with 1 - axis is twice the rotation.
    let quarter = |axis| multivector(PGA_3D, [("1", 1), (axis, -1)]);
    assert_eq!(quarter("e23").sandwich(&direction(0, 1, 0)), direction(0, 0, 2));
    assert_eq!(quarter("e31").sandwich(&direction(0, 0, 1)), direction(2, 0, 0));
    assert_eq!(quarter("e12").sandwich(&direction(1, 0, 0)), direction(0, 2, 0));
}

#[test]
fn a_product_of_motors_applies_the_right_factor_first() {
    let translator = multivector(PGA_3D, [("1", 1), ("e01", -2)]);
    let half_turn_about_z = multivector(PGA_3D, [("e12", -1)]);
    let turn_then_move = translator.geometric(&half_turn_about_z);
    assert_eq!(turn_then_move.sandwich(&point(1, 0, 0)), point(3, 0, 0));
    let move_then_turn = half_turn_about_z.geometric(&translator);
    assert_eq!(move_then_turn.sandwich(&point(1, 0, 0)), point(-5, 0, 0));
}

#[test]
fn a_motor_times_its_reverse_is_a_study_number() {
    // s, b, c, p as in m = s + b.(e23,e31,e12) + c.(e01,e02,e03) + p e0123.
    let m = multivector(
        PGA_3D,
        [("1", 2), ("e23", 3), ("e31", 5), ("e12", 7), ("e01", 11), ("e02", 13), ("e03", 17), ("e0123", 19)],
    );
    let (norm, study) = (4 + 9 + 25 + 49, 2 * (2 * 19 - (3 * 11 + 5 * 13 + 7 * 17)));
    assert_eq!(m.geometric(&m.reverse()), multivector(PGA_3D, [("1", norm), ("e0123", study)]));
    assert_eq!(m.norm_squared(), norm);
}
