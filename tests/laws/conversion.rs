//! Screws, matrices, quaternions, and motions from one thing to another.

use crate::law::Law;
use crate::motion::{Motion, Parts};
use crate::samples::{directions, far_from_underflow, full, motors};
use crate::tie::estimate;
use crate::tolerance::{Estimate, exact, up_to};
use pga_motor::{Direction, Motor, Point, Real, UnitLine, UnitPlane, pga2d};
use proptest::prelude::*;
use std::fmt::Debug;

macro_rules! in_both_precisions {
    ($($law:ident)*) => {
        $(
            mod $law {
                use crate::law::Law;

                #[test]
                fn in_f32() {
                    super::$law::<f32>(&Law::new(concat!(stringify!($law), " in_f32")));
                }

                #[test]
                fn in_f64() {
                    super::$law::<f64>(&Law::new(concat!(stringify!($law), " in_f64")));
                }
            }
        )*
    };
}

in_both_precisions! {
    a_screw_is_the_motion
    columns_are_the_motion
    columns_of_the_plane_are_the_motion
    quaternion_and_translation_are_the_motion
    points_are_carried_to_points
    planes_are_carried_to_planes
    lines_are_carried_to_lines
    lines_of_the_plane_are_carried_to_lines
}

fn unit<T: Real>() -> f64 {
    T::EPSILON.to_f64() / 2.0
}

/// The screw is made of log m = B: the axis is B over its norm, the slide its moment along that, a product of three;
/// the motor of it is (cos - sin l)(1 + d/2 l e0123), with l as exact as B/|B| and the moment of l times the sine, up
/// to 1. In all log, axis, and a product; the slide as a part of the moment is off by as much as that, and 4 u.
fn a_screw_is_the_motion<T: Real + Debug + 'static>(law: &Law) {
    law.holds_for(motors::<Motor<T>>(full::<Motor<T>>()), |m| {
        let screw = m.screw();
        let Some(found) = screw.motor() else {
            prop_assert!(false, "{screw:?} is no motion");
            return Ok(());
        };
        let h = m.half_angle();
        let log = estimate(m).log(h);
        let axis = if h > 0.0 { log.axis(h).times(h.sin()) } else { log };
        let slide = exact(unit::<T>(), [1.0, 0.0, m.sizes()[2]]);
        law.same_motion(found, m, &[estimate(m), log.exp(), axis, slide.product(slide)])
    });
}

/// An entry of the matrix is 1 or 0 and products of two coefficients, off by at most 4 u; as a matrix of three columns
/// by 4 sqrt(3) u. The rotor comes from 1 + trace and differences of entries, 4 times its square with s >= 1/2: with 8
/// entries together off by 4 u sqrt(3) (1 + sqrt(3)), over a norm of at least 2; and is normalised. Half turns about
/// coordinate axes are exact. The translation is twice r ~q, and back half of it times q.
fn columns_are_the_motion<T: Real + Debug + 'static>(law: &Law) {
    law.holds_for(motors::<Motor<T>>(full::<Motor<T>>()), |m| {
        let found = Motor::from_columns(m.to_matrix().to_columns()).expect("a motor's matrix is rigid");
        law.same_motion(found, m, &[estimate(m), through_columns(m)])
    });
}

fn through_columns<M: Motion>(m: M) -> Estimate {
    let given = estimate(m);
    let rotor = given.rotor().off_by(2.0 * 4.0 * M::unit() * 3_f64.sqrt(), 0.0).of_norm(1.0).normalized();
    given.translator().after(rotor)
}

fn columns_of_the_plane_are_the_motion<T: Real + Debug + 'static>(law: &Law) {
    law.holds_for(motors::<pga2d::Motor<T>>(full::<pga2d::Motor<T>>()), |m| {
        let found = pga2d::Motor::from_columns(m.to_columns()).expect("a motor's matrix is rigid");
        law.same_motion(found, m, &[estimate(m), through_columns(m)])
    });
}

fn quaternion_and_translation_are_the_motion<T: Real + Debug + 'static>(law: &Law) {
    law.holds_for(motors::<Motor<T>>(full::<Motor<T>>()), |m| {
        let (quaternion, translation) = m.to_quaternion_translation();
        let found = Motor::from_quaternion_translation(quaternion, translation).expect("a motor's quaternion");
        let given = estimate(m);
        law.same(found, m, &[given, given.translator().after(given.rotor().normalized())])
    });
}

fn coordinates() -> impl Strategy<Value = [f64; 3]> {
    let size = prop_oneof![Just(0.0), Just(1.0), Just(1e6)];
    (directions(full::<pga_motor::f64::Motor>()), size).prop_map(|(direction, size)| direction.map(|x| x * size))
}

fn point<T: Real>([x, y, z]: [f64; 3]) -> Point<T> {
    Point::new(T::from_f64(x), T::from_f64(y), T::from_f64(z))
}

fn direction<T: Real>([x, y, z]: [f64; 3]) -> Direction<T> {
    Direction::new(T::from_f64(x), T::from_f64(y), T::from_f64(z))
}

