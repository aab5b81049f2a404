//! What others compute is checked against definitions: glam's affine maps, and the kernels of `pga-motor` as any user's code.

use ga_codegen::check::strategies::{PGA3D, motors as reference_motors, points as reference_points};
use ga_codegen::check::{Check, Coefficient, Tolerance};
use ga_codegen::reference::Multivector;
use glam::{Affine3A, DAffine3, DVec3, Vec3};
use pga_motor::strategies::{self, motors, points};
use pga_motor::{Motor, Point, Real, Rotor};
use proptest::prelude::*;
use std::fmt::Debug;

type Blades<T, const N: usize> = [(&'static str, T); N];

fn multivector<T: Coefficient, const N: usize>(blades: Blades<T, N>) -> Multivector<T> {
    Multivector::from_blades(PGA3D, blades).expect("words of 3D PGA")
}

fn of_motor<T: Coefficient + Real>(m: Motor<T>) -> Multivector<T> {
    let rotation = [("1", m.s), ("e23", m.e23), ("e31", m.e31), ("e12", m.e12)];
    let ideal = [("e01", m.e01), ("e02", m.e02), ("e03", m.e03), ("e0123", m.e0123)];
    multivector(rotation).add(&multivector(ideal))
}

fn of_point<T: Coefficient + Real>(p: Point<T>) -> Multivector<T> {
    multivector([("e032", p.x), ("e013", p.y), ("e021", p.z), ("e123", T::ONE)])
}

fn motor<T: Coefficient + Real>(m: &Multivector<T>) -> Motor<T> {
    let [s, a, b, c] = ["1", "e23", "e31", "e12"].map(|word| m.coefficient(word));
    let [d, e, f, h] = ["e01", "e02", "e03", "e0123"].map(|word| m.coefficient(word));
    Motor::new(s, a, b, c, d, e, f, h)
}

fn coordinates<T: Coefficient>(p: &Multivector<T>) -> [T; 3] {
    ["e032", "e013", "e021"].map(|word| p.coefficient(word))
}

fn point<T: Coefficient + Real>(p: &Multivector<T>) -> Point<T> {
    let [x, y, z] = coordinates(p);
    Point::new(x, y, z)
}

#[test]
fn affine_maps_of_glam_are_sandwiches() {
    let check = Check::new(PGA3D, "m >> p").expect("a definition");
    check.input("m", reference_motors()).input("p", reference_points()).assert(|[m, p]| {
        let moved = DAffine3::from(motor(m)).transform_point3(DVec3::from(coordinates(p)));
        of_point(Point::new(moved.x, moved.y, moved.z))
    });
}

#[test]
fn affine_maps_of_glam_in_single_precision_are_sandwiches() {
    let check = Check::new(PGA3D, "m >> p").expect("a definition");
    check.input("m", motors().prop_map(of_motor)).input("p", points().prop_map(of_point)).assert(|[m, p]| {
        let moved = Affine3A::from(motor::<f32>(m)).transform_point3(Vec3::from(coordinates(p)));
        of_point(Point::new(moved.x, moved.y, moved.z))
    });
}

#[test]
fn a_transposed_matrix_is_found() {
    let check = Check::new(PGA3D, "m >> p").expect("a definition");
    let check = check.input("m", reference_motors()).input("p", reference_points());
    let error = check.run(|[m, p]| {
        let mut affine = DAffine3::from(motor(m));
        affine.matrix3 = affine.matrix3.transpose();
        let moved = affine.transform_point3(DVec3::from(coordinates(p)));
        of_point(Point::new(moved.x, moved.y, moved.z))
    });
    let error = error.expect_err("the opposite rotation");
    assert!(error.to_string().contains("\n    m = 0.6 + 0.8 e"), "{error}");
}

#[test]
fn our_own_kernels_pass_as_anybody_would() {
    let check = Check::new(PGA3D, "m >> p").expect("a definition");
    check
        .input("m", motors().prop_map(of_motor))
        .input("p", points().prop_map(of_point))
        .assert(|[m, p]| of_point(motor::<f64>(m).transform_point(point(p))));
    let check = Check::new(PGA3D, "a * b").expect("a definition").cases(500);
    let pairs = strategies::motor_pairs::<f32>().prop_map(|(a, b)| [a, b].map(of_motor));
    check.inputs(["a", "b"], pairs).tolerance(Tolerance::Derived).assert(|[a, b]| of_motor(motor(a) * motor(b)));
}

/// That a type's promise holds, relative to the size of what must cancel.
fn keeps_its_promise<T: Real + Debug + 'static>() {
    let unit = 32.0 * T::EPSILON.to_f64();
    let scaled = move |size: f64| T::from_f64(unit * (1.0 + size));
    proptest!(|(
        (a, b) in strategies::motor_pairs::<T>(),
        (c, negative) in strategies::antipodal_motors::<T>(),
        rotor in strategies::rotors::<T>(),
        line in strategies::unit_lines::<T>(),
        plane in strategies::unit_planes::<T>(),
        direction in strategies::unit_directions::<T>(),
    )| {
        for motor in [a, b, c] {
            let size = [motor.e01, motor.e02, motor.e03, motor.e0123].map(|each| each.abs().to_f64()).iter().sum();
            prop_assert!(motor.is_unit(scaled(size)), "{motor:?}");
        }
        prop_assert_eq!(negative, -c);
        prop_assert!(rotor.is_unit(scaled(0.0)) && plane.is_unit(scaled(0.0)));
        let moment = [line.e01, line.e02, line.e03].map(|each| each.abs().to_f64()).iter().sum();
        prop_assert!(line.is_unit(scaled(moment)), "{line:?}");
        prop_assert!((direction.norm().to_f64() - 1.0).abs() < unit);
    });
}

#[test]
fn strategies_keep_what_types_promise() {
    keeps_its_promise::<f32>();
    keeps_its_promise::<f64>();
}

#[test]
fn strategies_reach_the_nasty_ones() {
    let half = |rotor: Rotor<f64>| rotor.s.abs() < 0.01;
    proptest!(|(
        still in strategies::motors_near_identity::<f64>(),
        turned in strategies::rotors_near_half_turn::<f64>(),
        far in strategies::motors_with_tiny_turn_and_huge_step::<f64>(),
    )| {
        prop_assert!((still - Motor::IDENTITY).norm() < 0.02 && half(turned));
        prop_assert!(far.e12.abs() < 0.01 && far.e01.abs() > 1e3);
    });
}
