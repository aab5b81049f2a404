//! The geometry of the plane in Cl(2,0,1). Line a x + b y + c = 0: `a e1 + b e2 + c e0`; point: `e12 + x e20 + y e01`.

use ga_codegen::reference::{Multivector, Number};

use crate::surd::{SQRT_3, Surd};
use crate::{PGA_2D, multivector};

fn point<T: Number>(x: T, y: T) -> Multivector<T> {
    multivector(PGA_2D, [("e12", T::from(1)), ("e20", x), ("e01", y)])
}

fn ideal_point<T: Number>(x: T, y: T) -> Multivector<T> {
    multivector(PGA_2D, [("e20", x), ("e01", y)])
}

fn line<T: Number>(a: T, b: T, c: T) -> Multivector<T> {
    multivector(PGA_2D, [("e1", a), ("e2", b), ("e0", c)])
}

fn square<T: Number>(x: &Multivector<T>) -> Multivector<T> {
    x.geometric(x)
}

#[test]
fn a_normalised_point_squares_to_minus_one() {
    assert_eq!(square(&point(123, 456)), Multivector::scalar(PGA_2D, -1));
}

#[test]
fn an_ideal_point_squares_to_zero() {
    assert_eq!(square(&ideal_point(123, 456)), Multivector::zero(PGA_2D));
}

#[test]
fn pseudoscalar_takes_a_line_to_its_normal_direction_and_a_point_to_the_ideal_line() {
    let pseudoscalar = multivector(PGA_2D, [("e012", 1)]);
    assert_eq!(line(1, 2, 3).geometric(&pseudoscalar), ideal_point(1, 2));
    assert_eq!(point(42, 9000).geometric(&pseudoscalar), multivector(PGA_2D, [("e0", -1)]));
}

#[test]
fn lines_meet_in_their_common_point() {
    // x = 3 and y = 4.
    assert_eq!(line(1, 0, -3).outer(&line(0, 1, -4)), point(3, 4));
    // x = 3 and x = 5 meet at infinity, in the y direction, with their distance as the weight.
    assert_eq!(line(1, 0, -3).outer(&line(1, 0, -5)), ideal_point(0, 2));
}

#[test]
fn outer_product_of_unit_lines_is_the_sine_times_their_point_or_the_distance_times_their_direction() {
    // Twice the unit line with normal (1/2, sqrt(3)/2), 60 degrees from (1, 0), and the unit line x = 2.
    let zero = Surd::from(0);
    let (a, b) = (line(Surd::from(2), zero, Surd::from(-4)), line(Surd::from(1), SQRT_3, Surd::from(-2)));
    // Both go through (2, 0); times 4, the cosine is 2 and the sine 2 sqrt(3).
    assert_eq!(a.inner(&b), Multivector::scalar(PGA_2D, Surd::from(2)));
    let root = Surd::from(2) * SQRT_3;
    assert_eq!(a.outer(&b), point(Surd::from(2), zero).scale(root));
    // 3 x + 4 y = 5 and 3 x + 4 y = 15 have normals of length 5 and are 1 and 3 from the origin.
    let (c, d) = (line(3, 4, -5), line(3, 4, -15));
    assert_eq!(c.inner(&d), Multivector::scalar(PGA_2D, 25));
    // The distance 2 times the direction (-4/5, 3/5) along the lines, times 25.
    assert_eq!(c.outer(&d), ideal_point(-40, 30));
    assert_eq!(c.outer(&d).ideal_norm_squared(), (2 * 25) * (2 * 25));
    assert_eq!(c.outer(&d).norm_squared(), 0);
}

#[test]
fn join_of_two_points_is_the_line_through_both() {
    let (p, q) = (point(1, 2), point(4, 6));
    let join = p.regressive(&q);
    // The direction from p to q is (3, 4); the line is -4 x + 3 y - 2 = 0 up to a factor.
    assert_eq!(join, line(-4, 3, -2));
    assert_eq!(join.outer(&p), Multivector::zero(PGA_2D));
    assert_eq!(join.outer(&q), Multivector::zero(PGA_2D));
    assert_eq!(join.norm_squared(), 25);
}

#[test]
fn product_of_lines_is_the_cosine_and_the_sine_times_the_common_point() {
    // Unit normals (3/5, 4/5) and (1, 0), here five times too long in the first, through (1, 2).
    let (a, b) = (line(3, 4, -11), line(1, 0, -1));
    let expected = &Multivector::scalar(PGA_2D, 3) + &point(1, 2).scale(-4);
    assert_eq!(a.geometric(&b), expected);
}

#[test]
fn product_of_points_is_minus_one_and_their_distance() {
    let (p, q) = (point(1.0, 2.0), point(4.0, 6.0));
    let product = p.geometric(&q);
    assert_eq!(product.grade(0), Multivector::scalar(PGA_2D, -1.0));
    assert_eq!(product, &product.grade(0) + &p.commutator(&q));
    // An ideal point, perpendicular to (3, 4), of length 5. All steps are exact in f64.
    assert_eq!(p.commutator(&q), ideal_point(4.0, -3.0));
    assert_eq!(p.commutator(&q).ideal_norm(), 5.0);
    assert_eq!(p.commutator(&q).norm(), 0.0);
}

#[test]
fn product_of_a_line_and_a_point_is_the_perpendicular_and_the_distance() {
    let (a, p) = (line(3, 4, -11), point(2, 5));
    let product = a.geometric(&p);
    // 3 * 2 + 4 * 5 - 11 = 15: three units away, with a normal of length 5.
    assert_eq!(product.grade(3), multivector(PGA_2D, [("e012", 15)]));
    assert_eq!(product.grade(1), a.inner(&p));
    let perpendicular = a.inner(&p);
    assert_eq!(perpendicular.outer(&p), Multivector::zero(PGA_2D));
    assert_eq!(perpendicular.inner(&a), Multivector::zero(PGA_2D));
}

#[test]
fn reflection_in_a_line_mirrors_points_and_lines() {
    // The y axis as mirror; a reflected point has weight -1, which is the same point.
    let mirror = line(1, 0, 0);
    assert_eq!(mirror.sandwich(&point(3, 4)), point(-3, 4).neg());
    // x + 2 y + 5 = 0 becomes -x + 2 y + 5 = 0.
    assert_eq!(mirror.sandwich(&line(1, 2, 5)).neg(), line(-1, 2, 5));
}