/// The difference is rounded once, and so is the sum.
fn points_are_carried_to_points<T: Real + Debug + 'static>(law: &Law) {
    law.holds_for((coordinates(), coordinates()), |(a, b)| {
        let (a, b) = (point::<T>(a), point(b));
        let motor = Motor::between_points(a, b);
        prop_assert_eq!(motor.defects(), [0.0, 0.0]);
        let sizes = a.sizes()[2] + b.sizes()[2];
        law.same(motor.transform_point(a), b, &[up_to(unit::<T>(), [0.0, 0.0, 2.0 * unit::<T>() * sizes])])
    });
}

/// Two directions: any, and ones that differ, from each other or from each other's opposite, by a logarithmic distance.
fn two_directions() -> impl Strategy<Value = [[f64; 3]; 2]> {
    let free = || directions(far_from_underflow::<pga_motor::f64::Motor>());
    let near = (free(), free(), -7.0..0.0, any::<bool>()).prop_map(|(a, b, exponent, opposite)| {
        let sign = if opposite { -1.0 } else { 1.0 };
        [a, [0, 1, 2].map(|i| sign * a[i] + 10_f64.powf(exponent) * b[i])]
    });
    prop_oneof![(free(), free()).prop_map(|(a, b)| [a, b]), near]
}

/// 1 + b ~a, for unit vectors off by 4 u each, is off by these and a product, and is 2 cos of half the angle long;
/// normalised. Then the sandwich.
fn between<T: Real>(chord: f64, [a, b]: [f64; 2]) -> [Estimate; 2] {
    let given = |size| exact(unit::<T>(), [0.0, 1.0, size]).off_by(4.0 * unit::<T>(), 4.0 * unit::<T>() * size);
    let motor = given(a).product(given(b)).of_norm(chord).normalized();
    [motor.carry(given(a), 1.0), given(b)]
}

fn chord([a, b]: [[f64; 4]; 2]) -> f64 {
    f64::norm([0, 1, 2, 3].map(|i| a[i] + b[i]))
}

/// Units: the norm as of what is normalised. The sum before, of the size of the chord and of the things' ideal parts,
/// has the errors of a product, so these are off the Study quadric, and over the square of the chord: it is measured
/// from the relations that hold for exact units. The rest as of what is normalised.
fn is_unit<M: Motion>(law: &Law, motor: M, ideal: f64, chord: f64) -> Result<(), TestCaseError> {
    let [norm, study] = motor.defects();
    law.within(norm.abs(), 2.0 * 5.0 * M::unit())?;
    law.within(study.abs(), M::unit() * ideal / chord * (6.8 / chord + 14.6 + 18.0))
}

fn planes_are_carried_to_planes<T: Real + Debug + 'static>(law: &Law) {
    law.holds_for((two_directions(), coordinates(), coordinates()), |([m, n], p, q)| {
        let plane = |at, normal| UnitPlane::from_point_and_normal(point::<T>(at), direction(normal)).expect("a normal");
        let (a, b) = (plane(p, m), plane(q, n));
        let Some(motor) = Motor::between_planes(a, b) else { return Ok(()) };
        let sizes = [a.sizes()[2], b.sizes()[2]];
        let chord = chord([a.parts()[1], b.parts()[1]]);
        prop_assume!(chord > 1e-3 || unit::<T>() < 1e-10);
        is_unit(law, motor, sizes[0] + sizes[1], chord)?;
        law.same(motor.transform_unit_plane(a), b, &between::<T>(chord, sizes))
    });
}

fn lines_are_carried_to_lines<T: Real + Debug + 'static>(law: &Law) {
    law.holds_for((two_directions(), coordinates(), coordinates()), |([m, n], p, q)| {
        let line = |at, way| UnitLine::from_point_and_direction(point::<T>(at), direction(way)).expect("a direction");
        let (a, b) = (line(p, m), line(q, n));
        let Some(motor) = Motor::between_lines(a, b) else { return Ok(()) };
        let sizes = [p, q].map(f64::norm);
        let chord = chord([a.parts()[1], b.parts()[1]]);
        prop_assume!(chord > 1e-3 || unit::<T>() < 1e-10);
        is_unit(law, motor, sizes[0] + sizes[1], chord)?;
        law.same(motor.transform_unit_line(a), b, &between::<T>(chord, sizes))
    });
}

fn lines_of_the_plane_are_carried_to_lines<T: Real + Debug + 'static>(law: &Law) {
    law.holds_for((two_directions(), coordinates(), coordinates()), |([m, n], [p, ..], [q, ..])| {
        let line = |distance: f64, [x, y, _]: [f64; 3]| {
            let norm = f64::norm([x, y]);
            let [x, y, distance] = [x / norm, y / norm, distance].map(T::from_f64);
            (norm > 1e-3).then(|| pga2d::UnitLine::new(x, y, distance))
        };
        let (Some(a), Some(b)) = (line(p, m), line(q, n)) else { return Ok(()) };
        let Some(motor) = pga2d::Motor::between_lines(a, b) else { return Ok(()) };
        let sizes = [p.abs(), q.abs()];
        let chord = chord([a.parts()[1], b.parts()[1]]);
        prop_assume!(chord > 1e-3 || unit::<T>() < 1e-10);
        is_unit(law, motor, sizes[0] + sizes[1], chord)?;
        law.same(motor.transform_unit_line(a), b, &between::<T>(chord, sizes))
    });
}
